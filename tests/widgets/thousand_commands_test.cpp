// A thousand random commands of every kind, taken back and done again at random: the same bytes.
#include <QTest>

#include "core/map/map_io.h"
#include "tests/widgets/random_edits.h"

namespace handmap {

namespace {

constexpr int kCommands = 1000;

/// Takes from the map only what it is told to be others.
void follow(Map& shadow, const Map& map, const Touched& touched) {
  if (touched.listed) {
    shadow.buildings = map.buildings;
  } else {
    for (const std::size_t place : touched.buildings)
      shadow.buildings.at(place) = map.buildings.at(place);
  }
  if (touched.landmarks) shadow.landmarks = map.landmarks;
  if (touched.start) {
    shadow.start = map.start;
    shadow.start_uncertainty = map.start_uncertainty;
  }
  if (touched.route) shadow.route = map.route;
  if (touched.underlays) shadow.underlays = map.underlays;
  if (touched.layers) shadow.layers = map.layers;
  if (!touched.rest) return;
  Map rest = map;
  rest.buildings = std::move(shadow.buildings);
  rest.landmarks = std::move(shadow.landmarks);
  rest.start = shadow.start;
  rest.start_uncertainty = shadow.start_uncertainty;
  rest.route = std::move(shadow.route);
  rest.underlays = std::move(shadow.underlays);
  rest.layers = shadow.layers;
  shadow = std::move(rest);
}

}  // namespace

class ThousandCommandsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void comeBackToTheSameBytes_data() {
    QTest::addColumn<quint32>("seed");
    for (quint32 seed = 1; seed <= 3; ++seed) QTest::addRow("seed %u", seed) << seed;
  }

  void comeBackToTheSameBytes() {
    QFETCH(quint32, seed);
    RandomStream random(seed);
    MapDocument document;
    QUndoStack& undo = document.undoStack();
    const Map empty = document.map();
    Map shadow = empty;
    connect(&document, &MapDocument::mapChanged, this,
            [&](const Touched& touched) { follow(shadow, document.map(), touched); });
    std::vector<Map> after = {empty};  // each number of commands
    while (undo.count() < kCommands) {
      editAtRandom(document, random);
      document.finishMerging();
      QVERIFY(shadow == document.map());
      for (std::size_t i = 0; i < document.map().buildings.size(); ++i) {
        const Bounds box = document.buildingIndex().box(i);
        const Bounds now = boundsOf(document.map().buildings[i]);
        QVERIFY(box.low == now.low && box.high == now.high);
      }
      after.resize(static_cast<std::size_t>(undo.index()));
      after.push_back(document.map());
      QCOMPARE(after.size(), static_cast<std::size_t>(undo.count()) + 1);
      for (const Building& building : document.map().buildings) {
        const Polygon outline = building.footprint();
        QVERIFY(isSimple(outline) && signedArea(outline) > 0.0);
      }
    }
    const std::string bytes = formatMap(document.map());
    for (int i = 0; i < 300; ++i) {
      undo.setIndex(random.index(kCommands + 1));
      QVERIFY(document.map() == after[static_cast<std::size_t>(undo.index())]);
      QVERIFY(shadow == document.map());
    }
    undo.setIndex(0);
    QVERIFY(document.map() == empty);
    QCOMPARE(formatMap(document.map()), formatMap(empty));
    undo.setIndex(undo.count());
    QCOMPARE(formatMap(document.map()), bytes);
  }
};

}  // namespace handmap

QTEST_GUILESS_MAIN(handmap::ThousandCommandsTest)
#include "thousand_commands_test.moc"
