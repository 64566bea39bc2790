// One observation phase by phase: what each phase of a method changed, for those who want to look.
#pragma once

#include <vector>

#include "core/method/snapshot.h"

namespace handmap {

enum class PhaseKind {
  // The published method, Algorithm 1.
  Prediction,
  LocalMap,
  Swarms,  ///< one phase an iteration (Fig. 5)
  Weights,
  Resampling,
  // Ours.
  Way,
  Poses,
  Evidence,
  Detection,
  Labels,
  Correction
};

/// What a phase has to say in figures; each is told by the kinds that stand with it.
struct PhaseFacts {
  int iteration = 0;   ///< Swarms; 0: before the first
  int iterations = 0;  ///< Swarms
  /// Swarms: buildings in sight. Resampling: particles that stayed. Detection: buildings found.
  /// Labels: found buildings that are drawn ones. Correction: buildings that moved.
  int count = 0;
  int of = 0;  ///< Weights, Resampling: particles. Detection: walls. Labels: found buildings.
  /// Prediction, Way: the robot, by the odometry. Poses: the robot, since Way. Swarms: the best
  /// outline that moved farthest since the iteration before. Correction: the building that did.
  double moved_m = 0.0;
  double turned = 0.0;  ///< radians; Prediction, Way, Poses
  /// Swarms: best scores of all buildings. Weights: effective sample size.
  double value = 0.0;
  /// Resampling: it was due. Correction: a loop was closed.
  bool happened = false;
};

struct Phase {
  PhaseKind kind = PhaseKind::Prediction;
  PhaseFacts facts;
  Snapshot shown;                 ///< everything as it was after the phase
  std::vector<Segment> walls;     ///< found, map frame
  std::vector<Polygon> outlines;  ///< of buildings: the best of each swarm, or what was found
  std::vector<Segment> links;     ///< from what was found to what it is taken for
};

/// Collects the phases of one observation.
class PhaseRecorder {
 public:
  explicit PhaseRecorder(Snapshot before) : now_(std::move(before)) {}

  /// To be changed by the method as it goes.
  Snapshot& now() { return now_; }
  /// A phase that shows now() as it is.
  Phase& add(PhaseKind kind) { return phases_.emplace_back(Phase{kind, {}, now_, {}, {}, {}}); }
  std::vector<Phase> take() { return std::move(phases_); }

 private:
  Snapshot now_;
  std::vector<Phase> phases_;
};

}  // namespace handmap
