#include "app/gui/rig/connected_rigs.h"

#include "drivers/camera/image_devices.h"
#include "drivers/live/rig_host.h"

namespace handmap {

RigAccess rigAccess(MakeDevices make) {
  return {[make = std::move(make)](const Rig& rig, const std::shared_ptr<RigMonitor>& monitor,
                                   const std::stop_token& stop,
                                   const std::function<void(const Observation&)>& see) {
            RigHost host(rig, make, monitor);
            while (const auto observation = host.next(stop)) see(*observation);
          },
          connectedCameras};
}

}  // namespace handmap
