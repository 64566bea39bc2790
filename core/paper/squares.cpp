#include "core/paper/squares.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/median.h"
#include "core/paper/disc.h"
#include "core/paper/paper_pieces.h"

namespace handmap {

namespace {

constexpr std::size_t kLeastSquares = 60;
constexpr double kLeastCovered = 0.25;  // of the page
constexpr double kSameArea = 0.15;
constexpr double kSquareness = 0.25;  // of the area, to that of the largest disc's box
constexpr double kGridFit = 0.08;     // rms of the middles off the grid, of a square
constexpr double kThicker = 1.5;      // where two lines cross it is 1.4
constexpr double kGridReached = 0.5;  // of the squares: they hang together

std::vector<int> equalSquares(const PaperPieces& pieces) {
  std::vector<int> squares;
  std::vector<double> areas;
  for (int i = 1; i < pieces.count(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double side = pieces.thickness[at];
    if (pieces.at_edge[at] || std::abs(pieces.area[at] / (side * side) - 1.0) > kSquareness)
      continue;
    squares.push_back(i);
    areas.push_back(pieces.area[at]);
  }
  if (areas.size() < kLeastSquares) return {};
  const double middle = medianOf(areas);
  std::erase_if(squares, [&](int i) {
    return std::abs(pieces.area[static_cast<std::size_t>(i)] / middle - 1.0) > kSameArea;
  });
  const double covered = static_cast<double>(squares.size()) * middle;
  const bool fill = covered > kLeastCovered * static_cast<double>(pieces.labels.total());
  return squares.size() >= kLeastSquares && fill ? squares : std::vector<int>();
}

/// From columns and rows of squares to the page.
std::optional<cv::Mat> gridOf(const PaperPieces& pieces, const std::vector<int>& squares) {
  const auto count = static_cast<std::size_t>(pieces.count());
  std::vector<bool> is_square(count, false);
  for (const int i : squares) is_square[static_cast<std::size_t>(i)] = true;
  std::vector<std::vector<int>> beside(count);
  for (const PieceBorder& border : pieces.borders) {
    const auto a = static_cast<std::size_t>(border.a), b = static_cast<std::size_t>(border.b);
    if (!is_square[a] || !is_square[b]) continue;
    if (border.length_px < 0.5 * pieces.thickness[a]) continue;  // corner to corner
    beside[a].push_back(border.b);
    beside[b].push_back(border.a);
  }
  std::vector<cv::Point2f> cells, page;
  std::vector<bool> seen(count, false);
  for (const int first : squares) {
    if (seen[static_cast<std::size_t>(first)] || beside[static_cast<std::size_t>(first)].empty())
      continue;
    std::vector<cv::Point2f> own_cells = {{0.0F, 0.0F}}, own_page;
    std::vector<int> reached = {first};
    seen[static_cast<std::size_t>(first)] = true;
    for (std::size_t k = 0; k < reached.size(); ++k) {
      const auto here = static_cast<std::size_t>(reached[k]);
      own_page.emplace_back(pieces.mean[here]);
      for (const int next : beside[here]) {
        const auto there = static_cast<std::size_t>(next);
        if (seen[there]) continue;
        seen[there] = true;
        reached.push_back(next);
        const cv::Point2d way = pieces.mean[there] - pieces.mean[here];
        const bool across = std::abs(way.x) > std::abs(way.y);
        own_cells.push_back(
            own_cells[k] +
            cv::Point2f(across ? std::copysign(1.0F, static_cast<float>(way.x)) : 0,
                        across ? 0 : std::copysign(1.0F, static_cast<float>(way.y))));
      }
    }
    if (own_cells.size() > cells.size()) {
      cells = own_cells;
      page = own_page;
    }
  }
  if (static_cast<double>(cells.size()) < kGridReached * static_cast<double>(squares.size()))
    return std::nullopt;
  const cv::Mat grid = cv::findHomography(cells, page);
  if (grid.empty()) return std::nullopt;
  std::vector<cv::Point2f> fitted;
  cv::perspectiveTransform(cells, fitted, grid);
  double sum = 0.0;
  for (std::size_t k = 0; k < page.size(); ++k)
    sum += (fitted[k] - page[k]).ddot(fitted[k] - page[k]);
  const double side = pieces.thickness[static_cast<std::size_t>(squares.front())];
  const bool fits = std::sqrt(sum / static_cast<double>(page.size())) < kGridFit * side;
  return fits ? std::optional(grid) : std::nullopt;
}

/// 255 where the lines of the grid run, so thick, over all of a page.
cv::Mat gridLines(const cv::Mat& grid, const cv::Size& size, int thick_px) {
  std::vector<cv::Point2f> corners = {
      {0, 0},
      {static_cast<float>(size.width), 0},
      {static_cast<float>(size.width), static_cast<float>(size.height)},
      {0, static_cast<float>(size.height)}};
  cv::perspectiveTransform(corners, corners, grid.inv());
  const cv::Rect cells = cv::boundingRect(corners);
  cv::Mat lines = cv::Mat::zeros(size, CV_8U);
  if (cells.width > size.width || cells.height > size.height) return lines;
  const auto draw = [&](cv::Point2f from, cv::Point2f to) {
    std::vector<cv::Point2f> ends = {from, to};
    cv::perspectiveTransform(ends, ends, grid);
    cv::line(lines, cv::Point(16.0F * ends[0]), cv::Point(16.0F * ends[1]), 255, thick_px,
             cv::LINE_8, 4);
  };
  const auto left = static_cast<float>(cells.x) - 0.5F, top = static_cast<float>(cells.y) - 0.5F;
  const float right = left + static_cast<float>(cells.width) + 1.0F;
  const float bottom = top + static_cast<float>(cells.height) + 1.0F;
  for (float x = left; x <= right; x += 1.0F) draw({x, top}, {x, bottom});
  for (float y = top; y <= bottom; y += 1.0F) draw({left, y}, {right, y});
  return lines;
}

}  // namespace

cv::Mat withoutSquares(const cv::Mat& ink, double stroke_px) {
  const PaperPieces pieces = paperPieces(ink, stroke_px);
  const std::vector<int> squares = equalSquares(pieces);
  if (squares.empty()) return {};
  const auto grid = gridOf(pieces, squares);
  if (!grid) return cv::Mat::zeros(ink.size(), CV_8U);
  const int line_px = static_cast<int>(std::ceil(stroke_px)) + 2;
  const cv::Mat lines = gridLines(*grid, ink.size(), line_px);
  // Strokes along a line are thicker than it.
  cv::Mat thicker = pieces.off_paper_px > kThicker * (stroke_px / 2.0 + 0.5);
  cv::dilate(thicker, thicker, disc(line_px / 2 + 1));
  cv::Mat strokes = ink & (~lines | thicker);
  cv::Mat joined;
  cv::morphologyEx(strokes, joined, cv::MORPH_CLOSE, disc(line_px));
  return strokes | (joined & ink & lines);
}

}  // namespace handmap
