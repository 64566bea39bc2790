#include "core/estimation/labels/assignment.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Geometry>

#include "core/estimation/buildings/constants.h"
#include "core/estimation/labels/constants.h"

namespace handmap {

using namespace labels;

namespace {

Vec2 originOf(const Map& drawing) {
  return drawing.start ? drawing.start->position() : Vec2::Zero();
}

/// The density of found buildings that no one drew, by metre and metre.
double undrawnDensity(const Map& drawing, const AssignmentOptions& options) {
  std::vector<Vec2> corners;
  for (const Building& building : drawing.buildings) {
    for (const Vec2& corner : building.footprint()) corners.push_back(corner);
  }
  if (corners.empty()) return options.undrawn;
  const Bounds bounds = boundsOf(corners);
  const Vec2 size = bounds.high - bounds.low + Vec2::Constant(2.0 * kUndrawnMargin_m);
  return options.undrawn * static_cast<double>(drawing.buildings.size()) / (size.x() * size.y());
}

class Assigner {
 public:
  Assigner(const Map& drawing, std::span<const FoundBox> found, std::span<const Pose2> trajectory,
           const AssignmentOptions& options)
      : drawing_(drawing),
        found_(found),
        trajectory_(trajectory),
        options_(options),
        log_undrawn_(std::log(undrawnDensity(drawing, options))) {
    for (const Building& building : drawing.buildings) {
      drawn_.push_back(building.box());
      const double phantom = building.may_not_exist ? options.uncertain_phantom : options.phantom;
      log_present_.push_back(std::log((1.0 - phantom) / phantom));
    }
    for (const FoundBox& box : found) {
      found_at_.push_back(box.box.rectangle().centre);
      half_size_.push_back(halfSize(box.box.rectangle()));
      sides_.push_back(sideOf(found_at_.back()));
    }
  }

  std::vector<Hypothesis> operator()(const std::vector<Hypothesis>& roots) {
    std::vector<Branch> beam;
    for (const Hypothesis& root : roots) {
      beam.push_back(
          {std::vector<int>(drawing_.buildings.size(), kNone), root.motion, root.log_weight});
    }
    const std::vector<std::size_t> order = inOrder();
    for (const std::size_t building : order) {
      beam = fittest(grown(beam, building), drawn_[order.back()].centre);
    }
    std::vector<Hypothesis> hypotheses;
    double sum = 0.0;
    for (const Branch& branch : beam) {
      const double weight = std::exp(branch.log_weight - beam.front().log_weight);
      hypotheses.push_back({named(branch.found_of), branch.motion, branch.log_weight, weight});
      sum += weight;
    }
    for (Hypothesis& h : hypotheses) h.weight /= sum;
    return hypotheses;
  }

 private:
  /// A hypothesis that grows: what was found by its place in `found_`.
  struct Branch {
    std::vector<int> found_of;
    DrawingMotion motion;
    double log_weight = 0.0;
  };

  std::vector<FoundId> named(const std::vector<int>& found_of) const {
    std::vector<FoundId> ids;
    for (const int f : found_of) {
      ids.push_back(f == kNone ? FoundId::None : found_[static_cast<std::size_t>(f)].id);
    }
    return ids;
  }

  /// The branches with one building more, left out or given each found one that it may be.
  std::vector<Branch> grown(const std::vector<Branch>& beam, std::size_t building) const {
    std::vector<Branch> next;
    const int side = sideOf(beam.front().motion(drawn_[building].centre));
    for (const Branch& branch : beam) {
      next.push_back(branch);
      const Vec2 expected = branch.motion(drawn_[building].centre);
      const double reach = reachOf(building, branch.motion);
      for (std::size_t f = 0; f < found_.size(); ++f) {
        if ((found_at_[f] - expected).norm() > reach + half_size_[f]) continue;
        if (!isTaken(branch, f)) extend(branch, building, f, side, next);
      }
    }
    return next;
  }

