#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/options.h"
#include "app/cli/progress.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/calibration/stereo_calibrator.h"

namespace handmap {

namespace {

struct CalibrateArguments {
  std::string left;
  std::string right;
  std::string board;
  std::optional<double> square_m;
  std::string out;
  std::string report;
};

cv::Size cornersOf(const std::string& text) {
  const cv::Size corners = parseBoardCorners(text);
  if (corners.empty()) {
    throw Error(ErrorCode::Usage,
                fmt::format("--board: found {}, expected two different numbers of inner corners "
                            "from 3 to 50, as 9x6",
                            text));
  }
  return corners;
}

std::string summary(const CalibrationResult& result) {
  const StereoCalibration& calibration = result.calibration;
  return fmt::format(
      "{} pairs used, {} refused\n"
      "baseline {:.4f} m, focal lengths {:.2f} px and {:.2f} px\n"
      "error {:.3f} px left, {:.3f} px right, {:.3f} px between rows\n",
      result.used.size(), result.refused.size(), cv::norm(calibration.translation),
      calibration.left.matrix(0, 0), calibration.right.matrix(0, 0), result.left_error_px,
      result.right_error_px, result.epipolar_error_px);
}

int calibrate(const CalibrateArguments& arguments) {
  checkOutputFiles({arguments.out, arguments.report}, {arguments.left, arguments.right});
  const Board board{cornersOf(arguments.board), *arguments.square_m};
  const Interrupt interrupt;
  std::optional<Progress> progress;
  const auto tell = [&](int done, int all) {
    if (!progress) progress.emplace(all);
    progress->update(done, 0.0);
    return !interrupt.requested();
  };
  BoardImages images = findBoards(arguments.left, arguments.right, board, tell);
  if (interrupt.requested()) {
    progress->message("interrupted, nothing written");
    return Interrupt::kExitStatus;
  }
  progress->finish(static_cast<int>(images.views.size() + images.refused.size()));
  const CalibrationResult result = calibrateStereo(
      std::move(images), board, fmt::format("{} and {}", arguments.left, arguments.right));
  for (const RefusedPair& pair : result.refused) {
    progress->message(fmt::format("{} refused: {}", pair.name, pair.reason));
  }
  writeFileAtomically(arguments.out, formatStereoCalibration(result.calibration));
  if (!arguments.report.empty()) {
    writeFileAtomically(arguments.report, calibrationReportJson(result, board));
  }
  fmt::print("{}", summary(result));
  return 0;
}

}  // namespace

void addCalibrateCommand(CLI::App& app, ChosenCommand& chosen) {
  const auto arguments = std::make_shared<CalibrateArguments>();
  CalibrateArguments& a = *arguments;
  CLI::App* command =
      app.add_subcommand("calibrate", "Calibrate a stereo camera from images of a checkerboard");
  command->callback(
      [&chosen, arguments] { chosen = [arguments] { return calibrate(*arguments); }; });
  command->add_option("--left", a.left, "Images of the left camera (required)")
      ->required()
      ->option_text("DIR");
  command->add_option("--right", a.right, "Of the right one, with the same names (required)")
      ->required()
      ->option_text("DIR");
  command->add_option("--board", a.board, "Inner corners, columns x rows (required)")
      ->required()
      ->option_text("9x6");
  addNumber(*command, "--square", a.square_m, 0.001, 1, "Side of a square, metres, required")
      ->required();
  command->add_option("--out", a.out, "For recording.json: \"calibration\" (required)")
      ->required()
      ->option_text("calib.yml");
  command->add_option("--report", a.report, "Pairs used and refused, and the errors")
      ->option_text("report.json");
}

}  // namespace handmap
