// Corners, arranging and the clipboard.
#include <QSignalSpy>
#include <QTest>

#include "core/base/error.h"
#include "tests/widgets/tool_events.h"
#include "widgets/canvas/building_handles.h"
#include "widgets/editing/arranging.h"
#include "widgets/editing/clipboard.h"
#include "widgets/tools/corner_handles.h"
#include "widgets/tools/select_tool.h"

namespace handmap {

namespace {

const Polygon kL = {{0, 0}, {20, 0}, {20, 10}, {10, 10}, {10, 16}, {0, 16}};

Building building(const std::string& id, std::variant<Rectangle, Polygon> shape) {
  Building result;
  result.id = id;
  result.name = "House " + id;
  result.shape = std::move(shape);
  return result;
}

Map town() {
  Map map;
  map.buildings = {building("L", kL), building("A", Rectangle{{60, 5}, 20, 10, 0}),
                   building("B", Rectangle{{90, 11}, 10, 6, toRadians(4)}),
                   building("C", Rectangle{{130, -3}, 16, 8, toRadians(30)})};
  map.landmarks = {{"gate", "Gate", {0, -20}, {}}};
  map.route = {{0, -5}, {50, -5}, {100, -5}};
  return map;
}

}  // namespace

class EditingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    document_ = std::make_unique<MapDocument>();
    document_->reset(town());
    tool_ = std::make_unique<SelectTool>(*document_);
  }

  // --- Corners

  void aCornerOfAPolygonIsDragged() {
    document_->setSelection({"L"});
    drag(*tool_, {20, 10}, {22, 12});
    QCOMPARE(outline()[2], Vec2(22, 12));
    QCOMPARE(outline().size(), std::size_t(6));
    document_->undoStack().undo();
    QCOMPARE(document_->map(), town());
  }

  void theDotOnAnEdgeMakesACorner() {
    document_->setSelection({"L"});
    drag(*tool_, {10, 0}, {10, -4});
    QCOMPARE(outline().size(), std::size_t(7));
    QCOMPARE(outline()[1], Vec2(10, -4));
    QVERIFY(tool_->chosenCorner());
    QVERIFY(key(*tool_, Qt::Key_Delete));
    QCOMPARE(outline(), kL);
  }

  void aCornerThatWouldCrossStaysWhereItWasLast() {
    document_->setSelection({"L"});
    tool_->press(at({10, 10}));
    tool_->move(at({12, 9}));
    const QString hint = tool_->hint();
    tool_->move(at({30, -8}));
    QVERIFY(tool_->hint() != hint);
    tool_->release(at({30, -8}));
    QCOMPARE(outline()[3], Vec2(12, 9));
  }

  void cornersByKeys() {
    document_->setSelection({"L"});
    QVERIFY(key(*tool_, Qt::Key_Return));
    QVERIFY(key(*tool_, Qt::Key_Tab));
    QCOMPARE(*tool_->chosenCorner(), std::size_t(1));
    key(*tool_, Qt::Key_Right, Qt::ShiftModifier);
    QCOMPARE(outline()[1], Vec2(21, 0));
    QVERIFY(key(*tool_, Qt::Key_Insert));
    QCOMPARE(outline().size(), std::size_t(7));
    QVERIFY(key(*tool_, Qt::Key_Backspace));
    QCOMPARE(outline().size(), std::size_t(6));
    key(*tool_, Qt::Key_Return);
    QVERIFY(tool_->cancel());
    QVERIFY(!tool_->chosenCorner());
    QVERIFY(!tool_->cancel());
    QCOMPARE(document_->selection(), QStringList{"L"});
  }

  void aTriangleKeepsItsCorners() {
    Map map;
    map.buildings = {building("T", Polygon{{0, 0}, {9, 0}, {0, 9}})};
    document_->reset(map);
    document_->setSelection({"T"});
    key(*tool_, Qt::Key_Return);
    QVERIFY(!tool_->removeChosenCorner());
    QVERIFY(!key(*tool_, Qt::Key_Delete));
    QCOMPARE(document_->map().buildings.size(), std::size_t(1));
  }

  void aDoubleClickOnAWallAddsACornerAlsoToARectangle() {
    document_->setSelection({"L"});
    tool_->doubleClick(at({5, 0}));
    QCOMPARE(outline().size(), std::size_t(7));
    document_->setSelection({"A"});
    QVERIFY(tool_->addCornerAt({55, 0.1}, 0.5));
    QCOMPARE(document_->map().find("A")->footprint().size(), std::size_t(5));
    document_->setSelection({kRouteKey});
    QVERIFY(tool_->addCornerAt({25, -5}, 0.5));
    QCOMPARE(document_->map().route.size(), std::size_t(4));
    QVERIFY(tool_->removeChosenCorner());
    QCOMPARE(document_->map().route, town().route);
  }

  void undoInTheMiddleOfADragDoesNoHarm() {
    document_->setSelection({"L"});
    tool_->addCornerAt({5, 0}, 0.5);
    tool_->press(at(outline().back()));
    tool_->move(at({-3, 18}));
    document_->undoStack().undo();
    tool_->move(at({-4, 19}));
    tool_->release(at({-4, 19}));
    QVERIFY(isSimple(outline()));
    document_->setSelection({"A"});
    QVERIFY(!tool_->chosenCorner());
  }

  void theLockedStays() {
    Map map = town();
    map.buildings[1].flags.locked = true;
    document_->reset(map);
    document_->setSelection({"A", "B"});
    key(*tool_, Qt::Key_Right);
    QCOMPARE(document_->map().find("A")->box(), town().find("A")->box());
    QVERIFY(document_->map().find("B")->box() != town().find("B")->box());
    document_->setSelection({"A"});
    drag(*tool_, {60, 5}, {70, 5});
    QCOMPARE(document_->map().find("A")->box(), town().find("A")->box());
    QCOMPARE(document_->selection(), QStringList{"A"});
    document_->removeSelected();
    QVERIFY(document_->map().find("A"));
    document_->setSelection({"A", "B"});
    document_->removeSelected();
    QVERIFY(document_->map().find("A") && !document_->map().find("B"));
  }

  void whatIsFixedForRunsIsNotLocked() {
    Map map = town();
    map.buildings[1].fixed = true;
    document_->reset(map);
    document_->setSelection({"A"});
    key(*tool_, Qt::Key_Right);
    QVERIFY(document_->map().find("A")->box() != town().find("A")->box());
  }

  void nothingOfALockedLayerIsDeleted() {
    Map map = town();
    map.layers[static_cast<std::size_t>(DrawingLayer::Buildings)].locked = true;
    document_->reset(map);
    document_->selectAll();
    document_->removeSelected();
    QCOMPARE(document_->map().buildings.size(), map.buildings.size());
  }

  void tabGoesThroughEverythingAndOut() {
    QStringList seen;
    while (key(*tool_, Qt::Key_Tab)) seen << document_->selection();
    QCOMPARE(seen, (QStringList{"L", "A", "B", "C", "gate", kRouteKey}));
    QVERIFY(document_->selection().isEmpty());
    QVERIFY(key(*tool_, Qt::Key_Backtab));
    QCOMPARE(document_->selection(), QStringList{kRouteKey});
  }

  // --- Arranging

  void alignsTheSides() {
    const Map map = town();
    const QStringList keys = {"L", "A", "gate"};
    const MapChange left = aligned(map, keys, Alignment::Left);
    for (const Building& one : left.buildings) QCOMPARE(boundsOf(one).low.x(), 0.0);
    const MapChange top = aligned(map, keys, Alignment::Top);
    for (const Building& one : top.buildings) QCOMPARE(boundsOf(one).high.y(), 16.0);
    QCOMPARE(top.landmarks[0].position, Vec2(0, 16));
    const MapChange middle = aligned(map, keys, Alignment::CentreX);
    for (const Building& one : middle.buildings)
      QCOMPARE(boundsOf(one).low.x() + boundsOf(one).high.x(), 70.0);
    QVERIFY(aligned(map, {"L"}, Alignment::Left).isEmpty());
  }

  void distributesTheGaps() {
    Map map = town();
    map.buildings[3].shape = Rectangle{{130, -3}, 16, 8, 0};
    map.buildings[2].shape = Rectangle{{84, 11}, 10, 6, 0};
    const MapChange change = distributed(map, {"L", "A", "B", "C"}, Along::X);
    QCOMPARE(change.buildings.size(), std::size_t(2));
    // 138 m with 66 m of buildings: three gaps
    const double gap = (138.0 - 66.0) / 3.0;
    QVERIFY(std::abs(boundsOf(change.buildings[0]).low.x() - (20.0 + gap)) < 1e-9);
    QVERIFY(std::abs(boundsOf(change.buildings[1]).low.x() - (40.0 + 2.0 * gap)) < 1e-9);
  }

  void squaresUpAndMakesParallel() {
    Map map = town();
    map.buildings[0].shape = Polygon{{0, 0}, {20, 0.5}, {20, 10}, {10.4, 10}, {10, 16}, {0, 15.7}};
    const MapChange squared = squaredUp(map, {"L", "B", "C"});
    const auto& corners = std::get<Polygon>(squared.buildings[0].shape);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2 in = corners[(i + 1) % 6] - corners[i];
      const Vec2 out = corners[(i + 2) % 6] - corners[(i + 1) % 6];
      QVERIFY(std::abs(in.dot(out)) < 1e-9);
    }
    QCOMPARE(squared.buildings[1].box().heading, 0.0);
    QCOMPARE(squared.buildings[2].box().heading, toRadians(30));  // meant so
    const MapChange parallel = madeParallel(map, {"C"});
    QVERIFY(std::abs(parallel.buildings[0].box().heading - toRadians(4)) < 1e-9);
    // Of several the largest leads, or what is locked.
    const MapChange all = madeParallel(map, {"A", "B", "C"});
    for (const Building& building : all.buildings) QCOMPARE(building.box().heading, 0.0);
    map.buildings[3].flags.locked = true;
    const MapChange led = madeParallel(map, {"A", "C"});
    QCOMPARE(led.buildings.size(), std::size_t(1));
    QVERIFY(std::abs(led.buildings[0].box().heading - toRadians(30)) < 1e-9);
  }

  void turnsMirrorsAndRepeats() {
    const Map map = town();
    const QStringList keys = {"L", "A", "gate"};
    const auto turned = [&](const MapChange& change) {
      Map other = map;
      for (const Building& building : change.buildings)
        *std::ranges::find(other.buildings, building.id, &Building::id) = building;
      if (!change.landmarks.empty()) other.landmarks = change.landmarks;
      return other;
    };
    Map now = turned(turnedByQuarter(map, keys, true));
    QVERIFY(now.buildings[1].box().heading != map.buildings[1].box().heading);
    now = turned(turnedByQuarter(now, keys, false));
    QVERIFY((now.buildings[1].box().centre - map.buildings[1].box().centre).norm() < 1e-9);
    QVERIFY((now.landmarks[0].position - map.landmarks[0].position).norm() < 1e-9);
    now = turned(mirrored(map, {"L"}, Along::X));
    const auto& l = std::get<Polygon>(now.buildings[0].shape);
    QVERIFY(signedArea(l) > 0.0);
    QVERIFY(!contains(l, Vec2(5.0, 13.0)) && contains(l, Vec2(15.0, 13.0)));
    const Building c = mirrored(map, {"C"}, Along::Y).buildings[0];
    QVERIFY(std::abs(c.box().heading + toRadians(30)) < 1e-9);
    const MapChange copies = arrayed(map, {"A"}, 3, 2, {25.0, 15.0});
    QCOMPARE(copies.buildings.size(), std::size_t(5));
    QCOMPARE(copies.buildings[4].box().centre, Vec2(110.0, 20.0));
  }

  void locksAndUnlocks() {
    const MapChange locked = lockToggled(town(), {"A", "B"});
    QVERIFY(locked.buildings[0].flags.locked && locked.buildings[1].flags.locked);
    QVERIFY(!locked.buildings[0].fixed);  // a run may still move it
    document_->apply(locked, "Lock");
    QVERIFY(!lockToggled(document_->map(), {"A", "B"}).buildings[0].flags.locked);
    QVERIFY(lockToggled(document_->map(), {"A", "C"}).buildings[1].flags.locked);
  }

  // --- Clipboard

  void objectsComeThroughTheClipboardAsTheyWere() {
    const auto data = clipboardData(town(), {"L", "B", "gate", kRouteKey});
    const MapChange objects = objectsOf(*data);
    QCOMPARE(objects.buildings.size(), std::size_t(2));
    QCOMPARE(objects.buildings[0], town().buildings[0]);
    QCOMPARE(objects.landmarks, town().landmarks);
    QCOMPARE(*objects.route, town().route);
    QMimeData plain;  // as it comes from an editor
    plain.setText(data->text());
    QCOMPARE(objectsOf(plain).buildings.size(), std::size_t(2));
  }

  void copiesGetIdsAndNamesOfTheirOwn() {
    const MapChange copies = copiesFor(town(), selected(town(), {"L", "A", "gate", kRouteKey}));
    const QStringList keys = document_->add(copies, "Paste");
    QCOMPARE(keys, (QStringList{"B1", "B2", "L1"}));  // there is a route already
    QCOMPARE(document_->map().find("B1")->name, std::string());
    QCOMPARE(document_->undoStack().count(), 1);
    document_->undoStack().undo();
    QCOMPARE(document_->map(), town());
    MapDocument empty;
    const QStringList first = empty.add(copiesFor(empty.map(), copies), "Paste");
    QCOMPARE(first, (QStringList{"L", "A", "gate", kRouteKey}));
  }

  void pastedThingsLieWhereTheyShould() {
    const MapChange placed = centredAt(selected(town(), {"A"}), {-30, 7});
    QCOMPARE(placed.buildings[0].box().centre, Vec2(-30, 7));
  }

  void nonsenseOnTheClipboardIsSaid() {
    for (const char* text : {"", "hello", "{", "{\"format\":\"handmap\",\"version\":99}",
                             "{\"format\":\"handmap\",\"version\":1,\"buildings\":[{}]}"}) {
      QMimeData data;
      data.setText(QString::fromUtf8(text));
      QVERIFY_THROWS_EXCEPTION(Error, objectsOf(data));
    }
  }

 private:
  Polygon outline() const { return document_->map().find("L")->footprint(); }

  std::unique_ptr<MapDocument> document_;
  std::unique_ptr<SelectTool> tool_;
};

}  // namespace handmap

QTEST_GUILESS_MAIN(handmap::EditingTest)
#include "editing_test.moc"