  /// Half of the room is for the best, half for what has the drawing lie where few better ones have
  /// it: those that lie alike go on alike, and would leave none for what proves right later. Where
  /// it lies is told by the `farthest` drawn place.
  std::vector<Branch> fittest(std::vector<Branch> branches, const Vec2& farthest) const {
    struct Place {
      Vec2 at;
      int branches = 0;
    };
    std::ranges::stable_sort(branches, std::ranges::greater{}, &Branch::log_weight);
    const double least = branches.front().log_weight - kHopeless;
    std::erase_if(branches, [&](const Branch& branch) { return branch.log_weight < least; });
    const auto room = static_cast<std::size_t>(options_.hypotheses);
    if (branches.size() <= room) return branches;
    std::vector<Place> places;
    std::vector<Branch> kept;
    std::vector<Branch> others;
    for (Branch& branch : branches) {
      const Vec2 at = branch.motion(farthest);
      auto place = std::ranges::find_if(
          places, [&](const Place& other) { return (other.at - at).norm() < kSamePlace_m; });
      if (place == places.end()) place = places.insert(places.end(), {at});
      const bool stays = kept.size() < room / 2 || place->branches < kMostAlike;
      ++place->branches;
      (stays ? kept : others).push_back(std::move(branch));
    }
    std::ranges::move(others, std::back_inserter(kept));
    kept.erase(kept.begin() + options_.hypotheses, kept.end());
    std::ranges::stable_sort(kept, std::ranges::greater{}, &Branch::log_weight);
    return kept;
  }

  /// The nearest to the start first: what is known of the whole drawing grows outwards.
  std::vector<std::size_t> inOrder() const {
    std::vector<std::size_t> order(drawing_.buildings.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<double> distance;
    for (const Rectangle& box : drawn_) {
      distance.push_back((box.centre - originOf(drawing_)).norm());
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return distance[a] < distance[b]; });
    return order;
  }

  static bool isTaken(const Branch& branch, std::size_t found) {
    const auto& taken = branch.found_of;
    return std::find(taken.begin(), taken.end(), static_cast<int>(found)) != taken.end();
  }

  static double halfSize(const Rectangle& box) { return std::hypot(box.width, box.depth) / 2.0; }

  /// No pairing() lies farther from where a building is expected.
  double reachOf(std::size_t building, const DrawingMotion& motion) const {
    const Uncertainty uncertainty = drawing_.uncertaintyOf(drawing_.buildings[building]);
    const double own = std::hypot(uncertainty.position, uncertainty.size);
    const Rectangle& drawn = drawn_[building];
    return std::sqrt(kGate) * (own + motion.sigmaAt(drawn.centre)) +
           motion.scale() * halfSize(drawn);
  }

  /// Of the robot's way: 1 left, −1 right, 0 where there is none.
  int sideOf(const Vec2& point) const {
    const auto nearer = [&](const Pose2& a, const Pose2& b) {
      return (a.position() - point).squaredNorm() < (b.position() - point).squaredNorm();
    };
    const auto nearest = std::min_element(trajectory_.begin(), trajectory_.end(), nearer);
    if (nearest == trajectory_.end()) return 0;
    return nearest->toOwn(point).y() > 0.0 ? 1 : -1;
  }

  double disorder(const Branch& branch, std::size_t building, std::size_t found) const {
    double price = 0.0;
    for (std::size_t other = 0; other < branch.found_of.size(); ++other) {
      const int its_found = branch.found_of[other];
      if (its_found == kNone) continue;
      const Vec2 drawn_way = drawn_[other].centre - drawn_[building].centre;
      const Vec2 found_way = found_at_[static_cast<std::size_t>(its_found)] - found_at_[found];
      if (drawn_way.dot(found_way) < 0.0) price += options_.disorder;
    }
    return price;
  }

