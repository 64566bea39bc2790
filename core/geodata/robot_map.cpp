#include "core/geodata/robot_map.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>
#include <yaml-cpp/yaml.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/geodata/fleet_map.h"
#include "core/map/map_limits.h"
#include "core/recording/image_file.h"

namespace handmap {

namespace fs = std::filesystem;

namespace {

constexpr double kMargin_m = 2.0;
constexpr double kCoarsest_m = 10.0;  // of cells
constexpr std::uint8_t kFreeGrey = 254;
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
  bool raw = false;  ///< pixels are per cent; what is beyond them is unknown
  double occupied = 0.65;
  double free = 0.25;

  /// What a pixel says, 0 free … 1 occupied; nullopt: nothing.
  std::optional<double> occupancy(std::uint8_t grey) const {
    if (raw) return grey <= 100 ? std::optional(grey / 100.0) : std::nullopt;
    return (negate ? grey : 255 - grey) / 255.0;
  }
  /// 255 where it holds of what a pixel says.
  cv::Mat1b where(const cv::Mat1b& grey, const std::function<bool(double)>& holds) const {
    cv::Mat1b table(1, 256);
    for (int i = 0; i < 256; ++i) {
      const auto said = occupancy(static_cast<std::uint8_t>(i));
      table(i) = said && holds(*said) ? 255 : 0;
    }
    cv::Mat1b mask;
    cv::LUT(grey, table, mask);
    return mask;
  }
  cv::Mat1b isOccupied(const cv::Mat1b& grey) const {
    return where(grey, [this](double said) { return said > occupied; });
  }
  cv::Mat1b isFree(const cv::Mat1b& grey) const {
    return where(grey, [this](double said) { return said < free; });
  }
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
    const auto mode = node["mode"].as<std::string>("trinary");
    text.raw = mode == "raw";
    if (!text.raw && mode != "trinary" && mode != "scale") wrong("mode", "trinary, scale, raw");
    text.occupied = node["occupied_thresh"].as<double>(0.65);
    text.free = node["free_thresh"].as<double>(0.25);
    const auto origin = node["origin"].as<std::vector<double>>(std::vector<double>());
    if (origin.size() < 2) wrong("origin", "[x, y, yaw]");
    text.origin = {origin[0], origin[1], origin.size() > 2 ? origin[2] : 0.0};
  } catch (const YAML::Exception& error) {
    throwBadInput(file, phrase("line {}", error.mark.line + 1), error.msg,
                  phrase("a map of map_server"));
  }
  if (text.image.empty() || !staysInside(text.image))
    wrong("image", phrase("a path inside the folder"));
  if (!(text.cell_m >= 1e-3 && text.cell_m <= kCoarsest_m))
    wrong("resolution", phrase("metres a pixel"));
  if (!(text.free >= 0.0 && text.free < text.occupied && text.occupied <= 1.0)) {
    wrong("occupied_thresh", phrase("above free_thresh, both in 0 … 1"));
  }
  for (const double value : {text.origin.x, text.origin.y, text.origin.heading}) {
    if (!(std::abs(value) <= kMaxCoordinate)) wrong("origin", "[x, y, yaw]");
  }
  return text;
}

/// The picture of a grid, a pixel a cell.
struct GridPicture {
  RobotMapText text;
  fs::path image;
  cv::Mat1b grey;

  explicit GridPicture(const fs::path& path)
      : text(readText(path)), image(path.parent_path() / text.image) {
    grey = image.extension() == ".pgm" ? parsePgm(readFile(image, kMostPgmBytes), image.string())
                                       : greyImage(readImage(image));
  }
  /// Middle of a cell and corners in between, metres of the grid's frame.
  Vec2 place(double column, double row) const {
    return text.origin.toOuter({column * text.cell_m, (grey.rows - row) * text.cell_m});
  }
};

/// What is drawn, with some ground around it.
struct Grid {
  Vec2 low;  ///< its lower left corner
  double cell_m;
  int columns;
  int rows;
};

