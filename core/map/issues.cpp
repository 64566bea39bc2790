#include "core/map/issues.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>

#include <fmt/format.h>

#include "core/base/error.h"

namespace handmap {

namespace {

constexpr double kNarrow = 1.0;            // metres: thinner is a wall, not a building
constexpr double kLeastOverlap = 0.5;      // square metres: neighbours may touch
constexpr double kFarFromStart = 20.0;     // metres
constexpr std::size_t kBetweenLooks = 64;  // buildings from one look at the stop token to the next

struct Outline {
  const Building* building;
  Polygon polygon;
  Bounds bounds;
  bool simple;
};

class Search {
 public:
  Search(const Map& map, const std::stop_token& stop) : map_(map), stop_(stop) {
    outlines_.reserve(map.buildings.size());
    for (const Building& building : map.buildings) {
      lookForStop();
      Polygon polygon = building.footprint();
      const Bounds bounds = boundsOf(polygon);
      const bool simple = isSimple(polygon);
      outlines_.push_back({&building, std::move(polygon), bounds, simple});
    }
    std::ranges::sort(outlines_, {}, [](const Outline& o) { return o.bounds.low.x(); });
  }

  std::vector<Issue> run() {
    whole();
    overlaps();
    route();
    names();
    std::ranges::stable_sort(issues_, {}, &Issue::kind);
    return std::move(issues_);
  }

 private:
  void lookForStop() {
    if (++looked_ % kBetweenLooks == 0) throwIfStopped(stop_);
  }
  void add(Issue issue) {
    if (issues_.size() < kMaxIssues) issues_.push_back(std::move(issue));
  }

  void whole() {
    if (map_.buildings.empty()) add({Issue::Kind::NoBuilding, {}, {}});
    if (!map_.start) add({Issue::Kind::NoStart, {}, {}});
    for (const Outline& outline : outlines_) {
      const std::string& id = outline.building->id;
      const Vec2 middle = 0.5 * (outline.bounds.low + outline.bounds.high);
      if (!outline.simple) add({Issue::Kind::CrossesItself, {id}, middle});
      if (map_.start && contains(outline.polygon, map_.start->position()))
        add({Issue::Kind::StartInBuilding, {id}, map_.start->position()});
      const Rectangle box = outline.building->box();
      const double narrow = std::min(box.width, box.depth);
      if (narrow < kNarrow) add({Issue::Kind::TooNarrow, {id}, middle, narrow});
    }
  }

  /// Sorted by their left ends: those that begin before this one ends are looked at.
  void overlaps() {
    for (auto a = outlines_.begin(); a != outlines_.end(); ++a) {
      lookForStop();
      for (auto b = a + 1; b != outlines_.end() && b->bounds.low.x() < a->bounds.high.x(); ++b) {
        if (!a->simple || !b->simple || !a->bounds.overlaps(b->bounds) ||
            !overlap(a->polygon, b->polygon)) {
          continue;
        }
        const double area = intersectionArea(a->polygon, b->polygon);
        if (area < kLeastOverlap) continue;
        const Vec2 middle =
            0.5 * (a->bounds.low.cwiseMax(b->bounds.low) + a->bounds.high.cwiseMin(b->bounds.high));
        add({Issue::Kind::Overlap, {a->building->id, b->building->id}, middle, area});
        if (issues_.size() == kMaxIssues) return;
      }
    }
  }

  /// Steps along the route small enough to meet every building that is wide enough to matter.
  void route() {
    if (map_.route.empty()) return;
    if (map_.start) {
      const double away = (map_.route.front() - map_.start->position()).norm();
      if (away > kFarFromStart) add({Issue::Kind::RouteFarFromStart, {}, map_.route.front(), away});
    }
    for (const Outline& outline : outlines_) {
      lookForStop();
      if (const auto at = firstInside(outline))
        add({Issue::Kind::RouteInBuilding, {outline.building->id}, *at});
    }
  }

  std::optional<Vec2> firstInside(const Outline& outline) const {
    for (std::size_t i = 0; i < map_.route.size(); ++i) {
      if (contains(outline.polygon, map_.route[i])) return map_.route[i];
      if (i == 0) continue;
      const Segment leg{map_.route[i - 1], map_.route[i]};
      const Bounds around{leg.a.cwiseMin(leg.b).array() - 1e-9,
                          leg.a.cwiseMax(leg.b).array() + 1e-9};
      if (!around.overlaps(outline.bounds)) continue;
      if (auto at = crossing(leg, outline.polygon)) return at;
    }
    return std::nullopt;
  }

  static std::optional<Vec2> crossing(const Segment& leg, const Polygon& polygon) {
    const Vec2 offset = leg.b - leg.a;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2& from = polygon[i];
      const Vec2 edge = polygon[(i + 1) % polygon.size()] - from;
      const double turn = cross(offset, edge);
      if (turn == 0.0) continue;
      const double along = cross(from - leg.a, edge) / turn;
      const double on_edge = cross(from - leg.a, offset) / turn;
      if (along > 0.0 && along < 1.0 && on_edge >= 0.0 && on_edge <= 1.0)
        return leg.a + along * offset;
    }
    return std::nullopt;
  }

  void names() {
    std::unordered_map<std::string_view, std::string_view> first;
    const auto look = [&](const auto& item, const Vec2& at) {
      if (item.name.empty()) return;
      const auto [earlier, is_new] = first.try_emplace(item.name, item.id);
      if (!is_new) add({Issue::Kind::SameName, {item.id, std::string(earlier->second)}, at});
    };
    for (const Building& building : map_.buildings) look(building, building.box().centre);
    for (const Landmark& landmark : map_.landmarks) look(landmark, landmark.position);
  }

  const Map& map_;
  const std::stop_token& stop_;
  std::vector<Outline> outlines_;
  std::vector<Issue> issues_;
  std::size_t looked_ = 0;
};

}  // namespace

std::vector<Issue> findIssues(const Map& map, const std::stop_token& stop) {
  return Search(map, stop).run();
}

std::string inWords(const Issue& issue) {
  switch (issue.kind) {
    case Issue::Kind::NoBuilding:
      return "there is no building";
    case Issue::Kind::NoStart:
      return "there is no start: a run needs to know where the robot begins";
    case Issue::Kind::StartInBuilding:
      return fmt::format("the start lies in {}", issue.ids[0]);
    case Issue::Kind::RouteInBuilding:
      return fmt::format("the route leads through {}", issue.ids[0]);
    case Issue::Kind::RouteFarFromStart:
      return fmt::format("the route begins {:.1f} m from the start", issue.metres);
    case Issue::Kind::Overlap:
      return fmt::format("{} and {} overlap by {:.1f} m²", issue.ids[0], issue.ids[1],
                         issue.metres);
    case Issue::Kind::CrossesItself:
      return fmt::format("the outline of {} crosses itself", issue.ids[0]);
    case Issue::Kind::SameName:
      return fmt::format("{} and {} have the same name", issue.ids[1], issue.ids[0]);
    case Issue::Kind::TooNarrow:
      return fmt::format("{} is {:.2f} m narrow", issue.ids[0], issue.metres);
  }
  return {};
}

}  // namespace handmap
