#include "app/cli/options.h"

#include <filesystem>
#include <set>

#include <fmt/format.h>
#include <unistd.h>

#include "core/base/error.h"
#include "core/base/text.h"

namespace handmap {

namespace fs = std::filesystem;

CLI::Validator inRange(double low, double high) {
  const std::string range = fmt::format("{} to {}", low, high);
  return CLI::Validator(
      [=](const std::string& text) -> std::string {
        const std::optional<double> value = parseFinite(text);
        if (value && *value >= low && *value <= high) return {};
        return fmt::format("found {}, expected a number from {}", text, range);
      },
      range);
}

CLI::Option* addPair(CLI::App& command, const std::string& name,
                     const std::function<void(double, double)>& take, double first_high,
                     double second_high, const std::string& words, const std::string& text) {
  const std::string range = fmt::format("0,0 to {},{}", first_high, second_high);
  const auto read = [=](const std::string& word) {
    const std::size_t comma = std::min(word.find(','), word.size());
    const auto first = parseFinite(word.substr(0, comma));
    const auto second = parseFinite(word.substr(std::min(comma + 1, word.size())));
    if (first && second && *first >= 0.0 && *first <= first_high && *second >= 0.0 &&
        *second <= second_high) {
      return take(*first, *second);
    }
    throw CLI::ValidationError(name,
                               fmt::format("found {}, expected {} from {}", word, words, range));
  };
  return command.add_option_function<std::string>(name, read, fmt::format("{} ({})", text, range))
      ->option_text(words);
}

void addMisdrawing(CLI::App& command, Misdrawing& misdrawing) {
  addNumber(command, "--wrong", misdrawing.wrong, 0, 1000,
            "So many buildings drawn that are not there, and as many left out");
  const auto off = [&misdrawing](double metres, double degrees) {
    misdrawing.start_m = metres;
    misdrawing.start_turn_rad = toRadians(degrees);
  };
  addPair(command, "--start-off", off, 100, 90, "M,DEG",
          "The drawn start is off by metres and degrees, and says so");
}

void addFrames(CLI::App& command, ReplayOptions& replay, const std::string& every_text) {
  constexpr double kLastFrame = 2147483647;
  addNumber(command, "--from", replay.from, 0, kLastFrame, "First frame number");
  addNumber(command, "--to", replay.to, 0, kLastFrame, "Last frame number");
  addNumber(command, "--every", replay.every, 1, 1e6, every_text);
}

CLI::Option* addSeed(CLI::App& command, std::uint64_t& seed, const std::string& text) {
  const auto check = [](const std::string& word) -> std::string {
    const bool whole = word.find_first_not_of("0123456789") == std::string::npos;
    return whole ? "" : fmt::format("found {}, expected a whole number from 0", word);
  };
  return command.add_option("--seed", seed, fmt::format("{} (default {})", text, seed))
      ->check(CLI::Validator(check, "N"))
      ->option_text("N");
}

void addBuildingClass(CLI::App& command, std::optional<int>& building_class) {
  addNumber(command, "--building-class", building_class, 0, 1000,
            "Which class of a network is a building");
}

void addQuiet(CLI::App& command, bool& quiet) {
  command.add_flag("--quiet", quiet, "Say nothing but errors on stderr");
}

void checkOutputFiles(const std::vector<std::string>& outputs,
                      const std::vector<std::string>& inputs, NewOdometry odometry) {
  std::error_code error;
  std::set<fs::path> taken;
  for (const std::string& path : outputs) {
    if (path.empty()) continue;
    const auto refuse = [&](const std::string& reason) {
      throw Error(ErrorCode::Usage, fmt::format("{}: cannot be written: {}", path, reason));
    };
    const fs::path folder = fs::absolute(path).parent_path();
    if (!fs::is_directory(folder, error)) refuse("no such folder");
    if (fs::is_directory(path, error)) refuse("it is a folder");
    if (access(folder.c_str(), W_OK) != 0) refuse("no permission to write to the folder");
    for (const std::string& input : inputs) {
      const bool is_inside = fs::exists(path, error) && fs::equivalent(folder, input, error);
      if (is_inside || fs::equivalent(path, input, error)) {
        refuse("it is an input, and inputs are kept");
      }
    }
    refuseFileOfRecording(path, odometry);
    if (!taken.insert(fs::weakly_canonical(fs::absolute(path), error)).second) {
      refuse("another output goes there");
    }
  }
}

void checkOutputFolder(const std::string& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return;
  if (fs::is_directory(path, error) && fs::is_empty(path, error)) return;
  throw Error(
      ErrorCode::Usage,
      fmt::format("{}: found something there, expected a new folder or an empty one", path));
}

}  // namespace handmap
