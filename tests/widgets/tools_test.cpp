// The tools, driven by events alone: no window.
#include <QSignalSpy>
#include <QTest>

#include "widgets/canvas/building_handles.h"
#include "widgets/tools/edge_rectangle_tool.h"
#include "widgets/tools/eraser_tool.h"
#include "widgets/tools/freehand_tool.h"
#include "widgets/tools/landmark_tool.h"
#include "widgets/tools/measure_tool.h"
#include "widgets/tools/polygon_tool.h"
#include "widgets/tools/rectangle_tool.h"
#include "widgets/tools/route_tool.h"
#include "widgets/tools/select_tool.h"
#include "widgets/tools/start_tool.h"

namespace handmap {

namespace {

constexpr double kScale = 0.1;  // metres per pixel

ToolEvent at(double x, double y, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  ToolEvent event;
  event.position = event.snapped = Vec2(x, y);
  event.metres_per_pixel = kScale;
  event.modifiers = modifiers;
  return event;
}

void click(Tool& tool, double x, double y, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  tool.press(at(x, y, modifiers));
  tool.release(at(x, y, modifiers));
}

void drag(Tool& tool, const Vec2& from, const Vec2& to,
          Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  const Vec2 half = (from + to) / 2.0;
  tool.press(at(from.x(), from.y(), modifiers));
  tool.move(at(half.x(), half.y(), modifiers));
  tool.move(at(to.x(), to.y(), modifiers));
  tool.release(at(to.x(), to.y(), modifiers));
}

Map twoBuildings() {
  Map map;
  Building a;
  a.id = "A";
  a.shape = Rectangle{{0.0, 0.0}, 20.0, 10.0, 0.0};
  Building b;
  b.id = "B";
  b.shape = Rectangle{{50.0, 0.0}, 20.0, 10.0, toRadians(30.0)};
  map.buildings = {a, b};
  map.landmarks = {{"gate", "", {0.0, -30.0}, {}}};
  map.start = Pose2{30.0, -30.0, 0.0};
  return map;
}

void compare(const Rectangle& actual, const Rectangle& expected) {
  QVERIFY2((actual.centre - expected.centre).norm() < 1e-9,
           qPrintable(QStringLiteral("%1 %2").arg(actual.centre.x()).arg(actual.centre.y())));
  QVERIFY2(std::abs(actual.width - expected.width) < 1e-9,
           qPrintable(QString::number(actual.width)));
  QVERIFY2(std::abs(actual.depth - expected.depth) < 1e-9,
           qPrintable(QString::number(actual.depth)));
  QVERIFY2(std::abs(normalizedAngle(actual.heading - expected.heading)) < 1e-9,
           qPrintable(QString::number(actual.heading)));
}

}  // namespace

class ToolsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    document_ = std::make_unique<MapDocument>();
    document_->reset(twoBuildings());
  }

  // --- Rectangle

  void rectangleIsDrawnFromCornerToCorner() {
    RectangleTool tool(*document_);
    QSignalSpy changed(&tool, &Tool::changed);
    drag(tool, {30.0, 20.0}, {10.0, 60.0});
    compare(box("B1"), {{20.0, 40.0}, 20.0, 40.0, 0.0});
    QCOMPARE(document_->selection(), QStringList{"B1"});
    QVERIFY(changed.count() >= 3);
    document_->undoStack().undo();
    QCOMPARE(document_->map(), twoBuildings());
  }

  void rectangleKeepsToModifiers() {
    RectangleTool tool(*document_);
    drag(tool, {0.0, 0.0}, {10.0, -4.0}, Qt::ShiftModifier);
    compare(box("B1"), {{5.0, -5.0}, 10.0, 10.0, 0.0});
    drag(tool, {0.0, 0.0}, {10.0, -4.0}, Qt::ControlModifier);
    compare(box("B2"), {{0.0, 0.0}, 20.0, 8.0, 0.0});
  }

  void tooSmallOrCancelledRectanglesAreNone() {
    RectangleTool tool(*document_);
    QVERIFY(!tool.cancel());
    click(tool, 5.0, 5.0);
    drag(tool, {5.0, 5.0}, {25.0, 5.0});
    tool.press(at(0.0, 0.0));
    tool.move(at(30.0, 30.0));
    QVERIFY(tool.cancel());
    tool.release(at(30.0, 30.0));
    QCOMPARE(document_->undoStack().count(), 0);
  }

  // --- Polygon

  void polygonClosesInThreeWaysCounterClockwise() {
    PolygonTool tool(*document_);
    for (int way = 0; way < 3; ++way) {
      for (const Vec2& p : {Vec2(0, 0), Vec2(0, 10), Vec2(10, 10)}) click(tool, p.x(), p.y());
      if (way == 0) QVERIFY(tool.key({Qt::Key_Return, {}, 1.0}));
      if (way == 1) tool.doubleClick(at(10.0, 10.0));
      if (way == 2) click(tool, 0.2, 0.2);
      const Polygon expected{{10, 10}, {0, 10}, {0, 0}};
      QCOMPARE(std::get<Polygon>(document_->map().buildings.back().shape), expected);
      QCOMPARE(document_->undoStack().count(), way + 1);
    }
  }

  void polygonTakesTheLastCornerBack() {
    PolygonTool tool(*document_);
    QVERIFY(!tool.key({Qt::Key_Backspace, {}, 1.0}));
    for (const Vec2& p : {Vec2(0, 0), Vec2(10, 0), Vec2(99, 99)}) click(tool, p.x(), p.y());
    QVERIFY(tool.key({Qt::Key_Backspace, {}, 1.0}));
    click(tool, 10.0, 10.0);
    tool.key({Qt::Key_Enter, {}, 1.0});
    const Polygon expected{{0, 0}, {10, 0}, {10, 10}};
    QCOMPARE(std::get<Polygon>(document_->map().buildings.back().shape), expected);
  }

  void polygonRefusesToCrossItselfAndSaysSo() {
    PolygonTool tool(*document_);
    const QString first_hint = tool.hint();
    for (const Vec2& p : {Vec2(0, 0), Vec2(10, 0), Vec2(10, 10)}) click(tool, p.x(), p.y());
    const QString hint = tool.hint();
    QVERIFY(hint != first_hint);
    click(tool, 5.0, -5.0);  // would cross the first edge
    QVERIFY(tool.hint() != hint);
    click(tool, 10.0, 5.0);  // back along the last edge
    QVERIFY(tool.hint() != hint);
    tool.key({Qt::Key_Return, {}, 1.0});
    const Polygon expected{{0, 0}, {10, 0}, {10, 10}};
    QCOMPARE(std::get<Polygon>(document_->map().buildings.back().shape), expected);
  }

  void polygonRefusesToCloseAcrossItself() {
    PolygonTool tool(*document_);
    for (const Vec2& p : {Vec2(0, 0), Vec2(10, 0), Vec2(10, 10), Vec2(12, 10), Vec2(12, -5)})
      click(tool, p.x(), p.y());
    tool.key({Qt::Key_Return, {}, 1.0});
    QCOMPARE(document_->undoStack().count(), 1);  // this one is simple
    for (const Vec2& p :
         {Vec2(0, 0), Vec2(10, 0), Vec2(10, 10), Vec2(5, 10), Vec2(5, 5), Vec2(20, 5)})
      click(tool, p.x(), p.y());  // the last crosses and is not taken
    tool.key({Qt::Key_Return, {}, 1.0});
    QCOMPARE(std::get<Polygon>(document_->map().buildings.back().shape).size(), std::size_t(5));
    click(tool, 0.0, 0.0);
    click(tool, 10.0, 0.0);
    tool.key({Qt::Key_Return, {}, 1.0});  // two corners are no building
    QCOMPARE(document_->undoStack().count(), 2);
    QVERIFY(tool.cancel());
  }

  // --- Start, route, landmark

  void startTakesPositionAndHeading() {
    StartTool tool(*document_);
    drag(tool, {1.0, 2.0}, {1.0, 12.0});
    QCOMPARE(document_->map().start->position(), Vec2(1.0, 2.0));
    QCOMPARE(toDegrees(document_->map().start->heading), 90.0);
    click(tool, 5.0, 5.0);  // a click alone keeps the heading
    QCOMPARE(toDegrees(document_->map().start->heading), 90.0);
    drag(tool, {0.0, 0.0}, {10.0, 3.0}, Qt::ShiftModifier);
    QCOMPARE(toDegrees(document_->map().start->heading), 15.0);
    QCOMPARE(document_->undoStack().count(), 3);
    tool.press(at(9.0, 9.0));
    QVERIFY(tool.preview());
    QVERIFY(tool.cancel());
    QVERIFY(!tool.preview());
    QCOMPARE(document_->undoStack().count(), 3);
  }

  void routeGrowsByClicksAndShrinksByBackspace() {
    RouteTool tool(*document_);
    for (const Vec2& p : {Vec2(0, 0), Vec2(5, 0), Vec2(5, 0), Vec2(5, 5)})
      click(tool, p.x(), p.y());
    const std::vector<Vec2> three{{0, 0}, {5, 0}, {5, 5}};
    QCOMPARE(document_->map().route, three);
    QVERIFY(tool.key({Qt::Key_Backspace, {}, 1.0}));
    QCOMPARE(document_->map().route.size(), std::size_t(2));
    document_->undoStack().undo();
    QCOMPARE(document_->map().route, three);
  }

  void landmarkIsSetByAClick() {
    LandmarkTool tool(*document_);
    click(tool, 7.0, 8.0);
    QCOMPARE(document_->map().landmarks.back().position, Vec2(7.0, 8.0));
    QCOMPARE(document_->selection(), QStringList{"L1"});
  }

  // --- Select

  void clickSelectsAndShiftAddsAndTakesAway() {
    SelectTool tool(*document_);
    click(tool, 0.0, 0.0);
    QCOMPARE(document_->selection(), QStringList{"A"});
    click(tool, 50.0, 0.0, Qt::ShiftModifier);
    QCOMPARE(document_->selection(), (QStringList{"A", "B"}));
    click(tool, 0.0, 0.0, Qt::ShiftModifier);
    QCOMPARE(document_->selection(), QStringList{"B"});
    document_->setSelection({"A", "B"});
    click(tool, 0.0, 0.0);
    QCOMPARE(document_->selection(), QStringList{"A"});
    click(tool, 0.0, -30.0);
    QCOMPARE(document_->selection(), QStringList{"gate"});
    click(tool, 25.0, 25.0);
    QVERIFY(document_->selection().isEmpty());
    QCOMPARE(document_->undoStack().count(), 0);
  }

  void theFrameSelectsWhatItTouches() {
    SelectTool tool(*document_);
    drag(tool, {-20.0, -35.0}, {5.0, 20.0});
    QCOMPARE(document_->selection(), (QStringList{"A", "gate"}));
    drag(tool, {45.0, 20.0}, {50.0, -1.0}, Qt::ShiftModifier);
    QCOMPARE(document_->selection(), (QStringList{"A", "gate", "B"}));
    drag(tool, {90.0, 20.0}, {95.0, 30.0});
    QVERIFY(document_->selection().isEmpty());
  }

  void aDragMovesTheWholeSelectionInOneStep() {
    SelectTool tool(*document_);
    document_->setSelection({"A", "gate", kStartKey});
    drag(tool, {1.0, 1.0}, {11.0, 6.0});
    compare(box("A"), {{10.0, 5.0}, 20.0, 10.0, 0.0});
    QCOMPARE(document_->map().landmarks[0].position, Vec2(10.0, -25.0));
    QCOMPARE(document_->map().start->position(), Vec2(40.0, -25.0));
    QCOMPARE(document_->undoStack().count(), 1);
    QCOMPARE(document_->selection().size(), 3);
  }

  void theDragIsPreviewedAndCanBeCancelled() {
    SelectTool tool(*document_);
    tool.press(at(0.0, 0.0));
    tool.move(at(0.2, 0.0));
    QVERIFY(!tool.preview());  // a trembling hand is no drag
    tool.move(at(8.0, 0.0));
    QVERIFY(tool.preview());
    compare(tool.preview()->buildings[0].box(), {{8.0, 0.0}, 20.0, 10.0, 0.0});
    QCOMPARE(document_->map(), twoBuildings());
    QVERIFY(tool.cancel());
    tool.release(at(8.0, 0.0));
    QVERIFY(!tool.preview());
    QCOMPARE(document_->undoStack().count(), 0);
  }

  void handlesResizeInTheBuildingsOwnAxes() {
    SelectTool tool(*document_);
    for (const char* id : {"A", "B"}) {
      document_->setSelection({id});
      const Rectangle before = box(id);
      const Vec2 along = unitVector(before.heading);
      const Vec2 side = handlePosition(before, {1, 0}, kScale);
      drag(tool, side, side + 6.0 * along + 3.0 * perpendicular(along));
      compare(box(id), {before.centre + 3.0 * along, 26.0, 10.0, before.heading});

      const Rectangle wide = box(id);
      const Vec2 corner = handlePosition(wide, {-1, -1}, kScale);
      drag(tool, corner, corner + 2.0 * along + 4.0 * perpendicular(along));
      compare(box(id),
              {wide.centre + along + 2.0 * perpendicular(along), 24.0, 6.0, before.heading});
    }
    QCOMPARE(document_->undoStack().count(), 4);
  }

  void controlResizesAboutTheCentreAndNothingTurnsInsideOut() {
    SelectTool tool(*document_);
    document_->setSelection({"A"});
    const Vec2 top = handlePosition(box("A"), {0, 1}, kScale);
    drag(tool, top, top + Vec2(0.0, 2.0), Qt::ControlModifier);
    compare(box("A"), {{0.0, 0.0}, 20.0, 14.0, 0.0});
    const Vec2 right = handlePosition(box("A"), {1, 0}, kScale);
    drag(tool, right, {-90.0, 0.0});
    compare(box("A"), {{-10.0 + kMinSize / 2.0, 0.0}, kMinSize, 14.0, 0.0});
  }

  void theRoundHandleTurns() {
    SelectTool tool(*document_);
    document_->setSelection({"A"});
    const Vec2 handle = handlePosition(box("A"), {0, 0}, kScale);
    drag(tool, handle, {-30.0, 0.0});
    compare(box("A"), {{0.0, 0.0}, 20.0, 10.0, kPi / 2.0});
    const Vec2 turned_handle = handlePosition(box("A"), {0, 0}, kScale);
    drag(tool, turned_handle, {-30.0, 30.0 * std::tan(toRadians(-20.0))}, Qt::ShiftModifier);
    QCOMPARE(std::round(toDegrees(box("A").heading) * 1e6) / 1e6, 105.0);
  }

  void polygonsAreResizedAsAWhole() {
    Building house;
    house.shape = Polygon{{0, 60}, {20, 60}, {20, 70}, {10, 70}, {10, 75}, {0, 75}};
    document_->setSelection({document_->addBuilding(house)});
    SelectTool tool(*document_);
    const Rectangle before = box("B1");
    const Pose2 frame{before.centre.x(), before.centre.y(), before.heading};
    const Vec2 corner = handlePosition(before, {1, 1}, kScale);
    const Vec2 handle =
        handlePosition(handleFrame(*document_->map().find("B1"), kScale), {1, 1}, kScale);
    drag(tool, handle, handle - corner + frame.toOuter(3.0 * frame.toOwn(corner)));
    QCOMPARE(std::round(box("B1").width * 1e6), std::round(2.0 * before.width * 1e6));
    QCOMPARE(std::round(box("B1").depth * 1e6), std::round(2.0 * before.depth * 1e6));
    QCOMPARE(std::get<Polygon>(document_->map().buildings.back().shape).size(), std::size_t(6));
  }

  void theStartIsTurnedAndARoutePointMoved() {
    SelectTool tool(*document_);
    document_->setSelection({kStartKey});
    const Pose2 start = *document_->map().start;
    drag(tool, startHandle(start, kScale), {30.0, -10.0});
    QCOMPARE(toDegrees(document_->map().start->heading), 90.0);
    QCOMPARE(document_->map().start->position(), start.position());
    document_->setRoute({{0, 80}, {10, 80}, {20, 80}});
    document_->setSelection({kRouteKey});
    drag(tool, {10.0, 80.0}, {12.0, 90.0});
    const std::vector<Vec2> bent{{0, 80}, {12, 90}, {20, 80}};
    QCOMPARE(document_->map().route, bent);
  }

  void arrowKeysNudgeInOneStep() {
    SelectTool tool(*document_);
    QVERIFY(!tool.key({Qt::Key_Left, {}, 0.5}));
    document_->setSelection({"A"});
    for (int i = 0; i < 3; ++i) QVERIFY(tool.key({Qt::Key_Right, {}, 0.5}));
    QVERIFY(tool.key({Qt::Key_Up, Qt::ShiftModifier, 0.5}));
    compare(box("A"), {{1.5, 5.0}, 20.0, 10.0, 0.0});
    QCOMPARE(document_->undoStack().count(), 1);
    QVERIFY(tool.key({Qt::Key_Delete, {}, 0.5}));
    QVERIFY(!document_->map().find("A"));
  }

  void everyToolSaysWhatItDoes() {
    std::vector<std::unique_ptr<Tool>> tools;
    tools.push_back(std::make_unique<SelectTool>(*document_));
    tools.push_back(std::make_unique<RectangleTool>(*document_));
    tools.push_back(std::make_unique<EdgeRectangleTool>(*document_));
    tools.push_back(std::make_unique<PolygonTool>(*document_));
    tools.push_back(std::make_unique<FreehandTool>(*document_));
    tools.push_back(std::make_unique<StartTool>(*document_));
    tools.push_back(std::make_unique<RouteTool>(*document_));
    tools.push_back(std::make_unique<LandmarkTool>(*document_));
    tools.push_back(std::make_unique<MeasureTool>(*document_));
    tools.push_back(std::make_unique<EraserTool>(*document_));
    QSet<QString> hints;
    for (const auto& tool : tools) hints.insert(tool->hint());
    QCOMPARE(hints.size(), 10);
    QVERIFY(!hints.contains(QString()));
  }

 private:
  Rectangle box(const char* id) const { return document_->map().find(id)->box(); }

  std::unique_ptr<MapDocument> document_;
};

}  // namespace handmap

QTEST_GUILESS_MAIN(handmap::ToolsTest)
#include "tools_test.moc"
