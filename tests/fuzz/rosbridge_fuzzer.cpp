// Messages over rosbridge: the first byte tells JSON from CBOR and which message it should be.
#include <cmath>

#include "drivers/rosbridge/bounded_message.h"
#include "drivers/rosbridge/fragments.h"
#include "drivers/rosbridge/ros_messages.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  return fuzz::takenOrRefused([&] {
    const QByteArray bytes(reinterpret_cast<const char*>(data) + 1,
                           static_cast<qsizetype>(size) - 1);
    const bool cbor = (data[0] & 0x80U) != 0;
    const RosValue message(cbor ? parseCborMessage(bytes) : parseJsonMessage(bytes), "/topic");
    switch (data[0] & 7U) {
      case 0:
        return fuzz::require(std::isfinite(readOdometry(message).pose.heading));
      case 1:
        for (const RangePoint& point : readLaserScan(message).points) {
          fuzz::require(std::isfinite(point.x + point.y));
        }
        return;
      case 2:
        for (const RangePoint& point : readPointCloud(message).points) {
          fuzz::require(std::isfinite(point.x + point.y + point.z));
        }
        return;
      case 3:
        return fuzz::require(!readImage(message).image.empty());
      default:
        Fragments(1000).add(message);
    }
  });
}
