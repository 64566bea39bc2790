#include <cmath>

#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/logs/raw_scans.h"
#include "core/logs/table_log.h"

namespace handmap {

namespace {

constexpr std::size_t kMostRays = 20'000;
constexpr std::string_view kLaser = "FLASER";
constexpr std::string_view kRobotLaser = "ROBOTLASER1";
constexpr std::string_view kOdometry = "ODOM";

class CarmenLine {
 public:
  CarmenLine(const TextLine& line, const std::string& file)
      : file_(file), line_(line.number), words_(splitWords(line.text)) {}

  std::string_view kind() const { return words_.empty() ? std::string_view() : words_.front(); }

  double number(std::size_t i) const {
    const auto value = i < words_.size() ? parseFinite(words_[i]) : std::nullopt;
    if (value) return *value;
    throwBadInput(file_, phrase("line {}", line_),
                  i < words_.size() ? fmt::format("\"{}\"", words_[i].substr(0, 40))
                                    : phrase("{} fields", words_.size()),
                  phrase("a number in field {} of {}", i + 1, kind()));
  }

  std::size_t count(std::size_t i) const {
    const double value = number(i);
    if (value >= 0.0 && value <= kMostRays && value == std::floor(value)) {
      return static_cast<std::size_t>(value);
    }
    throwBadInput(file_, phrase("line {}", line_), formatNumber(value),
                  phrase("how many ranges follow, at most {}", kMostRays));
  }

  std::vector<double> numbers(std::size_t first, std::size_t count) const {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(number(first + i));
    return values;
  }

 private:
  const std::string& file_;
  int line_;
  std::vector<std::string_view> words_;
};

/// FLASER n r… x y theta odom_x odom_y odom_theta time host logger_time
void addLaser(const CarmenLine& line, RawLog& raw) {
  const std::size_t count = line.count(1);
  const std::size_t odometry = 2 + count + 3;
  const double time = line.number(odometry + 3);
  raw.scans.push_back({time, line.numbers(2, count), {}});
  raw.poses.push_back(
      {time, line.number(odometry), line.number(odometry + 1), line.number(odometry + 2)});
}

/// ROBOTLASER1 type start fov step most accuracy remission n r… m e… laser pose, robot pose, five
/// more, time host logger_time
void addRobotLaser(const CarmenLine& line, RawLog& raw) {
  const std::size_t count = line.count(8);
  const std::size_t remissions = line.count(9 + count);
  const std::size_t laser = 10 + count + remissions;
  const double time = line.number(laser + 11);
  raw.angles = RayAngles{line.number(2), line.number(4)};
  raw.most_range_m = line.number(5);
  raw.scans.push_back({time, line.numbers(9, count), {}});
  raw.poses.push_back({time, line.number(laser), line.number(laser + 1), line.number(laser + 2)});
}

}  // namespace

bool isCarmen(std::string_view content) {
  ContentLines lines(content);
  for (int i = 0; i < 100; ++i) {
    const auto line = lines.next();
    if (!line) return false;
    const auto words = splitWords(line->text);
    if (words.empty()) continue;
    if (words[0] == kLaser || words[0] == kRobotLaser || words[0] == kOdometry) return true;
    if (words[0] != "PARAM" && words[0] != "SYNC" && words[0] != "RLASER") return false;
  }
  return false;
}

void addCarmen(std::string_view content, const std::string& file, const LogOptions& options,
               const std::stop_token& stop, Log& log) {
  RawLog raw;
  raw.file = file;
  raw.metres = raw.pose_metres = 1.0;
  raw.seconds = 1.0;
  raw.radians = 1.0;
  std::vector<RawPose> odometry;
  ContentLines lines(content);
  while (const auto text = lines.next()) {
    throwIfStopped(stop);
    const CarmenLine line(*text, file);
    if (line.kind() == kLaser) addLaser(line, raw);
    if (line.kind() == kRobotLaser) addRobotLaser(line, raw);
    if (line.kind() == kOdometry) {
      odometry.push_back({line.number(7), line.number(1), line.number(2), line.number(3)});
    }
  }
  if (raw.poses.empty()) raw.poses = std::move(odometry);  // else each scan has its own
  addRaw(raw, options, log);
}

}  // namespace handmap
