// Drawing by keys, by typed numbers and in one stroke.
#include <QSignalSpy>
#include <QTest>

#include "tests/widgets/tool_events.h"
#include "widgets/tools/edge_rectangle_tool.h"
#include "widgets/tools/eraser_tool.h"
#include "widgets/tools/freehand_tool.h"
#include "widgets/tools/landmark_tool.h"
#include "widgets/tools/measure_tool.h"
#include "widgets/tools/polygon_tool.h"
#include "widgets/tools/rectangle_tool.h"
#include "widgets/tools/route_tool.h"
#include "widgets/tools/start_tool.h"

namespace handmap {

class DrawingToolsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { document_ = std::make_unique<MapDocument>(); }

  void aRectangleByTwoClicksAndByTypedSize() {
    RectangleTool tool(*document_);
    QSignalSpy created(&tool, &Tool::created);
    click(tool, {0, 0});
    click(tool, {20, -10});
    QCOMPARE(box(0), (Rectangle{{10, -5}, 20, 10, 0}));
    QCOMPARE(created.last()[0].toString(), "B1");
    click(tool, {0, 0});
    tool.move(at({-3, 2}));  // to which side
    type(tool, "40\t15\n");
    QCOMPARE(box(1), (Rectangle{{-20, 7.5}, 40, 15, 0}));
    QCOMPARE(document_->undoStack().count(), 2);
  }

  void numbersCanBeTakenBackAndAreNeverHalfUsed() {
    RectangleTool tool(*document_);
    click(tool, {0, 0});
    tool.move(at({5, 5}));
    type(tool, "4");
    key(tool, Qt::Key_Backspace);
    type(tool, "12,5\t");
    QVERIFY(!tool.wants(u'r'));
    type(tool, "7\n");
    QCOMPARE(box(0), (Rectangle{{6.25, 3.5}, 12.5, 7, 0}));
    click(tool, {0, 0});
    type(tool, "0\t5\n");
    QCOMPARE(document_->undoStack().count(), 1);  // nothing is 0 m wide
    QVERIFY(tool.isBusy());
    for (int i = 0; i < 20; ++i) type(tool, "9");
    type(tool, "\n");
    for (const Building& building : document_->map().buildings)
      QVERIFY(building.box().width <= 1e5);
  }

  void aRectangleByKeysAlone() {
    RectangleTool tool(*document_);
    QVERIFY(!tool.keyboardCursor());
    key(tool, Qt::Key_Right);
    QVERIFY(tool.keyboardCursor());
    key(tool, Qt::Key_Up, Qt::ShiftModifier);
    key(tool, Qt::Key_Return);
    key(tool, Qt::Key_Right, Qt::ShiftModifier);
    for (int i = 0; i < 5; ++i) key(tool, Qt::Key_Up);
    key(tool, Qt::Key_Left, Qt::ControlModifier);
    key(tool, Qt::Key_Return);
    QCOMPARE(box(0), (Rectangle{{1 + 4.95, 12.5}, 9.9, 5, 0}));
  }

  void theFirstCornerCanBeTypedToo() {
    RectangleTool tool(*document_);
    type(tool, "20\t10");
    type(tool, "-\n");
    type(tool, "8\t4\n");
    QCOMPARE(box(0), (Rectangle{{24, -8}, 8, 4, 0}));
  }

  void aRectangleByEdgeAndDepth() {
    EdgeRectangleTool tool(*document_);
    drag(tool, {0, 0}, {30, 40});
    QCOMPARE(document_->undoStack().count(), 0);
    click(tool, {30 - 8, 40 + 6});  // ten to the left
    const Rectangle drawn = box(0);
    QVERIFY(std::abs(drawn.width - 50) < 1e-9 && std::abs(drawn.depth - 10) < 1e-9);
    QVERIFY((drawn.centre - Vec2(15 - 4, 20 + 3)).norm() < 1e-9);
    click(tool, {0, 0});
    type(tool, "20\t90\n");
    tool.move(at({5, 5}));  // to the right
    type(tool, "6\n");
    QVERIFY((box(1).centre - Vec2(3, 10)).norm() < 1e-6);
    QCOMPARE(std::round(toDegrees(box(1).heading)), 90.0);
    click(tool, {0, 0});
    QVERIFY(tool.canTakeBack());
    tool.takeBack();
    QVERIFY(!tool.isBusy());
  }

