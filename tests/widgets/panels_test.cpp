// The property panel and the list of objects, with real keys.
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QSlider>
#include <QStackedWidget>
#include <QTableWidget>
#include <QTest>
#include <QTreeView>
#include <QTreeWidget>
#include <memory>

#include "core/map/map_io.h"
#include "widgets/panels/drawing_layers_panel.h"
#include "widgets/panels/number_field.h"
#include "widgets/panels/objects_panel.h"
#include "widgets/panels/property_panel.h"

namespace handmap {

namespace {

Map sampleMap() {
  Map map;
  map.name = "Sample";
  map.start = Pose2{1.0, 2.0, kPi / 2.0};
  for (const char* id : {"A", "B", "C"}) {
    Building building;
    building.id = id;
    building.shape = Rectangle{{10.123456, 20.0}, 20.0, id[0] == 'C' ? 5.0 : 10.0, 0.0};
    map.buildings.push_back(building);
  }
  map.buildings[0].estimate = Estimate{0.25, 0.5, 0.75, 12};
  map.landmarks = {{"gate", "Main gate", {0.0, -3.0}, {}}};
  map.route = {{0.0, 0.0}, {3.0, 4.0}};
  return map;
}

}  // namespace

class PanelsTest : public QObject {
  Q_OBJECT

 private:
  static QModelIndex rowOf(const QAbstractItemModel& model, const QString& key) {
    return model
        .match(model.index(0, 0), Qt::UserRole, key, 1, Qt::MatchExactly | Qt::MatchRecursive)
        .value(0);
  }
  static void choose(QTreeView& tree, const QModelIndex& row) {
    tree.selectionModel()->select(row,
                                  QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  }

 private Q_SLOTS:
  void init() {
    document_ = std::make_unique<MapDocument>();
    document_->reset(sampleMap());
    panel_ = std::make_unique<PropertyPanel>(*document_);
    panel_->show();
    panel_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(panel_.get()));
  }
  void cleanup() { panel_.reset(); }

  void showsExactNumbersWithoutChangingThem() {
    document_->setSelection({"A"});
    QCOMPARE(number("x").text(), "10.123 m");
    QCOMPARE(number("width").text(), "20 m");
    QCOMPARE(field<QLineEdit>("id").text(), "A");
    QVERIFY(field<QLabel>("estimate").text().contains("0.25"));
    QVERIFY(field<QLabel>("estimate").text().contains("12"));
    QVERIFY(!document_->isModified());
    type(number("y"), "21");
    QCOMPARE(box("A").centre, Vec2(10.123456, 21.0));  // x is not rounded by being shown
  }

  void nothingIsCutInANarrowPanel() {
    panel_->resize(255, 300);
    for (const QStringList& keys : {QStringList{"A"}, QStringList{kStartKey}, QStringList{}}) {
      document_->setSelection(keys);
      QCoreApplication::processEvents();
      const auto* area = panel_->findChild<QScrollArea*>();
      QCOMPARE(area->widget()->width(), area->viewport()->width());
      for (const NumberField* field : area->findChildren<NumberField*>())
        if (field->isVisible()) QVERIFY(field->geometry().right() < area->viewport()->width());
    }
  }

  void typingIsOneUndoStep() {
    document_->setSelection({"A"});
    type(number("width"), "33.25");
    QCOMPARE(box("A").width, 33.25);
    QCOMPARE(document_->undoStack().count(), 1);
    type(number("width"), "44");
    QCOMPARE(document_->undoStack().count(), 2);
    document_->undoStack().undo();
    QCOMPARE(box("A").width, 33.25);
    QCOMPARE(number("width").value(), 33.25);
    document_->undoStack().undo();
    QCOMPARE(document_->map(), sampleMap());
  }

  void headingIsInDegrees() {
    document_->setSelection({"A"});
    type(number("heading"), "30");
    QVERIFY(std::abs(box("A").heading - kPi / 6.0) < 1e-12);
    document_->setSelection({kStartKey});
    QCOMPARE(number("heading").value(), 90.0);
    type(number("heading"), "-45");
    QVERIFY(std::abs(document_->map().start->heading + kPi / 4.0) < 1e-12);
    QCOMPARE(document_->undoStack().count(), 2);
  }

