#include <fmt/format.h>

#include "tests/cli/program.h"

namespace handmap {
namespace {

struct Place {
  int x;
  int y;
};

class Figures : public CliTest {
 protected:
  /// Houses of 10 by 10 metres, A, B …
  static void writeHouses(const std::string& path, const std::vector<Place>& places) {
    std::string houses;
    for (std::size_t i = 0; i < places.size(); ++i) {
      houses += fmt::format(
          R"({}{{"id":"{}","shape":"rectangle","x":{},"y":{},"width":10,"depth":10,"heading_deg":0}})",
          i == 0 ? "" : ",", static_cast<char>('A' + i), places[i].x, places[i].y);
    }
    writeText(path, fmt::format(R"({{"format":"handmap","version":1,"buildings":[{}]}})", houses));
  }

  Figures() {
    writeHouses("true.handmap", {{0, 0}, {40, 0}, {0, 30}, {50, 60}, {90, 10}});
    writeHouses("drawn.handmap", {{2, 1}, {33, 4}, {3, 24}, {46, 47}});
    writeHouses("refined.handmap", {{1, 0}, {40, 1}, {0, 29}, {51, 60}});
  }
};

TEST_F(Figures, MakeARowOfADrawingAndOneOfItsCorrection) {
  const std::string expected =
      contentOf(std::filesystem::path(HANDMAP_CLI_EXPECTED) / "figures.csv");
  const std::vector<std::string> command = {"figures",      "drawn.handmap", "--reference",
                                            "true.handmap", "--corrected",   "refined.handmap"};
  expectDone(run(command), expected);
  std::vector<std::string> to_file = command;
  to_file.insert(to_file.end(), {"--csv", "out.csv"});
  expectDone(run(to_file), "");
  EXPECT_EQ(contentOf("out.csv"), expected);
}

TEST_F(Figures, RefuseWhatDoesNotGoTogether) {
  expectFailed(run({"figures", "drawn.handmap", "--reference", "true.handmap", "--reference",
                    "true.handmap"}),
               1,
               "handmap-cli: error: --reference: found 2, expected one, or one for each of the 1 "
               "drawings\n");
  expectFailed(run({"figures", "drawn.handmap", "refined.handmap", "--reference", "true.handmap",
                    "--corrected", "refined.handmap"}),
               1,
               "handmap-cli: error: --corrected: found 1, expected one for each of the 2 "
               "drawings\n");
  writeText("streets.geojson", "{}");
  expectFailed(run({"figures", "drawn.handmap", "--reference", "streets.geojson"}), 2,
               "handmap-cli: error: streets.geojson: found another kind of file than "
               "drawn.handmap, expected both .handmap or both .geojson\n");
}

}  // namespace
}  // namespace handmap
