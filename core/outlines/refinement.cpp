#include "core/outlines/refinement.h"

#include <algorithm>
#include <cmath>

#include "core/map/certainty.h"
#include "core/outlines/agreement.h"
#include "core/outlines/constants.h"

namespace handmap {

using namespace outlines;

namespace {

Polygon carried(const Polygon& drawn, const DrawingMotion& motion) {
  Polygon outline;
  for (const Vec2& corner : drawn) outline.push_back(motion(corner));
  return outline;
}

/// The side opposite the one that was seen best keeps the drawn distance from it, unless the rays
/// tell where it is, or the drawing knows its sizes, `size_m`, far worse than even a rear wall is
/// found. The ends of what was seen best are where its returns stop.
Polygon unseenAsDrawn(const Building& found, const Building& drawn, double size_m,
                      const DrawingMotion& motion, const PlacedRays& placed, double range_limit_m) {
  Polygon outline = found.footprint();
  const Rectangle box = found.box();
  // Not its box(): that of a crooked outline may lie along another wall.
  const Rectangle as_drawn = boundingRectangle(drawn.footprint(), box.heading - motion.turn());
  const double reach = std::hypot(box.width, box.depth) +
                       motion.scale() * std::hypot(as_drawn.width, as_drawn.depth);
  const OutlineScorer scorer(placed, range_limit_m, {}, kNobody, box.centre, reach);
  const auto of_side = scorer.returnsOfSides(outline, box.heading, kDrawnSlack_m);
  const auto front =
      static_cast<std::size_t>(std::max_element(of_side.begin(), of_side.end()) - of_side.begin());
  const SideEstimate rear = sidesOf(found)[(front + 2) % 4];
  const bool known = rear.seen && std::hypot(rear.sigma, kFoundRear_m) < 0.5 * size_m;
  if (known || of_side[front] < kSeenReturns) return outline;
  const double now = front % 2 == 0 ? box.width : box.depth;
  const double ratio = motion.scale() * (front % 2 == 0 ? as_drawn.width : as_drawn.depth) / now;
  const Vec2 outwards = unitVector(box.heading + static_cast<double>(front) * kPi / 2.0);
  Polygon as_deep = outline;
  for (Vec2& corner : as_deep) {
    const double depth = 0.5 * now - outwards.dot(corner - box.centre);
    corner += (1.0 - ratio) * depth * outwards;
  }
  const double told = scorer(outline, kDrawnSlack_m) - scorer(as_deep, kDrawnSlack_m);
  return told > kLeastEvidence ? outline : as_deep;
}

Building withOutline(const Building& drawn, const Polygon& outline) {
  Building building = drawn;
  if (std::holds_alternative<Polygon>(drawn.shape)) {
    building.shape = outline;
    return building;
  }
  // The corners of a rectangle begin where its own do.
  const Vec2 along = outline[1] - outline[0];
  const Vec2 across = outline[2] - outline[1];
  building.shape = Rectangle{0.25 * (outline[0] + outline[1] + outline[2] + outline[3]),
                             along.norm(), across.norm(), std::atan2(along.y(), along.x())};
  return building;
}

/// How far what the drawing states of the whole may have put a building off, one σ.
double wholeShift(const Map& drawing, const OutlineTask& task) {
  const Vec2 origin = drawing.start ? drawing.start->position() : Vec2::Zero();
  const double distance = (centroid(task.drawn) - origin).norm();
  return std::hypot(distance * task.whole.scale.value_or(0.0),
                    distance * task.whole.turn.value_or(0.0), task.whole.shift.value_or(0.0));
}

/// A building that was found is looked for where it was found, another one where it was drawn.
OutlineTask taskOf(const Map& drawing, std::size_t b, const std::optional<FoundMap>& found,
                   const PlacedRays& placed, double range_limit_m) {
  const Building& drawn = drawing.buildings[b];
  const Uncertainty uncertainty = drawing.uncertaintyOf(drawn);
  // A drawing may be surer of where it is than what is found tells; where outlines cannot be fitted
  // nothing else tells.
  const bool to_be_found =
      found && (std::max(uncertainty.position, drawing.whole.shift.value_or(0.0)) > kLabelled_m ||
                !placed.showsStructure());
  OutlineTask task;
  task.as_drawn = task.drawn = drawn.footprint();
  if (to_be_found) {
    const Building& now = found->map.buildings[b];
    task.labelled = isRecognised(now);
    task.drawn = task.labelled ? carried(task.as_drawn, found->motion) : now.footprint();
  }
  task.start = task.drawn;
  if (!to_be_found) task.whole = drawing.whole;
  task.shift_m = std::hypot(uncertainty.position, wholeShift(drawing, task));
  task.drawn_shift_m = task.shift_m;
  task.size_m = uncertainty.size;
  task.rectangle = std::holds_alternative<Rectangle>(drawn.shape);
  if (!task.labelled) return task;
  task.start = unseenAsDrawn(found->map.buildings[b], drawn, uncertainty.size, found->motion,
                             placed, range_limit_m);
  task.shift_m = kLabelled_m;
  return task;
}

std::variant<Rectangle, Polygon> moved(std::variant<Rectangle, Polygon> shape,
                                       const Pose2& motion) {
  if (auto* rectangle = std::get_if<Rectangle>(&shape)) {
    rectangle->centre = motion.toOuter(rectangle->centre);
    rectangle->heading = normalizedAngle(rectangle->heading + motion.heading);
  } else {
    for (Vec2& corner : std::get<Polygon>(shape)) corner = motion.toOuter(corner);
  }
  return shape;
}

/// How well the start tells how a way without the buildings lies on the drawing.
StartUncertainty startOf(const Map& drawing) {
  return drawing.start_uncertainty.value_or(
      StartUncertainty{kStart_m, drawing.whole.turn.value_or(kStartTurn)});
}

/// The drawing with the outlines that were found, in the frame of the way.
Map fittedMap(const Map& drawing, const std::optional<FoundMap>& found,
              const std::vector<OutlineTask>& tasks, const std::vector<OutlineResult>& results) {
  Map map = found ? found->map : drawing;
  for (std::size_t b = 0; b < tasks.size(); ++b) {
    const Building& drawn = drawing.buildings[b];
    if (drawn.fixed) continue;
    const Polygon& outline = results.empty() ? tasks[b].start : results[b].outline;
    Building& building = map.buildings[b];
    building.shape = withOutline(drawn, outline).shape;
    if (!results.empty() && results[b].estimate) {
      building.estimate = results[b].estimate;
      forgetCertainty(building);
      setSides(building, results[b].sides);
    } else if (!found || (outline == tasks[b].drawn && isRecognised(building))) {
      // It stays as drawn; what may be said of it is what the drawing says.
      const Uncertainty uncertainty = drawing.uncertaintyOf(drawn);
      found ? building.sides.reset() : forgetCertainty(building);
      building.estimate = {uncertainty.position, uncertainty.position, uncertainty.size, 0};
    }
    if (!results.empty() && results[b].doubt > 0.0) setDoubt(building, results[b].doubt);
  }
  return map;
}

void turnLessSure(Building& building, double sigma_m) {
  if (sigma_m <= 0.0) return;
  Sides sides = sidesOf(building);
  for (SideEstimate& side : sides) side.sigma = std::hypot(side.sigma, sigma_m);
  building.estimate->sigma_x = std::hypot(building.estimate->sigma_x, sigma_m);
  building.estimate->sigma_y = std::hypot(building.estimate->sigma_y, sigma_m);
  setSides(building, sides);
}

/// How much of a place is told by a way, and not by the drawing, each as sure as it is: 1 all.
double sharedBetween(double drawn_m, double way_m) {
  const double both = drawn_m * drawn_m + way_m * way_m;
  return both > 0.0 ? drawn_m * drawn_m / both : 1.0;
}

/// What is drawn right is as it was drawn; all else goes where those say that the map lies.
RefinedMap settled(const Map& drawing, Map fitted, const Agreement& agreement, bool by_start) {
  RefinedMap refined{std::move(fitted), agreement.motion, agreement.share};
  refined.refutes_start = agreement.refutes_start;
  refined.way_turn = agreement.way_turn;
  const bool start_is_off = drawing.start_uncertainty || agreement.refutes_start;
  if (start_is_off) refined.start_variance = agreement.covariance;
  const Pose2 back = inverse(agreement.motion);
  const Vec2 origin = drawing.start ? drawing.start->position() : Vec2::Zero();
  const bool told_by_start = by_start || start_is_off;
  for (std::size_t b = 0; b < drawing.buildings.size(); ++b) {
    const Building& drawn = drawing.buildings[b];
    Building& building = refined.map.buildings[b];
    if (drawn.fixed) continue;
    const bool seen = isRecognised(building);
    // A way that was told without the drawing says nothing of what nobody saw along it.
    const bool as_drawn = agreement.isRight(b) || (by_start && !seen);
    building.shape = as_drawn ? drawn.shape : moved(building.shape, back);
    if (!seen) continue;
    const Vec2 from_start = centroid(building.footprint()) - origin;
    const double way_m = agreement.way_turn * from_start.norm();
    // The drawing has its share already in a way that was laid along its buildings.
    const double by_way =
        by_start ? sharedBetween(drawing.uncertaintyOf(drawn).position, way_m) : 1.0;
    if (!as_drawn && by_start) {
      const Vec2 back_to_drawn = centroid(drawn.footprint()) - centroid(building.footprint());
      const Vec2 by = (1.0 - by_way) * back_to_drawn;
      building.shape = moved(building.shape, {by.x(), by.y(), 0.0});
    }
    const double start_m = told_by_start ? agreement.sigmaAt(from_start) : 0.0;
    turnLessSure(building, std::hypot(start_m, std::sqrt(by_way) * way_m));
  }
  return refined;
}

}  // namespace

double supportOf(const Map& drawing, const PlacedRays& placed, double range_limit_m,
                 const std::stop_token& stop) {
  double met = 0.0;
  double supported = 0.0;
  for (const Building& building : drawing.buildings) {
    if (stop.stop_requested()) return 0.0;
    const Polygon outline = building.footprint();
    const Bounds bounds = boundsOf(outline);
    const double radius = 0.5 * (bounds.high - bounds.low).norm();
    const OutlineScorer scorer(placed, range_limit_m, {}, kNobody, 0.5 * (bounds.low + bounds.high),
                               radius);
    const double evidence = scorer(outline, kDrawnSlack_m);
    if (std::abs(evidence) < kTells) continue;
    met += 1.0;
    if (evidence > 0.0) supported += 1.0;
  }
  return met > 0.0 ? supported / met : 0.0;
}

std::optional<RefinedMap> refine(const Map& drawing, const std::optional<FoundMap>& found,
                                 const PlacedRays& placed, double range_limit_m, std::uint64_t seed,
                                 const std::stop_token& stop,
                                 const std::function<void(double)>& progress, double way_turn) {
  std::vector<OutlineTask> tasks;
  for (std::size_t b = 0; b < drawing.buildings.size(); ++b) {
    if (stop.stop_requested()) return std::nullopt;
    tasks.push_back(taskOf(drawing, b, found, placed, range_limit_m));
  }
  std::vector<OutlineResult> results;
  if (placed.showsStructure()) {
    results = fitOutlines(tasks, placed, range_limit_m, seed, stop, progress);
    if (results.empty()) return std::nullopt;
  }
  Map fitted = fittedMap(drawing, found, tasks, results);
  const StartUncertainty start = startOf(drawing);
  const Agreement agreement = agreementOf(drawing, fitted, std::max(start.position, kSpreadFirst_m),
                                          std::max(start.heading, kLeastStartTurn), way_turn);
  return settled(drawing, std::move(fitted), agreement, !found);
}

}  // namespace handmap
