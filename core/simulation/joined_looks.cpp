#include "core/simulation/joined_looks.h"

#include <array>
#include <cmath>
#include <set>

namespace handmap {

namespace {

constexpr float kLowest_m = 0.3F;  // this and the next two: boulevard/dense
constexpr double kFarthest_m = 35.0;
constexpr double kCell_m = 0.12;

std::array<int, 3> cellOf(const RangePoint& point) {
  const auto cell = [](float metres) { return static_cast<int>(std::floor(metres / kCell_m)); };
  return {cell(point.x), cell(point.y), cell(point.z)};
}

}  // namespace

View JoinedLooks::add(const View& view, const Pose2& odometry) {
  if (!looks_.empty()) driven_m_ += between(looks_.back().odometry, odometry).position().norm();
  looks_.push_back({driven_m_, odometry, view});
  while (looks_.front().at_m < driven_m_ - metres_) looks_.pop_front();
  View joined;
  joined.points.emplace();
  std::set<std::array<int, 3>> taken;
  for (auto look = looks_.rbegin(); look != looks_.rend(); ++look) {
    const Pose2 seen_from = between(odometry, look->odometry);
    for (std::size_t i = 0; i < look->view.ids.size(); ++i) {
      RangePoint point = (*look->view.points)[i];
      const Vec2 place = seen_from.toOuter({point.x, point.y});
      point.x = static_cast<float>(place.x());
      point.y = static_cast<float>(place.y());
      if (point.z <= kLowest_m || place.norm() > kFarthest_m) continue;
      if (!taken.insert(cellOf(point)).second) continue;
      joined.points->push_back(point);
      joined.ids.push_back(look->view.ids[i]);
    }
  }
  return joined;
}

}  // namespace handmap
