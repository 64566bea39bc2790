// The canvas with real mouse, wheel and key events.
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QThreadPool>
#include <QWheelEvent>
#include <memory>

#include "widgets/canvas/map_canvas.h"
#include "widgets/canvas/rulers.h"
#include "widgets/style/colours.h"
#include "widgets/tools/toolbox.h"

namespace handmap {

namespace {

Map oneBuilding() {
  Map map;
  Building building;
  building.id = "A";
  building.shape = Rectangle{{10.0, 20.0}, 20.0, 10.0, 0.0};
  map.buildings = {building};
  return map;
}

Map town(int side) {
  Map map;
  for (int i = 0; i < side * side; ++i) {
    const int row = i / side;
    Building building;
    building.id = "H" + std::to_string(i);
    building.name = "House";
    building.shape = Rectangle{{(i % side) * 30.0, row * 30.0}, 20.0, 10.0, 0.1 * i};
    map.buildings.push_back(building);
  }
  return map;
}

double distance(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

}  // namespace

class CanvasTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    document_ = std::make_unique<MapDocument>();
    document_->reset(oneBuilding());
    canvas_ = std::make_unique<MapCanvas>(*document_);
    tools_ = std::make_unique<Toolbox>(*document_, *canvas_);
    canvas_->resize(800, 600);
    canvas_->show();
    QVERIFY(QTest::qWaitForWindowExposed(canvas_.get()));
  }
  void cleanup() {
    tools_.reset();
    canvas_.reset();
  }

  void whatGoesWithTheFocusSelectsNothing() {
    QPushButton button(canvas_.get());
    button.show();
    button.setFocus();
    QVERIFY(button.hasFocus());
    button.hide();
    QVERIFY(document_->selection().isEmpty());
  }

  void whatIsBelowTheCursorStaysThereWhileZooming() {
    double scale = canvas_->pixelsPerMetre();
    for (const QPoint cursor : {QPoint(17, 580), QPoint(400, 300), QPoint(790, 3)}) {
      for (const int notches : {1, 1, 3, -2, 7, -1, -9, 4}) {
        const QPointF before = toMetres(cursor);
        wheel(cursor, 120 * notches);
        QVERIFY(notches > 0 ? canvas_->pixelsPerMetre() > scale
                            : canvas_->pixelsPerMetre() < scale);
        scale = canvas_->pixelsPerMetre();
        QVERIFY(distance(toPixels(before), cursor) <= 1.0);
      }
    }
  }

  void zoomStopsBeforeNumbersDo() {
    for (int i = 0; i < 200; ++i) canvas_->zoomIn();
    const double most = canvas_->pixelsPerMetre();
    QVERIFY(most >= 100.0 && most < 1e4);
    canvas_->zoomIn();
    QCOMPARE(canvas_->pixelsPerMetre(), most);
    for (int i = 0; i < 200; ++i) canvas_->zoomOut();
    QVERIFY(canvas_->pixelsPerMetre() > 0.0);
    QVERIFY(canvas_->visibleMetres().width() < 1e7);
    canvas_->grab();
  }

  void aRouteIsNotShownWhileARunIsUnlessOneWorksOnIt() {
    document_->reset(oneBuilding());
    canvas_->zoomToFit();
    const auto picture = [this] { return canvas_->viewport()->grab().toImage(); };
    const QImage without = picture();
    document_->setRoute({{0.0, 20.0}, {30.0, 20.0}});
    const QImage with_route = picture();
    QVERIFY(with_route != without);
    canvas_->setRunShown(true);
    QCOMPARE(picture(), without);
    document_->setSelection({kRouteKey});
    QVERIFY(picture() != without);
    document_->setSelection({});
    canvas_->setTool(ToolId::Route);
    QVERIFY(picture() != without);
    canvas_->setTool(ToolId::Select);
    canvas_->setRunShown(false);
    QCOMPARE(picture(), with_route);
  }

  void yIsUp() {
    QVERIFY(toPixels({0.0, 10.0}).y() < toPixels({0.0, 0.0}).y());
    QVERIFY(toPixels({10.0, 0.0}).x() > toPixels({0.0, 0.0}).x());
  }

