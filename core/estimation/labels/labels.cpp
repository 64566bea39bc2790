#include "core/estimation/labels/labels.h"

#include <algorithm>
#include <cmath>

#include "core/base/gaussian.h"
#include "core/base/median.h"
#include "core/estimation/labels/constants.h"

namespace handmap {

using namespace labels;

namespace {

bool isWithin(double distance_m, const FoundBox& found, const Vec2& here) {
  return (found.box.rectangle().centre - here).norm() < distance_m;
}

/// How probable it is that a building is what the best hypothesis says.
double agreement(const std::vector<Hypothesis>& hypotheses, std::size_t place) {
  const FoundId best = hypotheses.front().found_of[place];
  double agreed = 0.0;
  for (const Hypothesis& h : hypotheses) agreed += h.found_of[place] == best ? h.weight : 0.0;
  return agreed;
}

}  // namespace

Labels::Labels(const Map& drawing, const AssignmentOptions& options)
    : drawing_(drawing),
      options_(options),
      settled_at_(drawing.buildings.size(), kNowhere),
      nearby_at_(drawing.buildings.size(), kNowhere),
      missed_(drawing.buildings.size(), 0.0),
      roots_(rootHypotheses(drawing, options)) {
  expected_ = roots_.front().motion;
  for (const Building& building : drawing.buildings) centres_.push_back(building.box().centre);
  nearby_drawing_.start = drawing.start;
  nearby_drawing_.uncertainty = drawing.uncertainty;
  hypotheses_ = assign(nearby_drawing_, {}, {}, roots_, options_);
}

void Labels::update(std::vector<FoundBox>& found, std::span<const Pose2> trajectory,
                    double near_m) {
  const Vec2 here = trajectory.back().position();
  bringNearOnesBack(found, here, near_m);
  findNearby(here, near_m);
  hypotheses_ = assign(nearby_drawing_, found, trajectory, roots_, options_);
  settleFarOnes(found, here, near_m);
}

void Labels::settleFarOnes(std::vector<FoundBox>& found, const Vec2& here, double near_m) {
  std::vector<FoundBox> kept;
  for (const FoundBox& box : found) {
    if (box.in_sight || isWithin(near_m, box, here)) {
      kept.push_back(box);
      continue;
    }
    const std::size_t drawn = drawnOf(box.id).value_or(kNowhere);
    if (drawn != kNowhere) {
      const Building& building = drawing_.buildings[drawn];
      settle(roots_, building, drawing_.uncertaintyOf(building), box, options_);
      settled_at_[drawn] = settled_.size();
    }
    settled_.push_back({box, drawn, drawn == kNowhere ? 0.0 : doubtOf(nearby_at_[drawn])});
  }
  if (kept.size() == found.size()) return;
  found = std::move(kept);
  for (Hypothesis& hypothesis : hypotheses_) {
    for (FoundId& id : hypothesis.found_of) {
      if (!findBox(found, id)) id = FoundId::None;
    }
  }
}

void Labels::bringNearOnesBack(std::vector<FoundBox>& found, const Vec2& here, double near_m) {
  std::vector<Settled> kept;
  for (const Settled& settled : settled_) {
    if (isWithin(near_m, settled.found, here)) {
      found.push_back(settled.found);
    } else {
      kept.push_back(settled);
    }
  }
  if (kept.size() == settled_.size()) return;
  settled_ = std::move(kept);
  settled_at_.assign(settled_at_.size(), kNowhere);
  roots_ = rootHypotheses(drawing_, options_);
  for (std::size_t i = 0; i < settled_.size(); ++i) {
    const std::size_t drawn = settled_[i].drawn;
    if (drawn == kNowhere) continue;
    const Building& building = drawing_.buildings[drawn];
    settle(roots_, building, drawing_.uncertaintyOf(building), settled_[i].found, options_);
    settled_at_[drawn] = i;
  }
}

void Labels::findNearby(const Vec2& here, double near_m) {
  for (const std::size_t building : nearby_) {
    const std::size_t place = nearby_at_[building];
    if (hypotheses_.front().found_of[place] == FoundId::None) {
      missed_[building] = doubtOf(place);
    }
    nearby_at_[building] = kNowhere;
  }
  nearby_.clear();
  nearby_drawing_.buildings.clear();
  const DrawingMotion& where = motion();
  for (std::size_t b = 0; b < centres_.size(); ++b) {
    if (settled_at_[b] != kNowhere) continue;
    const double off = kNearSigmas * drawing_.uncertaintyOf(drawing_.buildings[b]).position;
    if ((where(centres_[b]) - here).norm() > near_m + off) continue;
    nearby_at_[b] = nearby_.size();
    nearby_.push_back(b);
    nearby_drawing_.buildings.push_back(drawing_.buildings[b]);
  }
}

std::vector<FoundBox> Labels::settled(std::size_t most) const {
  std::vector<FoundBox> boxes;
  for (std::size_t i = settled_.size() - std::min(most, settled_.size()); i < settled_.size();
       ++i) {
    boxes.push_back(settled_[i].found);
  }
  return boxes;
}

void Labels::setSettled(std::span<const FoundBox> boxes) {
  const std::size_t first = settled_.size() - boxes.size();
  for (std::size_t i = 0; i < boxes.size(); ++i) settled_[first + i].found = boxes[i];
}

DrawingPrior Labels::prior(std::size_t most, std::span<const FoundBox> found) const {
  DrawingPrior prior;
  prior.expected = expected_;
  prior.motion = motion();
  if (options_.free_scale || options_.free_turn) prior.expected.mean = prior.motion.mean;
  prior.turn = freeTurn();
  const auto add = [&](FoundId box, std::size_t drawn, double doubt) {
    if (drawn == kNowhere || doubt > kMostDoubt) return;
    const Building& building = drawing_.buildings[drawn];
    prior.anchors.push_back({box, &building, drawing_.uncertaintyOf(building)});
  };
  for (std::size_t i = settled_.size() - std::min(most, settled_.size()); i < settled_.size();
       ++i) {
    add(settled_[i].found.id, settled_[i].drawn, settled_[i].doubt);
  }
  for (const FoundBox& box : found) {
    const std::size_t drawn = drawnOf(box.id).value_or(kNowhere);
    add(box.id, drawn, drawn == kNowhere ? 1.0 : doubtOf(nearby_at_[drawn]));
  }
  return prior;
}

std::optional<std::size_t> Labels::drawnOf(FoundId found) const {
  const std::vector<FoundId>& found_of = hypotheses_.front().found_of;
  const auto at = std::find(found_of.begin(), found_of.end(), found);
  if (at == found_of.end()) return std::nullopt;
  return nearby_[static_cast<std::size_t>(at - found_of.begin())];
}

std::vector<std::optional<std::size_t>> Labels::recognise(std::span<const FoundBox> boxes,
                                                          const Vec2& here, double shift_m) const {
  Map around;
  around.start = drawing_.start;
  around.uncertainty = drawing_.uncertainty;
  std::vector<std::size_t> which;
  for (std::size_t b = 0; b < centres_.size(); ++b) {
    if ((motion()(centres_[b]) - here).norm() > kReach_m + kNearSigmas * shift_m) continue;
    which.push_back(b);
    around.buildings.push_back(drawing_.buildings[b]);
  }
  Hypothesis root{{}, motion(), 0.0, 1.0};
  root.motion.covariance(2, 2) += shift_m * shift_m;
  root.motion.covariance(3, 3) += shift_m * shift_m;
  const std::vector<Hypothesis> hypotheses = assign(around, boxes, {}, {root}, options_);
  std::vector<std::optional<std::size_t>> labels(boxes.size());
  for (std::size_t b = 0; b < which.size(); ++b) {
    const FoundBox* best = findBox(boxes, hypotheses.front().found_of[b]);
    if (!best) continue;
    if (agreement(hypotheses, b) > kSure) {
      labels[static_cast<std::size_t>(best - boxes.data())] = which[b];
    }
  }
  return labels;
}

double Labels::headingScatter(std::span<const FoundBox> found) const {
  std::vector<double> errors;
  for (const std::size_t b : nearby_) {
    const FoundBox* box = foundFor(b, hypotheses_.front(), found);
    if (!box || box->observations < kLeastSeen) continue;
    errors.push_back(std::abs(std::remainder(
        box->box.heading - drawing_.buildings[b].box().heading - motion().turn(), kPi / 2.0)));
  }
  if (errors.empty()) return options_.heading_sigma;
  const double sigma = kMedianToSigma * medianOf(errors);
  const auto count = static_cast<double>(errors.size());
  return std::sqrt(
      (kAssumed * options_.heading_sigma * options_.heading_sigma + count * sigma * sigma) /
      (kAssumed + count));
}

double Labels::doubtOf(std::size_t place) const {
  const double agreed = agreement(hypotheses_, place);
  return hypotheses_.front().found_of[place] == FoundId::None ? agreed : 1.0 - agreed;
}

const FoundBox* Labels::foundFor(std::size_t building, const Hypothesis& hypothesis,
                                 std::span<const FoundBox> found) const {
  if (settled_at_[building] != kNowhere) return &settled_[settled_at_[building]].found;
  const std::size_t place = nearby_at_[building];
  if (place == kNowhere || hypothesis.found_of[place] == FoundId::None) return nullptr;
  return findBox(found, hypothesis.found_of[place]);
}

Labels::Label Labels::of(std::size_t building, std::span<const FoundBox> found) const {
  Label label{foundFor(building, hypotheses_.front(), found), missed_[building]};
  if (settled_at_[building] != kNowhere) {
    label.doubt = settled_[settled_at_[building]].doubt;
  } else if (isNearby(building)) {
    label.doubt = doubtOf(nearby_at_[building]);
  }
  return label;
}

}  // namespace handmap
