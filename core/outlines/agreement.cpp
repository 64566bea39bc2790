#include "core/outlines/agreement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/base/gaussian.h"
#include "core/estimation/buildings/constants.h"
#include "core/geometry/pose_covariance.h"
#include "core/map/certainty.h"
#include "core/outlines/constants.h"

namespace handmap {

using namespace outlines;

namespace {

/// How the map lies: shift and turn of the whole about the start, and how far the buildings that
/// are not drawn right are off together: a shift, and the log of a scale about the start.
using Lie = Eigen::Matrix<double, 6, 1>;
using LieMatrix = Eigen::Matrix<double, 6, 6>;

/// How far a side that was seen lies from where it is drawn, outwards.
struct SideError {
  using Slope = Eigen::Matrix<double, 1, 6>;
  Slope slope;         ///< by a Lie; the last three for a building that is drawn wrong
  double error = 0.0;  ///< metres
  double sigma = 0.0;  ///< of the fitted side
};

/// A building with its sides that were seen.
struct Compared {
  std::vector<SideError> sides;
  double drawn_sigma = 0.0;  ///< of a side, as the drawing says
  Vec2 place = Vec2::Zero();
  double place_sigma = 0.0;
  bool fixed = false;  ///< right whatever was seen
  double right = 0.5;
};

double farthest(const Polygon& outline, const Vec2& direction) {
  double most = outline.front().dot(direction);
  for (const Vec2& corner : outline) most = std::max(most, corner.dot(direction));
  return most;
}

Compared compared(const Building& drawn, const Building& fitted, const Uncertainty& uncertainty,
                  const Vec2& origin) {
  Compared building;
  building.fixed = drawn.fixed;
  // Fitting cannot tell a finer drawing from a right one.
  building.drawn_sigma =
      std::max(std::hypot(uncertainty.position, 0.5 * uncertainty.size), buildings::kFloor_m);
  const Rectangle box = drawn.box();
  building.place = box.centre;
  building.place_sigma = uncertainty.position;
  const double fitted_heading = fitted.box().heading;
  const Sides sides = sidesOf(fitted);
  const Polygon outline = drawn.footprint();
  const Polygon fitted_outline = fitted.footprint();
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const Vec2 normal = unitVector(box.heading + static_cast<double>(k) * kPi / 2.0);
    const SideEstimate& side = sides[sideFacing(fitted_heading, normal)];
    if (!side.seen || side.sigma <= 0.0) continue;
    const Vec2 middle = box.centre + 0.5 * (k % 2 == 0 ? box.width : box.depth) * normal;
    const Vec2 arm = middle - origin;
    SideError::Slope slope;
    slope << normal.x(), normal.y(), normal.dot(perpendicular(arm)), normal.x(), normal.y(),
        normal.dot(arm);
    building.sides.push_back({slope, farthest(fitted_outline, normal) - farthest(outline, normal),
                              std::max(side.sigma, buildings::kFloor_m)});
  }
  return building;
}

/// How far what is drawn off goes together, metres: a share of the drawing's extent.
double reachOf(const std::vector<Compared>& buildings) {
  const auto count = static_cast<double>(buildings.size());
  Vec2 middle = Vec2::Zero();
  for (const Compared& building : buildings) middle += building.place / count;
  double squares = 0.0;
  for (const Compared& building : buildings) squares += (building.place - middle).squaredNorm();
  return std::max(kTogetherReach * std::sqrt(0.5 * squares / count), buildings::kFloor_m);
}

double logNormal(double error, double sigma) {
  return -0.5 * std::pow(error / sigma, 2) - std::log(sigma);
}

double logSum(double a, double b) {
  const double most = std::max(a, b);
  return most + std::log(std::exp(a - most) + std::exp(b - most));
}

/// Density of the sides of a building that was fitted well, or to something else.
class Fits {
 public:
  void add(double error, double sigma) {
    well_ += logNormal(error, sigma);
    ill_ += logNormal(error, std::hypot(sigma, kMisfit_m));
  }
  double log() const { return logSum(well_, ill_); }

 private:
  double well_ = std::log(1.0 - kMisfitted);
  double ill_ = std::log(kMisfitted);
};

class Mixture {
 public:
  Mixture(std::vector<Compared> buildings, const Lie& sigma)
      : buildings_(std::move(buildings)),
        prior_(sigma.array().square().inverse().matrix().asDiagonal()) {}

