#include <cmath>

#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/plausibility/checks.h"
#include "core/recording/points_part.h"

namespace handmap {

namespace {

constexpr double kFar_m = 100.0;         // half of the returns: no sensor of robots does that
constexpr double kImpossible_m = 250.0;  // beyond what any reaches in daylight
constexpr double kNear_m = 3.0;          // less than that is no street in millimetres
constexpr double kCutShare = 0.25;
constexpr std::size_t kLeastHeights = 20;
constexpr double kOneHeight_m = 0.3;
constexpr double kGroundRange_m = 15.0;
constexpr double kSunk_m = 0.7;  // more than kerbs and ramps
constexpr std::size_t kRowsLookedFor = 2000;

double rangeOf(const RangePoint& p) { return std::hypot(p.x, p.y); }

double quantile(std::vector<double>& values, double share) {
  if (values.empty()) return 0.0;
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

std::string placeOf(const Recording& recording, const PointsSample& sample) {
  const FrameRow& row = recording.rows[sample.row];
  const auto part = partOf(recording.folder / row.points);
  return phrase("{}: frame {}",
                part ? part->file.string() : (recording.folder / row.points).string(), row.frame);
}

bool checkUnits(const Recording& recording, const PointsSample& first, double median_m,
                Doubts& doubts) {
  if (median_m < kFar_m) return false;
  const bool centimetres = median_m < 1000.0 * kNear_m;
  Doubt doubt;
  doubt.code = "points_units";
  doubt.certain = median_m >= kImpossible_m;
  doubt.message = phrase("{}: found half of the points farther away than {:.0f} m, expected metres",
                         placeOf(recording, first), median_m);
  doubt.hint = centimetres ? phrase("these look like centimetres: multiply x, y and z by 0.01")
                           : phrase("these look like millimetres: multiply x, y and z by 0.001");
  doubt.remedy = Remedy{centimetres ? phrase("Read the points as centimetres")
                                    : phrase("Read the points as millimetres")};
  doubt.remedy->points.scale = centimetres ? 0.01F : 0.001F;
  doubts.push_back(std::move(doubt));
  return true;
}

void checkRangeLimit(const Recording& recording, std::vector<double>& ranges_m, Doubts& doubts) {
  const auto beyond = std::ranges::count_if(
      ranges_m, [&](double range_m) { return range_m > recording.range_limit_m; });
  const double share = static_cast<double>(beyond) / static_cast<double>(ranges_m.size());
  if (share < kCutShare) return;
  const double reached_m =
      std::min(kMostReach_m, std::ceil(quantile(ranges_m, 0.99) / 10.0) * 10.0);
  Doubt doubt;
  doubt.code = "range_limit";
  doubt.message = phrase(
      "{}: range_limit_m: found {:.0f} % of the returns beyond {} m, where they "
      "are not used, expected the reach of the sensor",
      (recording.folder / "recording.json").string(), 100.0 * share,
      formatNumber(recording.range_limit_m));
  doubt.hint =
      phrase("\"range_limit_m\": {} in recording.json takes them in", formatNumber(reached_m));
  doubt.remedy = Remedy{phrase("See {} m far", formatNumber(reached_m))};
  doubt.remedy->range_limit_m = reached_m;
  doubts.push_back(std::move(doubt));
}

/// Where the ground is, of clouds that see it.
void checkHeights(const Recording& recording, const std::vector<PointsSample>& samples,
                  Doubts& doubts) {
  std::vector<double> lows_m;
  for (const PointsSample& sample : samples) {
    std::vector<double> heights_m;
    for (const RangePoint& p : sample.points) {
      if (rangeOf(p) < kGroundRange_m) heights_m.push_back(p.z);
    }
    if (heights_m.size() < kLeastHeights) continue;
    const double low_m = quantile(heights_m, 0.05);
    if (quantile(heights_m, 0.95) - low_m > kOneHeight_m) lows_m.push_back(low_m);
  }
  const double ground_m = medianOf(lows_m);
  if (lows_m.empty() || ground_m > -kSunk_m) return;
  Doubt doubt;
  doubt.code = "heights";
  doubt.message = phrase("{}: found the ground at z = {:.1f} m, expected it at 0",
                         placeOf(recording, samples.front()), ground_m);
  doubt.hint = phrase("z looks counted from the sensor: add its height, some {:.1f} m", -ground_m);
  doubt.remedy = Remedy{phrase("Raise the points by {:.1f} m", -ground_m)};
  doubt.remedy->points.raise_m = static_cast<float>(-ground_m);
  doubts.push_back(std::move(doubt));
}

void checkLikelihoods(const Recording& recording, const std::vector<PointsSample>& samples,
                      Doubts& doubts) {
  const PointsSample* some = nullptr;
  for (const PointsSample& sample : samples) {
    if (!sample.points.empty()) some = &sample;
    if (std::ranges::any_of(sample.points, [](const RangePoint& p) { return p.w > 0.0F; })) return;
  }
  if (!some) return;
  doubts.push_back({"likelihood_zero",
                    phrase("{}: found w = 0 in all points: none of them counts, expected how "
                           "surely each is on a building",
                           placeOf(recording, *some)),
                    phrase("where nothing is known of that, w is 1"),
                    true,
                    {}});
}

}  // namespace

void checkFiles(const Recording& recording, Doubts& doubts) {
  const std::vector<std::size_t> rows = rowsWithPoints(recording);
  const std::size_t step = rows.size() / kRowsLookedFor + 1;
  std::size_t looked = 0;
  std::size_t missing = 0;
  std::optional<int> first;
  for (std::size_t i = 0; i < rows.size(); i += step) {
    const FrameRow& row = recording.rows[rows[i]];
    const auto part = partOf(recording.folder / row.points);
    ++looked;
    if (fileExists(part ? part->file : recording.folder / row.points)) continue;
    ++missing;
    if (!first) first = row.frame;
  }
  if (missing < 2 || 10 * missing < looked) return;
  doubts.push_back({"points_missing",
                    phrase("{}: points: found {} of {} points files missing, the first here, "
                           "expected all",
                           placeOfFrame(recording, *first), missing, looked),
                    phrase("was the folder copied whole?"),
                    missing == looked,
                    {}});
}

void checkPoints(const Recording& recording, const std::vector<PointsSample>& samples,
                 Doubts& doubts) {
  std::vector<double> ranges_m;
  for (const PointsSample& sample : samples) {
    for (const RangePoint& p : sample.points) ranges_m.push_back(rangeOf(p));
  }
  if (ranges_m.empty()) return;
  const double median_m = quantile(ranges_m, 0.5);
  checkLikelihoods(recording, samples, doubts);
  if (checkUnits(recording, samples.front(), median_m, doubts)) return;
  checkRangeLimit(recording, ranges_m, doubts);
  checkHeights(recording, samples, doubts);
}

}  // namespace handmap
