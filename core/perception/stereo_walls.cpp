#include "core/perception/stereo_walls.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/stopwatch.h"
#include "core/base/text.h"
#include "core/classification/windows.h"
#include "core/perception/constants.h"
#include "core/perception/stereo_scan.h"
#include "core/perception/wall_columns.h"
#include "core/recording/image_file.h"

namespace handmap {

using namespace perception;

namespace {

[[noreturn]] void refuse(const std::string& place, const std::string& found,
                         const std::string& expected) {
  throwBadInput(phrase("stereo"), place, found, expected);
}

void require(bool good, const std::string& place, const std::string& found,
             const std::string& expected) {
  if (!good) refuse(place, found, expected);
}

void check(const StereoCamera& camera) {
  const auto positive = [](double value, const std::string& what) {
    require(std::isfinite(value) && value > 0.0, what, formatNumber(value),
            phrase("a positive number"));
  };
  positive(camera.fx, phrase("focal length fx"));
  positive(camera.fy, phrase("focal length fy"));
  positive(camera.baseline, phrase("baseline"));
  for (const double value :
       {camera.cx, camera.cy, camera.mount.x, camera.mount.y, camera.mount.z, camera.mount.yaw}) {
    require(std::isfinite(value), phrase("camera"), formatNumber(value), phrase("finite numbers"));
  }
  require(std::abs(camera.mount.pitch) < toRadians(60.0), phrase("camera mount"),
          phrase("{}° of pitch", formatNumber(toDegrees(camera.mount.pitch))),
          phrase("less than 60°"));
}

void check(const StereoOptions& options) {
  require(options.scale >= 0.0 && options.scale <= 1.0, "scale", formatNumber(options.scale),
          phrase("a number from 0 to 1"));
  require(options.num_disparities >= 0 && options.num_disparities <= 512 &&
              options.num_disparities % 16 == 0,
          "num_disparities", std::to_string(options.num_disparities),
          phrase("a multiple of 16, at most 512"));
  require(options.block_size >= 1 && options.block_size <= 31 && options.block_size % 2 == 1,
          "block_size", std::to_string(options.block_size), phrase("an odd number, at most 31"));
}

std::string describe(const cv::Mat& image) {
  if (image.empty()) return phrase("no image");
  return phrase("{}×{}, {} channels, {} bits", image.cols, image.rows, image.channels(),
                8 * image.elemSize1());
}

void check(const cv::Mat& left, const cv::Mat& right) {
  for (const cv::Mat* image : {&left, &right}) {
    if (!image->empty() && image->depth() == CV_8U &&
        (image->channels() == 1 || image->channels() == 3)) {
      continue;
    }
    refuse(image == &left ? phrase("left image") : phrase("right image"), describe(*image),
           phrase("8 bits, one or three channels"));
  }
  if (left.size() != right.size()) {
    refuse(phrase("right image"), describe(right),
           phrase("the size of the left image: {}", describe(left)));
  }
}

/// Mean step between neighbours in a row, grey levels. Where there is none, nothing can be matched
/// and what the matcher says comes from elsewhere: sky, saturated walls.
cv::Mat1f textureOf(const cv::Mat& image) {
  cv::Mat steps;
  cv::absdiff(image.colRange(1, image.cols), image.colRange(0, image.cols - 1), steps);
  cv::copyMakeBorder(steps, steps, 0, 0, 1, 0, cv::BORDER_REPLICATE);
  cv::Mat1f texture;
  cv::boxFilter(steps, texture, CV_32F, {kTextureWindow_px, kTextureWindow_px});
  return texture;
}

int disparitiesFor(const StereoCamera& reduced) {
  const double nearest = reduced.fx * reduced.baseline / kNearest_m;
  return 16 * static_cast<int>(std::clamp(std::ceil(nearest / 16.0), 1.0, 16.0));
}

/// Of an image: less is no place for two windows.
int leastSide() { return 2 * kWindow_px; }

/// Farther down the ground is nearer than what `disparities` reach to: nothing can be matched
/// there.
int rowsToMatch(const StereoCamera& reduced, const CameraRays& rays, int disparities) {
  const double nearest_m = reduced.fx * reduced.baseline / disparities;
  int rows = static_cast<int>(rays.up.size());
  while (rows > leastSide() &&
         nearest_m * -rays.up[static_cast<std::size_t>(rows - 1)] > reduced.mount.z) {
    --rows;
  }
  return rows;
}

}  // namespace

struct StereoWalls::Matcher {
  StereoCamera camera;
  StereoOptions options;
  std::optional<WallJudge> judge;
  cv::Ptr<cv::StereoSGBM> sgbm = cv::StereoSGBM::create();
  cv::Mat left;
  cv::Mat right;
  cv::Mat1s sixteenths;

