#include "core/classification/training.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/base/phrase.h"

namespace handmap {

namespace {

// Wider kernels see too little. Narrower ones and a greater C gain in cross-validation and lose in
// images of other cameras.
constexpr std::array kGammas = {0.2, 0.4};
constexpr std::array kCs = {1.0, 3.0};
// Windows of each class: to choose by, to train with, and to judge by, which bounds time and
// memory.
constexpr std::size_t kEnoughToChoose = 1500;
constexpr std::size_t kEnough = 3000;
constexpr std::size_t kEnoughOfTrees = 10'000;  // their time grows little faster than the number
constexpr std::size_t kMost = 30'000;
constexpr std::size_t kMostKept = 2'000'000;  // of both, in a set: less than a gigabyte

struct Samples {
  SampleMatrix features;
  std::vector<bool> buildings;
};

/// The fold that each sample is held out in: stretches of all of them, whatever their classes.
std::vector<int> plainStretches(const std::vector<bool>& buildings, int folds) {
  std::vector<int> fold_of(buildings.size());
  for (std::size_t i = 0; i < fold_of.size(); ++i) {
    fold_of[i] = static_cast<int>(i * static_cast<std::size_t>(folds) / fold_of.size());
  }
  return fold_of;
}

/// Stretches of each class by itself.
std::vector<int> stretchesOfClasses(const std::vector<bool>& buildings, int folds) {
  std::array<std::size_t, 2> size{};
  for (const bool building : buildings) ++size[building ? 1 : 0];
  std::array<std::size_t, 2> seen{};
  std::vector<int> fold_of;
  for (const bool building : buildings) {
    const std::size_t place = seen[building ? 1 : 0]++ * static_cast<std::size_t>(folds);
    fold_of.push_back(static_cast<int>(place / size[building ? 1 : 0]));
  }
  return fold_of;
}

/// Whether both classes are still there when any of the folds is held out.
bool canBeHeldOut(const std::vector<int>& fold_of, const std::vector<bool>& buildings) {
  std::array<std::set<int>, 2> folds;
  for (std::size_t i = 0; i < fold_of.size(); ++i) folds[buildings[i] ? 1 : 0].insert(fold_of[i]);
  return folds[0].size() > 1 && folds[1].size() > 1;
}

/// Evenly from each class, at most `count` of it: rare ones stay whole.
Samples thinned(const Eigen::Ref<const SampleMatrix>& features, const std::vector<bool>& buildings,
                std::size_t count) {
  std::array<std::size_t, 2> size{};
  for (const bool building : buildings) ++size[building ? 1 : 0];
  std::array<std::size_t, 2> seen{};
  std::vector<Eigen::Index> rows;
  Samples result;
  for (std::size_t i = 0; i < buildings.size(); ++i) {
    const std::size_t every = (size[buildings[i] ? 1 : 0] + count - 1) / count;
    if (seen[buildings[i] ? 1 : 0]++ % every != 0) continue;
    rows.push_back(static_cast<Eigen::Index>(i));
    result.buildings.push_back(buildings[i]);
  }
  result.features = features(rows, Eigen::all);
  return result;
}

/// Makes what parts the classes.
using Trainer = std::function<Separator(const Samples&)>;

Trainer machines(const SvmOptions& options) {
  return [=](const Samples& s) { return KernelSvm::train(s.features, s.buildings, options); };
}

Trainer trees(std::uint64_t seed) {
  return
      [=](const Samples& s) { return RandomTrees::train(s.features, s.buildings, {.seed = seed}); };
}

/// Samples with the fold that each is held out in.
class Folds {
 public:
  Folds(Samples samples, int folds)
      : samples_(std::move(samples)),
        count_(folds),
        fold_of_(plainStretches(samples_.buildings, folds)) {
    if (!canBeHeldOut(fold_of_, samples_.buildings)) {
      fold_of_ = stretchesOfClasses(samples_.buildings, folds);
    }
  }

  /// Of every sample the distance by what was trained without its fold, with at most `enough`
  /// of each class.
  Eigen::VectorXf heldOut(const Trainer& train, std::size_t enough, const std::stop_token& stop,
                          const std::function<void()>& fold_done) const {
    Eigen::VectorXf distances = Eigen::VectorXf::Zero(samples_.features.rows());
    for (int fold = 0; fold < count_ && !stop.stop_requested(); ++fold) {
      std::vector<Eigen::Index> in;
      std::vector<Eigen::Index> out;
      std::vector<bool> buildings;
      for (std::size_t i = 0; i < fold_of_.size(); ++i) {
        (fold_of_[i] == fold ? out : in).push_back(static_cast<Eigen::Index>(i));
        if (fold_of_[i] != fold) buildings.push_back(samples_.buildings[i]);
      }
      const Samples some = thinned(samples_.features(in, Eigen::all), buildings, enough);
      const SampleMatrix others = samples_.features(out, Eigen::all);
      distances(out) =
          std::visit([&](const auto& separator) { return separator.decide(others); }, train(some));
      fold_done();
    }
    return distances;
  }

