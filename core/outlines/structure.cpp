#include "core/outlines/structure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/base/gaussian.h"
#include "core/base/median.h"
#include "core/outlines/constants.h"
#include "core/perception/constants.h"

namespace handmap {

using namespace outlines;

namespace {

/// Weighted moments of the returns in a cell.
struct Moments {
  double count = 0.0, weight = 0.0, noise = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  void add(double px, double py, double w, double variance) {
    count += 1.0;
    weight += w;
    noise += w * variance;
    x += w * px;
    y += w * py;
    xx += w * px * px;
    xy += w * px * py;
    yy += w * py * py;
  }
  void add(const Moments& m) {
    count += m.count;
    weight += m.weight;
    noise += m.noise;
    x += m.x;
    y += m.y;
    xx += m.xx;
    xy += m.xy;
    yy += m.yy;
  }
};

struct Piece {
  Structure structure = Structure::Ragged;
  Vec2 middle = Vec2::Zero();
  Vec2 normal = Vec2::Zero();
};

/// Orders cells by column, and in it by row.
std::int64_t keyOf(int column, int row) {
  // Rows below zero come before those above.
  return (static_cast<std::int64_t>(column) << 32) |
         (static_cast<std::uint32_t>(row) ^ (1U << 31U));
}
int cellOf(double metres) { return static_cast<int>(std::floor(metres / kCell_m)); }

class Cells {
 public:
  Cells(const std::vector<PlacedRay>& rays, const RangeNoise& noise, const std::stop_token& stop) {
    std::unordered_map<std::int64_t, std::size_t> places;
    for (const PlacedRay& ray : rays) {
      if (stop.stop_requested()) return;
      if (ray.echo != Echo::Tall) continue;
      const auto range = static_cast<double>(ray.range);
      const double sigma = noise.at(range);
      // As imprecise as stereo is there, they make a line of anything.
      if (range > perception::kFar_m && sigma > kPlace_m) continue;
      const Vec2 end = ray.end();
      const double variance = sigma * sigma;
      const double weight = static_cast<double>(ray.share) / (variance + kPoses_m2);
      const int column = cellOf(end.x());
      const int row = cellOf(end.y());
      const auto [place, is_new] = places.try_emplace(keyOf(column, row), cells_.size());
      if (is_new) cells_.push_back({place->first, column, row, {}, {}});
      cells_[place->second].moments.add(end.x(), end.y(), weight, variance);
    }
    std::sort(cells_.begin(), cells_.end(),
              [](const Cell& a, const Cell& b) { return a.key < b.key; });
    tellPieces(stop);
  }

  const Piece* of(const PlacedRay& ray) const {
    const Vec2 end = ray.end();
    const std::int64_t key = keyOf(cellOf(end.x()), cellOf(end.y()));
    const auto found =
        std::lower_bound(cells_.begin(), cells_.end(), key,
                         [](const Cell& cell, std::int64_t wanted) { return cell.key < wanted; });
    return found == cells_.end() || found->key != key ? nullptr : &found->piece;
  }

 private:
  struct Cell {
    std::int64_t key;
    int column;
    int row;
    Moments moments;
    Piece piece;
  };

  /// What lies around a cell is a run of cells in each column beside it, and the runs move on with
  /// the cell.
  void tellPieces(const std::stop_token& stop) {
    std::array<std::size_t, 2 * kReach + 1> first{};
    for (Cell& cell : cells_) {
      if (stop.stop_requested()) return;
      Moments around;
      for (int i = -kReach; i <= kReach; ++i) {
        const int half = static_cast<int>(std::sqrt(kReach * kReach - i * i));
        const std::int64_t low = keyOf(cell.column + i, cell.row - half);
        const std::int64_t high = keyOf(cell.column + i, cell.row + half);
        std::size_t& begin = first[static_cast<std::size_t>(i + kReach)];
        while (begin < cells_.size() && cells_[begin].key < low) ++begin;
        for (std::size_t n = begin; n < cells_.size() && cells_[n].key <= high; ++n) {
          around.add(cells_[n].moments);
        }
      }
      cell.piece = pieceOf(around);
    }
  }

