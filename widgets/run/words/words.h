// What a run has found, in plain words. Metres and degrees.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <optional>
#include <span>

#include "core/map/concerns.h"
#include "core/map/map_changes.h"
#include "core/method/pose_trust.h"
#include "core/method/snapshot.h"

namespace handmap {

class Words {
  Q_DECLARE_TR_FUNCTIONS(handmap::Words)
 public:
  /// "L3", or "L3 · Library" where it has a name.
  static QString nameOf(const Building& building);
  /// "upper right": a direction on the map, for people who look at it with y up.
  static QString direction(double heading_rad);
  /// "Sure to 0.3 m; heading to 1°", or "Lost: may be anywhere within 8 m".
  static QString certainty(const FrameReport& report);
  /// "4 m from L3", of the nearest building within 50 m; else coordinates.
  static QString place(const Pose2& pose, const Map& map);
  /// "12 buildings moved by 0.3 to 4.1 m, 1 turned by 20°, 2 stand as drawn, 5 were not recognised.
  /// Of 3 only one side was seen: how deep they are is as drawn. 3 are doubtful: look at L3, L4,
  /// N1."
  static QString changes(const MapChanges& changes, const Map& drawing);
  /// What speaks for a corrected building and what against; lines. `refined`: of a run on
  /// `drawing`.
  static QString building(const Map& drawing, const Map& refined, std::size_t building,
                          const TrueMiddles* truth);
  /// "moved by 1.1 m, turned by 20°, grown by 9.0 m"; empty: none of these.
  static QString change(const BuildingChange& change);
  /// Why it is doubtful, and how often such buildings prove to be wrong; empty: it is not.
  /// `concerns`: of both maps.
  static QString doubt(const Map& drawing, const Map& refined, std::size_t building,
                       std::span<const Concern> concerns);
  /// "L3 stands in L4"
  static QString concern(const Concern& concern, const Map& drawing);
};

}  // namespace handmap
