// The document and its commands: what they change, that they can be taken back, and files.
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <memory>
#include <set>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/map/map_io.h"
#include "widgets/document/map_document.h"

namespace handmap {

namespace {

Building rectangle(const std::string& id, double x, double y) {
  Building building;
  building.id = id;
  building.shape = Rectangle{{x, y}, 20.0, 10.0, 0.0};
  return building;
}

Map sampleMap() {
  Map map;
  map.name = "Sample";
  map.start = Pose2{0.0, 0.0, kPi / 2.0};
  map.buildings = {rectangle("N1", 10.0, 25.0), rectangle("N2", 60.0, 25.0)};
  Building polygon;
  polygon.id = "N3";
  polygon.shape = Polygon{{0, 50}, {20, 50}, {20, 60}, {10, 60}, {10, 70}, {0, 70}};
  polygon.unknown["colour"] = "\"red\"";
  map.buildings.push_back(polygon);
  map.landmarks = {{"gate", "Main gate", {0.0, -3.0}, {}}};
  map.route = {{0.0, 0.0}, {60.0, 0.0}};
  return map;
}

const Building& building(const MapDocument& document, const char* id) {
  return *document.map().find(id);
}

QStringList someKeys(const MapDocument& document, RandomStream& random) {
  QStringList keys;
  for (const Building& candidate : document.map().buildings)
    if (random.uniform() < 0.4) keys << QString::fromStdString(candidate.id);
  for (const Landmark& landmark : document.map().landmarks)
    if (random.uniform() < 0.4) keys << QString::fromStdString(landmark.id);
  if (random.uniform() < 0.3) keys << kStartKey << kRouteKey;
  return keys;
}

void editAtRandom(MapDocument& document, RandomStream& random) {
  document.setSelection(someKeys(document, random));
  const QStringList keys = document.selection();
  const Vec2 offset(random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0));
  const bool mergeable = random.uniform() < 0.5;
  switch (random.index(12)) {
    case 0:
      document.addBuilding(rectangle("", offset.x(), offset.y()));
      break;
    case 1:
      document.addLandmark({"", "here", offset, {}});
      break;
    case 2:
      document.removeSelected();
      break;
    case 3:
      document.setStart(random.uniform() < 0.3
                            ? std::nullopt
                            : std::optional(Pose2{offset.x(), offset.y(), random.uniform()}),
                        mergeable);
      break;
    case 4:
      document.setRoute({offset, 2.0 * offset}, mergeable);
      break;
    case 5:
      document.setName(QString::number(offset.x()), mergeable);
      break;
    case 6:
      document.setGeoreference(Georeference{34.0 + random.uniform(), 137.0, 0.0, {}}, mergeable);
      break;
    case 7:
      document.setUnderlays({{"aerial.jpg", offset.x(), 0.0, 0.2, 0.0, 0.5, {}}}, "Underlay");
      break;
    case 8:
      if (!keys.isEmpty()) document.rename(keys.first(), QStringLiteral("R%1").arg(offset.x()));
      break;
    case 9: {
      Map refined = document.map();
      for (Building& b : refined.buildings) {
        b = moved(b, offset);
        b.estimate = Estimate{0.1, 0.2, 0.3, 4};
      }
      refined.refinement = "{\"seed\":1}";
      document.acceptRefinement(refined);
      break;
    }
    default:
      document.apply(moved(selected(document.map(), keys), offset), "Move", mergeable);
  }
}

void expectUniqueIds(const Map& map) {
  std::set<std::string> ids;
  for (const Building& b : map.buildings) QVERIFY(ids.insert(b.id).second);
  for (const Landmark& l : map.landmarks) QVERIFY(ids.insert(l.id).second);
}

}  // namespace

class DocumentTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { document_ = std::make_unique<MapDocument>(); }

  void anySeriesOfEditsCanBeTakenBackAndDoneAgain_data() {
    QTest::addColumn<quint32>("seed");
    for (quint32 seed = 0; seed < 40; ++seed) QTest::addRow("seed %u", seed) << seed;
  }

  void anySeriesOfEditsCanBeTakenBackAndDoneAgain() {
    QFETCH(quint32, seed);
    RandomStream random(seed);
    document_->reset(sampleMap());
    const std::string before = formatMap(document_->map());
    for (int i = 0; i < 60; ++i) {
      const int way = random.index(10);
      if (way == 0)
        document_->undoStack().undo();
      else if (way == 1)
        document_->undoStack().redo();
      else
        editAtRandom(*document_, random);
      expectUniqueIds(document_->map());
    }
    while (document_->undoStack().canRedo()) document_->undoStack().redo();
    const std::string after = formatMap(document_->map());
    QVERIFY(after != before);
    document_->undoStack().setIndex(0);
    QCOMPARE(formatMap(document_->map()), before);
    while (document_->undoStack().canRedo()) document_->undoStack().redo();
    QCOMPARE(formatMap(document_->map()), after);
  }

  void newIdsAreTheFirstFree() {
    Map map;
    map.buildings = {rectangle("B2", 0, 0)};
    map.landmarks = {{"B3", "", {0.0, 0.0}, {}}};
    document_->reset(map);
    QCOMPARE(document_->addBuilding(rectangle("", 0, 0)), "B1");
    QCOMPARE(document_->addBuilding(rectangle("B2", 0, 0)), "B4");
    QCOMPARE(document_->addBuilding(rectangle("Hall", 0, 0)), "Hall");
    QCOMPARE(document_->addLandmark({}), "L1");
  }

  void oneSignalForOneEdit() {
    document_->reset(sampleMap());
    QSignalSpy changed(document_.get(), &MapDocument::mapChanged);
    document_->selectAll();
    QCOMPARE(changed.count(), 0);
    document_->removeSelected();
    QCOMPARE(changed.count(), 1);
    QVERIFY(document_->map().buildings.empty());
    QVERIFY(!document_->map().start);
    QVERIFY(document_->selection().isEmpty());
    document_->undoStack().undo();
    QCOMPARE(changed.count(), 2);
    QCOMPARE(document_->map(), sampleMap());
  }

  void anEditThatChangesNothingIsNoStep() {
    document_->reset(sampleMap());
    document_->apply(selected(document_->map(), {"N1", "gate", kStartKey}), "Move");
    document_->setName("Sample");
    document_->removeSelected();
    QCOMPARE(document_->undoStack().count(), 0);
    QVERIFY(!document_->isModified());
  }

  void typingIsOneStepUntilItIsFinished() {
    document_->reset(sampleMap());
    for (const char* name : {"L", "Li", "Lib"}) {
      Building named = building(*document_, "N1");
      named.name = name;
      document_->changeBuilding("N1", named, "Name", true);
    }
    QCOMPARE(document_->undoStack().count(), 1);
    document_->finishMerging();
    Building named = building(*document_, "N1");
    named.name = "Library";
    document_->changeBuilding("N1", named, "Name", true);
    QCOMPARE(document_->undoStack().count(), 2);
    document_->undoStack().undo();
    QCOMPARE(building(*document_, "N1").name, "Lib");
    document_->undoStack().undo();
    QCOMPARE(building(*document_, "N1").name, "");
  }

  void editsOfDifferentObjectsDoNotMerge() {
    document_->reset(sampleMap());
    for (const char* id : {"N1", "N2", "N1"})
      document_->changeBuilding(id, moved(building(*document_, id), Vec2(1.0, 0.0)), "Move", true);
    QCOMPARE(document_->undoStack().count(), 3);
  }

  void refinementIsOneStepAndLeavesTheRest() {
    document_->reset(sampleMap());
    Map refined = document_->map();
    refined.name = "not this";
    for (Building& b : refined.buildings) {
      b = moved(b, Vec2(1.0, 2.0));
      b.name = "nor this";
      b.estimate = Estimate{0.1, 0.2, 0.3, 7};
    }
    refined.buildings.push_back(rectangle("unknown", 0.0, 0.0));
    refined.refinement = "{\"seed\":1}";
    document_->setSelection({"N2"});
    document_->removeSelected();  // the drawing went on while the run ran
    document_->acceptRefinement(refined);

    QCOMPARE(document_->undoStack().count(), 2);
    QCOMPARE(document_->map().buildings.size(), std::size_t(2));
    QCOMPARE(building(*document_, "N1").box().centre, Vec2(11.0, 27.0));
    QCOMPARE(building(*document_, "N1").estimate->observations, 7);
    QCOMPARE(building(*document_, "N1").name, "");
    QCOMPARE(document_->map().name, "Sample");
    QCOMPARE(document_->map().refinement, refined.refinement);
    document_->undoStack().setIndex(0);
    QCOMPARE(document_->map(), sampleMap());
  }

  void aNewShapeDropsTheEstimateOfTheOld() {
    Map map = sampleMap();
    map.buildings[0].estimate = Estimate{0.1, 0.2, 0.3, 7};
    document_->reset(map);
    Building named = building(*document_, "N1");
    named.name = "Library";
    document_->changeBuilding("N1", named, "Name");
    QVERIFY(building(*document_, "N1").estimate.has_value());
    document_->changeBuilding("N1", moved(named, Vec2(1.0, 0.0)), "Move");
    QVERIFY(!building(*document_, "N1").estimate.has_value());
    document_->undoStack().undo();
    QVERIFY(building(*document_, "N1").estimate.has_value());
  }

  void renamingKeepsIdsUniqueAndTheSelection() {
    document_->reset(sampleMap());
    document_->setSelection({"N1"});
    for (const char* bad : {"", "  ", "N2", "gate", "@start", "N1"})
      QVERIFY2(!document_->rename("N1", bad), bad);
    QVERIFY(!document_->rename("absent", "X"));
    QCOMPARE(document_->undoStack().count(), 0);
    QVERIFY(document_->rename("N1", "Library"));
    QCOMPARE(document_->selection(), QStringList{"Library"});
    QVERIFY(document_->map().find("Library"));
    document_->undoStack().undo();
    QVERIFY(document_->selection().isEmpty());
  }

  void selectionHoldsOnlyWhatExistsAndOnce() {
    document_->reset(sampleMap());
    QSignalSpy spy(document_.get(), &MapDocument::selectionChanged);
    document_->setSelection({"N1", "absent", "N1", kStartKey});
    QCOMPARE(document_->selection(), (QStringList{"N1", kStartKey}));
    document_->setSelection({"N1", kStartKey});
    QCOMPARE(spy.count(), 1);
    document_->setStart(std::nullopt);
    QCOMPARE(document_->selection(), QStringList{"N1"});
  }

  void savesAndOpens() {
    QTemporaryDir folder;
    const QString path = folder.filePath("drawn map – näh.handmap");
    document_->reset(sampleMap());
    QCOMPARE(document_->displayName(), "Sample");
    document_->setName("Other");
    QVERIFY(document_->isModified());
    QSignalSpy file_changed(document_.get(), &MapDocument::fileChanged);
    document_->save(path);
    QVERIFY(file_changed.count() > 0);
    QVERIFY(!document_->isModified());
    QCOMPARE(document_->filePath(), path);
    QCOMPARE(document_->displayName(), "drawn map – näh.handmap");
    document_->undoStack().undo();
    QVERIFY(document_->isModified());

    MapDocument other;
    other.open(path);
    QCOMPARE(other.map().name, "Other");
    QCOMPARE(other.undoStack().count(), 0);
  }

  void aFailedOpenOrSaveChangesNothing() {
    QTemporaryDir folder;
    document_->reset(sampleMap(), folder.filePath("mine.handmap"));
    document_->setName("Edited");
    QVERIFY_THROWS_EXCEPTION(Error, document_->open(folder.filePath("absent.handmap")));
    QVERIFY_THROWS_EXCEPTION(Error, document_->save(folder.filePath("no/such/folder.handmap")));
    QCOMPARE(document_->map().name, "Edited");
    QCOMPARE(document_->filePath(), folder.filePath("mine.handmap"));
    QVERIFY(document_->isModified());
  }

  void picturesAreStillFoundFromAnotherFolder() {
    QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkpath("a") && QDir(folder.path()).mkpath("b"));
    const std::string saved = folder.filePath("b/m.handmap").toStdString();
    const std::vector<Underlay> drawn = {{"aerial.jpg", 0, 0, 0.2, 0, 1, {}},
                                         {"/abs.png", 0, 0, 0.2, 0, 1, {}}};
    Map map = sampleMap();
    map.underlays = drawn;
    document_->reset(map, folder.filePath("a/m.handmap"));
    std::vector<Underlay> faint = drawn;
    faint[0].opacity = 0.5;
    document_->setUnderlays(faint, "Fade");
    document_->save(folder.filePath("b/m.handmap"));
    QVERIFY(!document_->isModified());
    QCOMPARE(readMap(saved).underlays[0].image, "../a/aerial.jpg");
    QCOMPARE(readMap(saved).underlays[1].image, "/abs.png");

    // A step from before the drawing moved still means the same picture.
    document_->undoStack().undo();
    QVERIFY(document_->isModified());
    document_->save(folder.filePath("b/m.handmap"));
    QCOMPARE(readMap(saved).underlays[0].image, "../a/aerial.jpg");
    QCOMPARE(readMap(saved).underlays[0].opacity, 1.0);
    document_->save(folder.filePath("a/m.handmap"));
    QCOMPARE(readMap(folder.filePath("a/m.handmap").toStdString()).underlays, drawn);
  }

  void whatWasEditedDuringARunIsKnownAndCanBeKept() {
    document_->reset(sampleMap());
    const Map given = document_->map();
    Map refined = given;
    for (Building& corrected : refined.buildings) {
      corrected = moved(corrected, Vec2(2.0, 0.0));
      corrected.estimate = Estimate{0.1, 0.1, 0.1, 5};
    }
    Building edited = moved(building(*document_, "N1"), Vec2(0.0, 7.0));
    document_->changeBuilding("N1", edited, "Move");
    QCOMPARE(document_->editedSince(given), QStringList{"N1"});
    document_->acceptRefinement(refined, document_->editedSince(given));
    QCOMPARE(building(*document_, "N1").shape, edited.shape);
    QCOMPARE(building(*document_, "N2").shape, refined.find("N2")->shape);
    QCOMPARE(document_->editedSince(given), QStringList{"N1"});
    document_->acceptRefinement(refined);
    QCOMPARE(building(*document_, "N1").shape, refined.find("N1")->shape);
    QVERIFY2(document_->editedSince(given).isEmpty(), "what a run corrected nobody has edited");
    const int steps = document_->undoStack().count();
    document_->acceptRefinement(refined);
    QCOMPARE(document_->undoStack().count(), steps);  // it is in the drawing already
  }

  void aDoubtGoesWithItsShape() {
    Map map = sampleMap();
    map.buildings[0].doubt = 0.40;
    map.buildings[1].doubt = 0.50;
    document_->reset(map);
    Map refined = map;
    refined.buildings[0].doubt.reset();
    refined.buildings[1].doubt = 0.90;
    document_->acceptRefinement(refined);
    QVERIFY(!building(*document_, "N1").doubt);
    QCOMPARE(building(*document_, "N2").doubt.value_or(0.0), 0.9);
    document_->changeBuilding("N2", moved(building(*document_, "N2"), Vec2(1.0, 0.0)), "Move");
    QVERIFY(!building(*document_, "N2").doubt);
    document_->undoStack().undo();
    document_->undoStack().undo();
    QCOMPARE(document_->map(), map);
  }

 private:
  std::unique_ptr<MapDocument> document_;
};

}  // namespace handmap

QTEST_GUILESS_MAIN(handmap::DocumentTest)
#include "document_test.moc"
