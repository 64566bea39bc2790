// Real drawings of people, scored against outlines made by hand.
#include <chrono>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/paper/trace.h"
#include "core/recording/image_file.h"

namespace handmap {
namespace {

struct Score {
  int found = 0;
  int missed = 0;
  int wrong = 0;
};

/// In pixels of the photo, y up. The outlines are told on a canvas of 850 × 600.
std::vector<Polygon> outlinesOf(const std::filesystem::path& file, const cv::Size& photo) {
  std::ifstream stream(file);
  std::vector<Polygon> outlines;
  const nlohmann::json json = nlohmann::json::parse(stream);
  for (const auto& feature : json["features"]) {
    if (feature["geometry"]["type"] != "Polygon") continue;
    Polygon outline;
    for (const auto& corner : feature["geometry"]["coordinates"][0]) {
      outline.push_back({corner[0].get<double>() * photo.width / 850.0,
                         corner[1].get<double>() * photo.height / 600.0});
    }
    outline.pop_back();
    if (signedArea(outline) < 0.0) std::ranges::reverse(outline);
    outlines.push_back(std::move(outline));
  }
  return outlines;
}

Score scored(const Trace& trace, const std::vector<Polygon>& truth, const cv::Size& photo) {
  Score score;
  std::vector<bool> found(truth.size(), false);
  for (const TracedShape& shape : trace.shapes) {
    if (shape.confidence < kSureOfShape) continue;
    Polygon outline;
    for (const cv::Point2d& p : onPhoto(shape.outline, trace.page)) {
      outline.push_back({p.x, photo.height - p.y});
    }
    bool right = false;
    for (std::size_t i = 0; i < truth.size() && !right; ++i) {
      right = !found[i] && intersectionOverUnion(outline, truth[i]) >= 0.5;
      if (right) found[i] = true;
    }
    score.wrong += !right;
  }
  score.found = static_cast<int>(std::ranges::count(found, true));
  score.missed = static_cast<int>(truth.size()) - score.found;
  return score;
}

TEST(Sketches, OfPeopleAreRead) {
  const std::filesystem::path folder = std::filesystem::path(HANDMAP_SHARED_DATA) / "sketches";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no drawings in " << folder;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::filesystem::path photo_file = entry.path();
    if (!photo_file.filename().string().starts_with("sketchMap") ||
        photo_file.extension() != ".jpg") {
      continue;
    }
    const cv::Mat photo = readPhoto(photo_file, kPhotoSide_px);
    const auto start = std::chrono::steady_clock::now();
    const Trace trace = traced(photo);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    const Score score =
        scored(trace, outlinesOf(photo_file.string() + ".geojson", photo.size()), photo.size());
    fmt::print("{}: {} found, {} missed, {} wrong, {:.1f} s\n", photo_file.filename().string(),
               score.found, score.missed, score.wrong, took.count());
    EXPECT_GE(score.found, 0.85 * (score.found + score.missed)) << photo_file;
    EXPECT_LE(5 * score.wrong, score.found) << photo_file;
    EXPECT_LT(took.count(), 10.0) << photo_file;
  }
}

TEST(Sketches, InChalkOnSquaredPaperAreReadAtAll) {
  const std::filesystem::path file =
      std::filesystem::path(HANDMAP_SHARED_DATA) / "sketches" / "ucl_buildings_xian_lu_ccby4.jpg";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no drawing " << file;
  const Trace trace = traced(readPhoto(file, kPhotoSide_px));
  EXPECT_TRUE(trace.ink.dark_page);
  EXPECT_GE(trace.shapes.size(), 10u);
}

}  // namespace
}  // namespace handmap