  void prepare(const cv::Mat& image, cv::Size size, int padding, cv::Mat& prepared) const;
  cv::Mat1f match(const cv::Mat& left_image, const cv::Mat& right_image, cv::Size size,
                  int disparities, int rows);
  std::vector<WallPoint> inRobotFrame(const std::vector<WallColumn>& columns,
                                      const StereoCamera& reduced, double pan_rad,
                                      double range_limit_m) const;
};

/// Grey, reduced, and padded on the left, or the search for large disparities would cost the view.
void StereoWalls::Matcher::prepare(const cv::Mat& image, cv::Size size, int padding,
                                   cv::Mat& prepared) const {
  const cv::Mat grey = greyImage(image);
  cv::Mat small = grey;
  if (size != grey.size()) cv::resize(grey, small, size, 0.0, 0.0, cv::INTER_AREA);
  cv::copyMakeBorder(small, prepared, 0, 0, padding, 0, cv::BORDER_REPLICATE);
}

cv::Mat1f StereoWalls::Matcher::match(const cv::Mat& left_image, const cv::Mat& right_image,
                                      cv::Size size, int disparities, int rows) {
  prepare(left_image, size, disparities, left);
  prepare(right_image, size, disparities, right);
  const cv::Mat upper = left.rowRange(0, rows);
  sgbm->setNumDisparities(disparities);
  sgbm->compute(upper, right.rowRange(0, rows), sixteenths);
  const cv::Mat1f texture = textureOf(upper);
  cv::Mat1f disparity(size, kUnknownDisparity);
  for (int row = 0; row < rows; ++row) {
    const short* in = sixteenths[row] + disparities;
    const float* contrast = texture[row] + disparities;
    float* out = disparity[row];
    for (int column = 0; column < size.width; ++column) {
      const float d = static_cast<float>(in[column]) / 16.0F;
      // Farther left the match would lie in the padding.
      const bool known =
          d > 0.0F && d <= static_cast<float>(column) && contrast[column] >= kMinTexture;
      out[column] = known ? d : kUnknownDisparity;
    }
  }
  return disparity;
}

std::vector<WallPoint> StereoWalls::Matcher::inRobotFrame(const std::vector<WallColumn>& columns,
                                                          const StereoCamera& reduced,
                                                          double pan_rad,
                                                          double range_limit_m) const {
  const CameraMount& mount = reduced.mount;
  const Pose2 placed{mount.x, mount.y, mount.yaw + pan_rad};
  std::vector<WallPoint> walls;
  walls.reserve(columns.size());
  for (const WallColumn& column : columns) {
    const double range = std::hypot(column.x, column.y);
    // Along the ray, which is longer than the depth by the factor range / x.
    const double sigma =
        column.x * range * options.sigma_disparity / (reduced.fx * reduced.baseline);
    const Vec2 point = placed.toOuter({column.x, column.y});
    const double robot_range = point.norm();
    if (sigma > options.max_sigma_m || robot_range > range_limit_m ||
        robot_range < options.filter.min_range_m) {
      continue;
    }
    walls.push_back({static_cast<float>(point.x()), static_cast<float>(point.y()),
                     static_cast<float>(sigma),
                     static_cast<float>(column.building *
                                        std::min(1.0, column.extent_m / (2.0 * kLeastExtent_m)))});
  }
  return walls;
}

double stereoScale(const StereoCamera& camera) {
  double scale = 1.0;
  while (scale > 0.25 && camera.fx * camera.baseline * scale / 2.0 >= kLeastFocal_px_m)
    scale /= 2.0;
  return scale;
}

StereoWalls::StereoWalls(const StereoCamera& camera, const StereoOptions& options,
                         std::optional<WallJudge> judge) {
  check(camera);
  check(options);
  matcher_ = std::make_unique<Matcher>();
  matcher_->camera = camera;
  matcher_->options = options;
  if (options.scale == 0.0) matcher_->options.scale = stereoScale(camera);
  matcher_->judge = std::move(judge);
  const int area = options.block_size * options.block_size;
  cv::StereoSGBM& sgbm = *matcher_->sgbm;
  sgbm.setMode(cv::StereoSGBM::MODE_SGBM_3WAY);
  sgbm.setBlockSize(options.block_size);
  sgbm.setP1(8 * area);
  sgbm.setP2(32 * area);
  sgbm.setPreFilterCap(kPreFilterCap);
  sgbm.setUniquenessRatio(kUniqueness_percent);
  sgbm.setDisp12MaxDiff(static_cast<int>(std::lround(options.left_right_px)));
  sgbm.setSpeckleWindowSize(options.speckle_window);
  sgbm.setSpeckleRange(static_cast<int>(std::lround(options.speckle_range)));
}

StereoWalls::~StereoWalls() = default;

StereoResult StereoWalls::operator()(const cv::Mat& left, const cv::Mat& right, double pan_rad,
                                     double range_limit_m) {
  check(left, right);
  const StereoOptions& options = matcher_->options;
  const cv::Size size(static_cast<int>(std::lround(left.cols * options.scale)),
                      static_cast<int>(std::lround(left.rows * options.scale)));
  if (std::min(size.width, size.height) < leastSide()) {
    refuse(phrase("left image"), describe(left),
           phrase("at least {} pixels a side at the reduced size", leastSide()));
  }
  const StereoCamera reduced =
      reducedCamera(matcher_->camera, static_cast<double>(left.cols) / size.width,
                    static_cast<double>(left.rows) / size.height);

  StereoResult result;
  const int disparities =
      options.num_disparities > 0 ? options.num_disparities : disparitiesFor(reduced);
  const CameraRays rays(reduced, size);
  const Stopwatch matching;
  result.disparity =
      matcher_->match(left, right, size, disparities, rowsToMatch(reduced, rays, disparities));
  result.stereo_ms = matching.ms();

  const Stopwatch rest;
  const GroundPlane ground = fitGround(result.disparity, reduced, rays);
  std::vector<WallColumn> columns =
      wallColumns(result.disparity, reduced, rays, ground, options.filter, range_limit_m);
  if (matcher_->judge) result.buildings = (*matcher_->judge)(left, size, columns);
  result.walls = matcher_->inRobotFrame(columns, reduced, pan_rad, range_limit_m);
  // Where σ_z = z² σ_d / (f B) passes its limit.
  const double max_depth_m = std::min(
      range_limit_m,
      std::sqrt(options.max_sigma_m * reduced.fx * reduced.baseline / options.sigma_disparity));
  const Pose2 placed{reduced.mount.x, reduced.mount.y, reduced.mount.yaw + pan_rad};
  result.looked_through = lookedThrough(result.disparity, reduced, rays, max_depth_m);
  for (Vec2& end : result.looked_through) end = placed.toOuter(end);
  result.walls_ms = rest.ms();
  return result;
}

}  // namespace handmap
