#include "app/gui/run/log_keeper.h"

#include <cmath>

#include "core/map/concerns.h"

namespace handmap {

LogKeeper::LogKeeper(RunController& run, LogModel& log, QObject* parent)
    : QObject(parent), run_(run), log_(log) {
  connect(&run, &RunController::sourceOpened, this,
          [this](const std::shared_ptr<const SourceInfo>& source) { begin(*source); });
  connect(&run, &RunController::newsArrived, this, [this](const RunNews& news) {
    for (const FrameReport& report : news.reports) look(report);
  });
  connect(&run, &RunController::frameSkipped, this, [this](int frame, const QString& reason) {
    add(LogKind::Warning, tr("Frame %1 was skipped: %2").arg(frame).arg(reason));
  });
  connect(&run, &RunController::stateChanged, this, [this](RunState state) {
    if (state == RunState::Paused) add(LogKind::Note, tr("Paused"));
  });
  connect(&run, &RunController::finished, this, &LogKeeper::finish);
  connect(&run, &RunController::failed, this, [this](const Failure& failure) {
    add(LogKind::Problem,
        failure.hint.isEmpty() ? failure.message : tr("%1 %2").arg(failure.message, failure.hint));
  });
}

void LogKeeper::add(LogKind kind, const QString& text, const QString& building) {
  log_.add({time_s_, kind, text, building});
}

void LogKeeper::begin(const SourceInfo& source) {
  time_s_.reset();
  certainty_.reset();
  guessed_ = false;
  loops_ = 0;
  add(LogKind::Note, tr("The run begins: %1, %n building(s) drawn", nullptr,
                        static_cast<int>(run_.drawing().buildings.size()))
                         .arg(QString::fromStdString(source.name)));
}

void LogKeeper::look(const FrameReport& report) {
  time_s_ = report.time_s;
  if (report.odometry_guessed != guessed_) {
    guessed_ = report.odometry_guessed;
    add(LogKind::Warning, guessed_ ? tr("No odometry: the robot is taken to go on as before")
                                   : tr("The odometry is back"));
  }
  if (report.loops > loops_) {
    add(LogKind::Note, tr("A loop was closed; %n so far", nullptr, report.loops));
  }
  loops_ = report.loops;
  const Certainty now = certaintyOf(report).kind;
  if (certainty_ == now) return;
  const bool lost = now == Certainty::Lost;
  const bool was_lost = certainty_ == Certainty::Lost;
  certainty_ = now;
  if (lost || was_lost) {
    add(lost ? LogKind::Warning : LogKind::Note, Words::certainty(report));
  }
}

void LogKeeper::finish(bool cancelled) {
  add(LogKind::Note, cancelled ? tr("The run was stopped") : tr("The run is done"));
  const auto result = run_.result();
  if (!result) return;
  const MapChanges changes = changesOf(run_.drawing(), result->map());
  add(LogKind::Note, Words::changes(changes, run_.drawing()));
  const std::vector<Concern> concerns = concernsOf(run_.drawing(), result->map());
  for (const BuildingChange& change : changes.doubtful) {
    const Building& building = run_.drawing().buildings[change.building];
    add(LogKind::Warning,
        Words::nameOf(building) + QStringLiteral(" · ") +
            Words::doubt(run_.drawing(), result->map(), change.building, concerns),
        QString::fromStdString(building.id));
  }
  for (const RunWarning& warning : result->warnings) {
    add(LogKind::Warning, QString::fromStdString(warning.message));
  }
}

}  // namespace handmap
