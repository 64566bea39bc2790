#include "widgets/comparing/comparison_panel.h"

#include <QLabel>
#include <QPainter>
#include <QSet>
#include <QTest>
#include <QTreeWidget>

#include "widgets/comparing/error_arrows_item.h"
#include "widgets/comparing/figure_words.h"
#include "widgets/style/colours.h"

namespace handmap {

class ComparisonPanelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyFigureIsToldInWords();
  void valuesHaveTheUnitOfTheirName();
  void showsTheFiguresOfTheDrawingAndOfTheCorrectedMap();
  void arrowsLeadFromTheTrueToTheDrawnPlaces();

 private:
  static Map threeHouses(double shift) {
    Map map;
    for (int i = 0; i < 4; ++i) {
      const Vec2 centre(40.0 * i + shift, i == 1 ? 30.0 : 0.0);
      Building building;
      building.id = "b" + std::to_string(i);
      building.shape = Rectangle{centre, 10.0, 10.0, 0.0};
      map.buildings.push_back(building);
    }
    return map;
  }
  /// The last building of the truth is missing in it.
  static Sketch sketch(double shift) {
    Map drawing = threeHouses(shift);
    drawing.buildings.pop_back();
    return sketchOf("d.handmap", drawing, threeHouses(0.0));
  }
  static QTreeWidgetItem* row(const ComparisonPanel& panel, FigureGroup group,
                              const QString& title) {
    const auto* tree = panel.findChild<QTreeWidget*>("comparison_figures");
    QTreeWidgetItem* under = tree->topLevelItem(static_cast<int>(group));
    for (int i = 0; i < under->childCount(); ++i) {
      if (under->child(i)->text(0) == title) return under->child(i);
    }
    return nullptr;
  }
};

void ComparisonPanelTest::everyFigureIsToldInWords() {
  QSet<QString> titles;
  const std::vector<NamedFigure> figures = namedFigures(figuresOf(sketch(5.0)));
  for (const NamedFigure& figure : figures) {
    if (figure.name == "drawing" || figure.name == "stage") continue;
    const FigureWords words = figureWords(figure.name);
    QVERIFY2(!words.title.isEmpty() && !words.explanation.isEmpty(), figure.name.c_str());
    titles.insert(titleOf(words.group) + words.title);
  }
  QCOMPARE(static_cast<std::size_t>(titles.size()), figures.size() - 2);
}

void ComparisonPanelTest::valuesHaveTheUnitOfTheirName() {
  QCOMPARE(figureValue("euclidean_shift_x_m", "5.12345"), QStringLiteral("5.123 m"));
  QCOMPARE(figureValue("euclidean_theta_deg", "-3"), QStringLiteral("-3°"));
  QCOMPARE(figureValue("missing", "123456"), QStringLiteral("123456"));
  QCOMPARE(figureValue("euclidean_p", "1.23456e-07"), QStringLiteral("1.235e-07"));
  QCOMPARE(figureValue("affine_p", ""), QStringLiteral("–"));
}

void ComparisonPanelTest::showsTheFiguresOfTheDrawingAndOfTheCorrectedMap() {
  ComparisonPanel panel;
  const SketchFigures drawn = figuresOf(sketch(5.0));
  panel.setFigures("“t.handmap”", {drawn});
  const auto* tree = panel.findChild<QTreeWidget*>("comparison_figures");
  QCOMPARE(tree->columnCount(), 2);
  QCOMPARE(row(panel, FigureGroup::Things, "Missing")->text(1), QStringLiteral("1"));
  QCOMPARE(row(panel, FigureGroup::Euclidean, "Shift along x")->text(1), QStringLiteral("5 m"));
  // Three places are too few for the affine fit.
  QCOMPARE(row(panel, FigureGroup::Affine, "Shift along x")->text(1), QStringLiteral("–"));
  QVERIFY(!row(panel, FigureGroup::Pairs, "Angle accuracy")->toolTip(0).isEmpty());
  const SketchFigures corrected = figuresOf(sketch(1.0), "corrected");
  panel.setFigures("“t.handmap”", {drawn, corrected});
  QCOMPARE(tree->columnCount(), 3);
  QCOMPARE(row(panel, FigureGroup::Euclidean, "Shift along x")->text(1), QStringLiteral("5 m"));
  QCOMPARE(row(panel, FigureGroup::Euclidean, "Shift along x")->text(2), QStringLiteral("1 m"));
  QCOMPARE(panel.table(), figureTable({drawn, corrected}));
  QVERIFY(panel.findChild<QLabel*>("comparison_words")->text().contains("“t.handmap”"));
}

void ComparisonPanelTest::arrowsLeadFromTheTrueToTheDrawnPlaces() {
  ErrorArrowsItem item;
  item.setPairs(pairsOf(sketch(25.0)));
  QCOMPARE(item.arrows().size(), 3);
  QCOMPARE(item.arrows()[0], QLineF(0.0, 0.0, 25.0, 0.0));
  QCOMPARE(item.arrows()[1], QLineF(40.0, 30.0, 65.0, 30.0));
  QCOMPARE(item.missing(), QList<QPointF>({{120.0, 0.0}}));
  QVERIFY(item.boundingRect().contains(QPointF(120.0, 0.0)));
  QImage image(200, 80, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.translate(20.0, 20.0);
  item.paint(&painter, nullptr, nullptr);
  painter.end();
  const QColor green = Colours::light()[Role::Truth];
  const auto is_green = [&](int x, int y) {
    const QColor at = image.pixelColor(x, y);
    return at.green() > at.red() + 40 && green.green() > green.red();
  };
  int shaft = 0;
  for (int x = 65; x < 80; ++x) shaft += is_green(x, 50);
  QVERIFY(shaft > 5);
  QVERIFY(!is_green(100, 20));
  item.clear();
  QVERIFY(item.arrows().isEmpty() && item.boundingRect().isEmpty());
}

}  // namespace handmap

QTEST_MAIN(handmap::ComparisonPanelTest)
#include "comparison_panel_test.moc"
