// What programs of others make of what was written: GDAL's, a reader of DXF, ffprobe, Chromium,
// Rerun. Those that are not there are passed over with a word.
#include <algorithm>
#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace handmap {
namespace {

using Json = nlohmann::json;
using Points = std::vector<std::array<double, 2>>;

bool has(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

/// What it prints.
std::string said(const std::string& command) {
  EXPECT_EQ(std::system((command + " >said.txt 2>said_wrong.txt").c_str()), 0)
      << command << '\n'
      << contentOf("said_wrong.txt");
  return contentOf("said.txt");
}

#define HANDMAP_NEEDS(program) \
  if (!has(program)) GTEST_SKIP() << "no " << program

void collect(const Json& coordinates, Points& points) {
  if (coordinates.empty()) return;
  if (coordinates[0].is_number()) {
    points.push_back({coordinates[0], coordinates[1]});
  } else {
    for (const Json& inner : coordinates) collect(inner, points);
  }
}

/// Of all polygons and closed lines.
Points outlinesIn(const Json& features) {
  Points points;
  for (const Json& feature : features["features"]) {
    if (feature["geometry"]["type"] != "Point") collect(feature["geometry"]["coordinates"], points);
  }
  return points;
}

/// Of each the farthest from the nearest of the others.
double apart(const Points& some, const Points& others) {
  double most = 0.0;
  for (const auto& p : some) {
    double least = 1e9;
    for (const auto& q : others) least = std::min(least, std::hypot(p[0] - q[0], p[1] - q[1]));
    most = std::max(most, least);
  }
  return most;
}

class Others : public CliTest {
 protected:
  Others() {
    Json map = Json::parse(contentOf("row-truth.handmap"));
    map.erase("route");
    for (const Json& building : map["buildings"]) {
      if (building.contains("vertices")) {
        for (const Json& corner : building["vertices"]) corners_.push_back(corner);
        continue;
      }
      const double x = building["x"];
      const double y = building["y"];
      const double a = building["width"].get<double>() / 2.0;
      const double b = building["depth"].get<double>() / 2.0;
      for (const auto& [u, v] : {std::pair(-a, -b), {a, -b}, {a, b}, {-a, b}}) {
        corners_.push_back({x + u, y + v});  // none is turned
      }
    }
    map["georeference"] = {{"latitude", 34.7}, {"longitude", 137.4}};
    writeText("map.handmap", map.dump());
  }
  static void convert(const std::string& file) {
    expectDone(run({"convert", "map.handmap", file}), "");
  }
  static Points readByGdal(const std::string& file) {
    return outlinesIn(Json::parse(
        said("ogr2ogr --config OSM_USE_CUSTOM_INDEXING NO -f GeoJSON -lco COORDINATE_PRECISION=12 "
             "/vsistdout/ " +
             file + (file.ends_with(".osm") ? " multipolygons" : ""))));
  }

  Points corners_;  ///< metres
};

TEST_F(Others, ReadMapsWhereTheyAre) {
  HANDMAP_NEEDS("ogr2ogr");
  constexpr double kDegree_m = 1.112e5;
  convert("map.geojson");
  const Points own = outlinesIn(Json::parse(contentOf("map.geojson")));
  ASSERT_GE(own.size(), corners_.size());
  for (const std::string file : {"map.geojson", "map.osm", "map.kml", "map.gpkg"}) {
    convert(file);
    const Points read = readByGdal(file);
    EXPECT_LT(apart(own, read) * kDegree_m, 0.02) << file;
    EXPECT_LT(apart(read, own) * kDegree_m, 0.02) << file;
  }
}

TEST_F(Others, ReadPlansWhereTheyAre) {
  HANDMAP_NEEDS("ogr2ogr");
  convert("map.dxf");
  EXPECT_LT(apart(corners_, readByGdal("map.dxf")), 1e-6);
  EXPECT_LT(apart(readByGdal("map.dxf"), corners_), 1e-6);
}

TEST_F(Others, FindNothingWrongInPlans) {
  const std::string python = "/usr/bin/python3";
  if (std::system((python + " -c 'import ezdxf' 2>/dev/null").c_str()) != 0) {
    GTEST_SKIP() << "no ezdxf";
  }
  convert("map.dxf");
  writeText("read.py",
            "import ezdxf, json\n"
            "plan = ezdxf.readfile('map.dxf')\n"
            "lines = plan.modelspace().query('LWPOLYLINE')\n"
            "print(json.dumps({'wrong': len(plan.audit().errors), 'closed': all(l.closed for l in "
            "lines),\n"
            "  'points': [list(p) for l in lines for p in l.get_points('xy')]}))\n");
  const Json read = Json::parse(said(python + " read.py"));
  EXPECT_EQ(read["wrong"], 0);
  EXPECT_EQ(read["closed"], true);
  EXPECT_EQ(read["points"].size(), corners_.size());
  EXPECT_LT(apart(corners_, read["points"].get<Points>()), 1e-6);
}

TEST_F(Others, ShowPlans) {
  HANDMAP_NEEDS("xmllint");
  HANDMAP_NEEDS("pdftotext");
  HANDMAP_NEEDS("identify");
  convert("map.svg");
  convert("map.pdf");
  convert("map.png");
  said("xmllint --noout map.svg && echo well-formed");
  EXPECT_NE(said("pdftotext map.pdf -").find("N1"), std::string::npos);
  EXPECT_EQ(said("identify -format '%m %w x %h' map.png"), "PNG 2376 x 1680");
}

/// A short run, its film and all that is kept of it.
class OthersOfARun : public Others {
 protected:
  OthersOfARun() {
    EXPECT_EQ(run({"simulate", "--seed", "3", "--out", "world"}).status, 0);
    const Outcome outcome = run({"run", "--map", "world/sketch.handmap", "--recording", "world",
                                 "--keep", "kept", "--film", "film.mp4", "--to", "20", "--quiet"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  }
};

TEST_F(OthersOfARun, PlayTheFilm) {
  HANDMAP_NEEDS("ffprobe");
  const Json film = Json::parse(said(
      "ffprobe -v error -count_frames -show_entries stream=nb_read_frames,width,height -of json "
      "film.mp4"))["streams"][0];
  const Json frames = Json::parse(contentOf("kept/report.json"))["frames"];
  EXPECT_EQ(film["nb_read_frames"], std::to_string(frames.size()));
  EXPECT_GE(film["width"], 640);
  EXPECT_EQ(contentOf("said_wrong.txt"), "");
}

TEST_F(OthersOfARun, ShowThePage) {
  HANDMAP_NEEDS("chromium");
  ASSERT_EQ(run({"report", "--run", "kept", "--out", "page.html"}).status, 0);
  const std::string shown = said(
      "chromium --headless --no-sandbox --disable-gpu --user-data-dir=profile --dump-dom "
      "--virtual-time-budget=3000 \"file://$PWD/page.html\"");
  const Json map = Json::parse(contentOf("kept/refined.handmap"));
  for (const Json& building : map["buildings"]) {
    EXPECT_NE(shown.find("<td>" + building["id"].get<std::string>()), std::string::npos)
        << building["id"];
  }
  EXPECT_NE(shown.find("<polygon"), std::string::npos);
  EXPECT_NE(shown.find("class=\"swarm\" d=\"M"), std::string::npos)
      << "particles of the first frame";
}

TEST_F(OthersOfARun, ThePageCanBeUsed) {
  HANDMAP_NEEDS("chromium");
  ASSERT_EQ(run({"report", "--run", "kept", "--out", "page.html"}).status, 0);
  std::string page = contentOf("page.html");
  page.insert(page.rfind("</body>"),
              "<script>" + contentOf(HANDMAP_SOURCES "/tests/cli/peers/use_page.js") + "</script>");
  writeText("used.html", page);
  const std::string shown = said(
      "chromium --headless --no-sandbox --disable-gpu --user-data-dir=profile --dump-dom "
      "--virtual-time-budget=3000 \"file://$PWD/used.html\"");
  const std::string begin = "<pre id=\"told\">";
  const std::size_t at = shown.find(begin);
  ASSERT_NE(at, std::string::npos) << "it stopped on the way";
  const std::size_t from = at + begin.size();
  const Json told = Json::parse(shown.substr(from, shown.find("</pre>", from) - from));
  EXPECT_TRUE(told["moved"].get<bool>()) << "the timeline moves the robot";
  EXPECT_NEAR(told["charted"].get<double>(), 0.5, 0.1) << "the chart, too";
  EXPECT_NEAR(told["measured"].get<double>(), told["expected"].get<double>(), 0.01);
  EXPECT_GE(told["layers"], 4);
  EXPECT_TRUE(told["hidden"].get<bool>());
  EXPECT_TRUE(told["zoomed"].get<bool>());
  EXPECT_EQ(told["marked"], 1);
  EXPECT_NE(told["titles"]["en"].get<std::string>().find("Report of a run"), std::string::npos);
  EXPECT_NE(told["titles"]["ja"].get<std::string>().find("実行の報告"), std::string::npos);
  EXPECT_GE(told["links"].size(), 6U);
  for (const Json& link : told["links"]) EXPECT_TRUE(link["is_here"].get<bool>()) << link["name"];
}

TEST_F(OthersOfARun, RerunShowsIt) {
  HANDMAP_NEEDS("chromium");
  if (!exists(std::filesystem::path(HANDMAP_PEERS "/node_modules/@rerun-io/web-viewer"))) {
    GTEST_SKIP() << "no viewer: ./dev peers";
  }
  const std::string viewer = said("NODE_PATH=" HANDMAP_PEERS "/node_modules node " HANDMAP_SOURCES
                                  "/tests/cli/peers/show_in_rerun.mjs kept/run.mcap shown.png 90");
  EXPECT_NE(viewer.find("run.mcap has finished"), std::string::npos) << viewer;
  EXPECT_EQ(viewer.find("ERROR"), std::string::npos) << viewer;
  for (const char* room : {"WARN re_importer", "WARN re_mcap", "WARN re_data"}) {
    EXPECT_EQ(viewer.find(room), std::string::npos) << viewer;
  }
  EXPECT_GT(contentOf("shown.png").size(), 30'000U);
}

}  // namespace
}  // namespace handmap
