#include "widgets/run/words/words.h"

#include <QStringList>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/map/certainty.h"
#include "core/session/pose_trust.h"

namespace handmap {

namespace {

constexpr double kNearby_m = 50.0;
constexpr qsizetype kMostNamed = 4;
constexpr double kSurprising = 2.0;  // σ of the drawing

/// Two figures at most: nobody believes more.
QString metres(double value) { return QString::number(value, 'f', value < 9.95 ? 1 : 0); }

QString range(double least, double most) {
  const QString from = metres(least);
  const QString to = metres(most);
  return from == to ? Words::tr("%1 m").arg(to) : Words::tr("%1 to %2 m").arg(from, to);
}

}  // namespace

QString Words::nameOf(const Building& building) {
  QString id = QString::fromStdString(building.id);
  if (building.name.empty() || building.name == building.id) return id;
  return id + QStringLiteral(" · ") + QString::fromStdString(building.name);
}

QString Words::direction(double heading_rad) {
  const std::array<QString, 8> words = {tr("right"),      tr("upper right"), tr("upper"),
                                        tr("upper left"), tr("left"),        tr("lower left"),
                                        tr("lower"),      tr("lower right")};
  const long eighth = std::lround(normalizedAngle(heading_rad) / (kPi / 4.0));
  return words[static_cast<std::size_t>((eighth + 8) % 8)];
}

QString Words::certainty(const FrameReport& report) {
  const auto [kind, within_m, heading_rad] = certaintyOf(report);
  const auto degrees = static_cast<int>(std::ceil(toDegrees(heading_rad)));
  switch (kind) {
    case Certainty::Sure:
      return tr("Sure to %1 m; heading to %2°").arg(metres(within_m)).arg(degrees);
    case Certainty::Rough:
      return tr("Roughly here: within %1 m; heading to %2°").arg(metres(within_m)).arg(degrees);
    case Certainty::Lost:
      break;
  }
  return tr("Lost: may be anywhere within %1 m").arg(metres(within_m));
}

QString Words::place(const Pose2& pose, const Map& map) {
  const Building* nearest = nullptr;
  double least = kNearby_m;
  for (const Building& building : map.buildings) {
    const double distance = distanceTo(building.footprint(), pose.position());
    if (distance >= least) continue;
    least = distance;
    nearest = &building;
  }
  if (nearest == nullptr) return tr("at %1, %2 m").arg(pose.x, 0, 'f', 0).arg(pose.y, 0, 'f', 0);
  return tr("%1 m from %2").arg(metres(least), nameOf(*nearest));
}

QString Words::changes(const MapChanges& changes, const Map& drawing) {
  QStringList parts;
  if (!changes.moved.empty()) {
    parts << tr("%n building(s) moved by %1", nullptr, static_cast<int>(changes.moved.size()))
                 .arg(range(changes.moved.back().moved_m(), changes.moved.front().moved_m()));
  }
  if (!changes.kept.empty()) {
    parts << tr("%n stand(s) as drawn", nullptr, static_cast<int>(changes.kept.size()));
  }
  if (!changes.unseen.empty()) {
    parts << tr("%n was (were) not seen", nullptr, static_cast<int>(changes.unseen.size()));
  }
  QString text = parts.join(tr(", ")) + tr(".");
  if (changes.doubtful.empty()) return text;
  QStringList names;
  for (const BuildingChange& change : changes.doubtful) {
    if (names.size() == kMostNamed) {
      names << QStringLiteral("…");
      break;
    }
    names << QString::fromStdString(drawing.buildings[change.building].id);
  }
  return text + QLatin1Char(' ') +
         tr("%n is (are) doubtful: look at %1.", nullptr, static_cast<int>(changes.doubtful.size()))
             .arg(names.join(tr(", ")));
}

QString Words::building(const Building& drawn, const Uncertainty& uncertainty, const Building& now,
                        const TrueMiddles* truth) {
  QStringList lines = {nameOf(drawn)};
  const double moved = (centroid(now.footprint()) - centroid(drawn.footprint())).norm();
  lines << tr("Moved by %1 m from where it was drawn").arg(metres(moved));
  if (const auto error = truth ? truth->errorOf(now) : std::nullopt) {
    lines << tr("%1 m from where it truly is").arg(metres(*error));
  }
  if (!now.estimate) return lines.join(QLatin1Char('\n'));
  if (now.estimate->observations == 0) {
    lines << tr("Nothing that was seen is taken for it: it is shown where the drawing has it");
  } else {
    lines << tr("For: seen in %n observation(s)", nullptr, now.estimate->observations);
  }
  const std::array<SideEstimate, 4> sides = sidesOf(now);
  const double heading = now.box().heading;
  QStringList seen;
  QStringList unseen;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const QString where = direction(heading + static_cast<double>(k) * kPi / 2.0);
    if (sides[k].seen) {
      seen << tr("%1 ±%2 m").arg(where).arg(sides[k].sigma, 0, 'f', 2);
    } else {
      unseen << where;
    }
  }
  if (!seen.isEmpty()) lines << tr("For: walls seen: %1").arg(seen.join(tr(", ")));
  if (!unseen.isEmpty()) {
    lines << tr("Against: walls that nobody saw: %1").arg(unseen.join(tr(", ")));
  }
  if (moved > kSurprising * uncertainty.position && uncertainty.position > 0.0) {
    lines << tr("Against: it moved %1 times as far as the drawing says that it may be off (%2 m)")
                 .arg(moved / uncertainty.position, 0, 'f', 1)
                 .arg(metres(uncertainty.position));
  }
  if (const double doubt = doubtOf(now); doubt > 0.0) {
    lines << tr("Doubtful: %1 % that it is another building, or is not there")
                 .arg(static_cast<int>(std::lround(100.0 * doubt)));
  }
  return lines.join(QLatin1Char('\n'));
}

}  // namespace handmap
