#include "core/map_match/grid_place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

#include <Eigen/Cholesky>
#include <opencv2/imgproc.hpp>

#include "core/base/parallel.h"
#include "core/geometry/to_outer.h"
#include "core/map_match/constants.h"
#include "core/trajectory/scan_features.h"

namespace handmap {

namespace {

using namespace map_match;

/// Metres to the cells of a picture, and back.
struct Raster {
  Vec2 low = Vec2::Zero();
  double cell_m = 1.0;
  cv::Size size;

  static Raster around(const std::vector<Vec2>& points, double margin_m, double cell_m) {
    Vec2 low = points.front();
    Vec2 high = low;
    for (const Vec2& p : points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    low.array() -= margin_m;
    high.array() += margin_m;
    Raster raster{low, std::max(cell_m, std::sqrt((high - low).prod() / kMostPixels)), {}};
    const Vec2 cells = ((high - low) / raster.cell_m).array().ceil() + 1.0;
    raster.size = {static_cast<int>(cells.x()), static_cast<int>(cells.y())};
    return raster;
  }
  cv::Point at(const Vec2& p) const {
    const Vec2 cell = ((p - low) / cell_m).array().floor();
    return {static_cast<int>(cell.x()), static_cast<int>(cell.y())};
  }
  bool has(const cv::Point& cell) const {
    return cell.x >= 0 && cell.y >= 0 && cell.x < size.width && cell.y < size.height;
  }
};

/// Points of the drawn walls, with normals outwards, and the nearest of them from anywhere.
class Walls {
 public:
  explicit Walls(const Map& drawing) {
    for (const Building& building : drawing.buildings) {
      const Polygon outline = building.footprint();
      outlines_.push_back(outline);
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const Segment wall{outline[i], outline[(i + 1) % outline.size()]};
        const int pieces = std::max(1, static_cast<int>(std::lround(wall.length() / kWallStep_m)));
        const Vec2 normal = -perpendicular(wall.b - wall.a).normalized();
        for (int k = 0; k < pieces; ++k) {
          points_.push_back({wall.a + (k + 0.5) / pieces * (wall.b - wall.a), normal});
        }
      }
    }
    std::vector<Vec2> places;
    for (const ScanPoint& p : points_) places.push_back(p.at);
    raster_ = Raster::around(places, kMargin_m, 0.25);
    cv::Mat1b free(raster_.size, std::uint8_t{1});
    for (const Vec2& place : places) free(raster_.at(place)) = 0;
    cv::distanceTransform(free, distance_, labels_, cv::DIST_L2, 5, cv::DIST_LABEL_PIXEL);
    nearest_.resize(places.size() + 1);
    for (std::size_t i = 0; i < places.size(); ++i) {
      nearest_[static_cast<std::size_t>(labels_(raster_.at(places[i])))] = i;
    }
  }

  const std::vector<ScanPoint>& points() const { return points_; }
  const std::vector<Polygon>& outlines() const { return outlines_; }
  const ScanPoint* nearest(const Vec2& place) const {
    const cv::Point cell = raster_.at(place);
    if (!raster_.has(cell)) return nullptr;
    return &points_[nearest_[static_cast<std::size_t>(labels_(cell))]];
  }

 private:
  std::vector<Polygon> outlines_;
  std::vector<ScanPoint> points_;
  Raster raster_;
  cv::Mat1f distance_;
  cv::Mat1i labels_;
  std::vector<std::size_t> nearest_;
};

/// The robot's map, asked by place.
class Ground {
 public:
  explicit Ground(const SeenGround& seen) {
    std::vector<Vec2> all = seen.edges;
    all.insert(all.end(), seen.free.begin(), seen.free.end());
    raster_ = Raster::around(all, kMargin_m, seen.cell_m);
    cv::Mat1b empty(raster_.size, std::uint8_t{1});
    for (const Vec2& p : seen.edges) empty(raster_.at(p)) = 0;
    cv::distanceTransform(empty, distance_, cv::DIST_L2, 5);
    free_ = cv::Mat1b(raster_.size, std::uint8_t{0});
    for (const Vec2& p : seen.free) free_(raster_.at(p)) = 1;
    const int around = 2 * static_cast<int>(std::lround(kWallStep_m / raster_.cell_m)) + 1;
    cv::dilate(free_, free_, cv::getStructuringElement(cv::MORPH_RECT, {around, around}));
  }
  /// From an occupied cell, metres.
  double distance(const Vec2& place) const {
    const cv::Point cell = raster_.at(place);
    return raster_.has(cell) ? distance_(cell) * raster_.cell_m : kMargin_m;
  }
  bool isFree(const Vec2& place) const {
    const cv::Point cell = raster_.at(place);
    return raster_.has(cell) && free_(cell) != 0;
  }

