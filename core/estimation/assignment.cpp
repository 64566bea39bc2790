#include "core/estimation/assignment.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "core/estimation/drawn_box.h"

namespace handmap {

namespace {

constexpr double kGate = 25.0;        // squared Mahalanobis distance beyond which nothing is tried
constexpr double kSurprising = 6.0;   // the same, beyond which a wall may not belong
constexpr double kFoundFloor = 0.3;   // metres, one σ, of what a box may be off its building
constexpr double kWidthRange = 60.0;  // metres over which sizes of undrawn buildings are spread
constexpr double kMostTurned = 4.0;   // half squares of the heading's error at most
constexpr double kFreeScale = 0.25;   // one σ
constexpr double kFan = toRadians(8.0);  // between the hypotheses of a free turn, and their σ
constexpr int kFanSteps = 5;             // to either side

/// The density of found buildings that no one drew, by metre and metre.
double undrawnDensity(const Map& drawing, const AssignmentOptions& options) {
  constexpr double kMargin = 20.0;
  std::vector<Vec2> corners;
  for (const Building& building : drawing.buildings) {
    for (const Vec2& corner : building.footprint()) corners.push_back(corner);
  }
  const Bounds bounds = boundsOf(corners);
  const Vec2 size = bounds.high - bounds.low + Vec2::Constant(2.0 * kMargin);
  return options.undrawn * static_cast<double>(drawing.buildings.size()) / (size.x() * size.y());
}

class Assigner {
 public:
  Assigner(const Map& drawing, std::span<const FoundBox> found, std::span<const Pose2> way,
           const AssignmentOptions& options)
      : drawing_(drawing),
        found_(found),
        way_(way),
        options_(options),
        log_undrawn_(std::log(undrawnDensity(drawing, options))),
        log_present_(std::log((1.0 - options.phantom) / options.phantom)) {
    for (const FoundBox& box : found) sides_.push_back(sideOf(box.box.rectangle().centre));
  }

  std::vector<Hypothesis> operator()() {
    std::vector<Hypothesis> beam = firstHypotheses();
    for (const std::size_t building : inOrder()) {
      std::vector<Hypothesis> next;
      const Vec2 centre = drawing_.buildings[building].box().centre;
      const int side = sideOf(beam.front().motion(centre));
      for (const Hypothesis& hypothesis : beam) {
        next.push_back(hypothesis);
        for (std::size_t f = 0; f < found_.size(); ++f) {
          if (!isTaken(hypothesis, f)) extend(hypothesis, building, f, side, next);
        }
      }
      const auto kept = std::min(next.size(), static_cast<std::size_t>(options_.hypotheses));
      std::stable_sort(next.begin(), next.end(), [](const Hypothesis& a, const Hypothesis& b) {
        return a.log_weight > b.log_weight;
      });
      next.resize(kept);
      beam = std::move(next);
    }
    double sum = 0.0;
    for (Hypothesis& h : beam) sum += h.weight = std::exp(h.log_weight - beam.front().log_weight);
    for (Hypothesis& h : beam) h.weight /= sum;
    return beam;
  }

 private:
  Vec2 origin() const { return drawing_.start ? drawing_.start->position() : Vec2::Zero(); }

  /// One, or a fan of them where the turn is free: each is Gaussian in (a, b).
  std::vector<Hypothesis> firstHypotheses() const {
    const double shift = options_.shift_share * drawing_.uncertainty.position;
    const double scale = options_.free_scale ? kFreeScale : options_.scale_sigma;
    const double turn = options_.free_turn ? kFan : options_.turn_sigma;
    const Eigen::Vector4d sigma(scale, turn, shift, shift);
    std::vector<Hypothesis> first;
    for (int step = 0; step <= (options_.free_turn ? 2 * kFanSteps : 0); ++step) {
      const double angle = kFan * (step % 2 == 0 ? step / 2 : -(step + 1) / 2);
      Hypothesis hypothesis;
      hypothesis.found_of.assign(drawing_.buildings.size(), Hypothesis::kNone);
      hypothesis.motion.origin = origin();
      hypothesis.motion.mean.head<2>() = unitVector(angle);
      Eigen::Matrix4d axes = Eigen::Matrix4d::Identity();
      axes.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(angle).toRotationMatrix();
      hypothesis.motion.covariance = axes * sigma.cwiseAbs2().asDiagonal() * axes.transpose();
      first.push_back(std::move(hypothesis));
    }
    return first;
  }

