// Naming, fingers, pens, snapping and the buttons on the canvas, with real events.
#include <QContextMenuEvent>
#include <QLineEdit>
#include <QPointingDevice>
#include <QSignalSpy>
#include <QTabletEvent>
#include <QTest>
#include <QToolButton>
#include <memory>

#include "widgets/canvas/map_canvas.h"
#include "widgets/tools/toolbox.h"

namespace handmap {

class CanvasEditingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    document_ = std::make_unique<MapDocument>();
    canvas_ = std::make_unique<MapCanvas>(*document_);
    tools_ = std::make_unique<Toolbox>(*document_, *canvas_);
    canvas_->resize(800, 600);
    canvas_->show();
    QVERIFY(QTest::qWaitForWindowExposed(canvas_.get()));
    canvas_->activateWindow();
    canvas_->setFocus();
  }
  void cleanup() {
    tools_.reset();
    canvas_.reset();
  }

  // --- Naming

  void whatWasDrawnIsNamedByTyping() {
    canvas_->setTool(ToolId::Rectangle);
    drag({-20, -10}, {0, 0});
    QTest::keyClicks(canvas_.get(), "L");
    QVERIFY(editor()->isVisible());
    QTest::keyClicks(editor(), "ab R1");
    QTest::keyClick(editor(), Qt::Key_Return);
    QCOMPARE(document_->map().buildings[0].name, std::string("Lab R1"));
    QCOMPARE(canvas_->tool(), ToolId::Rectangle);
    QVERIFY(!editor()->isVisible());
    document_->undoStack().undo();
    QCOMPARE(document_->map().buildings[0].name, std::string());
    QCOMPARE(document_->undoStack().count(), 2);
  }

  void drawingOnKeepsTheNameAndEscapeDropsIt() {
    canvas_->setTool(ToolId::Rectangle);
    drag({-20, -10}, {0, 0});
    QTest::keyClicks(canvas_.get(), "A");
    drag({10, -10}, {20, 0});
    QCOMPARE(document_->map().buildings[0].name, std::string("A"));
    QVERIFY(editor()->isVisible() && !editor()->hasFocus());
    QTest::keyClick(canvas_.get(), Qt::Key_Return);
    QVERIFY(editor()->hasFocus());
    QTest::keyClicks(editor(), "b");
    QTest::keyClick(editor(), Qt::Key_Escape);
    QCOMPARE(document_->map().buildings[1].name, std::string());
    drag({-40, -40}, {-30, -30});
    QTest::keyClick(canvas_.get(), Qt::Key_Escape);
    QTest::keyClicks(canvas_.get(), "C");
    QVERIFY(!editor()->isVisible());
  }

  void lettersAndDigitsAreNoShortcutsThen() {
    const auto is_taken = [&](int key, const QString& text) {
      QKeyEvent event(QEvent::ShortcutOverride, key, Qt::NoModifier, text);
      event.ignore();
      QCoreApplication::sendEvent(canvas_.get(), &event);
      return event.isAccepted();
    };
    QVERIFY(!is_taken(Qt::Key_R, "r"));
    canvas_->setTool(ToolId::Rectangle);
    QVERIFY(is_taken(Qt::Key_4, "4"));
    QVERIFY(!is_taken(Qt::Key_R, "r"));
    QVERIFY(!is_taken(Qt::Key_Minus, "-"));
    drag({-20, -10}, {0, 0});
    QVERIFY(!is_taken(Qt::Key_R, "r"));  // the next tool key is a tool key
    QVERIFY(is_taken(Qt::Key_L, "L"));
    QVERIFY(!is_taken(Qt::Key_Plus, "+"));
  }

  void renamesInPlace() {
    document_->setSelection({document_->addBuilding(box(0, 0))});
    canvas_->renameSelected();
    QVERIFY(editor()->isVisible());
    QTest::keyClicks(editor(), "Mensa");
    document_->undoStack().undo();  // the building goes, and with it its editor
    QVERIFY(!editor()->isVisible());
    document_->undoStack().redo();
    canvas_->setTool(ToolId::Select);
    QTest::mouseDClick(canvas_->viewport(), Qt::LeftButton, {}, toPixels({0, 0}));
    QVERIFY(editor()->isVisible());
    QTest::keyClicks(editor(), "Hall");
    QTest::mouseClick(canvas_->viewport(), Qt::LeftButton, {}, toPixels({-40, -40}));
    QCOMPARE(document_->map().buildings[0].name, std::string("Hall"));
    document_->setSelection({kStartKey});
    canvas_->renameSelected();
    QVERIFY(!editor()->isVisible());
  }

  // --- Keys

  void tabTypesOnAndLeavesTheCanvasWhenThereIsNothing() {
    canvas_->setTool(ToolId::Rectangle);
    QTest::keyClicks(canvas_.get(), "10");
    QTest::keyClick(canvas_.get(), Qt::Key_Tab);
    QTest::keyClicks(canvas_.get(), "20");
    QTest::keyClick(canvas_.get(), Qt::Key_Return);
    QTest::keyClicks(canvas_.get(), "8");
    QTest::keyClick(canvas_.get(), Qt::Key_Tab);
    QTest::keyClicks(canvas_.get(), "4");
    QTest::keyClick(canvas_.get(), Qt::Key_Return);
    QCOMPARE(document_->map().buildings.size(), std::size_t(1));
    QCOMPARE(document_->map().buildings[0].box().width, 8.0);
    QVERIFY(canvas_->hasFocus());
  }

  void theKeyboardsCursorStaysInSight() {
    canvas_->setTool(ToolId::Corners);
    for (int i = 0; i < 60; ++i) QTest::keyClick(canvas_.get(), Qt::Key_Right, Qt::ShiftModifier);
    const Vec2 cursor = *canvas_->currentTool().keyboardCursor();
    QVERIFY(canvas_->visibleMetres().contains(QPointF(cursor.x(), cursor.y())));
    QVERIFY(cursor.x() > 100.0);
  }

  // --- Snapping

  void pointsSnapToWhatIsDrawnAndAltHoldsItOff() {
    document_->addBuilding(box(0, 0));  // 20 × 10
    canvas_->setTool(ToolId::Rectangle);
    const double pixel = 1.0 / canvas_->pixelsPerMetre();
    drag({10 + 4 * pixel, 5 - 3 * pixel}, {30, 25});
    QCOMPARE(boundsOf(document_->map().buildings[1]).low, Vec2(10, 5));
    drag({10 + 4 * pixel, 5 - 3 * pixel}, {30, 25}, Qt::AltModifier);
    QVERIFY(boundsOf(document_->map().buildings[2]).low != Vec2(10, 5));
  }

  void aMovedBuildingLiesAgainstItsNeighbour() {
    document_->addBuilding(box(0, 0));
    document_->addBuilding(box(40, 0));
    const double pixel = 1.0 / canvas_->pixelsPerMetre();
    drag({40, 0}, {20 + 4 * pixel, 3 * pixel});
    const Vec2 centre = document_->map().buildings[1].box().centre;
    QVERIFY((centre - Vec2(20, 0)).norm() < 1e-9);
  }

  void theChipCyclesTheModes() {
    QSignalSpy changed(canvas_.get(), &MapCanvas::snapModesChanged);
    auto* snap = chip("snap_chip");
    QVERIFY(snap->isVisible());
    QStringList texts;
    for (int i = 0; i < 4; ++i) {
      texts << snap->text();
      snap->click();
    }
    texts.removeDuplicates();
    QCOMPARE(texts.size(), 4);
    QCOMPARE(canvas_->snapModes(), SnapModes{});
    QCOMPARE(changed.count(), 4);
  }

  // --- Fingers and pens

  void aFingerDrawsAndDoneCloses() {
    canvas_->setTool(ToolId::Corners);
    for (const QPointF& corner : {QPointF(-20, -20), QPointF(0, -20), QPointF(0, 0)}) {
      tap(corner);
      QTest::qWait(450);  // else the second tap of a double tap
    }
    QVERIFY(chip("done_chip")->isVisible());
    QVERIFY(chip("back_chip")->isVisible());
    chip("done_chip")->click();
    QCOMPARE(document_->map().buildings.size(), std::size_t(1));
    QVERIFY(!chip("done_chip")->isVisible());
    canvas_->setTool(ToolId::Rectangle);
    QTest::touchEvent(canvas_->viewport(), finger()).press(0, toPixels({10, 10}));
    QTest::touchEvent(canvas_->viewport(), finger()).move(0, toPixels({20, 16}));
    QTest::touchEvent(canvas_->viewport(), finger()).move(0, toPixels({30, 20}));
    QTest::touchEvent(canvas_->viewport(), finger()).release(0, toPixels({30, 20}));
    QCOMPARE(document_->map().buildings.size(), std::size_t(2));
    QVERIFY(std::abs(document_->map().buildings[1].box().width - 20.0) < 0.5);
  }

  void twoFingersMoveAndZoomAndDrawNothing() {
    canvas_->setTool(ToolId::Rectangle);
    const double scale = canvas_->pixelsPerMetre();
    const QPointF between = canvas_->viewportTransform().inverted().map(QPointF(400, 300));
    QTest::touchEvent(canvas_->viewport(), finger()).press(0, QPoint(350, 300));
    QTest::touchEvent(canvas_->viewport(), finger())
        .move(0, QPoint(350, 300))
        .press(1, QPoint(450, 300));
    for (int i = 1; i <= 10; ++i)
      QTest::touchEvent(canvas_->viewport(), finger())
          .move(0, QPoint(350 - 4 * i, 300 + 5 * i))
          .move(1, QPoint(450 + 6 * i, 300 + 5 * i));
    QTest::touchEvent(canvas_->viewport(), finger())
        .release(0, QPoint(310, 350))
        .release(1, QPoint(510, 350));
    QVERIFY2(std::abs(canvas_->pixelsPerMetre() / scale - 2.0) < 0.1,
             qPrintable(QString::number(canvas_->pixelsPerMetre() / scale)));
    const QPointF now = canvas_->viewportTransform().map(between);
    QVERIFY2(std::hypot(now.x() - 410, now.y() - 350) < 8.0,
             qPrintable(QStringLiteral("%1 %2").arg(now.x()).arg(now.y())));
    QCOMPARE(document_->undoStack().count(), 0);
    QVERIFY(!canvas_->currentTool().isBusy());
  }

  void aLongPressIsTheContextMenu() {
    document_->addBuilding(box(0, 0));
    QSignalSpy menu(canvas_.get(), &MapCanvas::contextMenuRequested);
    QTest::touchEvent(canvas_->viewport(), finger()).press(0, toPixels({0, 0}));
    QTRY_COMPARE(menu.count(), 1);
    QTest::touchEvent(canvas_->viewport(), finger()).release(0, toPixels({0, 0}));
    QCOMPARE(document_->selection(), QStringList{"B1"});
    QCOMPARE(document_->undoStack().count(), 1);
  }

  void theOtherEndOfThePenErases() {
    document_->addBuilding(box(0, 0));
    document_->addBuilding(box(40, 0));
    canvas_->setTool(ToolId::Rectangle);
    pen(QEvent::TabletPress, {0, 0});
    pen(QEvent::TabletMove, {5, 0});
    pen(QEvent::TabletRelease, {5, 0});
    QCOMPARE(document_->map().buildings.size(), std::size_t(1));
    QCOMPARE(canvas_->tool(), ToolId::Rectangle);
  }

  void theMouseMenuSelectsWhatItIsAbout() {
    document_->addBuilding(box(0, 0));
    QSignalSpy menu(canvas_.get(), &MapCanvas::contextMenuRequested);
    const auto ask = [&](QPointF metres) {
      const QPoint at = toPixels(metres);
      QContextMenuEvent event(QContextMenuEvent::Mouse, at, canvas_->viewport()->mapToGlobal(at));
      QCoreApplication::sendEvent(canvas_->viewport(), &event);
    };
    ask({0, 0});
    QCOMPARE(document_->selection(), QStringList{"B1"});
    tools_->addCorner();  // not on a wall: in the middle of the longest
    QCOMPARE(document_->map().buildings[0].footprint().size(), std::size_t(5));
    ask({40, 40});
    QVERIFY(document_->selection().isEmpty());
    QCOMPARE(canvas_->pastePosition().x(), std::round(canvas_->pastePosition().x() * 100) / 100);
    QVERIFY((canvas_->pastePosition() - Vec2(40, 40)).norm() < 0.5);
    QCOMPARE(menu.count(), 2);
    canvas_->setTool(ToolId::Corners);
    QTest::mouseClick(canvas_->viewport(), Qt::LeftButton, {}, toPixels({-30, 30}));
    QTest::mousePress(canvas_->viewport(), Qt::RightButton, {}, toPixels({-30, 30}));
    ask({-30, 30});
    QCOMPARE(menu.count(), 2);  // the right button dropped what was begun
  }

 private:
  static Building box(double x, double y) {
    Building building;
    building.shape = Rectangle{{x, y}, 20.0, 10.0, 0.0};
    return building;
  }
  static QPointingDevice* finger() {
    static QPointingDevice* device = QTest::createTouchDevice();
    return device;
  }
  QPoint toPixels(QPointF metres) const {
    return canvas_->viewportTransform().map(metres).toPoint();
  }
  QLineEdit* editor() const { return canvas_->findChild<QLineEdit*>("name_editor"); }
  QToolButton* chip(const char* name) const { return canvas_->findChild<QToolButton*>(name); }
  void tap(QPointF metres) {
    QTest::touchEvent(canvas_->viewport(), finger()).press(0, toPixels(metres));
    QTest::touchEvent(canvas_->viewport(), finger()).release(0, toPixels(metres));
  }
  void pen(QEvent::Type type, QPointF metres) {
    static const QPointingDevice kEraser(
        "pen", 7, QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Eraser,
        QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 1);
    const QPointF at = toPixels(metres);
    QTabletEvent event(type, &kEraser, at, canvas_->viewport()->mapToGlobal(at), 0.5, 0, 0, 0, 0, 0,
                       Qt::NoModifier, Qt::LeftButton, Qt::LeftButton);
    QCoreApplication::sendEvent(canvas_->viewport(), &event);
  }
  void drag(QPointF from, QPointF to, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::mousePress(canvas_->viewport(), Qt::LeftButton, modifiers, toPixels(from));
    for (const double t : {0.5, 1.0}) {
      const QPoint at = toPixels(from + t * (to - from));
      QMouseEvent move(QEvent::MouseMove, at, canvas_->viewport()->mapToGlobal(at), Qt::NoButton,
                       Qt::LeftButton, modifiers);
      QCoreApplication::sendEvent(canvas_->viewport(), &move);
    }
    QTest::mouseRelease(canvas_->viewport(), Qt::LeftButton, modifiers, toPixels(to));
  }

  std::unique_ptr<MapDocument> document_;
  std::unique_ptr<MapCanvas> canvas_;
  std::unique_ptr<Toolbox> tools_;
};

}  // namespace handmap

QTEST_MAIN(handmap::CanvasEditingTest)
#include "canvas_editing_test.moc"
