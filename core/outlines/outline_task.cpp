#include "core/outlines/outline_task.h"

#include <algorithm>
#include <cmath>

#include "core/outlines/constants.h"

namespace handmap {

using namespace outlines;

double headingOf(const Polygon& outline) {
  double longest = 0.0;
  Vec2 along(1.0, 0.0);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 wall = outline[i] - outline[(i + outline.size() - 1) % outline.size()];
    if (wall.norm() <= longest) continue;
    longest = wall.norm();
    along = wall;
  }
  return std::atan2(along.y(), along.x());
}

OutlinePrior priorOf(const OutlineTask& task) {
  OutlinePrior prior;
  prior.start = task.start;
  prior.heading = headingOf(task.start);
  const Rectangle now = boundingRectangle(task.start, prior.heading);
  // What is longest may have become another side.
  const double turn = std::remainder(headingOf(task.drawn) - prior.heading, kPi / 2.0);
  const Rectangle drawn = boundingRectangle(task.drawn, prior.heading + turn);
  prior.expected_log_size = {std::log(drawn.width / now.width), std::log(drawn.depth / now.depth)};
  prior.shift_m = task.shift_m;
  const double share = task.size_m / std::sqrt(drawn.width * drawn.depth);
  prior.log_scale =
      std::clamp(std::hypot(share, task.whole.scale.value_or(0.0)), kLeastShare, kMostScale);
  prior.turn = std::clamp(std::hypot(share, task.whole.turn.value_or(0.0)), kLeastShare, kMostTurn);
  prior.shear = task.rectangle ? 0.0 : std::clamp(share, kLeastShare, kMostShear);
  return prior;
}

OutlineTask asDrawn(OutlineTask task) {
  task.drawn = task.start = task.as_drawn;
  task.shift_m = task.drawn_shift_m;
  task.labelled = false;
  return task;
}

}  // namespace handmap
