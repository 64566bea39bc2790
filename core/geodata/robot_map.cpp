#include "core/geodata/robot_map.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>
#include <yaml-cpp/yaml.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/map/map_limits.h"

namespace handmap {

namespace fs = std::filesystem;

namespace {

constexpr double kMargin_m = 2.0;
constexpr std::int64_t kMostSide = 20'000;  // pixels
constexpr std::uintmax_t kMostYamlBytes = 1u << 16;
constexpr std::uintmax_t kMostPgmBytes = 450u << 20;
constexpr double kLeastArea_m2 = 4.0;
constexpr int kFiner = 4;  // a contour runs through the middles of pixels: half of a small one off

/// Width, height and the bytes of a grey picture (P5).
cv::Mat parsePgm(const std::string& content, const std::string& file) {
  std::size_t at = 0;
  const auto word = [&] {
    while (at < content.size()) {
      if (content[at] == '#') {
        at = std::min(content.find('\n', at), content.size());
      } else if (std::isspace(static_cast<unsigned char>(content[at])) != 0) {
        ++at;
      } else {
        break;
      }
    }
    const std::size_t begin = at;
    while (at < content.size() && std::isspace(static_cast<unsigned char>(content[at])) == 0) ++at;
    return content.substr(begin, at - begin);
  };
  const std::string kind = word();
  const auto width = parseInteger(word()).value_or(0);
  const auto height = parseInteger(word()).value_or(0);
  const auto most = parseInteger(word()).value_or(0);
  const bool is_known = kind == "P5" && width > 0 && height > 0 && width <= kMostSide &&
                        height <= kMostSide && most > 0 && most <= 255;
  const auto pixels = static_cast<std::size_t>(width * height);
  if (!is_known || content.size() < at + 1 || content.size() - at - 1 < pixels) {
    throwBadInput(file, "", phrase("{} bytes", content.size()), phrase("a whole picture, P5"));
  }
  const cv::Mat grey(static_cast<int>(height), static_cast<int>(width), CV_8U,
                     const_cast<char*>(content.data() + at + 1));
  return grey.clone();
}

struct RobotMapText {
  fs::path image;
  double cell_m = 0.0;
  Pose2 origin;
  bool negate = false;
  double occupied = 0.65;
};

RobotMapText readText(const fs::path& path) {
  const std::string file = path.string();
  const auto wrong = [&](const char* key, const std::string& expected) {
    throwBadInput(file, key, phrase("something else"), expected);
  };
  RobotMapText text;
  try {
    const YAML::Node node = YAML::Load(readFile(path, kMostYamlBytes));
    if (!node.IsMap()) wrong("image", phrase("a map of map_server"));
    text.image = node["image"].as<std::string>("");
    text.cell_m = node["resolution"].as<double>(0.0);
    text.negate = node["negate"].as<int>(0) != 0;
    text.occupied = node["occupied_thresh"].as<double>(0.65);
    const auto origin = node["origin"].as<std::vector<double>>(std::vector<double>());
    if (origin.size() < 2) wrong("origin", "[x, y, yaw]");
    text.origin = {origin[0], origin[1], origin.size() > 2 ? origin[2] : 0.0};
  } catch (const YAML::Exception& error) {
    throwBadInput(file, phrase("line {}", error.mark.line + 1), error.msg,
                  phrase("a map of map_server"));
  }
  if (text.image.empty() || !staysInside(text.image))
    wrong("image", phrase("a path inside the folder"));
  if (!(text.cell_m >= 1e-3 && text.cell_m <= 10.0)) wrong("resolution", phrase("metres a pixel"));
  for (const double value : {text.origin.x, text.origin.y, text.origin.heading}) {
    if (!(std::abs(value) <= kMaxCoordinate)) wrong("origin", "[x, y, yaw]");
  }
  return text;
}

}  // namespace

void writeRobotMap(const Map& map, const fs::path& path) {
  if (map.buildings.empty()) {
    throwBadInput(path.string(), "buildings", phrase("none"), phrase("at least one"));
  }
  Vec2 low = map.buildings.front().footprint().front();
  Vec2 high = low;
  const auto include = [&](const Vec2& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  };
  for (const Building& building : map.buildings) {
    for (const Vec2& corner : building.footprint()) include(corner);
  }
  if (map.start) include(map.start->position());
  for (const Vec2& point : map.route) include(point);
  low = ((low.array() - kMargin_m) / kRobotMapCell_m).floor() * kRobotMapCell_m;
  const Vec2 cells = (((high - low).array() + kMargin_m) / kRobotMapCell_m).ceil();
  if (!(cells.maxCoeff() <= static_cast<double>(kMostSide))) {
    throwBadInput(path.string(), "", phrase("{} × {} pixels", cells.x(), cells.y()),
                  phrase("at most {}", kMostSide));
  }
  cv::Mat1b grid(static_cast<int>(cells.y()), static_cast<int>(cells.x()), std::uint8_t{254});
  constexpr int kShift = 8;  // bits behind the point, of corners
  for (const Building& building : map.buildings) {
    std::vector<cv::Point> corners;
    for (const Vec2& corner : building.footprint()) {
      const Vec2 at = (corner - low) / kRobotMapCell_m;
      corners.emplace_back(
          static_cast<int>(std::lround((at.x() - 0.5) * (1 << kShift))),
          static_cast<int>(std::lround((cells.y() - at.y() - 0.5) * (1 << kShift))));
    }
    cv::fillPoly(grid, std::vector<std::vector<cv::Point>>{corners}, cv::Scalar(0), cv::LINE_8,
                 kShift);
  }
  fs::path image = path;
  image.replace_extension(".pgm");
  std::string pgm = fmt::format("P5\n{} {}\n255\n", grid.cols, grid.rows);
  pgm.append(reinterpret_cast<const char*>(grid.data), grid.total());
  writeFileAtomically(image, pgm);
  writeFileAtomically(path,
                      fmt::format("image: {}\nmode: trinary\nresolution: {}\norigin: [{}, {}, 0]\n"
                                  "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n",
                                  image.filename().string(), formatNumber(kRobotMapCell_m),
                                  formatNumber(low.x()), formatNumber(low.y())));
}

Map readRobotMap(const fs::path& path) {
  const RobotMapText text = readText(path);
  const fs::path image = path.parent_path() / text.image;
  const cv::Mat grey = parsePgm(readFile(image, kMostPgmBytes), image.string());
  const double limit = 255.0 * (text.negate ? text.occupied : 1.0 - text.occupied);
  cv::Mat occupied = text.negate ? cv::Mat(grey > limit) : cv::Mat(grey < limit);
  std::vector<std::vector<cv::Point>> pieces;
  cv::findContours(occupied, pieces, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  Map map;
  map.uncertainty = {text.cell_m, text.cell_m};
  map.whole = {0.0, 0.0};
  for (const auto& piece : pieces) {
    // Alone and finer, so that its edge is where its cells end.
    const cv::Rect box = cv::boundingRect(piece);
    if (box.area() * text.cell_m * text.cell_m < kLeastArea_m2) continue;
    if (map.buildings.size() == kMaxBuildings) break;
    cv::Mat1b mask(box.size(), std::uint8_t{0});
    cv::drawContours(mask, std::vector<std::vector<cv::Point>>{piece}, 0, cv::Scalar(255),
                     cv::FILLED, cv::LINE_8, {}, 0, -box.tl());
    cv::resize(mask, mask, {}, kFiner, kFiner, cv::INTER_NEAREST);
    cv::copyMakeBorder(mask, mask, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
    std::vector<std::vector<cv::Point>> fine;
    cv::findContours(mask, fine, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    std::vector<cv::Point> outline;
    cv::approxPolyDP(fine.front(), outline, 1.2 * kFiner, true);
    Polygon corners;
    for (const cv::Point& pixel : outline) {
      const double u = box.x + (pixel.x - 1 + 0.5) / kFiner;
      const double v = box.y + (pixel.y - 1 + 0.5) / kFiner;
      corners.push_back(text.origin.toOuter({u * text.cell_m, (grey.rows - v) * text.cell_m}));
    }
    if (signedArea(corners) < 0.0) std::ranges::reverse(corners);
    if (corners.size() < 3 || corners.size() > kMaxPolygonVertices || !isSimple(corners)) continue;
    if (signedArea(corners) < kLeastArea_m2) continue;
    Building building;
    building.id = fmt::format("B{}", map.buildings.size() + 1);
    building.shape = std::move(corners);
    map.buildings.push_back(std::move(building));
  }
  if (map.buildings.empty()) {
    throwBadInput(path.string(), "", phrase("nothing that is occupied"),
                  phrase("pieces of at least {} m²", kLeastArea_m2));
  }
  return map;
}

}  // namespace handmap
