// Painting, training, looking and saving as people do it.
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

#include "core/recording/image_file.h"
#include "tests/core/classification/painted_street.h"
#include "widgets/teach/teach_panel.h"

namespace handmap {
namespace {

constexpr int kWaitMs = 20000;

class Teach : public testing::Test {
 protected:
  Teach() {
    panel_.resize(900, 700);
    panel_.show();
    QStringList paths;
    for (int i = 0; i < 2; ++i) {
      paths << folder_.filePath(QString::number(i) + ".png");
      writePng(test::paintStreet(static_cast<std::uint64_t>(i)).image, paths.back().toStdString());
    }
    panel_.openImages(paths);
    choose("brush_size", 0);  // one window
  }

  void choose(const char* box, int index) {
    panel_.findChild<QComboBox*>(QLatin1String(box))->setCurrentIndex(index);
  }

  QPushButton& trainButton() { return *panel_.findChild<QPushButton*>("train"); }

  void click(int column, int row, Qt::MouseButton button = Qt::LeftButton) {
    QTest::mouseClick(&panel_.view(), button, {}, panel_.view().centreOf(column, row).toPoint());
  }

  WindowLabel labelAt(int column, int row) {
    return panel_.view().labels().at(static_cast<std::size_t>(row * 10 + column));
  }

  /// All windows of the first image as they are.
  void paintTruth() {
    const cv::Mat1b classes = test::paintStreet(0).classes;
    for (int brush = 0; brush < 2; ++brush) {
      choose("brush", brush);
      for (int i = 0; i < 80; ++i) {
        const bool building = classes(16 * (i / 10), 16 * (i % 10)) == test::kBuildingClass;
        if (building == (brush == 0)) click(i % 10, i / 10);
      }
    }
  }

  void trainAndWait() {
    QSignalSpy changed(&panel_, &TeachPanel::classifierChanged);
    QTest::mouseClick(&trainButton(), Qt::LeftButton);
    EXPECT_TRUE(panel_.isTraining());
    ASSERT_TRUE(changed.wait(kWaitMs));
    EXPECT_FALSE(panel_.isTraining());
  }

  QTemporaryDir folder_;
  TeachPanel panel_;
};

TEST_F(Teach, BrushesPaintWindowsAndErase) {
  click(3, 2);
  EXPECT_EQ(labelAt(3, 2), WindowLabel::Building);
  EXPECT_EQ(labelAt(4, 2), WindowLabel::Unknown);
  choose("brush", 1);
  choose("brush_size", 1);  // 3 × 3
  click(9, 7);
  EXPECT_EQ(labelAt(9, 7), WindowLabel::Other);
  EXPECT_EQ(labelAt(8, 6), WindowLabel::Other);
  EXPECT_EQ(labelAt(7, 7), WindowLabel::Unknown);
  click(9, 7, Qt::RightButton);
  EXPECT_EQ(labelAt(8, 6), WindowLabel::Unknown);
  choose("brush", 2);
  click(3, 2);
  EXPECT_EQ(labelAt(3, 2), WindowLabel::Unknown);
}

TEST_F(Teach, WhatIsPaintedStaysWithItsImage) {
  auto* images = panel_.findChild<QListWidget*>();
  click(3, 2);
  images->setCurrentRow(1);
  EXPECT_EQ(labelAt(3, 2), WindowLabel::Unknown);
  images->setCurrentRow(0);
  EXPECT_EQ(labelAt(3, 2), WindowLabel::Building);
}

TEST_F(Teach, TrainingNeedsEnoughOfBoth) {
  EXPECT_FALSE(trainButton().isEnabled());
  for (int column = 0; column < 5; ++column) click(column, 2);
  EXPECT_FALSE(trainButton().isEnabled());
  choose("brush", 1);
  for (int column = 0; column < 5; ++column) click(column, 7);
  EXPECT_TRUE(trainButton().isEnabled());
}

TEST_F(Teach, TrainsShowsAndSavesAModelThatFindsHouses) {
  paintTruth();
  trainAndWait();
  ASSERT_TRUE(panel_.classifier());
  const test::PaintedStreet street = test::paintStreet(1);
  Confusion unseen;
  judge(*panel_.classifier(), street.image, windowLabels(street.classes, 1, {}), unseen);
  EXPECT_GT(unseen.balancedAccuracy(), 0.85);

  const QImage with = panel_.view().grab().toImage();
  panel_.view().setFound(cv::Mat1f());
  EXPECT_NE(panel_.view().grab().toImage(), with);

  const QString path = folder_.filePath("model.json");
  EXPECT_TRUE(panel_.saveModel(path));
  TeachPanel other;
  EXPECT_TRUE(other.loadModel(path));
  EXPECT_EQ(other.classifier()->toJson(), panel_.classifier()->toJson());
}

TEST_F(Teach, TrainingIsCancelled) {
  paintTruth();
  QTest::mouseClick(&trainButton(), Qt::LeftButton);
  ASSERT_TRUE(panel_.isTraining());
  QTest::mouseClick(&trainButton(), Qt::LeftButton);
  EXPECT_TRUE(QTest::qWaitFor([this] { return !panel_.isTraining(); }, kWaitMs));
  EXPECT_FALSE(panel_.classifier());
}

TEST_F(Teach, MayBeClosedWhileTraining) {
  auto panel = std::make_unique<TeachPanel>();
  panel->openImages({folder_.filePath("0.png")});
  panel->train();  // nothing painted: fails, or is cancelled before
  panel.reset();
}

TEST_F(Teach, TellsWhatCannotBeUsed) {
  QSignalSpy messages(&panel_, &TeachPanel::messageRaised);
  panel_.openImages({folder_.filePath("none.png")});
  panel_.findChild<QListWidget*>()->setCurrentRow(2);
  ASSERT_EQ(messages.size(), 1);
  EXPECT_TRUE(messages.takeFirst().at(0).toString().contains("none.png"));
  QTest::mouseClick(&panel_.view(), Qt::LeftButton, {}, {30, 20});  // on nothing
  EXPECT_FALSE(panel_.loadModel(folder_.filePath("0.png")));
  EXPECT_EQ(messages.size(), 1);
  EXPECT_FALSE(panel_.classifier());
}

}  // namespace
}  // namespace handmap
