#pragma once

#include <Eigen/Core>

namespace handmap {

/// Feature vectors, one sample a row.
using SampleMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace handmap