  /// The nearest to the start first: what is known of the whole drawing grows outwards.
  std::vector<std::size_t> inOrder() const {
    std::vector<std::size_t> order(drawing_.buildings.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<double> distance;
    for (const Building& building : drawing_.buildings) {
      distance.push_back((building.box().centre - origin()).norm());
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return distance[a] < distance[b]; });
    return order;
  }

  static bool isTaken(const Hypothesis& hypothesis, std::size_t found) {
    const auto& taken = hypothesis.found_of;
    return std::find(taken.begin(), taken.end(), static_cast<int>(found)) != taken.end();
  }

  /// Of the robot's way: 1 left, −1 right, 0 where there is none.
  int sideOf(const Vec2& point) const {
    const auto nearer = [&](const Pose2& a, const Pose2& b) {
      return (a.position() - point).squaredNorm() < (b.position() - point).squaredNorm();
    };
    const auto nearest = std::min_element(way_.begin(), way_.end(), nearer);
    if (nearest == way_.end()) return 0;
    return nearest->toOwn(point).y() > 0.0 ? 1 : -1;
  }

  double disorder(const Hypothesis& hypothesis, std::size_t building, std::size_t found) const {
    const Vec2 drawn_at = drawing_.buildings[building].box().centre;
    const Vec2 found_at = found_[found].box.rectangle().centre;
    double price = 0.0;
    for (std::size_t other = 0; other < hypothesis.found_of.size(); ++other) {
      const int its_found = hypothesis.found_of[other];
      if (its_found == Hypothesis::kNone) continue;
      const Vec2 drawn_way = drawing_.buildings[other].box().centre - drawn_at;
      const Vec2 found_way =
          found_[static_cast<std::size_t>(its_found)].box.rectangle().centre - found_at;
      if (drawn_way.dot(found_way) < 0.0) price += options_.disorder;
    }
    return price;
  }

  void extend(const Hypothesis& hypothesis, std::size_t building, std::size_t f, int side,
              std::vector<Hypothesis>& next) const {
    const Building& drawn = drawing_.buildings[building];
    const FoundBox found = found_[f].nearestTo(drawn.box().heading + hypothesis.motion.turn());
    const SeenWalls seen(found);
    if (seen.count == 0) return;
    const auto count = static_cast<std::size_t>(seen.count);
    DrawingMotion motion = hypothesis.motion;
    const double turn_price = compareHeading(drawn.box().heading, found, motion);
    const DrawnBox prior(drawn, drawing_.uncertaintyOf(drawn), motion, found.box);
    if (farWalls(prior, motion, found, seen) > 1) return;
    Match match = compare(prior, motion, found, {seen.index.data(), count});
    // A wall may be of something built on to the building.
    const bool surprising = match.distance > kSurprising;
    for (std::size_t out = 0; surprising && count > 1 && out < count; ++out) {
      std::array<int, 4> others{};
      std::remove_copy(seen.index.begin(), seen.index.begin() + seen.count, others.begin(),
                       seen.index[out]);
      Match without = compare(prior, motion, found, {others.data(), count - 1});
      without.log_likelihood += std::log(options_.built_on / kWidthRange);
      if (without.log_likelihood > match.log_likelihood) match = std::move(without);
    }
    if (match.distance > kGate) return;
    // The same walls of a building that no one drew: anywhere, of any size.
    const double undrawn =
        log_undrawn_ * (seen.count - seen.widths) / 2.0 - seen.widths * std::log(kWidthRange);

    const double side_price = sides_[f] == side ? 0.0 : options_.wrong_side;

    Hypothesis extended = hypothesis;
    extended.found_of[building] = static_cast<int>(f);
    extended.log_weight += match.log_likelihood - undrawn + log_present_ - turn_price -
                           disorder(hypothesis, building, f) - side_price;
    extended.motion = motion;
    extended.motion.mean += match.mean_change;
    extended.motion.covariance -= match.covariance_change;
    next.push_back(std::move(extended));
  }

