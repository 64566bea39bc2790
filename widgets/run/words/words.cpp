#include "widgets/run/words/words.h"

#include <QStringList>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/map/certainty.h"
#include "core/method/constants.h"
#include "core/method/pose_trust.h"
#include "core/method/recognition.h"

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

QString degrees(double turn_rad) {
  return QString::number(std::lround(std::abs(toDegrees(turn_rad)))) + QChar(0xB0);
}

/// "L3, L4, N1, …"
QString namesOf(const std::vector<BuildingChange>& changes, const Map& drawing) {
  QStringList names;
  for (const BuildingChange& change : changes) {
    if (names.size() == kMostNamed) {
      names << QStringLiteral("…");
      break;
    }
    names << QString::fromStdString(drawing.buildings[change.building].id);
  }
  return names.join(Words::tr(", "));
}

/// Which sides were seen, and how sure they are; which were not.
QStringList sidesInWords(const Building& now) {
  const Sides sides = sidesOf(now);
  const double heading = now.box().heading;
  QStringList seen;
  QStringList unseen;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const QString where = Words::direction(heading + static_cast<double>(k) * kPi / 2.0);
    if (sides[k].seen) {
      seen << Words::tr("%1 ±%2 m").arg(where).arg(sides[k].sigma, 0, 'f', 2);
    } else {
      unseen << where;
    }
  }
  QStringList lines;
  if (!seen.isEmpty()) lines << Words::tr("For: walls seen: %1").arg(seen.join(Words::tr(", ")));
  if (!unseen.isEmpty()) {
    lines << Words::tr("Against: walls that nobody saw: %1").arg(unseen.join(Words::tr(", ")));
  }
  return lines;
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
  const auto heading_deg = static_cast<int>(std::ceil(toDegrees(heading_rad)));
  const QString unrecognised = metres(report.unrecognised_m);
  const bool is_unrecognised = report.unrecognised_m >= method::kUnrecognised_m;
  if (is_unrecognised && kind != Certainty::Lost) {
    return tr("Unsure: nothing of the drawing recognised for %1 m; if it was right before, within "
              "%2 m")
        .arg(unrecognised, metres(within_m));
  }
  QString words;
  switch (kind) {
    case Certainty::Sure:
      words = tr("Sure to %1 m; heading to %2°").arg(metres(within_m)).arg(heading_deg);
      break;
    case Certainty::Rough:
      words =
          tr("Roughly here: within %1 m; heading to %2°").arg(metres(within_m)).arg(heading_deg);
      break;
    case Certainty::Lost:
      words = tr("Lost: may be anywhere within %1 m").arg(metres(within_m));
      break;
  }
  if (!is_unrecognised) return words;
  return words + tr("; nothing of the drawing recognised for %1 m").arg(unrecognised);
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
  if (nearest == nullptr)
    return tr("at x %1 m, y %2 m").arg(pose.x, 0, 'f', 0).arg(pose.y, 0, 'f', 0);
  return tr("%1 m from %2").arg(metres(least), nameOf(*nearest));
}

QString Words::changes(const MapChanges& changes, const Map& drawing) {
  QStringList parts;
  if (!changes.moved.empty()) {
    parts << tr("%n building(s) moved by %1", nullptr, static_cast<int>(changes.moved.size()))
                 .arg(range(changes.moved.back().moved_m(), changes.moved.front().moved_m()));
  }
  if (!changes.turned.empty()) {
    parts << tr("%n turned by up to %1", nullptr, static_cast<int>(changes.turned.size()))
                 .arg(degrees(changes.turned.front().turned));
  }
  if (!changes.resized.empty()) {
    parts << tr("%n grown or shrunk by up to %1 m", nullptr,
                static_cast<int>(changes.resized.size()))
                 .arg(metres(std::abs(changes.resized.front().grown_m())));
  }
  if (!changes.kept.empty()) {
    parts << tr("%n stand(s) as drawn", nullptr, static_cast<int>(changes.kept.size()));
  }
  if (!changes.unseen.empty()) {
    parts << tr("%n was (were) not recognised", nullptr, static_cast<int>(changes.unseen.size()));
  }
  QString text = parts.join(tr(", ")) + tr(".");
  if (!changes.one_sided.empty()) {
    text +=
        QLatin1Char(' ') + tr("Of %n (%1) only one side was seen: how deep that is, is as drawn.",
                              nullptr, static_cast<int>(changes.one_sided.size()))
                               .arg(namesOf(changes.one_sided, drawing));
  }
  if (changes.doubtful.empty()) return text;
  return text + QLatin1Char(' ') +
         tr("%n is (are) doubtful: look at %1.", nullptr, static_cast<int>(changes.doubtful.size()))
             .arg(namesOf(changes.doubtful, drawing));
}