 private:
  Raster raster_;
  cv::Mat1f distance_;
  cv::Mat1b free_;
};

struct Candidate {
  Pose2 pose;
  double score = 0.0;
};

template <typename Point>
std::vector<Point> everyNth(const std::vector<Point>& points, std::size_t most) {
  std::vector<Point> some;
  const std::size_t stride = points.size() / most + 1;
  for (std::size_t i = 0; i < points.size(); i += stride) some.push_back(points[i]);
  return some;
}

/// Correlates what was seen, at one turn after the other, with walls and insides of buildings.
class Coarse {
 public:
  Coarse(const Walls& walls, const std::vector<Vec2>& straight, const std::vector<Vec2>& free)
      : straight_(straight), free_(free) {
    for (const Vec2& p : straight_) middle_ += p / static_cast<double>(straight_.size());
    for (const Vec2& p : straight_) reach_ = std::max(reach_, (p - middle_).norm());
    std::vector<Vec2> places;
    for (const ScanPoint& p : walls.points()) places.push_back(p.at);
    const Raster own = Raster::around(places, kMargin_m, 1.0);
    const double span =
        std::max(own.size.width, own.size.height) * own.cell_m + 2.0 * reach_;  // no wrap-around
    cell_m_ = std::max(0.5, span / kMostSide);
    side_ = cv::getOptimalDFTSize(static_cast<int>(std::ceil(span / cell_m_)));
    raster_ = {own.low, cell_m_, {side_, side_}};
    sigma_m_ = std::max(2.0, 1.5 * cell_m_);
    cv::Mat1b outside(side_, side_, std::uint8_t{1});
    for (const Vec2& place : places) outside(raster_.at(place)) = 0;
    cv::Mat1f near;
    cv::distanceTransform(outside, near, cv::DIST_L2, 5);
    cv::Mat1f kernel;
    cv::Mat(near.mul(near) * (-0.5 * cell_m_ * cell_m_ / (sigma_m_ * sigma_m_))).copyTo(kernel);
    cv::exp(kernel, kernel);
    cv::Mat1b inside(side_, side_, std::uint8_t{0});
    for (const Polygon& outline : walls.outlines()) {
      std::vector<cv::Point> corners;
      for (const Vec2& corner : outline) corners.push_back(raster_.at(corner));
      cv::fillPoly(inside, std::vector<std::vector<cv::Point>>{corners}, cv::Scalar(1));
    }
    cv::Mat1f filled;
    inside.convertTo(filled, CV_32F);
    filled.setTo(0.0, near * cell_m_ < kInside_m);
    cv::dft(kernel, walls_);
    cv::dft(filled, insides_);
  }

  /// Best places of all turns.
  std::vector<Candidate> search(const std::stop_token& stop) const {
    const double step =
        std::clamp(sigma_m_ / std::max(reach_, 1.0), toRadians(0.5), toRadians(3.0));
    const auto turns = static_cast<std::size_t>(std::ceil(2.0 * kPi / step));
    std::vector<std::array<Candidate, kOfOneTurn>> found(turns);
    parallelFor(turns, [&](std::size_t i) {
      if (!stop.stop_requested()) {
        found[i] = atTurn(2.0 * kPi * static_cast<double>(i) / static_cast<double>(turns));
      }
    });
    std::vector<Candidate> all;
    for (const auto& some : found) all.insert(all.end(), some.begin(), some.end());
    return all;
  }
  const Vec2& middle() const { return middle_; }

 private:
  cv::Mat1f pictureOf(const std::vector<Vec2>& points, double turn) const {
    cv::Mat1f picture(side_, side_, 0.0F);
    const ToOuter turned({0.0, 0.0, turn});
    for (const Vec2& p : points) {
      // About the corner of the picture, around which it wraps.
      const Vec2 cell = (turned(p - middle_) / cell_m_).array().round();
      const auto wrapped = [&](double v) {
        return ((static_cast<int>(v) % side_) + side_) % side_;
      };
      picture(wrapped(cell.y()), wrapped(cell.x())) += 1.0F / static_cast<float>(points.size());
    }
    return picture;
  }