Grid gridOf(const Map& map, const fs::path& file) {
  if (map.buildings.empty()) {
    throwBadInput(file.string(), "buildings", phrase("none"), phrase("at least one"));
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
  Vec2 cells = Vec2::Zero();
  for (const double cell_m : {kRobotMapCell_m, 0.2, 0.5, 1.0, 2.0, 5.0, kCoarsest_m}) {
    const Vec2 corner = ((low.array() - kMargin_m) / cell_m).floor() * cell_m;
    cells = (((high - corner).array() + kMargin_m) / cell_m).ceil();
    if (!(cells.maxCoeff() <= static_cast<double>(kMostSide))) continue;
    return {corner, cell_m, static_cast<int>(cells.x()), static_cast<int>(cells.y())};
  }
  throwBadInput(file.string(), "",
                phrase("{} × {} cells of {} m", cells.x(), cells.y(), kCoarsest_m),
                phrase("at most {}", kMostSide));
}

/// Both or none: an old text beside a new picture would be another map.
void writePair(const fs::path& path, const std::string& pgm, const std::string& text) {
  fs::path image = path;
  image.replace_extension(".pgm");
  fs::path part = image;
  part += ".part";
  writeFileAtomically(part, pgm);
  std::error_code error;
  try {
    writeFileAtomically(path, fmt::format("image: {}\n{}", image.filename().string(), text));
  } catch (const Error&) {
    fs::remove(part, error);
    throw;
  }
  fs::rename(part, image, error);
  if (error) {
    throw Error(ErrorCode::RunFailed,
                phrase("{}: cannot be written: {}", image.string(), error.message()));
  }
}

}  // namespace

double robotMapCell(const Map& map, const fs::path& file) { return gridOf(map, file).cell_m; }

void writeRobotMap(const Map& map, const fs::path& path) {
  const Grid grid = gridOf(map, path);
  std::string pgm = fmt::format("P5\n{} {}\n255\n", grid.columns, grid.rows);
  const std::size_t head = pgm.size();
  pgm.resize(head + static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows),
             static_cast<char>(kFreeGrey));
  cv::Mat1b picture(grid.rows, grid.columns, reinterpret_cast<std::uint8_t*>(pgm.data() + head));
  constexpr int kShift = 8;  // bits behind the point, of corners
  for (const Building& building : map.buildings) {
    std::vector<cv::Point> corners;
    for (const Vec2& corner : building.footprint()) {
      const Vec2 at = (corner - grid.low) / grid.cell_m;
      corners.emplace_back(
          static_cast<int>(std::lround((at.x() - 0.5) * (1 << kShift))),
          static_cast<int>(std::lround((grid.rows - at.y() - 0.5) * (1 << kShift))));
    }
    cv::fillPoly(picture, std::vector<std::vector<cv::Point>>{corners}, cv::Scalar(0), cv::LINE_8,
                 kShift);
  }
  writePair(path, pgm,
            fmt::format("mode: trinary\nresolution: {}\norigin: [{}, {}, 0]\n"
                        "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n",
                        formatNumber(grid.cell_m), formatNumber(grid.low.x()),
                        formatNumber(grid.low.y())));
}

Map readRobotMap(const fs::path& path) {
  const GridPicture grid(path);
  const RobotMapText& text = grid.text;
  const cv::Mat occupied = text.isOccupied(grid.grey);
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
      corners.push_back(grid.place(u, v));
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

RobotGrid readRobotGrid(const fs::path& path) {
  constexpr double kFreeStep_m = 0.5;
  const GridPicture picture(path);
  const RobotMapText& text = picture.text;
  const cv::Mat1b occupied = text.isOccupied(picture.grey);
  const cv::Mat1b free = text.isFree(picture.grey);
  RobotGrid grid{picture.image,
                 {picture.grey.cols, picture.grey.rows},
                 text.cell_m,
                 text.origin,
                 {text.cell_m, {}, {}}};
  const int step = std::max(1, static_cast<int>(kFreeStep_m / text.cell_m));
  const auto isInside = [&](int column, int row) {
    return row >= 0 && column >= 0 && row < occupied.rows && column < occupied.cols &&
           occupied(row, column) != 0;
  };
  for (int row = 0; row < occupied.rows; ++row) {
    for (int column = 0; column < occupied.cols; ++column) {
      const Vec2 middle = picture.place(column + 0.5, row + 0.5);
      if (isInside(column, row)) {
        const bool is_edge = !isInside(column - 1, row) || !isInside(column + 1, row) ||
                             !isInside(column, row - 1) || !isInside(column, row + 1);
        if (is_edge) grid.ground.edges.push_back(middle);
      } else if (row % step == 0 && column % step == 0 && free(row, column) != 0) {
        grid.ground.free.push_back(middle);
      }
    }
  }
  if (grid.ground.edges.empty()) {
    throwBadInput(path.string(), "", phrase("nothing that is occupied"), phrase("walls"));
  }
  return grid;
}

Underlay underlayOf(const RobotGrid& grid, const Pose2& place) {
  const Pose2 corner = place * grid.origin;
  const Vec2 top_left = corner.toOuter({0.0, grid.cells[1] * grid.cell_m});
  Underlay underlay;
  underlay.image = grid.image.string();
  underlay.x = top_left.x();
  underlay.y = top_left.y();
  underlay.metres_per_pixel = grid.cell_m;
  underlay.heading = corner.heading;
  underlay.opacity = 0.6;
  rememberFrame({grid.cells, grid.cell_m, grid.origin}, underlay);
  return underlay;
}

}  // namespace handmap
