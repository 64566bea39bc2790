// A support vector machine with a Gaussian kernel and a fixed number of vectors.
//
// Trained in the primal with the squared hinge loss (Chapelle, "Training a support vector machine
// in the primal", 2007) over a basis of chosen vectors (Keerthi, Chapelle and DeCoste, "Building
// support vector machines with reduced classifier complexity", 2006). The usual dual solution keeps
// about every fourth training window as a support vector: thousands, and tens of milliseconds an
// image. Here the cost of a window is set beforehand, and training takes in all windows there are.
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include <Eigen/Core>

#include "core/classification/sample_matrix.h"

namespace handmap {

struct SvmOptions {
  int vectors = 240;     ///< at most
  double gamma = 0.4;    ///< kernel exp(−γ |x − v|² / features); features are of variance 1
  double lambda = 1e-5;  ///< weight of the norm against the mean loss
  std::uint64_t seed = 1;
};

class KernelSvm {
 public:
  /// `vectors` one a row; `gamma` as in exp(−γ |x − v|²).
  KernelSvm(SampleMatrix vectors, Eigen::VectorXf weights, float bias, float gamma);

  /// `positive[i]` is the class of row i; both are there. The classes weigh the same whatever their
  /// sizes. Once `stop` is requested it returns soon, with something of no use.
  static KernelSvm train(const SampleMatrix& samples, const std::vector<bool>& positive,
                         const SvmOptions& options, const std::stop_token& stop = {});

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
