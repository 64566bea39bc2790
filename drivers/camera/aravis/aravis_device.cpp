#include "drivers/camera/aravis_device.h"

#include <algorithm>
#include <chrono>
#include <mutex>

#include <arv.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "drivers/camera/raw_images.h"

namespace handmap {

namespace {

constexpr int kAravisBuffers = 4;
constexpr std::uint64_t kWait_us = 100'000;
constexpr double kSilent_s = 2.0;

struct Release {
  void operator()(gpointer object) const { g_object_unref(object); }
};
template <typename Object>
using Owned = std::unique_ptr<Object, Release>;

/// What Aravis says goes out as an Error.
class Complaint {
 public:
  explicit Complaint(const std::string& source) : source_(source) {}
  ~Complaint() { g_clear_error(&error_); }
  Complaint(const Complaint&) = delete;
  Complaint& operator=(const Complaint&) = delete;

  GError** out() {
    g_clear_error(&error_);
    return &error_;
  }
  void raise(const std::string& what) const {
    if (error_ == nullptr) return;
    throw Error(ErrorCode::RunFailed, phrase("{}: cannot {}: {}", source_, what, error_->message));
  }

 private:
  std::string source_;
  GError* error_ = nullptr;
};

BayerTile tileOf(ArvPixelFormat format, const std::string& source) {
  switch (format) {
    case ARV_PIXEL_FORMAT_MONO_8:
      return BayerTile::None;
    case ARV_PIXEL_FORMAT_BAYER_RG_8:
      return BayerTile::Rggb;
    case ARV_PIXEL_FORMAT_BAYER_GB_8:
      return BayerTile::Gbrg;
    case ARV_PIXEL_FORMAT_BAYER_GR_8:
      return BayerTile::Grbg;
    case ARV_PIXEL_FORMAT_BAYER_BG_8:
      return BayerTile::Bggr;
    default:
      throw Error(ErrorCode::RunFailed,
                  phrase("{}: found images of the pixel format {:#x}, expected Mono8 or a "
                         "Bayer one of 8 bit",
                         source, format));
  }
}

/// The library is set up once; what it lists is shared by all threads.
std::mutex& libraryMutex() {
  static std::mutex mutex;
  return mutex;
}

class AravisDevice : public ImageDevice {
 public:
  AravisDevice(const AravisOptions& options, RigClock clock)
      : source_(options.source), clock_(std::move(clock)), last_s_(clock_()) {
    Complaint complaint(source_);
    {
      const std::scoped_lock lock(libraryMutex());
      arv_update_device_list();
      camera_.reset(arv_camera_new(source_.c_str(), complaint.out()));
    }
    complaint.raise(phrase("open it"));
    if (!camera_) throw Error(ErrorCode::RunFailed, phrase("{}: no such camera", source_));
    setUp(options, complaint);
    stream_.reset(arv_camera_create_stream(camera_.get(), nullptr, nullptr, complaint.out()));
    complaint.raise(phrase("receive its images"));
    const guint bytes = arv_camera_get_payload(camera_.get(), complaint.out());
    complaint.raise(phrase("ask how large its images are"));
    for (int i = 0; i < kAravisBuffers; ++i) {
      arv_stream_push_buffer(stream_.get(), arv_buffer_new_allocate(bytes));
    }
    arv_camera_start_acquisition(camera_.get(), complaint.out());
    complaint.raise(phrase("start it"));
  }

  ~AravisDevice() override { arv_camera_stop_acquisition(camera_.get(), nullptr); }
  AravisDevice(const AravisDevice&) = delete;
  AravisDevice& operator=(const AravisDevice&) = delete;

  std::optional<TimedImage> next(const std::stop_token& stop) override {
    while (!stop.stop_requested() && clock_() - last_s_ < kSilent_s) {
      ArvBuffer* buffer = arv_stream_timeout_pop_buffer(stream_.get(), kWait_us);
      if (buffer == nullptr) continue;
      std::optional<TimedImage> image;
      if (arv_buffer_get_status(buffer) == ARV_BUFFER_STATUS_SUCCESS) image = taken(*buffer);
      arv_stream_push_buffer(stream_.get(), buffer);
      if (!image) continue;
      last_s_ = clock_();
      return image;
    }
    return std::nullopt;
  }

 private:
  void setUp(const AravisOptions& options, Complaint& complaint) {
    arv_camera_set_acquisition_mode(camera_.get(), ARV_ACQUISITION_MODE_CONTINUOUS,
                                    complaint.out());
    complaint.raise(phrase("make it send on and on"));
    if (options.width > 0 && options.height > 0) {
      arv_camera_set_region(camera_.get(), 0, 0, options.width, options.height, complaint.out());
      complaint.raise(phrase("set the size of its images"));
    }
    if (options.rate_hz > 0.0) {
      arv_camera_set_frame_rate(camera_.get(), options.rate_hz, complaint.out());
      complaint.raise(phrase("set its rate"));
    }
  }

  TimedImage taken(ArvBuffer& buffer) const {
    const int width = arv_buffer_get_image_width(&buffer);
    const int height = arv_buffer_get_image_height(&buffer);
    std::size_t bytes = 0;
    const void* data = arv_buffer_get_data(&buffer, &bytes);
    const BayerTile tile = tileOf(arv_buffer_get_image_pixel_format(&buffer), source_);
    if (width <= 0 || height <= 0 || bytes < std::size_t(width) * std::size_t(height)) {
      throw Error(ErrorCode::RunFailed, phrase("{}: found {} bytes, expected {} × {} pixels",
                                               source_, bytes, width, height));
    }
    const cv::Mat1b raw(height, width, static_cast<std::uint8_t*>(const_cast<void*>(data)));
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    const double now_s = std::chrono::duration<double>(now).count();
    const double stamp_s = static_cast<double>(arv_buffer_get_system_timestamp(&buffer)) * 1e-9;
    const double age_s = std::clamp(now_s - stamp_s, 0.0, kSilent_s);
    return {clock_() - age_s, developed(raw, tile).clone()};
  }

  std::string source_;
  RigClock clock_;
  double last_s_;
  Owned<ArvCamera> camera_;
  Owned<ArvStream> stream_;  // after the camera: it goes first
};

}  // namespace

OpenImageDevice aravisDevice(AravisOptions options, RigClock clock) {
  return [options = std::move(options), clock = std::move(clock)] {
    return std::make_unique<AravisDevice>(options, clock);
  };
}

std::vector<std::string> aravisCameras() {
  const std::scoped_lock lock(libraryMutex());
  arv_update_device_list();
  std::vector<std::string> sources;
  for (unsigned i = 0; i < arv_get_n_devices(); ++i) sources.emplace_back(arv_get_device_id(i));
  return sources;
}

}  // namespace handmap
