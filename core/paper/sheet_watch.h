// A printed sheet that a camera looks at while somebody draws on it.
#pragma once

#include <vector>

#include "core/paper/trace.h"

namespace handmap {

enum class SheetSight {
  None,     ///< its four marks and its code are not all seen
  Covered,  ///< a hand lies over it
  Moving,   ///< since the image before
  Seen      ///< whole: what is drawn can be told
};

/// Follows the pen: what was found stays as it is while a hand is over it, and does not tremble
/// from image to image. A shape comes, changes or goes once it does so in images one after the
/// other.
class SheetWatch {
 public:
  /// Of any size, one channel or three.
  SheetSight look(const cv::Mat& image);

  /// Of the newest that was seen and looks otherwise than those before; with the shapes that are
  /// settled.
  const Trace& trace() const { return trace_; }
  /// Whether that is of the image that was looked at last.
  bool isNew() const { return is_new_; }
  /// Of each shape of the trace, for good.
  const std::vector<int>& numbers() const { return numbers_; }

 private:
  /// A shape, and what the newest images say otherwise.
  struct Watched {
    int number = 0;
    TracedShape shape;
    int seen = 0;     ///< images that agreed before it is settled
    int missing = 0;  ///< images in a row without it
    int other = 0;    ///< images in a row in which it is another
  };

  bool isStill(const Quad& grid, const cv::Size& image);
  bool looksAsBefore(const cv::Mat& page) const;
  bool isSettled() const;
  void settle(std::vector<TracedShape> shapes);

  std::optional<Quad> before_;
  std::vector<Watched> watched_;
  int next_ = 1;
  cv::Mat traced_;  ///< the page that was traced, small
  Trace trace_;
  bool is_new_ = false;
  std::vector<int> numbers_;
};

}  // namespace handmap