  void aPolygonByKeysClosesWithASecondEnter() {
    PolygonTool tool(*document_);
    key(tool, Qt::Key_Right);
    for (const int code : {Qt::Key_Return, Qt::Key_Right, Qt::Key_Return, Qt::Key_Up}) {
      if (code == Qt::Key_Return)
        key(tool, code);
      else
        key(tool, code, Qt::ShiftModifier);
    }
    QVERIFY(!tool.canFinish());
    key(tool, Qt::Key_Return);
    QVERIFY(tool.canFinish());
    key(tool, Qt::Key_Return);
    const Polygon expected{{1, 0}, {11, 0}, {11, 10}};
    QCOMPARE(std::get<Polygon>(document_->map().buildings[0].shape), expected);
  }

  void aPolygonByTypedLengthsAndAngles() {
    PolygonTool tool(*document_);
    click(tool, {0, 0});
    type(tool, "20\t0\n");
    type(tool, "10\t90\n");
    type(tool, "20\t180\n");
    QVERIFY(tool.canFinish());
    tool.finish();
    const Polygon expected{{0, 0}, {20, 0}, {20, 10}, {0, 10}};
    QCOMPARE(std::get<Polygon>(document_->map().buildings[0].shape), expected);
  }

  void aSecondFingerTakesNothingButItsOwnStroke() {
    PolygonTool tool(*document_);
    click(tool, {0, 0});
    click(tool, {10, 0});
    tool.press(at({10, 5}));
    tool.interrupt();
    tool.release(at({10, 5}));
    click(tool, {10, 10});
    QVERIFY(tool.canFinish());
    tool.finish();
    QCOMPARE(document_->map().buildings[0].footprint().size(), std::size_t(3));
    RectangleTool rectangle(*document_);
    rectangle.press(at({0, 0}));
    rectangle.interrupt();
    QVERIFY(!rectangle.isBusy());
  }

  void startByKeysAndTypedHeading() {
    StartTool tool(*document_);
    type(tool, "3\t4\n");
    type(tool, "33.3\n");
    QCOMPARE(document_->map().start->position(), Vec2(3, 4));
    QVERIFY(std::abs(toDegrees(document_->map().start->heading) - 33.3) < 1e-9);
    key(tool, Qt::Key_Right);
    key(tool, Qt::Key_Return);
    key(tool, Qt::Key_Up, Qt::ShiftModifier);
    key(tool, Qt::Key_Return);
    QCOMPARE(std::round(toDegrees(document_->map().start->heading)), 90.0);
  }

  void routeAndLandmarkByKeys() {
    RouteTool route(*document_);
    key(route, Qt::Key_Right);
    key(route, Qt::Key_Return);
    key(route, Qt::Key_Right, Qt::ShiftModifier);
    key(route, Qt::Key_Return);
    const std::vector<Vec2> way{{1, 0}, {11, 0}};
    QCOMPARE(document_->map().route, way);
    QSignalSpy finished(&route, &Tool::finished);
    key(route, Qt::Key_Return);
    QCOMPARE(finished.count(), 1);
    LandmarkTool landmark(*document_);
    type(landmark, "7\t8\n");
    QCOMPARE(document_->map().landmarks[0].position, Vec2(7, 8));
  }

  void measuringChangesNothingAndStaysToBeRead() {
    MeasureTool tool(*document_);
    click(tool, {0, 0});
    click(tool, {10, 0});
    click(tool, {10, 10});
    tool.doubleClick(at({10, 10}));
    QVERIFY(!tool.isBusy());
    QVERIFY(tool.cancel());  // what was measured goes
    QVERIFY(!tool.cancel());
    QCOMPARE(document_->undoStack().count(), 0);
  }

