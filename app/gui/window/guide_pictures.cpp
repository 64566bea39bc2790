#include "app/gui/window/guide_pictures.h"

#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QTemporaryDir>
#include <QTimer>

#include <fmt/format.h>

#include "app/gui/editing/editing_panels.h"
#include "app/gui/files/exports.h"
#include "app/gui/rig/rig_actions.h"
#include "app/gui/run/source_actions.h"
#include "app/gui/run/transport_actions.h"
#include "app/gui/window/main_window.h"
#include "core/base/error.h"
#include "core/recording/image_file.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/panels/property_panel.h"
#include "widgets/rig/rig_dialog.h"
#include "widgets/run/panels/charts_panel.h"
#include "widgets/run/panels/layers_panel.h"
#include "widgets/run/panels/transport_bar.h"
#include "widgets/run/panels/why_panel.h"
#include "widgets/teach/teach_panel.h"

namespace handmap {

namespace {

constexpr QSize kWindow(1280, 860);
constexpr QSize kPanel(460, 560);
constexpr int kShownAt = 14;      // of 42 stops: something was corrected, something lies ahead
constexpr int kSettled_ms = 400;  // what is told and laid out later

void mouse(QWidget& widget, QEvent::Type type, QPointF at) {
  const Qt::MouseButtons held = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
  QMouseEvent event(type, at, widget.mapToGlobal(at), Qt::LeftButton, held, Qt::NoModifier);
  QCoreApplication::sendEvent(&widget, &event);
}

}  // namespace

QStringList GuidePictures::names() {
  return {"demonstration", "drawing", "properties", "why", "charts", "teaching", "robot"};
}

GuidePictures::GuidePictures(MainWindow& window, QString folder)
    : QObject(&window), window_(window), folder_(std::move(folder)) {
  window_.showNormal();
  window_.resize(kWindow);
  QTimer::singleShot(0, this, &GuidePictures::begin);
}

void GuidePictures::keep(QWidget& widget, const char* name) {
  QImage picture(widget.size(), QImage::Format_RGB32);
  picture.fill(widget.palette().color(QPalette::Window));
  widget.render(&picture);
  writePicture(picture, QDir(folder_).filePath(QStringLiteral("%1.png").arg(name)));
}

/// As large as it is easy to read, whatever room the docks have.
void GuidePictures::keepPanel(QWidget& panel, const char* name) {
  QWidget* dock = &panel;
  while (qobject_cast<QDockWidget*>(dock) == nullptr) dock = dock->parentWidget();
  auto& its_dock = static_cast<QDockWidget&>(*dock);
  const bool was_floating = its_dock.isFloating();
  window_.docks().show(panel);
  its_dock.setFloating(true);
  its_dock.resize(kPanel);
  QCoreApplication::processEvents();
  keep(panel, name);
  its_dock.setFloating(was_floating);
  QCoreApplication::processEvents();
}

void GuidePictures::begin() {
  try {
    if (!QDir().mkpath(folder_)) {
      throw Error(ErrorCode::RunFailed, (folder_ + ": cannot be made").toStdString());
    }
    drawBuilding();
  } catch (const Error& error) {
    fmt::print(stderr, "handmap: {}\n", error.what());
    return QCoreApplication::exit(static_cast<int>(error.code()));
  }
  window_.sources().openDemonstration();
  window_.transport().setSpeed(0.0);
  connect(&window_.sources(), &SourceActions::failed, this,
          [] { QCoreApplication::exit(static_cast<int>(ErrorCode::RunFailed)); });
  connect(&window_.run(), &RunController::stateChanged, this, [this](RunState state) {
    if (state == RunState::Paused) QTimer::singleShot(kSettled_ms, this, &GuidePictures::onPaused);
  });
  window_.runs().runOrResume();
  window_.run().runUntil(kShownAt);
}

/// In the middle of a rectangle whose width was typed.
void GuidePictures::drawBuilding() {
  Map map;
  map.start = Pose2{0.0, -12.0, 0.0};
  Building library;
  library.id = "B1";
  library.name = "Library";
  library.shape = Rectangle{{10.0, 8.0}, 30.0, 14.0, 0.0};
  library.uncertainty = Uncertainty{4.0, 3.0};
  map.buildings = {library};
  window_.document().reset(map);
  MapCanvas& canvas = window_.canvas();
  canvas.zoomToRect({-20.0, -30.0, 90.0, 70.0});
  window_.document().setSelection({"B1"});
  QCoreApplication::processEvents();
  keepPanel(window_.properties(), "properties");
  window_.document().setSelection({});
  canvas.setTool(ToolId::Rectangle);
  QWidget& viewport = *canvas.viewport();
  const auto at = [&canvas](double x, double y) {
    return canvas.viewportTransform().map(QPointF(x, y));
  };
  mouse(viewport, QEvent::MouseButtonPress, at(35.0, 1.0));
  mouse(viewport, QEvent::MouseButtonRelease, at(35.0, 1.0));
  mouse(viewport, QEvent::MouseMove, at(60.0, 16.0));
  for (const QChar digit : QStringLiteral("25")) {
    QKeyEvent key(QEvent::KeyPress, Qt::Key_0 + digit.digitValue(), Qt::NoModifier, QString(digit));
    QCoreApplication::sendEvent(&canvas, &key);
  }
  QCoreApplication::processEvents();
  keep(viewport, "drawing");
  canvas.currentTool().cancel();
  canvas.setTool(ToolId::Select);
  window_.document().undoStack().setClean();
}

void GuidePictures::onPaused() {
  disconnect(&window_.run(), &RunController::stateChanged, this, nullptr);
  window_.canvas().zoomToFit();
  window_.docks().show(window_.runPanels().layers);
  QCoreApplication::processEvents();
  try {
    keep(window_, "demonstration");
    keepPanel(window_.runPanels().charts, "charts");
  } catch (const Error&) {
    return QCoreApplication::exit(static_cast<int>(ErrorCode::RunFailed));
  }
  window_.docks().show(window_.runPanels().why);
  window_.runPanels().why.ask(0, 0);
  QTimer::singleShot(5 * kSettled_ms, this, &GuidePictures::finishRun);
}

void GuidePictures::finishRun() {
  try {
    keepPanel(window_.runPanels().why, "why");
    makeOthers();
    QCoreApplication::exit(0);
  } catch (const Error& error) {
    fmt::print(stderr, "handmap: {}\n", error.what());
    QCoreApplication::exit(static_cast<int>(ErrorCode::RunFailed));
  }
}

void GuidePictures::makeOthers() {
  const QTemporaryDir scratch;
  const auto snapshot = window_.run().history()->at(kShownAt);
  const QString image = scratch.filePath("street.png");
  writePng(snapshot->image, image.toStdString());
  TeachPanel& teach = window_.teach();
  window_.docks().show(teach);
  teach.openImages({image});
  teach.setModel(std::make_shared<const BuildingClassifier>(
      BuildingClassifier::builtIn(snapshot->image.channels() == 3)));
  QCoreApplication::processEvents();
  keep(teach, "teaching");
  window_.rigs().showDialog();
  QCoreApplication::processEvents();
  keep(*window_.rigs().dialog(), "robot");
  window_.rigs().dialog()->close();
}

}  // namespace handmap
