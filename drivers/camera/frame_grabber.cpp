#include "drivers/camera/frame_grabber.h"

#include <algorithm>
#include <condition_variable>
#include <filesystem>
#include <mutex>

#include <fmt/format.h>
#include <opencv2/videoio.hpp>

#include "drivers/device/reconnect.h"

namespace handmap {

namespace {

constexpr int kOpenPatience_ms = 4000;
constexpr int kReadPatience_ms = 3000;
constexpr double kDefaultRate_hz = 25.0;  // of a file that does not tell it
constexpr double kMostRate_hz = 240.0;

bool isVideoFile(const std::string& source) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(source, ignored);
}

bool isDevice(const std::string& source) { return source.starts_with("/dev/"); }
bool isStream(const std::string& source) { return source.find("://") != std::string::npos; }

/// A wait that a stop ends.
void wait(std::chrono::duration<double> time, const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any never;
  std::unique_lock lock(mutex);
  never.wait_for(lock, stop, time, [] { return false; });
}

bool opened(cv::VideoCapture& capture, const GrabberOptions& options) {
  const bool device = isDevice(options.source);
  const std::vector<int> patience = {cv::CAP_PROP_OPEN_TIMEOUT_MSEC, kOpenPatience_ms,
                                     cv::CAP_PROP_READ_TIMEOUT_MSEC, kReadPatience_ms};
  const bool open = device ? capture.open(options.source, cv::CAP_V4L2)
                    : isStream(options.source)
                        ? capture.open(options.source, cv::CAP_FFMPEG, patience)
                        : capture.open(options.source);
  if (!open) return false;
  if (!device) return true;
  if (options.width > 0) capture.set(cv::CAP_PROP_FRAME_WIDTH, options.width);
  if (options.height > 0) capture.set(cv::CAP_PROP_FRAME_HEIGHT, options.height);
  if (options.rate_hz > 0.0) capture.set(cv::CAP_PROP_FPS, options.rate_hz);
  capture.set(cv::CAP_PROP_BUFFERSIZE, 1);  // what waits in a buffer is old
  return true;
}

}  // namespace

FrameGrabber::FrameGrabber(GrabberOptions options, RigClock clock, FrameListener on_frame,
                           StateListener on_state)
    : options_(std::move(options)),
      clock_(std::move(clock)),
      on_frame_(std::move(on_frame)),
      on_state_(std::move(on_state)),
      thread_([this](const std::stop_token& stop) { work(stop); }) {}

void FrameGrabber::work(const std::stop_token& stop) {
  Reconnect reconnect(options_.seed);
  while (!stop.stop_requested()) {
    on_state_(State::Opening, options_.source);
    bool delivered = false;
    try {
      delivered = grabAll(stop);
    } catch (const cv::Exception& error) {
      on_state_(State::Lost, fmt::format("{}: {}", options_.source, error.err));
    }
    if (stop.stop_requested()) return;
    if (delivered) {
      reconnect.succeeded();
      if (isVideoFile(options_.source)) {
        return on_state_(State::AtEnd, options_.source + ": the video is at its end");
      }
    }
    wait(reconnect.nextDelay(), stop);
  }
}

/// Whether there was an image at all.
bool FrameGrabber::grabAll(const std::stop_token& stop) {
  cv::VideoCapture capture;
  const bool file = isVideoFile(options_.source);
  const bool may_be_there = file || isDevice(options_.source) || isStream(options_.source);
  if (!may_be_there || !opened(capture, options_)) {
    on_state_(State::Lost, options_.source +
                               ": cannot be opened: is it there, and in use by nobody "
                               "else?");
    return false;
  }
  const double told_hz = capture.get(cv::CAP_PROP_FPS);
  const double rate_hz = told_hz > 0.0 && told_hz < kMostRate_hz ? told_hz : kDefaultRate_hz;
  double due_s = clock_();
  bool any = false;
  while (!stop.stop_requested()) {
    if (file) wait(std::chrono::duration<double>(std::max(0.0, due_s - clock_())), stop);
    due_s += 1.0 / rate_hz;
    if (!capture.grab()) break;
    const double time_s = clock_();
    cv::Mat image;
    if (!capture.retrieve(image) || image.empty()) break;
    if (image.depth() != CV_8U || (image.channels() != 1 && image.channels() != 3)) {
      on_state_(State::Lost,
                fmt::format("{}: found images of {} channels and {} bits, expected 1 or 3 of 8",
                            options_.source, image.channels(), 8 * image.elemSize1()));
      return any;
    }
    if (!any) on_state_(State::Delivering, options_.source);
    any = true;
    on_frame_({time_s, std::move(image)});
  }
  if (!stop.stop_requested() && !(file && any)) {
    on_state_(State::Lost, options_.source + ": no more images come");
  }
  return any;
}

}  // namespace handmap
