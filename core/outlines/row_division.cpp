#include "core/outlines/row_division.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Core>

#include "core/outlines/constants.h"

namespace handmap {

using namespace outlines;

namespace {

using Eigen::ArrayXd;
using Eigen::ArrayXXd;
using Eigen::Index;

double squared(double x) { return x * x; }

/// Tables have a column for each number of houses that are decided, in their order.
class Row {
 public:
  Row(const std::vector<RowHouse>& houses, double from, double to, const StretchEvidence& evidence)
      : houses_(houses),
        count_(static_cast<Index>(houses.size())),
        from_(from),
        cells_(std::max(1L, std::lround((to - from) / kRowCell_m))),
        cell_m_((to - from) / static_cast<double>(cells_)),
        evidence_(evidenceOf(evidence)),
        undrawn_(evidence_),
        own_(ArrayXXd::Zero(cells_ + 1, count_)) {
    double mean_width = 0.0;
    for (const RowHouse& house : houses) mean_width += house.width / static_cast<double>(count_);
    ArrayXd of_thing = ArrayXd::Zero(cells_ + 1);
    for (Index n = 1; n <= cells_; ++n) {
      of_thing[n] = normal(std::log(widthOf(n) / mean_width), kThingLogWidth);
      const double scale = widthOf(n) * kThingLogWidth * std::sqrt(2.0 * kPi);
      const double density = of_thing[n] * cell_m_ / scale;
      undrawn_.matrix().diagonal(n) *= std::exp(-kTells) * density;
    }
    for (const RowHouse& house : houses) of_width_.push_back(of_thing * widthsOf(house));
  }

  /// All divisions where all houses lie off by so much, together: forwards and backwards along the
  /// row. Which houses are not of it is told after a drawn one or at first, so that each division
  /// is counted once.
  void add(double shift, double weight) {
    std::vector<ArrayXd> of_centre;
    for (const RowHouse& house : houses_) of_centre.push_back(centresOf(house, shift));
    ArrayXXd drawn = ArrayXXd::Zero(cells_ + 1, count_ + 1);  // up to a cell, a house ends there
    ArrayXXd all = drawn;                                     // or something that is not drawn
    drawn(0, 0) = weight;
    for (Index b = 0; b <= cells_; ++b) {
      for (Index h = 0; h <= count_; ++h) {
        if (h > 0) {
          const Index n = std::min(b, most(h - 1));
          drawn(b, h) += elsewhere(h - 1) * drawn(b, h - 1) +
                         (all.col(h - 1).segment(b - n, n) * ending(h - 1, b, n, of_centre)).sum();
        }
        all(b, h) = drawn(b, h) + (all.col(h).head(b) * undrawn_.col(b).head(b)).sum();
      }
    }
    ArrayXXd after_drawn = ArrayXXd::Zero(cells_ + 1, count_ + 1);  // from a cell on
    ArrayXXd after = after_drawn;
    after(cells_, count_) = 1.0;
    for (Index b = cells_; b >= 0; --b) {
      for (Index h = count_; h >= 0; --h) {
        after_drawn(b, h) = after(b, h);
        if (h < count_) after_drawn(b, h) += elsewhere(h) * after_drawn(b, h + 1);
        after.col(h).head(b) += undrawn_.col(b).head(b) * after(b, h);
        if (h == 0) continue;
        const Index n = std::min(b, most(h - 1));
        const ArrayXd from_here = ending(h - 1, b, n, of_centre) * after_drawn(b, h);
        after.col(h - 1).segment(b - n, n) += from_here;
        const ArrayXd whole = all.col(h - 1).segment(b - n, n) * from_here;
        own_.col(h - 1).segment(b - n, n) += whole;
        own_(b, h - 1) -= whole.sum();
      }
    }
    total_ += weight * after_drawn(0, 0);
  }

