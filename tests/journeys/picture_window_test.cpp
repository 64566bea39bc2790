// Pictures under the drawing, from the menu and dropped on the window.
#include <QDir>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QFile>
#include <QMimeData>
#include <QPushButton>

#include <gtest/gtest.h>

#include "app/gui/files/file_actions.h"
#include "app/gui/run/source_actions.h"
#include "core/geodata/robot_map.h"
#include "core/map/map_io.h"
#include "tests/journeys/scripted_dialogs.h"
#include "tests/journeys/window_test.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/importing/bag_dialog.h"
#include "widgets/importing/import_dialog.h"
#include "widgets/tools/picture_tool.h"
#include "widgets/tools/toolbox.h"

namespace handmap {
namespace {

class PictureWindow : public WindowTest {
 protected:
  PictureWindow() {
    auto dialogs = std::make_unique<ScriptedDialogs>();
    dialogs_ = dialogs.get();
    window_ = std::make_unique<MainWindow>(document_, settings_, std::move(dialogs));
    window_->show();
    EXPECT_TRUE(QDir(folder_.path()).mkdir("elsewhere"));
    EXPECT_TRUE(QImage(400, 200, QImage::Format_RGB32).save(path("elsewhere/photo.png")));
  }
  ~PictureWindow() override { document_.undoStack().setClean(); }

  void add(const QString& name) {
    dialogs_->paths = {path(name)};
    window_->findChild<QAction*>("draw.add_picture")->trigger();
  }
  void drop(const QString& name) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path(name))});
    QDragEnterEvent enter(QPoint(200, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window_.get(), &enter);
    QDropEvent event(QPointF(200.0, 300.0), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window_.get(), &event);
  }
  QString newest() const {
    const auto messages = window_->messages().messages();
    return messages.isEmpty() ? QString() : messages.front()->text();
  }

  ScriptedDialogs* dialogs_ = nullptr;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(PictureWindow, APictureIsAddedSelectedAndReadyToBeMoved) {
  add("elsewhere/photo.png");
  ASSERT_EQ(document_.map().underlays.size(), 1u);
  EXPECT_EQ(document_.map().underlays[0].image, path("elsewhere/photo.png").toStdString());
  EXPECT_EQ(document_.selection(), QStringList{pictureKey(0)});
  EXPECT_EQ(window_->canvas().tool(), ToolId::Picture);
  EXPECT_TRUE(document_.trustsReferences()) << "chosen by hand";
  EXPECT_TRUE(newest().contains("“photo.png” lies under the drawing")) << newest().toStdString();
  window_->findChild<QAction*>("edit.delete")->trigger();
  EXPECT_TRUE(document_.map().underlays.empty());
}

TEST_F(PictureWindow, ASavedDrawingNamesItFromItsOwnFolder) {
  document_.save(path("m.handmap"));
  drop("elsewhere/photo.png");
  ASSERT_EQ(document_.map().underlays.size(), 1u);
  EXPECT_EQ(document_.map().underlays[0].image, "elsewhere/photo.png");
  const Underlay& underlay = document_.map().underlays[0];
  const double middle = underlay.x + 200.0 * underlay.metres_per_pixel;
  EXPECT_LT(middle, window_->canvas().visibleMetres().center().x()) << "where it was dropped";
}

