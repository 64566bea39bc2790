// A photo of a drawing on paper becomes buildings, looked through in the window.
#include <QDir>
#include <QFile>
#include <QLabel>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "core/map/map_io.h"
#include "tests/core/paper/photographed.h"
#include "tests/journeys/scripted_dialogs.h"
#include "tests/journeys/window_test.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/panels/property_panel.h"
#include "widgets/tools/paper_tool.h"
#include "widgets/tools/toolbox.h"

namespace handmap {
namespace {

class PaperWindow : public WindowTest {
 protected:
  PaperWindow() {
    auto dialogs = std::make_unique<ScriptedDialogs>();
    dialogs_ = dialogs.get();
    window_ = std::make_unique<MainWindow>(document_, settings_, std::move(dialogs));
    window_->show();
  }
  ~PaperWindow() override { document_.undoStack().setClean(); }

  /// Two houses, one with a word in it.
  cv::Mat drawing() const {
    cv::Mat print = test::printed(emptySheet(200.0));
    test::penned(print, Rectangle{{60.0, 110.0}, 50.0, 30.0, 0.0}.corners());
    test::penned(print, Rectangle{{180.0, 90.0}, 40.0, 40.0, 0.0}.corners());
    cv::putText(print, "Post", test::onPrint({47.0, 107.0}), cv::FONT_HERSHEY_SIMPLEX, 3.0,
                {40, 40, 40}, 5);
    return print;
  }
  void openPhoto(const cv::Mat& photo) {
    cv::imwrite(path("photo.png").toStdString(), photo);
    dialogs_->paths = {path("photo.png")};
    action(*window_, "file.from_paper")->trigger();
  }
  PaperTool& tool() { return window_->tools().paperTool(); }
  bool isReviewing() {
    return QTest::qWaitFor([&] { return tool().isBusy(); }, kPatienceMs);
  }