  void fitShowsEverythingAndAnEmptyMapToo() {
    Map map = oneBuilding();
    map.route = {{-500.0, 3000.0}, {800.0, 10.0}};
    map.start = Pose2{0.0, -900.0, 0.0};
    document_->reset(map);
    canvas_->zoomToFit();
    for (const QPointF& point : {QPointF(-500, 3000), QPointF(800, 10), QPointF(0, -900)})
      QVERIFY(canvas_->visibleMetres().contains(point));
    canvas_->zoomToObject("A");
    QVERIFY(canvas_->visibleMetres().width() < 200.0);
    QVERIFY(distance(canvas_->visibleMetres().center(), {10.0, 20.0}) < 1.0);
    const QRectF shown = canvas_->visibleMetres();
    canvas_->zoomToObject("absent");
    QCOMPARE(canvas_->visibleMetres(), shown);
    document_->reset();
    canvas_->zoomToFit();
    QVERIFY(canvas_->visibleMetres().contains(QRectF(-50, -50, 100, 100)));
  }

  void farFromTheOriginItIsStillExact() {
    Map map = oneBuilding();
    map.buildings[0].shape = Rectangle{{900000.0, -900000.0}, 20.0, 10.0, 0.0};
    document_->reset(map);
    canvas_->zoomToFit();
    const QPointF corner = toPixels({900010.0, -899995.0});
    QVERIFY(canvas_->viewport()->rect().contains(corner.toPoint()));
    QVERIFY(distance(toMetres(corner), {900010.0, -899995.0}) < 1e-6);
    press({900000.0, -900000.0});
    QCOMPARE(document_->selection(), QStringList{"A"});
  }

  void cursorAndScaleAreTold() {
    QSignalSpy cursor(canvas_.get(), &MapCanvas::cursorMoved);
    QSignalSpy scale(canvas_.get(), &MapCanvas::scaleChanged);
    const QPoint at(123, 234);
    QMouseEvent hover(QEvent::MouseMove, at, canvas_->viewport()->mapToGlobal(at), Qt::NoButton,
                      Qt::NoButton, Qt::NoModifier);
    QCoreApplication::sendEvent(canvas_->viewport(), &hover);
    QCOMPARE(cursor.count(), 1);
    QVERIFY(distance(cursor.last()[0].toPointF(), toMetres(QPoint(123, 234))) < 1e-9);
    canvas_->zoomIn();
    QCOMPARE(scale.last()[0].toDouble(), canvas_->pixelsPerMetre());
  }

  void middleButtonAndSpacePan() {
    for (const bool with_space : {false, true}) {
      const QPointF before = toMetres(QPoint(400, 300));
      if (with_space) QTest::keyPress(canvas_->viewport(), Qt::Key_Space);
      const Qt::MouseButton button = with_space ? Qt::LeftButton : Qt::MiddleButton;
      QTest::mousePress(canvas_->viewport(), button, {}, QPoint(400, 300));
      QTest::mouseMove(canvas_->viewport(), QPoint(430, 280));
      QTest::mouseMove(canvas_->viewport(), QPoint(500, 250));
      QTest::mouseRelease(canvas_->viewport(), button, {}, QPoint(500, 250));
      if (with_space) QTest::keyRelease(canvas_->viewport(), Qt::Key_Space);
      QVERIFY(distance(toPixels(before), {500.0, 250.0}) <= 1.0);
      QVERIFY(document_->selection().isEmpty());
    }
    const QPointF before = toMetres(QPoint(400, 300));
    wheel(QPoint(400, 300), 120, Qt::ShiftModifier);
    QCOMPARE(toPixels(before).toPoint(), QPoint(400, 420));
  }

