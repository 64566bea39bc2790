#include "core/estimation/smoothing/smoother.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.h"
#include "core/estimation/smoothing/constants.h"
#include "core/estimation/smoothing/landmark_factor.h"

namespace handmap {

using namespace smoothing;

namespace {

using Unknowns = NormalEquations::Unknowns;

/// Walls that would pass one another stay.
void move(Box& box, const Eigen::Matrix<double, kBoxSize, 1>& step) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double one = box.reach[axis] + step[static_cast<int>(axis)];
    const double other = box.reach[axis + 2] + step[static_cast<int>(axis) + 2];
    if (one + other < kLeastSize_m) continue;
    box.reach[axis] = one;
    box.reach[axis + 2] = other;
  }
  box.heading += std::clamp(step[kBoxSize - 1], -kMostTurn, kMostTurn);
}

}  // namespace

double Smoother::iterate(const SmoothingGraph& graph, double slack_m, const std::stop_token& stop) {
  layout_ = StateLayout(graph);
  NormalEquations equations(layout_.size());
  addOdometry(graph, equations);
  const std::vector<int> observations = addBuildings(graph, slack_m, stop, equations);
  if (stop.stop_requested()) return 0.0;
  addHeadings(graph, equations);
  for (const auto& [old, again] : graph.same) {
    const std::size_t a = layout_.indexOf(old);
    const std::size_t b = layout_.indexOf(again);
    addSame(graph.boxes[a], graph.boxes[b], layout_.box(a), layout_.box(b), equations);
  }
  if (graph.drawing) addDrawing(graph, layout_, equations);
  addCalibration(graph.frames, equations);
  addLandmarks(graph, equations);
  if (stop.stop_requested()) return 0.0;
  const std::optional<Eigen::VectorXd> step = solver_.solve(equations);
  if (!step) return 0.0;
  for (std::size_t b = 0; b < graph.boxes.size(); ++b) {
    graph.boxes[b].observations = observations[b];
  }
  return update(graph, *step);
}

void Smoother::addOdometry(const SmoothingGraph& graph, NormalEquations& equations) const {
  for (std::size_t i = std::max<std::size_t>(graph.fixed, 1); i < graph.frames.size(); ++i) {
    equations.add(odometryFactor(*graph.frames[i - 1], *graph.frames[i], scale_, odometry_),
                  std::array{Unknowns{layout_.pose(i - 1), kPoseSize},
                             Unknowns{layout_.pose(i), kPoseSize}, Unknowns{layout_.scale(), 1}});
  }
}

std::vector<int> Smoother::addBuildings(const SmoothingGraph& graph, double slack_m,
                                        const std::stop_token& stop,
                                        NormalEquations& equations) const {
  const SightErrors errors{slack_m, systematic_m_, bias_per_m_};
  std::vector<int> observations(graph.boxes.size());
  std::vector<std::size_t> seeing;  // frames that may have seen a box
  std::vector<std::optional<SightEquations>> sights;
  for (std::size_t b = 0; b < graph.boxes.size() && !stop.stop_requested(); ++b) {
    const FoundBox& found = graph.boxes[b];
    seeing.clear();
    for (std::size_t i = 0; i < graph.frames.size(); ++i) {
      const std::size_t number = graph.frames[i]->number;
      if (number >= found.first_frame && number <= found.last_frame) seeing.push_back(i);
    }
    sights.resize(seeing.size());
    parallelFor(seeing.size(), [&](std::size_t i) {
      sights[i] = sightEquations(*graph.frames[seeing[i]], found.box, sensor_, errors);
    });
    for (std::size_t i = 0; i < seeing.size(); ++i) {
      if (!sights[i]) continue;
      equations.add(sights[i]->matrix, sights[i]->right,
                    std::array{Unknowns{layout_.pose(seeing[i]), kPoseSize},
                               Unknowns{layout_.box(b), kBoxSize}, Unknowns{layout_.bias(), 1}});
      ++observations[b];
    }
    addReachDamping(layout_.box(b), equations);
    if (found.predates(graph.frames)) addKnownWalls(found, layout_.box(b), equations);
  }
  return observations;
}

