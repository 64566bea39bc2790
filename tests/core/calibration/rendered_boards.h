// Pairs of images of a checkerboard, rendered through lenses that bend.
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <opencv2/calib3d.hpp>

#include "core/calibration/board_images.h"
#include "core/recording/image_file.h"
#include "core/recording/stereo_calibration.h"

namespace handmap::test {

inline const Board kBoard{{9, 6}, 0.04};

/// Pose of the board in the left camera: the corner between its first four squares is its origin.
struct BoardPose {
  cv::Vec3d turn;  ///< as cv::Rodrigues has it
  cv::Vec3d place;
};

/// Tilted to all sides, near and far, in all parts of the image.
inline std::vector<BoardPose> variedPoses() {
  std::vector<BoardPose> poses;
  for (int i = 0; i < 12; ++i) {
    const double a = 2.0 * CV_PI * i / 12.0;
    const double z = 0.62 + 0.05 * (i % 4);
    poses.push_back({{0.45 * std::cos(a), 0.45 * std::sin(a), 0.08 * (i % 3 - 1)},
                     {-0.12 + 0.07 * std::cos(3 * a), -0.10 + 0.07 * std::sin(2 * a), z}});
  }
  return poses;
}

/// The middle of the board at a pixel of the left image of boardCamera(), at a distance.
inline BoardPose boardAt(double u, double v, double z, const cv::Vec3d& turn) {
  cv::Matx33d rotation;
  cv::Rodrigues(turn, rotation);
  const cv::Vec3d middle(0.5 * (kBoard.corners.width - 1) * kBoard.square_m,
                         0.5 * (kBoard.corners.height - 1) * kBoard.square_m, 0.0);
  return {turn, cv::Vec3d(z * (u - 244) / 430, z * (v - 176) / 432, z) - rotation * middle};
}

/// As the program asks a person for them: at all edges, near and far, turned and tilted.
inline std::vector<BoardPose> guidedPoses() {
  return {boardAt(195, 180, 0.8, {0, 0, 0}),         boardAt(347, 180, 0.8, {0, 0, 0}),
          boardAt(260, 100, 0.8, {0, 0, 0}),         boardAt(260, 264, 0.8, {0, 0, 0}),
          boardAt(280, 180, 0.6, {0, 0, 0}),         boardAt(260, 180, 1.15, {0, 0, 0}),
          boardAt(270, 180, 0.75, {0, -0.45, 0}),    boardAt(270, 180, 0.75, {0, 0.45, 0}),
          boardAt(270, 180, 0.75, {0.45, 0, 0}),     boardAt(270, 180, 0.75, {-0.45, 0, 0}),
          boardAt(200, 130, 0.85, {0.35, 0.35, 0}),  boardAt(330, 130, 0.85, {-0.35, 0.35, 0}),
          boardAt(200, 230, 0.85, {0.35, -0.35, 0}), boardAt(330, 230, 0.85, {-0.35, -0.35, 0}),
          boardAt(270, 180, 0.8, {0.3, 0, 0.5}),     boardAt(330, 240, 1.15, {0, 0.5, 0})};
}

/// 480×360 pixels, 12 cm apart.
inline StereoCalibration boardCamera() {
  StereoCalibration calibration;
  calibration.size = {480, 360};
  calibration.left = {{430, 0, 244, 0, 432, 176, 0, 0, 1}, {-0.18, 0.06, 0.0008, -0.0006, 0.0}};
  calibration.right = {{424, 0, 236, 0, 425, 184, 0, 0, 1}, {-0.16, 0.04, -0.0005, 0.0009, 0.0}};
  cv::Rodrigues(cv::Vec3d(0.01, 0.02, -0.012), calibration.rotation);
  calibration.translation = {-0.12, 0.002, 0.001};
  return calibration;
}

/// Square wave of period 2 with softened edges: -1 … 1.
inline double wave(double x, double softness) {
  const double in_period = x - 2.0 * std::floor(x / 2.0);
  const double to_edge = in_period < 0.5   ? in_period
                         : in_period < 1.5 ? 1.0 - in_period
                                           : in_period - 2.0;
  return std::clamp(to_edge / softness, -1.0, 1.0);
}

/// What a camera with this lens sees of a board at `turn`, `place` in its frame.
inline cv::Mat renderBoard(const LensCalibration& lens, cv::Size size, const cv::Matx33d& turn,
                           const cv::Vec3d& place, const Board& board = kBoard) {
  std::vector<cv::Point2f> pixels;
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      pixels.emplace_back(static_cast<float>(u), static_cast<float>(v));
    }
  }
  std::vector<cv::Point2f> rays;
  cv::undistortPoints(pixels, rays, lens.matrix, lens.distortion, cv::noArray(), cv::noArray(),
                      cv::TermCriteria(cv::TermCriteria::COUNT, 20, 0.0));
  const cv::Vec3d normal(turn(0, 2), turn(1, 2), turn(2, 2));
  cv::Mat1b image(size, std::uint8_t(90));
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const cv::Vec3d ray(rays[i].x, rays[i].y, 1.0);
    const double z = normal.dot(place) / normal.dot(ray);
    if (!(z > 0.0)) continue;
    const cv::Vec3d on_board = turn.t() * (z * ray - place) * (1.0 / board.square_m);
    const double x = on_board[0] + 1.0;  // squares from the outer corner
    const double y = on_board[1] + 1.0;
    const bool on_paper =
        x > -0.7 && y > -0.7 && x < board.corners.width + 1.7 && y < board.corners.height + 1.7;
    if (!on_paper) continue;
    const bool on_squares =
        x > 0.0 && y > 0.0 && x < board.corners.width + 1 && y < board.corners.height + 1;
    const double softness = 0.7 * z / (lens.matrix(0, 0) * board.square_m);
    const double parity = wave(x, softness) * wave(y, softness);
    image.at<std::uint8_t>(static_cast<int>(i) / size.width, static_cast<int>(i) % size.width) =
        cv::saturate_cast<std::uint8_t>(on_squares ? 130.0 - 95.0 * parity : 225.0);
  }
  return image;
}

inline cv::Mat leftImage(const StereoCalibration& camera, const BoardPose& pose) {
  cv::Matx33d turn;
  cv::Rodrigues(pose.turn, turn);
  return renderBoard(camera.left, camera.size, turn, pose.place);
}

inline cv::Mat rightImage(const StereoCalibration& camera, const BoardPose& pose) {
  cv::Matx33d turn;
  cv::Rodrigues(pose.turn, turn);
  return renderBoard(camera.right, camera.size, camera.rotation * turn,
                     camera.rotation * pose.place + camera.translation);
}

/// left/00.png, right/00.png and so on.
inline void writeBoards(const std::filesystem::path& folder, const StereoCalibration& camera,
                        const std::vector<BoardPose>& poses) {
  std::filesystem::create_directories(folder / "left");
  std::filesystem::create_directories(folder / "right");
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const std::string name = (i < 10 ? "0" : "") + std::to_string(i) + ".png";
    writePng(leftImage(camera, poses[i]), folder / "left" / name);
    writePng(rightImage(camera, poses[i]), folder / "right" / name);
  }
}

}  // namespace handmap::test
