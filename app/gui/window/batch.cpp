#include "app/gui/window/batch.h"

#include <QCoreApplication>
#include <QDir>
#include <QTimer>

#include <fmt/format.h>

#include "app/gui/files/exports.h"
#include "app/gui/run/result_actions.h"
#include "app/gui/run/run_score.h"
#include "app/gui/run/source_actions.h"
#include "app/gui/run/transport_actions.h"
#include "app/gui/window/main_window.h"
#include "core/base/text.h"
#include "core/map/map_io.h"
#include "core/map/references.h"
#include "widgets/canvas/map_canvas.h"

namespace handmap {

Batch::Batch(MainWindow& window, const CommandLine& line)
    : QObject(&window), window_(window), line_(line) {
  connect(&window.sources(), &SourceActions::failed, this, &Batch::onFailed);
  // Later, so that what the window shows of the end is in its picture.
  connect(&window.run(), &RunController::finished, this,
          [this] { QTimer::singleShot(0, this, &Batch::onFinished); });
}

void Batch::onFailed(const Failure& failure) {
  fmt::print(stderr, "handmap: {}\n", failure.message.toStdString());
  if (!failure.hint.isEmpty()) fmt::print(stderr, "{}\n", failure.hint.toStdString());
  QCoreApplication::exit(static_cast<int>(failure.code));
}

void Batch::onFinished() {
  try {
    if (!line_.report_folder.isEmpty()) writeReport(line_.report_folder);
    QCoreApplication::exit(0);
  } catch (const Error& error) {
    onFailed(failureOf(error));
  }
}

void Batch::writeReport(const QString& folder) {
  const auto result = window_.run().result();
  const auto score = window_.results().score();
  if (!result || !score) throw Error(ErrorCode::RunFailed, "the run ended before its first step");
  if (!QDir().mkpath(folder)) {
    throw Error(ErrorCode::RunFailed, (folder + ": cannot be made").toStdString());
  }
  const auto path = [&folder](const char* name) { return QDir(folder).absoluteFilePath(name); };
  for (const RunWarning& warning : result->warnings) {
    fmt::print(stderr, "handmap: warning: {} {}\n", warning.message, warning.hint);
  }
  Map refined = result->map();
  const std::string refined_file = path("refined.handmap").toStdString();
  moveReferences(refined, window_.document().origin().toStdString(), refined_file);
  writeMap(refined, refined_file);
  writeFileAtomically(path("trajectory.tum").toStdString(),
                      formatTum(result->last->trajectory.all()));
  window_.canvas().zoomToFit();
  writePicture(pictureOf(window_), path("screenshot.png"));

  fmt::print("{}\n{}\n", window_.runs().stateInWords().toStdString(),
             scoreTable(*score).toStdString());
  for (const auto& [what, name] :
       {std::pair("corrected map", "refined.handmap"), std::pair("trajectory", "trajectory.tum"),
        std::pair("screenshot", "screenshot.png")}) {
    fmt::print("{:<12} {}\n", what, path(name).toStdString());
  }
}

}  // namespace handmap
