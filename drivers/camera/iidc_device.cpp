#include "drivers/camera/iidc_device.h"

#include <charconv>

#include <fmt/format.h>
#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "drivers/camera/raw_images.h"

namespace handmap {

namespace {

constexpr double kSilent_s = 2.0;
constexpr double kPoll_s = 0.003;
constexpr auto kFirst = "first";

std::uint64_t identityOf(const std::string& source, const std::vector<std::uint64_t>& there) {
  if (there.empty()) {
    throw Error(ErrorCode::RunFailed,
                phrase("no FireWire camera answers: is it connected, and may you use /dev/fw*?"));
  }
  if (source == kFirst) return there.front();
  std::uint64_t identity = 0;
  const auto [end, error] =
      std::from_chars(source.data(), source.data() + source.size(), identity, 16);
  if (error != std::errc() || end != source.data() + source.size()) {
    throw Error(ErrorCode::RunFailed,
                phrase("FireWire camera: found \"{}\", expected its number (hexadecimal) or "
                       "\"first\"",
                       source));
  }
  for (const std::uint64_t one : there) {
    if (one == identity) return identity;
  }
  throw Error(ErrorCode::RunFailed, phrase("the FireWire camera {} does not answer; {:016x} does",
                                           source, there.front()));
}

class IidcDevice : public ImageDevice {
 public:
  IidcDevice(const std::string& source, std::unique_ptr<IidcCamera> camera, RigClock clock)
      : camera_(std::move(camera)), clock_(std::move(clock)), last_s_(clock_()) {
    camera_->begin(identityOf(source, camera_->identities()));
    tile_ = bayerTileOf(camera_->bayerRegister());
  }

  std::optional<TimedImage> next(const std::stop_token& stop) override {
    while (!stop.stop_requested() && clock_() - last_s_ < kSilent_s) {
      const auto frame = camera_->poll();
      if (!frame) {
        waitFor(kPoll_s, stop);
        continue;
      }
      TimedImage image{clock_() - frame->age_s, frame->damaged ? cv::Mat() : both(*frame)};
      camera_->done();
      if (frame->damaged) continue;
      last_s_ = clock_();
      return image;
    }
    return std::nullopt;
  }

 private:
  /// The right image comes first; of three the one in the middle is left out: the outer ones are
  /// farther apart.
  cv::Mat both(const IidcFrame& frame) const {
    if (frame.images != 2 && frame.images != 3) {
      throw Error(ErrorCode::RunFailed,
                  phrase("FireWire camera: found {} bytes a pixel, expected the 2 or 3 of a "
                         "stereo head",
                         frame.images));
    }
    const auto images = deinterlaced(frame.bytes, {frame.width, frame.height}, frame.images);
    cv::Mat pair;
    cv::hconcat(developed(images.back(), tile_), developed(images.front(), tile_), pair);
    return pair;
  }

  std::unique_ptr<IidcCamera> camera_;
  RigClock clock_;
  double last_s_;
  BayerTile tile_ = BayerTile::None;
};

}  // namespace

OpenImageDevice iidcDevice(std::string source, OpenIidc open, RigClock clock) {
  return [source = std::move(source), open = std::move(open), clock = std::move(clock)] {
    return std::make_unique<IidcDevice>(source, open(), clock);
  };
}

std::vector<std::string> iidcCameras(IidcCamera& camera) {
  std::vector<std::string> sources;
  for (const std::uint64_t identity : camera.identities()) {
    sources.push_back(fmt::format("{:016x}", identity));
  }
  return sources;
}

}  // namespace handmap