  ScriptedDialogs* dialogs_ = nullptr;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(PaperWindow, ASheetIsTakenOverInOneStep) {
  document_.save(path("place.handmap"));
  openPhoto(test::photographed(drawing(), {0.4, 1.0, 2.0, 0.2, 0.0, 2.0, 3}));
  ASSERT_TRUE(isReviewing());
  EXPECT_EQ(window_->canvas().tool(), ToolId::Paper);
  ASSERT_EQ(tool().takenCount(), 2);
  EXPECT_TRUE(document_.map().buildings.empty());
  QTest::keyClick(window_->canvas().viewport(), Qt::Key_Return);
  const Map& map = document_.map();
  ASSERT_EQ(map.buildings.size(), 2u);
  EXPECT_EQ(window_->canvas().tool(), ToolId::Select);
  EXPECT_NEAR(map.buildings[0].box().centre.x(), -60.0, 1.0);
  EXPECT_NEAR(map.buildings[0].box().centre.y(), 90.0, 1.0);
  ASSERT_TRUE(map.start);
  EXPECT_GT(map.uncertainty.position, 5.0);
  ASSERT_EQ(map.underlays.size(), 1u);
  EXPECT_EQ(map.underlays[0].image, "place-paper.png");
  EXPECT_TRUE(QFile::exists(path("place-paper.png")));
  EXPECT_EQ(document_.undoStack().count(), 1);
  document_.undoStack().undo();
  EXPECT_TRUE(map.buildings.empty());
  EXPECT_TRUE(map.underlays.empty());
  EXPECT_FALSE(map.start);
  EXPECT_EQ(map.uncertainty, Uncertainty{});
}

TEST_F(PaperWindow, WhatWasWrittenStandsBesideTheNameAlsoWhenOpenedAgain) {
  openPhoto(test::photographed(drawing(), {}));
  ASSERT_TRUE(isReviewing());
  tool().finish();
  document_.save(path("place.handmap"));
  document_.open(path("place.handmap"));
  const auto* writing = window_->properties().findChild<QLabel*>("writing");
  ASSERT_NE(writing, nullptr);
  document_.setSelection({QString::fromStdString(document_.map().buildings[0].id)});
  EXPECT_FALSE(writing->pixmap().isNull());
  EXPECT_FALSE(writing->isHidden());
  document_.setSelection({QString::fromStdString(document_.map().buildings[1].id)});
  EXPECT_TRUE(writing->isHidden());
}

TEST_F(PaperWindow, AnotherPageIsAsWideAsOneSays) {
  cv::Mat page(900, 1400, CV_8UC3, cv::Scalar::all(235));
  cv::rectangle(page, {200, 200, 200, 150}, {40, 40, 40}, 4);
  cv::rectangle(page, {1000, 500, 200, 150}, {40, 40, 40}, 4);
  dialogs_->figures = {100.0};
  openPhoto(page);
  ASSERT_TRUE(isReviewing());
  tool().finish();
  ASSERT_EQ(document_.map().buildings.size(), 2u);
  const double left = boundsOf(document_.map().buildings[0].footprint()).low.x();
  EXPECT_NEAR(boundsOf(document_.map().buildings[1].footprint()).high.x() - left, 100.0, 0.5);
  EXPECT_FALSE(document_.map().start);
}

TEST_F(PaperWindow, WhatWasLeftDoesNotCountForTheWidth) {
  cv::Mat page(900, 1400, CV_8UC3, cv::Scalar::all(235));
  for (const int x : {100, 500, 1100}) cv::rectangle(page, {x, 300, 200, 150}, {40, 40, 40}, 4);
  dialogs_->figures = {100.0};
  openPhoto(page);
  ASSERT_TRUE(isReviewing());
  ASSERT_EQ(tool().takenCount(), 3);
  QTest::keyClick(window_->canvas().viewport(), Qt::Key_Tab);
  QTest::keyClick(window_->canvas().viewport(), Qt::Key_Delete);
  QTest::keyClick(window_->canvas().viewport(), Qt::Key_Return);
  const Map& map = document_.map();
  ASSERT_EQ(map.buildings.size(), 2u);
  const Bounds left = boundsOf(map.buildings[0].footprint());
  const Bounds right = boundsOf(map.buildings[1].footprint());
  EXPECT_NEAR(std::max(left.high.x(), right.high.x()) - std::min(left.low.x(), right.low.x()),
              100.0, 0.5);
  EXPECT_NEAR(map.underlays[0].metres_per_pixel, 100.0 / 800.0, 0.001);
}

TEST_F(PaperWindow, WhereThePageCannotBeKeptNothingIsLost) {
  document_.save(path("place.handmap"));
  openPhoto(test::photographed(drawing(), {}));
  ASSERT_TRUE(isReviewing());
  QDir folder(path(""));
  ASSERT_TRUE(folder.rename(path(""), path("") + "-gone"));
  QTest::keyClick(window_->canvas().viewport(), Qt::Key_Return);
  EXPECT_TRUE(message(*window_).contains("place-paper.png")) << message(*window_).toStdString();
  EXPECT_TRUE(tool().isBusy());
  EXPECT_TRUE(document_.map().buildings.empty());
  ASSERT_TRUE(folder.rename(path("") + "-gone", path("")));
  QTest::keyClick(window_->canvas().viewport(), Qt::Key_Return);
  EXPECT_EQ(document_.map().buildings.size(), 2u);
  EXPECT_FALSE(tool().isBusy());
}

TEST_F(PaperWindow, NoShapeLiesUnderTheMessageInASmallWindow) {
  window_->canvas().setFixedSize(745, 425);  // what a screen of 800 by 600 leaves
  cv::Mat print = test::printed(emptySheet(200.0));
  test::penned(print, Rectangle{{30.0, 20.0}, 40.0, 15.0, 0.0}.corners());
  test::penned(print, Rectangle{{200.0, 20.0}, 40.0, 15.0, 0.0}.corners());
  openPhoto(test::photographed(print, {}));
  ASSERT_TRUE(isReviewing());
  QTest::qWait(50);
  const QWidget& canvas = *window_->canvas().viewport();
  const QRect covered(canvas.mapFromGlobal(window_->messages().mapToGlobal(QPoint())),
                      window_->messages().size());
  ASSERT_EQ(tool().review().proposals.size(), 2u);
  for (const PaperReview::Proposal& proposal : tool().review().proposals) {
    const Vec2 middle = proposal.building.box().centre;
    const QPoint at = window_->canvas().mapFromScene({middle.x(), middle.y()});
    EXPECT_TRUE(canvas.rect().contains(at));
    EXPECT_FALSE(covered.contains(at)) << at.x() << ", " << at.y();
  }
}

TEST_F(PaperWindow, APageWithoutShapesIsToldAndNothingChanges) {
  openPhoto(cv::Mat(600, 800, CV_8UC3, cv::Scalar::all(235)));
  EXPECT_TRUE(QTest::qWaitFor([&] { return message(*window_).contains("has no closed shapes"); },
                              kPatienceMs));
  EXPECT_FALSE(document_.isModified());
}

/// A camera over the table: bare, a hand, one house, a hand over it, two houses.
void filmDrawing(const std::string& file) {
  constexpr double kRate_hz = 5.0;
  const cv::Size size(1600, 1200);
  cv::VideoWriter film(file, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), kRate_hz, size);
  cv::Mat sheet = test::printed(emptySheet(200.0));
  const auto shown = [&](int images, bool hand) {
    cv::Mat table = sheet.clone();
    if (hand) {
      cv::line(table, test::onPrint({70.0, 100.0}), test::onPrint({300.0, 20.0}), {125, 160, 205},
               400, cv::LINE_AA);
    }
    cv::Mat image;
    cv::resize(test::photographed(table, {0.3, 1.0, 0.1, 0.2, 0.0, 2.0, 3}), image, size);
    for (int i = 0; i < images; ++i) film.write(image);
  };
  shown(8, false);
  shown(5, true);
  test::penned(sheet, Rectangle{{60.0, 110.0}, 50.0, 30.0, 0.0}.corners());
  shown(15, false);
  test::penned(sheet, Rectangle{{180.0, 50.0}, 40.0, 40.0, 0.0}.corners());
  shown(8, true);
  shown(20, false);
}

TEST_F(PaperWindow, ACameraFollowsThePen) {
  document_.save(path("place.handmap"));
  filmDrawing(path("table.avi").toStdString());
  dialogs_->texts = {path("table.avi")};
  action(*window_, "file.open_camera")->trigger();
  ASSERT_TRUE(isReviewing());
  EXPECT_TRUE(tool().review().proposals.empty());
  EXPECT_TRUE(message(*window_).contains("is followed")) << message(*window_).toStdString();
  ASSERT_TRUE(QTest::qWaitFor([&] { return tool().takenCount() == 1; }, kPatienceMs));
  const auto first = tool().review().proposals[0].building.shape;
  QTest::keyClick(window_->canvas().viewport(), Qt::Key_Tab);
  QTest::keyClick(window_->canvas().viewport(), Qt::Key_Delete);
  ASSERT_EQ(tool().takenCount(), 0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return tool().review().proposals.size() == 2; }, kPatienceMs));
  EXPECT_EQ(tool().takenCount(), 1) << "who said no is not asked again";
  EXPECT_EQ(tool().review().proposals[0].building.shape, first) << "a hand changed it";
  EXPECT_TRUE(document_.map().buildings.empty());
  QTest::keyClick(window_->canvas().viewport(), Qt::Key_Return);
  ASSERT_EQ(document_.map().buildings.size(), 1u);
  EXPECT_NEAR(document_.map().buildings[0].box().centre.x(), 60.0, 1.5);
  EXPECT_NEAR(document_.map().buildings[0].box().centre.y(), 30.0, 1.5);
  ASSERT_TRUE(document_.map().start);
  EXPECT_TRUE(QFile::exists(path("place-paper.png")));
  EXPECT_EQ(document_.undoStack().count(), 1);
  QTest::qWait(1000);
  EXPECT_FALSE(tool().isBusy()) << "the camera is closed";
}

