#include "core/estimation/labels/assignment.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace handmap {
namespace {

FoundBox foundAt(const Rectangle& box) {
  return {boxOf(box), 100.0, 0.01 * Eigen::Matrix4d::Identity(), 0.001, 9};
}

struct Case {
  Map drawing;
  std::vector<FoundBox> found;
};

Case randomCase(RandomStream& random, int count, double sigma) {
  Case result;
  result.drawing.start = Pose2{};
  result.drawing.uncertainty = {sigma, sigma};
  result.drawing.whole.shift = 0.0;
  for (int i = 0; i < count; ++i) {
    const Rectangle truth{
        {40.0 * i + random.uniform(0.0, 10.0), random.uniform() < 0.5 ? 20.0 : -20.0},
        random.uniform(15.0, 30.0),
        15.0,
        0.0};
    Building building;
    building.id = std::to_string(i);
    Rectangle drawn = truth;
    drawn.centre += Vec2(random.normal(0.0, sigma), random.normal(0.0, sigma));
    drawn.width = std::max(5.0, random.normal(drawn.width, sigma));
    building.shape = drawn;
    result.drawing.buildings.push_back(building);
    result.found.push_back(foundAt(truth));
  }
  return result;
}

/// Named by their places.
std::vector<Hypothesis> assignAlone(const Case& c, std::span<const Pose2> way,
                                    const AssignmentOptions& options) {
  std::vector<FoundBox> found = c.found;
  for (std::size_t i = 0; i < found.size(); ++i) found[i].id = static_cast<FoundId>(i);
  return assign(c.drawing, found, way, rootHypotheses(c.drawing, options), options);
}

std::vector<int> placesOf(const Hypothesis& hypothesis) {
  std::vector<int> places;
  for (const FoundId id : hypothesis.found_of) places.push_back(static_cast<int>(id));
  return places;
}

AssignmentOptions plainOptions() {
  AssignmentOptions options;
  options.hypotheses = 100000;
  options.scale_sigma = 1e-9;
  options.turn_sigma = 1e-9;
  options.disorder = 1.5;
  return options;
}

/// The weight of one assignment where nothing is common to the drawing: a sum over the pairs.
double plainWeight(const Case& c, const AssignmentOptions& o, const std::vector<int>& found_of) {
  Vec2 low(1e9, 1e9);
  Vec2 high = -low;
  for (const Building& building : c.drawing.buildings) {
    for (const Vec2& corner : building.footprint()) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
  }
  const Vec2 size = high - low + Vec2(40.0, 40.0);
  const double undrawn = std::log(o.undrawn * static_cast<double>(c.drawing.buildings.size()) /
                                  (size.x() * size.y())) -
                         2.0 * std::log(60.0);
  const auto normal = [](double off, double variance) {
    return -0.5 * (off * off / variance + std::log(2.0 * kPi * variance));
  };
  const double s = c.drawing.uncertainty.position * c.drawing.uncertainty.position;
  const double floor = 0.1 * 0.1 + 0.3 * 0.3;
  double weight = 0.0;
  for (std::size_t i = 0; i < found_of.size(); ++i) {
    if (found_of[i] < 0) continue;
    const Rectangle drawn = c.drawing.buildings[i].box();
    const Rectangle found = c.found[static_cast<std::size_t>(found_of[i])].box.rectangle();
    // Centre and half size are independent; the walls are their sum and difference (slope 2).
    weight += normal(found.centre.x() - drawn.centre.x(), s + floor / 2.0) +
              normal((found.width - drawn.width) / 2.0, s / 4.0 + floor / 2.0) +
              normal(found.centre.y() - drawn.centre.y(), s + floor / 2.0) +
              normal((found.depth - drawn.depth) / 2.0, s / 4.0 + floor / 2.0) -
              2.0 * std::log(2.0) - undrawn + std::log((1.0 - o.phantom) / o.phantom);
    for (std::size_t j = 0; j < i; ++j) {
      if (found_of[j] < 0) continue;
      const Vec2 other = c.found[static_cast<std::size_t>(found_of[j])].box.rectangle().centre;
      const Vec2 drawn_way = c.drawing.buildings[j].box().centre - drawn.centre;
      if (drawn_way.dot(other - found.centre) < 0.0) weight -= o.disorder;
    }
  }
  return weight;
}

double plainBest(const Case& c, const AssignmentOptions& o, std::vector<int>& found_of,
                 std::size_t next) {
  if (next == found_of.size()) return plainWeight(c, o, found_of);
  double best = plainBest(c, o, found_of, next + 1);
  for (int f = 0; f < static_cast<int>(c.found.size()); ++f) {
    if (std::find(found_of.begin(), found_of.end(), f) != found_of.end()) continue;
    found_of[next] = f;
    best = std::max(best, plainBest(c, o, found_of, next + 1));
    found_of[next] = -1;
  }
  return best;
}

TEST(Assign, IsTheBestOfAllAssignments) {
  RandomStream random(21);
  const AssignmentOptions options = plainOptions();
  for (int round = 0; round < 30; ++round) {
    const Case c = randomCase(random, 4, 12.0);
    const auto hypotheses = assignAlone(c, {}, options);
    std::vector<int> found_of(4, -1);
    const double best = plainBest(c, options, found_of, 0);
    EXPECT_NEAR(hypotheses.front().log_weight, best, 1e-3);
    EXPECT_NEAR(plainWeight(c, options, placesOf(hypotheses.front())), best, 1e-3);
  }
}

/// A quarter drawn so badly that houses lie near their neighbours' places, most seen from one side.
Case crowdedCase(RandomStream& random) {
  Case c;
  c.drawing.start = Pose2{};
  c.drawing.uncertainty = {3.0, 3.0};
  while (c.found.size() < 24) {
    const Rectangle truth{{random.uniform(0.0, 150.0), random.uniform(-50.0, 50.0)},
                          random.uniform(8.0, 16.0),
                          random.uniform(7.0, 12.0),
                          0.0};
    const bool is_free = std::ranges::all_of(c.found, [&](const FoundBox& other) {
      return (other.box.rectangle().centre - truth.centre).norm() > 14.0;
    });
    if (!is_free) continue;
    Rectangle drawn = truth;
    drawn.centre = 1.1 * truth.centre + Vec2(random.normal(0.0, 6.0), random.normal(0.0, 6.0));
    drawn.width += random.normal(0.0, 1.5);
    drawn.depth += random.normal(0.0, 1.5);
    Building building;
    building.id = std::to_string(c.found.size());
    building.shape = drawn;
    if (random.uniform() < 0.9) c.drawing.buildings.push_back(building);
    c.found.push_back(foundAt(truth));
    for (Eigen::Index wall = 0; wall < 4; ++wall) {
      if (random.uniform() < 0.6) c.found.back().covariance(wall, wall) = 225.0;
    }
  }
  return c;
}

TEST(Assign, AHundredHypothesesFindMostOfWhatThousandsFind) {
  RandomStream random(29);
  AssignmentOptions many;
  many.hypotheses = 3000;
  double short_by = 0.0;
  for (int round = 0; round < 30; ++round) {
    const Case c = crowdedCase(random);
    short_by += assignAlone(c, {}, many).front().log_weight -
                assignAlone(c, {}, AssignmentOptions{}).front().log_weight;
  }
  EXPECT_LT(short_by, 40.0) << "nats; 67 with the hundred best alone";
}

TEST(Assign, LearnsTheScaleOfTheWholeDrawing) {
  RandomStream random(22);
  Case c = randomCase(random, 6, 1.0);
  for (FoundBox& found : c.found) {
    Rectangle box = found.box.rectangle();
    box.centre *= 1.1;
    box.width *= 1.1;
    found = foundAt(box);
  }
  const auto hypotheses = assignAlone(c, {}, AssignmentOptions{});
  for (int i = 0; i < 6; ++i)
    EXPECT_EQ(placesOf(hypotheses.front())[static_cast<std::size_t>(i)], i);
  EXPECT_NEAR(hypotheses.front().motion.scale(), 1.1, 0.02);
}

TEST(Assign, KeepsTheSideOfTheWay) {
  // Drawn 60 m too far along the street each, the left one ahead, the right one behind.
  Case c;
  c.drawing.uncertainty = {33.0, 33.0};
  for (const double side : {1.0, -1.0}) {
    Building building;
    building.id = side > 0.0 ? "left" : "right";
    building.shape = Rectangle{{100.0 + 30.0 * side, 20.0 * side}, 50.0, 15.0, 0.0};
    c.drawing.buildings.push_back(building);
    c.found.push_back(foundAt({{100.0 - 30.0 * side, 20.0 * side}, 50.0, 15.0, 0.0}));
  }
  const std::vector<Pose2> way = {{0.0, 0.0, 0.0}, {100.0, 0.0, 0.0}, {200.0, 0.0, 0.0}};
  const auto labels = [&](std::span<const Pose2> driven) {
    return placesOf(assignAlone(c, driven, AssignmentOptions{}).front());
  };
  EXPECT_EQ(labels(way), (std::vector<int>{0, 1}));
  EXPECT_EQ(labels({}), (std::vector<int>{1, 0}));
}

TEST(Assign, LeavesOutWhatIsNotThere) {
  RandomStream random(23);
  Case c = randomCase(random, 4, 1.0);
  c.found.erase(c.found.begin() + 1);
  const auto best = assignAlone(c, {}, AssignmentOptions{}).front();
  EXPECT_EQ(placesOf(best), (std::vector<int>{0, -1, 1, 2}));
  c.found.clear();
  EXPECT_EQ(assignAlone(c, {}, AssignmentOptions{}).size(), 1u);
}

TEST(Assign, NamesAreKeptInWhateverOrderTheFoundOnesAre) {
  RandomStream random(25);
  Case c = randomCase(random, 4, 1.0);
  std::vector<FoundBox> found = c.found;
  for (std::size_t i = 0; i < found.size(); ++i) found[i].id = static_cast<FoundId>(10 + 3 * i);
  const auto roots = rootHypotheses(c.drawing, {});
  const auto before = assign(c.drawing, found, {}, roots, {}).front().found_of;
  std::reverse(found.begin(), found.end());
  EXPECT_EQ(assign(c.drawing, found, {}, roots, {}).front().found_of, before);
  EXPECT_EQ(before[2], static_cast<FoundId>(16));
}

TEST(Assignment, TakesWhatTheDrawingStatesOfItsScaleAndTurn) {
  const AssignmentOptions usual = withStated({}, {});
  EXPECT_EQ(usual.scale_sigma, kUsualScaleSigma);
  EXPECT_EQ(usual.turn_sigma, kUsualTurnSigma);
  EXPECT_FALSE(usual.free_turn);
  Map drawing;
  drawing.start = Pose2{};
  const auto sigma = [&](const WholeUncertainty& whole, Eigen::Index k) {
    const auto roots = rootHypotheses(drawing, withStated(whole, {}));
    EXPECT_EQ(roots.size(), 1U);
    return std::sqrt(roots.front().motion.covariance(k, k));
  };
  EXPECT_NEAR(sigma({0.02, {}}, 0), 0.02, 1e-9);
  EXPECT_NEAR(sigma({{}, 0.03}, 1), 0.03, 1e-9);
  // To scale and true, and yet what is found may be compared.
  EXPECT_LT(sigma({0.0, 0.0}, 0), 1e-3);
  EXPECT_GT(sigma({0.0, 0.0}, 0), 0.0);
  EXPECT_LT(sigma({0.0, 0.0}, 1), 1e-3);
  EXPECT_TRUE(withStated({{}, toRadians(20.0)}, {}).free_turn);
}

TEST(Assignment, AStartThatIsNotSureLetsTheDrawingLieElsewhere) {
  Map drawing;
  drawing.start = Pose2{};
  drawing.uncertainty = {1.0, 1.0};
  const auto sigma_of = [&](const StartUncertainty& start) {
    return rootHypotheses(drawing, withStart(start, {})).front().motion.sigmaAt(Vec2::Zero());
  };
  const double exact = sigma_of({});
  EXPECT_NEAR(sigma_of({3.0, 0.0}), std::hypot(exact, 3.0 * std::sqrt(2.0)), 1e-9);
  const auto turned = rootHypotheses(drawing, withStart({0.0, toRadians(5.0)}, {}));
  ASSERT_EQ(turned.size(), 1U);
  EXPECT_NEAR(std::sqrt(turned.front().motion.covariance(1, 1)),
              std::hypot(kUsualTurnSigma, toRadians(5.0)), 1e-9);
  EXPECT_GT(rootHypotheses(drawing, withStart({0.0, toRadians(20.0)}, {})).size(), 1U)
      << "one Gaussian does not reach so far";
}

Case oneHouse(double width, double depth, double sigma) {
  Case c;
  c.drawing.start = Pose2{};
  c.drawing.uncertainty = {sigma, sigma};
  Building building;
  building.id = "A";
  building.shape = Rectangle{{40.0, 20.0}, width, depth, 0.0};
  c.drawing.buildings = {building};
  return c;
}

TEST(Assignment, ACarIsNoHouse) {
  Case c = oneHouse(10.0, 9.0, 3.0);
  const auto takes = [&](double width, double depth) {
    c.found = {foundAt({{40.0, 20.0}, width, depth, 0.0})};
    const std::vector<Hypothesis> all = assignAlone(c, {}, AssignmentOptions{});
    return std::ranges::any_of(all, [](const Hypothesis& h) { return placesOf(h)[0] == 0; });
  };
  EXPECT_TRUE(takes(10.0, 9.0));
  EXPECT_TRUE(takes(6.0, 5.0));
  EXPECT_TRUE(takes(18.0, 9.0));
  EXPECT_FALSE(takes(4.3, 1.8));
  c.drawing.uncertainty.size = 10.0;
  EXPECT_FALSE(takes(4.3, 1.8)) << "however wrong sizes are stated to be";
}

TEST(Assignment, WhatMayNotExistNeedsABetterMatch) {
  Case c = oneHouse(20.0, 15.0, 2.0);
  const auto share = [&](double off, bool may_not_exist) {
    c.drawing.buildings.front().may_not_exist = may_not_exist;
    c.found = {foundAt({{40.0 + off, 20.0}, 20.0, 15.0, 0.0})};
    double with = 0.0;
    for (const Hypothesis& hypothesis : assignAlone(c, {}, plainOptions())) {
      if (placesOf(hypothesis)[0] == 0) with += hypothesis.weight;
    }
    return with;
  };
  for (const double off : {0.0, 4.0, 6.0, 8.0}) {
    EXPECT_LT(share(off, true), share(off, false)) << off;
    // The odds are those of its being there: 98 to 2, or even.
    const double odds = share(off, false) / (1.0 - share(off, false));
    const double uncertain = share(off, true) / (1.0 - share(off, true));
    EXPECT_NEAR(odds / uncertain, 49.0, 0.5) << off;
  }
  EXPECT_GT(share(0.0, true), 0.9);
}

}  // namespace
}  // namespace handmap
