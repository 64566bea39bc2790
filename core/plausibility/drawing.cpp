#include "core/plausibility/drawing.h"

#include <algorithm>
#include <limits>

#include "core/base/phrase.h"
#include "core/base/spelling.h"
#include "core/plausibility/checks.h"

namespace handmap {

namespace {

constexpr double kLong_m = 400.0;  // half of the buildings: there are no such places
constexpr double kImpossibleLength_m = 2e3;
constexpr double kMillimetres_m = 1e4;  // ten metres of them; a hundred metres in centimetres
constexpr double kThrough = 0.25;       // share of the way; drawings from memory are metres off
constexpr double kClear = 0.02;
constexpr double kBeside_m = 15.0;
constexpr double kLookedAt_m = 300.0;  // odometry is off farther on
constexpr std::size_t kLeastPlaces = 20;
constexpr double kBetweenPlaces_m = 2.0;
constexpr std::size_t kLooks = 30;
constexpr std::size_t kReturnsALook = 60;
constexpr std::size_t kLeastReturns = 300;
constexpr double kNowhere_m = 10.0;  // farther from every wall tells no more
constexpr double kFits = 0.6;        // times as far off as the drawing is
constexpr double kDrawnOff_m = 3.0;  // of a drawing from memory

void checkSizes(const Map& drawing, const std::string& file, Doubts& doubts) {
  std::vector<double> lengths_m;
  for (const Building& building : drawing.buildings) {
    lengths_m.push_back(std::max(building.box().width, building.box().depth));
  }
  const double length_m = medianOf(lengths_m);
  if (length_m < kLong_m) return;
  const auto first = std::ranges::find_if(lengths_m, [](double m) { return m >= kLong_m; });
  const bool centimetres = length_m < kMillimetres_m;
  doubts.push_back(
      {"drawing_units",
       phrase("{}: buildings[{}]: found half of them longer than {:.0f} m, expected metres", file,
              first - lengths_m.begin(), length_m),
       centimetres ? phrase("these look like centimetres") : phrase("these look like millimetres"),
       length_m >= kImpossibleLength_m,
       {},
       centimetres ? 0.01 : 0.001});
}

void checkKeys(const UnknownMembers& unknown, const std::vector<std::string_view>& known,
               const std::string& place, Doubts& doubts) {
  for (const auto& [path, value] : unknown) {
    const std::string key = path.substr(path.rfind('.') + 1);
    const auto meant = likelyMeant(key, known);
    if (!meant || *meant == key) continue;
    doubts.push_back(
        {"strange_key",
         phrase("{}{}: found a key that nothing knows, expected {}", place, path, *meant),
         phrase("without it the usual value holds"),
         false,
         {}});
  }
}

bool goesThrough(const Map& drawing, const Vec2& at) {
  return std::ranges::any_of(drawing.buildings, [&](const Building& building) {
    return contains(building.footprint(), at);
  });
}

bool goesBeside(const Map& drawing, const Vec2& at) {
  return std::ranges::any_of(drawing.buildings, [&](const Building& building) {
    return distanceTo(building.footprint(), at) < kBeside_m;
  });
}

/// From the start, in the frame of the robot there.
std::vector<Vec2> placesOnWay(const Recording& recording) {
  std::vector<Vec2> places;
  double way_m = 0.0;
  Vec2 last = Vec2::Zero();
  const auto first = recording.odometry.at(recording.rows.front().time_s);
  for (const FrameRow& row : recording.rows) {
    const auto pose = first ? recording.odometry.at(row.time_s) : std::nullopt;
    if (!pose) continue;
    const Vec2 place = between(*first, *pose).position();
    const double step_m = (place - last).norm();
    if (step_m < kBetweenPlaces_m) continue;
    way_m += step_m;
    last = place;
    if (way_m > kLookedAt_m) break;
    places.push_back(place);
  }
  return places;
}

double distanceToOutline(const Polygon& outline, const Vec2& point) {
  double least_m = kNowhere_m;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    least_m = std::min(least_m,
                       distanceTo(Segment{outline[i], outline[(i + 1) % outline.size()]}, point));
  }
  return least_m;
}

/// Mean distance of what was seen from the drawn outlines, as the drawing is and mirrored.
struct Offs {
  double drawn_m = 0.0;
  double mirrored_m = 0.0;
  std::size_t returns = 0;
};

Offs offsOfWalls(const Recording& recording, const Map& drawing, const std::stop_token& stop) {
  Offs offs;
  const auto first = recording.odometry.at(recording.rows.front().time_s);
  const auto off_m = [&](const Vec2& seen) {
    double least_m = kNowhere_m;
    for (const Building& building : drawing.buildings) {
      least_m = std::min(least_m, distanceToOutline(building.footprint(), seen));
    }
    return least_m;
  };
  for (const PointsSample& sample : samplesOf(recording, kLooks, stop)) {
    const auto pose = first ? recording.odometry.at(recording.rows[sample.row].time_s) : first;
    if (!pose) continue;
    const Pose2 here = between(*first, *pose);
    const std::size_t step = sample.points.size() / kReturnsALook + 1;
    for (std::size_t i = 0; i < sample.points.size(); i += step) {
      const RangePoint& p = sample.points[i];
      const Vec2 own(p.x, p.y);
      if (!isMeasured(p) || own.norm() > recording.range_limit_m || p.w <= 0.0F) continue;
      const Vec2 seen = here.toOuter(own);
      offs.drawn_m += off_m(drawing.start->toOuter(seen));
      offs.mirrored_m += off_m(drawing.start->toOuter({seen.x(), -seen.y()}));
      ++offs.returns;
    }
  }
  const auto count = static_cast<double>(std::max<std::size_t>(1, offs.returns));
  offs.drawn_m /= count;
  offs.mirrored_m /= count;
  return offs;
}

Doubts doubtsOfWalls(const Recording& recording, const Map& drawing, const std::string& file,
                     const std::stop_token& stop) {
  const Offs offs = offsOfWalls(recording, drawing, stop);
  const bool fits_mirrored = offs.drawn_m > kDrawnOff_m && offs.mirrored_m < kFits * offs.drawn_m;
  if (offs.returns < kLeastReturns || !fits_mirrored) return {};
  return {{"mirrored_drawing",
           phrase("{}: buildings: found what is seen {:.1f} m off their walls, mirrored {:.1f} m, "
                  "expected y up and headings counter-clockwise",
                  file, offs.drawn_m, offs.mirrored_m),
           phrase("is y of the drawing down, as in pictures, or do odometry and scans turn the "
                  "wrong way?"),
           false,
           {}}};
}

}  // namespace