  std::array<Candidate, kOfOneTurn> atTurn(double turn) const {
    cv::Mat seen;
    cv::dft(pictureOf(straight_, turn), seen);
    cv::Mat scores;
    cv::mulSpectrums(walls_, seen, scores, 0, true);
    if (!free_.empty()) {
      cv::Mat free;
      cv::dft(pictureOf(free_, turn), free);
      cv::Mat conflict;
      cv::mulSpectrums(insides_, free, conflict, 0, true);
      scores -= conflict;
    }
    cv::dft(scores, scores, cv::DFT_INVERSE | cv::DFT_SCALE);
    std::array<Candidate, kOfOneTurn> best;
    for (Candidate& one : best) {
      cv::Point at;
      cv::minMaxLoc(scores, nullptr, &one.score, nullptr, &at);
      const Vec2 place = raster_.low + cell_m_ * Vec2(at.x + 0.5, at.y + 0.5);
      const Vec2 origin = place - Pose2{0.0, 0.0, turn}.toOuter(middle_);
      one.pose = {origin.x(), origin.y(), turn};
      cv::circle(scores, at, static_cast<int>(std::ceil(2.0 * sigma_m_ / cell_m_)),
                 cv::Scalar(-1.0), cv::FILLED);
    }
    return best;
  }