  static Piece pieceOf(const Moments& sum) {
    Piece piece;
    if (sum.count < kLeastReturns) return piece;
    const double mx = sum.x / sum.weight;
    const double my = sum.y / sum.weight;
    const double xx = sum.xx / sum.weight - mx * mx;
    const double yy = sum.yy / sum.weight - my * my;
    const double xy = sum.xy / sum.weight - mx * my;
    const double along = 0.5 * std::atan2(2.0 * xy, xx - yy);
    const double half = std::hypot(0.5 * (xx - yy), xy);
    const double length = std::sqrt(std::max(0.0, 0.5 * (xx + yy) + half));
    const double thickness = std::sqrt(std::max(0.0, 0.5 * (xx + yy) - half));
    const double noise = std::sqrt(sum.noise / sum.weight);
    piece.middle = {mx, my};
    piece.normal = perpendicular(unitVector(along));
    if (length < kLeastLength_m) return piece;
    if (thickness < std::hypot(kWall_m, kWallNoise * noise)) {
      piece.structure = Structure::Straight;
    } else if (thickness < std::hypot(kHedge_m, kHedgeNoise * noise)) {
      piece.structure = Structure::Linear;
    }
    return piece;
  }

  std::vector<Cell> cells_;  ///< by key
};

/// How far returns are off what is straight, by their distance: offset and quadratic term by least
/// squares over the medians of distance bins.
RangeNoise measured(const std::vector<PlacedRay>& rays, const Cells& cells, RangeNoise noise) {
  std::array<std::vector<double>, kNoiseBins> errors;
  for (const PlacedRay& ray : rays) {
    if (ray.echo != Echo::Tall) continue;
    const Piece* piece = cells.of(ray);
    if (piece == nullptr || piece->structure != Structure::Straight) continue;
    const double cosine =
        std::abs(piece->normal.dot(Vec2(static_cast<double>(ray.dx), static_cast<double>(ray.dy))));
    const auto bin = static_cast<std::size_t>(static_cast<double>(ray.range) / kNoiseBin_m);
    if (cosine < kNoiseCosine || bin >= kNoiseBins) continue;
    errors[bin].push_back(std::abs(piece->normal.dot(ray.end() - piece->middle)) / cosine);
  }
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (std::size_t bin = 0; bin < kNoiseBins; ++bin) {
    const std::vector<double>& of_bin = errors[bin];
    if (of_bin.size() < kLeastInBin) continue;
    const double sigma = kMedianToSigma * medianOf(of_bin);
    const double distance = (static_cast<double>(bin) + 0.5) * kNoiseBin_m;
    const Eigen::Vector2d row(1.0, distance * distance);
    const double weight = 1.0 / (sigma * sigma);
    normal += weight * row * row.transpose();
    right += weight * sigma * row;
  }
  if (normal.determinant() <= 1e-9 * normal.squaredNorm()) return noise;
  const Eigen::Vector2d fit = normal.ldlt().solve(right);
  noise.offset_m = std::clamp(fit[0], 0.02, 0.3);
  noise.quadratic_per_m = std::clamp(fit[1], 0.0001, 0.003);
  return noise;
}

/// How often the robot came to each place, by where it looked from there.
class Visits {
 public:
  explicit Visits(const PlacedRays& placed) {
    const PlacedRay* before = nullptr;
    double way_m = 0.0;
    for (const PlacedRay& ray : placed.rays) {
      if (before != nullptr) {
        way_m += std::hypot(static_cast<double>(ray.x - before->x),
                            static_cast<double>(ray.y - before->y));
      }
      before = &ray;
      Looks& looks = of(ray);
      if (looks.visits == 0 || way_m - looks.last_m > kAway_m) ++looks.visits;
      looks.last_m = way_m;
    }
  }

  int count(const PlacedRay& ray) { return of(ray).visits; }

 private:
  struct Looks {
    int visits = 0;
    double last_m = 0.0;
  };