/// A labelled building stands as it was drawn, another one in one of the drawing's directions.
void Smoother::addHeadings(const SmoothingGraph& graph, NormalEquations& equations) const {
  std::vector<const Building*> drawn(graph.boxes.size());
  if (graph.drawing) {
    for (const DrawingPrior::Anchor& anchor : graph.drawing->anchors) {
      drawn[layout_.indexOf(anchor.box)] = anchor.drawn;
    }
  }
  for (std::size_t b = 0; b < graph.boxes.size(); ++b) {
    const HeadingPrior own =
        drawn[b] ? HeadingPrior{{drawn[b]->box().heading + graph.drawing->turn}, headings_.sigma}
                 : HeadingPrior{};
    equations.add(headingFactor(graph.boxes[b].box, drawn[b] ? own : headings_),
                  std::array{Unknowns{layout_.box(b) + kBoxSize - 1, 1}});
  }
}

void Smoother::addLandmarks(const SmoothingGraph& graph, NormalEquations& equations) const {
  for (std::size_t i = 0; i < graph.frames.size(); ++i) {
    const Frame& frame = *graph.frames[i];
    for (const Sighting& sighting : frame.sightings) {
      const auto id = static_cast<std::size_t>(sighting.landmark);
      if (layout_.landmark(id) == kNone) continue;
      equations.add(
          landmarkFactor(frame.pose, graph.landmarks[id], sighting, bias_per_m_, systematic_m_),
          std::array{Unknowns{layout_.pose(i), kPoseSize},
                     Unknowns{layout_.landmark(id), kLandmarkSize}, Unknowns{layout_.bias(), 1}});
    }
  }
}

void Smoother::addCalibration(std::span<Frame* const> frames, NormalEquations& equations) const {
  double sigma = kLeastBias;
  for (const Frame* frame : frames) sigma = std::max(sigma, frame->bias_sigma_per_m);
  equations.add(layout_.bias(), layout_.bias(), 1.0 / (sigma * sigma));
  equations.right(layout_.bias()) -= bias_per_m_ / (sigma * sigma);
  // Cauchy's weight.
  const double weight = 1.0 / (kScale * kScale + scale_ * scale_);
  // It changes little from one window of frames to the next: what one tells is no more than a part.
  equations.add(layout_.scale(), layout_.scale(), weight + 1.0 / (kScaleChange * kScaleChange));
  equations.right(layout_.scale()) -= scale_ * weight;
}

double Smoother::update(const SmoothingGraph& graph, const Eigen::VectorXd& step) {
  double moved = 0.0;
  for (std::size_t i = graph.fixed; i < graph.frames.size(); ++i) {
    Pose2& pose = graph.frames[i]->pose;
    const Eigen::Vector3d by = step.segment<kPoseSize>(layout_.pose(i));
    moved = std::max(moved, by.head<2>().norm());
    pose.x += by.x();
    pose.y += by.y();
    pose.heading = normalizedAngle(pose.heading + by.z());
  }
  for (std::size_t b = 0; b < graph.boxes.size(); ++b) {
    move(graph.boxes[b].box, step.segment<kBoxSize>(layout_.box(b)));
  }
  bias_per_m_ += step[layout_.bias()];
  scale_ += step[layout_.scale()];
  if (graph.drawing) graph.drawing->motion.mean += step.segment<kMotionSize>(layout_.motion());
  for (std::size_t i = 0; i < graph.landmarks.size(); ++i) {
    const int at = layout_.landmark(i);
    if (at != kNone) graph.landmarks[i] += step.segment<kLandmarkSize>(at);
  }
  return moved;
}

std::optional<Eigen::Matrix3d> Smoother::covariances(std::span<FoundBox> boxes) const {
  if (!solver_.isSolved()) return std::nullopt;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    const int at = layout_.box(b);
    for (int k = 0; k < 4; ++k) {
      boxes[b].covariance.col(k) = solver_.covarianceColumn(at + k).segment<4>(at);
    }
    boxes[b].heading_sigma = std::sqrt(std::max(solver_.covarianceColumn(at + 4)[at + 4], 0.0));
  }
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  const int last = layout_.lastPose();
  for (int k = 0; last != kNone && k < kPoseSize; ++k) {
    covariance.col(k) = solver_.covarianceColumn(last + k).segment<kPoseSize>(last);
  }
  return covariance;
}

}  // namespace handmap