  /// `start_is_known`: as well as nothing but buildings that are right can tell better, unless all
  /// refute it. Returns whether they do.
  bool solve(bool start_is_known, double way_turn) {
    way_turn_ = way_turn;
    Mixture none = *this;
    none.takeNoneAsRight();
    iterate();
    // As if all were right: a way that lies askew on the drawing has none of them where it is
    // drawn.
    Mixture askew = *this;
    for (Compared& building : askew.buildings_) building.right = 1.0;
    for (int round = 0; round < kMostRounds; ++round) askew.maximize();
    askew.share_ = 0.5;
    askew.iterate();
    if (askew.log_density_ > log_density_) *this = std::move(askew);
    // A few agree by chance, with one start or another.
    if (logEvidence() - none.logEvidence() > kTogether) return false;
    *this = std::move(none);
    if (!start_is_known) {
      covariance_ += covarianceTogether();
      return false;
    }
    Mixture free = *this;
    free.prior_.topLeftCorner<3, 3>().setZero();
    free.takeNoneAsRight();
    free.covariance_ += free.covarianceTogether();
    if (free.refutesStart(way_turn)) {
      *this = std::move(free);
      way_turn_ = 0.0;
      return true;
    }
    lie_.head<3>().setZero();
    covariance_ = prior_.inverse();
    if (way_turn > 0.0 && countOfSeen() >= kLeastToRefute) turnWay(free);
    return false;
  }

  double wayTurn() const { return way_turn_; }
  const Lie& lie() const { return lie_; }
  const LieMatrix& covariance() const { return covariance_; }
  /// 0 where nothing was seen.
  double shareSeen() const {
    const auto seen = countOfSeen();
    return seen > 0 ? together() / static_cast<double>(seen) : 0.0;
  }
  const std::vector<Compared>& buildings() const { return buildings_; }

 private:
  void iterate() {
    for (int round = 0; round < kMostRounds; ++round) {
      const double before = log_density_;
      expect();
      if (round > 0 && log_density_ - before < kSettled) break;
      maximize();
    }
  }

  /// None is drawn right but what is fixed: all tell how the whole lies, each as well as it is
  /// drawn.
  void takeNoneAsRight() {
    for (Compared& building : buildings_) building.right = building.fixed ? 1.0 : 0.0;
    for (int round = 0; round < kMostRounds; ++round) maximize();
    share_ = 0.0;
    expect();
  }
  /// Of all lies and shares, not of the best alone (Laplace; a beta integral).
  double logEvidence() const {
    double log = log_density_ + 0.5 * std::log((covariance_ * prior_).determinant());
    if (share_ <= 0.0) return log;
    const double right = together();
    const auto wrong = static_cast<double>(countOfSeen()) - right;
    log -= right * std::log(share_) + wrong * std::log(1.0 - share_);
    return log + std::lgamma(right + 1.0) + std::lgamma(wrong + 1.0) -
           std::lgamma(right + wrong + 2.0);
  }
  /// Whether it lies where an exact start, and a way that may be turned about it, cannot have it.
  bool refutesStart(double way_turn) const {
    Eigen::Matrix3d variance = covariance_.topLeftCorner<3, 3>();
    variance(2, 2) += way_turn * way_turn;
    const Eigen::Vector3d off = lie_.head<3>();
    return countOfSeen() >= kLeastToRefute &&
           off.dot(variance.inverse() * off) > kRareSquareOfThree;
  }

  /// The start is where it is, and the way may be turned about it: by as much as it says itself,
  /// and all buildings together of a drawing that may be turned too.
  void turnWay(const Mixture& free) {
    Eigen::Matrix3d variance = free.covariance_.topLeftCorner<3, 3>();
    variance(2, 2) += 1.0 / prior_(2, 2);
    const Eigen::Matrix3d told = variance.inverse();
    const double information = told(2, 2) + 1.0 / (way_turn_ * way_turn_);
    lie_[2] = told.row(2).dot(free.lie_.head<3>()) / information;
    way_turn_ = 1.0 / std::sqrt(information);
  }

  /// What the lie is less sure by, since what stands near each other is drawn off together.
  LieMatrix covarianceTogether() const {
    using Pull = Eigen::Matrix<double, 6, 2>;
    const double reach = reachOf(buildings_);
    std::vector<std::pair<Vec2, Pull>> pulls;  // of the lie, by a place drawn off by its σ
    for (const Compared& building : buildings_) {
      if (building.sides.empty()) continue;
      Pull pull = Pull::Zero();
      for (const SideError& side : building.sides)
        pull += side.slope.transpose() * side.slope.head<2>() /
                std::pow(wrongSigmaOf(building, side), 2);
      pulls.emplace_back(building.place, (1.0 - building.right) * worse_ * building.place_sigma *
                                             covariance_ * pull);
    }
    LieMatrix sum = LieMatrix::Zero();
    for (std::size_t a = 0; a < pulls.size(); ++a) {
      for (std::size_t b = 0; b < pulls.size(); ++b) {
        if (a == b) continue;
        const double apart = (pulls[a].first - pulls[b].first).norm();
        sum += std::exp(-apart / reach) * pulls[a].second * pulls[b].second.transpose();
      }
    }
    return sum;
  }

  std::ptrdiff_t countOfSeen() const {
    return std::ranges::count_if(buildings_, [](const Compared& b) { return !b.sides.empty(); });
  }

  double together() const {
    double sum = 0.0;
    for (const Compared& building : buildings_) {
      if (!building.sides.empty()) sum += building.right;
    }
    return sum;
  }

  double wrongErrorOf(const SideError& side) const { return side.error - side.slope.dot(lie_); }
  double errorOf(const SideError& side) const {
    return side.error - side.slope.head<3>().dot(lie_.head<3>());
  }

