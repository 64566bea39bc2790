#include "core/sketch_study/people.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/sketch_study/heavy_tails.h"
#include "core/sketch_study/size_line.h"

namespace handmap {

namespace {

constexpr std::uint32_t kPeople = 41;  // a stream of its own

/// Sum and count, for means that may be of nothing.
struct Mean {
  double sum = 0.0;
  double weight = 0.0;
  void add(double value, double with = 1.0) {
    sum += value;
    weight += with;
  }
  double value() const { return weight > 0.0 ? sum / weight : 0.0; }
  double root() const { return std::sqrt(value()); }
};

void measurePlaces(const std::vector<DrawnErrors>& drawings, PeopleFigures& figures) {
  Mean metres;
  Mean extents;
  Mean sizes;
  Mean product;
  Mean loss;
  Mean distance;
  std::vector<double> shares;
  for (const DrawnErrors& drawing : drawings) {
    for (const DrawnError& error : drawing.of) {
      const double off = error.off.squaredNorm();
      const double extent = drawing.extent;
      metres.add(off, 2.0 * error.freedom);
      extents.add(off / (extent * extent), 2.0 * error.freedom);
      if (error.size > 0.0) sizes.add(off / (error.size * error.size), 2.0 * error.freedom);
      product.add(error.off_product / (extent * extent));
      loss.add(error.product_loss);
      distance.add(error.nearest / extent);
      for (const int axis : {0, 1}) {
        shares.push_back(error.fullOff()[axis] / extent);
      }
    }
  }
  figures.position_m = metres.root();
  figures.position_of_extent = extents.root();
  figures.position_of_size = sizes.root();
  figures.neighbour_correlation =
      extents.sum > 0.0 ? product.value() / extents.value() + loss.value() : 0.0;
  figures.neighbour_distance = distance.value();
  if (shares.empty()) return;
  const HeavyTails tails = fitHeavyTails(shares);
  figures.bulk_of_extent = tails.sigma;
  figures.tail_freedom = tails.freedom;
}

void measureOutlines(const std::vector<DrawnErrors>& drawings, PeopleFigures& figures) {
  const SizeLine line = sizeLine(drawings);
  figures.size_slope = line.slope;
  figures.size_factor = std::exp(line.bias);
  figures.size_sigma = line.sigma;
  Mean size;
  std::vector<double> turns;
  Mean right;
  Mean true_right;
  Mean corners;
  Mean true_corners;
  for (const DrawnErrors& drawing : drawings) {
    for (const DrawnError& error : drawing.of) {
      if (!error.log_size) continue;
      size.add(std::pow(error.size * std::expm1(*error.log_size), 2));
      turns.push_back(std::abs(toDegrees(*error.turn)));
      right.add(error.right_corners, error.corners);
      true_right.add(error.true_right_corners, error.true_corners);
      corners.add(error.corners);
      true_corners.add(error.true_corners);
    }
  }
  figures.size_m = size.root();
  figures.turn_deg = quantile(turns, 0.68);
  figures.right_corners = right.value();
  figures.true_right_corners = true_right.value();
  figures.corners = corners.value();
  figures.true_corners = true_corners.value();
}

void measureDrawings(const std::vector<DrawnErrors>& drawings, PeopleFigures& figures) {
  Mean order;
  Mean shown;
  Mean turn;
  Mean scale;
  for (const DrawnErrors& drawing : drawings) {
    order.add(drawing.order_kept);
    shown.add(drawing.represented, drawing.objects);
    turn.add(std::pow(toDegrees(drawing.turn), 2));
    scale.add(std::log(drawing.scale));
  }
  Mean spread;
  for (const DrawnErrors& drawing : drawings) {
    spread.add(std::pow(std::log(drawing.scale) - scale.value(), 2));
  }
  spread.weight -= 1.0;
  figures.order_kept = order.value();
  figures.missing = 1.0 - shown.value();
  figures.drawing_turn_deg = turn.root();
  figures.drawing_scale = spread.root();
}

std::vector<DrawnErrors> drawnAgain(const std::vector<DrawnErrors>& drawings,
                                    RandomStream& random) {
  std::vector<DrawnErrors> again;
  for (std::size_t i = 0; i < drawings.size(); ++i) {
    const int person = random.index(static_cast<int>(drawings.size()));
    DrawnErrors drawing = drawings[static_cast<std::size_t>(person)];
    const std::vector<DrawnError> all = drawing.of;
    for (DrawnError& error : drawing.of) {
      error = all[static_cast<std::size_t>(random.index(static_cast<int>(all.size())))];
    }
    again.push_back(std::move(drawing));
  }
  return again;
}

}  // namespace

const std::vector<PeopleFigure>& allPeopleFigures() {
  using F = PeopleFigures;
  static const std::vector<PeopleFigure> kAll = {
      {"position_m", &F::position_m},
      {"position_of_extent", &F::position_of_extent},
      {"position_of_size", &F::position_of_size},
      {"bulk_of_extent", &F::bulk_of_extent},
      {"tail_freedom", &F::tail_freedom},
      {"neighbour_correlation", &F::neighbour_correlation},
      {"neighbour_distance_of_extent", &F::neighbour_distance},
      {"size_slope", &F::size_slope},
      {"size_factor", &F::size_factor},
      {"size_sigma_ln", &F::size_sigma},
      {"size_m", &F::size_m},
      {"turn_deg_68", &F::turn_deg},
      {"right_corners_share", &F::right_corners},
      {"true_right_corners_share", &F::true_right_corners},
      {"corners", &F::corners},
      {"true_corners", &F::true_corners},
      {"order_kept_share", &F::order_kept},
      {"missing_share", &F::missing},
      {"drawing_turn_deg", &F::drawing_turn_deg},
      {"drawing_scale_ln", &F::drawing_scale},
  };
  return kAll;
}

PeopleFigures peopleFigures(const std::vector<DrawnErrors>& drawings) {
  PeopleFigures figures;
  measurePlaces(drawings, figures);
  measureOutlines(drawings, figures);
  measureDrawings(drawings, figures);
  return figures;
}

std::vector<FigureRange> peopleIntervals(const std::vector<DrawnErrors>& drawings, int draws,
                                         std::uint64_t seed) {
  const std::vector<PeopleFigure>& all = allPeopleFigures();
  std::vector<std::vector<double>> values(all.size());
  for (int draw = 0; draw < draws; ++draw) {
    RandomStream random(seed, static_cast<std::uint32_t>(draw), 0, kPeople);
    const PeopleFigures figures = peopleFigures(drawnAgain(drawings, random));
    for (std::size_t i = 0; i < all.size(); ++i) values[i].push_back(figures.*all[i].value);
  }
  std::vector<FigureRange> intervals;
  for (const std::vector<double>& of : values) {
    intervals.push_back({quantile(of, 0.025), quantile(of, 0.975)});
  }
  return intervals;
}

}  // namespace handmap