QString Words::change(const BuildingChange& change) {
  QStringList parts;
  if (change.moved_m() >= kLeastMove_m) parts << tr("moved by %1 m").arg(metres(change.moved_m()));
  if (change.isTurned()) parts << tr("turned by %1").arg(degrees(change.turned));
  if (change.isResized()) {
    const double grown = change.grown_m();
    parts
        << (grown > 0.0 ? tr("grown by %1 m") : tr("shrunk by %1 m")).arg(metres(std::abs(grown)));
  }
  return parts.join(tr(", "));
}

QString Words::concern(const Concern& concern, const Map& drawing) {
  const QString name = nameOf(drawing.buildings[concern.building]);
  switch (concern.kind) {
    case Concern::Kind::Overlaps:
      return tr("%1 stands in %2: they overlap by %3 % more than drawn")
          .arg(name, nameOf(drawing.buildings[concern.other]))
          .arg(std::lround(100.0 * concern.by));
    case Concern::Kind::Moved:
      return tr("%1 moved by %2 m: something else may have been taken for it")
          .arg(name, metres(concern.by));
    case Concern::Kind::Resized:
      break;
  }
  return (concern.by > 0.0 ? tr("%1 grew by %2 m: something else may have been taken for it")
                           : tr("%1 shrank by %2 m: something else may have been taken for it"))
      .arg(name, metres(std::abs(concern.by)));
}

QString Words::doubt(const Map& drawing, const Map& refined, std::size_t building,
                     std::span<const Concern> concerns) {
  const double doubt = doubtOf(refined.buildings[building]);
  if (doubt <= 0.0) return {};
  QStringList reasons;
  if (!isRecognised(refined.buildings[building])) {
    reasons << tr("the robot came by and did not recognise it");
  } else {
    for (const Concern& concern : concernsAbout(building, concerns)) {
      reasons << Words::concern(concern, drawing);
    }
    if (reasons.isEmpty()) reasons << tr("what was seen may as well be another building");
  }
  return tr("Doubtful: %1. Of 100 buildings with such signs about %2 were wrong.")
      .arg(reasons.join(tr("; ")))
      .arg(std::lround(100.0 * doubt));
}

QString Words::building(const Map& drawing, const Map& refined, std::size_t b,
                        const TrueMiddles* truth) {
  const Building& drawn = drawing.buildings[b];
  const Building& now = refined.buildings[b];
  QStringList lines = {nameOf(drawn)};
  const bool recognised = isRecognised(now);
  const BuildingChange changed = changeOf(drawn, now);
  const QString words = change(changed);
  if (now.estimate && !recognised) {
    lines << (words.isEmpty() ? tr("Not recognised: it is shown where the drawing has it")
                              : tr("Not recognised: it is shown where the drawing has it, %1 "
                                   "together with the buildings beside it")
                                    .arg(words));
  } else {
    lines << (words.isEmpty() ? tr("As drawn") : tr("Against the drawing: %1").arg(words));
  }
  if (const auto error = truth ? truth->errorOf(now) : std::nullopt) {
    lines << tr("%1 m from where it truly is").arg(metres(*error));
  }
  if (!now.estimate) return lines.join(QLatin1Char('\n'));
  if (recognised) {
    lines << tr("For: seen in %n observation(s)", nullptr, now.estimate->observations);
    lines << sidesInWords(now);
    if (changed.one_sided) lines << tr("Only one side was seen: how deep it is, is as drawn");
    const Uncertainty uncertainty = drawing.uncertaintyOf(drawn);
    if (changed.moved_m() > kSurprising * uncertainty.position) {
      lines << tr("Against: it moved %1 times as far as the drawing says that it may be off (%2 m)")
                   .arg(changed.moved_m() / uncertainty.position, 0, 'f', 1)
                   .arg(metres(uncertainty.position));
    }
  }
  if (doubtOf(now) > 0.0) lines << doubt(drawing, refined, b, concernsOf(drawing, refined));
  return lines.join(QLatin1Char('\n'));
}

}  // namespace handmap
