// Images of two cameras that know nothing of each other, put into pairs by their times.
#pragma once

#include <array>
#include <deque>
#include <optional>

#include <opencv2/core/mat.hpp>

namespace handmap {

enum class Side { Left, Right };

struct TimedImage {
  double time_s = 0.0;
  cv::Mat image;
};

class PairMatcher {
 public:
  /// A robot that turns by 30°/s has turned by 0.3° in that time: some pixels of disparity.
  static constexpr double kTolerance_s = 0.010;

  struct Pair {
    double time_s;  ///< of the left image
    cv::Mat left;
    cv::Mat right;
  };

  /// `right_delay_s`: the right image of a pair comes so much later.
  explicit PairMatcher(double right_delay_s) : right_delay_s_(right_delay_s) {}

  /// A pair as soon as both are there. Each image is in one pair at most.
  std::optional<Pair> add(Side side, TimedImage image);

  long unmatched() const { return unmatched_; }  ///< images that found no other
  /// How much later the right image of the latest two neighbours was, less the delay that is known:
  /// what is to be set where pairs do not match.
  double offset_s() const { return offset_s_; }

 private:
  static constexpr std::size_t kMostWaiting = 4;

  double right_delay_s_;
  std::array<std::deque<TimedImage>, 2> waiting_;  ///< by Side; the right ones less the delay
  long unmatched_ = 0;
  double offset_s_ = 0.0;
};

}  // namespace handmap
