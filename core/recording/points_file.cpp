#include <bit>
#include <cmath>
#include <cstring>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/recording/recording.h"

namespace handmap {

namespace {

constexpr std::uintmax_t kMaxPointsBytes = 64u << 20;
static_assert(std::endian::native == std::endian::little && sizeof(RangePoint) == 16,
              "points files are read as they lie in memory");

}  // namespace

std::vector<RangePoint> readPoints(const std::filesystem::path& path) {
  const std::string file = path.string();
  const std::string content = readFile(path, kMaxPointsBytes);
  if (content.empty() || content.size() % sizeof(RangePoint) != 0) {
    throwBadInput(file, "", phrase("{} bytes", content.size()),
                  phrase("16 bytes a point, at least one point"));
  }
  std::vector<RangePoint> points(content.size() / sizeof(RangePoint));
  std::memcpy(points.data(), content.data(), content.size());

  std::size_t not_finite = 0;
  std::size_t bad_weight = 0;
  for (const RangePoint& p : points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) ++not_finite;
    if (!(p.w >= 0.0f && p.w <= 1.0f)) ++bad_weight;
  }
  if (not_finite > 0) {
    throwBadInput(file, "", phrase("{} points that are not finite", not_finite),
                  phrase("finite coordinates"));
  }
  if (bad_weight > 0) {
    throwBadInput(file, "", phrase("{} points with w outside 0 … 1", bad_weight),
                  phrase("w from 0 to 1"));
  }
  return points;
}

}  // namespace handmap
