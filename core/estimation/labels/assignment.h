// Which found building is which drawn one: hypotheses over all of them together.
#pragma once

#include <span>
#include <vector>

#include "core/estimation/labels/pairing.h"

namespace handmap {

struct AssignmentOptions : PairingOptions {
  int hypotheses = 100;  ///< choice
  double undrawn =
      0.05;  ///< found buildings that no one drew, as a share of the drawn ones; choice
  double phantom = 0.02;  ///< drawn ones that are not there or were not found, share; choice
  double uncertain_phantom = 0.5;  ///< the same of those that their drawer says may not exist
  double disorder = 2.0;    ///< price of two that change places in the drawing, nats; METHOD.md 4
  double wrong_side = 3.0;  ///< and of one on the other side of the trajectory; choice
  double scale_sigma = kUsualScaleSigma;  ///< of the whole drawing
  double turn_sigma = kUsualTurnSigma;
  bool free_scale = false;  ///< the drawing may be 0.7 to 1.4 times as large
  bool free_turn = false;   ///< and turned by ±40° about the robot's start
  /// Of the robot's start on the drawing, one σ: as much as the drawing may lie elsewhere.
  double start_m = 0.0;
  double start_turn = 0.0;  ///< radians
};

/// With what the drawing itself says of its scale and turn. A turn that may be large is left free.
AssignmentOptions withStated(const WholeUncertainty& whole, AssignmentOptions options);

/// With what it says of the robot's start.
AssignmentOptions withStart(const StartUncertainty& start, AssignmentOptions options);

/// One way to assign all; what the assigned ones say of the whole drawing is marginalised exactly
/// (Rao-Blackwell: a discrete particle with a Gaussian of its own).
struct Hypothesis {
  std::vector<FoundId> found_of;  ///< by drawn building; None: left out
  DrawingMotion motion;
  double log_weight = 0.0;
  double weight = 0.0;  ///< normalized
};

/// What is assumed of a drawing before anything is assigned: one hypothesis, or a fan of them where
/// the turn is free: each is Gaussian in (a, b).
std::vector<Hypothesis> rootHypotheses(const Map& drawing, const AssignmentOptions& options);

/// What the roots are where a drawn building is known to be a found one.
void settle(std::vector<Hypothesis>& roots, const Building& drawn, const Uncertainty& uncertainty,
            const FoundBox& found, const AssignmentOptions& options);

/// The best hypotheses that grow from the roots, the best first. Not empty. `found` have ids.
/// `trajectory`: where the robot has been, map frame.
std::vector<Hypothesis> assign(const Map& drawing, std::span<const FoundBox> found,
                               std::span<const Pose2> trajectory,
                               const std::vector<Hypothesis>& roots,
                               const AssignmentOptions& options);

}  // namespace handmap
