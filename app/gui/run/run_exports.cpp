#include "app/gui/run/run_exports.h"

#include <QFileInfo>
#include <QMainWindow>

#include "app/gui/files/file_actions.h"
#include "app/gui/run/run_controller.h"
#include "app/gui/run/source_actions.h"
#include "app/gui/shell/language.h"
#include "core/base/text.h"
#include "core/map/map_io.h"
#include "core/map/references.h"
#include "core/recording/recording.h"
#include "core/report/report.h"
#include "core/run_log/run_film.h"
#include "core/run_log/run_log.h"
#include "core/run_log/run_part.h"
#include "widgets/actions/action_set.h"
#include "widgets/document/map_document.h"

namespace handmap {

namespace {

/// The moments that the history has kept, by `open` (a RunLog or RunFilm) and `finish`.
/// What cannot be written whole leaves an older file as it was. False: stopped.
template <typename Open, typename Finish>
bool writeMoments(const RunHistory& history, const std::filesystem::path& path,
                  const std::stop_token& stop, const Open& open, const Finish& finish) {
  const auto remove_part = [&path] {
    std::error_code ignored;
    std::filesystem::remove(runPartOf(path), ignored);
  };
  try {
    {
      auto moments = open();
      for (int i = history.first(); i <= history.newest() && !stop.stop_requested(); ++i) {
        moments.add(*history.at(i));
      }
      if (!stop.stop_requested()) finish(moments);
    }
    if (stop.stop_requested()) remove_part();
    return !stop.stop_requested();
  } catch (...) {
    remove_part();
    throw;
  }
}

std::vector<ReportedParticles> particlesOf(const RunHistory& history) {
  std::vector<ReportedParticles> all;
  for (int i = history.first(); i <= history.newest(); ++i) {
    const auto snapshot = history.at(i);
    if (snapshot->particles.empty()) continue;
    const double time_s = snapshot->report.time_s;
    if (all.empty() || all.back().time_s < time_s) all.push_back({time_s, {}});
    all.back().points.clear();
    for (const ParticleView& particle : snapshot->particles) {
      all.back().points.push_back(particle.pose.position());
    }
  }
  return all;
}

/// Anew from its beginning, into a new folder. False where it was stopped: then nothing is left.
bool writeRecording(const Robot& robot, const std::vector<Act>& acts,
                    const std::filesystem::path& folder, const std::stop_token& stop) {
  const auto source = robot.connect({}, stop, [](double) {});
  if (!source) return false;
  const Trajectory truth(source->info().truth, "truth");
  auto writer = std::make_unique<RecordingWriter>(folder, source->info());
  const auto remove = [&] {
    writer.reset();
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
  };
  try {
    while (!stop.stop_requested()) {
      std::optional<Observation> observation;
      try {
        observation = source->next();
      } catch (const FrameError&) {
        continue;  // a run passes over it, too
      }
      if (!observation) {
        if (!acts.empty()) writeActs(folder, acts);
        return true;
      }
      writer->add(*observation, truth.at(observation->time_s));
    }
  } catch (...) {
    remove();
    throw;
  }
  remove();
  return false;
}

}  // namespace

RunExports::RunExports(const Shell& shell, MapDocument& document, FileActions& files,
                       const SourceActions& sources, RunController& run)
    : QObject(&shell.window),
      shell_(shell),
      document_(document),
      files_(files),
      sources_(sources),
      run_(run) {
  const ActionSet& actions = shell_.actions;
  actions.on("file.export_map", this, [this] { exportMap(); });
  actions.on("file.export_trajectory", this, [this] { exportTrajectory(); });
  actions.on("file.export_report", this, [this] { exportReport(); });
  actions.on("file.export_mcap", this, [this] { exportMcap(); });
  actions.on("file.export_film", this, [this] { exportFilm(); });
  actions.on("file.export_recording", this, [this] { exportRecording(); });
  files_.setCorrected([this] { return refinedMap(); });
  connect(&run_, &RunController::begun, this, &RunExports::updateActions);
  connect(&run_, &RunController::stateChanged, this, &RunExports::updateActions);
  connect(&run_, &RunController::newsArrived, this, &RunExports::updateActions);
  connect(&sources_, &SourceActions::robotChanged, this, &RunExports::updateActions);
  updateActions();
}

void RunExports::updateActions() {
  const auto result = run_.result();
  shell_.actions.setEnabled(
      {"file.export_map", "file.export_trajectory", "file.export_mcap", "file.export_film"},
      result != nullptr, tr("no run has corrected anything yet"));
  const auto& robot = sources_.robot();
  shell_.actions.setEnabled(
      {"file.export_recording"}, robot && !robot->live,
      robot ? tr("a live drive is recorded as it goes on") : tr("there is no robot yet"));
  shell_.actions.setEnabled({"file.export_report"}, result && !result->report.empty(),
                            tr("no run has come to its end yet"));
}

std::optional<Map> RunExports::refinedMap() const {
  const auto result = run_.result();
  if (!result) return std::nullopt;
  Map map = result->map();
  map.georeference = document_.map().georeference;
  return map;
}

QString RunExports::nameOf(const QString& what) const {
  return QFileInfo(document_.displayName()).completeBaseName() + what;
}

void RunExports::exportMap() {
  std::optional<Map> map = refinedMap();
  if (!map) return;
  files_.exportAs(
      {tr("Export the corrected map"), nameOf(tr("-corrected")) + QStringLiteral(".handmap"),
       FileActions::mapFilter(), QStringLiteral("handmap"), tr("The corrected map")},
      [this, &map](const QString& path) {
        moveReferences(*map, document_.origin().toStdString(), path.toStdString());
        writeMap(*map, path.toStdString());
      });
}

void RunExports::exportTrajectory() {
  const auto result = run_.result();
  if (!result) return;
  files_.exportAs({tr("Export the trajectory"), document_.displayName(), tr("Trajectories (*.tum)"),
                   QStringLiteral("tum"), tr("The way of the robot")},
                  [&result](const QString& path) {
                    writeFileAtomically(path.toStdString(),
                                        formatTum(result->last->trajectory.all()));
                  });
}

void RunExports::exportReport() {
  const auto result = run_.result();
  if (!result || result->report.empty()) return;
  ReportInputs inputs;
  inputs.drawing = run_.drawing();
  if (inputs.drawing.name.empty()) inputs.drawing.name = nameOf({}).toStdString();
  inputs.refined = *refinedMap();
  inputs.run = result->report;
  inputs.run_file = "report.json";
  inputs.trajectory = result->last->trajectory.all();
  if (languageOf(shell_.settings).language() == QLocale::Japanese) {
    inputs.language = ReportLanguage::Japanese;
  }
  std::filesystem::path recording;
  if (const auto& robot = sources_.robot()) {
    inputs.truth = robot->truth_map;
    recording = robot->folder.toStdString();
  }
  files_.exportInBackground(
      {tr("Export a report"), nameOf(tr("-report")) + QStringLiteral(".html"),
       tr("Pages (*.html *.pdf)"), QStringLiteral("html"), tr("The report of the run")},
      [inputs = std::move(inputs), recording, history = run_.history()](
          const QString& path, const std::stop_token& stop) {
        ReportInputs all = inputs;
        if (history) all.particles = particlesOf(*history);
        if (is_directory(recording)) all.recording = openRecording(recording);  // for its pictures
        if (stop.stop_requested()) return false;
        const std::string page =
            path.endsWith(QLatin1String(".pdf")) ? reportPdf(all) : reportHtml(all);
        if (stop.stop_requested()) return false;
        writeFileAtomically(path.toStdString(), page);
        return true;
      });
}

void RunExports::exportMcap() {
  const auto result = run_.result();
  const auto history = run_.history();
  const auto tape = run_.tape();
  if (!result || !history || !tape) return;
  files_.exportInBackground(
      {tr("Export the run as MCAP"), nameOf(tr("-run")) + QStringLiteral(".mcap"),
       tr("MCAP (*.mcap)"), QStringLiteral("mcap"), tr("The run")},
      [result, history, tape, drawing = run_.drawing()](const QString& path,
                                                        const std::stop_token& stop) {
        return writeMoments(
            *history, path.toStdString(), stop,
            [&] { return RunLog(path.toStdString(), drawing, tape->info()); },
            [&](RunLog& log) {
              log.finish(result->map(), result->last->trajectory.all(), result->warnings);
            });
      });
}

void RunExports::exportFilm() {
  const auto history = run_.history();
  if (!run_.result() || !history) return;
  files_.exportInBackground(
      {tr("Export the run as a film"), nameOf(tr("-run")) + QStringLiteral(".mp4"),
       tr("Films (*.mp4 *.webm *.mkv *.avi)"), QStringLiteral("mp4"), tr("The film of the run")},
      [history, drawing = run_.drawing()](const QString& path, const std::stop_token& stop) {
        return writeMoments(
            *history, path.toStdString(), stop,
            [&] { return RunFilm(path.toStdString(), drawing); },
            [](RunFilm& film) { film.finish(); });
      });
}

void RunExports::exportRecording() {
  const auto& robot = sources_.robot();
  if (!robot || robot->live) return;
  files_.exportInBackground(
      {tr("A new folder for the recording"), nameOf(tr("-recording")), {}, {}, tr("The recording")},
      [robot = *robot, acts = acts_ ? acts_() : std::vector<Act>()](const QString& path,
                                                                    const std::stop_token& stop) {
        return writeRecording(robot, acts, path.toStdString(), stop);
      });
}

}  // namespace handmap
