// What is assumed of found buildings, and what the drawing says of them.
#pragma once

#include <vector>

#include "core/estimation/drawing/drawing_prior.h"
#include "core/estimation/drawing/drawn_box.h"
#include "core/estimation/smoothing/smoothing_graph.h"
#include "core/pose_graph/normal_equations.h"

namespace handmap {

/// The main directions of the drawing (modulo π/2), and how far a building may be turned against
/// the nearest, one σ.
struct HeadingPrior {
  std::vector<double> headings;
  double sigma = 0.1;
};

/// How far a box is turned against what is expected, at most two σ of it. State: its heading.
ScalarFactor<1> headingFactor(const Box& box, const HeadingPrior& prior);

/// Holds a building to the size that it has as far as nobody saw both sides, and to its place where
/// nobody saw any.
void addReachDamping(int box_at, NormalEquations& equations);

/// Holds walls to where they are that an earlier visit told, of which there are no frames here.
void addKnownWalls(const FoundBox& found, int box_at, NormalEquations& equations);

/// Two boxes of one building have the same walls.
void addSame(const FoundBox& old, const FoundBox& again, int old_at, int again_at,
             NormalEquations& equations);

/// The walls of a box less those that the drawing predicts. weight: inverse of their covariance,
/// times what the robust kernel leaves.
struct DrawnWallsFactor {
  Eigen::Vector4d residual;
  Eigen::Matrix4d by_motion;  ///< of the prediction, by DrawingMotion::mean
  Eigen::Matrix4d weight;
};
/// `seen`: not empty.
DrawnWallsFactor drawnWallsFactor(const FoundBox& found, const SeenWalls& seen,
                                  const DrawingPrior::Anchor& anchor, const DrawingMotion& motion);

/// Of all anchors, and of the motion as it was expected.
void addDrawing(const SmoothingGraph& graph, const StateLayout& layout, NormalEquations& equations);

}  // namespace handmap
