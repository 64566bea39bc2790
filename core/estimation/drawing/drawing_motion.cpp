#include "core/estimation/drawing/drawing_motion.h"

namespace handmap {

void DrawingMotion::correct(const Eigen::RowVector4d& slope, double value, double variance) {
  const Eigen::Vector4d seen = covariance * slope.transpose();
  const Eigen::Vector4d gain = seen / (slope.dot(seen) + variance);
  mean += gain * (value - slope.dot(mean));
  covariance -= gain * seen.transpose();
}

}  // namespace handmap
