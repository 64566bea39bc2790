#include "widgets/run/words/phase_words.h"

#include <cmath>

namespace handmap {

namespace {

QString centimetres(double value) { return QString::number(value, 'f', 2); }

}  // namespace

QString PhaseWords::name(const Phase& phase) {
  switch (phase.kind) {
    case PhaseKind::Prediction:
      return tr("Prediction");
    case PhaseKind::LocalMap:
      return tr("Local map");
    case PhaseKind::Swarms:
      return tr("Swarms %1/%2").arg(phase.facts.iteration).arg(phase.facts.iterations);
    case PhaseKind::Weights:
      return tr("Weights");
    case PhaseKind::Resampling:
      return tr("Resampling");
    case PhaseKind::Way:
      return tr("Way");
    case PhaseKind::Poses:
      return tr("Poses");
    case PhaseKind::Evidence:
      return tr("Signs of walls");
    case PhaseKind::Detection:
      return tr("Buildings found");
    case PhaseKind::Labels:
      return tr("Matching");
    case PhaseKind::Correction:
      break;
  }
  return tr("Correction");
}

QString PhaseWords::change(const Phase& phase) {
  const PhaseFacts& facts = phase.facts;
  const QString moved = centimetres(facts.moved_m);
  const QString turned = QString::number(toDegrees(facts.turned), 'f', 1);
  switch (phase.kind) {
    case PhaseKind::Prediction:
      return tr("The particles go on by the odometry and its noise; the best one moved by %1 m and "
                "turned by %2°.")
          .arg(moved, turned);
    case PhaseKind::LocalMap:
      return tr("The walls seen over the last metres, laid at the best particle.");
    case PhaseKind::Swarms:
      if (facts.iteration == 0) {
        return tr("Samples of %n building(s) in sight, before they move; score %1.", nullptr,
                  facts.count)
            .arg(facts.value, 0, 'f', 1);
      }
      return tr("The best outlines moved by up to %1 m; score %2.")
          .arg(moved)
          .arg(facts.value, 0, 'f', 1);
    case PhaseKind::Weights:
      return tr("Each particle weighs as what it sees fits its map: as good as %1 of %2 particles.")
          .arg(facts.value, 0, 'f', 1)
          .arg(facts.of);
    case PhaseKind::Resampling:
      if (!facts.happened) return tr("Not due: enough particles count. All %1 stay.").arg(facts.of);
      return tr("%1 of %2 particles stay, the heavy ones more than once.")
          .arg(facts.count)
          .arg(facts.of);
    case PhaseKind::Way:
      return tr("The robot drove %1 m and turned %2°, by odometry or matched scans.")
          .arg(moved, turned);
    case PhaseKind::Poses:
      return tr("The last poses and buildings fitted together: the robot moved by %1 m and turned "
                "by %2°.")
          .arg(moved, turned);
    case PhaseKind::Evidence:
      return tr("Where walls are likely by the last frames: the stronger, the likelier.");
    case PhaseKind::Detection:
      return tr("%1 walls and %2 buildings in sight, found without the drawing.")
          .arg(facts.of)
          .arg(facts.count);
    case PhaseKind::Labels:
      return tr("%1 of %2 found buildings are matched with drawn ones (dotted lines).")
          .arg(facts.count)
          .arg(facts.of);
    case PhaseKind::Correction:
      break;
  }
  const QString map =
      facts.count == 0
          ? tr("No building of the map moved.")
          : tr("%n building(s) of the map moved by up to %1 m.", nullptr, facts.count).arg(moved);
  return facts.happened ? tr("A loop was closed. %1").arg(map) : map;
}

}  // namespace handmap
