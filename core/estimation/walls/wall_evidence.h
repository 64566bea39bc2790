// Evidence for walls kept over frames: one image for each direction that a wall may face.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/estimation/walls/frame.h"

namespace handmap {

/// A frame that is worked on, and how the evidence holds it: from this pose, weighed by this model.
struct ActiveFrame {
  Frame* frame;
  Pose2 held_at;
  std::shared_ptr<const SensorModel> held_by;
};

/// Evidence for walls along `heading`, seen from below: walls whose outward normal is
/// −perpendicular(unitVector(heading)). A cell holds the summed log ratio of the rays that cross
/// the row of the cell there, so that the evidence for a wall is the sum of its cells. The plane is
/// wrapped around a square: a window that moves with the robot. Numbers are fixed-point, so that a
/// frame taken out leaves no trace.
class WallImage {
 public:
  /// The window is at least `window_m` wide.
  WallImage(double heading_rad, double cell_m, double window_m);

  double heading() const { return heading_; }
  double cell() const { return cell_; }
  int size() const { return size_; }  ///< cells a side, a power of two
  const Vec2& along() const { return along_; }
  const Vec2& across() const { return across_; }
  /// The cells of one column, by wrapped row.
  const std::int32_t* column(int index) const {
    return cells_.data() + static_cast<std::ptrdiff_t>(index & (size_ - 1)) * size_;
  }
  /// So many cells of one column, from `row` on, one behind the other: copied to `wrapped` where
  /// the plane is wrapped around in between.
  const std::int32_t* cells(int column_index, int row, std::span<std::int32_t> wrapped) const {
    const std::int32_t* const first = column(column_index);
    const int begin = row & (size_ - 1);
    const auto until_end = static_cast<std::size_t>(size_ - begin);
    if (wrapped.size() <= until_end) return first + begin;
    std::copy_n(first + begin, until_end, wrapped.begin());
    std::copy_n(first, wrapped.size() - until_end, wrapped.begin() + (size_ - begin));
    return wrapped.data();
  }
  double at(int column_index, int row) const {
    return column(column_index)[row & (size_ - 1)] / walls::kScale;
  }

  /// Adds (sign 1) or takes out (sign −1) what the rays of a frame say from where it is held.
  void apply(const ActiveFrame& held, int sign);
  /// Takes all out.
  void clear();

 private:
  double heading_;
  double cell_;
  int size_;
  Vec2 along_;
  Vec2 across_;
  std::vector<std::int32_t> cells_;
};

/// The images of the four sides of every direction, over the last frames.
class WallEvidence {
 public:
  WallEvidence(double cell_m, double window_m) : cell_(cell_m), window_(window_m) {}

  /// Looks for walls of one more direction (modulo π/2); `held`: the frames that it holds.
  void include(double heading, std::span<const ActiveFrame> held);
  void exclude(double heading);
  void add(const ActiveFrame& held) { change({}, {&held, 1}); }
  void remove(const ActiveFrame& held) { change({&held, 1}, {}); }
  /// Takes some out and puts others in: one image after the other, for they are large.
  void change(std::span<const ActiveFrame> out, std::span<const ActiveFrame> in);
  /// Takes all out and puts `held` in: half the work of taking out one by one.
  void putAnew(std::span<const ActiveFrame> held);
  const std::vector<WallImage>& images() const { return images_; }

 private:
  double cell_;
  double window_;
  std::vector<WallImage> images_;
};

}  // namespace handmap
