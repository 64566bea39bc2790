#include "drivers/camera/image_device.h"

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace handmap {

void waitFor(double seconds, const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any never;
  std::unique_lock lock(mutex);
  never.wait_for(lock, stop, std::chrono::duration<double>(seconds), [] { return false; });
}

}  // namespace handmap
