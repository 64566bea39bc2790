// A public map, displaced as a whole and imprecise in its parts, is driven through and goes back.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace handmap {
namespace {

using Json = nlohmann::json;
using Point = std::array<double, 2>;

const std::filesystem::path kExtract =
    std::filesystem::path(HANDMAP_SHARED_DATA) / "osm/campus_unimib.osm";
constexpr double kNear_m = 60.0;
constexpr double kStart_m = 0.1;
constexpr double kHeading_deg = 0.1;

class PublicMap : public CliTest {
 protected:
  void SetUp() override {
    if (!exists(kExtract)) GTEST_SKIP() << kExtract << " is not there";
  }
};

/// Two streets of the extract.
const std::vector<Point> kWay = {{47.5, 47.4},   {43.0, 36.3},    {81.3, 20.5},   {34.8, -98.0},
                                 {10.2, -160.7}, {-24.9, -248.0}, {-82.8, -390.1}};

double distance(const Point& p, const Point& a, const Point& b) {
  const double x = b[0] - a[0];
  const double y = b[1] - a[1];
  const double along = ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / (x * x + y * y);
  const double t = std::clamp(along, 0.0, 1.0);
  return std::hypot(p[0] - a[0] - t * x, p[1] - a[1] - t * y);
}

bool isNear(const Json& building) {
  for (const Point corner : building["vertices"]) {
    for (std::size_t i = 1; i < kWay.size(); ++i) {
      if (distance(corner, kWay[i - 1], kWay[i]) < kNear_m) return true;
    }
  }
  return false;
}

Json mapOf(const std::string& path) { return Json::parse(contentOf(path)); }

/// Of the corners of what was seen.
double rms(const Json& map, const Json& truth, const Json& seen) {
  double squares = 0.0;
  int corners = 0;
  for (std::size_t b = 0; b < truth["buildings"].size(); ++b) {
    if (!seen["buildings"][b].contains("estimate") ||
        seen["buildings"][b]["estimate"]["observations"] == 0)
      continue;
    const Json& right = truth["buildings"][b]["vertices"];
    for (std::size_t k = 0; k < right.size(); ++k, ++corners) {
      const Point at = map["buildings"][b]["vertices"][k];
      squares += std::pow(at[0] - right[k][0].get<double>(), 2) +
                 std::pow(at[1] - right[k][1].get<double>(), 2);
    }
  }
  return std::sqrt(squares / corners);
}

TEST_F(PublicMap, ThatIsDisplacedIsRepaired) {
  expectDone(run({"convert", kExtract, "all.handmap"}), "");
  Json truth = mapOf("all.handmap");
  Json buildings = Json::array();
  for (const Json& building : truth["buildings"]) {
    if (isNear(building)) buildings.push_back(building);
  }
  truth["buildings"] = buildings;
  truth["route"] = kWay;
  truth["start"] = {{"x", kWay[0][0]}, {"y", kWay[0][1]}, {"heading_deg", -112.0}};
  writeText("truth.handmap", truth.dump());
  const Outcome driven = run({"simulate", "--world", "truth.handmap", "--laser", "--clutter",
                              "--rough", "--view", "270", "--out", "drive"});
  ASSERT_EQ(driven.status, 0) << driven.err;

  constexpr Point kShift = {-5.0, 4.0};
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> own(0.5, 2.0);
  std::uniform_real_distribution<double> direction(0.0, 6.28);
  std::normal_distribution<double> normal;
  Json drawing = truth;
  drawing.erase("route");
  for (Json& building : drawing["buildings"]) {
    const double by = own(random);
    const double to = direction(random);
    for (Json& corner : building["vertices"]) {
      corner[0] = corner[0].get<double>() + kShift[0] + by * std::cos(to);
      corner[1] = corner[1].get<double>() + kShift[1] + by * std::sin(to);
    }
  }
  drawing["uncertainty"] = {
      {"position_m", 1.3}, {"size_m", 0.5}, {"scale", 0}, {"turn_deg", 0}, {"shift_m", 6}};
  drawing["handmap:start_uncertainty"] = {{"position_m", kStart_m}, {"heading_deg", kHeading_deg}};
  for (const char* member : {"x", "y"}) {
    drawing["start"][member] = truth["start"][member].get<double>() + kStart_m * normal(random);
  }
  writeText("drawing.handmap", drawing.dump());

  const Outcome done = run({"run", "--map", "drawing.handmap", "--recording", "drive", "--out",
                            "refined.handmap", "--json"});
  ASSERT_EQ(done.status, 0) << done.err;
  const Json refined = mapOf("refined.handmap");
  EXPECT_LT(rms(refined, truth, refined), 0.35 * rms(drawing, truth, refined));
  const Json common = Json::parse(done.out)["common_shift"];
  EXPECT_GE(common["buildings"], 9);
  for (const std::size_t axis : {0U, 1U}) {
    const double sigma = common[axis == 0 ? "sigma_x" : "sigma_y"];
    EXPECT_LT(sigma, 0.6) << common;
    EXPECT_NEAR(common[axis == 0 ? "x" : "y"], -kShift[axis], 2.0 * sigma) << common;
  }
  EXPECT_NEAR(common["own_m"], 0.9, 0.4);

  // Numbers and tags go back as they came.
  expectDone(run({"convert", "refined.handmap", "back.osm"}), "");
  expectDone(run({"convert", "back.osm", "back.handmap"}), "");
  const Json back = mapOf("back.handmap");
  ASSERT_EQ(back["buildings"].size(), truth["buildings"].size());
  for (const Json& building : back["buildings"]) {
    const auto before = std::ranges::find_if(buildings, [&](const Json& other) {
      return other["public_map"]["id"] == building["public_map"]["id"];
    });
    ASSERT_NE(before, buildings.end()) << building;
    Json tags = building["public_map"]["tags"];
    for (auto tag = tags.begin(); tag != tags.end();) {
      tag = tag.key().starts_with("handmap:") ? tags.erase(tag) : std::next(tag);
    }
    EXPECT_EQ(tags, (*before)["public_map"]["tags"]);
  }
}

}  // namespace
}  // namespace handmap