  void severalBuildingsShowWhatTheyShare() {
    document_->setSelection({"A", "B", "C"});
    QCOMPARE(number("width").value(), 20.0);
    QCOMPARE(number("depth").text(), "several");
    QTest::keyClick(&number("depth"), Qt::Key_Up);
    QCOMPARE(document_->undoStack().count(), 0);
    QVERIFY(!field<QLineEdit>("id").isEnabled());
    type(number("depth"), "7");
    for (const char* id : {"A", "B", "C"}) QCOMPARE(box(id).depth, 7.0);
    QCOMPARE(document_->undoStack().count(), 1);
    type(field<QLineEdit>("name"), "Hall");
    for (const Building& building : document_->map().buildings) QCOMPARE(building.name, "Hall");
    QCOMPARE(document_->undoStack().count(), 2);
  }

  void aTakenIdIsRefusedWithAWord() {
    QSignalSpy message(panel_.get(), &PropertyPanel::messageRaised);
    document_->setSelection({"A"});
    type(field<QLineEdit>("id"), "B");
    QCOMPARE(message.count(), 1);
    QCOMPARE(field<QLineEdit>("id").text(), "A");
    type(field<QLineEdit>("id"), "Library");
    QVERIFY(document_->map().find("Library"));
    QCOMPARE(document_->selection(), QStringList{"Library"});
    QCOMPARE(message.count(), 1);
  }

  void whatIsHalfTypedIsNotForTheNextObject() {
    document_->setSelection({"A"});
    for (const char* name : {"id", "x"}) {
      auto* edit = name[0] == 'x' ? number("x").findChild<QLineEdit*>() : &field<QLineEdit>("id");
      edit->setFocus();
      edit->selectAll();
      QTest::keyClicks(edit, "7");
      document_->setSelection({name[0] == 'x' ? "B" : "C"});
      QTest::keyClick(edit, Qt::Key_Return);
      document_->setSelection({"A"});
    }
    QVERIFY(document_->map().find("C"));
    QCOMPARE(box("B").centre.x(), 10.123456);
    QCOMPARE(box("A").centre.x(), 7.0);
    QCOMPARE(document_->undoStack().count(), 1);
  }

  void whatIsLockedIsNotMovedByNumbers() {
    document_->setSelection({"A"});
    QTest::mouseClick(&field<QCheckBox>("locked"), Qt::LeftButton, {}, QPoint(8, 8));
    QVERIFY(document_->map().find("A")->flags.locked && !document_->map().find("A")->fixed);
    QVERIFY(!number("x").isEnabled() && !number("width").isEnabled());
    document_->setSelection({"A", "B"});
    const double before = box("A").centre.x();
    type(number("x"), "7");
    QCOMPARE(box("A").centre.x(), before);
    QCOMPARE(box("B").centre.x(), 7.0);
  }

  void fixedAndUncertaintyAreSet() {
    document_->setSelection({"A", "B"});
    QTest::mouseClick(&field<QCheckBox>("fixed"), Qt::LeftButton, {}, QPoint(8, 8));
    QVERIFY(document_->map().find("A")->fixed && document_->map().find("B")->fixed);
    QVERIFY(!number("position_sigma").isEnabled());
    QTest::mouseClick(&field<QCheckBox>("own_uncertainty"), Qt::LeftButton, {}, QPoint(8, 8));
    QVERIFY(number("position_sigma").isEnabled());
    type(number("position_sigma"), "1.5");
    const Uncertainty expected{1.5, 3.0};
    QCOMPARE(document_->map().find("B")->uncertainty.value(), expected);
    QVERIFY(!document_->map().find("C")->uncertainty);
  }