TEST_F(PaperWindow, ACameraThatIsNotThereIsTold) {
  dialogs_->texts = {path("none.avi")};
  action(*window_, "file.open_camera")->trigger();
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return message(*window_).contains("cannot be opened"); }, kPatienceMs));
  EXPECT_FALSE(document_.isModified());
  EXPECT_FALSE(tool().isBusy());
}

TEST_F(PaperWindow, WhatWasDrawnOnASheetPrintsOverIt) {
  document_.save(path("place.handmap"));
  openPhoto(test::photographed(drawing(), {}));
  ASSERT_TRUE(isReviewing());
  tool().finish();
  dialogs_->choices = {2};
  dialogs_->paths = {path("over.pdf")};
  action(*window_, "file.print_sheet")->trigger();
  QFile file(path("over.pdf"));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_EQ(file.readAll().toStdString(), overprintPdf(document_.map()));
}

TEST_F(PaperWindow, ASheetIsPrinted) {
  dialogs_->figures = {300.0};
  dialogs_->paths = {path("sheet.pdf")};
  action(*window_, "file.print_sheet")->trigger();
  QFile file(path("sheet.pdf"));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_EQ(file.readAll().toStdString(), sheetPdf(emptySheet(300.0)));
}

}  // namespace
}  // namespace handmap
