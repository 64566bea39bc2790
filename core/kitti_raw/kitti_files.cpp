#include "core/kitti_raw/kitti_files.h"

#include <array>
#include <chrono>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/geometry/pose2.h"

namespace handmap {

namespace {

constexpr std::uintmax_t kMostText = 64u << 20;
constexpr std::uintmax_t kMostScan = 64u << 20;
constexpr double kMostNumber = 1e9;
constexpr std::size_t kFixNumbers = 6;  // latitude, longitude, altitude, roll, pitch, yaw
constexpr double kRotationOff = 0.01;

std::optional<double> secondsOf(std::string_view text) {
  // 2011-09-26 13:04:34.977012964
  if (text.size() < 19 || text[4] != '-' || text[7] != '-' || text[10] != ' ' || text[13] != ':' ||
      text[16] != ':') {
    return std::nullopt;
  }
  const auto year = parseInteger(text.substr(0, 4));
  const auto month = parseInteger(text.substr(5, 2));
  const auto day = parseInteger(text.substr(8, 2));
  const auto hour = parseInteger(text.substr(11, 2));
  const auto minute = parseInteger(text.substr(14, 2));
  const auto second = parseFinite(text.substr(17));
  if (!year || !month || !day || !hour || !minute || !second) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(static_cast<int>(*year)),
                                         std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day))};
  const bool is_time =
      *hour >= 0 && *hour < 24 && *minute >= 0 && *minute < 60 && *second >= 0.0 && *second < 61.0;
  if (!date.ok() || !is_time) return std::nullopt;
  const auto days = std::chrono::sys_days(date).time_since_epoch().count();
  return static_cast<double>(days) * 86400.0 + static_cast<double>(*hour * 3600 + *minute * 60) +
         *second;
}

std::string shown(std::string_view text) { return '"' + std::string(text.substr(0, 40)) + '"'; }

}  // namespace

std::vector<double> readKittiTimestamps(const std::filesystem::path& path) {
  const std::string content = readFile(path, kMostText);
  std::vector<double> times;
  ContentLines lines(content);
  while (const auto line = lines.next()) {
    const auto time_s = secondsOf(trimmed(line->text));
    if (!time_s || (!times.empty() && *time_s <= times.back())) {
      throwBadInput(path.string(), phrase("line {}", line->number), shown(line->text),
                    phrase("a later time, 2011-09-26 13:02:25.594360375"));
    }
    times.push_back(*time_s);
  }
  return times;
}

KittiCalibration::KittiCalibration(const std::filesystem::path& path) : file_(path.string()) {
  const std::string content = readFile(path, kMostText);
  ContentLines lines(content);
  while (const auto line = lines.next()) {
    const std::size_t colon = line->text.find(':');
    if (colon == std::string_view::npos) continue;
    std::vector<double> numbers;
    for (const std::string_view word : splitWords(line->text.substr(colon + 1))) {
      const auto number = parseFinite(word);
      if (!number || std::abs(*number) > kMostNumber) {
        numbers.clear();  // a date or a name
        break;
      }
      numbers.push_back(*number);
    }
    entries_[std::string(trimmed(line->text.substr(0, colon)))] = std::move(numbers);
  }
}

const std::vector<double>& KittiCalibration::numbers(const std::string& key,
                                                     std::size_t count) const {
  const auto entry = entries_.find(key);
  const std::size_t found = entry == entries_.end() ? 0 : entry->second.size();
  if (found != count) {
    throwBadInput(file_, key, phrase("{} numbers", found), fmt::format("{}", count));
  }
  return entry->second;
}

Eigen::Isometry3d KittiCalibration::transform() const {
  const Eigen::Matrix3d rotation =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(numbers("R", 9).data());
  const bool is_rotation =
      (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm() < kRotationOff &&
      rotation.determinant() > 0.0;
  if (!is_rotation) {
    throwBadInput(file_, "R", phrase("no rotation matrix"), phrase("an orthonormal one"));
  }
  Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
  transform.linear() = rotation;
  transform.translation() = Eigen::Map<const Eigen::Vector3d>(numbers("T", 3).data());
  return transform;
}

KittiFix readKittiFix(const std::filesystem::path& path) {
  const std::string content = readFile(path, kMostText);
  const auto words = splitWords(std::string_view(content).substr(0, content.find('\n')));
  std::array<double, kFixNumbers> numbers{};
  for (std::size_t i = 0; i < kFixNumbers; ++i) {
    const auto number = i < words.size() ? parseFinite(words[i]) : std::nullopt;
    if (!number) {
      throwBadInput(path.string(), phrase("line {}", 1), phrase("{} numbers", i),
                    phrase("latitude, longitude, altitude, roll, pitch and yaw"));
    }
    numbers[i] = *number;
  }
  if (std::abs(numbers[0]) > 85.0 || std::abs(numbers[1]) > 180.0) {
    throwBadInput(path.string(), phrase("line {}", 1),
                  fmt::format("{:g}, {:g}", numbers[0], numbers[1]),
                  phrase("latitude and longitude in degrees"));
  }
  return {numbers[0], numbers[1], normalizedAngle(numbers[5])};
}

std::vector<RangePoint> readKittiScan(const std::filesystem::path& path, std::size_t stride) {
  const std::string bytes = readFile(path, kMostScan);
  constexpr std::size_t kPoint = 4 * sizeof(float);  // x, y, z, how bright
  if (bytes.size() % kPoint != 0) {
    throwBadInput(path.string(), "", phrase("{} bytes", bytes.size()),
                  phrase("a multiple of {}", kPoint));
  }
  std::vector<RangePoint> points;
  points.reserve(bytes.size() / kPoint / stride + 1);
  for (std::size_t at = 0; at < bytes.size(); at += stride * kPoint) {
    std::array<float, 3> p{};
    std::memcpy(p.data(), bytes.data() + at, sizeof(p));
    const bool is_point = std::isfinite(p[0] + p[1] + p[2]) && std::abs(p[0]) < 1e4F &&
                          std::abs(p[1]) < 1e4F && std::abs(p[2]) < 1e4F;
    if (is_point) points.push_back({p[0], p[1], p[2], 1.0F});
  }
  return points;
}

}  // namespace handmap
