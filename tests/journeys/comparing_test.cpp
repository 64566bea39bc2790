// A drawing beside a true map, in the window: figures, arrows, the table on disk.
#include <QDockWidget>
#include <QFile>
#include <QGraphicsScene>
#include <QPushButton>
#include <QTreeWidget>

#include <gtest/gtest.h>

#include "core/base/text.h"
#include "core/map/map_io.h"
#include "core/sketch_study/figures.h"
#include "tests/journeys/scripted_dialogs.h"
#include "tests/journeys/window_test.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/comparing/error_arrows_item.h"

namespace handmap {
namespace {

class ComparingWindow : public WindowTest {
 protected:
  ComparingWindow() {
    auto dialogs = std::make_unique<ScriptedDialogs>();
    dialogs_ = dialogs.get();
    window_ = std::make_unique<MainWindow>(document_, settings_, std::move(dialogs));
    window_->show();
  }
  ~ComparingWindow() override { document_.undoStack().setClean(); }

  static Map houses(int count, double shift) {
    Map map;
    for (int i = 0; i < count; ++i) {
      const Vec2 centre(40.0 * i + shift, i % 2 == 0 ? 0.0 : 30.0);
      Building building;
      building.id = "b" + std::to_string(i);
      building.shape = Rectangle{centre, 10.0, 10.0, 0.0};
      map.buildings.push_back(building);
    }
    return map;
  }
  void compare(const Map& drawing, const Map& truth) {
    writeMap(drawing, path("drawing.handmap").toStdString());
    writeMap(truth, path("truth.handmap").toStdString());
    ASSERT_TRUE(window_->files().open(path("drawing.handmap")));
    dialogs_->paths = {path("truth.handmap")};
    action(*window_, "file.compare")->trigger();
  }
  QDockWidget* dock() { return window_->findChild<QDockWidget*>("comparison"); }
  bool isCompared() { return !dock()->isHidden() && dock()->toggleViewAction()->isEnabled(); }
  QTreeWidget* figures() { return dock()->findChild<QTreeWidget*>("comparison_figures"); }
  const ErrorArrowsItem* arrows() {
    for (const QGraphicsItem* item : window_->canvas().scene()->items()) {
      if (const auto* found = dynamic_cast<const ErrorArrowsItem*>(item)) return found;
    }
    return nullptr;
  }

  ScriptedDialogs* dialogs_ = nullptr;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(ComparingWindow, FiguresAndArrowsStayAsLongAsThePanel) {
  compare(houses(5, 12.0), houses(6, 0.0));
  ASSERT_TRUE(isCompared());
  const QRect map(window_->canvas().mapToGlobal(QPoint()), window_->canvas().size());
  EXPECT_FALSE(map.intersects(QRect(dock()->mapToGlobal(QPoint()), dock()->size())))
      << "the arrows stay in sight";
  EXPECT_EQ(figures()->columnCount(), 2);
  ASSERT_NE(arrows(), nullptr);
  EXPECT_EQ(arrows()->arrows().size(), 5);
  EXPECT_EQ(arrows()->arrows()[0], QLineF(0.0, 0.0, 12.0, 0.0));
  EXPECT_EQ(arrows()->missing().size(), 1);
  document_.setSelection({"b0"});
  window_->canvas().deleteSelected();
  EXPECT_TRUE(QTest::qWaitFor([&] { return arrows()->arrows().size() == 4; }, kPatienceMs));
  action(*window_, "view.inspector")->trigger();
  EXPECT_EQ(arrows()->arrows().size(), 4) << "folded, there is more room for them";
  action(*window_, "view.inspector")->trigger();
  dock()->close();
  EXPECT_TRUE(arrows()->arrows().isEmpty());
  EXPECT_TRUE(arrows()->missing().isEmpty());
}

TEST_F(ComparingWindow, TheTableIsThatOfTheCommandLine) {
  compare(houses(5, 12.0), houses(6, 0.0));
  ASSERT_TRUE(isCompared());
  dialogs_->paths = {path("out.csv")};
  dock()->findChild<QPushButton*>("comparison_save")->click();
  const std::string told = figureTable({figuresOf(
      readSketch(path("drawing.handmap").toStdString(), path("truth.handmap").toStdString()))});
  EXPECT_EQ(readFile(path("out.csv").toStdString(), 1 << 20), told);
}

TEST_F(ComparingWindow, AnotherDrawingEndsIt) {
  compare(houses(5, 12.0), houses(6, 0.0));
  ASSERT_TRUE(isCompared());
  action(*window_, "file.new")->trigger();
  EXPECT_FALSE(isCompared());
  EXPECT_TRUE(arrows()->arrows().isEmpty());
}

TEST_F(ComparingWindow, TooLittleInCommonIsTold) {
  compare(houses(2, 12.0), houses(6, 0.0));
  EXPECT_FALSE(isCompared());
  EXPECT_TRUE(message(*window_).contains("too little in common: 2 building"))
      << message(*window_).toStdString();
}

TEST_F(ComparingWindow, WhatIsNoMapIsTold) {
  QFile file(path("no.handmap"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("no map");
  file.close();
  document_.reset(houses(5, 0.0));
  dialogs_->paths = {path("no.handmap")};
  action(*window_, "file.compare")->trigger();
  EXPECT_FALSE(isCompared());
  EXPECT_TRUE(message(*window_).contains("no.handmap")) << message(*window_).toStdString();
  document_.reset();
}

TEST_F(ComparingWindow, AfterARunTheCorrectedMapStandsBesideTheDrawing) {
  runSimulator(*window_);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window_->run().result() != nullptr; }, kPatienceMs));
  action(*window_, "file.compare")->trigger();
  ASSERT_TRUE(isCompared());
  EXPECT_TRUE(dialogs_->asked.isEmpty());  // the simulator knows
  ASSERT_EQ(figures()->columnCount(), 3);
  const QTreeWidgetItem* things = figures()->topLevelItem(0);
  for (int i = 0; i < things->childCount(); ++i) {
    EXPECT_FALSE(things->child(i)->text(2).isEmpty()) << i;
  }
}

}  // namespace
}  // namespace handmap
