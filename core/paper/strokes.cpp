#include "core/paper/strokes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>

#include <opencv2/imgproc.hpp>

namespace handmap {

namespace {

const std::array<cv::Point, 8> kAround = {cv::Point{0, -1}, {1, -1}, {1, 0},  {1, 1},
                                          {0, 1},           {-1, 1}, {-1, 0}, {-1, -1}};
constexpr double kAhead = 0.6;    // cosine of the widest angle between a stroke and its bridge
constexpr int kThickest_px = 60;  // half of it: what is thicker is no stroke
constexpr std::size_t kMostEnds = 3000;
constexpr int kDirection_px = 12;  // of the stroke's end that tells where it goes

std::uint8_t neighbours(const cv::Mat& lines, const cv::Point& p) {
  std::uint8_t bits = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    const cv::Point q = p + kAround[i];
    if (lines.at<std::uint8_t>(q) != 0) bits = static_cast<std::uint8_t>(bits | 1u << i);
  }
  return bits;
}

bool removable(std::uint8_t bits, bool second) {
  int count = 0;
  int steps = 0;
  for (unsigned i = 0; i < 8; ++i) {
    const bool here = (bits >> i & 1) != 0;
    const bool next = (bits >> ((i + 1) % 8) & 1) != 0;
    count += here;
    steps += !here && next;
  }
  if (count < 2 || count > 6 || steps != 1) return false;
  const bool up = (bits & 1) != 0, right = (bits & 4) != 0, down = (bits & 16) != 0,
             left = (bits & 64) != 0;
  return second ? !(up && right && left) && !(up && down && left)
                : !(up && right && down) && !(right && down && left);
}

/// The pixels of the lines that can be walked to from `end` in so many steps.
std::vector<cv::Point> walked(const cv::Mat& thin, const cv::Point& end, int steps) {
  std::vector<cv::Point> seen = {end};
  std::size_t from = 0;
  for (int step = 0; step < steps; ++step) {
    const std::size_t to = seen.size();
    for (; from < to; ++from) {
      for (const cv::Point& d : kAround) {
        const cv::Point q = seen[from] + d;
        if (thin.at<std::uint8_t>(q) == 0) continue;
        if (std::find(seen.begin(), seen.end(), q) == seen.end()) seen.push_back(q);
      }
    }
  }
  return seen;
}

/// A stroke that soon meets another or ends: of a letter or a hatching.
bool isLetter(const cv::Mat& thin, const cv::Point& end, double least_px) {
  const auto length = static_cast<double>(walked(thin, end, static_cast<int>(least_px)).size());
  return length < least_px || length > 1.2 * least_px;  // thinned lines have steps
}

bool inside(const cv::Mat& image, const cv::Point& p) {
  return p.x > 0 && p.y > 0 && p.x < image.cols - 1 && p.y < image.rows - 1;
}

std::optional<cv::Point> meantFor(const cv::Mat& thin, const cv::Point& end, double reach_px) {
  const int reach = static_cast<int>(reach_px);
  const std::vector<cv::Point> own = walked(thin, end, 2 * reach);
  const cv::Point back = walked(thin, end, kDirection_px).back();
  const cv::Point2d way = cv::Point2d(end - back) / std::max(1.0, cv::norm(end - back));
  std::optional<cv::Point> best;
  double least = reach_px;
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const cv::Point q = end + cv::Point(dx, dy);
      const double distance = std::hypot(dx, dy);
      if (!inside(thin, q) || distance >= least || thin.at<std::uint8_t>(q) == 0) continue;
      if (std::find(own.begin(), own.end(), q) != own.end()) continue;
      const bool ahead = way.dot(cv::Point2d(q - end)) > kAhead * distance;
      const bool is_end =
          cv::norm(q - end) < reach_px / 2 && std::popcount(neighbours(thin, q)) == 1;
      if (!ahead && !is_end) continue;
      least = distance;
      best = q;
    }
  }
  return best;
}

}  // namespace

cv::Mat thinned(const cv::Mat& ink) {
  cv::Mat lines = ink.clone();
  cv::rectangle(lines, {0, 0}, {lines.cols - 1, lines.rows - 1}, 0, 1);
  std::vector<cv::Point> left;
  cv::findNonZero(lines, left);
  std::vector<cv::Point> gone;
  bool changed = true;
  for (int round = 0; changed && round < kThickest_px; ++round) {
    changed = false;
    for (const bool second : {false, true}) {
      gone.clear();
      for (const cv::Point& p : left) {
        if (removable(neighbours(lines, p), second)) gone.push_back(p);
      }
      for (const cv::Point& p : gone) lines.at<std::uint8_t>(p) = 0;
      changed = changed || !gone.empty();
    }
    std::erase_if(left, [&](const cv::Point& p) { return lines.at<std::uint8_t>(p) == 0; });
  }
  return lines;
}

std::vector<std::pair<cv::Point, cv::Point>> bridges(const cv::Mat& thin, double reach_px) {
  std::vector<cv::Point> lines;
  cv::findNonZero(thin, lines);
  std::vector<std::pair<cv::Point, cv::Point>> found;
  std::size_t ends = 0;
  for (const cv::Point& p : lines) {
    if (std::popcount(neighbours(thin, p)) != 1) continue;
    if (++ends > kMostEnds) break;
    if (isLetter(thin, p, 2.0 * reach_px)) continue;
    if (const auto q = meantFor(thin, p, reach_px)) found.emplace_back(p, *q);
  }
  return found;
}

}  // namespace handmap
