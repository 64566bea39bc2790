// Features of mean 0 and variance 1.
#pragma once

#include <Eigen/Core>

#include "core/classification/sample_matrix.h"

namespace handmap {

struct Standardization {
  Eigen::RowVectorXf mean;
  Eigen::RowVectorXf scale;  ///< 1 / standard deviation; 0 for what is always the same

  static Standardization of(const SampleMatrix& samples);
  SampleMatrix operator()(const SampleMatrix& samples) const {
    return (samples.rowwise() - mean) * scale.asDiagonal();
  }
};

inline Standardization Standardization::of(const SampleMatrix& samples) {
  Standardization result;
  result.mean = samples.colwise().mean();
  const auto rows = static_cast<float>(samples.rows());
  const Eigen::RowVectorXf deviation =
      ((samples.rowwise() - result.mean).colwise().squaredNorm() / rows).cwiseSqrt();
  result.scale = (deviation.array() > 1e-6F).select(deviation.cwiseInverse(), 0.0F);
  return result;
}

}  // namespace handmap
