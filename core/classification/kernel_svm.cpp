#include "core/classification/kernel_svm.h"

#include <algorithm>
#include <utility>

#include <Eigen/Cholesky>
#include <opencv2/core.hpp>
#include <opencv2/ml.hpp>

namespace handmap {

namespace {

constexpr int kClusterRounds = 8;
constexpr int kMaxIterations = 50'000;
constexpr double kTolerance = 0.01;     // of the optimum of the plane
constexpr Eigen::Index kBlock = 128;    // samples at a time: their kernels stay in the cache
constexpr float kVectorRidge = 0.001F;  // vectors that lie close together

/// A view of the samples; OpenCV does not write to it.
cv::Mat1f viewOf(const SampleMatrix& samples) {
  return {static_cast<int>(samples.rows()), static_cast<int>(samples.cols()),
          const_cast<float*>(samples.data())};  // NOLINT(cppcoreguidelines-pro-type-const-cast)
}

std::vector<Eigen::Index> rowsOf(const std::vector<bool>& positive, bool wanted) {
  std::vector<Eigen::Index> rows;
  for (std::size_t i = 0; i < positive.size(); ++i) {
    if (positive[i] == wanted) rows.push_back(static_cast<Eigen::Index>(i));
  }
  return rows;
}

/// Those that k-means finds in each class by itself, half of them in either class; fewer where a
/// class has fewer samples.
SampleMatrix clusterCentres(const SampleMatrix& samples, const std::vector<bool>& positive,
                            const SvmOptions& options) {
  SampleMatrix centres(0, samples.cols());
  cv::setRNGSeed(static_cast<int>(options.seed));  // of this thread
  for (const bool wanted : {true, false}) {
    const SampleMatrix of_class = samples(rowsOf(positive, wanted), Eigen::all);
    const auto count = std::min<Eigen::Index>(options.vectors / 2, of_class.rows());
    cv::Mat labels;
    cv::Mat1f found;
    cv::kmeans(viewOf(of_class), static_cast<int>(count), labels,
               {cv::TermCriteria::MAX_ITER, kClusterRounds, 0.0}, 1, cv::KMEANS_PP_CENTERS, found);
    centres.conservativeResize(centres.rows() + count, Eigen::NoChange);
    centres.bottomRows(count) =
        Eigen::Map<const SampleMatrix>(found.ptr<float>(), count, samples.cols());
  }
  // Four places after the point are plenty, and keep the file of a model small.
  constexpr float kSteps = 1e4F;
  return (centres * kSteps).array().round() / kSteps + 0.0F;  // no negative zeros
}

/// Of a plane w·x + b that parts the classes.
struct Plane {
  Eigen::VectorXf weights;
  float bias;
};

Plane separatingPlane(const SampleMatrix& inputs, const std::vector<bool>& positive, double c) {
  // The machine says > 0 for the class with the lower number.
  cv::Mat1i classes(static_cast<int>(positive.size()), 1);
  for (int i = 0; i < classes.rows; ++i) classes(i) = positive[static_cast<std::size_t>(i)] ? 0 : 1;
  const auto all = static_cast<double>(positive.size());
  const auto positives = static_cast<double>(std::count(positive.begin(), positive.end(), true));
  const cv::Mat1d class_weights =
      (cv::Mat1d(2, 1) << 0.5 * all / positives, 0.5 * all / (all - positives));
  const auto svm = cv::ml::SVM::create();
  svm->setType(cv::ml::SVM::C_SVC);
  svm->setKernel(cv::ml::SVM::LINEAR);
  svm->setC(c);
  svm->setClassWeights(class_weights);
  svm->setTermCriteria(
      {cv::TermCriteria::MAX_ITER + cv::TermCriteria::EPS, kMaxIterations, kTolerance});
  svm->train(viewOf(inputs), cv::ml::ROW_SAMPLE, classes);

  // A linear machine has one support vector: the sum of all.
  const cv::Mat1f vectors = svm->getSupportVectors();
  cv::Mat1d alphas;
  cv::Mat1i used;
  const double rho = svm->getDecisionFunction(0, alphas, used);
  Plane plane{Eigen::VectorXf::Zero(inputs.cols()), static_cast<float>(-rho)};
  for (int i = 0; i < static_cast<int>(alphas.total()); ++i) {
    plane.weights += static_cast<float>(alphas(i)) *
                     Eigen::Map<const Eigen::VectorXf>(vectors[used(i)], plane.weights.size());
  }
  return plane;
}

}  // namespace

KernelSvm::KernelSvm(SampleMatrix vectors, Eigen::VectorXf weights, float bias, float gamma)
    : vectors_(std::move(vectors)),
      weights_(std::move(weights)),
      squares_(vectors_.rowwise().squaredNorm()),
      bias_(bias),
      gamma_(gamma) {}

SampleMatrix KernelSvm::kernel(const SampleMatrix& samples) const {
  // |x − v|² = |x|² + |v|² − 2 x·v: one matrix product for all.
  SampleMatrix result = 2.0F * gamma_ * samples * vectors_.transpose();
  result.colwise() -= gamma_ * samples.rowwise().squaredNorm();
  result.rowwise() -= gamma_ * squares_.transpose();
  result = result.array().min(0.0F).exp();
  return result;
}

KernelSvm KernelSvm::train(const SampleMatrix& samples, const std::vector<bool>& positive,
                           const SvmOptions& options) {
  KernelSvm svm(clusterCentres(samples, positive, options), {}, 0.0F,
                static_cast<float>(options.gamma / static_cast<double>(samples.cols())));
  // K = L Lᵀ; the inputs L⁻¹ k(x) have the scalar products of the kernel.
  Eigen::MatrixXf vectors = svm.kernel(svm.vectors_);
  vectors.diagonal().array() += kVectorRidge;
  const Eigen::LLT<Eigen::MatrixXf> root(vectors);
  const SampleMatrix inputs = root.matrixL().solve(svm.kernel(samples).transpose()).transpose();
  const Plane plane = separatingPlane(inputs, positive, options.c);
  svm.weights_ = root.matrixU().solve(plane.weights);
  svm.bias_ = plane.bias;
  return svm;
}

Eigen::VectorXf KernelSvm::decide(const SampleMatrix& samples) const {
  Eigen::VectorXf distances(samples.rows());
  for (Eigen::Index from = 0; from < samples.rows(); from += kBlock) {
    const Eigen::Index count = std::min(kBlock, samples.rows() - from);
    distances.segment(from, count) =
        (kernel(samples.middleRows(from, count)) * weights_).array() + bias_;
  }
  return distances;
}

}  // namespace handmap
