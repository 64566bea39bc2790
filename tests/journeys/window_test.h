// A window without a display, its files in a folder of the test's own.
#pragma once

#include <QLabel>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

#include "app/gui/run/result_actions.h"
#include "app/gui/run/source_actions.h"
#include "app/gui/run/transport_actions.h"
#include "app/gui/shell/docks.h"
#include "app/gui/window/application.h"
#include "app/gui/window/main_window.h"
#include "widgets/background/background.h"
#include "widgets/messages/message_bar.h"
#include "widgets/run/panels/run_setup_panel.h"
#include "widgets/run/panels/transport_bar.h"

namespace handmap {

inline constexpr int kPatienceMs = 60'000;

class WindowTest : public testing::Test {
 protected:
  WindowTest() {
    QObject::connect(&Application::instance(), &Application::failed, &guard_,
                     [](const QString& message) { ADD_FAILURE() << message.toStdString(); });
  }
  /// No thread outlives its test.
  ~WindowTest() override { EXPECT_TRUE(waitForBackground(std::chrono::seconds(30))); }

  QString path(const QString& name) const { return folder_.filePath(name); }
  std::unique_ptr<MainWindow> open() {
    auto window = std::make_unique<MainWindow>(document_, settings_);
    window->show();
    return window;
  }
  /// The simulator with few particles, as fast as possible.
  static void runSimulator(MainWindow& window) {
    RunSetup setup;
    setup.settings.slam.slam_particles = 5;
    setup.settings.slam.pso_particles = 5;
    window.runPanels().setup.setSetup(setup);
    window.sources().openTwoRows();
    window.transport().setSpeed(0.0);
    window.runs().runOrResume();
  }
  static bool waitFor(MainWindow& window, RunState state) {
    return QTest::qWaitFor([&] { return window.run().state() == state; }, kPatienceMs);
  }
  static QString message(MainWindow& window) {
    if (!window.messages().isVisible()) return {};
    QString text;
    for (const auto* label : window.messages().findChildren<QLabel*>()) text += label->text();
    return text;
  }
  static QAction* action(MainWindow& window, const QString& id) {
    return window.findChild<QAction*>(id);
  }

  QObject guard_;
  MapDocument document_;
  QTemporaryDir folder_;
  QSettings settings_{folder_.filePath("settings.ini"), QSettings::IniFormat};
};

}  // namespace handmap
