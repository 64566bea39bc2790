// Calibration of a stereo camera as it is, before rectification: the file that OpenCV writes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <opencv2/core/matx.hpp>
#include <opencv2/core/types.hpp>

namespace handmap {

/// Pinhole with the distortion of OpenCV: k1 k2 p1 p2 [k3 [k4 k5 k6 [s1 … s4 [τx τy]]]]. Pixels.
struct LensCalibration {
  cv::Matx33d matrix = cv::Matx33d::eye();  ///< fx 0 cx  0 fy cy  0 0 1
  std::vector<double> distortion;           ///< 4, 5, 8, 12 or 14 numbers
};

struct StereoCalibration {
  cv::Size size;  ///< of the images of both cameras
  LensCalibration left;
  LensCalibration right;
  /// A point x of the left camera (x right, y down, z forward, metres) is rotation·x + translation
  /// in the right one: translation[0] < 0.
  cv::Matx33d rotation = cv::Matx33d::eye();
  cv::Vec3d translation;
};

/// Throws BadInput where `calibration` cannot be that of two cameras side by side: focal lengths
/// and centres off the image, no rotation, no plausible baseline, left and right swapped, one above
/// the other. `file` names it in messages.
void checkStereoCalibration(const StereoCalibration& calibration, const std::string& file);

/// Reads and checks YAML, XML or JSON of cv::FileStorage with image_width and image_height (or
/// image_size, size: [w, h]), M1 D1 M2 D2 R T as OpenCV's stereo_calib writes them; also
/// camera_matrix_left, distortion_left and so on. Throws BadInput with the key.
StereoCalibration readStereoCalibration(const std::filesystem::path& path);

/// The YAML that reads back as the same calibration.
std::string formatStereoCalibration(const StereoCalibration& calibration);

}  // namespace handmap
