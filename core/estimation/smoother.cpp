#include "core/estimation/smoother.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "core/estimation/silhouette.h"

namespace handmap {

namespace {

constexpr int kPoseSize = 3;
constexpr int kBoxSize = 5;
constexpr int kBias = kPoseSize + kBoxSize;
constexpr double kSizePrior = 4.0;    // metres, one σ
constexpr double kPlacePrior = 40.0;  // metres, one σ
constexpr double kHeadingPrior = 0.2;
constexpr double kLeastKnown = 0.3;  // metres, one σ
constexpr double kLeastSize = 2.0;   // metres
constexpr double kMostTurn = 0.05;   // radians an iteration
constexpr double kEndsAreWorse = 3.0;
constexpr int kLeastSightings = 3;  // of a landmark that is to be trusted
constexpr float kLeastCosine = 0.02F;
constexpr double kLeastBias = 1e-9;  // 1/m, one σ
constexpr double kScaleChange = 0.002;
constexpr double kSameWall = 0.1;  // metres, one σ
constexpr double kSameHeading = 0.01;
constexpr double kTogether = 2.0;  // times σ: what stands together is drawn wrong together
constexpr double kNowhere = 1e6;   // m²

/// Walls that would pass one another stay.
void move(Box& box, const Eigen::Matrix<double, kBoxSize, 1>& step) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double one = box.reach[axis] + step[static_cast<int>(axis)];
    const double other = box.reach[axis + 2] + step[static_cast<int>(axis) + 2];
    if (one + other < kLeastSize) continue;
    box.reach[axis] = one;
    box.reach[axis + 2] = other;
  }
  box.heading += std::clamp(step[kBoxSize - 1], -kMostTurn, kMostTurn);
}

}  // namespace

void Smoother::Normal::add(const LocalVector& jacobian, double residual, double weight) {
  matrix.noalias() += weight * jacobian * jacobian.transpose();
  right.noalias() -= weight * residual * jacobian;
}

bool Smoother::addReturns(const Frame& frame, const FoundBox& found, double slack_m,
                          Normal& normal) const {
  const Box& box = found.box;
  const BoxView view(box, frame.pose);
  if (view.inside() || !view.inReach(sensor_.rangeLimit())) return false;
  const double c = std::cos(frame.pose.heading);
  const double s = std::sin(frame.pose.heading);
  std::vector<Vec2> normals;
  for (std::size_t k = 0; k < box.walls(); ++k) normals.push_back(box.normal(k));
  std::vector<Normal> walls(box.walls());
  std::vector<double> information(box.walls());
  view.forRays(frame.rays, [&](const FrameRay& ray) {
    if (ray.sight.label == SensorModel::kSilent) return;
    const Entry entry = view.entry(ray);
    if (entry.distance < 0.0F) return;
    const double noise = sensor_.options().noise.at(entry.distance);
    // Near the limit only the returns that noise makes shorter come back.
    if (entry.distance + 2.0 * noise > sensor_.rangeLimit()) return;
    const double cosine = std::max(entry.cosine, kLeastCosine);
    const double sigma = std::hypot(noise, slack_m / cosine);
    const double squared = static_cast<double>(entry.distance * entry.distance);
    const double range_error =
        static_cast<double>(ray.sight.range - entry.distance) - bias_per_m_ * squared;
    if (std::abs(range_error) > 4.0 * sigma) return;
    const double weight = sensor_.responsibility(ray.sight.label, range_error, sigma) /
                          (sigma * sigma * cosine * cosine);
    const auto wall = static_cast<std::size_t>(entry.wall);
    // At the hypothesised point: at the measured one the noise would be in the slopes as well.
    const Vec2 direction(c * ray.x - s * ray.y, s * ray.x + c * ray.y);
    const Vec2 turned = static_cast<double>(entry.distance) * direction;
    const Vec2 from_pivot = frame.pose.position() + turned - box.pivot;
    const Vec2& n = normals[wall];
    LocalVector jacobian = LocalVector::Zero();
    jacobian.head<3>() << n.x(), n.y(), n.dot(perpendicular(turned));
    const std::array<double, 4> slopes = box.slopes(box.shareAt(box.pivot + from_pivot), n);
    for (std::size_t k = 0; k < 4; ++k) jacobian[kPoseSize + static_cast<int>(k)] = -slopes[k];
    jacobian[kPoseSize + 4] = perpendicular(n).dot(from_pivot);
    jacobian[kBias] = -squared * n.dot(direction);
    const double clutter_error = sensor_.clutterError(ray.sight.label, noise);
    walls[wall].add(jacobian, (range_error - clutter_error) * n.dot(direction), weight);
    information[wall] += weight;
  });
  bool seen = false;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    if (information[k] == 0.0) continue;
    const double share = 1.0 / (1.0 + information[k] * systematic_m_ * systematic_m_);
    normal.matrix += share * walls[k].matrix;
    normal.right += share * walls[k].right;
    seen = true;
  }
  return seen;
}

