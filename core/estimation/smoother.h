// Least squares over poses and found buildings.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include <Eigen/SparseCholesky>

#include "core/estimation/drawn_box.h"
#include "core/estimation/loop_closure.h"

namespace handmap {

/// Noise of one odometry step, one σ.
struct OdometryNoise {
  double length_per_m = 0.03;
  double side_per_m = 0.01;
  double heading_variance_per_m = 2e-5;  ///< radians²
  double heading_per_rad = 0.02;
  double least_length_m = 0.01;
  double least_heading = 0.001;
  double scale = 0.003;  ///< of all lengths; Cauchy's, for some wheels are worn
};

/// What a drawing says of the found boxes that are labelled: where their walls are, but for how it
/// lies as a whole, and how they stand.
struct DrawingPrior {
  struct Anchor {
    std::size_t box;
    const Building* drawn;
    Uncertainty uncertainty;
  };
  std::vector<Anchor> anchors;
  DrawingMotion expected;  ///< before anything was found
  DrawingMotion motion;
  double turn = 0.0;  ///< of the drawing, where it is not as drawn
};

/// What is smoothed together.
struct SmoothingGraph {
  std::span<Frame* const> frames;  ///< in order of time; consecutive ones are bound by odometry
  std::size_t fixed = 1;           ///< poses before this one stay
  std::span<FoundBox> boxes;
  std::vector<Vec2>& landmarks;
  std::span<const SameBuilding> same = {};  ///< of the boxes
  DrawingPrior* drawing = nullptr;          ///< its motion follows
};

/// Gauss-Newton with weights that follow the sensor model. What a frame says of a wall is each
/// return's distance from it; what it says of the end of a building is the bearing at which the
/// returns of the building stop.
class Smoother {
 public:
  Smoother(const OdometryNoise& odometry, const SensorModel& sensor)
      : odometry_(odometry), sensor_(sensor) {}

  /// How far, across a wall, what one frame says of it is off as a whole, one σ: walls are not
  /// quite straight and poses of moving robots not quite those of the scan. Its ends are off by
  /// more.
  void setSystematic(double sigma_m) { systematic_m_ = sigma_m; }
  /// Variance of the odometry's heading after a metre, radians².
  void setHeadingVariance(double per_m) { odometry_.heading_variance_per_m = per_m; }
  /// The main directions of the drawing (modulo π/2), and how far a building may be turned against
  /// the nearest, one σ.
  void expectHeadings(std::vector<double> headings, double sigma) {
    headings_ = std::move(headings);
    heading_sigma_ = sigma;
  }
  /// What the ranges are off systematically, see RangeNoise, is estimated with all the rest.
  double biasPerMetre() const { return bias_per_m_; }
  /// And so is what the lengths of the odometry are off: the motion as it was.
  Pose2 scaled(const Pose2& motion) const {
    return {(1.0 + scale_) * motion.x, (1.0 + scale_) * motion.y, motion.heading};
  }
  /// Moves the poses, the boxes and the landmarks that the frames saw. `slack_m` (across a wall,
  /// one σ) is what poses and boxes may be off before: wide to catch, narrow to settle.
  /// Returns how far the pose that moved most did, metres. Nothing moves when `stop` was requested.
  double iterate(const SmoothingGraph& graph, double slack_m, const std::stop_token& stop = {});
  /// Writes the σ of the boxes and returns the covariance of the last pose, after a whole
  /// iterate().
  Eigen::Matrix3d covariances(std::span<FoundBox> boxes);

 private:
  using Local = Eigen::Matrix<double, 9, 9>;  ///< of a pose (3), a box (5) and the bias
  using LocalVector = Eigen::Matrix<double, 9, 1>;
  struct Normal {
    Local matrix = Local::Zero();
    LocalVector right = LocalVector::Zero();
    void add(const LocalVector& jacobian, double residual, double weight);
  };

  bool addReturns(const Frame& frame, const FoundBox& found, double slack_m, Normal& normal) const;
  void addSilhouette(const Frame& frame, const FoundBox& found, Normal& normal) const;
  void scatter(const Normal& normal, int pose, int box);
  void addOdometry(const Frame& from, const Frame& to, int from_index, int to_index);
  void addSighting(const Frame& frame, const Sighting& sighting, const Vec2& landmark, int pose,
                   int landmark_at);
  void addReachPrior(int box_at);
  void addKnownWalls(const FoundBox& found, int box_at);
  void addHeadingPrior(const Box& box, std::span<const double> headings, int box_at);
  void addSame(const FoundBox& old, const FoundBox& again, int old_at, int again_at);
  void addDrawing(const DrawingPrior& drawing, std::span<const FoundBox> boxes);
  void addCalibrationPrior(std::span<Frame* const> frames);
  void addBlock(int row, int column, const Eigen::MatrixXd& block);

  OdometryNoise odometry_;
  double systematic_m_ = 0.03;
  double bias_per_m_ = 0.0;
  double scale_ = 0.0;  ///< of the odometry, less 1
  std::vector<double> headings_;
  double heading_sigma_ = 0.1;
  const SensorModel& sensor_;
  std::vector<Eigen::Triplet<double>> triplets_;
  Eigen::VectorXd right_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
  int poses_ = 0;  ///< free ones
  int bias_at_ = 0;
  int scale_at_ = 0;
  int motion_at_ = 0;
};

}  // namespace handmap