  /// Fitting cannot tell what is drawn a little off from what is right.
  double wrongSigmaOf(const Compared& building, const SideError& side) const {
    return std::hypot(side.sigma, std::max(worse_ * building.drawn_sigma, kMisfit_m));
  }

  void expect() {
    log_density_ = -0.5 * lie_.dot(prior_ * lie_);
    for (Compared& building : buildings_) {
      if (building.sides.empty()) {
        building.right = building.fixed ? 1.0 : share_;
        continue;
      }
      Fits as_right;
      Fits as_wrong;
      for (const SideError& side : building.sides) {
        as_right.add(errorOf(side), side.sigma);
        as_wrong.add(wrongErrorOf(side), wrongSigmaOf(building, side));
      }
      if (building.fixed) {
        building.right = 1.0;
        log_density_ += as_right.log();
        continue;
      }
      const double right = std::log(share_) + as_right.log();
      const double wrong = std::log(1.0 - share_) + as_wrong.log();
      log_density_ += logSum(right, wrong);
      building.right = 1.0 / (1.0 + std::exp(wrong - right));
    }
  }

  void maximize() {
    double right = 0.0;
    double count = 0.0;
    double squares = kStatedSides;
    double sides = kStatedSides;
    LieMatrix information = prior_;
    Lie pull = Lie::Zero();
    for (const Compared& building : buildings_) {
      if (building.sides.empty()) continue;
      right += building.right;
      count += 1.0;
      for (const SideError& side : building.sides) {
        const double wrong_error = wrongErrorOf(side);
        const double drawn = wrongSigmaOf(building, side);
        squares += (1.0 - building.right) * std::pow(wrong_error / building.drawn_sigma, 2);
        sides += 1.0 - building.right;
        // Robust where a building that is right was fitted to something else.
        const double off = std::pow(errorOf(side) / side.sigma, 2);
        const auto add = [&](const SideError::Slope& slope, double weight) {
          information += weight * slope.transpose() * slope;
          pull += weight * side.error * slope.transpose();
        };
        SideError::Slope of_right = side.slope;
        of_right.tail<3>().setZero();
        add(of_right, building.right / (side.sigma * side.sigma * (1.0 + off / 9.0)));
        add(side.slope, (1.0 - building.right) / (drawn * drawn));
      }
    }
    share_ = (right + 1.0) / (count + 2.0);  // a uniform prior
    worse_ = std::sqrt(squares / sides);
    lie_ = information.ldlt().solve(pull);
    covariance_ = information.inverse();
  }

  std::vector<Compared> buildings_;
  LieMatrix prior_;     ///< information
  double share_ = 0.5;  ///< of buildings that are drawn right
  double worse_ = 1.0;  ///< the others are off by so many times what the drawing says
  Lie lie_ = Lie::Zero();
  LieMatrix covariance_ = LieMatrix::Zero();  ///< of it
  double log_density_ = 0.0;
  double way_turn_ = 0.0;  ///< that nothing tells yet, one σ
};

}  // namespace

Agreement agreementOf(const Map& drawing, const Map& fitted, double start_m, double start_turn,
                      double way_turn) {
  const Vec2 origin = drawing.start ? drawing.start->position() : Vec2::Zero();
  std::vector<Compared> buildings;
  for (std::size_t b = 0; b < drawing.buildings.size(); ++b) {
    const Building& drawn = drawing.buildings[b];
    buildings.push_back(compared(drawn, fitted.buildings[b], drawing.uncertaintyOf(drawn), origin));
  }
  const double together = std::max(drawing.shiftSigma(), buildings::kFloor_m);
  const bool start_is_known = !drawing.start_uncertainty;
  if (!start_is_known) {
    // Its turn and that of the way are one.
    start_turn = std::hypot(start_turn, way_turn);
    way_turn = 0.0;
  }
  Lie sigma;
  // Of a start that is said to be off the scale would take a part.
  const double scale = start_is_known ? drawing.whole.scale.value_or(kUsualScaleSigma) : 0.0;
  sigma << start_m, start_m, start_turn, together, together, std::max(scale, kLeastShare);
  Mixture mixture(std::move(buildings), sigma);
  Agreement agreement;
  agreement.refutes_start = mixture.solve(start_is_known, way_turn);
  const Lie& motion = mixture.lie();
  const Pose2 about{origin.x(), origin.y(), 0.0};
  agreement.motion =
      Pose2{origin.x() + motion[0], origin.y() + motion[1], motion[2]} * inverse(about);
  agreement.covariance = mixture.covariance().topLeftCorner<3, 3>();
  agreement.way_turn = mixture.wayTurn();
  agreement.share = mixture.shareSeen();
  for (const Compared& building : mixture.buildings()) agreement.right.push_back(building.right);
  return agreement;
}

double Agreement::sigmaAt(const Vec2& from_start) const {
  return std::sqrt(0.5 * swungBy(from_start, covariance).topLeftCorner<2, 2>().trace());
}

}  // namespace handmap