  /// What a heading says of the drawing's turn: (a, b) lies along it. Returns its price; a building
  /// that stands as it likes says nothing.
  double compareHeading(double drawn, const FoundBox& found, DrawingMotion& motion) const {
    const Vec2 turn = unitVector(found.box.heading - drawn);
    const Eigen::RowVector4d slope(-turn.y(), turn.x(), 0.0, 0.0);
    const double sigma = motion.scale() * std::hypot(options_.heading_sigma, found.heading_sigma);
    const double error = slope.dot(motion.mean);
    const double predicted = sigma * sigma + (slope * motion.covariance).dot(slope);
    const double price = 0.5 * error * error / predicted;
    if (price > kMostTurned) return kMostTurned;
    motion.correct(slope, 0.0, sigma * sigma);
    return price;
  }

  /// How well some walls of a found box fit a drawn one, and what they say of the whole drawing.
  struct Match {
    double distance;  ///< squared Mahalanobis
    double log_likelihood;
    Eigen::Vector4d mean_change;
    Eigen::Matrix4d covariance_change;
  };

  /// Walls that are beyond the gate already each for itself.
  static int farWalls(const DrawnBox& prior, const DrawingMotion& motion, const FoundBox& found,
                      const SeenWalls& seen) {
    int far = 0;
    for (int i = 0; i < seen.count; ++i) {
      const int k = seen.index[static_cast<std::size_t>(i)];
      const auto wall = static_cast<std::size_t>(k);
      const double error = found.box.reach[wall] - prior.mean()[k];
      const auto slope = prior.slope().row(k);
      const double variance = prior.covariance()(k, k) + kFoundFloor * kFoundFloor +
                              found.reach_sigma[wall] * found.reach_sigma[wall] +
                              (slope * motion.covariance).dot(slope);
      far += static_cast<int>(error * error > kGate * variance);
    }
    return far;
  }

  static Match compare(const DrawnBox& prior, const DrawingMotion& motion, const FoundBox& found,
                       std::span<const int> walls) {
    const auto count = static_cast<Eigen::Index>(walls.size());
    Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::DontAlign, 4, 4> slope(count, 4);
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4, 1> error(count);
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 4> covariance(count, count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const int k = walls[static_cast<std::size_t>(i)];
      slope.row(i) = prior.slope().row(k);
      error[i] = found.box.reach[static_cast<std::size_t>(k)] - prior.mean()[k];
      for (Eigen::Index j = 0; j < count; ++j) {
        covariance(i, j) = prior.covariance()(k, walls[static_cast<std::size_t>(j)]);
      }
      const double sigma = found.reach_sigma[static_cast<std::size_t>(k)];
      covariance(i, i) += sigma * sigma + kFoundFloor * kFoundFloor;
    }
    covariance += slope * motion.covariance * slope.transpose();
    const Eigen::LLT<decltype(covariance)> factor(covariance);
    const double distance = error.dot(factor.solve(error));
    const double log_determinant = 2.0 * factor.matrixLLT().diagonal().array().log().sum() +
                                   static_cast<double>(count) * std::log(2.0 * kPi);
    const auto seen_by_motion = (slope * motion.covariance).eval();
    const auto gain = factor.solve(seen_by_motion).transpose().eval();
    return {distance, -0.5 * (distance + log_determinant), gain * error, gain * seen_by_motion};
  }

  const Map& drawing_;
  std::span<const FoundBox> found_;
  std::span<const Pose2> way_;
  const AssignmentOptions& options_;
  std::vector<int> sides_;  ///< of the found buildings
  double log_undrawn_;
  double log_present_;
};

}  // namespace

void DrawingMotion::correct(const Eigen::RowVector4d& slope, double value, double variance) {
  const Eigen::Vector4d seen = covariance * slope.transpose();
  const Eigen::Vector4d gain = seen / (slope.dot(seen) + variance);
  mean += gain * (value - slope.dot(mean));
  covariance -= gain * seen.transpose();
}

std::vector<Hypothesis> assign(const Map& drawing, std::span<const FoundBox> found,
                               std::span<const Pose2> way, const AssignmentOptions& options) {
  return Assigner(drawing, found, way, options)();
}

}  // namespace handmap
