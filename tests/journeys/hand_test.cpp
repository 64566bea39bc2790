// What hand and eye meet in the window: room for the map, keys that go where one thinks, and the
// corrected building as a thing.
#include <QAbstractButton>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>

#include "app/gui/files/file_actions.h"
#include "tests/journeys/scripted_dialogs.h"
#include "tests/journeys/window_test.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/messages/message.h"
#include "widgets/panels/number_field.h"
#include "widgets/panels/property_panel.h"
#include "widgets/run/overlays/run_strip.h"
#include "widgets/run/panels/buildings_panel.h"
#include "widgets/run/panels/why_panel.h"

namespace handmap {
namespace {

class HandAndEye : public WindowTest {
 protected:
  void SetUp() override {
    auto dialogs = std::make_unique<ScriptedDialogs>();
    dialogs_ = dialogs.get();
    window_ = std::make_unique<MainWindow>(document_, settings_, std::move(dialogs));
    window_->show();
    window_->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
    canvas_ = &window_->canvas();
  }
  void TearDown() override { document_.undoStack().setClean(); }

  void resizeTo(const QSize& size) {
    window_->showNormal();
    window_->resize(size);
    QCoreApplication::processEvents();
  }
  double shareOfMap() const {
    const auto area = [](const QWidget& widget) {
      return double(widget.width()) * widget.height();
    };
    return area(*canvas_) / area(*window_);
  }
  QString draw(const char* id, double x, double y) {
    Building building;
    building.id = id;
    building.shape = Rectangle{{x, y}, 20.0, 10.0, 0.0};
    return document_.addBuilding(building);
  }
  void press(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier, const QString& = {}) {
    QTest::keyClick(QApplication::focusWidget(), static_cast<Qt::Key>(key), modifiers);
  }
  QWidget* welcome() const {
    for (auto* widget : window_->findChildren<QWidget*>())
      if (QString(widget->metaObject()->className()).endsWith("WelcomeStrip")) return widget;
    return nullptr;
  }
  /// A run of the two rows to its end; where the building of that id is corrected to.
  void runToTheEnd() {
    runSimulator(*window_);
    ASSERT_TRUE(waitFor(*window_, RunState::Idle));
    ASSERT_TRUE(window_->run().result());
  }