  void drawsWithTheMouseAndEscapeLeadsBack() {
    QSignalSpy tool(canvas_.get(), &MapCanvas::toolChanged);
    QSignalSpy hint(canvas_.get(), &MapCanvas::hintChanged);
    canvas_->setTool(ToolId::Rectangle);
    QCOMPARE(tool.count(), 1);
    QCOMPARE(hint.last()[0].toString(), canvas_->hint());
    canvas_->setSnapModes({.grid = true, .objects = false});
    dragMouse({-20.1, -9.9}, {-10.2, -5.1});
    QCOMPARE(document_->map().buildings.size(), std::size_t(2));
    const Rectangle drawn = document_->map().buildings.back().box();
    QCOMPARE(drawn.centre, Vec2(-15.0, -7.5));
    QCOMPARE(drawn.width, 10.0);
    QCOMPARE(drawn.depth, 5.0);

    press({-20.0, -20.0});
    QTest::mouseMove(canvas_->viewport(), toPixels({-10.0, -25.0}).toPoint());
    QTest::keyClick(canvas_->viewport(), Qt::Key_Escape);
    QCOMPARE(canvas_->tool(), ToolId::Rectangle);  // the first only drops what is begun
    QTest::mouseRelease(canvas_->viewport(), Qt::LeftButton, {}, toPixels({-10, -25}).toPoint());
    QTest::keyClick(canvas_->viewport(), Qt::Key_Escape);
    QCOMPARE(canvas_->tool(), ToolId::Select);
    QCOMPARE(document_->selection(), QStringList{"B1"});
    QTest::keyClick(canvas_->viewport(), Qt::Key_Escape);
    QVERIFY(document_->selection().isEmpty());
    QCOMPARE(document_->undoStack().count(), 1);
  }

  void polygonByClicksAndADoubleClick() {
    canvas_->setTool(ToolId::Corners);
    for (const QPointF& p : {QPointF(-20, -20), QPointF(0, -20), QPointF(0, -10)}) {
      press(p);
      release(p);
    }
    QTest::mouseDClick(canvas_->viewport(), Qt::LeftButton, {}, toPixels({0, -10}).toPoint());
    QCOMPARE(document_->map().buildings.size(), std::size_t(2));
    QCOMPARE(std::get<Polygon>(document_->map().buildings[1].shape).size(), std::size_t(3));
  }

  void movesWithTheMouseAndKeys() {
    dragMouse({10.0, 20.0}, {15.0, 10.0});
    const Vec2 moved_to = document_->map().buildings[0].box().centre;
    QVERIFY((moved_to - Vec2(15.0, 10.0)).norm() < 2.0 / canvas_->pixelsPerMetre());
    QCOMPARE(moved_to, Vec2((moved_to * 100.0).array().round() / 100.0));  // tidy numbers
    QTest::keyClick(canvas_->viewport(), Qt::Key_Up);
    QVERIFY(document_->map().buildings[0].box().centre.y() > moved_to.y());
    QTest::keyClick(canvas_->viewport(), Qt::Key_Delete);
    QVERIFY(document_->map().buildings.empty());
    QCOMPARE(document_->undoStack().count(), 3);
  }

  void aPreviewIsSeenBeforeItIsDone() {
    canvas_->setGridVisible(false);
    const QRgb ink = paintedAt({-20.0, 20.0});
    press({10.0, 20.0});
    QTest::mouseMove(canvas_->viewport(), toPixels({-20.0, 20.0}).toPoint());
    QVERIFY(paintedAt({-20.0, 20.0 - 3.0}) != ink);
    QTest::keyClick(canvas_->viewport(), Qt::Key_Escape);
    QCOMPARE(paintedAt({-20.0, 20.0 - 3.0}), ink);
    release({-20.0, 20.0});
  }

  void layersCanBeHidden() {
    canvas_->setGridVisible(false);
    const QRgb ground = Colours::of(canvas_->palette())[Role::Background].rgb();
    QVERIFY(paintedAt({10.0, 22.0}) != ground);
    canvas_->setDrawingVisible(false);
    QCOMPARE(paintedAt({10.0, 22.0}), ground);
  }

