// README's table of real places, guarded: what is missing to its figures may be a fifth more.
#include <algorithm>
#include <cctype>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace handmap {
namespace {

const std::filesystem::path kShared = HANDMAP_SHARED_DATA;
constexpr double kMore = 1.2;
constexpr double kWorse = 0.05;  // of the overlap, as README counts buildings made worse

struct Place {
  std::string folder;
  std::string drawing;  ///< one that is there, or "people-" and a seed
  double overlap;       ///< mean IoU of the corrected map as it stands
  double way_m;         ///< rms, aligned
};

void PrintTo(const Place& place, std::ostream* out) {
  *out << place.folder << ' ' << place.drawing;
}

class RealPlaces : public CliTest, public testing::WithParamInterface<Place> {
 protected:
  void SetUp() override {
    if (!exists(kShared / GetParam().folder))
      GTEST_SKIP() << "no real recordings beside the project";
  }
  static nlohmann::json compared(const std::string& map) {
    const std::filesystem::path folder = kShared / GetParam().folder;
    const Outcome outcome = run({"compare", map, folder / "truth.handmap", "--trajectory",
                                 "way.tum", "--truth", folder / "truth.tum", "--json"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out);
  }
};

TEST_P(RealPlaces, AreAsReadmeSays) {
  const auto& [name, drawing, overlap, way_m] = GetParam();
  const std::filesystem::path folder = kShared / name;
  std::filesystem::path drawn_map = folder / (drawing + ".handmap");
  if (const std::string people = "people-"; drawing.starts_with(people)) {
    drawn_map = "drawn.handmap";
    ASSERT_EQ(run({"perturb", "--map", folder / "truth.handmap", "--like", "people", "--seed",
                   drawing.substr(people.size()), "--out", drawn_map})
                  .status,
              0);
  }
  std::vector<std::string> arguments{"run",    "--map", drawn_map,         "--recording",
                                     folder,   "--out", "refined.handmap", "--trajectory",
                                     "way.tum"};
  if (name == "street") arguments.insert(arguments.end(), {"--from", "40", "--source", "points"});
  const Outcome done = run(arguments);
  ASSERT_EQ(done.status, 0) << done.err;

  const nlohmann::json drawn = compared(drawn_map);
  const nlohmann::json refined = compared("refined.handmap");
  const nlohmann::json& mean = refined["as_it_is"]["mean"];
  EXPECT_LE(1.0 - mean["iou"].get<double>(), kMore * (1.0 - overlap) + 0.005);
  EXPECT_LE(refined["trajectory"]["aligned_rms_m"].get<double>(), kMore * way_m);
  const nlohmann::json& before = drawn["as_it_is"]["buildings"];
  const nlohmann::json& after = refined["as_it_is"]["buildings"];
  ASSERT_EQ(before.size(), after.size());
  int worse = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    worse += after[i]["iou"].get<double>() < before[i]["iou"].get<double>() - kWorse ? 1 : 0;
  }
  EXPECT_LE(worse, drawing == "truth" ? 0 : 1);
}

std::string nameOf(const testing::TestParamInfo<Place>& info) {
  std::string name = info.param.folder + '_' + info.param.drawing;
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(
    Readme, RealPlaces,
    testing::Values(
        Place{"campus", "truth", 1.0, 0.2}, Place{"campus", "sketch-a", 0.94, 0.22},
        Place{"campus", "sketch-b", 0.87, 0.22}, Place{"campus", "sketch-c", 0.93, 0.22},
        Place{"campus", "sketch-d", 0.88, 0.22}, Place{"campus", "people-3", 0.85, 0.22},
        Place{"corner", "truth", 1.0, 0.28}, Place{"corner", "sketch-a", 0.56, 0.28},
        Place{"corner", "sketch-b", 0.52, 0.41}, Place{"corner", "sketch-c", 0.62, 0.28},
        Place{"street", "truth", 1.0, 0.16}, Place{"street", "sketch-a", 0.81, 0.2},
        Place{"street", "sketch-b", 0.83, 0.16}, Place{"street", "sketch-c", 0.81, 0.16},
        Place{"far-rows/plain-301", "sketch", 0.96, 0.28},
        Place{"far-rows/turned-311", "sketch", 0.91, 0.27},
        Place{"far-rows/cloud-321", "sketch", 0.96, 0.25},
        Place{"laser-sim/rough-1", "sketch-a-start-off", 0.91, 0.04},
        Place{"laser-sim/rough-1", "sketch-c", 0.99, 0.04},
        Place{"laser-sim/rough-2", "sketch-a-start-off", 0.84, 0.15},
        Place{"laser-sim/terrace-1", "sketch-b", 0.85, 0.04},
        Place{"laser-sim/terrace-2", "sketch-b", 0.89, 0.07},
        Place{"laser-sim/town", "sketch-a", 0.38, 0.12}),
    nameOf);

}  // namespace
}  // namespace handmap
