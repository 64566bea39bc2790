#include "core/report/report_data.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/evaluation/common_shift.h"
#include "core/map/map_io.h"
#include "core/recording/image_file.h"

namespace handmap {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostPictures = 40;
constexpr int kPictureWidth = 240;
constexpr std::size_t kMostClouds = 400;
constexpr std::size_t kMostParticles = 100;  // of a cloud
constexpr std::size_t kMostFrames = 1'000'000;

double rounded(double value, double unit) { return std::round(value / unit) * unit; }

Json outlineJson(const Polygon& outline) {
  Json points = Json::array();
  for (const Vec2& p : outline) points.push_back({rounded(p.x(), 1e-3), rounded(p.y(), 1e-3)});
  return points;
}

Json buildingsJson(const ReportInputs& inputs) {
  const std::vector<WallTolerance> walls = tolerancesOf(inputs.drawing, inputs.refined);
  Json all = Json::array();
  for (const Building& building : inputs.refined.buildings) {
    Json one = {{"id", building.id},
                {"name", building.name},
                {"refined", outlineJson(building.footprint())},
                {"walls", Json::array()}};
    if (const Building* drawn = inputs.drawing.find(building.id)) {
      one["drawn"] = outlineJson(drawn->footprint());
      one["moved_m"] = rounded((building.box().centre - drawn->box().centre).norm(), 1e-3);
    }
    if (building.doubt) one["doubt"] = *building.doubt;
    if (building.estimate) one["observations"] = building.estimate->observations;
    for (const WallTolerance& wall : walls) {
      if (wall.building != building.id) continue;
      one["walls"].push_back({{"sigma", wall.sigma}, {"seen", wall.seen}, {"within", wall.within}});
    }
    all.push_back(std::move(one));
  }
  return all;
}

Json surveyJson(const Survey& survey) {
  return {{"buildings", survey.buildings},
          {"present", survey.present},
          {"walls", survey.walls},
          {"rms_before_m", survey.rms_before_m},
          {"rms_after_m", survey.rms_after_m},
          {"within_before", survey.within_before},
          {"within_after", survey.within_after}};
}

/// time x y heading, σ of these.
Json framesJson(const JsonValue& run) {
  Json frames = Json::array();
  for (const JsonValue& frame : run.at("frames").items(kMostFrames)) {
    Json row = {frame.at("time_s").number(-1e12, 1e12)};
    for (const char* key : {"pose", "pose_sigma"}) {
      const auto values = frame.at(key).items(3);
      if (values.size() != 3) frame.at(key).fail("[x, y, heading]");
      for (const JsonValue& value : values) row.push_back(rounded(value.number(-1e9, 1e9), 1e-4));
    }
    frames.push_back(std::move(row));
  }
  if (frames.empty()) run.at("frames").fail("[]", "[{…}, …]");
  return frames;
}

/// time x y x y …, evenly of the run and of each cloud.
Json particlesJson(const std::vector<ReportedParticles>& particles) {
  Json clouds = Json::array();
  const std::size_t step = particles.size() / kMostClouds + 1;
  for (std::size_t i = 0; i < particles.size(); i += step) {
    Json row = {particles[i].time_s};
    const std::vector<Vec2>& points = particles[i].points;
    const std::size_t each = points.size() / kMostParticles + 1;
    for (std::size_t k = 0; k < points.size(); k += each) {
      row.push_back(rounded(points[k].x(), 1e-2));
      row.push_back(rounded(points[k].y(), 1e-2));
    }
    clouds.push_back(std::move(row));
  }
  return clouds;
}

std::string base64(const std::vector<unsigned char>& bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8U | (i + k < bytes.size() ? bytes[i + k] : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : kDigits[group >> (18U - 6U * k) & 63U];
    }
  }
  return text;
}

/// Of the left camera, small, evenly over the time of the run.
Json picturesJson(const Recording& recording, double first_s, double last_s) {
  std::vector<const FrameRow*> rows;
  for (const FrameRow& row : recording.rows) {
    if (!row.left.empty() && row.time_s >= first_s && row.time_s <= last_s) rows.push_back(&row);
  }
  Json pictures = Json::array();
  const std::size_t step = rows.size() / kMostPictures + 1;
  for (std::size_t i = 0; i < rows.size(); i += step) {
    cv::Mat image;
    try {
      image = readImage(recording.folder / rows[i]->left);
    } catch (const Error&) {
      continue;  // a run passes over it, too
    }
    const double scale = static_cast<double>(kPictureWidth) / image.cols;
    cv::resize(image, image, {}, scale, scale, cv::INTER_AREA);
    std::vector<unsigned char> bytes;
    cv::imencode(".jpg", image, bytes, {cv::IMWRITE_JPEG_QUALITY, 60});
    pictures.push_back({{"time_s", rows[i]->time_s}, {"jpeg", base64(bytes)}});
  }
  return pictures;
}

}  // namespace

nlohmann::ordered_json reportData(const ReportInputs& inputs) {
  const auto parsed = parseJson(inputs.run, inputs.run_file);
  const JsonValue run(parsed, inputs.run_file);
  Json data = {{"title", inputs.drawing.name},  {"program", "handmap " HANDMAP_VERSION},
               {"tolerances_m", kTolerances_m}, {"buildings", buildingsJson(inputs)},
               {"frames", framesJson(run)},     {"run", Json::object()}};
  for (const char* key : {"program", "recording", "settings", "wall_s", "warnings", "skipped"}) {
    if (parsed.contains(key)) data["run"][key] = parsed[key];
  }
  if (const auto common = commonShiftOf(inputs.drawing, inputs.refined)) {
    data["common"] = {{"x", common->shift.x()},
                      {"y", common->shift.y()},
                      {"sigma_x", common->shift_sigma.x()},
                      {"sigma_y", common->shift_sigma.y()},
                      {"turn_deg", toDegrees(common->turn)},
                      {"sigma_turn_deg", toDegrees(common->turn_sigma)},
                      {"own_m", common->own},
                      {"buildings", common->buildings}};
  }
  data["particles"] = particlesJson(inputs.particles);
  data["truth"] = Json::array();
  if (inputs.truth) {
    for (const Building& building : inputs.truth->buildings) {
      data["truth"].push_back(outlineJson(building.footprint()));
    }
    data["survey"] = surveyJson(surveyOf(inputs.drawing, inputs.refined, *inputs.truth));
  }
  data["pictures"] = Json::array();
  if (inputs.recording) {
    const Json& frames = data["frames"];
    data["pictures"] = picturesJson(*inputs.recording, frames.front()[0].get<double>() - 1e-3,
                                    frames.back()[0].get<double>() + 1e-3);
  }
  data["files"] = {{"drawing.handmap", formatMap(inputs.drawing)},
                   {"refined.handmap", formatMap(inputs.refined)},
                   {"walls.csv", tolerancesCsv(inputs.drawing, inputs.refined)},
                   {"walls.tex", tolerancesLatex(inputs.drawing, inputs.refined)},
                   {"report.json", inputs.run}};
  if (!inputs.trajectory.empty()) data["files"]["trajectory.tum"] = formatTum(inputs.trajectory);
  return data;
}

}  // namespace handmap
