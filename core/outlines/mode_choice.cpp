#include "core/outlines/mode_choice.h"

#include <algorithm>
#include <numeric>

#include "core/outlines/constants.h"

namespace handmap {

using namespace outlines;

namespace {

class Choice {
 public:
  Choice(const std::vector<std::vector<double>>& worth, const std::vector<ModeConflict>& conflicts)
      : worth_(worth), of_(worth.size()), chosen_(worth.size(), kNoMode) {
    for (const ModeConflict& conflict : conflicts) {
      of_[conflict.building].push_back(conflict);
      of_[conflict.other].push_back(
          {conflict.other, conflict.other_mode, conflict.building, conflict.mode, conflict.cost});
    }
  }

  std::vector<int> solve() {
    begin();
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t i = 0; i < worth_.size(); ++i) changed |= improveAround(i);
    }
    return chosen_;
  }

 private:
  int modesOf(std::size_t i) const { return static_cast<int>(worth_[i].size()); }

  /// Of building i as it is chosen, with its conflicts; `except`: without those with that one.
  double worthOf(std::size_t i, std::size_t except) const {
    if (chosen_[i] == kNoMode) return 0.0;
    const auto mode = static_cast<std::size_t>(chosen_[i]);
    double worth = worth_[i][mode];
    for (const ModeConflict& conflict : of_[i]) {
      if (conflict.mode != mode || conflict.other == except) continue;
      if (chosen_[conflict.other] == static_cast<int>(conflict.other_mode)) worth -= conflict.cost;
    }
    return worth;
  }
  double worthOf(std::size_t i) const { return worthOf(i, i); }

  void begin() {
    std::vector<std::size_t> order(worth_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto best = [&](std::size_t i) {
      return worth_[i].empty() ? 0.0 : *std::ranges::max_element(worth_[i]);
    };
    std::ranges::stable_sort(order, std::ranges::greater{}, best);
    for (const std::size_t i : order) chooseBest(i);
  }

  void chooseBest(std::size_t i) {
    int best = kNoMode;
    double most = 0.0;
    for (int mode = 0; mode < modesOf(i); ++mode) {
      chosen_[i] = mode;
      const double worth = worthOf(i);
      if (worth <= most) continue;
      most = worth;
      best = mode;
    }
    chosen_[i] = best;
  }

  /// Building i alone and with each that it is in conflict with.
  bool improveAround(std::size_t i) {
    std::vector<std::size_t> others;
    for (const ModeConflict& conflict : of_[i]) others.push_back(conflict.other);
    std::ranges::sort(others);
    others.erase(std::unique(others.begin(), others.end()), others.end());
    bool changed = false;
    for (const std::size_t other : others) {
      const int mode_before = chosen_[i];
      const int other_before = chosen_[other];
      const double before = worthOf(i) + worthOf(other, i);
      int best = mode_before;
      int other_best = other_before;
      double most = before + kLeastWorth;
      for (int mode = kNoMode; mode < modesOf(i); ++mode) {
        for (int other_mode = kNoMode; other_mode < modesOf(other); ++other_mode) {
          chosen_[i] = mode;
          chosen_[other] = other_mode;
          const double worth = worthOf(i) + worthOf(other, i);
          if (worth <= most) continue;
          most = worth;
          best = mode;
          other_best = other_mode;
        }
      }
      chosen_[i] = best;
      chosen_[other] = other_best;
      changed |= best != mode_before || other_best != other_before;
    }
    return changed;
  }

  const std::vector<std::vector<double>>& worth_;
  std::vector<std::vector<ModeConflict>> of_;  ///< by building, told from its side
  std::vector<int> chosen_;
};

}  // namespace

std::vector<int> chooseModes(const std::vector<std::vector<double>>& worth,
                             const std::vector<ModeConflict>& conflicts) {
  return Choice(worth, conflicts).solve();
}

}  // namespace handmap
