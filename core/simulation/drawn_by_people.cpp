#include "core/simulation/drawn_by_people.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/simulation/possible_drawing.h"

namespace handmap {

namespace {

constexpr std::uint32_t kMissing = 42;         // a stream of its own
constexpr std::size_t kMostCorrelated = 1000;  // of all with all: a second

double sizeOf(const Building& building) {
  return std::sqrt(std::abs(signedArea(building.footprint())));
}

/// Mean of ln size.
double middleSize(const Map& map) {
  double middle = 0.0;
  const auto count = static_cast<double>(map.buildings.size());
  for (const Building& building : map.buildings) middle += std::log(sizeOf(building)) / count;
  return middle;
}

class PeoplesHand {
 public:
  PeoplesHand(const Map& truth, const PeopleErrors& errors)
      : truth_(truth), errors_(errors), middle_(middleSize(truth)) {
    const double extent = extentOf(truth);
    sigma_m_ = errors.position * extent;
    const auto count = static_cast<Eigen::Index>(truth.buildings.size());
    Eigen::MatrixXd covariance(count, count);
    for (Eigen::Index i = 0; i < count; ++i) {
      places_.push_back(truth.buildings[static_cast<std::size_t>(i)].box().centre);
    }
    for (Eigen::Index i = 0; i < count; ++i) {
      for (Eigen::Index j = 0; j < count; ++j) {
        const Vec2 apart =
            places_[static_cast<std::size_t>(i)] - places_[static_cast<std::size_t>(j)];
        covariance(i, j) =
            sigma_m_ * sigma_m_ * std::exp(-apart.norm() / std::max(1e-9, errors.reach * extent));
      }
    }
    // So that two buildings at one place can be told apart.
    covariance.diagonal().array() *= 1.0 + 1e-9;
    information_ = covariance.inverse();
  }

  Building draw(std::size_t i, const std::vector<Building>& drawn, RandomStream& random) const {
    Rectangle box = truth_.buildings[i].box();
    const double log_size = std::log(sizeOf(truth_.buildings[i]));
    const double drawn_size = std::exp(middle_ + errors_.size_slope * (log_size - middle_) +
                                       random.normal(0.0, errors_.size_sigma));
    const double stretch = drawn_size / std::sqrt(box.width * box.depth);
    box.width *= stretch;
    box.depth *= stretch;
    box.heading = normalizedAngle(box.heading + random.normal(0.0, errors_.turn));
    box.centre = places_[i] + offGiven(i, drawn, random);
    Building building = truth_.buildings[i];
    building.shape = box;
    return building;
  }

 private:
  /// Of the normal distribution of one error where the others are known.
  Vec2 offGiven(std::size_t i, const std::vector<Building>& drawn, RandomStream& random) const {
    const auto row = static_cast<Eigen::Index>(i);
    const double own = information_(row, row);
    if (!(own > 0.0) || !std::isfinite(own)) return Vec2::Zero();  // all at one place
    Vec2 mean = Vec2::Zero();
    for (std::size_t j = 0; j < drawn.size(); ++j) {
      if (j == i) continue;
      const double weight = -information_(row, static_cast<Eigen::Index>(j)) / own;
      mean += weight * (drawn[j].box().centre - places_[j]);
    }
    const double sigma = 1.0 / std::sqrt(own);
    const double x = random.normal(mean.x(), sigma);
    return {x, random.normal(mean.y(), sigma)};
  }

  const Map& truth_;
  PeopleErrors errors_;
  double middle_;  ///< of ln true size
  double sigma_m_ = 0.0;
  std::vector<Vec2> places_;
  Eigen::MatrixXd information_;
};

}  // namespace

double extentOf(const Map& map) {
  Vec2 middle = Vec2::Zero();
  const auto count = static_cast<double>(std::max<std::size_t>(1, map.buildings.size()));
  for (const Building& building : map.buildings) middle += building.box().centre / count;
  double square = 0.0;
  for (const Building& building : map.buildings) {
    square += (building.box().centre - middle).squaredNorm();
  }
  return std::sqrt(square / (2.0 * count));
}

Uncertainty uncertaintyOfPeople(const Map& drawing, const PeopleErrors& errors) {
  const double middle = middleSize(drawing);
  double square = 0.0;
  for (const Building& building : drawing.buildings) {
    const double size = sizeOf(building);
    const double pull = (errors.size_slope - 1.0) * (std::log(size) - middle);
    square += size * size * (errors.size_sigma * errors.size_sigma + pull * pull);
  }
  const auto count = static_cast<double>(std::max<std::size_t>(1, drawing.buildings.size()));
  return {errors.position * extentOf(drawing), std::sqrt(square / count)};
}

Map drawnByPeople(const Map& truth, const PeopleErrors& errors, std::uint64_t seed,
                  Keeping keeping) {
  if (truth.buildings.size() > kMostCorrelated) {
    throwBadInput(phrase("buildings"), "", std::to_string(truth.buildings.size()),
                  phrase("at most {}", kMostCorrelated));
  }
  const PeoplesHand hand(truth, errors);
  const auto redraw = [&](std::size_t i, const std::vector<Building>& drawn, RandomStream& random) {
    return hand.draw(i, drawn, random);
  };
  Map drawn = possibleDrawing(truth, redraw, seed, keeping);
  drawn.uncertainty = uncertaintyOfPeople(truth, errors);
  RandomStream random(seed, 0, 0, kMissing);
  std::size_t left = drawn.buildings.size();
  std::erase_if(drawn.buildings, [&](const Building& building) {
    const bool missed = random.uniform() < errors.missing && left > PeopleErrors::kLeast;
    if (missed && !building.fixed) --left;
    return missed && !building.fixed;
  });
  return drawn;
}

}  // namespace handmap
