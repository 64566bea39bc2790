// A place of straight walls, a laser in it and wheels that slip: for the tests of ways from scans.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/random.h"
#include "core/recording/observation.h"
#include "core/simulation/ray_cast.h"

namespace handmap::test {

inline void addBox(std::vector<Segment>& walls, double x, double y, double width, double depth) {
  const std::vector<Vec2> c{{x, y}, {x + width, y}, {x + width, y + depth}, {x, y + depth}};
  for (std::size_t i = 0; i < 4; ++i) walls.push_back({c[i], c[(i + 1) % 4]});
}

/// A block with recesses of several widths inside a corridor, the outer wall with pillars.
inline std::vector<Segment> ringCorridor() {
  std::vector<Segment> walls;
  addBox(walls, 10, 10, 50, 30);
  addBox(walls, 0, 0, 70, 50);
  addBox(walls, 13, 7.5, 4, 2.5);
  addBox(walls, 29, 8.5, 7, 1.5);
  addBox(walls, 60, 17, 2, 5);
  addBox(walls, 60, 30, 1.5, 3);
  addBox(walls, 44, 40, 5, 2);
  addBox(walls, 20, 40, 9, 1.5);
  addBox(walls, 8, 14, 2, 3);
  addBox(walls, 8.5, 27, 1.5, 6);
  return walls;
}

inline double rangeTo(const std::vector<Segment>& walls, const Vec2& from, double bearing) {
  double nearest = kNoHit;
  for (const Segment& wall : walls) {
    nearest = std::min(nearest, rayToSegment(from, unitVector(bearing), wall));
  }
  return nearest;
}

/// A laser of 360 rays all around.
inline std::vector<RangePoint> scanFrom(const std::vector<Segment>& walls, const Pose2& pose,
                                        double sigma_m, RandomStream& random) {
  std::vector<RangePoint> points;
  for (int i = 0; i < 360; ++i) {
    const double bearing = toRadians(i);
    const double range =
        rangeTo(walls, pose.position(), pose.heading + bearing) + random.normal(0.0, sigma_m);
    if (!(range < 40.0)) continue;
    const Vec2 at = range * unitVector(bearing);
    points.push_back({static_cast<float>(at.x()), static_cast<float>(at.y()), 0.5F, 1.0F});
  }
  return points;
}

/// Around the block of ringCorridor(), `rounds` times, corners cut round.
inline std::vector<Pose2> aroundTheBlock(double rounds) {
  const double length = 2 * (55 + 35) + 2 * kPi * 2.5 - 4 * 5;
  std::vector<Pose2> trajectory;
  Pose2 pose{30, 5, 0};
  double left[] = {27.5, 0, 35, 0, 55, 0, 35, 0, 27.5};  // straight pieces, then to the start
  const double step = 0.5;
  for (double done = 0.0; done < rounds * length;) {
    for (std::size_t i = 0; i < 9 && done < rounds * length; ++i) {
      const bool bend = i % 2 == 1;
      const double piece = bend ? 0.5 * kPi * 2.5 : left[i] - (i == 0 || i == 8 ? 2.5 : 5.0);
      const int steps = static_cast<int>(std::lround(piece / step));
      for (int k = 0; k < steps; ++k) {
        trajectory.push_back(pose);
        pose = pose * Pose2{piece / steps, 0.0, bend ? 0.5 * kPi / steps : 0.0};
        done += piece / steps;
      }
    }
  }
  return trajectory;
}

/// Odometry of wheels that count 2 % too much and turn with a bias and noise.
inline std::vector<Pose2> slipping(const std::vector<Pose2>& trajectory, RandomStream& random) {
  std::vector<Pose2> odometry{trajectory.front()};
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    Pose2 motion = between(trajectory[i - 1], trajectory[i]);
    motion.x *= 1.02;
    motion.heading += 0.0005 + random.normal(0.0, 0.003);
    odometry.push_back(odometry.back() * motion);
  }
  return odometry;
}

inline double rms(const std::vector<Pose2>& poses, const std::vector<Pose2>& truth) {
  double sum = 0.0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    sum += (poses[i].position() - truth[i].position()).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(poses.size()));
}

}  // namespace handmap::test
