#include "core/outlines/row_division.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/outlines/constants.h"

namespace handmap {

using namespace outlines;

namespace {

double logAdd(double a, double b) {
  if (a < b) std::swap(a, b);
  return b == kNever ? a : a + std::log1p(std::exp(b - a));
}

double squared(double x) { return x * x; }

class Row {
 public:
  Row(const std::vector<RowHouse>& houses, double from, double to, const StretchEvidence& evidence)
      : houses_(houses),
        from_(from),
        cells_(static_cast<std::size_t>(std::max(1L, std::lround((to - from) / kRowCell_m)))),
        cell_m_((to - from) / static_cast<double>(cells_)) {
    for (const RowHouse& house : houses) {
      mean_width_ += house.width / static_cast<double>(houses.size());
    }
    evidence_.assign((cells_ + 1) * (cells_ + 1), 0.0);
    for (std::size_t a = 0; a < cells_; ++a) {
      for (std::size_t b = a + 1; b <= cells_; ++b) {
        evidence_[b * (cells_ + 1) + a] = evidence(placeOf(a), placeOf(b));
      }
    }
    for (const RowHouse& house : houses) {
      of_width_.push_back(widthsOf(house));
      most_.push_back(static_cast<std::size_t>(std::max(0.0, house.most_width / cell_m_)));
    }
    undrawn_of_width_.assign(cells_ + 1, kNever);
    for (std::size_t n = 1; n <= cells_; ++n) {
      const double off = std::log(widthOf(n) / mean_width_) / kUndrawnLogWidth;
      undrawn_of_width_[n] = -kIsThere - 0.5 * squared(off);
    }
  }

  struct Division {
    double nats = kNever;
    std::vector<std::size_t> parts;
  };

  /// All houses lie off by so much, together.
  void shiftBy(double shift) { shift_ = shift; }

  /// The most probable one.
  Division best() const {
    struct Step {
      double nats = kNever;
      std::size_t houses = 0;
      std::size_t cell = 0;
      std::size_t part = kUndrawn;
    };
    const std::size_t n = houses_.size();
    // Of the row up to a cell, the first so many houses decided.
    std::vector<std::vector<Step>> steps(n + 1, std::vector<Step>(cells_ + 1));
    steps[0][0].nats = 0.0;
    for (std::size_t h = 0; h <= n; ++h) {
      for (std::size_t c = 0; c <= cells_; ++c) {
        Step& best = steps[h][c];
        const auto offer = [&](const Step& step) {
          if (step.nats > best.nats) best = step;
        };
        if (h > 0) {
          offer({steps[h - 1][c].nats + houses_[h - 1].worth_elsewhere, h - 1, c});
          for (std::size_t a = c - std::min(c, most_[h - 1]); a < c; ++a) {
            offer({steps[h - 1][a].nats + houseNats(h - 1, a, c), h - 1, a, h - 1});
          }
        }
        for (std::size_t a = 0; a < c; ++a) {
          offer({steps[h][a].nats + undrawnNats(a, c), h, a});
        }
      }
    }
    Division division{steps[n][cells_].nats, {}};
    if (division.nats == kNever) return division;
    for (std::size_t h = n, c = cells_; c > 0 || h > 0;) {
      const Step& step = steps[h][c];
      if (step.cell < c) division.parts.push_back(step.part);
      h = step.houses;
      c = step.cell;
    }
    std::ranges::reverse(division.parts);
    return division;
  }

