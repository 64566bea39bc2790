// Buildings found, followed and labelled.
#include <algorithm>
#include <cmath>

#include "core/estimation/constants.h"
#include "core/estimation/estimator_state.h"

namespace handmap {

using namespace estimation;

bool HandmapEstimator::State::isInSight(const FoundBox& box) const {
  return !box.dormant && isInReach(box);
}

bool HandmapEstimator::State::isInReach(const FoundBox& box) const {
  return BoxView(box.box, frames.back().pose).inReach(options.range_limit_m);
}

void HandmapEstimator::State::updateDirections() {
  const Vec2 here = frames.back().pose.position();
  const DrawingMotion& motion = labels.motion();
  std::vector<double> drawn;
  for (const std::size_t b : labels.nearby()) {
    const Building& building = drawing.buildings[b];
    const Rectangle box = building.box();
    const double reach = options.range_limit_m + 0.5 * std::hypot(box.width, box.depth) +
                         drawing.uncertaintyOf(building).position;
    if ((motion(box.centre) - here).norm() < reach)
      drawn.push_back(box.heading + labels.freeTurn());
  }
  directions.update(drawn, evidence.frames(), sensor, evidence.evidence());
  smoother.expectHeadings({directions.drawn(), labels.headingScatter(found)});
}

/// Where key frames are close to each other buildings are refined at one and walls detected at the
/// next. Returns whether walls were.
bool HandmapEstimator::State::findBuildings() {
  const bool both =
      frames.size() < 2 || frames.back().driven_m - frames[frames.size() - 2].driven_m > kClose_m;
  const bool detects = both || !detected_last;
  detected_last = detects;
  for (FoundBox& box : found) box.in_sight = isInSight(box);
  const auto dormant = std::stable_partition(found.begin(), found.end(),
                                             [](const FoundBox& box) { return !box.dormant; });
  const std::vector<FoundBox> aside(dormant, found.end());
  found.erase(dormant, found.end());
  const std::vector<Frame*> last = framesFrom(firstActive());
  const std::span<const Frame* const> seen(last.begin(), last.end());
  if (both || !detects) finder.refineAll(found, seen, sensor);
  if (detects) {
    finder.update(
        found,
        detectWalls(evidence.evidence(), frames.back().pose.position(), options.range_limit_m),
        seen, sensor);
  }
  found.insert(found.end(), aside.begin(), aside.end());
  return detects;
}

/// What has been out of sight for long becomes dormant: the trajectory may have drifted since. It
/// is so no longer where something is in sight that was there before it became dormant.
void HandmapEstimator::State::followBuildings() {
  const std::size_t now = frames.back().number;
  std::size_t oldest = now;
  for (FoundBox& box : found) {
    if (box.last_frame > now) {  // a new one
      box.first_frame = frames[firstActive()].number;
      box.last_frame = now;
    }
    if (isInSight(box)) {
      box.last_frame = now;
      oldest = std::min(oldest, box.first_frame);
    } else if (box.last_frame + kMostActive < now) {
      box.dormant = true;
    }
  }
  for (FoundBox& box : found) {
    if (!box.dormant || box.last_frame < oldest || !isInReach(box)) continue;
    box.dormant = false;
    box.last_frame = now;
  }
}

void HandmapEstimator::State::updateNoise() {
  noise.add(frames.back(), found, sensor);
  clutter.add(frames.back(), found, sensor);
  smoother.setSystematic(noise.systematic());
  MeasuredSensor changed = sensor.measured();
  changed.noise = noise.fitted(changed.noise);
  changed.noise.bias_per_m = smoother.biasPerMetre();
  changed.clutter = clutter.measured();
  if (differMuch(changed.noise, sensor.measured().noise) ||
      differMuch(changed.clutter, sensor.measured().clutter)) {
    sensor = SensorModel(changed, sensor.rangeLimit());
    evidence.setSensor(sensor);
  }
}

void HandmapEstimator::State::labelBuildings(double near_m) {
  std::vector<Pose2> trajectory_here;
  const std::size_t last = std::min(frames.size(), kLastPoses);
  for (std::size_t i = frames.size() - last; i < frames.size(); ++i) {
    trajectory_here.push_back(frames[i].pose);
  }
  labels.update(found, trajectory_here, near_m);
}

}  // namespace handmap
