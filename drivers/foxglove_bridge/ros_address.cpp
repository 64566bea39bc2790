#include "drivers/foxglove_bridge/ros_address.h"

#include "drivers/foxglove_bridge/foxglove_bridge_client.h"
#include "drivers/rosbridge/rosbridge_client.h"

namespace handmap {

std::shared_ptr<RosClient> rosClientAt(const std::string& address, RosVersion version,
                                       std::uint64_t seed) {
  const QUrl url(QString::fromStdString(address));
  if (url.scheme().startsWith(QLatin1String("foxglove"))) {
    return std::make_shared<FoxgloveBridgeClient>(url, seed);
  }
  return std::make_shared<RosbridgeClient>(RosbridgeOptions{url, version}, seed);
}

}  // namespace handmap
