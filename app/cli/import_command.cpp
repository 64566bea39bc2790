#include <iostream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include "app/cli/commands.h"
#include "app/cli/messages.h"
#include "app/cli/options.h"
#include "core/bag_import/bag_import.h"
#include "core/base/text.h"
#include "core/geometry/pose2.h"
#include "core/kitti_raw/kitti_raw.h"
#include "core/logs/log.h"
#include "core/plausibility/plausibility.h"
#include "core/recording/sensor_place.h"

namespace handmap {

namespace {

struct ImportArguments {
  std::vector<std::string> files;
  std::string out;
  std::string name;
  bool quiet = false;
  LogOptions options;
  ToldTopics topics;
};

/// What a word of --units means: one of length, of time or of angle.
void setUnit(std::string_view word, LogOptions& options) {
  if (word == "m") {
    options.metres = 1.0;
  } else if (word == "cm") {
    options.metres = 0.01;
  } else if (word == "mm") {
    options.metres = 0.001;
  } else if (word == "s") {
    options.seconds = 1.0;
  } else if (word == "ms") {
    options.seconds = 1e-3;
  } else if (word == "us") {
    options.seconds = 1e-6;
  } else if (word == "ns") {
    options.seconds = 1e-9;
  } else if (word == "rad") {
    options.radians = 1.0;
  } else if (word == "deg") {
    options.radians = toRadians(1.0);
  } else {
    throw CLI::ValidationError("--units",
                               fmt::format("found {}, expected m|cm|mm,s|ms|us|ns,rad|deg", word));
  }
}

void setUnits(const std::string& text, LogOptions& options) {
  for (const std::string_view word : splitFields(text, ',')) setUnit(word, options);
}

void answer(const Question& question, const std::string& text, LogOptions& options) {
  if (question.option() == "columns") return setColumns(text, options);
  if (question.option() == "angles") return setAngles(text, options);
  const auto rate_hz = parseFinite(text);
  if (!rate_hz || *rate_hz <= 0.0) {
    throw CLI::ValidationError("--rate", fmt::format("found {}, expected scans a second", text));
  }
  options.rate_hz = rate_hz;
}

/// A person at a terminal is asked for what cannot be seen.
Log readAsking(ImportArguments& arguments) {
  const std::vector<std::filesystem::path> files(arguments.files.begin(), arguments.files.end());
  while (true) {
    try {
      return readLogs(files, arguments.options);
    } catch (const Question& question) {
      if (isatty(STDIN_FILENO) == 0 || arguments.quiet) throw;
      fmt::print(stderr, "{}\n{}? ", question.what(), question.text());
      std::string line;
      if (!std::getline(std::cin, line) || trimmed(line).empty()) throw;
      answer(question, line, arguments.options);
    }
  }
}

void sayNotes(const ImportArguments& arguments, const std::vector<std::string>& notes) {
  if (arguments.quiet) return;
  for (const std::string& note : notes) fmt::print(stderr, "handmap-cli: note: {}\n", note);
  for (const Doubt& doubt : doubtsOf(openRecording(arguments.out))) {
    fmt::print(stderr, "handmap-cli: warning: {}\nhint: {}\n", doubt.message, doubt.hint);
  }
}

int importFromBag(const ImportArguments& arguments, const std::string& name) {
  if (arguments.files.size() > 1) {
    throw Error(ErrorCode::Usage,
                fmt::format("{}: found {} files, expected one bag, or the folder of its parts",
                            arguments.files.front(), arguments.files.size()));
  }
  const auto bag = openBag(arguments.files.front());
  const BagPlan plan = planOf(*bag, arguments.topics);
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < bag->topics().size(); ++i) {
    const std::string role = plan.roleOf(i, *bag);
    if (!role.empty()) notes.push_back(fmt::format("{} as {}", bag->topics()[i].name, role));
  }
  const ImportedBag imported = importBag(*bag, plan, arguments.out, name, notes);
  sayNotes(arguments, notes);
  fmt::print("{}: recording of {} pairs of images, {} scans and {} poses\n", arguments.out,
             imported.pairs, imported.scans, imported.poses);
  return 0;
}

int importFromKitti(const ImportArguments& arguments, const std::string& name) {
  if (arguments.files.size() > 1) {
    throw Error(ErrorCode::Usage,
                fmt::format("{}: found {} files, expected the folder of one drive",
                            arguments.files.front(), arguments.files.size()));
  }
  if (arguments.options.sensor) {
    throw Error(ErrorCode::Usage, "--sensor: a drive of KITTI tells where its sensors are");
  }
  // Without a slash behind it.
  const std::filesystem::path folder =
      (std::filesystem::absolute(arguments.files.front()).lexically_normal() / "").parent_path();
  std::vector<std::string> notes;
  const ImportedDrive imported = importKittiRaw(
      folder, arguments.out, name.empty() ? folder.filename().string() : name, notes);
  sayNotes(arguments, notes);
  fmt::print("{}: recording of {} pairs of images, {} scans and {} true poses\n", arguments.out,
             imported.pairs, imported.scans, imported.poses);
  return 0;
}

int import(ImportArguments arguments) {
  checkOutputFolder(arguments.out);
  std::string name = arguments.name;
  if (name.empty()) name = std::filesystem::path(arguments.files.front()).stem().string();
  if (isBag(arguments.files.front())) return importFromBag(arguments, name);
  if (isKittiRaw(arguments.files.front())) return importFromKitti(arguments, name);
  const Log log = readAsking(arguments);
  std::vector<std::string> notes = log.notes;
  const std::size_t scans = writeLog(log, arguments.out, name, notes);
  sayNotes(arguments, notes);
  fmt::print("{}: recording of {} scans and {} poses\n", arguments.out, scans, log.poses.size());
  return 0;
}

}  // namespace

