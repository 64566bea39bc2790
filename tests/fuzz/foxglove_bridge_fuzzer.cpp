// What a Foxglove bridge sends: the text of a type of message up to the first zero, then a message
// of it; the first byte tells ROS 1 from ROS 2, and a type that is known instead.
#include <array>

#include "core/bags/ros_camera.h"
#include "drivers/rosbridge/ros_messages.h"
#include "drivers/rosbridge/ros_schema.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

namespace {

/// Of a camera that stands beside the one of the message.
void describe(const RosValue& message) {
  fuzz::takenOrRefused([&] {
    const ros::CameraInfo left = readCameraInfo(message);
    if (left.size.area() > 1'000'000) return;  // it is rectified, but takes its time
    ros::CameraInfo right = left;
    right.projection(0, 3) -= 0.1 * right.projection(0, 0);
    const Rectifier rectifier = ros::rectifierOf(left, right, false, "fuzz");
    fuzz::require(rectifier.camera({}).baseline > 0.0);
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  return fuzz::takenOrRefused([&] {
    std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    constexpr std::array kKnown = {"nav_msgs/Odometry", "sensor_msgs/LaserScan",
                                   "sensor_msgs/PointCloud2", "visualization_msgs/MarkerArray",
                                   "sensor_msgs/CameraInfo"};
    if ((data[0] & 0x80U) != 0) {
      const RosSchema schema = RosSchema::known(kKnown[data[0] % kKnown.size()]);
      const RosValue message(schema.read(bytes, "/topic"), "/topic");
      if (data[0] % kKnown.size() == 4) describe(message);
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
