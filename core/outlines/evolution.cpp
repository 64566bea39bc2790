#include "core/outlines/evolution.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>

#include "core/outlines/constants.h"

namespace handmap {

using namespace outlines;

namespace {

/// Names as in the tutorial, table 1 and figure 6.
class Strategy {
 public:
  Strategy(const Eigen::VectorXd& start, double step)
      : n_(static_cast<double>(start.size())),
        mean_(start),
        sigma_(step),
        covariance_(Eigen::MatrixXd::Identity(start.size(), start.size())),
        path_(Eigen::VectorXd::Zero(start.size())),
        step_path_(Eigen::VectorXd::Zero(start.size())) {
    double sum = 0.0;
    for (int i = 0; i < kParents; ++i) {
      weights_[static_cast<std::size_t>(i)] = std::log(kParents + 0.5) - std::log(i + 1.0);
      sum += weights_[static_cast<std::size_t>(i)];
    }
    double squares = 0.0;
    for (double& weight : weights_) {
      weight /= sum;
      squares += weight * weight;
    }
    mu_eff_ = 1.0 / squares;
    c_c_ = (4.0 + mu_eff_ / n_) / (n_ + 4.0 + 2.0 * mu_eff_ / n_);
    c_sigma_ = (mu_eff_ + 2.0) / (n_ + mu_eff_ + 5.0);
    c_1_ = 2.0 / (std::pow(n_ + 1.3, 2) + mu_eff_);
    c_mu_ = std::min(1.0 - c_1_,
                     2.0 * (mu_eff_ - 2.0 + 1.0 / mu_eff_) / (std::pow(n_ + 2.0, 2) + mu_eff_));
    d_sigma_ = 1.0 + 2.0 * std::max(0.0, std::sqrt((mu_eff_ - 1.0) / (n_ + 1.0)) - 1.0) + c_sigma_;
    chi_n_ = std::sqrt(n_) * (1.0 - 1.0 / (4.0 * n_) + 1.0 / (21.0 * n_ * n_));
    decompose();
  }

  /// From the mean, in units of the step.
  Eigen::VectorXd sample(RandomStream& random) const {
    Eigen::VectorXd z(mean_.size());
    for (double& value : z) value = random.normal();
    return axes_ * widths_.cwiseProduct(z);
  }
  Eigen::VectorXd at(const Eigen::VectorXd& y) const { return mean_ + sigma_ * y; }
  double widest() const { return sigma_ * widths_.maxCoeff(); }

  /// `best`: the samples of this generation, the best first.
  void adapt(const std::vector<Eigen::VectorXd>& best, int generation) {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(mean_.size());
    Eigen::MatrixXd rank_mu = Eigen::MatrixXd::Zero(mean_.size(), mean_.size());
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      y += weights_[i] * best[i];
      rank_mu += weights_[i] * best[i] * best[i].transpose();
    }
    mean_ += sigma_ * y;
    const Eigen::VectorXd white = axes_ * (axes_.transpose() * y).cwiseQuotient(widths_);
    step_path_ =
        (1.0 - c_sigma_) * step_path_ + std::sqrt(c_sigma_ * (2.0 - c_sigma_) * mu_eff_) * white;
    const double settled = std::sqrt(1.0 - std::pow(1.0 - c_sigma_, 2.0 * (generation + 1)));
    const bool steady = step_path_.norm() / settled < (1.4 + 2.0 / (n_ + 1.0)) * chi_n_;
    path_ *= 1.0 - c_c_;
    if (steady) path_ += std::sqrt(c_c_ * (2.0 - c_c_) * mu_eff_) * y;
    const double missing = steady ? 0.0 : c_c_ * (2.0 - c_c_);
    covariance_ = (1.0 - c_1_ - c_mu_ + c_1_ * missing) * covariance_ +
                  c_1_ * path_ * path_.transpose() + c_mu_ * rank_mu;
    sigma_ *= std::exp(c_sigma_ / d_sigma_ * (step_path_.norm() / chi_n_ - 1.0));
    decompose();
  }

 private:
  void decompose() {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance_);
    axes_ = solver.eigenvectors();
    widths_ = solver.eigenvalues().cwiseMax(kLeastEigenvalue).cwiseSqrt();
  }

  double n_;
  Eigen::VectorXd mean_;
  double sigma_;
  Eigen::MatrixXd covariance_;
  Eigen::VectorXd path_;       ///< p_c
  Eigen::VectorXd step_path_;  ///< p_σ
  std::array<double, kParents> weights_{};
  double mu_eff_ = 0.0;
  double c_c_ = 0.0;
  double c_sigma_ = 0.0;
  double c_1_ = 0.0;
  double c_mu_ = 0.0;
  double d_sigma_ = 0.0;
  double chi_n_ = 0.0;
  Eigen::MatrixXd axes_;
  Eigen::VectorXd widths_;
};

}  // namespace

Evolved evolve(const std::function<double(const Eigen::VectorXd&)>& value,
               const Eigen::VectorXd& start, const Evolution& evolution, RandomStream& random,
               const std::stop_token& stop) {
  Evolved best{start, value(start)};
  Strategy strategy(start, evolution.step);
  struct Tried {
    Eigen::VectorXd y;
    double value;
  };
  for (int generation = 0; generation < evolution.most_generations; ++generation) {
    std::vector<Tried> tried;
    for (int i = 0; i < kOffspring; ++i) {
      if (stop.stop_requested()) return best;
      Eigen::VectorXd y = strategy.sample(random);
      const Eigen::VectorXd parameters = strategy.at(y);
      const double now = value(parameters);
      if (now > best.value) best = {parameters, now};
      tried.push_back({std::move(y), now});
    }
    std::ranges::stable_sort(tried, std::ranges::greater{}, &Tried::value);
    std::vector<Eigen::VectorXd> parents;
    for (std::size_t i = 0; i < kParents; ++i) parents.push_back(std::move(tried[i].y));
    strategy.adapt(parents, generation);
    if (strategy.widest() < evolution.least_step) break;
  }
  return best;
}

}  // namespace handmap
