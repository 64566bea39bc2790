#include "app/gui/run/run_score.h"

#include <QObject>
#include <QStringList>

namespace handmap {

namespace {

QString metres(double value) { return QString::number(value, 'f', 2); }

QString row(const QString& label, const QString& before, const QString& after) {
  return QStringLiteral("%1 %2 %3\n").arg(label, -28).arg(before, 10).arg(after, 10);
}

}  // namespace

RunScore scoreRun(const Map& drawing, const Map& refined, const std::optional<Map>& truth_map,
                  const Snapshot& last, const std::vector<StampedPose>& truth) {
  RunScore score;
  if (truth_map) {
    score.maps = {compareMaps(drawing, *truth_map, false).mean(),
                  compareMaps(refined, *truth_map, false).mean()};
  }
  if (!truth.empty()) {
    const Trajectory true_trajectory(truth, "truth");
    const auto odometry = compareTrajectories(last.odometry.all(), true_trajectory);
    const auto corrected = compareTrajectories(last.trajectory.all(), true_trajectory);
    if (odometry && corrected) score.trajectories = {*odometry, *corrected};
  }
  return score;
}

QString scoreInWords(const RunScore& score) {
  QStringList parts;
  if (score.maps) {
    const auto& [drawn, corrected] = *score.maps;
    parts << QObject::tr("buildings along x %1 → %2 m").arg(metres(drawn.x), metres(corrected.x))
          << QObject::tr("front walls %1 → %2 m").arg(metres(drawn.front), metres(corrected.front))
          << QObject::tr("widths %1 → %2 m").arg(metres(drawn.width), metres(corrected.width));
  }
  if (score.trajectories) {
    parts << QObject::tr("way of the robot %1 → %2 m")
                 .arg(metres(score.trajectories->odometry.rms_m),
                      metres(score.trajectories->corrected.rms_m));
  }
  return parts.isEmpty() ? QString()
                         : QObject::tr("Mean errors, before → after: %1").arg(parts.join(", "));
}

QString scoreTable(const RunScore& score) {
  QString table;
  if (score.maps) {
    const auto& [drawn, corrected] = *score.maps;
    table += row(QObject::tr("mean error of %n building(s)", nullptr, corrected.buildings),
                 QObject::tr("drawn"), QObject::tr("corrected"));
    table += row("  x (m)", metres(drawn.x), metres(corrected.x));
    table += row("  front wall (m)", metres(drawn.front), metres(corrected.front));
    table += row("  width (m)", metres(drawn.width), metres(corrected.width));
    table += row("  overlap with truth (IoU)", metres(drawn.iou), metres(corrected.iou));
  }
  if (score.trajectories) {
    const auto& [odometry, corrected] = *score.trajectories;
    table += row(QObject::tr("error of the robot's way"), QObject::tr("odometry"),
                 QObject::tr("corrected"));
    table += row("  rms (m)", metres(odometry.rms_m), metres(corrected.rms_m));
    table += row("  at the end (m)", metres(odometry.end_m), metres(corrected.end_m));
    table += row(QStringLiteral("  rms heading (°)"), metres(toDegrees(odometry.rms_heading)),
                 metres(toDegrees(corrected.rms_heading)));
  }
  return table;
}

}  // namespace handmap