  /// That with most cells right.
  std::vector<RowPart> division() const {
    if (!(total_ > 0.0)) return {};
    const ArrayXXd share = shares();
    const std::vector<Stretch> stretches = mostRight(share);
    std::vector<RowPart> parts;
    double from = from_;
    double from_sigma = 0.0;
    for (std::size_t k = 0; k < stretches.size(); ++k) {
      const Stretch& part = stretches[k];
      const auto [to, to_sigma] = k + 1 < stretches.size()
                                      ? endBetween(part, stretches[k + 1], share)
                                      : std::pair(placeOf(cells_), 0.0);
      parts.push_back({part.of == count_ ? kUndrawn : static_cast<std::size_t>(part.of), from, to,
                       from_sigma, to_sigma, share(part.middle(), part.of)});
      from = to;
      from_sigma = to_sigma;
    }
    return parts;
  }

 private:
  /// Cells of a house, or of none: the last index.
  struct Stretch {
    Index of, from, to;
    Index middle() const { return (from + to) / 2; }
  };

  /// How probably a cell is of a house, or of none.
  ArrayXXd shares() const {
    ArrayXXd share(cells_, count_ + 1);
    ArrayXd of_houses = ArrayXd::Zero(count_);
    for (Index c = 0; c < cells_; ++c) {
      of_houses += own_.row(c).transpose() / total_;
      share.row(c).head(count_) = of_houses.transpose();
      share(c, count_) = 1.0 - of_houses.sum();
    }
    return share;
  }

  std::vector<Stretch> mostRight(const ArrayXXd& share) const {
    ArrayXXd upto = ArrayXXd::Zero(cells_ + 1, count_ + 1);
    for (Index c = 0; c < cells_; ++c) upto.row(c + 1) = upto.row(c) + share.row(c);
    struct Step {
      double right = -1.0;
      Index from = 0;
      bool decides = false;  // on a house: there, or where it is empty that it is not of the row
    };
    Eigen::Array<Step, Eigen::Dynamic, Eigen::Dynamic> steps(cells_ + 1, count_ + 1);
    steps(0, 0).right = 0.0;
    for (Index h = 0; h <= count_; ++h) {
      for (Index c = 0; c <= cells_; ++c) {
        Step& best = steps(c, h);
        const auto offer = [&](const Step& step) {
          if (step.right > best.right) best = step;
        };
        if (c > 0) offer({steps(c - 1, h).right + share(c - 1, count_), c - 1});
        if (h == 0) continue;
        offer({steps(c, h - 1).right, c, true});
        const ArrayXd& of_width = of_width_[static_cast<std::size_t>(h - 1)];
        for (Index a = c - std::min(c, most(h - 1)); a < c; ++a) {
          if (of_width[c - a] == 0.0) continue;
          offer({steps(a, h - 1).right + upto(c, h - 1) - upto(a, h - 1), a, true});
        }
      }
    }
    std::vector<Stretch> stretches;
    for (Index h = count_, c = cells_; c > 0 || h > 0;) {
      const Step& step = steps(c, h);
      if (step.decides) --h;
      const Index of = step.decides ? h : count_;
      if (of == count_ && !stretches.empty() && stretches.back().of == of) {
        stretches.back().from = step.from;
      } else if (step.from < c) {
        stretches.push_back({of, step.from, c});
      }
      c = step.from;
    }
    std::ranges::reverse(stretches);
    return stretches;
  }

  /// Mean and σ, as what is between both middles is rather of the one or of the other.
  std::pair<double, double> endBetween(const Stretch& part, const Stretch& next,
                                       const ArrayXXd& share) const {
    double mean = 0.0;
    double square = 0.0;
    for (Index c = part.middle(); c < next.middle(); ++c) {
      const double both = share(c, part.of) + share(c, next.of);
      const double still = both > 0.0 ? share(c, part.of) / both : 0.5;
      mean += still;
      square += still * static_cast<double>(2 * (c - part.middle()) + 1);
    }
    return {placeOf(part.middle()) + mean * cell_m_,
            std::sqrt(std::max(0.0, square - squared(mean))) * cell_m_};
  }

