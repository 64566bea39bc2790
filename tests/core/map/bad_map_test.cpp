// Maps that must be refused, and how; and damaged ones that must not crash anything.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/map/map_io.h"
#include "tests/core/base/expect_error.h"
#include "tests/core/base/temporary_folder.h"
#include "tests/core/map/example_maps.h"

namespace handmap {
namespace {

using test::expectBadInput;
using test::kFullMap;

/// The full map with one piece of its text replaced.
std::string with(const std::string& what, const std::string& by) {
  std::string text = kFullMap;
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

void expectRefused(const std::string& text, const std::vector<std::string>& words) {
  SCOPED_TRACE(text);
  expectBadInput([&] { parseMap(text, "campus.handmap"); }, words);
}

TEST(BadMap, WrongTypesAndRanges) {
  struct Case {
    const char* what;
    const char* by;
    std::vector<std::string> words;
  };
  const std::vector<Case> cases = {
      {"\"width\": 40.0",
       "\"width\": \"abc\"",
       {"campus.handmap: buildings[0].width: found \"abc\" (string), expected a number > 0"}},
      {"\"width\": 40.0", "\"width\": 0", {"buildings[0].width: found 0"}},
      {"\"width\": 40.0", "\"width\": -3.5", {"buildings[0].width: found -3.5"}},
      {"\"width\": 40.0", "\"width\": 1e6", {"buildings[0].width", "at most 100000"}},
      {"\"width\": 40.0", "\"width\": 1e999", {"campus.handmap", "buildings[0].width", "number"}},
      {"\"width\": 40.0", "\"width\": NaN", {"line 7", "no valid JSON"}},
      {"\"width\": 40.0,", "", {"buildings[0].width: found nothing"}},
      {"\"depth\": 15.0", "\"depth\": null", {"buildings[0].depth: found null"}},
      {"\"x\": 10.0", "\"x\": 1e7", {"buildings[0].x", "-1000000 to 1000000"}},
      {"\"heading_deg\": 33.3", "\"heading_deg\": [1]", {"buildings[0].heading_deg", "an array"}},
      {"\"shape\": \"rectangle\"", "\"shape\": \"circle\"", {"buildings[0].shape", "circle"}},
      {"\"shape\": \"rectangle\",", "", {"buildings[0].shape: found nothing"}},
      {"\"id\": \"N1\"", "\"id\": \"\"", {"buildings[0].id", "not empty"}},
      {"\"id\": \"N1\"", "\"id\": 7", {"buildings[0].id: found 7, expected a string"}},
      {"\"fixed\": true", "\"fixed\": 1", {"buildings[0].fixed", "true or false"}},
      {"\"position_m\": 0.5", "\"position_m\": -1", {"buildings[0].uncertainty.position_m"}},
      {"{ \"position_m\": 2.5",
       "{ \"scale\": -0.1, \"position_m\": 2.5",
       {"uncertainty.scale", "-0.1"}},
      {"{ \"position_m\": 2.5", "{ \"scale\": \"a\", \"position_m\": 2.5", {"uncertainty.scale"}},
      {"{ \"position_m\": 2.5",
       "{ \"turn_deg\": 181, \"position_m\": 2.5",
       {"uncertainty.turn_deg: found 181", "180"}},
      {"\"observations\": 12", "\"observations\": 1.5", {"buildings[0].estimate.observations"}},
      {"\"sigma_x\": 0.1", "\"sigma_x\": -0.1", {"buildings[0].estimate.sigma_x"}},
      {"[[60,20],[95,20]", "[[60,20],[95]", {"buildings[1].vertices[1]", "[x, y]"}},
      {"[95,20]", "[95,\"a\"]", {"buildings[1].vertices[1][1]: found \"a\""}},
      {"[[60,20],[95,20],[95,34],[60,34]]", "[[60,20],[95,20]]", {"vertices", "2 different"}},
      {"[[60,20],[95,20],[95,34],[60,34]]", "[[0,0],[1,1],[0,0],[1,1]]", {"without area"}},
      {"[[60,20],[95,20],[95,34],[60,34]]", "[[0,0],[9,9],[9,0],[0,8]]", {"meets itself"}},
      {"\"open\": true", "\"name\": \"twice\"", {"landmarks[0].name", "twice"}},
      {"\"x\": 0.0, \"y\": -3.0", "\"x\": 0.0", {"landmarks[0].y: found nothing"}},
      {"[60,0]", "60", {"route[1]: found 60"}},
      {"\"metres_per_pixel\": 0.2", "\"metres_per_pixel\": 0", {"underlays[0].metres_per_pixel"}},
      {"\"opacity\": 0.5", "\"opacity\": 1.5", {"underlays[0].opacity", "0 to 1"}},
      {"\"latitude\": 34.70", "\"latitude\": 90", {"georeference.latitude"}},
      {"\"longitude\": 137.41", "\"longitude\": 181", {"georeference.longitude"}},
      {"\"heading_deg\": 90.0, ", "", {"start.heading_deg: found nothing"}},
      {"{ \"seed\": 1, \"recording\": \"street\" }", "[]", {"refinement", "an object"}},
      {"\"name\": \"Campus, drawn from memory\"", "\"name\": 5", {"name: found 5"}},
  };
  for (const Case& c : cases) expectRefused(with(c.what, c.by), c.words);
}

TEST(BadMap, FormatAndVersion) {
  expectRefused(with("\"handmap\"", "\"other\""), {"format: found \"other\"", "\"handmap\""});
  expectRefused(with("\"format\": \"handmap\", ", ""), {"format: found nothing"});
  expectRefused(with("\"version\": 1", "\"version\": 2"),
                {"version: found 2", "up to 1", "update the program"});
  expectRefused(with("\"version\": 1", "\"version\": 0"), {"version: found 0"});
  expectRefused(with("\"version\": 1", "\"version\": 1.5"), {"version: found 1.5"});
  expectRefused(with("\"version\": 1", "\"version\": \"1\""), {"version: found \"1\""});
  expectRefused(with("\"buildings\"", "\"houses\""), {"buildings: found nothing"});
  expectRefused("[]", {"campus.handmap: found an array of 0, expected an object"});
}

TEST(BadMap, OneIdTwiceNamesBothPlaces) {
  expectRefused(with("\"N2\"", "\"N1\""), {"buildings[1].id", "\"N1\"", "buildings[0]"});
  expectRefused(with("\"gate\"", "\"N2\""), {"landmarks[0].id", "\"N2\"", "buildings[1]"});
}

TEST(BadMap, BoundsStringsAndVertices) {
  expectRefused(with("Library", std::string(5000, 'x')), {"buildings[0].name", "5000 bytes"});
  std::string ring = "[";
  for (int i = 0; i < 2'001; ++i) {
    const double angle = 2.0 * kPi * i / 2'001;
    ring += (i == 0 ? "[" : ",[") + std::to_string(1000.0 * std::cos(angle)) + "," +
            std::to_string(1000.0 * std::sin(angle)) + "]";
  }
  expectBadInput([&] { parseMap(with("[[60,20],[95,20],[95,34],[60,34]]", ring + "]"), "m"); },
                 {"buildings[1].vertices", "2001"});
}

/// "[ITEM,ITEM,…]"; %d is the number of the item.
std::string array(int count, const std::string& item) {
  std::string text = "[";
  for (int i = 0; i < count; ++i) {
    std::string one = item;
    if (const auto place = one.find("%d"); place != std::string::npos) {
      one.replace(place, 2, std::to_string(i));
    }
    text += (i == 0 ? "" : ",") + one;
  }
  return text + "]";
}

TEST(BadMap, BoundsCounts) {
  const auto map = [](const std::string& members) {
    return R"({"format":"handmap","version":1,)" + members + "}";
  };
  const auto refused = [&](const std::string& members, const std::vector<std::string>& words) {
    expectBadInput([&] { parseMap(map(members), "m"); }, words);
  };
  refused("\"buildings\":" + array(100'001, "0"),
          {"m: buildings: found an array of 100001, expected at most 100000"});
  refused("\"buildings\":[],\"landmarks\":" + array(100'001, "0"), {"m: landmarks: ", "100000"});
  refused("\"buildings\":[],\"route\":" + array(100'001, "[0,0]"), {"m: route: ", "100000"});
  refused("\"buildings\":[],\"underlays\":" + array(101, "0"), {"m: underlays: ", "most 100"});
  refused("\"buildings\":[],\"route\":[" + array(9, "0") + "]", {"m: route[0]: ", "most 2"});
  // Zigzags of 1,000 vertices each.
  std::string zigzag = "[[0,9]";
  for (int i = 0; i < 998; ++i) zigzag += fmt::format(",[{},{}]", i, i % 2);
  const std::string house = R"({"id":"%d","shape":"polygon","vertices":)" + zigzag + ",[998,9]]}";
  refused("\"buildings\":" + array(501, house),
          {"m: buildings[500]: found 501000 vertices up to here, expected at most 500000 in all"});
}

TEST(BadMap, Files) {
  const test::TemporaryFolder folder;
  expectBadInput([&] { readMap(folder.path() / "none.handmap"); },
                 {"none.handmap", "no such file"});
  expectBadInput([&] { readMap(folder.write("empty.handmap", "")); }, {"empty.handmap: line 1"});
  expectBadInput([&] { readMap(folder.path()); }, {"no regular file"});
  const auto huge = folder.write("huge.handmap", "");
  std::filesystem::resize_file(huge, (64u << 20) + 1);
  expectBadInput([&] { readMap(huge); }, {"huge.handmap", "67108865 bytes"});
}

TEST(BadMap, EveryTruncationIsRefused) {
  for (std::size_t length = 0; length < kFullMap.size(); ++length) {
    EXPECT_THROW(parseMap(kFullMap.substr(0, length), "m"), Error) << length;
  }
}

TEST(BadMap, RandomDamageIsRefusedOrRead) {
  RandomStream random(13);
  const std::string interesting = "{}[]\",:0-9.eE+\\untf \n\xff";
  int read = 0;
  constexpr int kTrials = 5000;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::string text = kFullMap;
    const int changes = 1 + random.index(3);
    for (int i = 0; i < changes; ++i) {
      const auto at = static_cast<std::size_t>(random.index(static_cast<int>(text.size())));
      const auto pick =
          static_cast<std::size_t>(random.index(static_cast<int>(interesting.size())));
      switch (random.index(4)) {
        case 0:
          text[at] = static_cast<char>(random.index(256));
          break;
        case 1:
          text[at] = interesting[pick];
          break;
        case 2:
          text.erase(at, 1 + pick);
          break;
        default:
          text.insert(at, text.substr(at, 1 + pick));
          break;
      }
    }
    try {
      const Map map = parseMap(text, "m");
      ASSERT_EQ(formatMap(parseMap(formatMap(map), "again")), formatMap(map)) << text;
      ++read;
    } catch (const Error&) {
    }
  }
  EXPECT_GT(read, 0);
  EXPECT_LT(read, kTrials);
}

}  // namespace
}  // namespace handmap
