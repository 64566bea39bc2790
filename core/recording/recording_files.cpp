#include "core/recording/recording_files.h"

#include <algorithm>
#include <array>
#include <string>

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"

namespace handmap {

namespace fs = std::filesystem;

namespace {

constexpr std::array kNames = {"recording.json", "frames.csv", "odometry.tum",
                               "truth.tum",      "calib.txt",  "acts.jsonl"};
constexpr std::array kKittiNames = {"times.txt", "calib.txt", "poses.txt"};
constexpr std::size_t kMostBytes = 64U << 20U;  // of what says which files it has

std::string lowered(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) {
    return c < 0x80 ? static_cast<char>(std::tolower(c)) : static_cast<char>(c);
  });
  return text;
}

bool isThere(const fs::path& file) {
  std::error_code error;
  return fs::exists(file, error);
}

/// Empty where it cannot be read: what it would say is then not known.
std::string contentOf(const fs::path& file) {
  try {
    return readFile(file, kMostBytes);
  } catch (const Error&) {
    return {};
  }
}

bool isKitti(const fs::path& folder) {
  return isThere(folder / "times.txt") && isThere(folder / "calib.txt");
}

bool isRecording(const fs::path& folder) {
  return isThere(folder / "recording.json") || isThere(folder / "frames.csv") || isKitti(folder);
}

template <typename Names>
bool contains(const Names& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

/// One of the cells of frames.csv.
bool isInTable(const fs::path& folder, const std::string& lowered_name) {
  const std::string table = lowered(contentOf(folder / "frames.csv"));
  for (std::size_t at = table.find(lowered_name); at != std::string::npos;
       at = table.find(lowered_name, at + 1)) {
    const std::size_t end = at + lowered_name.size();
    const bool begins = at == 0 || table[at - 1] == ',' || table[at - 1] == '\n';
    const bool ends = end == table.size() ||
                      std::string_view(",@\r\n ").find(table[end]) != std::string_view::npos;
    if (begins && ends) return true;
  }
  return false;
}

bool isCalibration(const fs::path& folder, const std::string& lowered_name) {
  const auto json = nlohmann::json::parse(contentOf(folder / "recording.json"), nullptr, false);
  if (!json.is_object() || !json.contains("camera") || !json["camera"].is_object()) return false;
  const auto& camera = json["camera"];
  return camera.contains("calibration") && camera["calibration"].is_string() &&
         lowered(camera["calibration"].get<std::string>()) == lowered_name;
}

/// `inside`: from the folder on.
bool belongs(const fs::path& folder, const fs::path& inside) {
  const std::string name = lowered(inside.generic_string());
  if (contains(kNames, name)) return true;
  if (isKitti(folder) && (contains(kKittiNames, name) || name.starts_with("image_"))) {
    return true;
  }
  // Beside a points file lie the ids of its points.
  const std::string points =
      name.ends_with(".ids") ? name.substr(0, name.size() - 3) + "bin" : name;
  return isInTable(folder, name) || isInTable(folder, points) || isCalibration(folder, name);
}

std::optional<fs::path> recordingAround(const fs::path& file) {
  for (fs::path folder = file.parent_path(); folder.has_relative_path();
       folder = folder.parent_path()) {
    if (isRecording(folder) && belongs(folder, file.lexically_relative(folder))) return folder;
  }
  return std::nullopt;
}

}  // namespace

std::optional<fs::path> recordingOf(const fs::path& file) {
  std::error_code error;
  const fs::path here = fs::absolute(file, error).lexically_normal();
  if (auto folder = recordingAround(here)) return folder;
  const fs::path behind_links = fs::weakly_canonical(here, error);
  return error ? std::nullopt : recordingAround(behind_links);
}

void refuseFileOfRecording(const fs::path& output, NewOdometry odometry) {
  const auto folder = recordingOf(output);
  if (!folder) return;
  const bool is_odometry = lowered(output.filename().string()) == "odometry.tum";
  if (odometry == NewOdometry::Allowed && is_odometry && !isThere(output)) return;
  throw Error(
      ErrorCode::BadInput,
      phrase("{}: found a file of the recording {}, expected another place for what is written",
             output.string(), folder->string()));
}

}  // namespace handmap