  void picturesOutsideOfTheFolderAreShownWhenTheyAreTrusted() {
    QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir("maps"));
    QImage red(40, 20, QImage::Format_RGB32);
    red.fill(Qt::red);
    QVERIFY(red.save(folder.filePath("red.png")));
    Map map;
    map.underlays = {{"../red.png", -40.0, -20.0, 0.5, 0.0, 1.0, {}}};
    document_->reset(map, folder.filePath("maps/m.handmap"));
    canvas_->zoomToFit();
    QVERIFY(QThreadPool::globalInstance()->waitForDone());
    QTest::qWait(1);
    QVERIFY(paintedAt({-30.0, -25.0}) != QColor(Qt::red).rgb());
    document_->setTrustsReferences(true);
    QTRY_COMPARE(paintedAt({-30.0, -25.0}), QColor(Qt::red).rgb());
  }

  void picturesAppearAndMissingOnesAreMarked() {
    QTemporaryDir folder;
    QImage red(40, 20, QImage::Format_RGB32);
    red.fill(Qt::red);
    QVERIFY(red.save(folder.filePath("red.png")));
    Map map = oneBuilding();
    map.underlays = {{"red.png", -40.0, -20.0, 0.5, 0.0, 1.0, {}},
                     {"absent.png", 40.0, -20.0, 0.05, 0.0, 1.0, {}}};
    document_->reset(map, folder.filePath("m.handmap"));
    canvas_->zoomToFit();
    // 20 m × 10 m, from the top left corner to the right and down
    QTRY_COMPARE(paintedAt({-30.0, -25.0}), QColor(Qt::red).rgb());
    QVERIFY(paintedAt({-30.0, -31.0}) != QColor(Qt::red).rgb());
    canvas_->setGridVisible(false);
    QTRY_VERIFY(coloursIn({40.0, -35.0, 20.0, 15.0}).size() > 1);  // not only the ground
    canvas_->setUnderlaysVisible(false);
    QCOMPARE(coloursIn({-40.0, -30.0, 20.0, 10.0}).size(), 1);
  }

  void aTownOfTenThousandIsDrawnAndEdited() {
    document_->reset(town(100));
    canvas_->zoomToFit();
    QVERIFY(!canvas_->grab().isNull());
    document_->selectAll();
    QTest::keyClick(canvas_->viewport(), Qt::Key_Right);
    QCOMPARE(document_->map().buildings[9999].box().centre.x(), 99 * 30.0 + 0.1);
    canvas_->zoomToObject("H5050");
    QVERIFY(!canvas_->grab().isNull());
    document_->removeSelected();
    QVERIFY(document_->map().buildings.empty());
  }

  void theGridKeepsToOneTwoFive() {
    for (double metres = 1e-4; metres < 1e6; metres *= 1.37) {
      const double step = roundedStep(metres);
      QVERIFY(step >= metres * (1.0 - 1e-6) && step <= metres * 2.5 * (1.0 + 1e-6));
      const double digit = step / std::pow(10.0, std::floor(std::log10(step * 1.0000001)));
      QVERIFY(std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 ||
              std::abs(digit - 5) < 1e-6);
    }
  }

 private:
  QPointF toPixels(QPointF metres) const { return canvas_->viewportTransform().map(metres); }
  QPointF toMetres(QPointF pixels) const {
    return canvas_->viewportTransform().inverted().map(pixels);
  }
  QRgb paintedAt(QPointF metres) const {
    return canvas_->viewport()->grab().toImage().pixel(toPixels(metres).toPoint());
  }
  QSet<QRgb> coloursIn(QRectF metres) const {
    const QImage image = canvas_->viewport()->grab().toImage();
    const QRect area = canvas_->viewportTransform().mapRect(metres).toRect();
    QSet<QRgb> colours;
    for (int y = area.top(); y <= area.bottom(); ++y)
      for (int x = area.left(); x <= area.right(); ++x) colours.insert(image.pixel(x, y));
    return colours;
  }
  void press(QPointF metres) {
    QTest::mousePress(canvas_->viewport(), Qt::LeftButton, {}, toPixels(metres).toPoint());
  }
  void release(QPointF metres) {
    QTest::mouseRelease(canvas_->viewport(), Qt::LeftButton, {}, toPixels(metres).toPoint());
  }
  void dragMouse(QPointF from, QPointF to) {
    press(from);
    QTest::mouseMove(canvas_->viewport(), toPixels((from + to) / 2.0).toPoint());
    QTest::mouseMove(canvas_->viewport(), toPixels(to).toPoint());
    release(to);
  }
  void wheel(QPoint at, int delta, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QWheelEvent event(at, canvas_->viewport()->mapToGlobal(at), {}, {0, delta}, Qt::NoButton,
                      modifiers, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(canvas_->viewport(), &event);
  }

  std::unique_ptr<MapDocument> document_;
  std::unique_ptr<MapCanvas> canvas_;
  std::unique_ptr<Toolbox> tools_;
};

}  // namespace handmap

QTEST_MAIN(handmap::CanvasTest)
#include "canvas_test.moc"