  ScriptedDialogs* dialogs_ = nullptr;
  std::unique_ptr<MainWindow> window_;
  MapCanvas* canvas_ = nullptr;
};

TEST_F(HandAndEye, TheInspectorIsOneAndFolds) {
  resizeTo({1280, 800});
  action(*window_, "view.inspector")->setChecked(true);
  window_->docks().setOpen(true);
  window_->docks().showRunDocks(true, true);
  QCoreApplication::processEvents();
  int in_front = 0;
  for (const auto* dock : window_->findChildren<QDockWidget*>())
    if (!dock->isFloating() && dock->isVisible() && !dock->visibleRegion().isEmpty()) ++in_front;
  EXPECT_EQ(in_front, 1);
  const int width = canvas_->width();
  window_->docks().showRunDocks(false, false);
  window_->docks().showRunDocks(true, true);
  QCoreApplication::processEvents();
  EXPECT_EQ(canvas_->width(), width) << "sizes outlive runs";
  action(*window_, "view.inspector")->trigger();
  QCoreApplication::processEvents();
  EXPECT_FALSE(window_->docks().isOpen());
  EXPECT_GT(canvas_->width(), width + 200);
  window_->docks().showRunDocks(true, true);
  EXPECT_FALSE(window_->findChild<QDockWidget*>("buildings")->isVisible()) << "folded stays folded";
  action(*window_, "view.inspector")->trigger();
  EXPECT_TRUE(window_->findChild<QDockWidget*>("buildings")->isVisible());
}

TEST_F(HandAndEye, APanelThatIsClosedByItsCrossStaysClosed) {
  resizeTo({1280, 800});
  window_->docks().setOpen(true);
  window_->docks().showRunDocks(true, true);
  auto* charts = window_->findChild<QDockWidget*>("charts");
  ASSERT_FALSE(charts->isHidden());
  charts->close();
  window_->docks().showRunDocks(false, false);
  window_->docks().showRunDocks(true, true);
  EXPECT_TRUE(charts->isHidden());
  charts->toggleViewAction()->trigger();
  EXPECT_FALSE(charts->isHidden());
}

TEST_F(HandAndEye, TheInspectorKeepsItsWidthFromOneSessionToTheNext) {
  window_->docks().setOpen(true);
  QCoreApplication::processEvents();
  const int width = window_->docks().width();
  window_->docks().bringForward(window_->runPanels().setup);
  ASSERT_TRUE(window_->close());
  for (int session = 0; session < 2; ++session) {
    window_ = std::make_unique<MainWindow>(document_, settings_);
    window_->show();
    QCoreApplication::processEvents();
    EXPECT_NEAR(window_->docks().width(), width, 4) << session;
    EXPECT_FALSE(window_->findChild<QDockWidget*>("objects")->visibleRegion().isEmpty());
    ASSERT_TRUE(window_->close());
  }
}

TEST_F(HandAndEye, ASmallScreenIsTheMaps) {
  resizeTo({790, 575});  // 800 × 600 without the frame
  window_->docks().arrange({790, 575});
  QCoreApplication::processEvents();
  draw("A", 0, 0);
  window_->docks().showRunDocks(true, true);
  QCoreApplication::processEvents();
  EXPECT_GE(shareOfMap(), 0.6);
  const QSize before = canvas_->size();
  window_->messages().show(MessageBar::Kind::Error, "Something long to read. It failed.");
  QCoreApplication::processEvents();
  EXPECT_EQ(canvas_->size(), before) << "a message does not move the map";
}

TEST_F(HandAndEye, TheWelcomeGoesWhenSomethingIsOpen) {
  EXPECT_TRUE(welcome()->isVisible());
  canvas_->setTool(ToolId::Rectangle);
  EXPECT_FALSE(welcome()->isVisible()) << "it would shift what is being drawn";
  canvas_->setTool(ToolId::Select);
  draw("A", 0, 0);
  EXPECT_FALSE(welcome()->isVisible());
  document_.undoStack().setClean();
  action(*window_, "file.new")->trigger();
  EXPECT_TRUE(welcome()->isVisible());
  EXPECT_TRUE(canvas_->hasFocus()) << "after New one draws";
}

TEST_F(HandAndEye, TheSimulatorDoesNotReplaceADrawing) {
  window_->sources().openSimulator();
  EXPECT_EQ(document_.map().buildings.size(), 6u) << "an empty one gives way to two rows";
  action(*window_, "file.new")->trigger();
  draw("A", 20, 20);
  document_.setStart(Pose2{});
  document_.setRoute({{0, 0}, {40, 0}});
  const Map drawn = document_.map();
  window_->sources().openSimulator();
  ASSERT_TRUE(QTest::qWaitFor([&] { return window_->sources().robot().has_value(); }, kPatienceMs));
  EXPECT_EQ(document_.map(), drawn);
  EXPECT_TRUE(action(*window_, "run.run")->isEnabled());
}

TEST_F(HandAndEye, WhatWasMissingIsSaidUntilItIsThere) {
  action(*window_, "run.simulate")->trigger();
  ASSERT_EQ(window_->messages().messages().size(), 1);
  draw("A", 0, 0);
  EXPECT_EQ(window_->messages().messages().size(), 1) << "there is no start yet";
  document_.setStart(Pose2{});
  EXPECT_TRUE(window_->messages().messages().isEmpty());
}

TEST_F(HandAndEye, RenamingKeepsTheSelection) {
  const QString id = draw("A", 0, 0);
  document_.setSelection({id});
  canvas_->setFocus();
  action(*window_, "edit.rename")->trigger();
  QTest::keyClicks(QApplication::focusWidget(), "Hall");
  press(Qt::Key_Return);
  EXPECT_EQ(document_.map().buildings[0].name, "Hall");
  EXPECT_EQ(document_.selection(), QStringList{id});
  EXPECT_TRUE(canvas_->hasFocus());
  press(Qt::Key_F2);
  press(Qt::Key_Return);
  EXPECT_EQ(document_.selection(), QStringList{id});
}

TEST_F(HandAndEye, KeysOfToolsWorkWhileANumberIsTyped) {
  document_.setSelection({draw("A", 0, 0)});
  window_->docks().show(window_->properties());
  NumberField* field = nullptr;
  for (auto* number : window_->properties().findChildren<NumberField*>())
    if (number->isVisible() && number->isEnabled()) field = number;
  ASSERT_TRUE(field);
  field->setFocus();
  ASSERT_TRUE(QTest::qWaitFor([field] { return field->hasFocus(); }));
  QTest::keyClick(window_->windowHandle(), Qt::Key_R);
  EXPECT_EQ(canvas_->tool(), ToolId::Rectangle);
  EXPECT_TRUE(canvas_->hasFocus());
}

TEST_F(HandAndEye, TabGoesThroughAFewStops) {
  resizeTo({1280, 800});
  window_->docks().setOpen(true);
  canvas_->setFocus();
  QStringList stops;
  for (int i = 0; i < 40; ++i) {
    QTest::keyClick(window_->windowHandle(), Qt::Key_Tab);
    QWidget* at = QApplication::focusWidget();
    if (at == canvas_) break;
    stops << at->metaObject()->className() + QString(" ") + at->accessibleName();
  }
  EXPECT_TRUE(canvas_->hasFocus());
  EXPECT_LE(stops.size(), 10) << stops.join("; ").toStdString();
}

TEST_F(HandAndEye, ChipsOfToolsAreThereOnlyWhileSomethingIsDrawn) {
  canvas_->setTool(ToolId::Corners);
  const auto shown = [this](const char* name) {
    return canvas_->findChild<QToolButton*>(name)->isVisible();
  };
  for (const char* name : {"back_chip", "cancel_chip", "done_chip"}) EXPECT_FALSE(shown(name));
  for (const QPoint at : {QPoint(200, 200), QPoint(300, 200), QPoint(300, 300)}) {
    QTest::mouseClick(canvas_->viewport(), Qt::LeftButton, {}, at);
    QTest::qWait(QApplication::doubleClickInterval() + 10);
  }
  for (const char* name : {"back_chip", "cancel_chip", "done_chip"}) EXPECT_TRUE(shown(name));
  QTest::mouseClick(canvas_->findChild<QToolButton*>("done_chip"), Qt::LeftButton);
  for (const char* name : {"back_chip", "cancel_chip", "done_chip"}) EXPECT_FALSE(shown(name));
}

TEST_F(HandAndEye, TheSelectionIsTurnedMirroredAndRepeated) {
  document_.setSelection({draw("A", 0, 0)});
  action(*window_, "edit.rotate_left")->trigger();
  const Bounds box = boundsOf(document_.map().buildings[0]);
  EXPECT_NEAR(box.high.y() - box.low.y(), 20.0, 1e-9);
  action(*window_, "edit.undo")->trigger();
  dialogs_->figures = {3, 2, 5, 5};
  action(*window_, "edit.array")->trigger();
  ASSERT_EQ(document_.map().buildings.size(), 6u);
  EXPECT_EQ(document_.map().buildings[5].box().centre, Vec2(50.0, 15.0));
  action(*window_, "edit.undo")->trigger();
  EXPECT_EQ(document_.map().buildings.size(), 1u);
}

TEST_F(HandAndEye, ACorrectedBuildingIsAThing) {
  EXPECT_FALSE(action(*window_, "run.why")->isEnabled());
  EXPECT_FALSE(action(*window_, "run.give_pose")->isVisible()) << "there is no robot";
  runToTheEnd();
  EXPECT_TRUE(action(*window_, "run.give_pose")->isVisible());
  // A drawn one that stands elsewhere: the corrected one is alone at its place.
  const Map refined = window_->run().result()->map();
  const Building& now = refined.buildings[0];
  const QString id = QString::fromStdString(now.id);
  document_.changeBuilding(id, moved(document_.map().buildings[0], Vec2(0.0, 300.0)), "Away");
  document_.setSelection({});
  canvas_->zoomToFit();
  canvas_->setTool(ToolId::Select);
  const Vec2 middle = now.box().centre;
  const QPoint at = canvas_->viewportTransform().map(QPointF(middle.x(), middle.y())).toPoint();
  QTest::mouseClick(canvas_->viewport(), Qt::LeftButton, {}, at);
  EXPECT_EQ(document_.selection(), QStringList{id});
  QStringList offered;
  QContextMenuEvent menu_event(QContextMenuEvent::Mouse, at, canvas_->mapToGlobal(at));
  QCoreApplication::sendEvent(canvas_->viewport(), &menu_event);
  auto* menu = canvas_->findChild<QMenu*>("canvas_menu");
  ASSERT_TRUE(menu);
  for (const QAction* entry : menu->actions()) offered << entry->objectName();
  menu->close();
  for (const char* wanted : {"run.why", "run.right", "run.not_there"})
    EXPECT_TRUE(offered.contains(wanted)) << wanted;
  action(*window_, "run.why")->trigger();
  ASSERT_TRUE(window_->runPanels().why.asked());
  EXPECT_EQ(window_->runPanels().why.asked()->building, 0u);
}

TEST_F(HandAndEye, TwoPlacesSayWhereTheDrawingLies) {
  draw("A", 50, 0);
  canvas_->zoomToRect({-100, -50, 250, 100});
  action(*window_, "draw.georeference")->trigger();
  EXPECT_EQ(canvas_->tool(), ToolId::GeoPin);
  const auto click = [this](double x, double y, double latitude, double longitude) {
    dialogs_->figures = {latitude, longitude};
    const QPoint at = canvas_->viewportTransform().map(QPointF(x, y)).toPoint();
    QTest::mouseClick(canvas_->viewport(), Qt::LeftButton, {}, at);
    ASSERT_TRUE(QTest::qWaitFor([this] { return dialogs_->figures.isEmpty(); }));
  };
  click(0, 0, 52.0, 13.0);
  click(100, 0, 52.0009, 13.0);  // 100 m to the north
  ASSERT_TRUE(document_.map().georeference);
  EXPECT_NEAR(document_.map().georeference->latitude, 52.0, 1e-4);
  EXPECT_NEAR(toDegrees(document_.map().georeference->heading), 90.0, 2.0);
  EXPECT_EQ(canvas_->tool(), ToolId::Select);
}

TEST_F(HandAndEye, AnArrowPointsToARobotOutOfView) {
  runSimulator(*window_);
  auto* pointer = canvas_->findChild<QAbstractButton*>("robot_pointer");
  ASSERT_TRUE(waitFor(*window_, RunState::Idle));
  canvas_->zoomToFit();
  EXPECT_FALSE(pointer->isVisible());
  canvas_->zoomToRect({-2000, -2000, 50, 50});
  EXPECT_TRUE(pointer->isVisible());
  const QWidget* snap = canvas_->findChild<QWidget*>("snap_chip");
  const QWidget* strip = canvas_->findChild<RunStrip*>();
  ASSERT_TRUE(strip->isVisible());
  canvas_->zoomToRect({2000, 2000, 50, 50});  // it is below, to the left
  EXPECT_FALSE(pointer->geometry().intersects(snap->parentWidget()->geometry()));
  canvas_->zoomToRect({100, -2000, 900, 50});  // above
  EXPECT_FALSE(pointer->geometry().intersects(strip->geometry()));
  EXPECT_TRUE(canvas_->viewport()->geometry().contains(pointer->geometry()));
  pointer->click();
  EXPECT_FALSE(pointer->isVisible());
}

TEST_F(HandAndEye, OnlyWhatIsTickedIsAccepted) {
  runToTheEnd();
  BuildingsPanel& review = window_->runPanels().buildings;
  review.model().setAllTaken(true);
  const QString left_out = review.model().idAt(0);
  review.model().setData(review.model().index(0, 0), Qt::Unchecked, Qt::CheckStateRole);
  const Map drawn = document_.map();
  action(*window_, "run.accept")->trigger();
  int changed = 0;
  for (std::size_t i = 0; i < drawn.buildings.size(); ++i) {
    const bool same = document_.map().buildings[i] == drawn.buildings[i];
    EXPECT_TRUE(same || QString::fromStdString(drawn.buildings[i].id) != left_out);
    changed += same ? 0 : 1;
  }
  EXPECT_EQ(changed, 5);
  EXPECT_EQ(document_.undoStack().count(), 1);
  for (const Message* message : window_->messages().messages())
    EXPECT_FALSE(message->text().contains("The run is done")) << "it is answered";
}

}  // namespace
}  // namespace handmap