  void theEraserTakesWhatItTouchesInOneStep() {
    for (int i = 0; i < 4; ++i) {
      Building building;
      building.shape = Rectangle{{20.0 * i, 0}, 10, 10, 0};
      building.flags.locked = i == 2;
      document_->addBuilding(building);
    }
    const Map before = document_->map();
    EraserTool tool(*document_);
    drag(tool, {-10, 0}, {42, 0});
    QCOMPARE(document_->map().buildings.size(), std::size_t(2));  // the locked one and the last
    QVERIFY(document_->map().find("B3") && document_->map().find("B4"));
    document_->undoStack().undo();
    QCOMPARE(document_->map(), before);
    tool.press(at({0, 0}));
    QVERIFY(tool.cancel());
    QCOMPARE(document_->map(), before);
  }

  void aStrokeIsGuessedAndTwoUndosTakeItAway() {
    FreehandTool tool(*document_);
    stroke(tool, {{0, 0}, {40, 1}, {40.5, 20}, {-0.5, 19}});
    QVERIFY(tool.guess());
    QCOMPARE(tool.guess()->kind, StrokeShape::Rectangular);
    QVERIFY(tool.canFinish());
    key(tool, Qt::Key_Return);
    QVERIFY(std::holds_alternative<Rectangle>(document_->map().buildings[0].shape));
    QVERIFY(!tool.isBusy());
    document_->undoStack().undo();
    QVERIFY(std::holds_alternative<Polygon>(document_->map().buildings[0].shape));
    document_->undoStack().undo();
    QVERIFY(document_->map().buildings.empty());
  }

  void tabGoesThroughTheGuesses() {
    FreehandTool tool(*document_);
    stroke(tool, {{0, 0}, {40, 0}, {40, 14}, {20, 15}, {20, 30}, {0, 30}});
    QCOMPARE(tool.guess()->kind, StrokeShape::LShaped);
    const ShapeGuess* first = tool.guess();
    QVERIFY(key(tool, Qt::Key_Tab));
    QVERIFY(tool.guess() != first);
    QVERIFY(key(tool, Qt::Key_Backtab));
    QCOMPARE(tool.guess(), first);
    stroke(tool, {{60, 0}, {90, 0}, {75, 25}});  // drawing on takes the guess
    QCOMPARE(document_->map().buildings[0].footprint().size(), std::size_t(6));
    QVERIFY(tool.cancel());  // and Escape leaves the stroke as it is
    QVERIFY(document_->map().buildings[1].footprint().size() >= 3);
    QCOMPARE(document_->undoStack().count(), 3);
  }

  void guessesSurviveWhatHappensMeanwhile() {
    FreehandTool tool(*document_);
    stroke(tool, {{0, 0}, {40, 0}, {40, 20}, {0, 20}});
    document_->undoStack().undo();
    QVERIFY(!tool.guess());
    key(tool, Qt::Key_Return);
    tool.finish();
    QVERIFY(document_->map().buildings.empty());
    tool.setRecognizing(false);
    stroke(tool, {{0, 0}, {40, 0}, {40, 20}, {0, 20}});
    QVERIFY(!tool.guess());
    QCOMPARE(document_->map().buildings.size(), std::size_t(1));
    const QString hint = tool.hint();
    drag(tool, {100, 100}, {101, 100});  // a line encloses nothing
    QVERIFY(tool.hint() != hint);
    QCOMPARE(document_->map().buildings.size(), std::size_t(1));
  }

 private:
  Rectangle box(std::size_t i) const {
    return std::get<Rectangle>(document_->map().buildings.at(i).shape);
  }
  static void stroke(Tool& tool, const Polygon& around) {
    tool.press(at(around.front()));
    for (std::size_t i = 0; i < around.size(); ++i) {
      const Vec2 way = around[(i + 1) % around.size()] - around[i];
      for (int k = 0; k < 30; ++k) tool.move(at(around[i] + way * k / 30.0));
    }
    tool.release(at(around.front()));
  }

  std::unique_ptr<MapDocument> document_;
};

}  // namespace handmap

QTEST_GUILESS_MAIN(handmap::DrawingToolsTest)
#include "drawing_tools_test.moc"
