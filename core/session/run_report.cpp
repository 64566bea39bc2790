#include "core/session/run_report.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <nlohmann/json.hpp>

#include "core/base/text.h"
#include "core/method/pose_trust.h"

namespace handmap {

namespace {

using Json = nlohmann::ordered_json;

const char* methodName(const RunSettings& settings) {
  if (!settings.slam.refine) return "localization";
  return settings.method == Method::Paper ? "paper" : "handmap";
}

Json settingsJson(const RunSettings& settings) {
  const SlamOptions& slam = settings.slam;
  const StereoOptions& stereo = settings.perception.stereo;
  const LocalMapOptions& local_map = settings.perception.local_map;
  const PerceptionOptions& perception = settings.perception;
  const char* classifier = !perception.classify    ? "none"
                           : perception.classifier ? "own"
                                                   : "built-in";
  Json free = Json::array();
  if (settings.free_scale) free.push_back("scale");
  if (settings.free_turn) free.push_back("turn");
  return {
      {"method", methodName(settings)},
      {"free", free},
      {"slam_particles", slam.slam_particles},
      {"pso_particles", slam.pso_particles},
      {"pso_iterations", slam.pso_iterations},
      {"inertia", slam.inertia},
      {"cognitive", slam.cognitive},
      {"social", slam.social},
      {"effective_ratio", slam.effective_ratio == EffectiveRatio::ToAll ? "to-all" : "to-zero"},
      {"resample_below", slam.resample_below},
      {"motion",
       {{"length_per_m", slam.motion.length_per_m},
        {"heading_per_m", slam.motion.heading_per_m},
        {"heading_per_rad", slam.motion.heading_per_rad},
        {"min_length_m", slam.motion.min_length_m},
        {"min_heading_rad", slam.motion.min_heading_rad}}},
      {"classifier", classifier},
      {"stereo",
       {{"scale", stereo.scale},
        {"num_disparities", stereo.num_disparities},
        {"block_size", stereo.block_size},
        {"sigma_disparity", stereo.sigma_disparity}}},
      {"local_map",
       {{"cell_m", local_map.cell_m},
        {"smoothing_sigma_m", local_map.smoothing_sigma_m},
        {"saturation_votes", local_map.saturation_votes},
        {"path_m", local_map.path_m}}},
  };
}

/// Probabilities to a tenth of a per cent.
double rounded(double share) { return std::round(share * 1000.0) / 1000.0; }

Json frameJson(const FrameReport& frame) {
  const StageTimes& ms = frame.ms;
  Json json{{"frame", frame.frame},
            {"time_s", frame.time_s},
            {"ms",
             {{"read", ms.read},
              {"stereo", ms.stereo},
              {"classify", ms.classify},
              {"local_map", ms.local_map},
              {"slam", ms.slam},
              {"total", ms.total}}},
            {"effective_sample_size", frame.effective_sample_size},
            {"visible_buildings", frame.visible_buildings},
            {"pose", {frame.pose.x, frame.pose.y, frame.pose.heading}},
            {"pose_sigma", frame.pose_sigma}};
  for (std::size_t i = 0; i < method::kWithin_m.size(); ++i) {
    json["within"][formatNumber(method::kWithin_m[i]) + "_m"] = rounded(frame.within[i]);
  }
  if (frame.odometry_guessed) json["odometry_guessed"] = true;
  return json;
}

/// As dump(1) has them in an object. One by one: all those of an hour at once take 250 MB.
void addFrames(const std::vector<FrameReport>& frames, std::string& text) {
  for (const FrameReport& frame : frames) {
    text += &frame == &frames.front() ? "\n" : ",\n";
    const std::string lines = frameJson(frame).dump(1);
    for (std::size_t at = 0; at < lines.size();) {
      const std::size_t end = std::min(lines.find('\n', at), lines.size() - 1) + 1;
      text.append("  ").append(lines, at, end - at);
      at = end;
    }
  }
  if (!frames.empty()) text += "\n ";
}

void addGivenPoses(const RunSettings& settings, Json& json) {
  for (const auto& [time_s, pose] : settings.given_poses) {
    json["given_poses"].push_back({time_s, pose.x, pose.y, pose.heading});
  }
}

std::string odometryOf(const RunSettings& settings, const SourceInfo& source) {
  return source.visual_odometry ? "visual" : settings.odometry;
}

}  // namespace

std::string refinementJson(const RunSettings& settings, const SourceInfo& source,
                           const std::vector<FrameReport>& frames) {
  Json json{{"program", "handmap " HANDMAP_VERSION},
            {"recording", source.name},
            {"seed", settings.seed},
            {"first_frame", frames.empty() ? 0 : frames.front().frame},
            {"last_frame", frames.empty() ? 0 : frames.back().frame},
            {"observations", frames.size()},
            {"settings", settingsJson(settings)}};
  const std::string odometry = odometryOf(settings, source);
  if (odometry != "recorded") json["odometry"] = odometry;
  addGivenPoses(settings, json);
  return json.dump();
}

std::string runReportJson(const RunRecord& run) {
  Json report{{"program", "handmap " HANDMAP_VERSION},
              {"recording", run.source.name},
              {"settings", settingsJson(run.settings)},
              {"wall_s", run.wall_s},
              {"peak_memory_mb", run.peak_memory_mb},
              {"warnings", Json::array()},
              {"skipped", Json::array()},
              {"buildings", Json::array()},
              {"frames", Json::array()}};
  report["settings"]["seed"] = run.settings.seed;
  report["settings"]["threads"] = run.settings.threads;
  report["settings"]["odometry"] = odometryOf(run.settings, run.source);
  if (run.source.speed > 0.0) report["settings"]["speed"] = run.source.speed;
  addGivenPoses(run.settings, report["settings"]);
  for (const RunWarning& warning : run.warnings) {
    report["warnings"].push_back(
        {{"code", warning.code}, {"message", warning.message}, {"hint", warning.hint}});
  }
  for (const SkippedFrame& frame : run.skipped) {
    report["skipped"].push_back({{"frame", frame.frame}, {"reason", frame.reason}});
  }
  for (const BuildingTrust& trust : trustOf(run.refined)) {
    report["buildings"].push_back({{"id", run.refined.buildings[trust.building].id},
                                   {"wall_sigma_m", trust.sigma_m},
                                   {"within_sigma", rounded(trust.within)}});
  }
  std::string text = report.dump(1);
  constexpr std::string_view kEnd = "]\n}";  // of no frames yet
  text.resize(text.size() - kEnd.size());
  addFrames(run.frames, text);
  return text.append(kEnd).append("\n");
}

}  // namespace handmap