void Smoother::addSilhouette(const Frame& frame, const FoundBox& found, Normal& normal) const {
  const Box& box = found.box;
  for (const SeenEnd& end : silhouette(box, frame, sensor_)) {
    const Vec2 corner = box.corner(end.corner);
    const Vec2 offset = corner - frame.pose.position();
    const Vec2 slope = perpendicular(offset) / offset.squaredNorm();
    LocalVector jacobian = LocalVector::Zero();
    jacobian.head<3>() << -slope.x(), -slope.y(), -1.0;
    const std::array<double, 4> slopes = box.slopes(box.share(end.corner), slope);
    for (std::size_t k = 0; k < 4; ++k) jacobian[kPoseSize + static_cast<int>(k)] = slopes[k];
    jacobian[kPoseSize + 4] = slope.dot(perpendicular(corner - box.pivot));
    const double bearing = std::atan2(offset.y(), offset.x()) - frame.pose.heading;
    const double sigma = std::hypot(end.sigma, kEndsAreWorse * systematic_m_ / offset.norm());
    normal.add(jacobian, normalizedAngle(bearing - end.bearing), 1.0 / (sigma * sigma));
  }
}

void Smoother::addBlock(int row, int column, const Eigen::MatrixXd& block) {
  for (int i = 0; i < block.rows(); ++i) {
    for (int j = 0; j < block.cols(); ++j) {
      if (row + i >= column + j) triplets_.emplace_back(row + i, column + j, block(i, j));
    }
  }
}

void Smoother::scatter(const Normal& normal, int pose, int box) {
  const int box_at = poses_ * kPoseSize + box * kBoxSize;
  addBlock(box_at, box_at, normal.matrix.block<kBoxSize, kBoxSize>(kPoseSize, kPoseSize));
  addBlock(bias_at_, box_at, normal.matrix.block<1, kBoxSize>(kBias, kPoseSize));
  addBlock(bias_at_, bias_at_, normal.matrix.block<1, 1>(kBias, kBias));
  right_.segment<kBoxSize>(box_at) += normal.right.segment<kBoxSize>(kPoseSize);
  right_[bias_at_] += normal.right[kBias];
  if (pose < 0) return;
  const int pose_at = pose * kPoseSize;
  addBlock(pose_at, pose_at, normal.matrix.topLeftCorner<kPoseSize, kPoseSize>());
  addBlock(box_at, pose_at, normal.matrix.block<kBoxSize, kPoseSize>(kPoseSize, 0));
  addBlock(bias_at_, pose_at, normal.matrix.block<1, kPoseSize>(kBias, 0));
  right_.segment<kPoseSize>(pose_at) += normal.right.head<kPoseSize>();
}

