#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <opencv2/core.hpp>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "core/base/error.h"
#include "core/classification/building_classifier.h"
#include "core/classification/load_classifier.h"
#include "core/classification/overlay.h"
#include "core/recording/image_file.h"

namespace handmap {

namespace {

struct ClassifyArguments {
  std::string model;
  std::optional<int> building_class;
  std::string image;
  std::string out;
  bool json = false;
};

/// FORMATS 3.
std::string toJson(const cv::Mat1f& probabilities) {
  std::vector<std::string> rows;
  for (int row = 0; row < probabilities.rows; ++row) {
    const float* values = probabilities[row];
    rows.push_back(fmt::format("[{:.4f}]", fmt::join(values, values + probabilities.cols, ",")));
  }
  return fmt::format("{{\"window\":{},\"columns\":{},\"rows\":{},\"building\":[{}]}}\n", kWindow_px,
                     probabilities.cols, probabilities.rows, fmt::join(rows, ","));
}

int classify(const ClassifyArguments& arguments) {
  checkOutputFiles({arguments.out}, {arguments.image, arguments.model});
  const cv::Mat image = readImage(arguments.image);
  const auto classifier = arguments.model.empty()
                              ? std::make_shared<const BuildingClassifier>(
                                    BuildingClassifier::builtIn(image.channels() == 3))
                              : loadClassifier(arguments.model, arguments.building_class);
  cv::Mat1f probabilities;
  try {
    probabilities = classifier->probabilities(image);
  } catch (const Error& error) {
    throw Error(error.code(), arguments.image + ": " + error.what(), error.hint());
  }
  if (!arguments.out.empty()) writePng(withCrosses(image, probabilities), arguments.out);
  if (arguments.json) {
    fmt::print("{}", toJson(probabilities));
  } else {
    fmt::print("{} of {} windows show a building\n", cv::countNonZero(probabilities > 0.5F),
               probabilities.total());
  }
  return 0;
}

}  // namespace

void addClassifyCommand(CLI::App& app, ChosenCommand& chosen) {
  const auto arguments = std::make_shared<ClassifyArguments>();
  ClassifyArguments& a = *arguments;
  CLI::App* command = app.add_subcommand("classify",
                                         "Find the windows of an image that show a "
                                         "building");
  command->callback(
      [&chosen, arguments] { chosen = [arguments] { return classify(*arguments); }; });
  command->add_option("image", a.image, "PNG or JPEG (required)")->required()->option_text("IMAGE");
  command
      ->add_option("--model", a.model,
                   "Made by train, or a network (default: the one of the program)")
      ->option_text("MODEL|NET.onnx");
  addBuildingClass(*command, a.building_class);
  command->add_option("--out", a.out, "The image with a cross on every such window, PNG")
      ->option_text("overlay.png");
  command->add_flag("--json", a.json, "Print the probabilities of all windows");
}

}  // namespace handmap
