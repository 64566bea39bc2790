#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/recording/points_part.h"
#include "core/recording/recording.h"

namespace handmap {

namespace {

constexpr std::uintmax_t kMaxPointsBytes = 64u << 20;
constexpr std::size_t kBytesOfXyz = 3 * sizeof(float);
constexpr std::size_t kIdsInPoints = sizeof(RangePoint) / sizeof(std::uint32_t);  // in bytes
static_assert(std::endian::native == std::endian::little && sizeof(RangePoint) == 16,
              "points files are read as they lie in memory");

bool hasLikelihood(const RangePoint& p) {
  return !std::isfinite(p.w) || (p.w >= 0.0F && p.w <= 1.0F);
}

std::vector<RangePoint> withoutLikelihood(const std::string& content) {
  std::vector<RangePoint> points(content.size() / kBytesOfXyz, RangePoint{0, 0, 0, 1});
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::memcpy(&points[i], content.data() + i * kBytesOfXyz, kBytesOfXyz);
  }
  return points;
}

std::vector<RangePoint> parsePoints(const std::string& content, const std::string& file) {
  const bool may_be_xyz = content.size() % kBytesOfXyz == 0;
  if (content.size() % sizeof(RangePoint) != 0) {
    if (may_be_xyz) return withoutLikelihood(content);
    throwBadInput(file, "", phrase("{} bytes", content.size()),
                  phrase("16 bytes a point (x y z w) or 12 (x y z)"));
  }
  std::vector<RangePoint> points(content.size() / sizeof(RangePoint));
  if (!points.empty()) std::memcpy(points.data(), content.data(), content.size());
  const auto bad = points.size() - static_cast<std::size_t>(
                                       std::count_if(points.begin(), points.end(), hasLikelihood));
  if (bad == 0) return points;
  // A coordinate in the place of w is now and then below 0, an intensity never.
  const bool below = std::ranges::any_of(points, [](const RangePoint& p) { return p.w < 0.0F; });
  if (may_be_xyz && below) return withoutLikelihood(content);
  throwBadInput(file, "", phrase("{} points with w outside 0 … 1", bad),
                phrase("w from 0 to 1: how surely a point is on a building, no intensity"));
}

std::string readPart(const PointsPart& part) {
  const std::string file = part.file.string();
  std::ifstream stream(part.file, std::ios::binary | std::ios::ate);
  if (!stream) throwBadInput(file, "", phrase("no such file"), phrase("a readable file"));
  const auto size = static_cast<std::uintmax_t>(stream.tellg());
  if (part.bytes > kMaxPointsBytes || part.offset > size || part.bytes > size - part.offset) {
    throwBadInput(file, "", phrase("{} bytes", size),
                  phrase("{} bytes from byte {} on", part.bytes, part.offset));
  }
  std::string content(part.bytes, '\0');
  stream.seekg(static_cast<std::streamoff>(part.offset));
  stream.read(content.data(), static_cast<std::streamsize>(part.bytes));
  if (!stream) throwBadInput(file, "", phrase("no more bytes"), phrase("a readable file"));
  return content;
}

/// Beside NAME.bin may lie NAME.ids; of a part of the one the same part of the other.
std::vector<std::uint32_t> readIds(const std::optional<PointsPart>& part,
                                   const std::filesystem::path& path, std::size_t points) {
  std::filesystem::path file = part ? part->file : path;
  file.replace_extension(".ids");
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return {};
  const std::string content =
      part ? readPart({file, part->offset / kIdsInPoints, part->bytes / kIdsInPoints})
           : readFile(file, kMaxPointsBytes);
  if (content.size() != points * sizeof(std::uint32_t)) {
    throwBadInput(file.string(), "", phrase("{} bytes", content.size()),
                  phrase("4 bytes for each of {} points", points));
  }
  std::vector<std::uint32_t> ids(points);
  if (!ids.empty()) std::memcpy(ids.data(), content.data(), content.size());
  return ids;
}

}  // namespace

void readPoints(const std::filesystem::path& path, View& view) {
  const auto part = partOf(path);
  std::vector<RangePoint> points =
      parsePoints(part ? readPart(*part) : readFile(path, kMaxPointsBytes), path.string());
  std::vector<std::uint32_t> ids = readIds(part, path, points.size());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const RangePoint& p = points[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z) || !std::isfinite(p.w)) {
      continue;
    }
    if (!ids.empty()) ids[kept] = ids[i];
    points[kept++] = p;
  }
  points.resize(kept);
  if (!ids.empty()) ids.resize(kept);
  view.points = std::move(points);
  view.ids = std::move(ids);
}

std::vector<RangePoint> readPoints(const std::filesystem::path& path) {
  View view;
  readPoints(path, view);
  return std::move(*view.points);
}

std::optional<PointsPart> partOf(const std::filesystem::path& path) {
  const std::string text = path.string();
  const std::size_t at = text.rfind('@');
  const std::size_t plus = text.find('+', at == std::string::npos ? text.size() : at);
  if (plus == std::string::npos) return std::nullopt;
  const auto offset = parseInteger(std::string_view(text).substr(at + 1, plus - at - 1));
  const auto bytes = parseInteger(std::string_view(text).substr(plus + 1));
  if (!offset || !bytes || *offset < 0 || *bytes < 0) return std::nullopt;
  return PointsPart{text.substr(0, at), static_cast<std::uintmax_t>(*offset),
                    static_cast<std::uintmax_t>(*bytes)};
}

}  // namespace handmap
