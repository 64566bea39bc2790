// IidcCamera by libdc1394.
#include <algorithm>
#include <chrono>

#include <dc1394/dc1394.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "drivers/camera/iidc_device.h"

namespace handmap {

namespace {

constexpr std::uint32_t kIidcBuffers = 4;
/// Of Format 7, in which Point Grey's stereo heads send their images together.
constexpr dc1394video_mode_t kStereoMode = DC1394_VIDEO_MODE_FORMAT7_3;
constexpr std::uint64_t kBayerTileMapping = 0x1040;

void need(dc1394error_t status, const std::string& what) {
  if (status == DC1394_SUCCESS) return;
  throw Error(ErrorCode::RunFailed,
              phrase("FireWire camera: cannot {}: {}", what, dc1394_error_get_string(status)));
}

class SystemIidc : public IidcCamera {
 public:
  SystemIidc() : library_(dc1394_new()) {
    dc1394_log_register_handler(DC1394_LOG_ERROR, nullptr, nullptr);  // it is told as an Error
    if (library_ == nullptr) throw Error(ErrorCode::RunFailed, phrase("there is no FireWire here"));
  }

  ~SystemIidc() override {
    if (camera_ != nullptr) {
      dc1394_video_set_transmission(camera_, DC1394_OFF);
      dc1394_capture_stop(camera_);
      dc1394_camera_free(camera_);
    }
    dc1394_free(library_);
  }
  SystemIidc(const SystemIidc&) = delete;
  SystemIidc& operator=(const SystemIidc&) = delete;

  std::vector<std::uint64_t> identities() override {
    dc1394camera_list_t* list = nullptr;
    need(dc1394_camera_enumerate(library_, &list), phrase("list cameras"));
    std::vector<std::uint64_t> all;
    for (std::uint32_t i = 0; i < list->num; ++i) all.push_back(list->ids[i].guid);
    dc1394_camera_free_list(list);
    return all;
  }

  void begin(std::uint64_t identity) override {
    camera_ = dc1394_camera_new(library_, identity);
    if (camera_ == nullptr) {
      throw Error(ErrorCode::RunFailed, phrase("FireWire camera: cannot open it"));
    }
    dc1394_video_set_transmission(camera_, DC1394_OFF);  // where a program before did not
    if (dc1394_video_set_operation_mode(camera_, DC1394_OPERATION_MODE_1394B) == DC1394_SUCCESS) {
      need(dc1394_video_set_iso_speed(camera_, DC1394_ISO_SPEED_800), phrase("set its speed"));
    } else {
      need(dc1394_video_set_iso_speed(camera_, DC1394_ISO_SPEED_400), phrase("set its speed"));
    }
    need(dc1394_video_set_mode(camera_, kStereoMode), phrase("make it send its images together"));
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    need(dc1394_format7_get_max_image_size(camera_, kStereoMode, &width, &height),
         phrase("ask its size"));
    need(
        dc1394_format7_set_roi(camera_, kStereoMode, coding(), DC1394_USE_RECOMMENDED, 0, 0,
                               static_cast<std::int32_t>(width), static_cast<std::int32_t>(height)),
        phrase("set its image"));
    need(dc1394_capture_setup(camera_, kIidcBuffers, DC1394_CAPTURE_FLAGS_DEFAULT),
         phrase("receive its images"));
    need(dc1394_video_set_transmission(camera_, DC1394_ON), phrase("start it"));
  }

  std::uint32_t bayerRegister() override {
    std::uint32_t letters = 0;
    const auto status = dc1394_get_control_register(camera_, kBayerTileMapping, &letters);
    return status == DC1394_SUCCESS ? letters : 0;
  }

  std::optional<IidcFrame> poll() override {
    need(dc1394_capture_dequeue(camera_, DC1394_CAPTURE_POLICY_POLL, &frame_),
         phrase("take an image"));
    if (frame_ == nullptr) return std::nullopt;
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    const double now_s = std::chrono::duration<double>(now).count();
    const auto pixels = static_cast<std::uint64_t>(frame_->size[0]) * frame_->size[1];
    IidcFrame frame;
    frame.bytes = frame_->image;
    frame.width = static_cast<int>(frame_->size[0]);
    frame.height = static_cast<int>(frame_->size[1]);
    frame.images = pixels == 0 ? 0 : static_cast<int>(frame_->image_bytes / pixels);
    frame.age_s = std::max(0.0, now_s - static_cast<double>(frame_->timestamp) * 1e-6);
    frame.damaged = dc1394_capture_is_frame_corrupt(camera_, frame_) == DC1394_TRUE;
    return frame;
  }

  void done() override {
    need(dc1394_capture_enqueue(camera_, frame_), phrase("give an image back"));
  }

 private:
  /// Two images where the camera can; an XB3 then sends the outer two.
  dc1394color_coding_t coding() {
    dc1394color_codings_t codings;
    need(dc1394_format7_get_color_codings(camera_, kStereoMode, &codings),
         phrase("ask what it sends"));
    for (const auto wanted :
         {DC1394_COLOR_CODING_RAW16, DC1394_COLOR_CODING_MONO16, DC1394_COLOR_CODING_RGB8}) {
      for (std::uint32_t i = 0; i < codings.num; ++i) {
        if (codings.codings[i] == wanted) return wanted;
      }
    }
    throw Error(ErrorCode::RunFailed, phrase("FireWire camera: it is no stereo head"));
  }

  dc1394_t* library_;
  dc1394camera_t* camera_ = nullptr;
  dc1394video_frame_t* frame_ = nullptr;
};

}  // namespace

std::unique_ptr<IidcCamera> systemIidc() { return std::make_unique<SystemIidc>(); }

}  // namespace handmap