  Confusion score(const Eigen::VectorXf& distances) const {
    Confusion confusion;
    for (std::size_t i = 0; i < fold_of_.size(); ++i) {
      confusion.add(samples_.buildings[i], distances[static_cast<Eigen::Index>(i)] > 0.0F);
    }
    return confusion;
  }

  const Samples& samples() const { return samples_; }

 private:
  Samples samples_;
  int count_;
  std::vector<int> fold_of_;
};

SvmOptions chooseOptions(const Folds& folds, SvmOptions options, const std::stop_token& stop,
                         const std::function<void()>& fold_done) {
  SvmOptions best = options;
  double best_accuracy = -1.0;
  for (const double gamma : kGammas) {
    for (const double c : kCs) {
      options.gamma = gamma;
      options.c = c;
      const double accuracy =
          folds.score(folds.heldOut(machines(options), kEnoughToChoose, stop, fold_done))
              .balancedAccuracy();
      if (accuracy <= best_accuracy) continue;
      best_accuracy = accuracy;
      best = options;
    }
  }
  return best;
}

void checkClasses(const std::vector<bool>& buildings, int folds) {
  const auto positives = std::count(buildings.begin(), buildings.end(), true);
  const auto others = static_cast<std::ptrdiff_t>(buildings.size()) - positives;
  for (const auto& [count, name] :
       {std::pair{positives, phrase("of buildings")}, {others, phrase("of others")}}) {
    if (count < folds) {
      throwBadInput(phrase("training images"), "", phrase("{} windows {}", count, name),
                    phrase("at least {}", folds));
    }
  }
}

}  // namespace

void TrainingSet::add(const cv::Mat& image, const std::vector<WindowLabel>& labels) {
  const SampleMatrix features = windowFeatures(image, features_);
  const WindowGrid grid = WindowGrid::of(image.size());
  if (buildings_.size() + labels.size() > kMostKept) {
    throwBadInput(phrase("training images"), "", phrase("more than {} windows", kMostKept),
                  phrase("fewer"));
  }
  for (int column = 0; column < grid.columns; ++column) {
    for (int row = 0; row < grid.rows; ++row) {
      const int window = row * grid.columns + column;
      const WindowLabel label = labels.at(static_cast<std::size_t>(window));
      if (label == WindowLabel::Unknown) continue;
      const float* values = features.row(window).data();
      values_.insert(values_.end(), values, values + features.cols());
      buildings_.push_back(label == WindowLabel::Building);
    }
  }
}

std::optional<BuildingClassifier> trainClassifier(const TrainingSet& set,
                                                  const TrainingOptions& options,
                                                  const std::stop_token& stop,
                                                  const std::function<void(double)>& progress) {
  checkClasses(set.buildings(), options.folds);
  Samples samples = thinned(set.samples(), set.buildings(), kMost);
  const Standardization standardization = Standardization::of(samples.features);
  samples.features = standardization(samples.features);
  const Folds folds(std::move(samples), options.folds);
  const std::vector<bool>& buildings = folds.samples().buildings;
  const std::size_t count = options.trees ? kEnoughOfTrees : kEnough;
  const Samples enough = thinned(folds.samples().features, buildings, count);
  // In the time of one fold while options are chosen.
  constexpr double kCost = static_cast<double>(kEnough * kEnough) /
                           static_cast<double>(kEnoughToChoose * kEnoughToChoose);
  const double choices = options.trees ? 0.0 : kGammas.size() * kCs.size();
  const double total = options.folds * (choices + kCost) + kCost;
  double done = 0.0;
  const auto tell = [&](double cost) {
    done += cost;
    if (progress) progress(done / total);
  };

  SvmOptions chosen{.vectors = options.vectors, .gamma = 0.0, .c = 0.0, .seed = options.seed};
  if (!options.trees) chosen = chooseOptions(folds, chosen, stop, [&] { tell(1.0); });
  const Trainer train = options.trees ? trees(options.seed) : machines(chosen);
  const Eigen::VectorXf distances = folds.heldOut(train, count, stop, [&] { tell(kCost); });
  if (stop.stop_requested()) return std::nullopt;
  Separator separator = train(enough);
  tell(kCost);
  const Logistic logistic = Logistic::fit(distances, buildings);
  Eigen::VectorXf probable(distances.size());
  for (Eigen::Index i = 0; i < distances.size(); ++i) probable[i] = logistic(distances[i]) - 0.5F;
  return BuildingClassifier(set.features(), standardization, std::move(separator), logistic,
                            {options.seed, chosen.gamma, chosen.c, folds.score(probable)});
}

void judge(const BuildingClassifier& classifier, const cv::Mat& image,
           const std::vector<WindowLabel>& labels, Confusion& confusion) {
  const cv::Mat1f probabilities = classifier.probabilities(image);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] == WindowLabel::Unknown) continue;
    confusion.add(labels[i] == WindowLabel::Building, probabilities.ptr<float>()[i] >= 0.5F);
  }
}

}  // namespace handmap
