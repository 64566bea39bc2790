// Which found building is which drawn one, over a whole run: near the robot anew with each
// observation, farther away for good until it comes back.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/estimation/drawing/drawing_prior.h"
#include "core/estimation/labels/assignment.h"
#include "core/estimation/labels/constants.h"

namespace handmap {

class Labels {
 public:
  /// Keeps a reference to the drawing.
  Labels(const Map& drawing, const AssignmentOptions& options);

  /// Takes the buildings that are out of sight and farther from the robot than `near_m` out of
  /// `found`, brings back those that no longer are, and labels what is in it. `trajectory`: the
  /// robot's last poses.
  void update(std::vector<FoundBox>& found, std::span<const Pose2> trajectory, double near_m);

  /// The buildings far away: the last `most` that have become so.
  std::vector<FoundBox> settled(std::size_t most) const;
  /// The same ones, put right.
  void setSettled(std::span<const FoundBox> boxes);
  /// Changes all of the buildings far away.
  template <typename Change>
  void changeSettled(Change change) {
    for (Settled& settled : settled_) change(settled.found);
  }
  std::size_t settledCount() const { return settled_.size(); }

  /// About the drawn buildings near the robot; the best first.
  const std::vector<Hypothesis>& hypotheses() const { return hypotheses_; }
  const DrawingMotion& motion() const { return hypotheses_.front().motion; }
  /// Before anything was found.
  const DrawingMotion& expectedMotion() const { return expected_; }
  /// How the drawing is turned, where that is free. Otherwise 0: a turn that is made up from the
  /// way must not make up the way.
  double freeTurn() const { return options_.free_turn ? motion().turn() : 0.0; }
  /// How far buildings are turned against the drawing, one σ, as far as they are known.
  double headingScatter(std::span<const FoundBox> found) const;
  /// Indices of the drawn buildings near the robot.
  const std::vector<std::size_t>& nearby() const { return nearby_; }

  bool isNearby(std::size_t building) const { return nearby_at_[building] != labels::kNowhere; }

  /// What a drawn building is, see refinedBuilding().
  struct Label {
    const FoundBox* found = nullptr;  ///< nullptr: none; of `found` of the last update()
    double doubt = 0.0;               ///< that it is another one, or is there after all
  };
  /// What the drawing says of the boxes of settled(most) and of `found` of the last update().
  DrawingPrior prior(std::size_t most, std::span<const FoundBox> found) const;
  /// Which drawn building one of `found` of the last update() is.
  std::optional<std::size_t> drawnOf(FoundId found) const;
  /// Which drawn buildings some boxes are, whatever else is taken for these, as far as that is
  /// sure; near `here` the way may have drifted by `shift_m`, one σ.
  std::vector<std::optional<std::size_t>> recognise(std::span<const FoundBox> boxes,
                                                    const Vec2& here, double shift_m) const;
  Label of(std::size_t building, std::span<const FoundBox> found) const;
  /// The same by any of the hypotheses, without the doubt.
  const FoundBox* foundFor(std::size_t building, const Hypothesis& hypothesis,
                           std::span<const FoundBox> found) const;

 private:
  struct Settled {
    FoundBox found;
    std::size_t drawn;  ///< labels::kNowhere: no one drew it
    double doubt;
  };

  void settleFarOnes(std::vector<FoundBox>& found, const Vec2& here, double near_m);
  void bringNearOnesBack(std::vector<FoundBox>& found, const Vec2& here, double near_m);
  void findNearby(const Vec2& here, double near_m);
  double doubtOf(std::size_t place) const;

  const Map& drawing_;
  AssignmentOptions options_;
  std::vector<Vec2> centres_;  ///< of the drawn buildings
  std::vector<Settled> settled_;
  std::vector<std::size_t> settled_at_;  ///< by drawn building: in settled_, or kNowhere
  std::vector<std::size_t> nearby_;
  std::vector<std::size_t> nearby_at_;  ///< by drawn building: in nearby_, or kNowhere
  std::vector<double> missed_;  ///< by drawn building: doubt when it was left behind unfound
  Map nearby_drawing_;
  DrawingMotion expected_;
  std::vector<Hypothesis> roots_;
  std::vector<Hypothesis> hypotheses_;
};

}  // namespace handmap