  const std::vector<Vec2>& straight_;
  const std::vector<Vec2>& free_;
  Vec2 middle_ = Vec2::Zero();
  double reach_ = 0.0;
  double cell_m_ = 1.0;
  double sigma_m_ = 2.0;
  int side_ = 0;
  Raster raster_;
  cv::Mat walls_;
  cv::Mat insides_;
};

bool isSamePlace(const Pose2& a, const Pose2& b, const Vec2& middle, double reach_m) {
  return (a.toOuter(middle) - b.toOuter(middle)).norm() < reach_m &&
         std::abs(normalizedAngle(a.heading - b.heading)) < toRadians(12.0);
}

/// The best, none at the place of a better one.
std::vector<Candidate> distinct(std::vector<Candidate> all, const Vec2& middle, double reach_m,
                                std::size_t most) {
  std::stable_sort(all.begin(), all.end(),
                   [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
  std::vector<Candidate> kept;
  for (const Candidate& one : all) {
    if (kept.size() == most) break;
    const bool is_new = std::none_of(kept.begin(), kept.end(), [&](const Candidate& other) {
      return isSamePlace(one.pose, other.pose, middle, reach_m);
    });
    if (is_new) kept.push_back(one);
  }
  return kept;
}

struct Similarity {
  Pose2 pose = {};
  double scale = 1.0;
  double scale_sigma = 0.0;
};

/// Gauss-Newton of straight pieces onto the lines of the walls, x, y, turn and, where it is not
/// held, scale, about `middle`.
Similarity laid(const std::vector<ScanPoint>& seen, const Walls& walls, const Vec2& middle,
                Pose2 start, bool holds_scale) {
  Similarity state{{}, 1.0, 0.0};
  Vec2 place = start.toOuter(middle);
  double turn = start.heading;
  for (const double gate_m : {6.0, 6.0, 4.0, 4.0, 2.5, 2.5, 1.5, 1.5, 1.5, 1.5}) {
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d gradient = Eigen::Vector4d::Zero();
    double squares = 0.0;
    double weights = 0.0;
    const ToOuter turned({0.0, 0.0, turn});
    for (const ScanPoint& p : seen) {
      const Vec2 arm = state.scale * turned(p.at - middle);
      const ScanPoint* wall = walls.nearest(place + arm);
      if (!wall) continue;
      if (std::abs(wall->normal.dot(turned.turned(p.normal))) < kSameNormal) continue;
      if ((place + arm - wall->at).norm() > 2.0 * gate_m) continue;
      const double residual = wall->normal.dot(place + arm - wall->at);
      const double ratio = residual / (0.4 * gate_m);
      const double weight = 1.0 / (1.0 + ratio * ratio);
      Eigen::Vector4d slope;
      slope << wall->normal, wall->normal.dot(perpendicular(arm)),
          wall->normal.dot(arm) / state.scale;
      normal += weight * slope * slope.transpose();
      gradient += weight * residual * slope;
      squares += weight * residual * residual;
      weights += weight;
    }
    if (weights < 10.0) break;
    normal.diagonal() += Eigen::Vector4d(1e-3, 1e-3, 1e-3, holds_scale ? 1e12 : 1e-3);
    const Eigen::Vector4d step = -normal.ldlt().solve(gradient);
    if (!step.allFinite()) break;
    place += step.head<2>();
    turn += step[2];
    state.scale = std::clamp(state.scale + step[3], 0.7, 1.4);
    // Neighbouring pieces are off together: a building is one look, of some 40 of them.
    state.scale_sigma =
        std::sqrt(kShared * squares / weights * Eigen::Matrix4d(normal.inverse())(3, 3));
  }
  const Vec2 origin = place - state.scale * Pose2{0.0, 0.0, turn}.toOuter(middle);
  state.pose = {origin.x(), origin.y(), normalizedAngle(turn)};
  return state;
}

/// What holds for a place, by the drawn walls that face what was seen.
struct Verdict {
  double supported = 0.0;
  double median_m = 0.0;
  double most_m = 0.0;
  double near = 0.0;      ///< share of the straight pieces that lie on walls
  double conflict = 0.0;  ///< share of the free ground within buildings
  double score() const { return std::sqrt(supported * near) - conflict; }
};

Verdict judged(const Pose2& pose, const std::vector<ScanPoint>& seen, const std::vector<Vec2>& free,
               const Ground& ground, const Walls& walls, double gate_m) {
  Verdict verdict;
  std::vector<double> distances;
  int facing = 0;
  for (const ScanPoint& wall : walls.points()) {
    bool faces = false;
    for (double out_m = 0.5; out_m <= kFaces_m && !faces; out_m += 0.5) {
      faces = ground.isFree(pose.toOwn(wall.at + out_m * wall.normal));
    }
    if (!faces) continue;
    ++facing;
    const double distance = ground.distance(pose.toOwn(wall.at));
    if (distance <= gate_m) distances.push_back(distance);
  }
  if (distances.empty()) return verdict;
  std::sort(distances.begin(), distances.end());
  const auto n = static_cast<double>(distances.size());
  verdict.supported = n / facing;
  verdict.median_m = distances[distances.size() / 2];
  verdict.most_m = distances[static_cast<std::size_t>(0.9 * n)];
  for (const ScanPoint& p : moved(seen, pose)) {
    const ScanPoint* wall = walls.nearest(p.at);
    verdict.near += wall && std::abs(wall->normal.dot(p.normal)) > kSameNormal &&
                    (wall->at - p.at).norm() < gate_m;
  }
  verdict.near /= static_cast<double>(seen.size());
  const ToOuter outer(pose);
  for (const Vec2& p : free) {
    const Vec2 at = outer(p);
    const ScanPoint* wall = walls.nearest(at);
    verdict.conflict += wall && wall->normal.dot(at - wall->at) < -gate_m;
  }
  if (!free.empty()) verdict.conflict /= static_cast<double>(free.size());
  return verdict;
}

/// Steps from cell to cell are no thickness of a wall: cells are looked at as if they were small.
std::vector<ScanPoint> straightPieces(const SeenGround& seen) {
  const double scale = std::min(1.0, kSmall_m / seen.cell_m);
  std::vector<Vec2> edges = seen.edges;
  for (Vec2& p : edges) p *= scale;
  std::vector<ScanPoint> straight;
  for (const ScanPoint& p : standingFeatures(edges)) {
    if (p.straight()) straight.push_back({p.at / scale, p.normal});
  }
  return everyNth(straight, kMostPieces);
}

}  // namespace

std::optional<GridPlace> placeOf(const SeenGround& seen, const Map& drawing,
                                 const std::stop_token& stop) {
  const std::vector<ScanPoint> straight = straightPieces(seen);
  if (straight.size() < 10 || drawing.buildings.empty()) return std::nullopt;
  const Walls walls(drawing);
  const Ground ground(seen);
  std::vector<Vec2> places;
  for (const ScanPoint& p : straight) places.push_back(p.at);
  const std::vector<Vec2> free = everyNth(seen.free, kMostPieces);
  const Coarse coarse(walls, places, free);
  const double gate_m = std::max(1.0, drawing.uncertainty.position);
  std::vector<Candidate> best =
      distinct(coarse.search(stop), coarse.middle(), kSameByFar_m, kCandidates);
  parallelFor(best.size(), [&](std::size_t i) {
    if (stop.stop_requested()) return;
    best[i].pose = laid(straight, walls, coarse.middle(), best[i].pose, true).pose;
    best[i].score = judged(best[i].pose, straight, free, ground, walls, gate_m).score();
  });
  if (stop.stop_requested()) return std::nullopt;
  const double same_m = std::max(kSameByFar_m, kSameSigmas * drawing.uncertainty.position);
  best = distinct(best, coarse.middle(), same_m, 2);
  const Similarity stretched = laid(straight, walls, coarse.middle(), best[0].pose, false);
  const Verdict verdict = judged(best[0].pose, straight, free, ground, walls, gate_m);
  GridPlace place;
  place.pose = best[0].pose;
  place.supported = verdict.supported;
  place.median_m = verdict.median_m;
  place.most_m = verdict.most_m;
  place.scale = stretched.scale;
  place.scale_sigma = stretched.scale_sigma;
  place.fits = verdict.supported >= kLeastSupported;
  if (best.size() > 1 && best[1].score > kNearlyAsWell * best[0].score) place.other = best[1].pose;
  return place;
}

}  // namespace handmap
