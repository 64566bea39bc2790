#include "drivers/camera/opencv_device.h"

#include <algorithm>
#include <filesystem>

#include <opencv2/videoio.hpp>

#include "core/base/error.h"
#include "core/base/phrase.h"

namespace handmap {

namespace {

constexpr int kOpenPatience_ms = 4000;
constexpr int kReadPatience_ms = 3000;
constexpr double kDefaultRate_hz = 25.0;  // of a file that does not tell it
constexpr double kMostRate_hz = 240.0;
constexpr double kPlayingAlready_s = 2.0;  // a file that is there only later begins when it is

bool isVideoFile(const std::string& source) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(source, ignored);
}

bool isDevice(const std::string& source) { return source.starts_with("/dev/"); }
bool isStream(const std::string& source) { return source.find("://") != std::string::npos; }

class OpencvDevice : public ImageDevice {
 public:
  OpencvDevice(const CaptureOptions& options, RigClock clock)
      : options_(options), clock_(std::move(clock)), file_(isVideoFile(options.source)) {
    if (!open()) {
      throw Error(
          ErrorCode::RunFailed,
          phrase("{}: cannot be opened: is it there, and in use by nobody else?", options_.source));
    }
    const double told_hz = capture_.get(cv::CAP_PROP_FPS);
    rate_hz_ = told_hz > 0.0 && told_hz < kMostRate_hz ? told_hz : kDefaultRate_hz;
    due_s_ = clock_() - options_.begin_s < kPlayingAlready_s ? options_.begin_s : clock_();
  }

  std::optional<TimedImage> next(const std::stop_token& stop) override {
    if (file_) {
      due_s_ += 1.0 / rate_hz_;
      waitFor(std::max(0.0, due_s_ - clock_()), stop);
    }
    if (stop.stop_requested() || !capture_.grab()) return std::nullopt;
    const double time_s = file_ ? due_s_ : clock_();
    cv::Mat image;
    if (!capture_.retrieve(image) || image.empty()) return std::nullopt;
    if (image.depth() != CV_8U || (image.channels() != 1 && image.channels() != 3)) {
      throw Error(ErrorCode::RunFailed,
                  phrase("{}: found images of {} channels and {} bits, expected 1 or 3 of 8",
                         options_.source, image.channels(), 8 * image.elemSize1()));
    }
    return TimedImage{time_s, std::move(image)};
  }

  bool hasEnd() const override { return file_; }

 private:
  bool open() {
    const bool device = isDevice(options_.source);
    const bool stream = isStream(options_.source);
    if (!device && !stream && !file_) return false;
    const std::vector<int> patience = {cv::CAP_PROP_OPEN_TIMEOUT_MSEC, kOpenPatience_ms,
                                       cv::CAP_PROP_READ_TIMEOUT_MSEC, kReadPatience_ms};
    const bool opened = device   ? capture_.open(options_.source, cv::CAP_V4L2)
                        : stream ? capture_.open(options_.source, cv::CAP_FFMPEG, patience)
                                 : capture_.open(options_.source);
    if (!opened || !device) return opened;
    if (options_.width > 0) capture_.set(cv::CAP_PROP_FRAME_WIDTH, options_.width);
    if (options_.height > 0) capture_.set(cv::CAP_PROP_FRAME_HEIGHT, options_.height);
    if (options_.rate_hz > 0.0) capture_.set(cv::CAP_PROP_FPS, options_.rate_hz);
    capture_.set(cv::CAP_PROP_BUFFERSIZE, 1);  // what waits in a buffer is old
    return true;
  }

  CaptureOptions options_;
  RigClock clock_;
  bool file_;
  cv::VideoCapture capture_;
  double rate_hz_ = 0.0;
  double due_s_ = 0.0;
};

}  // namespace

OpenImageDevice opencvDevice(CaptureOptions options, RigClock clock) {
  return [options = std::move(options), clock = std::move(clock)] {
    return std::make_unique<OpencvDevice>(options, clock);
  };
}

}  // namespace handmap