  void theScaleAndTurnOfTheDrawingMayBeKnown() {
    QVERIFY(!number("scale_sigma").isEnabled());
    QCOMPARE(number("scale_sigma").value(), 5.0);
    QTest::mouseClick(&field<QCheckBox>("whole_known"), Qt::LeftButton, {}, QPoint(8, 8));
    const WholeUncertainty exact{0.0, 0.0};
    QCOMPARE(document_->map().whole, exact);
    type(number("scale_sigma"), "2");
    type(number("turn_sigma"), "0.5");
    QCOMPARE(number("shift_sigma").value(), 0.9);  // as people draw
    type(number("shift_sigma"), "6");
    const WholeUncertainty stated{0.02, toRadians(0.5), 6.0};
    QCOMPARE(document_->map().whole, stated);
    QTest::mouseClick(&field<QCheckBox>("whole_known"), Qt::LeftButton, {}, QPoint(8, 8));
    const WholeUncertainty shifted{{}, {}, 6.0};
    QCOMPARE(document_->map().whole, shifted);
    document_->undoStack().undo();
    QCOMPARE(document_->map().whole, stated);
  }

  void theMapAndALandmarkHavePagesToo() {
    type(field<QLineEdit>("name"), "Campus");
    QCOMPARE(document_->map().name, "Campus");
    QTest::mouseClick(&field<QCheckBox>("georeferenced"), Qt::LeftButton, {}, QPoint(8, 8));
    type(number("latitude"), "34.7012345");
    QCOMPARE(document_->map().georeference->latitude, 34.7012345);
    document_->setSelection({"gate"});
    type(number("y"), "-4.5");
    QCOMPARE(document_->map().landmarks[0].position, Vec2(0.0, -4.5));
    document_->setSelection({kRouteKey});
    QVERIFY(field<QLabel>("summary").text().contains("5.0 m"));
    document_->setSelection({kRouteKey, "A"});
    QVERIFY(field<QLabel>("summary").text().contains("2"));
    QCOMPARE(document_->undoStack().count(), 4);
  }

  void anEditOutsideIsShown() {
    document_->setSelection({"A"});
    document_->apply(moved(selected(document_->map(), {"A"}), Vec2(5.0, 0.0)), "Move");
    QCOMPARE(number("x").text(), "15.123 m");
    QCOMPARE(field<QLabel>("estimate").text(), "none yet");
  }

  void theTreeSelectsBothWays() {
    ObjectsPanel objects(*document_);
    auto* tree = objects.findChild<QTreeView*>();
    const QAbstractItemModel& model = *tree->model();
    QCOMPARE(model.rowCount(), 4);  // start, route, buildings, landmarks
    QCOMPARE(model.index(2, 0).data().toString(), "Buildings (3)");
    QCOMPARE(model.rowCount(model.index(2, 0)), 3);
    QVERIFY(tree->isExpanded(model.index(2, 0)));
    choose(*tree, rowOf(model, "A"));
    QCOMPARE(document_->selection(), QStringList{"A"});
    choose(*tree, model.index(2, 0));  // all of a kind
    QCOMPARE(document_->selection(), QStringList({"A", "B", "C"}));
    document_->setSelection({"B", "gate", "C"});
    QCOMPARE(tree->selectionModel()->selectedRows().size(), 3);
    QSignalSpy shown(&objects, &ObjectsPanel::showRequested);
    Q_EMIT tree->activated(rowOf(model, "gate"));
    QCOMPARE(shown.last()[0].toString(), "gate");
    Q_EMIT tree->activated(model.index(2, 0));  // nothing to go to
    QCOMPARE(shown.size(), 1);
    document_->removeSelected();
    QCOMPARE(model.rowCount(), 3);
    QCOMPARE(model.rowCount(model.index(2, 0)), 1);
    document_->undoStack().undo();
    QCOMPARE(model.rowCount(model.index(2, 0)), 3);
  }

  void theTreeStaysAsItWasOpened() {
    ObjectsPanel objects(*document_);
    objects.show();
    auto* tree = objects.findChild<QTreeView*>();
    tree->collapse(tree->model()->index(2, 0));
    Building building = document_->map().buildings[0];
    building.id = "D";
    document_->addBuilding(building);
    QVERIFY(!tree->isExpanded(tree->model()->index(2, 0)));
    QVERIFY(tree->isExpanded(tree->model()->index(3, 0)));
    tree->setCurrentIndex(rowOf(*tree->model(), "gate"));
    document_->addBuilding(building);
    QCOMPARE(tree->currentIndex().data(Qt::UserRole).toString(), "gate");
  }

