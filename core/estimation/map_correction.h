// The drawing, corrected by what was found.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/shared_list.h"
#include "core/estimation/drawing/predicted_motion.h"
#include "core/estimation/drawing/refined_building.h"
#include "core/estimation/labels/labels.h"

namespace handmap {

/// Kept from observation to observation: with each, what is near the robot is corrected, and a few
/// of the others.
class MapCorrection {
 public:
  /// Tells whether the robot was within sight of a place, and nearer to it than it is now.
  using HasPassed = std::function<bool(const Rectangle&)>;

  /// Keeps references to the drawing and to its labels.
  MapCorrection(const Map& drawing, const Labels& labels)
      : drawing_(drawing),
        labels_(labels),
        corrected_(drawing.buildings),
        predicted_(drawing.buildings),
        displaced_(drawing.buildings.size()) {
    auto rest = std::make_shared<Map>(drawing);
    rest->buildings.clear();
    rest_ = std::move(rest);
  }

  /// `found`: of the last update of the labels.
  void correctAll(std::span<const FoundBox> found, const HasPassed& has_passed);
  void correctSome(std::span<const FoundBox> found, const HasPassed& has_passed);
  /// A building that is probably another one, or not there, has a member "doubtful".
  std::function<Map()> mapLater() const;
  /// Each as if it had not been found itself.
  std::function<Map()> predictedLater() const;
  const Building& corrected(std::size_t building) const { return corrected_[building]; }

 private:
  void compare(std::size_t building, std::span<const FoundBox> found);
  void predict();
  /// How the drawing lies at a building, by the others that were found.
  DrawingMotion motionBeside(std::size_t building) const;
  void correct(std::size_t building, std::span<const FoundBox> found, const HasPassed& has_passed);
  Building stated(std::size_t building, const RefinedBuilding& refined,
                  const FoundBox* found) const;
  std::function<Map()> later(const SharedList<Building>& buildings) const;
  void share();

  const Map& drawing_;
  const Labels& labels_;
  std::shared_ptr<const Map> rest_;  ///< the drawing without its buildings
  SharedListWriter<Building> corrected_;
  SharedList<Building> buildings_;  ///< the same, to be shown
  SharedListWriter<Building> predicted_;
  SharedList<Building> predicted_buildings_;
  std::vector<std::optional<Displaced>> displaced_;  ///< by building; of those that were found
  std::vector<Displaced> found_;                     ///< those that were
  double share_ = 0.0;                               ///< of the whole's motion; predictiveShare()
  std::size_t last_ = 0;                             ///< of the far buildings
};

}  // namespace handmap
