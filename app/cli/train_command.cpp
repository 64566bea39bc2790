#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/options.h"
#include "app/cli/share_progress.h"
#include "core/base/error.h"
#include "core/classification/labelled_folder.h"
#include "core/classification/training.h"

namespace handmap {

namespace {

struct TrainArguments {
  LabelledFolder training;
  LabelledFolder validation;
  FeatureFamily family = FeatureFamily::Handmap;
  bool grey = false;
  TrainingOptions options;
  std::string out;
};

void printFigures(const std::string& name, const Confusion& figures) {
  fmt::print("{:<15} {:>17.3f} {:>10.3f} {:>7.3f} {:>6.3f}\n", name, figures.balancedAccuracy(),
             figures.precision(), figures.recall(), figures.f1());
}

TrainingSet readTrainingSet(const TrainArguments& arguments, ShareProgress& progress,
                            const std::stop_token& stop) {
  // What trees are for, streets elsewhere, is where equalized features are better.
  const bool equalizes = arguments.options.trees && arguments.family == FeatureFamily::Handmap;
  TrainingSet set({equalizes ? FeatureFamily::Equalized : arguments.family, !arguments.grey});
  const auto add = [&](const cv::Mat& image, const std::vector<WindowLabel>& labels, double share) {
    set.add(image, labels);
    progress.update("reading images", share);
  };
  forEachLabelled(arguments.training, add, stop);
  return set;
}

Confusion validate(const TrainArguments& arguments, const BuildingClassifier& classifier,
                   ShareProgress& progress, const std::stop_token& stop) {
  Confusion confusion;
  const auto add = [&](const cv::Mat& image, const std::vector<WindowLabel>& labels, double share) {
    judge(classifier, image, labels, confusion);
    progress.update("validating", share);
  };
  forEachLabelled(arguments.validation, add, stop);
  return confusion;
}

int train(const TrainArguments& arguments) {
  checkOutputFiles({arguments.out}, {arguments.training.images, arguments.training.labels,
                                     arguments.validation.images, arguments.validation.labels});
  const Interrupt interrupt;
  const std::stop_token stop = interrupt.token();
  ShareProgress progress;
  const TrainingSet set = readTrainingSet(arguments, progress, stop);
  if (stop.stop_requested()) return Interrupt::kExitStatus;
  const auto classifier = trainClassifier(
      set, arguments.options, stop, [&](double share) { progress.update("training", share); });
  if (!classifier) return Interrupt::kExitStatus;
  const bool validates = !arguments.validation.images.empty();
  const Confusion validation =
      validates ? validate(arguments, *classifier, progress, stop) : Confusion{};
  if (stop.stop_requested()) return Interrupt::kExitStatus;
  classifier->save(arguments.out);

  const Confusion& crossed = classifier->record().cross_validated;
  const std::string method =
      arguments.options.trees
          ? "trees"
          : fmt::format("gamma {}, C {}", classifier->record().gamma, classifier->record().c);
  fmt::print("{} windows, {} of buildings; {} features, {}; {}\n", set.buildings().size(),
             crossed.buildings(), nameOf(classifier->features().family),
             arguments.grey ? "grey" : "colour", method);
  fmt::print("{:15} balanced accuracy  precision  recall     F1\n", "");
  printFigures("cross-validated", crossed);
  if (validates) printFigures("validation", validation);
  return 0;
}

void addFolders(CLI::App& command, TrainArguments& a) {
  command.add_option("--images", a.training.images, "PNG or JPEG images (required)")
      ->required()
      ->option_text("DIR");
  command
      .add_option("--labels", a.training.labels,
                  "For each image a grey PNG of the same name and size with a class number a pixel "
                  "(required)")
      ->required()
      ->option_text("DIR");
  CLI::Option* images = command.add_option("--validate-images", a.validation.images,
                                           "Images to judge the model by; nothing is learnt there");
  CLI::Option* labels =
      command.add_option("--validate-labels", a.validation.labels, "Their labels");
  images->option_text("DIR")->needs(labels);
  labels->option_text("DIR")->needs(images);
}

}  // namespace

void addTrainCommand(CLI::App& app, ChosenCommand& chosen) {
  const auto arguments = std::make_shared<TrainArguments>();
  TrainArguments& a = *arguments;
  CLI::App* command =
      app.add_subcommand("train", "Teach from labelled images what buildings look like");
  command->callback([&chosen, arguments] {
    arguments->validation.building = arguments->training.building;
    arguments->validation.ignored = arguments->training.ignored;
    arguments->training.seed = arguments->options.seed;
    chosen = [arguments] { return train(*arguments); };
  });
  addFolders(*command, a);
  addNumber(*command, "--label", a.training.building, 0, 255, "The class number of buildings");
  addNumber(*command, "--ignore", a.training.ignored, 0, 255,
            "The class number of what is not known");
  addChoice(*command, "--features", a.family,
            {{"handmap", FeatureFamily::Handmap}, {"paper", FeatureFamily::Paper}},
            "What is measured of a window");
  addNumber(*command, "--variations", a.training.variations, 0, 100,
            "Of each image, as other cameras would have taken it, to learn from too");
  command->add_flag("--trees", a.options.trees,
                    "Random trees in place of the support vector machine: better when real streets "
                    "elsewhere are learnt from, worse when rendered ones are");
  command->add_flag("--grey", a.grey, "A model that needs no colours");
  addSeed(*command, a.options.seed, "Of the random numbers");
  command->add_option("--out", a.out, "The model (required)")->required()->option_text("MODEL");
}

}  // namespace handmap
