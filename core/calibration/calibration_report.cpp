#include <nlohmann/json.hpp>
#include <opencv2/core/base.hpp>

#include "core/calibration/stereo_calibrator.h"
#include "core/geometry/pose2.h"

namespace handmap {

std::string calibrationReportJson(const CalibrationResult& result, const Board& board) {
  using Json = nlohmann::ordered_json;
  const auto lens = [](const LensCalibration& of, double error_px) {
    const cv::Matx33d& m = of.matrix;
    return Json{{"focal_px", {m(0, 0), m(1, 1)}},
                {"centre_px", {m(0, 2), m(1, 2)}},
                {"distortion", of.distortion},
                {"error_px", error_px}};
  };
  const StereoCalibration& calibration = result.calibration;
  Json report{{"program", "handmap " HANDMAP_VERSION},
              {"board",
               {{"columns", board.corners.width},
                {"rows", board.corners.height},
                {"square_m", board.square_m}}},
              {"size_px", {calibration.size.width, calibration.size.height}},
              {"left", lens(calibration.left, result.left_error_px)},
              {"right", lens(calibration.right, result.right_error_px)},
              {"baseline_m", cv::norm(calibration.translation)},
              {"epipolar_error_px", result.epipolar_error_px},
              {"focal_sigma_percent", 100.0 * result.focal_sigma},
              {"board_turn_deg", toDegrees(result.board_turn)},
              {"used", Json::array()},
              {"refused", Json::array()}};
  for (const UsedPair& pair : result.used) {
    report["used"].push_back({{"name", pair.name}, {"error_px", pair.error_px}});
  }
  for (const RefusedPair& pair : result.refused) {
    report["refused"].push_back({{"name", pair.name}, {"reason", pair.reason}});
  }
  return report.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace handmap