Doubts doubtsOfDrawing(const Map& drawing, const std::filesystem::path& path) {
  Doubts doubts;
  const std::string file = path.string();
  checkSizes(drawing, file, doubts);
  checkKeys(drawing.unknown,
            {"name", "start", "uncertainty", "buildings", "landmarks", "route", "underlays",
             "georeference", "position_m", "size_m", "scale", "turn_deg"},
            file + ": ", doubts);
  for (const Building& building : drawing.buildings) {
    checkKeys(building.unknown, {"name", "uncertainty", "fixed", "position_m", "size_m"},
              phrase("{}: building {}: ", file, building.id), doubts);
  }
  return doubts;
}

Doubts doubtsOfWay(const Recording& recording, const Map& drawing,
                   const std::filesystem::path& path, const std::stop_token& stop) {
  if (!drawing.start || recording.odometry.empty() || recording.rows.empty()) return {};
  const std::vector<Vec2> places = placesOnWay(recording);
  if (places.size() < kLeastPlaces) return {};
  std::size_t through = 0;
  std::size_t mirrored_through = 0;
  std::size_t mirrored_beside = 0;
  for (const Vec2& place : places) {
    const Vec2 mirrored = drawing.start->toOuter({place.x(), -place.y()});
    through += goesThrough(drawing, drawing.start->toOuter(place)) ? 1 : 0;
    mirrored_through += goesThrough(drawing, mirrored) ? 1 : 0;
    mirrored_beside += goesBeside(drawing, mirrored) ? 1 : 0;
  }
  const auto all = static_cast<double>(places.size());
  const bool fits_mirrored =
      static_cast<double>(mirrored_through) <= kClear * all && 2 * mirrored_beside > places.size();
  if (static_cast<double>(through) < kThrough * all || !fits_mirrored) {
    return doubtsOfWalls(recording, drawing, path.string(), stop);
  }
  return {
      {"way_through_buildings",
       phrase("{}: found a way that leads through its buildings on {:.0f} % of {:.0f} m, "
              "mirrored it would not, expected y up and headings counter-clockwise",
              path.string(), 100.0 * static_cast<double>(through) / all, kBetweenPlaces_m * all),
       phrase("is y of the drawing down, as in pictures, or does the odometry turn the wrong "
              "way?"),
       false,
       {}}};
}

}  // namespace handmap
