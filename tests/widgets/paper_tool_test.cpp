// What was read from a photo is taken or left, by pointer and by keys.
#include "widgets/tools/paper_tool.h"

#include <QPainter>
#include <QSignalSpy>
#include <QTest>

#include "tests/widgets/tool_events.h"
#include "widgets/style/colours.h"

namespace handmap {

namespace {

PaperReview review() {
  PaperReview review;
  review.page = QImage(200, 100, QImage::Format_RGB32);
  review.page.fill(Qt::white);
  review.place.x = 0.0;
  review.place.y = 50.0;
  review.place.metres_per_pixel = 0.5;
  for (const double x : {20.0, 50.0, 80.0}) {
    PaperReview::Proposal proposal;
    proposal.building.shape = Rectangle{{x, 25.0}, 20.0, 20.0, 0.0};
    proposal.ink = QImage(4, 4, QImage::Format_Alpha8);
    proposal.ink.fill(255);
    proposal.ink_at = {static_cast<int>(2.0 * x), 50};
    proposal.taken = x < 70.0;
    review.proposals.push_back(std::move(proposal));
  }
  return review;
}

}  // namespace

class PaperToolTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aClickTakesAndLeaves();
  void keysDoTheSame();
  void nothingTickedCannotBeTaken();
  void escapeDropsItAndASecondFingerDoesNot();
  void theInkOfTheOneLookedAtLightsUp();
};

void PaperToolTest::aClickTakesAndLeaves() {
  MapDocument document;
  PaperTool tool(document);
  tool.setReview(review());
  QCOMPARE(tool.takenCount(), 2);
  click(tool, {50.0, 25.0});
  QVERIFY(!tool.review().proposals[1].taken);
  click(tool, {80.0, 25.0});
  click(tool, {65.0, 25.0});  // between two
  std::vector<std::size_t> taken;
  connect(&tool, &PaperTool::taken, this,
          [&](const std::vector<std::size_t>& proposals) { taken = proposals; });
  QSignalSpy finished(&tool, &Tool::finished);
  tool.finish();
  QCOMPARE(taken, (std::vector<std::size_t>{0, 2}));
  QVERIFY(tool.isBusy());  // until they are in the drawing
  QCOMPARE(finished.count(), 0);
  tool.endReview();
  QCOMPARE(finished.count(), 1);
  QVERIFY(!tool.isBusy());
  QVERIFY(document.map().buildings.empty());  // whoever listens adds them
}

void PaperToolTest::keysDoTheSame() {
  MapDocument document;
  PaperTool tool(document);
  QVERIFY(!key(tool, Qt::Key_Return));
  tool.setReview(review());
  key(tool, Qt::Key_Tab);
  key(tool, Qt::Key_Delete);
  QVERIFY(!tool.review().proposals[0].taken);
  key(tool, Qt::Key_Backtab);
  QVERIFY(tool.removeChosen());
  QVERIFY(tool.review().proposals[2].taken);
  QSignalSpy taken(&tool, &PaperTool::taken);
  key(tool, Qt::Key_Return);
  QCOMPARE(taken.count(), 1);
}

void PaperToolTest::nothingTickedCannotBeTaken() {
  MapDocument document;
  PaperTool tool(document);
  tool.setReview(review());
  click(tool, {20.0, 25.0});
  click(tool, {50.0, 25.0});
  QVERIFY(!tool.canFinish());
  key(tool, Qt::Key_Return);
  QVERIFY(tool.isBusy());
}

void PaperToolTest::escapeDropsItAndASecondFingerDoesNot() {
  MapDocument document;
  PaperTool tool(document);
  tool.setReview(review());
  tool.interrupt();
  QVERIFY(tool.isBusy());
  QVERIFY(tool.cancel());
  QVERIFY(!tool.isBusy());
  QVERIFY(!tool.cancel());
}

void PaperToolTest::theInkOfTheOneLookedAtLightsUp() {
  MapDocument document;
  PaperTool tool(document);
  tool.setReview(review());
  tool.move(at({50.0, 25.0}));
  QImage canvas(400, 200, QImage::Format_RGB32);
  canvas.fill(Qt::white);
  QPainter painter(&canvas);
  QTransform to_device;  // four pixels a metre, y down
  to_device.translate(0.0, 200.0);
  to_device.scale(4.0, -4.0);
  ToolPaint paint{painter, to_device, Colours::light()};
  tool.paint(paint);
  painter.end();
  const QColor there = canvas.pixelColor(203, 103);  // page 101.5, 51.5
  const QColor selection = Colours::light()[Role::Selection];
  QVERIFY(std::abs(there.red() - selection.red()) < 40 &&
          std::abs(there.blue() - selection.blue()) < 40);
}

}  // namespace handmap

QTEST_MAIN(handmap::PaperToolTest)
#include "paper_tool_test.moc"
