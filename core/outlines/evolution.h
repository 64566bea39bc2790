// The greatest value of a rugged function: covariance matrix adaptation (CMA-ES; Hansen, "The CMA
// Evolution Strategy: A Tutorial", 2016, arXiv 1604.00772), with the constants given there.
#pragma once

#include <functional>
#include <stop_token>

#include <Eigen/Core>

#include "core/base/random.h"

namespace handmap {

struct Evolution {
  double step = 1.0;         ///< of the first generation, one σ of each parameter
  double least_step = 0.01;  ///< it ends where no direction is searched wider
  int most_generations = 60;
};

struct Evolved {
  Eigen::VectorXd parameters;
  double value = 0.0;
};

/// The best of all that were tried, `start` among them. Steps of all parameters should matter
/// alike at first. The same random numbers give the same result. Comes back early where `stop` is
/// requested.
Evolved evolve(const std::function<double(const Eigen::VectorXd&)>& value,
               const Eigen::VectorXd& start, const Evolution& evolution, RandomStream& random,
               const std::stop_token& stop = {});

}  // namespace handmap
