// A support vector machine with a Gaussian kernel and a fixed number of vectors.
//
// cv::ml::SVM (C-SVC) finds the plane, in the space that the kernels with the centres of clusters
// span (Nyström: Williams and Seeger, "Using the Nyström method to speed up kernel machines",
// 2000). With the kernel itself it keeps about every fourth training window as a support vector:
// thousands, and tens of milliseconds an image. Here the cost of a window is set beforehand.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/classification/sample_matrix.h"

namespace handmap {

struct SvmOptions {
  int vectors = 240;   ///< at most
  double gamma = 0.4;  ///< kernel exp(−γ |x − v|² / features); features are of variance 1
  double c = 3.0;      ///< C: weight of the loss against the norm
  std::uint64_t seed = 1;
};

class KernelSvm {
 public:
  /// `vectors` one a row; `gamma` as in exp(−γ |x − v|²).
  KernelSvm(SampleMatrix vectors, Eigen::VectorXf weights, float bias, float gamma);

  /// `positive[i]` is the class of row i; both are there. The classes weigh the same whatever their
  /// sizes. The time grows with the square of the number of samples: 6,000 take half a second.
  static KernelSvm train(const SampleMatrix& samples, const std::vector<bool>& positive,
                         const SvmOptions& options);

  /// Of every row the signed distance from the border, in margins; > 0 is the positive class.
  Eigen::VectorXf decide(const SampleMatrix& samples) const;

  const SampleMatrix& vectors() const { return vectors_; }
  const Eigen::VectorXf& weights() const { return weights_; }
  float bias() const { return bias_; }
  float gamma() const { return gamma_; }

 private:
  SampleMatrix kernel(const SampleMatrix& samples) const;

  SampleMatrix vectors_;
  Eigen::VectorXf weights_;
  Eigen::VectorXf squares_;  ///< |v|²
  float bias_;
  float gamma_;
};

}  // namespace handmap