  /// Forwards and backwards along the row.
  std::vector<RowPart> placed(const std::vector<std::size_t>& parts) const {
    const std::size_t n = parts.size();
    std::vector<std::vector<double>> before(n + 1, std::vector<double>(cells_ + 1, kNever));
    std::vector<std::vector<double>> after = before;
    before[0][0] = 0.0;
    after[n][cells_] = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t a = 0; a < cells_; ++a) {
        if (before[k][a] == kNever) continue;
        for (std::size_t b = a + 1; b <= cells_; ++b) {
          before[k + 1][b] = logAdd(before[k + 1][b], before[k][a] + partNats(parts[k], a, b));
        }
      }
    }
    for (std::size_t k = n; k-- > 0;) {
      for (std::size_t a = 0; a < cells_; ++a) {
        for (std::size_t b = a + 1; b <= cells_; ++b) {
          if (after[k + 1][b] == kNever) continue;
          after[k][a] = logAdd(after[k][a], after[k + 1][b] + partNats(parts[k], a, b));
        }
      }
    }
    std::vector<RowPart> placed;
    double from = from_;
    double from_sigma = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      double sum = 0.0, off = 0.0, square = 0.0;  // of places from the last one on
      for (std::size_t c = 0; c <= cells_; ++c) {
        const double p = std::exp(before[k + 1][c] + after[k + 1][c] - before[n][cells_]);
        sum += p;
        off += p * (placeOf(c) - from);
        square += p * squared(placeOf(c) - from);
      }
      const double to = from + off / sum;
      const double sigma = std::sqrt(std::max(0.0, square / sum - squared(off / sum)));
      placed.push_back({parts[k], from, to, from_sigma, sigma});
      from = to;
      from_sigma = sigma;
    }
    return placed;
  }

 private:
  double placeOf(std::size_t cell) const { return from_ + static_cast<double>(cell) * cell_m_; }
  double widthOf(std::size_t cells) const { return static_cast<double>(cells) * cell_m_; }
  double evidence(std::size_t a, std::size_t b) const { return evidence_[b * (cells_ + 1) + a]; }

  /// What its width alone says, by cells.
  std::vector<double> widthsOf(const RowHouse& house) const {
    std::vector<double> nats(cells_ + 1, kNever);
    for (std::size_t n = 1; n <= cells_; ++n) {
      const double width = widthOf(n);
      if (width < house.least_width || width > house.most_width) continue;
      const double off = std::log(width / house.width) / house.log_width_sigma;
      nats[n] = kIsThere + house.nats - 0.5 * squared(off);
    }
    return nats;
  }

  double houseNats(std::size_t h, std::size_t a, std::size_t b) const {
    const double of_width = of_width_[h][b - a];
    if (of_width == kNever) return kNever;
    const RowHouse& house = houses_[h];
    const double off = 0.5 * (placeOf(a) + placeOf(b)) - house.centre - shift_;
    return of_width + evidence(a, b) - 0.5 * squared(off / house.centre_sigma);
  }
  double undrawnNats(std::size_t a, std::size_t b) const {
    return undrawn_of_width_[b - a] + evidence(a, b);
  }
  double partNats(std::size_t part, std::size_t a, std::size_t b) const {
    return part == kUndrawn ? undrawnNats(a, b) : houseNats(part, a, b);
  }

  const std::vector<RowHouse>& houses_;
  double from_;
  std::size_t cells_;
  double cell_m_;
  double mean_width_ = 0.0;
  double shift_ = 0.0;
  std::vector<double> evidence_;               ///< of a stretch, by its end
  std::vector<std::vector<double>> of_width_;  ///< by house
  std::vector<std::size_t> most_;              ///< cells of a house
  std::vector<double> undrawn_of_width_;
};

}  // namespace

std::vector<RowPart> divideRow(const std::vector<RowHouse>& houses, double from, double to,
                               const StretchEvidence& evidence, const std::stop_token& stop) {
  if (houses.empty() || to - from < kRowCell_m) return {};
  Row row(houses, from, to, evidence);
  double shift_sigma = 0.0;
  for (const RowHouse& house : houses) {
    shift_sigma += house.centre_sigma / static_cast<double>(houses.size());
  }
  Row::Division best;
  double best_shift = 0.0;
  for (double sigmas = -kMostShift; sigmas <= kMostShift; sigmas += kShiftStep) {
    if (stop.stop_requested()) return {};
    row.shiftBy(sigmas * shift_sigma);
    Row::Division division = row.best();
    division.nats -= 0.5 * squared(sigmas);
    if (division.nats <= best.nats) continue;
    best = std::move(division);
    best_shift = sigmas * shift_sigma;
  }
  row.shiftBy(best_shift);
  return row.placed(best.parts);
}

}  // namespace handmap
