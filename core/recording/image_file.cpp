#include "core/recording/image_file.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"

namespace handmap {

namespace {

constexpr std::uintmax_t kMaxImageBytes = 256u << 20;
constexpr std::string_view kPngMagic = "\x89PNG\r\n\x1a\n";
constexpr std::string_view kPngEnd = "IEND\xae\x42\x60\x82";
constexpr std::string_view kJpegMagic = "\xff\xd8\xff";
constexpr std::string_view kJpegEnd = "\xff\xd9";

/// What the header of an image file says, and whether its end is there.
struct Header {
  std::int64_t width = 0;
  std::int64_t height = 0;
  bool complete = false;
};

std::int64_t bigEndian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::int64_t value = 0;
  for (const char byte : bytes.substr(at, count)) value = value * 256 + std::uint8_t(byte);
  return value;
}

std::optional<Header> pngHeader(std::string_view bytes) {
  if (bytes.size() < 33 || bytes.substr(12, 4) != "IHDR") return std::nullopt;
  return Header{bigEndian(bytes, 16, 4), bigEndian(bytes, 20, 4),
                bytes.find(kPngEnd) != std::string_view::npos};
}

/// Walks from segment to segment to the frame header (SOF), then to the start of the scan: past
/// that, the end mark cannot be part of a thumbnail.
std::optional<Header> jpegHeader(std::string_view bytes) {
  std::optional<Header> header;
  std::size_t at = 2;
  while (at + 4 <= bytes.size() && std::uint8_t(bytes[at]) == 0xff) {
    const int marker = std::uint8_t(bytes[at + 1]);
    if (marker == 0xff) {  // padding
      ++at;
      continue;
    }
    const bool is_frame =
        marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (is_frame && at + 9 <= bytes.size()) {
      header = Header{bigEndian(bytes, at + 7, 2), bigEndian(bytes, at + 5, 2), false};
    }
    if (marker == 0xda) {
      if (header) header->complete = bytes.find(kJpegEnd, at) != std::string_view::npos;
      return header;
    }
    at += 2 + static_cast<std::size_t>(bigEndian(bytes, at + 2, 2));
  }
  return header;
}

Header readHeader(std::string_view bytes, const std::string& file) {
  std::optional<Header> header;
  if (bytes.empty()) {
    throwBadInput(file, "", phrase("an empty file"), phrase("a PNG or JPEG image"));
  }
  if (bytes.starts_with(kPngMagic)) header = pngHeader(bytes);
  if (bytes.starts_with(kJpegMagic)) header = jpegHeader(bytes);
  if (!header) throwBadInput(file, "", phrase("no image"), phrase("a PNG or JPEG image"));
  return *header;
}

/// Of a whole image of at most so many pixels.
Header checkedHeader(std::string_view bytes, const std::string& file, std::int64_t most_pixels) {
  const Header header = readHeader(bytes, file);
  // The sides first: their product may be more than a number holds.
  const bool fits = header.width <= most_pixels && header.height <= most_pixels &&
                    header.width * header.height <= most_pixels;
  if (!fits) {
    throwBadInput(file, "", phrase("{} × {} pixels", header.width, header.height),
                  phrase("at most {} megapixels", most_pixels / 1'000'000));
  }
  if (!header.complete) {
    throwBadInput(file, "", phrase("an image that is cut off"), phrase("a whole one"));
  }
  return header;
}

cv::Mat decoded(std::string_view bytes, const std::string& file, int flags) {
  cv::Mat image;
  try {
    if (bytes.size() > kMaxImageBytes) {
      throwBadInput(file, "", phrase("more than 256 MiB"), phrase("a smaller image"));
    }
    const cv::Mat buffer(1, static_cast<int>(bytes.size()), CV_8UC1,
                         const_cast<char*>(bytes.data()));
    image = cv::imdecode(buffer, flags);
  } catch (const cv::Exception& error) {
    throwBadInput(file, "", error.err, phrase("an image that can be decoded"));
  }
  if (image.empty()) {
    throwBadInput(file, "", phrase("a damaged image"), phrase("one that can be decoded"));
  }
  return image;
}

}  // namespace

cv::Mat readImage(const std::filesystem::path& path) {
  return decodeImage(readFile(path, kMaxImageBytes), path.string());
}

cv::Mat decodeImage(std::string_view bytes, const std::string& file) {
  checkedHeader(bytes, file, kMaxImagePixels);
  cv::Mat image = decoded(bytes, file, cv::IMREAD_UNCHANGED);
  if (image.depth() != CV_8U || (image.channels() != 1 && image.channels() != 3)) {
    throwBadInput(file, "",
                  phrase("{} channels of {} bits", image.channels(), 8 * image.elemSize1()),
                  phrase("1 or 3 channels of 8 bits"));
  }
  return image;
}

cv::Mat readPhoto(const std::filesystem::path& path, int side_px) {
  return decodePhoto(readFile(path, kMaxImageBytes), path.string(), side_px);
}

cv::Mat decodePhoto(std::string_view bytes, const std::string& file, int side_px) {
  const Header header = checkedHeader(bytes, file, kMaxPhotoPixels);
  const std::int64_t times = std::max(header.width, header.height) / std::max(1, side_px);
  const int flags = times >= 8   ? cv::IMREAD_REDUCED_COLOR_8
                    : times >= 4 ? cv::IMREAD_REDUCED_COLOR_4
                    : times >= 2 ? cv::IMREAD_REDUCED_COLOR_2
                                 : cv::IMREAD_COLOR;
  return decoded(bytes, file, flags);
}

cv::Mat greyImage(const cv::Mat& image) {
  if (image.channels() == 1) return image;
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

void writePng(const cv::Mat& image, const std::filesystem::path& path) {
  std::vector<unsigned char> bytes;
  bool done = false;
  try {
    done = cv::imencode(".png", image, bytes);
  } catch (const cv::Exception&) {
    done = false;
  }
  if (!done) {
    throw Error(ErrorCode::RunFailed, phrase("{}: cannot be encoded as PNG", path.string()));
  }
  writeFileAtomically(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace handmap
