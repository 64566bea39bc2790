#include "core/classification/clusters.h"

#include <algorithm>
#include <utility>

#include "core/base/random.h"

namespace handmap {

namespace {

constexpr int kRounds = 8;
/// More do not move the centres by much, and cost time.
constexpr std::size_t kMaxSamples = 6000;

std::vector<Eigen::Index> shuffledRows(const std::vector<bool>& positive, bool wanted,
                                       RandomStream& random) {
  std::vector<Eigen::Index> rows;
  for (std::size_t i = 0; i < positive.size(); ++i) {
    if (positive[i] == wanted) rows.push_back(static_cast<Eigen::Index>(i));
  }
  for (std::size_t i = rows.size(); i > 1; --i) {
    std::swap(rows[i - 1], rows[static_cast<std::size_t>(random.index(static_cast<int>(i)))]);
  }
  return rows;
}

/// Lloyd's algorithm from the first `count` samples.
SampleMatrix kMeans(const SampleMatrix& samples, Eigen::Index count, const std::stop_token& stop) {
  SampleMatrix centres = samples.topRows(count);
  for (int round = 0; round < kRounds && !stop.stop_requested(); ++round) {
    const Eigen::VectorXf squares = centres.rowwise().squaredNorm();
    SampleMatrix distances = -2.0F * samples * centres.transpose();
    distances.rowwise() += squares.transpose();
    SampleMatrix sums = SampleMatrix::Zero(count, samples.cols());
    Eigen::VectorXf members = Eigen::VectorXf::Zero(count);
    for (Eigen::Index i = 0; i < samples.rows(); ++i) {
      Eigen::Index nearest = 0;
      distances.row(i).minCoeff(&nearest);
      sums.row(nearest) += samples.row(i);
      members[nearest] += 1.0F;
    }
    for (Eigen::Index k = 0; k < count; ++k) {
      if (members[k] > 0.0F) centres.row(k) = sums.row(k) / members[k];
    }
  }
  // Four places after the point are plenty, and keep the file of a model small.
  constexpr float kSteps = 1e4F;
  return (centres * kSteps).array().round() / kSteps + 0.0F;  // no negative zeros
}

}  // namespace

SampleMatrix clusterCentres(const SampleMatrix& samples, const std::vector<bool>& positive,
                            int count, std::uint64_t seed, const std::stop_token& stop) {
  SampleMatrix centres(0, samples.cols());
  for (const bool wanted : {true, false}) {
    RandomStream random(seed, wanted ? 1U : 0U);
    std::vector<Eigen::Index> rows = shuffledRows(positive, wanted, random);
    rows.resize(std::min(rows.size(), kMaxSamples));
    const auto size = std::min<Eigen::Index>(count / 2, static_cast<Eigen::Index>(rows.size()));
    const SampleMatrix found = kMeans(samples(rows, Eigen::all), size, stop);
    centres.conservativeResize(centres.rows() + size, Eigen::NoChange);
    centres.bottomRows(size) = found;
  }
  return centres;
}

}  // namespace handmap