void Smoother::addOdometry(const Frame& from, const Frame& to, int from_index, int to_index) {
  const Pose2 counted = between(from.odometry, to.odometry);
  const Pose2 measured = scaled(counted);
  const Pose2 step = between(from.pose, to.pose);
  const double length = std::hypot(measured.x, measured.y);
  const double heading = std::sqrt(odometry_.heading_variance_per_m * length) +
                         odometry_.heading_per_rad * std::abs(measured.heading) +
                         odometry_.least_heading;
  const Eigen::Vector3d sigma =
      to.odometry_noise *
      Eigen::Vector3d(odometry_.length_per_m * length + odometry_.least_length_m,
                      odometry_.side_per_m * length + odometry_.least_length_m, heading);
  const Eigen::Vector3d residual(step.x - measured.x, step.y - measured.y,
                                 normalizedAngle(step.heading - measured.heading));
  const double c = std::cos(from.pose.heading);
  const double s = std::sin(from.pose.heading);
  Eigen::Matrix<double, 3, 7> jacobian;               // both poses, the scale
  jacobian << -c, -s, step.y, c, s, 0.0, -counted.x,  //
      s, -c, -step.x, -s, c, 0.0, -counted.y,         //
      0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0;
  const Eigen::Matrix<double, 7, 3> weighted =
      jacobian.transpose() * sigma.cwiseInverse().cwiseAbs2().asDiagonal();
  const Eigen::Matrix<double, 7, 7> matrix = weighted * jacobian;
  const Eigen::Matrix<double, 7, 1> right = -weighted * residual;
  addBlock(scale_at_, scale_at_, matrix.block<1, 1>(6, 6));
  addBlock(scale_at_, to_index * kPoseSize, matrix.block<1, 3>(6, 3));
  right_[scale_at_] += right[6];
  addBlock(to_index * kPoseSize, to_index * kPoseSize, matrix.block<3, 3>(3, 3));
  right_.segment<3>(to_index * kPoseSize) += right.segment<3>(3);
  if (from_index < 0) return;
  addBlock(scale_at_, from_index * kPoseSize, matrix.block<1, 3>(6, 0));
  addBlock(from_index * kPoseSize, from_index * kPoseSize, matrix.topLeftCorner<3, 3>());
  addBlock(to_index * kPoseSize, from_index * kPoseSize, matrix.block<3, 3>(3, 0));
  right_.segment<3>(from_index * kPoseSize) += right.head<3>();
}

/// A building of which nobody saw both sides keeps its size, and stays where nobody saw any.
void Smoother::addReachPrior(int box_at) {
  constexpr double kSize = 1.0 / (kSizePrior * kSizePrior);
  constexpr double kPlace = 0.25 / (kPlacePrior * kPlacePrior);
  for (int k = 0; k < 2; ++k) {
    triplets_.emplace_back(box_at + k, box_at + k, kSize + kPlace);
    triplets_.emplace_back(box_at + k + 2, box_at + k + 2, kSize + kPlace);
    triplets_.emplace_back(box_at + k + 2, box_at + k, kSize - kPlace);
  }
}

/// What was found on an earlier visit, of which there are no frames here.
void Smoother::addKnownWalls(const FoundBox& found, int box_at) {
  for (int k = 0; k < 4; ++k) {
    const double sigma = std::max(found.reachSigma(static_cast<std::size_t>(k)), kLeastKnown);
    triplets_.emplace_back(box_at + k, box_at + k, 1.0 / (sigma * sigma));
  }
}

/// One of the main directions of the drawing, or any.
void Smoother::addHeadingPrior(const Box& box, std::span<const double> headings, int box_at) {
  double turned = 0.0;
  double sigma = kHeadingPrior;
  for (const double heading : headings) {
    const double against = std::remainder(box.heading - heading, kPi / 2.0);
    if (sigma == heading_sigma_ && std::abs(against) > std::abs(turned)) continue;
    turned = against;
    sigma = heading_sigma_;
  }
  const double weight = 1.0 / (sigma * sigma);
  const int at = box_at + kBoxSize - 1;
  triplets_.emplace_back(at, at, weight);
  // Robust: a building may stand as it likes.
  const double most = 2.0 * sigma;
  right_[at] -= weight * std::clamp(turned, -most, most);
}