  void theTreeIsGoneThroughByKeys() {
    ObjectsPanel objects(*document_);
    objects.show();
    objects.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&objects));
    auto* tree = objects.findChild<QTreeView*>();
    tree->setFocus();
    tree->setCurrentIndex(tree->model()->index(2, 0));
    QTest::keyClick(tree, Qt::Key_Down);
    QCOMPARE(document_->selection(), QStringList{"A"});
    QSignalSpy shown(&objects, &ObjectsPanel::showRequested);
    QTest::keyClick(tree, Qt::Key_Return);
    QCOMPARE(shown.size(), 1);
    const QModelIndex row = tree->currentIndex();
    QCOMPARE(row.data(Qt::AccessibleTextRole).toString(), "Building A");
    QCOMPARE(row.siblingAtColumn(1).data(Qt::AccessibleTextRole).toString(), "shown");
  }

  void findingHidesButKeepsTheSelection() {
    ObjectsPanel objects(*document_);
    auto* tree = objects.findChild<QTreeView*>();
    document_->setSelection({"A"});
    objects.findChild<QLineEdit*>()->setText("MAIN");
    QCOMPARE(tree->model()->rowCount(), 1);  // the node of the landmarks
    QCOMPARE(tree->model()->rowCount(tree->model()->index(0, 0)), 1);
    QCOMPARE(document_->selection(), QStringList{"A"});
    objects.findChild<QLineEdit*>()->clear();
    QCOMPARE(tree->selectionModel()->selectedRows().size(), 1);
  }

  void objectsAreRenamedHiddenAndLockedInTheTree() {
    ObjectsPanel objects(*document_);
    objects.show();
    QAbstractItemModel& model = *objects.findChild<QTreeView*>()->model();
    const auto set = [&](const QModelIndex& row, int column, Qt::CheckState state) {
      return model.setData(row.siblingAtColumn(column), state, Qt::CheckStateRole);
    };
    QVERIFY(model.setData(rowOf(model, "A"), "Library", Qt::EditRole));
    QCOMPARE(building("A").name, std::string("Library"));
    QVERIFY(set(rowOf(model, "A"), 2, Qt::Checked));
    QVERIFY(building("A").flags.locked && !building("A").fixed);
    for (const char* key : {"A", "gate", "@route"}) {
      QVERIFY(set(rowOf(model, key), 1, Qt::Unchecked));
      QCOMPARE(rowOf(model, key).siblingAtColumn(1).data(Qt::CheckStateRole).toInt(),
               int(Qt::Unchecked));
    }
    QVERIFY(building("A").flags.hidden && document_->map().landmarks[0].flags.hidden);
    QVERIFY(stateOf(document_->map().layers, DrawingLayer::Route).hidden);
    QVERIFY(set(model.index(2, 0), 2, Qt::Checked));  // all buildings
    QVERIFY(stateOf(document_->map().layers, DrawingLayer::Buildings).locked);
    const std::string file = formatMap(document_->map());
    QCOMPARE(formatMap(parseMap(file, "m")), file);  // which keeps it
    QVERIFY(parseMap(file, "m").buildings[0].flags.hidden);
    QVERIFY(!(model.flags(rowOf(model, "@start")) & Qt::ItemIsEditable));
    QVERIFY(!(model.flags(model.index(2, 0)) & Qt::ItemIsEditable));
    document_->undoStack().setIndex(0);
    QCOMPARE(document_->map(), sampleMap());
  }

  void howSureTheStartIsCanBeSaid() {
    document_->setSelection({kStartKey});
    QCOMPARE(number("start_position_sigma").text(), "0 m");
    type(number("start_position_sigma"), "2.5");
    type(number("start_heading_sigma"), "15");
    const auto said = document_->map().start_uncertainty;
    QVERIFY(said);
    QCOMPARE(said->position, 2.5);
    QCOMPARE(said->heading, toRadians(15.0));
    QCOMPARE(formatMap(parseMap(formatMap(document_->map()), "m")), formatMap(document_->map()));
    document_->undoStack().undo();
    QCOMPARE(document_->map().start_uncertainty->heading, 0.0);
    document_->undoStack().setIndex(0);
    QCOMPARE(document_->map(), sampleMap());  // where nothing was said
  }

  void layersAreHiddenLockedAndFaded() {
    DrawingLayersPanel layers(*document_);
    layers.show();
    auto* tree = layers.findChild<QTreeWidget*>("drawing_layers");
    QCOMPARE(tree->topLevelItemCount(), 4);
    tree->topLevelItem(0)->setCheckState(1, Qt::Unchecked);
    QTRY_VERIFY(stateOf(document_->map().layers, DrawingLayer::Buildings).hidden);
    tree->setCurrentItem(tree->topLevelItem(3));
    layers.findChild<QSlider*>("layer_opacity")->setValue(40);
    QCOMPARE(stateOf(document_->map().layers, DrawingLayer::Route).opacity, 0.4);
    document_->setUnderlays({{"a.png", 0, 0, 1, 0, 1, {}}}, "Add");
    QCOMPARE(tree->topLevelItemCount(), 5);
    tree->topLevelItem(4)->setCheckState(2, Qt::Checked);
    QTRY_VERIFY(document_->map().underlays[0].flags.locked);
    document_->undoStack().setIndex(0);
    QCOMPARE(document_->map(), sampleMap());
  }

  void cornersAreNumbersInATable() {
    Building polygon = building("A");
    polygon.shape = Polygon{{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}, {0.0, 10.0}};
    document_->changeBuilding("A", polygon, "Polygon");
    document_->setSelection({"A"});
    auto* table = panel_->findChild<QTableWidget*>("vertices");
    QVERIFY(table->isVisible());
    QCOMPARE(table->rowCount(), 4);
    table->item(2, 0)->setText("12.5");
    QCOMPARE(std::get<Polygon>(building("A").shape)[2], Vec2(12.5, 10.0));
    QSignalSpy messages(panel_.get(), &PropertyPanel::messageRaised);
    table->item(2, 0)->setText("-5");  // would cross
    table->item(2, 1)->setText("what");
    QCOMPARE(messages.count(), 2);
    QCOMPARE(std::get<Polygon>(building("A").shape)[2], Vec2(12.5, 10.0));
    table->setCurrentCell(0, 0);
    panel_->findChild<QPushButton*>("add_vertex")->click();
    QCOMPARE(std::get<Polygon>(building("A").shape)[1], Vec2(5.0, 0.0));
    table->setCurrentCell(1, 0);
    panel_->findChild<QPushButton*>("remove_vertex")->click();
    QCOMPARE(table->rowCount(), 4);
    document_->setSelection({"B"});
    QVERIFY(!table->isVisible());
  }

  void howSureIsSaidInWords() {
    document_->setSelection({"A"});
    auto& sure = field<QComboBox>("sure");
    QCOMPARE(sure.currentText(), QString("roughly"));
    QTest::keyClick(&sure, Qt::Key_Up);
    QCOMPARE(building("A").uncertainty, std::optional(Uncertainty{0.5, 0.5}));
    QCOMPARE(number("position_sigma").value(), 0.5);
    type(number("position_sigma"), "1.7");
    QCOMPARE(sure.currentText(), QString("in numbers"));
    field<QCheckBox>("may_not_exist").click();
    QVERIFY(building("A").may_not_exist);
    document_->setSelection({});
    auto& whole = field<QComboBox>("sure");
    whole.setCurrentIndex(2);
    Q_EMIT whole.activated(2);
    QCOMPARE(document_->map().uncertainty, (Uncertainty{8.0, 5.0}));
  }

 private:
  template <typename Field>
  Field& field(const char* name) const {
    QWidget* page = panel_->findChild<QStackedWidget*>()->currentWidget();
    auto* found = page->findChild<Field*>(QLatin1String(name));
    if (!found) qFatal("no field %s on this page", name);
    return *found;
  }
  NumberField& number(const char* name) const { return field<NumberField>(name); }
  const Building& building(const char* id) const { return *document_->map().find(id); }
  Rectangle box(const char* id) const { return document_->map().find(id)->box(); }

  template <typename Field>
  static void type(Field& field, const char* text) {
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, QLatin1String(text));
    QTest::keyClick(&field, Qt::Key_Return);
  }

  std::unique_ptr<MapDocument> document_;
  std::unique_ptr<PropertyPanel> panel_;
};

}  // namespace handmap

QTEST_MAIN(handmap::PanelsTest)
#include "panels_test.moc"