  static double normal(double off, double sigma) { return std::exp(-0.5 * squared(off / sigma)); }
  double placeOf(Index cell) const { return from_ + static_cast<double>(cell) * cell_m_; }
  double widthOf(Index cells) const { return static_cast<double>(cells) * cell_m_; }
  const RowHouse& house(Index h) const { return houses_[static_cast<std::size_t>(h)]; }
  double elsewhere(Index h) const { return std::exp(house(h).worth_elsewhere); }
  Index most(Index h) const {
    return static_cast<Index>(std::max(0.0, house(h).most_width / cell_m_));
  }

  /// Of each stretch against its cells one by one, which is the same for all divisions: as it
  /// stands it is beyond what a double holds.
  ArrayXXd evidenceOf(const StretchEvidence& evidence) const {
    ArrayXd alone = ArrayXd::Zero(cells_ + 1);
    for (Index c = 0; c < cells_; ++c)
      alone[c + 1] = alone[c] + evidence(placeOf(c), placeOf(c + 1));
    ArrayXXd table = ArrayXXd::Zero(cells_ + 1, cells_ + 1);
    for (Index b = 1; b <= cells_; ++b) {
      for (Index a = 0; a < b; ++a) {
        table(a, b) = std::exp(evidence(placeOf(a), placeOf(b)) - alone[b] + alone[a]);
      }
    }
    return table;
  }

  ArrayXd widthsOf(const RowHouse& house) const {
    ArrayXd weights = ArrayXd::Zero(cells_ + 1);
    for (Index n = 1; n <= cells_; ++n) {
      const double width = widthOf(n);
      if (width < house.least_width || width > house.most_width) continue;
      weights[n] = std::exp(kTells + house.nats) *
                   normal(std::log(width / house.width), house.log_width_sigma);
    }
    return weights;
  }
  /// By the cells of both ends together.
  ArrayXd centresOf(const RowHouse& house, double shift) const {
    ArrayXd weights(2 * cells_ + 1);
    for (Index both = 0; both <= 2 * cells_; ++both) {
      const double centre = from_ + 0.5 * widthOf(both);
      weights[both] = normal(centre - house.centre - shift, house.centre_sigma);
    }
    return weights;
  }
  /// A house of at most n cells ends there, by where it begins.
  ArrayXd ending(Index h, Index b, Index n, const std::vector<ArrayXd>& of_centre) const {
    const auto k = static_cast<std::size_t>(h);
    return evidence_.col(b).segment(b - n, n) * of_width_[k].segment(1, n).reverse() *
           of_centre[k].segment(2 * b - n, n);
  }

  const std::vector<RowHouse>& houses_;
  Index count_;
  double from_;
  Index cells_;
  double cell_m_;
  ArrayXXd evidence_;              ///< of a stretch; a column has those that end there
  ArrayXXd undrawn_;               ///< that it is a thing that is not drawn
  std::vector<ArrayXd> of_width_;  ///< by house
  ArrayXXd own_;                   ///< of each cell, less those of the one before
  double total_ = 0.0;
};

}  // namespace

std::vector<RowPart> divideRow(const std::vector<RowHouse>& houses, double from, double to,
                               const StretchEvidence& evidence, const std::stop_token& stop) {
  if (houses.empty() || to - from < kRowCell_m) return {};
  Row row(houses, from, to, evidence);
  double shift_sigma = 0.0;
  for (const RowHouse& house : houses) {
    shift_sigma += kSharedShift * house.centre_sigma / static_cast<double>(houses.size());
  }
  for (double sigmas = -kMostShift; sigmas <= kMostShift; sigmas += kShiftStep) {
    if (stop.stop_requested()) return {};
    row.add(sigmas * shift_sigma, std::exp(-0.5 * squared(sigmas)));
  }
  return row.division();
}

}  // namespace handmap
