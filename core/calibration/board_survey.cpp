#include "core/calibration/board_survey.h"

#include <algorithm>
#include <cmath>

#include <opencv2/calib3d.hpp>

#include "core/geometry/pose2.h"

namespace handmap {

namespace {

// Shares of the image. The inner corners of a board that is held to an edge are a square and its
// white border away from it.
constexpr double kAtEdge = 0.15;
constexpr double kNear = 0.45;
constexpr double kFar = 0.3;
constexpr double kTurned = 0.3;  // rad: 17°, beyond doubt also for a focal length that is guessed

// Another view than one that was taken differs by one of these at least.
constexpr double kOtherPlace = 0.12;
constexpr double kOtherExtent = 1.25;
constexpr double kOtherTurn = 0.2;  // rad
constexpr double kOtherRoll = 0.3;  // rad

// A hand that holds still trembles by that much; what moves more is blurred, or not at the same
// place in two cameras that take their images some milliseconds apart.
constexpr double kTremble = 0.004;  // of the width of the image
constexpr double kStill_s = 0.3;

double lengthOf(const cv::Point2f& a, const cv::Point2f& b) { return cv::norm(a - b); }

}  // namespace

BoardPosture postureOf(const std::vector<cv::Point2f>& corners, const Board& board, cv::Size size) {
  const int columns = board.corners.width;
  const int rows = board.corners.height;
  std::vector<cv::Point3f> flat;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      flat.emplace_back(static_cast<float>(column), static_cast<float>(row), 0.0F);
    }
  }
  const double focal_px = std::max(size.width, size.height);  // that of a common lens
  const cv::Matx33d lens(focal_px, 0, size.width / 2.0, 0, focal_px, size.height / 2.0, 0, 0, 1);
  cv::Vec3d turned;
  cv::Vec3d place;
  cv::solvePnP(flat, corners, lens, cv::noArray(), turned, place, false, cv::SOLVEPNP_IPPE);
  cv::Matx33d rotation;
  cv::Rodrigues(turned, rotation);

  BoardPosture posture;
  cv::Point2d sum;
  for (const cv::Point2f& corner : corners) sum += cv::Point2d(corner);
  sum *= 1.0 / static_cast<double>(corners.size());
  posture.centre = {sum.x / size.width, sum.y / size.height};
  const auto at = [&](int column, int row) {
    return corners[static_cast<std::size_t>(row * columns + column)];
  };
  const double along = std::max(lengthOf(at(0, 0), at(columns - 1, 0)),
                                lengthOf(at(0, rows - 1), at(columns - 1, rows - 1)));
  const double across = std::max(lengthOf(at(0, 0), at(0, rows - 1)),
                                 lengthOf(at(columns - 1, 0), at(columns - 1, rows - 1)));
  posture.extent = std::max(along, across) / std::max(size.width, size.height);
  const double away = rotation(2, 2) < 0.0 ? -1.0 : 1.0;  // the normal that leads away
  posture.turn = std::atan2(-away * rotation(0, 2), away * rotation(2, 2));
  posture.tilt = std::atan2(-away * rotation(1, 2), away * rotation(2, 2));
  posture.roll = std::atan(rotation(1, 0) / rotation(0, 0));
  return posture;
}

std::optional<BoardVerdict> BoardSurvey::judge(double time_s, const std::vector<cv::Point2f>& left,
                                               const std::vector<cv::Point2f>& right) {
  if (left.empty() || right.empty()) {
    stood_at_.clear();
    return left.empty() && right.empty() ? BoardVerdict::NotSeen : BoardVerdict::InOneImage;
  }
  const bool still = isStill(time_s, left);
  if (isKnown(postureOf(left, board_, size_)) || taken() >= kMost) return BoardVerdict::Known;
  if (!still) return BoardVerdict::Moving;
  return std::nullopt;
}

bool BoardSurvey::isStill(double time_s, const std::vector<cv::Point2f>& corners) {
  double most = 0.0;
  for (std::size_t i = 0; i < stood_at_.size(); ++i) {
    most = std::max(most, lengthOf(corners[i], stood_at_[i]));
  }
  if (stood_at_.empty() || most > kTremble * size_.width) {
    stood_at_ = corners;
    still_since_s_ = time_s;
  }
  return time_s - still_since_s_ >= kStill_s;
}

bool BoardSurvey::isKnown(const BoardPosture& posture) const {
  return std::any_of(postures_.begin(), postures_.end(), [&](const BoardPosture& taken) {
    const cv::Point2d moved = taken.centre - posture.centre;
    const double rolled = std::abs(taken.roll - posture.roll);
    return std::hypot(moved.x, moved.y) < kOtherPlace &&
           std::abs(std::log(taken.extent / posture.extent)) < std::log(kOtherExtent) &&
           std::abs(taken.turn - posture.turn) < kOtherTurn &&
           std::abs(taken.tilt - posture.tilt) < kOtherTurn &&
           std::min(rolled, kPi - rolled) < kOtherRoll;
  });
}

/// The edges count in either image: what is near is never at the left edge of the left one and
/// whole in the right one.
void BoardSurvey::take(const BoardView& view) {
  const BoardPosture posture = postureOf(view.left, board_, size_);
  postures_.push_back(posture);
  double left = 1.0;
  double right = 0.0;
  double top = 1.0;
  double bottom = 0.0;
  for (const auto* corners : {&view.left, &view.right}) {
    for (const cv::Point2f& corner : *corners) {
      left = std::min(left, static_cast<double>(corner.x) / size_.width);
      right = std::max(right, static_cast<double>(corner.x) / size_.width);
      top = std::min(top, static_cast<double>(corner.y) / size_.height);
      bottom = std::max(bottom, static_cast<double>(corner.y) / size_.height);
    }
  }
  const auto meet = [this](bool met, BoardNeed need) {
    if (met) met_.push_back(need);
  };
  meet(left <= kAtEdge, BoardNeed::AtLeft);
  meet(right >= 1.0 - kAtEdge, BoardNeed::AtRight);
  meet(top <= kAtEdge, BoardNeed::AtTop);
  meet(bottom >= 1.0 - kAtEdge, BoardNeed::AtBottom);
  meet(posture.extent >= kNear, BoardNeed::Near);
  meet(posture.extent <= kFar, BoardNeed::Far);
  meet(posture.turn >= kTurned, BoardNeed::LeftNearer);
  meet(posture.turn <= -kTurned, BoardNeed::RightNearer);
  meet(posture.tilt >= kTurned, BoardNeed::TopNearer);
  meet(posture.tilt <= -kTurned, BoardNeed::BottomNearer);
}

std::vector<BoardNeed> BoardSurvey::missing() const {
  std::vector<BoardNeed> missing;
  std::copy_if(
      kAllBoardNeeds.begin(), kAllBoardNeeds.end(), std::back_inserter(missing),
      [this](BoardNeed need) { return std::find(met_.begin(), met_.end(), need) == met_.end(); });
  return missing;
}

}  // namespace handmap
