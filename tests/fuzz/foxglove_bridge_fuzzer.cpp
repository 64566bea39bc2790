// What a Foxglove bridge sends: the text of a type of message up to the first zero, then a message
// of it; the first byte tells ROS 1 from ROS 2, and a type that is known instead.
#include <array>

#include "drivers/rosbridge/ros_schema.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  return fuzz::takenOrRefused([&] {
    std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    constexpr std::array kKnown = {"nav_msgs/Odometry", "sensor_msgs/LaserScan",
                                   "sensor_msgs/PointCloud2", "visualization_msgs/MarkerArray"};
    if ((data[0] & 0x80U) != 0) {
      const RosSchema schema = RosSchema::known(kKnown[data[0] % kKnown.size()]);
      const RosValue message(schema.read(bytes, "/topic"), "/topic");
      // What was read can be written, and reads back the same.
      const std::string written = schema.write(message);
      return fuzz::require(schema.write(RosValue(schema.read(written, "/topic"), "/topic")) ==
                           written);
    }
    const std::string_view text = bytes.substr(0, bytes.find('\0'));
    const RosSchema schema("pkg/Type", text,
                           (data[0] & 1U) != 0 ? MessageEncoding::Ros1 : MessageEncoding::Cdr);
    bytes.remove_prefix(std::min(bytes.size(), text.size() + 1));
    schema.read(bytes, "/topic");
  });
}
