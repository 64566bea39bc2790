#include "core/calibration/stereo_calibrator.h"

#include <algorithm>
#include <cmath>

#include <opencv2/calib3d.hpp>

#include "core/base/error.h"
#include "core/base/median.h"
#include "core/base/phrase.h"
#include "core/geometry/pose2.h"

namespace handmap {

namespace {

constexpr double kMaxError_px = 1.0;
constexpr double kMaxFocalSigma = 0.02;
constexpr double kMinTurn = 0.26;  // rad: 15°
constexpr double kOutlier = 3.0;   // times the median error of the pairs
constexpr double kOutlier_px = 0.5;
constexpr int kFlags = cv::CALIB_FIX_K3;  // few images tell it, and it is wild beyond their corners

using Corners = std::vector<std::vector<cv::Point2f>>;

/// The corners of all views, in the form that OpenCV takes.
struct Points {
  std::vector<std::vector<cv::Point3f>> board;
  Corners left;
  Corners right;
};

Points pointsOf(const BoardImages& images, const Board& board) {
  std::vector<cv::Point3f> corners;
  for (int row = 0; row < board.corners.height; ++row) {
    for (int column = 0; column < board.corners.width; ++column) {
      corners.emplace_back(static_cast<float>(column * board.square_m),
                           static_cast<float>(row * board.square_m), 0.0F);
    }
  }
  Points points;
  for (const BoardView& view : images.views) {
    points.board.push_back(corners);
    points.left.push_back(view.left);
    points.right.push_back(view.right);
  }
  return points;
}

void requirePairs(const BoardImages& images, const std::string& source) {
  if (images.views.size() >= kLeastPairs) return;
  throw Error(
      ErrorCode::BadInput,
      phrase("{}: found {} pairs that show the whole board, expected at least {}{}", source,
             images.views.size(), kLeastPairs,
             images.refused.empty()
                 ? ""
                 : phrase("; the first refused, {}: {}", images.refused.front().name,
                          images.refused.front().reason)),
      phrase("take 15 to 30 pairs, the board near and far, tilted and turned, in all corners; is "
             "the number of inner corners right?"));
}

double rms(const cv::Mat& errors) {
  return std::sqrt(errors.dot(errors) / static_cast<double>(errors.total()));
}

/// One camera alone. The board's turn and the focal length's uncertainty tell whether the images
/// say enough of it.
struct SingleCamera {
  cv::Mat matrix;
  cv::Mat distortion;
  double focal_sigma = 0.0;
  double turn = 0.0;
};

SingleCamera calibrateSingle(const Points& points, const Corners& corners, cv::Size size) {
  SingleCamera camera;
  std::vector<cv::Vec3d> turns;
  std::vector<cv::Vec3d> shifts;
  cv::Mat sigmas;
  cv::calibrateCamera(points.board, corners, size, camera.matrix, camera.distortion, turns, shifts,
                      sigmas, cv::noArray(), cv::noArray(), kFlags);
  camera.focal_sigma = sigmas.at<double>(0) / camera.matrix.at<double>(0, 0);
  std::vector<cv::Vec3d> normals;
  for (const cv::Vec3d& turn : turns) {
    cv::Matx33d rotation;
    cv::Rodrigues(turn, rotation);
    normals.emplace_back(rotation(0, 2), rotation(1, 2), rotation(2, 2));
  }
  for (const cv::Vec3d& a : normals) {
    for (const cv::Vec3d& b : normals) {
      camera.turn = std::max(camera.turn, std::acos(std::clamp(a.dot(b), -1.0, 1.0)));
    }
  }
  return camera;
}

void requireVaried(const SingleCamera& camera, const std::string& side, const std::string& source) {
  const std::string hint =
      phrase("tilt the board to both sides and up and down, by 20 to 40 degrees");
  if (!(camera.turn >= kMinTurn)) {
    throw Error(ErrorCode::BadInput,
                phrase("{}: {} camera: found boards turned by at most {:.0f}° to each other, "
                       "expected {:.0f}° or more: the focal length cannot be told",
                       source, side, toDegrees(camera.turn), toDegrees(kMinTurn)),
                hint);
  }
  if (!(camera.focal_sigma <= kMaxFocalSigma)) {
    throw Error(ErrorCode::BadInput,
                phrase("{}: {} camera: found a focal length known to ±{:.1f} %, expected ±{:g} "
                       "% or better",
                       source, side, 100 * camera.focal_sigma, 100 * kMaxFocalSigma),
                hint);
  }
}

/// Both cameras; gives the error of each view and side, and fills in `result`.
cv::Mat calibrateBoth(const Points& points, cv::Size size, const std::string& source,
                      CalibrationResult& result) {
  SingleCamera left = calibrateSingle(points, points.left, size);
  SingleCamera right = calibrateSingle(points, points.right, size);
  requireVaried(left, phrase("left"), source);
  requireVaried(right, phrase("right"), source);
  cv::Mat rotation;
  cv::Mat translation;
  cv::Mat errors;
  cv::stereoCalibrate(points.board, points.left, points.right, left.matrix, left.distortion,
                      right.matrix, right.distortion, size, rotation, translation, cv::noArray(),
                      cv::noArray(), errors, kFlags | cv::CALIB_USE_INTRINSIC_GUESS);
  const auto lens = [](const SingleCamera& camera) {
    return LensCalibration{cv::Matx33d(camera.matrix), camera.distortion.reshape(1, 1)};
  };
  result.calibration = {size, lens(left), lens(right), cv::Matx33d(rotation),
                        cv::Vec3d(translation)};
  result.left_error_px = rms(errors.col(0));
  result.right_error_px = rms(errors.col(1));
  result.focal_sigma = left.focal_sigma;
  result.board_turn = std::min(left.turn, right.turn);
  return errors;
}

/// Moves the views that do not fit the others to the refused; whether there were any.
bool refuseOutliers(const cv::Mat& errors, BoardImages& images) {
  std::vector<double> of_view;
  for (int i = 0; i < errors.rows; ++i) of_view.push_back(rms(errors.row(i)));
  const double usual = medianOf(of_view);
  const double limit = std::max(kOutlier * usual, kOutlier_px);
  std::vector<BoardView> kept;
  for (std::size_t i = 0; i < of_view.size(); ++i) {
    if (of_view[i] <= limit) {
      kept.push_back(std::move(images.views[i]));
    } else {
      images.refused.push_back({images.views[i].name, phrase("off by {:.2f} px, the others by "
                                                             "{:.2f} px",
                                                             of_view[i], usual)});
    }
  }
  images.views = std::move(kept);
  return images.views.size() < of_view.size();
}

double epipolarError(const Points& points, const StereoCalibration& calibration) {
  cv::Mat r1;
  cv::Mat r2;
  cv::Mat p1;
  cv::Mat p2;
  cv::Mat q;
  const LensCalibration& l = calibration.left;
  const LensCalibration& r = calibration.right;
  cv::stereoRectify(l.matrix, l.distortion, r.matrix, r.distortion, calibration.size,
                    calibration.rotation, calibration.translation, r1, r2, p1, p2, q);
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.left.size(); ++i) {
    Corners rectified(2);
    cv::undistortPoints(points.left[i], rectified[0], l.matrix, l.distortion, r1, p1);
    cv::undistortPoints(points.right[i], rectified[1], r.matrix, r.distortion, r2, p2);
    for (std::size_t j = 0; j < rectified[0].size(); ++j, ++count) {
      sum += std::abs(rectified[0][j].y - rectified[1][j].y);
    }
  }
  return sum / static_cast<double>(count);
}

void requireSmallErrors(const CalibrationResult& result, const std::string& source) {
  for (const auto& [error, what] :
       {std::pair(result.left_error_px, phrase("an error of the left camera")),
        std::pair(result.right_error_px, phrase("an error of the right camera")),
        std::pair(result.epipolar_error_px,
                  phrase("an error between the rows of rectified images"))}) {
    if (error <= kMaxError_px) continue;
    throw Error(ErrorCode::BadInput,
                phrase("{}: found {} of {:.2f} px, expected at most {:g} px", source, what, error,
                       kMaxError_px),
                phrase("sharp images, both of a pair taken at one time, of a board that is flat"));
  }
}

}  // namespace

CalibrationResult calibrateStereo(BoardImages images, const Board& board,
                                  const std::string& source) {
  requirePairs(images, source);
  CalibrationResult result;
  cv::Mat errors;
  Points points;
  try {
    points = pointsOf(images, board);
    errors = calibrateBoth(points, images.size, source, result);
    if (refuseOutliers(errors, images)) {
      requirePairs(images, source);
      points = pointsOf(images, board);
      errors = calibrateBoth(points, images.size, source, result);
    }
    result.epipolar_error_px = epipolarError(points, result.calibration);
  } catch (const cv::Exception& error) {
    throwBadInput(source, "", phrase("boards that fit no camera ({})", error.err),
                  phrase("a flat checkerboard seen from several sides"));
  }
  checkStereoCalibration(result.calibration, source);
  requireSmallErrors(result, source);
  for (std::size_t i = 0; i < images.views.size(); ++i) {
    result.used.push_back({images.views[i].name, rms(errors.row(static_cast<int>(i)))});
  }
  result.refused = std::move(images.refused);
  return result;
}

}  // namespace handmap
