#include "core/recording/calibration.h"

#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"

namespace handmap {

namespace {

using Projection = std::array<double, 12>;

constexpr std::uintmax_t kMaxKittiCalibrationBytes = 1u << 20;
constexpr double kMaxIntrinsic_px = 1e5;
constexpr double kMaxBaseline = 100.0;
constexpr double kTolerance = 1e-3;  // relative or pixels: rectified images agree to that

Projection parseProjection(std::string_view numbers, const std::string& file,
                           const std::string& place) {
  const auto words = splitWords(numbers);
  Projection p{};
  if (words.size() != p.size()) {
    throwBadInput(file, place, phrase("{} numbers", words.size()), "12");
  }
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto value = parseFinite(words[i]);
    if (!value) {
      throwBadInput(file, place, fmt::format("\"{}\"", words[i].substr(0, 40)),
                    phrase("a finite number"));
    }
    p[i] = *value;
  }
  const bool is_pinhole = p[0] > 1.0 && p[0] < kMaxIntrinsic_px && p[5] > 1.0 &&
                          p[5] < kMaxIntrinsic_px && std::abs(p[2]) < kMaxIntrinsic_px &&
                          std::abs(p[6]) < kMaxIntrinsic_px && p[1] == 0.0 && p[4] == 0.0 &&
                          p[8] == 0.0 && p[9] == 0.0 && p[10] == 1.0;
  if (!is_pinhole) {
    throwBadInput(file, place, phrase("no projection matrix of a rectified camera"),
                  "fx 0 cx tx  0 fy cy ty  0 0 1 tz");
  }
  return p;
}

Projection findProjection(std::string_view content, const std::string& name,
                          const std::string& file) {
  std::optional<Projection> found;
  ContentLines lines(content);
  while (const auto line = lines.next()) {
    const auto colon = line->text.find(':');
    if (colon == std::string_view::npos || trimmed(line->text.substr(0, colon)) != name) continue;
    const std::string place = phrase("line {}", line->number) + ": " + name;
    if (found) throwBadInput(file, place, phrase("this matrix twice"), phrase("it once"));
    found = parseProjection(line->text.substr(colon + 1), file, place);
  }
  if (!found) {
    throwBadInput(file, "", phrase("no line {}:", name), phrase("the 12 numbers of the camera"));
  }
  return *found;
}

void requireSame(double left, double right, const char* what, const std::string& file) {
  if (std::abs(left - right) <= kTolerance * std::max(1.0, std::abs(left))) return;
  throwBadInput(file, what, phrase("{} left and {} right", left, right),
                phrase("the same for both cameras of a rectified pair"));
}

/// How far right of the camera that the matrices count from.
double offsetOf(const Projection& p) { return -p[3] / p[0]; }

}  // namespace

StereoCamera readCalibration(const std::filesystem::path& path, const std::string& left,
                             const std::string& right, const CameraMount& mount) {
  const std::string file = path.string();
  const std::string content = readFile(path, kMaxKittiCalibrationBytes);
  const Projection l = findProjection(content, left, file);
  const Projection r = findProjection(content, right, file);
  requireSame(l[0], r[0], "fx", file);
  requireSame(l[5], r[5], "fy", file);
  requireSame(l[2], r[2], "cx", file);
  requireSame(l[6], r[6], "cy", file);

  StereoCamera camera{l[0], l[5], l[2], l[6], offsetOf(r) - offsetOf(l), mount};
  if (!(camera.baseline > 0.0 && camera.baseline <= kMaxBaseline)) {
    throwBadInput(file, phrase("{} and {}", left, right),
                  phrase("a baseline of {:.4g} m", camera.baseline),
                  phrase("one > 0 and at most {:g} m: the right camera to the right of the "
                         "left one",
                         kMaxBaseline));
  }
  camera.mount.x += offsetOf(l) * std::sin(mount.yaw);
  camera.mount.y -= offsetOf(l) * std::cos(mount.yaw);
  return camera;
}

std::string formatCalibration(const StereoCamera& camera) {
  const std::string fx = formatNumber(camera.fx);
  const auto line = [&](const char* name, double tx) {
    return fmt::format("{}: {} 0 {} {} 0 {} {} 0 0 0 1 0\n", name, fx, formatNumber(camera.cx),
                       formatNumber(tx), formatNumber(camera.fy), formatNumber(camera.cy));
  };
  return line("P0", 0.0) + line("P1", -camera.fx * camera.baseline);
}

}  // namespace handmap
