#include "core/experiments/trial_table.h"

#include <cmath>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/text.h"

namespace handmap {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kMethods = {Method::Handmap, Method::Paper};
constexpr std::array kMeasures = {"x", "front", "width"};
constexpr double kMost_m = 1e6;
constexpr std::size_t kMostSteps = 100000;

Json toJson(const TrialSettings& settings) {
  Json json = {{"program", "handmap " HANDMAP_VERSION},
               {"seed", settings.seed},
               {"slam_particles", settings.slam_particles},
               {"pso_particles", settings.pso_particles},
               {"drawings_keep_side_and_order", settings.keeping == Keeping::SideAndOrder}};
  if (settings.like == Like::People) json["drawings_like"] = "people";
  return json;
}

std::string columns() {
  std::string names = "method,sigma_m,trial";
  for (const std::string id : Trial::kBuildings) {
    for (const char* measure : kMeasures) names += fmt::format(",{}_drawn_{}", id, measure);
    for (const char* measure : kMeasures) names += fmt::format(",{}_{}", id, measure);
    names += fmt::format(",{0}_iou,{0}_overlaps", id);
  }
  return names + ",pose_odometry_map";
}

std::string rounded(double value) {
  return formatNumber(std::round(value * 1000.0) / 1000.0 + 0.0);
}

/// One line of a table, field by field.
class LineReader {
 public:
  LineReader(std::string_view line, std::string source, int number)
      : fields_(splitFields(line, ',')), source_(std::move(source)), number_(number) {}

  Trial trial() {
    constexpr std::size_t kFields = 4 + 8 * Trial::kBuildings.size();
    if (fields_.size() != kFields) {
      fail(fmt::format("{} fields", fields_.size()), fmt::format("{}", kFields));
    }
    Trial trial;
    trial.key = {method(), number(0.0, kMost_m), static_cast<int>(whole(2147483647))};
    for (TrialBuilding& building : trial.buildings) {
      for (double& measure : building.drawn) measure = number(-kMost_m, kMost_m);
      for (double& measure : building.found) measure = number(-kMost_m, kMost_m);
      building.iou = number(0.0, 1.0);
      building.overlaps = whole(1) != 0;
    }
    trial.way = way();
    return trial;
  }

 private:
  [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
    throwBadInput(source_, fmt::format("line {}", number_), found, expected);
  }

  Method method() {
    const std::string_view word = fields_[next_++];
    for (const Method method : kMethods) {
      if (word == nameOf(method)) return method;
    }
    fail(quotedJson(word.substr(0, 40)), "handmap or paper");
  }

  double inRange(std::string_view word, double low, double high) const {
    const std::optional<double> value = parseFinite(word);
    if (value && *value >= low && *value <= high) return *value;
    fail(quotedJson(word.substr(0, 40)), fmt::format("a number from {} to {}", low, high));
  }

  double number(double low, double high) { return inRange(fields_[next_++], low, high); }

  std::int64_t whole(std::int64_t most) {
    const std::string_view word = fields_[next_++];
    const std::optional<std::int64_t> value = parseInteger(word);
    if (value && *value >= 0 && *value <= most) return *value;
    fail(quotedJson(word.substr(0, 40)), fmt::format("a whole number from 0 to {}", most));
  }

  std::vector<TrialStep> way() {
    const std::vector<std::string_view> words = splitWords(fields_[next_++]);
    if (words.empty() || words.size() % 3 != 0 || words.size() / 3 > kMostSteps) {
      fail(fmt::format("{} numbers of the way", words.size()), "three a step");
    }
    std::vector<TrialStep> steps;
    for (std::size_t i = 0; i < words.size(); i += 3) {
      steps.push_back({inRange(words[i], 0.0, kMost_m), inRange(words[i + 1], 0.0, kMost_m),
                       inRange(words[i + 2], 0.0, kMost_m)});
    }
    return steps;
  }

  std::vector<std::string_view> fields_;
  std::string source_;
  int number_;
  std::size_t next_ = 0;
};

/// The settings of a table are those wanted.
void checkSettings(std::string_view line, const std::string& source,
                   const TrialSettings& settings) {
  if (!line.starts_with("# ")) {
    throwBadInput(source, "line 1", "no settings", "a table of trials");
  }
  const nlohmann::json json = parseJson(line.substr(2), source + ": line 1");
  const JsonValue found(json, source + ": line 1");
  const auto refuse = [&](const std::string& key, const std::string& there,
                          const std::string& expected) {
    throw Error(ErrorCode::BadInput,
                fmt::format("{}: line 1: {}: found {}, expected {}", source, key, there, expected),
                "a folder holds trials of one setting: take the same, or another folder");
  };
  const Json wanted = toJson(settings);
  for (const auto& [key, value] : wanted.items()) {
    const auto there = found.find(key);
    if (!there) refuse(key, "nothing", value.dump());
    if (there->dump() != value.dump()) refuse(key, there->dump(), value.dump());
  }
  for (const auto& [key, there] : found.others({})) {
    if (!wanted.contains(key)) refuse(key, there, "nothing");
  }
}

}  // namespace

const char* nameOf(Method method) { return method == Method::Paper ? "paper" : "handmap"; }

std::string trialTableHead(const TrialSettings& settings) {
  return "# " + toJson(settings).dump() + "\n" + columns() + "\n";
}

std::string trialLine(const Trial& trial) {
  std::string line = fmt::format("{},{},{}", nameOf(trial.key.method),
                                 formatNumber(trial.key.sigma_m), trial.key.number);
  for (const TrialBuilding& building : trial.buildings) {
    for (const double measure : building.drawn) line.append(1, ',').append(rounded(measure));
    for (const double measure : building.found) line.append(1, ',').append(rounded(measure));
    // Downwards, so that an IoU that is too small never becomes one that is not.
    line += fmt::format(",{},{}", formatNumber(std::floor(building.iou * 1e4) / 1e4),
                        building.overlaps ? 1 : 0);
  }
  char separator = ',';
  for (const TrialStep& step : trial.way) {
    line += separator + rounded(step.pose) + " " + rounded(step.odometry) + " " + rounded(step.map);
    separator = ' ';
  }
  return line + "\n";
}

std::vector<Trial> parseTrials(std::string_view text, const std::string& source,
                               const TrialSettings& settings) {
  std::vector<Trial> trials;
  int number = 0;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string_view::npos) return trials;
    const std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    if (number == 1) {
      checkSettings(line, source, settings);
    } else if (number == 2) {
      if (line != columns())
        throwBadInput(source, "line 2", "other columns", "those of this version");
    } else {
      trials.push_back(LineReader(line, source, number).trial());
    }
  }
}

}  // namespace handmap
