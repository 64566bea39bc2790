// handmap: the desktop program.

#include <QProcess>
#include <QSettings>
#include <QTemporaryDir>
#include <chrono>
#include <clocale>
#include <cstdlib>

#include <fmt/format.h>
#include <malloc.h>

#include "app/gui/files/file_actions.h"
#include "app/gui/rig/rig_actions.h"
#include "app/gui/run/source_actions.h"
#include "app/gui/run/transport_actions.h"
#include "app/gui/shell/language.h"
#include "app/gui/window/application.h"
#include "app/gui/window/batch.h"
#include "app/gui/window/command_line.h"
#include "app/gui/window/guide_pictures.h"
#include "app/gui/window/main_window.h"
#include "app/gui/window/narrator.h"
#include "core/base/error.h"
#include "widgets/background/background.h"
#include "widgets/messages/message_bar.h"
#include "widgets/run/panels/run_setup_panel.h"
#include "widgets/run/panels/transport_bar.h"
#include "widgets/style/icons.h"

namespace {

using namespace handmap;

QtMessageHandler default_handler = nullptr;

/// The platform that draws into memory complains about every window; nobody can help that.
void dropNoise(QtMsgType type, const QMessageLogContext& context, const QString& message) {
  if (message.startsWith(QLatin1String("This plugin does not support"))) return;
  default_handler(type, context, message);
}

/// A machine without a display runs the same program, drawing into memory. False: nobody can see
/// it.
bool choosePlatform() {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
    if (!qEnvironmentVariableIsEmpty(name)) return true;
  }
  qputenv("QT_QPA_PLATFORM", "offscreen");
  default_handler = qInstallMessageHandler(dropNoise);
  return false;
}

/// A drive of hours is concluded again and again, each time from a thread of its own and with a lot
/// of memory for a moment. Pools of few threads, and large pieces outside of them, give it back.
void keepMemoryLevel() {
  mallopt(M_ARENA_MAX, 2);
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
  mallopt(M_TRIM_THRESHOLD, 8 << 20);
}

void applySetup(MainWindow& window, const CommandLine& line) {
  RunSetupPanel& panel = window.runPanels().setup;
  RunSetup setup = panel.setup();
  if (line.seed) setup.settings.seed = static_cast<std::uint64_t>(*line.seed);
  panel.setSetup(setup);
}

/// Throws Error where a batch must not go on without the drawing.
void openDrawing(MainWindow& window, const CommandLine& line) {
  if (line.map.isEmpty()) return;
  if (line.isBatch()) {
    window.document().open(line.map);
  } else {
    window.files().open(line.map);
  }
}

void openRobot(MainWindow& window, const CommandLine& line, bool first_start) {
  const bool nothing_asked =
      line.map.isEmpty() && line.recording.isEmpty() && line.rig.isEmpty() && !line.virtual_rig;
  const bool demo = line.demo || (first_start && nothing_asked);
  if (line.run || demo) {
    QObject::connect(&window.sources(), &SourceActions::robotChanged, &window.runs(),
                     &TransportActions::runOrResume, Qt::SingleShotConnection);
  }
  if (demo) window.sources().openDemonstration();
  if (line.virtual_rig) window.sources().openVirtualRig(*line.virtual_rig);
  if (!line.rig.isEmpty()) window.rigs().openRig(line.rig);
  if (!line.recording.isEmpty()) window.sources().openRecording(line.recording, line.replay);
  if (line.isBatch()) window.transport().setSpeed(0.0);
  if (line.speed) window.transport().setSpeed(*line.speed);
}

int runProgram(Application& app, const CommandLine& line) {
  // A batch neither reads nor leaves traces of how somebody likes the window.
  const QTemporaryDir scratch;
  QSettings own;
  QSettings none(scratch.filePath("settings.ini"), QSettings::IniFormat);
  QSettings& settings = line.isBatch() ? none : own;
  constexpr auto kStartedKey = "window/started";
  const bool first_start = !line.isBatch() && !settings.contains(kStartedKey) &&
                           !settings.contains("window/geometry");  // of an earlier version
  settings.setValue(kStartedKey, true);
  installLanguage(app, settings);

  MapDocument document;
  MainWindow window(document, settings);
  QObject::connect(&app, &Application::failed, &window,
                   [&window](const QString& message, const QString& hint) {
                     window.messages().show(MessageBar::Kind::Error, message, hint);
                   });
  window.files().setWindowOpener([](const QStringList& arguments) {
    // A window is a process of its own: what one of them meets does not touch the others.
    QProcess::startDetached(QApplication::applicationFilePath(), arguments);
  });
  applySetup(window, line);
  if (line.verbose) new Narrator(window);
  if (!line.guide_folder.isEmpty()) {
    new GuidePictures(window, line.guide_folder);
    return app.exec();
  }
  if (line.isBatch()) new Batch(window, line);
  window.show();
  openDrawing(window, line);
  openRobot(window, line, first_start);
  if (!line.isBatch()) window.offerRecovery();
  return app.exec();
}

/// Longer than any step takes to notice that nobody waits for it.
constexpr auto kPatience = std::chrono::seconds(10);

/// Threads that were let go may not meet the end of main(): what they use would be gone.
int ended(int status) {
  if (!waitForBackground(kPatience)) std::_Exit(status);
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  keepMemoryLevel();
  try {
    const bool visible = choosePlatform();
    Application app(argc, argv);
    std::setlocale(LC_NUMERIC, "C");  // files have decimal points
    QApplication::setApplicationName("handmap");
    QApplication::setOrganizationName("handmap");
    QApplication::setApplicationVersion(HANDMAP_VERSION);
    QApplication::setDesktopFileName("handmap");
    QApplication::setWindowIcon(QIcon(":/handmap.svg"));
    const CommandLine line = parseCommandLine(QApplication::arguments());
    if (!visible && !line.isBatch()) {
      throw Error(ErrorCode::Usage, "there is no display to open a window on",
                  "--offscreen-report DIR runs without one.");
    }
    return ended(runProgram(app, line));
  } catch (const Error& error) {
    fmt::print(stderr, "handmap: {}\n", error.what());
    if (!error.hint().empty()) fmt::print(stderr, "{}\n", error.hint());
    return ended(static_cast<int>(error.code()));
  } catch (const std::exception& error) {
    fmt::print(stderr, "handmap: {}\n", error.what());
    return ended(static_cast<int>(ErrorCode::RunFailed));
  }
}
