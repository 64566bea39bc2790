// Student's t distribution about zero: errors that are now and then far larger than usual.
#pragma once

#include <vector>

namespace handmap {

struct HeavyTails {
  double sigma = 1.0;     ///< scale, that of the bulk
  double freedom = 60.0;  ///< 60: as good as normal; 3: one error in twenty is beyond 3.2 σ

  double logDensity(double error) const;
};

double normalLogDensity(double error, double sigma);

/// The most likely one. `errors` must not be empty.
HeavyTails fitHeavyTails(const std::vector<double>& errors);

/// Linear between the ordered values; 0 of none.
double quantile(std::vector<double> values, double share);

}  // namespace handmap