  Looks& of(const PlacedRay& ray) {
    const auto cell = [](float metres) {
      return static_cast<int>(std::floor(static_cast<double>(metres) / kStand_m));
    };
    const double turns =
        std::atan2(static_cast<double>(ray.dy), static_cast<double>(ray.dx)) / (2.0 * kPi) + 0.5;
    const double sector = std::min(turns * kSectors, kSectors - 1.0);
    const std::int64_t place = keyOf(cell(ray.x), cell(ray.y));
    if (place != place_ || looks_ == nullptr) looks_ = &places_[place];
    place_ = place;
    return (*looks_)[static_cast<std::size_t>(sector)];
  }

  std::unordered_map<std::int64_t, std::array<Looks, kSectors>> places_;
  std::int64_t place_ = 0;  ///< of the last ray: those of a frame are from one
  std::array<Looks, kSectors>* looks_ = nullptr;
};

/// Where the robot comes back to and looks the same way it sees again what it saw, with the same
/// errors: all visits tell together what one tells.
void shareVisits(PlacedRays& placed) {
  Visits visits(placed);
  for (PlacedRay& ray : placed.rays) ray.share /= static_cast<float>(visits.count(ray));
}

/// What ends at one place is off by what that place and the poses are off: more looks at it tell
/// ever less.
void shareOut(std::vector<PlacedRay>& rays) {
  std::unordered_map<std::int64_t, float> looks;
  const auto place_of = [&](const PlacedRay& ray) {
    const Vec2 end = ray.end() / kPlace_m;
    return 4 * keyOf(static_cast<int>(std::floor(end.x())), static_cast<int>(std::floor(end.y()))) +
           static_cast<std::int64_t>(ray.echo);
  };
  for (const PlacedRay& ray : rays) looks[place_of(ray)] += ray.share;
  for (PlacedRay& ray : rays) ray.share *= std::min(1.0F, kEnoughLooks / looks[place_of(ray)]);
}

}  // namespace

PlacedRays placeRays(std::span<const SeenFrame> seen, const std::vector<Pose2>& poses,
                     const std::stop_token& stop) {
  PlacedRays placed;
  std::size_t rays = 0;
  for (const SeenFrame& frame : seen) rays += frame.rays->size();
  placed.rays.reserve(rays);
  for (const SeenFrame& frame : seen) {
    placed.frame_begin.push_back(placed.rays.size());
    const Pose2& pose = poses.at(frame.observation);
    for (const SeenRay& ray : *frame.rays) {
      const double heading = pose.heading + static_cast<double>(ray.bearing);
      PlacedRay in_map;
      in_map.x = static_cast<float>(pose.x);
      in_map.y = static_cast<float>(pose.y);
      in_map.dx = static_cast<float>(std::cos(heading));
      in_map.dy = static_cast<float>(std::sin(heading));
      in_map.range = ray.range;
      in_map.share = frame.looks * ray.share;
      in_map.echo = ray.echo;
      placed.rays.push_back(in_map);
    }
  }
  placed.frame_begin.push_back(placed.rays.size());
  for (int round = 0; round < kStructureRounds; ++round) {
    const Cells cells(placed.rays, placed.noise, stop);
    placed.noise = measured(placed.rays, cells, placed.noise);
  }
  const Cells cells(placed.rays, placed.noise, stop);
  if (stop.stop_requested()) return placed;
  shareVisits(placed);
  shareOut(placed.rays);
  for (PlacedRay& ray : placed.rays) {
    const Piece* piece = ray.echo == Echo::Tall ? cells.of(ray) : nullptr;
    if (piece == nullptr) continue;
    ray.structure = piece->structure;
    ray.nx = static_cast<float>(piece->normal.x());
    ray.ny = static_cast<float>(piece->normal.y());
  }
  const auto count = [&](auto is) {
    return static_cast<double>(std::count_if(placed.rays.begin(), placed.rays.end(), is));
  };
  const double tall = count([](const PlacedRay& ray) { return ray.echo == Echo::Tall; });
  placed.straight = count([](const PlacedRay& ray) {
                      return ray.echo == Echo::Tall && ray.structure == Structure::Straight;
                    }) /
                    std::max(1.0, tall);
  return placed;
}

}  // namespace handmap
