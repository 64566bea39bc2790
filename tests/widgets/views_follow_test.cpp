// Views that follow only what changed show what views made anew would.
#include <QSignalSpy>
#include <QTest>

#include "tests/widgets/random_edits.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/panels/object_tree_model.h"

namespace handmap {

namespace {

constexpr int kEdits = 300;

QImage pictureOf(MapCanvas& canvas) {
  QImage image(canvas.size(), QImage::Format_RGB32);
  canvas.viewport()->render(&image);
  return image;
}

/// But for the rounding of soft edges, which begin elsewhere on a picture of another size.
bool looksLike(const QImage& a, const QImage& b) {
  constexpr int kRounding = 16;  // of 255
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QColor one = a.pixelColor(x, y);
      const QColor other = b.pixelColor(x, y);
      if (std::abs(one.red() - other.red()) > kRounding ||
          std::abs(one.green() - other.green()) > kRounding ||
          std::abs(one.blue() - other.blue()) > kRounding)
        return false;
    }
  return a.size() == b.size();
}

std::unique_ptr<MapCanvas> canvasOf(MapDocument& document) {
  auto canvas = std::make_unique<MapCanvas>(document);
  canvas->resize(300, 200);
  canvas->zoomToRect({-200.0, -150.0, 400.0, 300.0});
  return canvas;
}

QStringList rowsOf(const QAbstractItemModel& model, const QModelIndex& parent = {}) {
  QStringList rows;
  for (int row = 0; row < model.rowCount(parent); ++row) {
    for (int column = 0; column < model.columnCount(parent); ++column) {
      const QModelIndex index = model.index(row, column, parent);
      rows << model.data(index, Qt::DisplayRole).toString() +
                  model.data(index, Qt::CheckStateRole).toString();
    }
    rows << rowsOf(model, model.index(row, 0, parent));
  }
  return rows;
}

}  // namespace

class ViewsFollowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void likeViewsMadeAnew() {
    RandomStream random(7);
    MapDocument document;
    const auto canvas = canvasOf(document);
    ObjectTreeModel tree(document);
    connect(&document, &MapDocument::mapChanged, &tree, &ObjectTreeModel::follow);
    for (int i = 0; i < kEdits; ++i) {
      if (i % 5 == 4)
        document.undoStack().setIndex(random.index(document.undoStack().count() + 1));
      else
        editAtRandom(document, random);
      QVERIFY(looksLike(pictureOf(*canvas), pictureOf(*canvasOf(document))));
      QCOMPARE(rowsOf(tree), rowsOf(ObjectTreeModel(document)));
    }
  }

  void oneThatMovesIsToldAlone() {
    MapDocument document;
    for (int i = 0; i < 100; ++i) {
      Building building;
      building.shape = Rectangle{{20.0 * i, 0.0}, 10.0, 8.0, 0.0};
      document.addBuilding(building);
    }
    ObjectTreeModel tree(document);
    connect(&document, &MapDocument::mapChanged, &tree, &ObjectTreeModel::follow);
    Touched told;
    connect(&document, &MapDocument::mapChanged, this, [&](const Touched& t) { told = t; });
    const auto is_alone = [&](std::size_t place) {
      return told.onlyPlaces() && told.buildings == std::vector{place};
    };
    document.apply(moved(selected(document.map(), {"B41"}), {1.0, 0.0}), "Move");
    QVERIFY(is_alone(40));
    document.undoStack().undo();
    QVERIFY(is_alone(40));

    QSignalSpy rows(&tree, &ObjectTreeModel::dataChanged);
    Building named = *document.map().find("B7");
    named.name = "Library";
    document.changeBuilding("B7", named, "Name");
    QVERIFY(is_alone(6));
    QCOMPARE(rows.count(), 2);  // the node of the buildings, and it
    document.rename("B7", "House");
    QVERIFY(told.listed);
  }
};

}  // namespace handmap

QTEST_MAIN(handmap::ViewsFollowTest)
#include "views_follow_test.moc"