  void extend(const Branch& branch, std::size_t building, std::size_t f, int side,
              std::vector<Branch>& next) const {
    const Uncertainty uncertainty = drawing_.uncertaintyOf(drawing_.buildings[building]);
    const std::optional<Pairing> pair =
        pairing(drawn_[building], uncertainty, found_[f], branch.motion, options_);
    if (!pair) return;
    // The same walls of a building that no one drew: anywhere, of any size.
    const double undrawn = log_undrawn_ * (pair->walls - pair->widths) / 2.0 -
                           pair->widths * std::log(buildings::kChance_m);
    const double side_price = sides_[f] == side ? 0.0 : options_.wrong_side;

    Branch extended = branch;
    extended.found_of[building] = static_cast<int>(f);
    extended.log_weight += pair->log_likelihood - undrawn + log_present_[building] -
                           disorder(branch, building, f) - side_price;
    extended.motion = pair->motion;
    next.push_back(std::move(extended));
  }

  const Map& drawing_;
  std::span<const FoundBox> found_;
  std::span<const Pose2> trajectory_;
  const AssignmentOptions& options_;
  std::vector<Rectangle> drawn_;
  std::vector<Vec2> found_at_;
  std::vector<double> half_size_;  ///< of the found ones
  std::vector<int> sides_;         ///< of the found buildings
  double log_undrawn_;
  std::vector<double> log_present_;  ///< of the drawn ones
};

}  // namespace

AssignmentOptions withStated(const WholeUncertainty& whole, AssignmentOptions options) {
  if (whole.scale) options.scale_sigma = std::max(*whole.scale, kLeastSigma);
  if (whole.turn) {
    options.turn_sigma = std::max(*whole.turn, kLeastSigma);
    options.free_turn |= *whole.turn > kFan;  // one Gaussian in (a, b) does not reach so far
  }
  return options;
}

AssignmentOptions withStart(const StartUncertainty& start, AssignmentOptions options) {
  options.start_m = start.position;
  options.start_turn = start.heading;
  options.free_turn |= start.heading > kFan;
  return options;
}

std::vector<Hypothesis> rootHypotheses(const Map& drawing, const AssignmentOptions& options) {
  const double shift = std::hypot(drawing.shiftSigma(), options.start_m);
  const double scale = options.free_scale ? kFreeScale : options.scale_sigma;
  const double turn = options.free_turn ? kFan : std::hypot(options.turn_sigma, options.start_turn);
  const Eigen::Vector4d sigma(scale, turn, shift, shift);
  std::vector<Hypothesis> roots;
  for (int step = 0; step <= (options.free_turn ? 2 * kFanSteps : 0); ++step) {
    const double angle = kFan * (step % 2 == 0 ? step / 2 : -(step + 1) / 2);
    Hypothesis root;
    root.motion.origin = originOf(drawing);
    root.motion.mean.head<2>() = unitVector(angle);
    Eigen::Matrix4d axes = Eigen::Matrix4d::Identity();
    axes.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(angle).toRotationMatrix();
    root.motion.covariance = axes * sigma.cwiseAbs2().asDiagonal() * axes.transpose();
    roots.push_back(std::move(root));
  }
  return roots;
}

void settle(std::vector<Hypothesis>& roots, const Building& drawn, const Uncertainty& uncertainty,
            const FoundBox& found, const AssignmentOptions& options) {
  std::vector<Hypothesis> settled;
  for (Hypothesis& root : roots) {
    const auto pair = pairing(drawn.box(), uncertainty, found, root.motion, options);
    if (!pair) continue;
    root.motion = pair->motion;
    root.log_weight += pair->log_likelihood;
    settled.push_back(std::move(root));
  }
  if (!settled.empty()) roots = std::move(settled);
}

std::vector<Hypothesis> assign(const Map& drawing, std::span<const FoundBox> found,
                               std::span<const Pose2> trajectory,
                               const std::vector<Hypothesis>& roots,
                               const AssignmentOptions& options) {
  return Assigner(drawing, found, trajectory, options)(roots);
}

}  // namespace handmap
