// Which views of a checkerboard a stereo camera has, and which it still needs: the lenses are told
// by boards at the edges of the images, the focal length by tilted ones, the baseline by near and
// far ones. A state machine without clock, camera or thread.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/calibration/board.h"

namespace handmap {

/// Where the board is to be, as one sees it in the images; *Nearer*: that side of it is turned to
/// the camera.
enum class BoardNeed {
  AtLeft,
  AtRight,
  AtTop,
  AtBottom,
  Near,
  Far,
  LeftNearer,
  RightNearer,
  TopNearer,
  BottomNearer
};
inline constexpr std::array kAllBoardNeeds = {
    BoardNeed::AtLeft,    BoardNeed::AtRight,     BoardNeed::AtTop,      BoardNeed::AtBottom,
    BoardNeed::Near,      BoardNeed::Far,         BoardNeed::LeftNearer, BoardNeed::RightNearer,
    BoardNeed::TopNearer, BoardNeed::BottomNearer};

enum class BoardVerdict {
  NotSeen,
  InOneImage,  ///< not whole in the other
  Moving,
  Known,    ///< one like it was taken
  Blurred,  ///< still, but not sharp
  Taken
};

/// How a board lies before a camera whose focal length is not known yet.
struct BoardPosture {
  cv::Point2d centre;   ///< shares of the image
  double extent = 0.0;  ///< its longer side, as a share of the image
  double turn = 0.0;    ///< radians, positive: its left side is nearer
  double tilt = 0.0;    ///< radians, positive: its top is nearer
  double roll = 0.0;    ///< radians in the image, between -π/2 and π/2
};
BoardPosture postureOf(const std::vector<cv::Point2f>& corners, const Board& board, cv::Size size);

class BoardSurvey {
 public:
  static constexpr int kEnough = 15;  ///< pairs; OpenCV's own advice begins at ten
  static constexpr int kMost = 60;

  BoardSurvey(Board board, cv::Size size) : board_(board), size_(size) {}

  /// What both images show at a moment; empty corners: not the whole board. nullopt: it stands
  /// still, and there is none like it yet: worth a closer look.
  std::optional<BoardVerdict> judge(double time_s, const std::vector<cv::Point2f>& left,
                                    const std::vector<cv::Point2f>& right);
  /// This view is used.
  void take(const BoardView& view);

  int taken() const { return static_cast<int>(postures_.size()); }
  std::vector<BoardNeed> missing() const;
  bool isEnough() const { return taken() >= kEnough && missing().empty(); }

 private:
  bool isStill(double time_s, const std::vector<cv::Point2f>& corners);
  bool isKnown(const BoardPosture& posture) const;

  Board board_;
  cv::Size size_;
  std::vector<cv::Point2f> stood_at_;
  double still_since_s_ = 0.0;
  std::vector<BoardPosture> postures_;
  std::vector<BoardNeed> met_;
};

}  // namespace handmap
