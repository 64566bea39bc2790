#include "core/paper/sheet_marks.h"

#include <algorithm>
#include <cmath>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "core/recording/image_file.h"

namespace handmap {

namespace {

constexpr double kBeyond_mm = 8.0;        // of the middle of a mark from the corner of the grid
constexpr double kLeastSide = 1 / 200.0;  // of a mark, to the longer side of the photo
constexpr double kMostSide = 1 / 6.0;
constexpr double kLeastMarkLevels = 25.0;  // grey levels between its black and its white
constexpr double kBlack = 0.65;            // of what the paper is as bright as, at most
constexpr int kLeastPhoto_px = 100;        // of a smaller one no cell could be told from the next
constexpr std::size_t kMostMarks = 24;     // what else looks like one

struct Mark {
  Quad corners;
  cv::Point2f middle;
  bool first = false;
};

cv::Point2f onPaper(const Vec2& place_mm) {
  return {static_cast<float>(place_mm.x()), static_cast<float>(place_mm.y())};
}

double greyAt(const cv::Mat& grey, const cv::Point2f& at) {
  const int x = static_cast<int>(std::lround(at.x)), y = static_cast<int>(std::lround(at.y));
  if (x < 1 || y < 1 || x >= grey.cols - 1 || y >= grey.rows - 1) return -1.0;
  return cv::mean(grey(cv::Rect(x - 1, y - 1, 3, 3)))[0];
}

/// Whether the four-sided outline is that of a mark: each ring of cells as it is to be.
std::optional<Mark> markIn(const cv::Mat& grey, const std::vector<cv::Point2f>& corners) {
  const Quad cells = {
      cv::Point2f{0, 0}, {kMarkCells, 0}, {kMarkCells, kMarkCells}, {0, kMarkCells}};
  const cv::Mat to_photo = cv::getPerspectiveTransform(cells.data(), corners.data());
  std::vector<cv::Point2f> places;
  for (int i = 0; i < kMarkCells * kMarkCells; ++i) {
    places.emplace_back(static_cast<float>(i % kMarkCells) + 0.5F,
                        static_cast<float>(i / kMarkCells) + 0.5F);
  }
  cv::perspectiveTransform(places, places, to_photo);
  double black = 0.0, white = 255.0;  // the lightest of what is to be black, and the reverse
  for (int i = 0; i < kMarkCells * kMarkCells; ++i) {
    const int ring = std::max(std::abs(i % kMarkCells - 3), std::abs(i / kMarkCells - 3));
    const double here = greyAt(grey, places[static_cast<std::size_t>(i)]);
    if (here < 0.0) return std::nullopt;
    if (ring == 2) white = std::min(white, here);
    if (ring == 1 || ring == 3) black = std::max(black, here);
  }
  if (white - black < kLeastMarkLevels) return std::nullopt;
  Mark mark;
  std::copy(corners.begin(), corners.end(), mark.corners.begin());
  const auto middle = static_cast<std::size_t>(kMarkCells * kMarkCells / 2);
  mark.middle = places[middle];
  mark.first = greyAt(grey, mark.middle) > (white + black) / 2.0;
  return mark;
}

std::vector<Mark> marksOn(const cv::Mat& grey) {
  const int side = std::max(grey.cols, grey.rows);
  cv::Mat dark;
  cv::adaptiveThreshold(grey, dark, 255, cv::ADAPTIVE_THRESH_MEAN_C, cv::THRESH_BINARY_INV,
                        std::max(5, side / 50) | 1, 10);
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(dark, contours, cv::RETR_LIST, cv::CHAIN_APPROX_SIMPLE);
  std::vector<Mark> marks;
  for (const auto& contour : contours) {
    const double root = std::sqrt(cv::contourArea(contour));
    if (root < kLeastSide * side || root > kMostSide * side) continue;
    std::vector<cv::Point> hull, corners;
    cv::convexHull(contour, hull);
    cv::approxPolyDP(hull, corners, 0.05 * cv::arcLength(hull, true), true);
    if (corners.size() != 4 || !cv::isContourConvex(corners)) continue;
    std::vector<cv::Point2f> fine(corners.begin(), corners.end());
    const int window = std::clamp(static_cast<int>(root / 10.0), 1, 5);
    cv::cornerSubPix(grey, fine, {window, window}, {-1, -1},
                     {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 20, 0.05});
    const auto mark = markIn(grey, fine);
    const bool again = mark && std::ranges::any_of(marks, [&](const Mark& known) {
                         return cv::norm(known.middle - mark->middle) < root / 2.0;
                       });
    if (mark && !again) marks.push_back(*mark);
    if (marks.size() == kMostMarks) break;
  }
  return marks;
}

/// From the one that differs on, clockwise as the photo shows them. Empty: not these.
std::vector<Mark> inOrder(std::vector<Mark> marks) {
  if (marks.size() != 4) return {};
  cv::Point2f centre;
  for (const Mark& mark : marks) centre += mark.middle * 0.25F;
  std::ranges::sort(marks, {}, [&](const Mark& mark) {
    return std::atan2(mark.middle.y - centre.y, mark.middle.x - centre.x);
  });
  const auto first = std::ranges::find_if(marks, &Mark::first);
  if (first == marks.end() || std::ranges::count_if(marks, &Mark::first) != 1) return {};
  std::rotate(marks.begin(), first, marks.end());
  std::vector<cv::Point2f> middles;
  for (const Mark& mark : marks) middles.push_back(mark.middle);
  return cv::isContourConvex(middles) ? marks : std::vector<Mark>();
}

/// From millimetres of the sheet to pixels, by all corners of all marks.
cv::Mat placed(const std::vector<Mark>& marks) {
  std::vector<cv::Point2f> middles, paper, photo;
  std::vector<cv::Point2f> middles_mm;
  for (std::size_t i = 0; i < 4; ++i) {
    middles.push_back(marks[i].middle);
    middles_mm.push_back(onPaper(markPlaces()[i]));
  }
  const cv::Mat rough = cv::getPerspectiveTransform(middles, middles_mm);
  for (std::size_t i = 0; i < 4; ++i) {
    std::vector<cv::Point2f> seen(marks[i].corners.begin(), marks[i].corners.end()), there;
    cv::perspectiveTransform(seen, there, rough);
    for (std::size_t k = 0; k < 4; ++k) {
      const cv::Point2f off = there[k] - middles_mm[i];
      const auto half = static_cast<float>(kMark_mm / 2.0);
      paper.push_back(middles_mm[i] +
                      cv::Point2f(std::copysign(half, off.x), std::copysign(half, off.y)));
      photo.push_back(seen[k]);
    }
  }
  return cv::findHomography(paper, photo);
}

/// Whether the cell is darker than the paper above and below it: a shadow covers all three.
bool isBlack(const cv::Mat& grey, const cv::Mat& to_photo, const Vec2& cell) {
  const Vec2 beside(0.0, 1.05 * kCodeCell_mm);
  std::vector<cv::Point2f> places = {onPaper(cell), onPaper(cell + beside), onPaper(cell - beside)};
  cv::perspectiveTransform(places, places, to_photo);
  const double paper = (greyAt(grey, places[1]) + greyAt(grey, places[2])) / 2.0;
  return greyAt(grey, places[0]) < kBlack * paper;
}

std::optional<SheetCode> readCode(const cv::Mat& grey, const cv::Mat& to_photo) {
  std::array<bool, kCodeCells> cells{};
  for (int i = 0; i < kCodeCells; ++i)
    cells[static_cast<std::size_t>(i)] = isBlack(grey, to_photo, codePlace(i));
  auto code = codeOf(cells);
  if (!code || !code->of_map) return code;
  std::array<bool, kPlaceCells> place{};
  for (int i = 0; i < kPlaceCells; ++i)
    place[static_cast<std::size_t>(i)] = isBlack(grey, to_photo, placeCellPlace(i));
  code->corner = cornerOf(place);
  return code;
}

/// The remainder by x⁸ + x² + x + 1 (CRC-8 of ITU I.432.1), of 30 bits.
unsigned checkOf(unsigned bits) {
  unsigned rest = 0x55;  // so that white cells are none
  for (int i = 29; i >= 0; --i) {
    const bool carry = ((rest >> 7U) ^ (bits >> static_cast<unsigned>(i))) & 1U;
    rest = (rest << 1U) & 0xFFU;
    if (carry) rest ^= 0x07U;
  }
  return rest;
}

}  // namespace

std::array<Vec2, 4> markPlaces() {
  const double right = kSheetWidth_mm + kBeyond_mm, top = kSheetHeight_mm + kBeyond_mm;
  return {Vec2(-kBeyond_mm, top), Vec2(right, top), Vec2(right, -kBeyond_mm),
          Vec2(-kBeyond_mm, -kBeyond_mm)};
}

std::array<bool, kCodeCells> codeCells(const SheetCode& code) {
  const auto at =
      static_cast<unsigned>(std::ranges::find(kSquares_m, code.square_m) - kSquares_m.begin());
  std::array<bool, kCodeCells> cells = {true,           (at & 4U) != 0, (at & 2U) != 0,
                                        (at & 1U) != 0, code.of_map,    false};
  cells.back() = std::ranges::count(cells, true) % 2 == 0;
  return cells;
}

Vec2 codePlace(int cell) {
  return {kSheetWidth_mm / 2.0 + (cell + 0.5 - kCodeCells / 2.0) * kCodeCell_mm,
          kSheetHeight_mm + kBeyond_mm};
}

std::optional<SheetCode> codeOf(const std::array<bool, kCodeCells>& cells) {
  if (!cells[0] || std::ranges::count(cells, true) % 2 == 0) return std::nullopt;
  const std::size_t at = (cells[1] ? 4U : 0U) + (cells[2] ? 2U : 0U) + (cells[3] ? 1U : 0U);
  return SheetCode{kSquares_m[at], cells[4], {}};
}

std::array<bool, kPlaceCells> placeCells(const SheetCode& code) {
  std::array<bool, kPlaceCells> cells{};
  if (!code.corner) return cells;
  constexpr unsigned kMask = 0x7FFF;
  const unsigned bits = (static_cast<unsigned>((*code.corner)[0]) & kMask) << 15U |
                        (static_cast<unsigned>((*code.corner)[1]) & kMask);
  const std::uint64_t all = static_cast<std::uint64_t>(bits) << 8U | checkOf(bits);
  for (std::size_t i = 0; i < cells.size(); ++i)
    cells[i] = (all >> (cells.size() - 1 - i) & 1U) != 0;
  return cells;
}

Vec2 placeCellPlace(int cell) {
  constexpr int kHalf = kPlaceCells / 2;
  return codePlace(cell < kHalf ? cell - kHalf - 1 : cell - kHalf + kCodeCells + 1);
}

std::optional<std::array<int, 2>> cornerOf(const std::array<bool, kPlaceCells>& cells) {
  std::uint64_t all = 0;
  for (const bool cell : cells) all = all << 1U | static_cast<std::uint64_t>(cell);
  const auto bits = static_cast<unsigned>(all >> 8U);
  if (checkOf(bits) != (all & 0xFFU)) return std::nullopt;
  const auto signedOf = [](unsigned value) {
    return static_cast<int>(value & 0x3FFFU) - static_cast<int>(value & 0x4000U);
  };
  return std::array{signedOf(bits >> 15U & 0x7FFFU), signedOf(bits & 0x7FFFU)};
}

std::optional<SeenSheet> sheetOn(const cv::Mat& photo) {
  if (std::min(photo.cols, photo.rows) < kLeastPhoto_px) return std::nullopt;
  const cv::Mat grey = greyImage(photo);
  const std::vector<Mark> marks = inOrder(marksOn(grey));
  if (marks.empty()) return std::nullopt;
  const cv::Mat to_photo = placed(marks);
  if (to_photo.empty()) return std::nullopt;
  const auto code = readCode(grey, to_photo);
  if (!code) return std::nullopt;
  std::vector<cv::Point2f> grid = {onPaper({0.0, kSheetHeight_mm}),
                                   onPaper({kSheetWidth_mm, kSheetHeight_mm}),
                                   onPaper({kSheetWidth_mm, 0.0}), onPaper({0.0, 0.0})};
  cv::perspectiveTransform(grid, grid, to_photo);
  return SeenSheet{{grid[0], grid[1], grid[2], grid[3]}, *code};
}

}  // namespace handmap
