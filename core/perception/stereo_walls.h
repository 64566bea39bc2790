// Rectified stereo pairs to points on walls (paper, II-A).
#pragma once

#include <memory>
#include <optional>

#include <opencv2/core/mat.hpp>

#include "core/perception/wall_judge.h"
#include "core/perception/wall_points.h"
#include "core/recording/observation.h"

namespace handmap {

struct StereoOptions {
  /// Images are reduced by this before matching; 0: as far as depth allows, see stereoScale().
  double scale = 0.0;
  int num_disparities = 0;  ///< at the reduced size, a multiple of 16; 0: to see 4 m
  int block_size = perception::kBlockSize_px;  ///< odd
  double left_right_px =
      perception::kOff_px;  ///< consistency, at the reduced size; rounded, at least 1
  int speckle_window = perception::kSpeckle_px;  ///< pixels
  double speckle_range = perception::kOff_px;    ///< pixels of disparity
  double sigma_disparity =
      perception::kDisparitySigma_px;  ///< σ_d at the reduced size, pixels: σ_z = z² σ_d / (f B)
  double max_sigma_m = perception::kMostSigma_m;  ///< points noisier than this are dropped
  WallFilter filter;
};

/// 1, 1/2 or 1/4: the smallest at which f·B is still 180 px·m. There a pixel of disparity is 2.2 m
/// at 20 m; matchers pull disparities towards whole pixels, and walls with them.
double stereoScale(const StereoCamera& camera);

/// What one pair gave, for the panel and for pictures.
struct StereoResult {
  cv::Mat1f disparity;  ///< pixels at the reduced size; < 0 where unknown
  std::vector<WallPoint> walls;
  /// Probability of each 16×16 window of the left image; 0.5 where not asked; empty without a
  /// judge.
  cv::Mat1f buildings;
  std::vector<Vec2> looked_through;  ///< robot frame: where the view of each column ends
  double stereo_ms = 0.0;            ///< matching
  double walls_ms = 0.0;             ///< the rest
};

/// cv::StereoSGBM with left-right check and speckle filter, then per image column the vertical
/// extent over disparity. Holds buffers: one object a thread.
class StereoWalls {
 public:
  /// Without a judge every wall is as sure as its extent. Throws BadInput for a camera or options
  /// that cannot be.
  StereoWalls(const StereoCamera& camera, const StereoOptions& options,
              std::optional<WallJudge> judge = {});
  ~StereoWalls();
  StereoWalls(const StereoWalls&) = delete;
  StereoWalls& operator=(const StereoWalls&) = delete;

  /// Left and right: 8 bit, one or three channels, of one size. Throws BadInput otherwise.
  StereoResult operator()(const cv::Mat& left, const cv::Mat& right, double pan_rad,
                          double range_limit_m);

 private:
  struct Matcher;
  std::unique_ptr<Matcher> matcher_;
};

}  // namespace handmap
