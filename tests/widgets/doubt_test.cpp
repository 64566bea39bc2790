// Soft edges: as wide as the uncertainty that a run takes for true, and what is hidden has none.
#include <QTest>
#include <memory>

#include "core/map/certainty.h"
#include "widgets/canvas/hit_test.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/tools/toolbox.h"

namespace handmap {

class DoubtTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    document_ = std::make_unique<MapDocument>();
    Map map;
    Building building;
    building.id = "A";
    building.shape = Rectangle{{0.0, 0.0}, 20.0, 20.0, 0.0};
    map.buildings = {building};
    map.uncertainty = {4.0, 0.0};
    document_->reset(map);
    canvas_ = std::make_unique<MapCanvas>(*document_);
    tools_ = std::make_unique<Toolbox>(*document_, *canvas_);
    canvas_->resize(400, 400);
    canvas_->setGridVisible(false);
    canvas_->show();
    canvas_->zoomToRect({-20.0, -20.0, 40.0, 40.0});
  }

  void theEdgeIsAsWideAsTheUncertainty() {
    const QRgb ground = at(17.0);
    QVERIFY(at(13.0) != ground);  // 3 m off the wall at 10 m, σ is 4 m
    QCOMPARE(at(15.0), ground);
    QVERIFY(qGray(at(10.6)) < qGray(at(13.5)));  // stronger near the wall
    document_->setUncertainty({0.5, 0.0});
    QCOMPARE(at(13.0), ground);
    Building sure = document_->map().buildings[0];
    sure.uncertainty = Uncertainty{6.0, 0.0};
    document_->changeBuilding("A", sure, "Own");
    QVERIFY(at(15.0) != ground);
    canvas_->setDoubtVisible(false);
    QCOMPARE(at(15.0), ground);
  }

  void whatWasTakenOverIsAsSureAsTheRunMadeIt() {
    const QRgb ground = at(17.0);
    QVERIFY(at(13.0) != ground);
    Map refined = document_->map();
    refined.buildings[0].estimate = Estimate{0.5, 0.5, 0.5, 7};
    setSides(refined.buildings[0], {{{0.5, true}, {0.5, true}, {4.0, false}, {0.5, true}}});
    document_->acceptRefinement(refined);
    QCOMPARE(at(13.0), ground);    // seen: now sure to 0.5 m
    QVERIFY(at(-13.0) != ground);  // nobody saw that wall
    document_->undoStack().undo();
    QVERIFY(at(13.0) != ground);
  }

  void whatMayNotExistIsMarked() {
    canvas_->setDoubtVisible(true);
    document_->setUncertainty({0.0, 0.0});
    const QImage before = picture();
    Building doubted = document_->map().buildings[0];
    doubted.may_not_exist = true;
    document_->changeBuilding("A", doubted, "Doubt");
    QVERIFY(picture() != before);
  }

  void theHiddenIsNeitherDrawnNorMet() {
    const QRgb ground = at(17.0);
    QVERIFY(at(5.0) != ground);
    QCOMPARE(key(), QString("A"));
    LayerStates layers;
    layers[static_cast<std::size_t>(DrawingLayer::Buildings)].hidden = true;
    document_->setLayers(layers, "Hide");
    QCOMPARE(at(5.0), ground);
    QCOMPARE(at(13.0), ground);
    QCOMPARE(key(), QString());
    document_->undoStack().undo();
    layers = {};
    layers[static_cast<std::size_t>(DrawingLayer::Buildings)].locked = true;
    document_->setLayers(layers, "Lock");
    QVERIFY(at(5.0) != ground);
    QCOMPARE(key(), QString());
    document_->undoStack().undo();
    Building hidden = document_->map().buildings[0];
    hidden.flags.hidden = true;
    document_->changeBuilding("A", hidden, "Hide");
    QCOMPARE(at(5.0), ground);
    QCOMPARE(key(), QString());
  }

 private:
  QImage picture() const { return canvas_->viewport()->grab().toImage(); }
  /// On the x axis, a little beside what may be written there.
  QRgb at(double x) const {
    const QPoint point = canvas_->viewportTransform().map(QPointF(x, 4.0)).toPoint();
    return picture().pixel(point);
  }
  QString key() const { return objectAt(*document_, {5.0, 4.0}, 0.1); }

  std::unique_ptr<MapDocument> document_;
  std::unique_ptr<MapCanvas> canvas_;
  std::unique_ptr<Toolbox> tools_;
};

}  // namespace handmap

QTEST_MAIN(handmap::DoubtTest)
#include "doubt_test.moc"