void Smoother::addSame(const FoundBox& old, const FoundBox& again, int old_at, int again_at) {
  for (const Agreement& agreement : compare(old, again)) {
    const bool is_wall = agreement.old_parameter < 4;
    const double sigma = is_wall ? kSameWall : kSameHeading;
    const double weight = 1.0 / (sigma * sigma);
    addBlock(old_at, old_at, weight * agreement.old_slope * agreement.old_slope.transpose());
    addBlock(again_at, again_at,
             weight * agreement.again_slope * agreement.again_slope.transpose());
    // Of these two one lies below the diagonal.
    addBlock(again_at, old_at, weight * agreement.again_slope * agreement.old_slope.transpose());
    addBlock(old_at, again_at, weight * agreement.old_slope * agreement.again_slope.transpose());
    right_.segment<kBoxSize>(old_at) -= weight * agreement.error * agreement.old_slope;
    right_.segment<kBoxSize>(again_at) -= weight * agreement.error * agreement.again_slope;
  }
}

void Smoother::addDrawing(const DrawingPrior& drawing, std::span<const FoundBox> boxes) {
  const Eigen::Matrix4d prior = drawing.expected.covariance.inverse();
  addBlock(motion_at_, motion_at_, prior);
  right_.segment<4>(motion_at_) -= prior * (drawing.motion.mean - drawing.expected.mean);
  for (const DrawingPrior::Anchor& anchor : drawing.anchors) {
    const FoundBox& found = boxes[anchor.box];
    const SeenWalls seen(found);
    if (seen.count == 0) continue;
    const DrawnBox drawn(*anchor.drawn, anchor.uncertainty, drawing.motion, found.box);
    // Walls that were not seen may be anywhere.
    Eigen::Matrix4d covariance = kTogether * kTogether * drawn.covariance();
    for (Eigen::Index k = 0; k < 4; ++k) {
      if (!seen.has(k)) covariance(k, k) += kNowhere;
    }
    Eigen::Matrix4d weight = covariance.inverse();
    const Eigen::Vector4d residual =
        Eigen::Map<const Eigen::Vector4d>(found.box.reach.data()) - drawn.mean();
    // Cauchy's weight: some labels are wrong.
    weight /= 1.0 + residual.dot(weight * residual) / (4.0 * seen.count);
    const int box_at = poses_ * kPoseSize + static_cast<int>(anchor.box) * kBoxSize;
    const Eigen::Matrix4d across = drawn.slope().transpose() * weight;
    addBlock(box_at, box_at, weight);
    addBlock(motion_at_, box_at, -across);
    addBlock(motion_at_, motion_at_, across * drawn.slope());
    right_.segment<4>(box_at) -= weight * residual;
    right_.segment<4>(motion_at_) += across * residual;
  }
}

void Smoother::addCalibrationPrior(std::span<Frame* const> frames) {
  double sigma = kLeastBias;
  for (const Frame* frame : frames) sigma = std::max(sigma, frame->bias_sigma_per_m);
  triplets_.emplace_back(bias_at_, bias_at_, 1.0 / (sigma * sigma));
  right_[bias_at_] -= bias_per_m_ / (sigma * sigma);
  // Cauchy's weight.
  const double weight = 1.0 / (odometry_.scale * odometry_.scale + scale_ * scale_);
  // It changes little from one window of frames to the next: what one tells is no more than a part.
  triplets_.emplace_back(scale_at_, scale_at_, weight + 1.0 / (kScaleChange * kScaleChange));
  right_[scale_at_] -= scale_ * weight;
}

