// A drawing comes out the same wherever it lies in the world, however it is written down, and
// whichever way a scanner begins to look.
#include <gtest/gtest.h>

#include "core/session/run_session.h"
#include "core/simulation/simulated_source.h"

namespace handmap {
namespace {

const World kPlace = campusWorld(11);
constexpr double kSame = 0.97;  // mean overlap; what nobody saw is told by chance

Map drawn() {
  Map drawing = perturbed(kPlace.map, 6.0, 2);
  drawing.uncertainty = {6.0, 6.0};
  return drawing;
}

/// As it lies elsewhere: outlines and start.
Map laid(Map map, const Pose2& at) {
  for (Building& building : map.buildings) {
    if (auto* box = std::get_if<Rectangle>(&building.shape)) {
      box->centre = at.toOuter(box->centre);
      box->heading += at.heading;
    } else {
      for (Vec2& corner : std::get<Polygon>(building.shape)) corner = at.toOuter(corner);
    }
  }
  map.start = at * *map.start;
  return map;
}

/// A scanner with every third ray of another: always the same ones, or in turn.
class EveryThirdRay : public ObservationSource {
 public:
  EveryThirdRay(std::unique_ptr<ObservationSource> source, bool in_turn)
      : source_(std::move(source)), in_turn_(in_turn) {}
  const SourceInfo& info() const override { return source_->info(); }
  std::optional<Observation> next() override {
    auto observation = source_->next();
    if (!observation) return observation;
    for (View& view : observation->views) {
      std::vector<RangePoint> kept;
      if (!view.points) continue;
      for (const RangePoint& p : *view.points) {
        const auto ray = std::lround(static_cast<double>(std::atan2(p.y, p.x)) / kRay) + 720;
        if (ray % 3 == first_) kept.push_back(p);
      }
      view.points = kept;
    }
    if (in_turn_) first_ = (first_ + 1) % 3;
    return observation;
  }

 private:
  static constexpr double kRay = toRadians(0.5);
  std::unique_ptr<ObservationSource> source_;
  bool in_turn_;
  long first_ = 0;
};

Map corrected(const Map& drawing,
              std::unique_ptr<ObservationSource> source = simulate(kPlace, laserOnTheMove(4.0),
                                                                   3)) {
  RunSession session(drawing, std::move(source), {});
  std::shared_ptr<const Snapshot> last;
  while (const auto next = session.step()) last = next;
  return last->map.get();
}

/// How well the buildings lie on those of another map, each laid as told.
double meanOverlap(const Map& map, const Map& other, const Pose2& at) {
  double sum = 0.0;
  for (std::size_t b = 0; b < map.buildings.size(); ++b) {
    Polygon outline = other.buildings[b].footprint();
    for (Vec2& corner : outline) corner = at.toOuter(corner);
    sum += intersectionOverUnion(map.buildings[b].footprint(), outline);
  }
  return sum / static_cast<double>(map.buildings.size());
}

class SamePlace : public testing::Test {
 protected:
  static void SetUpTestSuite() { usual_ = corrected(drawn()); }
  static double sameness(const Map& drawing, const Pose2& at = {}) {
    return meanOverlap(corrected(drawing), usual_, at);
  }
  static inline Map usual_;
};

TEST_F(SamePlace, WhereverItLies) {
  ASSERT_GT(meanOverlap(usual_, kPlace.map, {}), meanOverlap(drawn(), kPlace.map, {}) + 0.2);
  for (const Pose2& at : {Pose2{45000.0, -80000.0, 0.0}, Pose2{-300.0, 70.0, toRadians(37.0)}}) {
    EXPECT_GT(sameness(laid(drawn(), at), at), kSame) << at.x << ", " << toDegrees(at.heading);
  }
}

TEST_F(SamePlace, WithRectanglesWrittenAnotherWay) {
  Map aslant = drawn();
  Map outlines = drawn();
  for (Building& building : aslant.buildings) {
    if (auto* box = std::get_if<Rectangle>(&building.shape)) {
      std::swap(box->width, box->depth);
      box->heading += kPi / 2.0;
    }
  }
  for (Building& building : outlines.buildings) building.shape = building.footprint();
  EXPECT_GT(sameness(aslant), kSame);
  EXPECT_GT(sameness(outlines), kSame);
}

TEST_F(SamePlace, InAnotherOrder) {
  Map drawing = drawn();
  std::ranges::reverse(drawing.buildings);
  Map now = corrected(drawing);
  std::ranges::reverse(now.buildings);
  EXPECT_GT(meanOverlap(now, usual_, {}), kSame);
}

TEST_F(SamePlace, WhicheverRayAScanBeginsWith) {
  const auto by = [](bool in_turn) {
    return std::make_unique<EveryThirdRay>(simulate(kPlace, laserOnTheMove(2.0), 3), in_turn);
  };
  const double fixed = meanOverlap(corrected(drawn(), by(false)), kPlace.map, {});
  const double in_turn = meanOverlap(corrected(drawn(), by(true)), kPlace.map, {});
  EXPECT_GT(in_turn, fixed - 0.05) << fixed << " where it always begins with the same";
}

}  // namespace
}  // namespace handmap
