#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "core/bags/ros_messages.h"
#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/recording/image_file.h"

namespace handmap::ros {

namespace {

/// How OpenCV makes one or three channels (blue first) of it; -1: as it is.
struct PixelForm {
  std::string_view name;
  int channels;
  int conversion;
};

// OpenCV names a Bayer pattern by the second row of its second and third column.
constexpr std::array kForms = {PixelForm{"mono8", 1, -1},
                               PixelForm{"8UC1", 1, -1},
                               PixelForm{"bgr8", 3, -1},
                               PixelForm{"8UC3", 3, -1},
                               PixelForm{"rgb8", 3, cv::COLOR_RGB2BGR},
                               PixelForm{"bgra8", 4, cv::COLOR_BGRA2BGR},
                               PixelForm{"rgba8", 4, cv::COLOR_RGBA2BGR},
                               PixelForm{"bayer_rggb8", 1, cv::COLOR_BayerBG2BGR},
                               PixelForm{"bayer_bggr8", 1, cv::COLOR_BayerRG2BGR},
                               PixelForm{"bayer_gbrg8", 1, cv::COLOR_BayerGR2BGR},
                               PixelForm{"bayer_grbg8", 1, cv::COLOR_BayerGB2BGR},
                               PixelForm{"yuv422", 2, cv::COLOR_YUV2BGR_UYVY},
                               PixelForm{"yuv422_yuy2", 2, cv::COLOR_YUV2BGR_YUY2}};

}  // namespace

cv::Mat imageOf(const PlainImage& plain, const std::string& source) {
  const auto refuse = [&](const std::string& found, const std::string& expected) {
    throwBadInput(source, "", found, expected);
  };
  const auto& [height, width, encoding, step, data] = plain;
  const auto form = std::ranges::find(kForms, encoding, &PixelForm::name);
  if (form == kForms.end()) {
    refuse(fmt::format("\"{}\"", encoding), "mono8, bgr8, rgb8, bayer_rggb8, yuv422 …");
  }
  const std::uint64_t pixels = std::uint64_t{width} * height;
  if (pixels == 0 || pixels > static_cast<std::uint64_t>(kMaxImagePixels)) {
    refuse(phrase("{} × {} pixels", width, height), phrase("at most {}", kMaxImagePixels));
  }
  const std::size_t line = std::size_t{width} * static_cast<std::size_t>(form->channels);
  if (step < line || data.size() / step < height) {
    refuse(phrase("{} bytes", data.size()), phrase("{} bytes", line * height));
  }
  const bool is_pair = form->channels == 2 || encoding.starts_with("bayer");
  if (is_pair && (width % 2 != 0 || height % 2 != 0)) {
    refuse(phrase("{} × {} pixels", width, height), phrase("even numbers"));
  }
  const cv::Mat raw(static_cast<int>(height), static_cast<int>(width), CV_8UC(form->channels),
                    const_cast<char*>(data.data()), step);
  cv::Mat image;
  if (form->conversion < 0) return raw.clone();
  cv::cvtColor(raw, image, form->conversion);
  return image;
}

cv::Mat readImage(FieldReader fields, const BagTopic& topic) {
  readHeader(fields, topic.encoding);
  if (topic.type == "sensor_msgs/Image") {
    PlainImage plain;
    plain.height = fields.get<std::uint32_t>();
    plain.width = fields.get<std::uint32_t>();
    plain.encoding = fields.text(100);
    fields.get<std::uint8_t>();  // 8 bit: no order of bytes
    plain.step = std::size_t{fields.get<std::uint32_t>()};
    plain.data = fields.takeSized<std::uint32_t>();
    return imageOf(plain, fields.source());
  }
  fields.text(200);  // "jpeg", "bgr8; jpeg compressed bgr8"; the bytes themselves tell
  return decodeImage(fields.takeSized<std::uint32_t>(), fields.source());
}

}  // namespace handmap::ros