void Smoother::addSighting(const Frame& frame, const Sighting& sighting, const Vec2& landmark,
                           int pose, int landmark_at) {
  const Vec2 offset = landmark - frame.pose.position();
  const double range = std::max(offset.norm(), 0.5);
  const Vec2 along = offset / range;
  const Vec2 sideways = perpendicular(along) / range;
  const double bearing = std::atan2(offset.y(), offset.x()) - frame.pose.heading;
  const Eigen::Vector2d residual(normalizedAngle(bearing - sighting.bearing),
                                 range + bias_per_m_ * range * range - sighting.range);
  const Eigen::Vector2d sigma(
      std::hypot(sighting.bearing_sigma, kEndsAreWorse * systematic_m_ / range),
      std::hypot(sighting.range_sigma, kEndsAreWorse * systematic_m_));
  Eigen::Matrix<double, 2, 6> jacobian;  // pose, landmark, bias
  jacobian << -sideways.x(), -sideways.y(), -1.0, sideways.x(), sideways.y(), 0.0,  //
      -along.x(), -along.y(), 0.0, along.x(), along.y(), range * range;
  // Cauchy's weight: some sightings are of something else.
  const double robust = 1.0 / (1.0 + residual.cwiseQuotient(sigma).squaredNorm() / 4.0);
  const Eigen::Matrix<double, 6, 2> weighted =
      jacobian.transpose() * (robust * sigma.cwiseInverse().cwiseAbs2()).asDiagonal();
  const Eigen::Matrix<double, 6, 6> matrix = weighted * jacobian;
  const Eigen::Matrix<double, 6, 1> right = -weighted * residual;
  addBlock(landmark_at, landmark_at, matrix.block<2, 2>(3, 3));
  addBlock(bias_at_, landmark_at, matrix.block<1, 2>(5, 3));
  addBlock(bias_at_, bias_at_, matrix.block<1, 1>(5, 5));
  right_.segment<2>(landmark_at) += right.segment<2>(3);
  right_[bias_at_] += right[5];
  if (pose < 0) return;
  addBlock(pose * kPoseSize, pose * kPoseSize, matrix.topLeftCorner<3, 3>());
  addBlock(landmark_at, pose * kPoseSize, matrix.block<2, 3>(3, 0));
  addBlock(bias_at_, pose * kPoseSize, matrix.block<1, 3>(5, 0));
  right_.segment<3>(pose * kPoseSize) += right.head<3>();
}

