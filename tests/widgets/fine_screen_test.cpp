// On a screen whose pixels are half as large nothing that is drawn is thinner.
#include <QGuiApplication>
#include <QTest>

#include "widgets/style/colours.h"

namespace handmap {

namespace {

const bool kIsFine = qputenv("QT_SCALE_FACTOR", "2");  // read when the application is made

}  // namespace

class FineScreenTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void pensAndCasingsHaveTwiceAsManyPixels() {
    QVERIFY(kIsFine && qGuiApp->devicePixelRatio() == 2.0);
    const Colours& colours = Colours::light();
    const QPen wall = colours.pen(Role::Drawing);
    QCOMPARE(wall.widthF(), 2.8);
    const QPen casing = colours.casing(wall);
    QVERIFY(casing.isCosmetic());
    QCOMPARE(casing.widthF(), 2.8 + 2.0 * 2.5);
    QCOMPARE(casing.color(), colours[Role::TextHalo]);
    QCOMPARE(cosmeticPen(Qt::red, 3.0).widthF(), 6.0);
  }
};

}  // namespace handmap

QTEST_MAIN(handmap::FineScreenTest)
#include "fine_screen_test.moc"