TEST_F(PictureWindow, AWorldFileIsBelievedAndItsPlaceTakenOver) {
  QFile file(path("elsewhere/photo.pgw"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("0.000005\n0\n0\n-0.000004\n137.4\n34.7\n");
  file.close();
  add("elsewhere/photo.png");
  ASSERT_TRUE(document_.map().georeference.has_value());
  EXPECT_NEAR(document_.map().georeference->latitude, 34.7, 0.01);
  EXPECT_NEAR(document_.map().underlays[0].metres_per_pixel, 0.45, 0.02);
  EXPECT_TRUE(newest().contains("lies where its file says")) << newest().toStdString();
  document_.undoStack().undo();
  EXPECT_FALSE(document_.map().georeference.has_value()) << "one step";
}

TEST_F(PictureWindow, HostilePicturesAreToldAndNothingIsAdded) {
  QFile file(path("bad.png"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("\x89PNG but no more");
  file.close();
  add("bad.png");
  EXPECT_TRUE(newest().contains("bad.png")) << newest().toStdString();
  drop("bad.png");
  add("gone.png");
  EXPECT_TRUE(newest().contains("no such file")) << newest().toStdString();
  EXPECT_TRUE(document_.map().underlays.empty());
}

/// Four buildings, and the robot map of them.
Map fourBuildings() {
  Map map;
  for (const Rectangle& box :
       {Rectangle{{15.0, 18.0}, 20.0, 10.0, 0.0}, Rectangle{{50.0, 22.0}, 30.0, 14.0, 0.0},
        Rectangle{{20.0, -16.0}, 34.0, 12.0, 0.0}, Rectangle{{62.0, -20.0}, 18.0, 18.0, 0.0}}) {
    Building building;
    building.id = "B" + std::to_string(map.buildings.size() + 1);
    building.shape = box;
    map.buildings.push_back(building);
  }
  map.uncertainty.position = 0.5;
  return map;
}

TEST_F(PictureWindow, AMapOfARobotIsLaidWhereItLies) {
  writeRobotMap(fourBuildings(), path("elsewhere/grid.yaml").toStdString());
  // The same place in a frame of its own.
  Map drawing = fourBuildings();
  const Pose2 place{30.0, -12.0, 0.6};
  for (Building& building : drawing.buildings) {
    auto& box = std::get<Rectangle>(building.shape);
    box.centre = place.toOuter(box.centre);
    box.heading = 0.6;
  }
  document_.reset(drawing);
  document_.undoStack().setClean();
  drop("elsewhere/grid.yaml");
  ASSERT_TRUE(QTest::qWaitFor([&] { return document_.map().underlays.size() == 1; }, kPatienceMs));
  const Underlay& underlay = document_.map().underlays[0];
  EXPECT_EQ(underlay.image, path("elsewhere/grid.pgm").toStdString());
  const RobotGrid grid = readRobotGrid(path("elsewhere/grid.yaml").toStdString());
  const Underlay right = underlayOf(grid, place);
  EXPECT_LT(std::hypot(underlay.x - right.x, underlay.y - right.y), 0.3);
  EXPECT_NEAR(underlay.heading, 0.6, 0.01);
  EXPECT_EQ(underlay.metres_per_pixel, 0.1);
  EXPECT_TRUE(newest().contains("lies on the drawing")) << newest().toStdString();
  document_.undoStack().undo();
  EXPECT_TRUE(document_.map().underlays.empty()) << "one step";
}

TEST_F(PictureWindow, AMapOfARobotThatIsNoneIsTold) {
  QFile file(path("no.yaml"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("image: 7\n");
  file.close();
  add("no.yaml");
  ASSERT_TRUE(QTest::qWaitFor([&] { return newest().contains("no.yaml: "); }, kPatienceMs));
  EXPECT_TRUE(document_.map().underlays.empty());
  // Another drawing is opened while it is sought.
  writeRobotMap(fourBuildings(), path("grid.yaml").toStdString());
  add("grid.yaml");
  document_.reset(Map());
  EXPECT_TRUE(waitForBackground(std::chrono::seconds(30)));
  QCoreApplication::processEvents();
  EXPECT_TRUE(document_.map().underlays.empty());
}

TEST_F(PictureWindow, ADrawingOfSomebodyElseIsNotTrustedByAddingOneOfMine) {
  Map map;
  map.underlays.push_back({"../secret.png", 0.0, 0.0, 1.0, 0.0, 1.0, {}});
  writeMap(map, path("elsewhere/theirs.handmap").toStdString());
  ASSERT_TRUE(window_->files().open(path("elsewhere/theirs.handmap")));
  add("elsewhere/photo.png");
  EXPECT_EQ(document_.map().underlays.size(), 2u);
  EXPECT_FALSE(document_.trustsReferences());
}

TEST_F(PictureWindow, ThePropertiesScaleItByALength) {
  add("elsewhere/photo.png");
  auto press = [&](const char* name) { window_->findChild<QPushButton*>(name)->click(); };
  press("by_length");
  PictureTool& tool = window_->tools().pictureTool();
  EXPECT_EQ(tool.mode(), PictureTool::Mode::Scale);
  ToolEvent event;
  for (const double x : {0.0, 10.0}) {
    event.position = event.snapped = Vec2(x, 0.0);
    tool.press(event);
    tool.release(event);
  }
  const double before = document_.map().underlays[0].metres_per_pixel;
  auto* length = window_->findChild<QDoubleSpinBox*>("length");
  ASSERT_TRUE(length->isEnabled());
  EXPECT_EQ(length->value(), 10.0);
  length->setFocus();
  length->selectAll();
  QTest::keyClicks(length, "25");
  QTest::keyClick(length, Qt::Key_Return);
  EXPECT_NEAR(document_.map().underlays[0].metres_per_pixel, 2.5 * before, 1e-9);
  EXPECT_FALSE(length->isEnabled());
}

/// Named on the command line, chosen at Open or dropped: the same is offered.
class AnyFile : public PictureWindow, public testing::WithParamInterface<bool> {
 protected:
  void open(const QString& name) {
    GetParam() ? drop(name) : void(window_->files().open(path(name)));
  }
  void write(const QString& name, const QByteArray& text) const {
    QFile file(path(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
  }
};

TEST_P(AnyFile, ATableIsImported) {
  write("drive.csv", "time_s,x_m,y_m,heading_rad\n0,0,0,0\n1,1,0,0\n");
  open("drive.csv");
  auto* dialog = window_->findChild<ImportDialog*>();
  ASSERT_NE(dialog, nullptr) << newest().toStdString();
  dialog->reject();
}

TEST_P(AnyFile, ABagIsImported) {
  write("drive.bag", "#ROSBAG V2.0\n");
  open("drive.bag");
  auto* dialog = window_->findChild<BagDialog*>();
  ASSERT_NE(dialog, nullptr) << newest().toStdString();
  dialog->reject();
}

TEST_P(AnyFile, ARobotIsConnected) {
  write("cart.json", R"({"format": "handmap-rig", "version": 1, "name": "Cart",
      "scanner": {"kind": "hokuyo", "port": "tcp://127.0.0.1:9"}})");
  open("cart.json");
  EXPECT_TRUE(newest().contains("Cart")) << newest().toStdString();
  ASSERT_TRUE(window_->sources().robot());
  EXPECT_TRUE(window_->sources().robot()->live);
}

TEST_P(AnyFile, AFolderIsARecordingOrADriveToBeImported) {
  QDir(folder_.path()).mkdir("rec");
  write("rec/recording.json", R"({"format":"handmap-recording","version":1})");
  open("rec");
  EXPECT_TRUE(QTest::qWaitFor([&] { return newest().contains("frames.csv"); }, kPatienceMs))
      << newest().toStdString();
  QDir(folder_.path()).mkpath("drive/image_00/data");
  write("drive/image_00/timestamps.txt", "2011-09-26 13:04:34.977012964\n");
  dialogs_->paths = {path("made")};
  open("drive");
  EXPECT_TRUE(QTest::qWaitFor([&] { return newest().contains("drive"); }, kPatienceMs))
      << newest().toStdString();
}

TEST_P(AnyFile, APictureLiesUnderTheDrawing) {
  open("elsewhere/photo.png");
  EXPECT_EQ(document_.map().underlays.size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Ways, AnyFile, testing::Bool());

}  // namespace
}  // namespace handmap