double Smoother::iterate(const SmoothingGraph& graph, double slack_m, const std::stop_token& stop) {
  const std::span<Frame* const> frames = graph.frames;
  const std::span<FoundBox> boxes = graph.boxes;
  const std::size_t fixed = graph.fixed;
  std::vector<Vec2>& landmarks = graph.landmarks;
  DrawingPrior* const drawing = graph.drawing;
  poses_ = static_cast<int>(frames.size() - fixed);
  int size = poses_ * kPoseSize + static_cast<int>(boxes.size()) * kBoxSize;
  std::vector<int> sightings(landmarks.size());
  for (const Frame* frame : frames) {
    for (const Sighting& s : frame->sightings) ++sightings[static_cast<std::size_t>(s.landmark)];
  }
  std::vector<int> landmark_at(landmarks.size(), -1);
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    if (sightings[i] < kLeastSightings) continue;
    landmark_at[i] = size;
    size += 2;
  }
  bias_at_ = size++;
  scale_at_ = size++;
  motion_at_ = size;
  if (drawing) size += 4;
  triplets_.clear();
  right_ = Eigen::VectorXd::Zero(size);
  const auto index_of = [&](std::size_t frame) {
    return frame < fixed ? -1 : static_cast<int>(frame - fixed);
  };
  const auto at_box = [&](std::size_t b) {
    return poses_ * kPoseSize + static_cast<int>(b) * kBoxSize;
  };
  for (std::size_t i = std::max<std::size_t>(fixed, 1); i < frames.size(); ++i) {
    addOdometry(*frames[i - 1], *frames[i], index_of(i - 1), index_of(i));
  }
  std::vector<const Building*> drawn(boxes.size());
  if (drawing) {
    for (const DrawingPrior::Anchor& anchor : drawing->anchors) drawn[anchor.box] = anchor.drawn;
  }
  std::vector<int> observations(boxes.size());
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    if (stop.stop_requested()) return 0.0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      if (frames[i]->number < boxes[b].first_frame || frames[i]->number > boxes[b].last_frame) {
        continue;
      }
      Normal normal;
      if (!addReturns(*frames[i], boxes[b], slack_m, normal)) continue;
      addSilhouette(*frames[i], boxes[b], normal);
      scatter(normal, index_of(i), static_cast<int>(b));
      ++observations[b];
    }
    if (drawn[b]) {
      const double own = drawn[b]->box().heading + drawing->turn;
      addHeadingPrior(boxes[b].box, {&own, 1}, at_box(b));
    } else {
      addHeadingPrior(boxes[b].box, headings_, at_box(b));
    }
    addReachPrior(at_box(b));
    if (boxes[b].predates(frames)) addKnownWalls(boxes[b], at_box(b));
  }
  for (const auto& [old, again] : graph.same) {
    addSame(boxes[old], boxes[again], at_box(old), at_box(again));
  }
  if (drawing) addDrawing(*drawing, boxes);
  addCalibrationPrior(frames);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    for (const Sighting& sighting : frames[i]->sightings) {
      const auto id = static_cast<std::size_t>(sighting.landmark);
      if (landmark_at[id] < 0) continue;
      addSighting(*frames[i], sighting, landmarks[id], index_of(i), landmark_at[id]);
    }
  }
  if (stop.stop_requested()) return 0.0;
  for (std::size_t b = 0; b < boxes.size(); ++b) boxes[b].observations = observations[b];
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(triplets_.begin(), triplets_.end());
  solver_.compute(matrix);
  const Eigen::VectorXd step = solver_.solve(right_);
  if (!step.allFinite()) return 0.0;
  double moved = 0.0;
  for (int i = 0; i < poses_; ++i) {
    Pose2& pose = frames[fixed + static_cast<std::size_t>(i)]->pose;
    moved = std::max(moved, step.segment<2>(i * kPoseSize).norm());
    pose.x += step[i * kPoseSize];
    pose.y += step[i * kPoseSize + 1];
    pose.heading = normalizedAngle(pose.heading + step[i * kPoseSize + 2]);
  }
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    move(boxes[b].box, step.segment<kBoxSize>(at_box(b)));
  }
  bias_per_m_ += step[bias_at_];
  scale_ += step[scale_at_];
  if (drawing) drawing->motion.mean += step.segment<4>(motion_at_);
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    if (landmark_at[i] >= 0) landmarks[i] += step.segment<2>(landmark_at[i]);
  }
  return moved;
}

Eigen::Matrix3d Smoother::covariances(std::span<FoundBox> boxes) {
  const auto column_of = [&](int index) -> Eigen::VectorXd {
    return solver_.solve(Eigen::VectorXd::Unit(right_.size(), index));
  };
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    const int at = poses_ * kPoseSize + static_cast<int>(b) * kBoxSize;
    for (int k = 0; k < 4; ++k) boxes[b].covariance.col(k) = column_of(at + k).segment<4>(at);
    boxes[b].heading_sigma = std::sqrt(std::max(column_of(at + 4)[at + 4], 0.0));
  }
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  const int last = (poses_ - 1) * kPoseSize;
  for (int k = 0; poses_ > 0 && k < kPoseSize; ++k) {
    covariance.col(k) = column_of(last + k).segment<3>(last);
  }
  return covariance;
}

}  // namespace handmap
