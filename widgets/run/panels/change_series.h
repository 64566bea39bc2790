// How far each building has been moved, over the time of a run; of a bounded number of moments.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "core/map/map_changes.h"

namespace handmap {

class ChangeSeries {
 public:
  static constexpr std::size_t kMostMoments = 256;

  struct Moment {
    std::vector<float> moved_m;          ///< by building
    std::optional<double> mean_error_m;  ///< of those that the truth has
  };

  void setDrawing(Map drawing);
  void setTruth(const std::optional<TrueMiddles>& truth) { truth_ = truth; }
  /// Moments may come in any order; the same one again takes the place of the earlier.
  void add(double time_s, const Map& refined);
  void clear() { moments_.clear(); }

  const std::map<double, Moment>& moments() const { return moments_; }
  /// The buildings that moved farthest at any moment, the farthest first.
  std::vector<std::size_t> farthest(std::size_t most) const;
  const Map& drawing() const { return drawing_; }

 private:
  void thin();

  Map drawing_;
  std::vector<Vec2> drawn_;  ///< middles
  std::optional<TrueMiddles> truth_;
  std::map<double, Moment> moments_;
};

}  // namespace handmap