void addImportCommand(CLI::App& app, ChosenCommand& chosen) {
  const auto arguments = std::make_shared<ImportArguments>();
  ImportArguments& a = *arguments;
  CLI::App* command =
      app.add_subcommand("import", "Make a recording of bags and logs of other programs");
  command->callback([&chosen, arguments] { chosen = [arguments] { return import(*arguments); }; });
  command
      ->add_option(
          "log", a.files,
          "A bag of ROS 1 (.bag) or ROS 2 (.mcap, .db3 or its folder); the folder of a drive of "
          "KITTI's raw data; or CARMEN logs, "
          "tables with a header (.csv), poses (.tum), arrays of numpy (.npy, .npz), several "
          "together, as scans and poses")
      ->required()
      ->option_text("FILE ...");
  command->add_option("--out", a.out, "The recording, a new folder (required)")
      ->required()
      ->option_text("DIR");
  command->add_option("--name", a.name, "Of the recording (default: that of the first file)")
      ->option_text("TEXT");
  const auto text = [command](const char* option, auto set, const char* what, const char* form) {
    command->add_option_function<std::string>(option, set, what)->option_text(form);
  };
  text(
      "--columns", [&a](const std::string& words) { setColumns(words, a.options); },
      "Which columns hold what, by name, number or A-B: time scan x y z w heading qx qy qz qw "
      "ranges; arrays by name: ranges points time poses angles",
      "ROLE=COLUMN,...");
  text(
      "--units", [&a](const std::string& words) { setUnits(words, a.options); },
      "Of lengths, times and angles (default: as they look)", "m|cm|mm,s|ms|us|ns,rad|deg");
  text(
      "--angles", [&a](const std::string& words) { setAngles(words, a.options); },
      "Directions of the ranges, degrees, 0 ahead, positive to the left; a STEP below 0 counts "
      "clockwise",
      "FIRST:STEP");
  addNumber(*command, "--rate", a.options.rate_hz, 1e-3, 1e4,
            "Scans a second, where there are no times");
  addNumber(*command, "--max-range", a.options.most_range_m, 0.1, 1e4,
            "Nothing came back from N metres on");
  text(
      "--sensor",
      [&a](const std::string& place) {
        a.options.sensor = parseSensorPlace(place);
        a.topics["sensor"] = place;
      },
      "Where on the robot the scanner (of a bag without scans and points: the camera) is, x ahead, "
      "y left, z up, metres, and how far it is turned to the left, degrees (default: as the file "
      "says)",
      "X,Y,Z[,YAW]");
  for (const auto& [role, what] : std::initializer_list<std::pair<const char*, const char*>>{
           {"left", "images of the left camera"},
           {"right", "images of the right camera"},
           {"scan", "a LaserScan"},
           {"points", "a PointCloud2"},
           {"odometry", "poses in the odometry frame"},
           {"truth", "true poses, for scoring"}}) {
    text((std::string("--") + role).c_str(),
         [&a, role = std::string(role)](const std::string& topic) { a.topics[role] = topic; },
         (std::string("Of a bag: ") + what + ", or none (default: by names and types)").c_str(),
         "TOPIC");
  }
  addQuiet(*command, a.quiet);
}

}  // namespace handmap
