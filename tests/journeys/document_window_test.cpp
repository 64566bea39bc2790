// What the window does with a drawing: exports, leaving, what a drawing names, menus and keys.
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QFileInfo>
#include <QMenuBar>
#include <QPushButton>
#include <QScreen>
#include <QToolButton>
#include <QtEndian>

#include <gtest/gtest.h>

#include "app/gui/files/file_actions.h"
#include "core/bags/bag.h"
#include "core/map/map_io.h"
#include "core/recording/recording.h"
#include "core/session/acts.h"
#include "tests/journeys/scripted_dialogs.h"
#include "tests/journeys/window_test.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/run/panels/buildings_panel.h"
#include "widgets/teach/teach_panel.h"

namespace handmap {
namespace {

class DocumentWindow : public WindowTest {
 protected:
  DocumentWindow() {
    auto dialogs = std::make_unique<ScriptedDialogs>();
    dialogs_ = dialogs.get();
    window_ = std::make_unique<MainWindow>(document_, settings_, std::move(dialogs));
    window_->show();
  }

  void trigger(const QString& id) { window_->findChild<QAction*>(id)->trigger(); }
  QStringList texts() const {
    QStringList texts;
    for (const Message* message : window_->messages().messages()) texts << message->text();
    return texts;
  }
  bool press(const QString& text) {
    for (const Message* message : window_->messages().messages()) {
      for (auto* button : message->findChildren<QPushButton*>()) {
        if (button->text() != text) continue;
        button->click();
        return true;
      }
    }
    return false;
  }
  /// A few frames of the simulator; the drawing was never saved.
  void runALittle() {
    runSimulator(*window_);
    ASSERT_TRUE(
        QTest::qWaitFor([this] { return window_->run().result() != nullptr; }, kPatienceMs));
    window_->run().stop();
    ASSERT_TRUE(QTest::qWaitFor([this] { return !window_->run().isActive(); }, kPatienceMs));
  }
  void drawAHouse() {
    Building house;
    house.shape = Rectangle{Vec2(0.0, 0.0), 10.0, 8.0, 0.0};
    document_.addBuilding(house);
  }
  void write(const QString& name, const QByteArray& content) const {
    QFile file(path(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(content);
  }
  QByteArray contentOf(const QString& name) const {
    QFile file(path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

  ScriptedDialogs* dialogs_ = nullptr;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(DocumentWindow, ADrawingThatWasNeverSavedIsExportedInEveryWay) {
  runALittle();
  document_.setGeoreference(Georeference{34.7, 137.4, 0.0, {}});
  dialogs_->paths = {path("refined.handmap"), path("refined.geojson"), path("drawn.geojson"),
                     path("town.osm"),        path("canvas.png"),      path("canvas.svg"),
                     path("canvas.pdf"),      path("way.tum")};
  trigger("file.export_map");
  EXPECT_TRUE(texts().first().startsWith("The corrected map is in “refined.handmap”"))
      << texts().first().toStdString();
  dialogs_->choices = {0, 1, 0};
  trigger("file.export_other");
  EXPECT_TRUE(texts().first().startsWith("The corrected map is in “refined.geojson”"));
  trigger("file.export_other");
  EXPECT_TRUE(texts().first().startsWith("The drawing is in “drawn.geojson”"));
  trigger("file.export_other");
  EXPECT_TRUE(contentOf("town.osm").contains("<osm"));
  for (int i = 0; i < 3; ++i) trigger("file.export_png");
  EXPECT_TRUE(contentOf("canvas.pdf").startsWith("%PDF"));
  const QByteArray svg = contentOf("canvas.svg");
  EXPECT_TRUE(svg.contains("Corrected map")) << "the legend";
  EXPECT_FALSE(svg.contains("Particles")) << "they are not shown";
  EXPECT_GT(svg.count("<path") + svg.count("<polyline"), 20) << "lines, and no picture of them";
  trigger("file.export_trajectory");
  EXPECT_TRUE(texts().first().contains(path("way.tum")));
  for (const char* name :
       {"refined.handmap", "refined.geojson", "drawn.geojson", "canvas.png", "way.tum"}) {
    EXPECT_GT(QFileInfo(path(name)).size(), 0) << name;
  }
  const auto count = document_.map().buildings.size();
  document_.undoStack().setClean();
  ASSERT_TRUE(window_->files().open(path("drawn.geojson"))) << texts().first().toStdString();
  EXPECT_EQ(document_.map().buildings.size(), count);
  EXPECT_TRUE(document_.filePath().isEmpty()) << "it is saved as a drawing, not over the GeoJSON";
  EXPECT_NEAR(document_.map().georeference->latitude, 34.7, 0.01);
  document_.setGeoreference(Georeference{34.7, 137.4, 0.0, {}});
  const Map refined = readMap(path("refined.handmap").toStdString());
  EXPECT_FALSE(refined.refinement.empty());
  EXPECT_EQ(refined.georeference, document_.map().georeference);
  document_.undoStack().setClean();
}

TEST_F(DocumentWindow, AnExportThatFailsIsTold) {
  document_.setGeoreference(Georeference{});
  dialogs_->paths = {path("no/such/folder/a.geojson"), path("no/such/folder/a.png")};
  trigger("file.export_other");
  trigger("file.export_png");
  ASSERT_EQ(texts().size(), 2);
  EXPECT_TRUE(texts().first().contains("no/such/folder/a.png")) << texts().first().toStdString();
  EXPECT_TRUE(texts().last().contains("no/such/folder/a.geojson"));
}

TEST_F(DocumentWindow, WhatNeedsAPlaceLeadsToWhereItIsSaid) {
  drawAHouse();
  dialogs_->paths = {path("a.kml"), path("a.dxf"), path("a.yaml")};
  trigger("file.export_other");
  EXPECT_TRUE(texts().first().contains(".kml")) << texts().first().toStdString();
  EXPECT_FALSE(QFile::exists(path("a.kml")));
  EXPECT_TRUE(press("Say where"));
  for (int i = 0; i < 2; ++i) trigger("file.export_other");
  EXPECT_TRUE(contentOf("a.dxf").contains("POLYLINE")) << texts().first().toStdString();
  EXPECT_TRUE(contentOf("a.yaml").contains("a.pgm"));
  EXPECT_TRUE(contentOf("a.pgm").startsWith("P5"));
  document_.undoStack().setClean();
}

TEST_F(DocumentWindow, AMapOfRobotsOfALargePlaceGetsCoarserCells) {
  drawAHouse();
  Building far;
  far.id = "far";
  far.shape = Rectangle{Vec2(3000.0, 0.0), 10.0, 8.0, 0.0};
  document_.addBuilding(far);
  dialogs_->paths = {path("a.yaml")};
  trigger("file.export_other");
  EXPECT_TRUE(texts().first().startsWith(
      "The drawing (in cells of 0.2 m, it is a large place) is in “a.yaml”."));
  EXPECT_TRUE(contentOf("a.yaml").contains("resolution: 0.2"));
  document_.undoStack().setClean();
}

TEST_F(DocumentWindow, AMapOfRobotsTakesNoPictureFromTheDrawing) {
  drawAHouse();
  QImage(8, 8, QImage::Format_Grayscale8).save(path("plan.pgm"));
  const QByteArray plan = contentOf("plan.pgm");
  Map map = document_.map();
  map.underlays.push_back({path("plan.pgm").toStdString()});
  document_.reset(map);
  dialogs_->paths = {path("plan.yaml")};
  trigger("file.export_other");
  EXPECT_TRUE(texts().first().contains("belongs to the drawing")) << texts().first().toStdString();
  EXPECT_EQ(contentOf("plan.pgm"), plan);
  document_.undoStack().setClean();
}

/// With what was said of it.
TEST_F(DocumentWindow, ARunOfTheSimulatorBecomesARecording) {
  EXPECT_FALSE(window_->findChild<QAction*>("file.export_recording")->isEnabled());
  runSimulator(*window_);
  ASSERT_TRUE(waitFor(*window_, RunState::Idle));
  const auto before = window_->run().result()->last->trajectory.all();
  const std::string gone = document_.map().buildings[1].id;
  document_.setSelection({QString::fromStdString(gone)});
  trigger("run.not_there");
  dialogs_->paths = {path("drive")};
  trigger("file.export_recording");
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return texts().filter("The recording is in “drive”").size() == 1; }, kPatienceMs))
      << texts().join('\n').toStdString();
  const Recording recording = openRecording(path("drive").toStdString());
  EXPECT_EQ(recording.rows.size(), before.size());
  EXPECT_EQ(recording.truth.poses().size(), before.size());
  const auto acts = readActs(path("drive").toStdString());
  ASSERT_EQ(acts.size(), 1U);
  EXPECT_EQ(acts[0].kind, Act::Kind::BuildingIsNotThere);
  EXPECT_EQ(acts[0].building, gone);
  dialogs_->paths = {path("drive")};
  trigger("file.export_recording");
  EXPECT_TRUE(QTest::qWaitFor([&] { return texts().filter("drive").size() >= 2; }, kPatienceMs))
      << "not over one that is there: " << texts().join('\n').toStdString();
  EXPECT_EQ(openRecording(path("drive").toStdString()).rows.size(), before.size());
  document_.undoStack().setClean();
}

TEST_F(DocumentWindow, ARecordingIsLookedForBesideTheDrawing) {
  drawAHouse();
  dialogs_->paths = {path("place.handmap")};
  trigger("file.save");
  trigger("run.open_recording");
  EXPECT_EQ(dialogs_->folder, QFileInfo(path("place.handmap")).path());
  dialogs_->paths = {path("nowhere")};
  trigger("run.open_recording");
  trigger("run.open_recording");
  EXPECT_EQ(dialogs_->folder, path("nowhere")) << "then where the last one was";
}

TEST_F(DocumentWindow, ARunIsExportedAsAPageAsMcapAndAsAFilm) {
  EXPECT_FALSE(window_->findChild<QAction*>("file.export_report")->isEnabled());
  runSimulator(*window_);
  ASSERT_TRUE(QTest::qWaitFor([this] { return window_->run().result() != nullptr; }, kPatienceMs));
  EXPECT_FALSE(window_->findChild<QAction*>("file.export_report")->isEnabled()) << "not at its end";
  ASSERT_TRUE(waitFor(*window_, RunState::Idle));
  dialogs_->paths = {path("run.html"), path("run.mcap"), path("run.avi")};
  const auto told = [this](const QString& what) {
    return QTest::qWaitFor([&] { return texts().filter(what).size() == 1; }, kPatienceMs);
  };
  trigger("file.export_report");
  ASSERT_TRUE(told("The report of the run is in “run.html”")) << texts().join('\n').toStdString();
  const QByteArray page = contentOf("run.html");
  for (const char* part : {"refined.handmap", "trajectory.tum", "\"seed\"", "\"truth\":[["})
    EXPECT_TRUE(page.contains(part)) << part;
  trigger("file.export_mcap");
  ASSERT_TRUE(told("The run is in “run.mcap”")) << texts().join('\n').toStdString();
  const auto bag = openBag(path("run.mcap").toStdString());
  const auto poses = std::ranges::find(bag->topics(), std::string("/pose"), &BagTopic::name);
  ASSERT_NE(poses, bag->topics().end());
  EXPECT_EQ(poses->messages, window_->run().result()->last->trajectory.all().size());
  trigger("file.export_film");
  ASSERT_TRUE(told("The film of the run is in “run.avi”")) << texts().join('\n').toStdString();
  const QByteArray film = contentOf("run.avi");
  EXPECT_TRUE(film.startsWith("RIFF"));
  constexpr qsizetype kFrames = 48;  // where an AVI file says how many it has
  ASSERT_GT(film.size(), kFrames + 4);
  EXPECT_EQ(qFromLittleEndian<quint32>(film.constData() + kFrames), poses->messages);
  EXPECT_TRUE(QDir(path("")).entryList({"*.part*"}).isEmpty());
  document_.undoStack().setClean();
}

TEST_F(DocumentWindow, ABagBecomesARecording) {
  const QString bag =
      QStringLiteral(HANDMAP_SOURCES "/../shared/data/bags/kitti_street_excerpt.bag");
  if (!QFile::exists(bag)) GTEST_SKIP() << bag.toStdString() << " is not there";
  dialogs_->paths = {bag, path("street")};
  trigger("file.import_log");
  auto* dialog = window_->findChild<QDialog*>("bag_dialog");
  ASSERT_TRUE(dialog);
  QPushButton* import = nullptr;
  for (auto* button : dialog->findChildren<QPushButton*>())
    if (button->text().startsWith("Import")) import = button;
  ASSERT_TRUE(import);
  ASSERT_TRUE(QTest::qWaitFor([&] { return import->isEnabled(); }, kPatienceMs));
  import->click();
  EXPECT_TRUE(texts().first().contains("is being made")) << texts().first().toStdString();
  ASSERT_TRUE(QTest::qWaitFor([this] { return texts().filter("“street” is open:").size() == 1; },
                              kPatienceMs))
      << texts().join('\n').toStdString();
  EXPECT_TRUE(texts().filter("is being made").isEmpty());
  EXPECT_TRUE(QFile::exists(path("street/frames.csv")));
}

TEST_F(DocumentWindow, AcceptingAsksForWhatWasEditedDuringTheRun) {
  runALittle();
  window_->runPanels().buildings.model().setAllTaken(true);
  const QString id = QString::fromStdString(document_.map().buildings.front().id);
  const Building edited = moved(document_.map().buildings.front(), Vec2(0.0, 3.0));
  document_.changeBuilding(id, edited, "Move");
  const Map before = document_.map();
  trigger("run.accept");
  EXPECT_EQ(document_.map(), before) << "not without an answer";
  ASSERT_TRUE(press("Take all others"));
  EXPECT_EQ(document_.map().buildings.front(), edited);
  EXPECT_NE(document_.map(), before);
  trigger("run.accept");
  ASSERT_TRUE(press("Take all"));
  EXPECT_NE(document_.map().buildings.front().shape, edited.shape);
  trigger("run.accept");
  EXPECT_FALSE(press("Take all")) << "nobody has edited anything since";

  document_.changeBuilding(id, edited, "Move");
  trigger("run.accept");
  document_.undoStack().setClean();
  trigger("file.new");
  EXPECT_FALSE(press("Take all")) << "the question was of another drawing";
}

TEST_F(DocumentWindow, LeavingAsksForWhatWasTaught) {
  TeachPanel& teach = window_->teach();
  teach.setModel(std::make_shared<const BuildingClassifier>(BuildingClassifier::builtIn(false)));
  teach.setUnsaved();
  EXPECT_FALSE(window_->close()) << "cancelled";
  dialogs_->choices = {0};
  EXPECT_FALSE(window_->close()) << "no file was chosen";
  dialogs_->choices = {0};
  dialogs_->paths = {path("mine.json")};
  EXPECT_TRUE(window_->close());
  EXPECT_TRUE(QFile::exists(path("mine.json")));
}

TEST_F(DocumentWindow, LeavingAsksForWhatWasPaintedAndNotTrained) {
  TeachPanel& teach = window_->teach();
  teach.addTeaching({{{path("photo.png"), {WindowLabel::Building}}}});
  EXPECT_FALSE(window_->close());
  dialogs_->choices = {1};
  EXPECT_TRUE(window_->close());
}

TEST_F(DocumentWindow, WhatLiesOutsideOfTheFolderIsReadWhenSomebodySaysSo) {
  ASSERT_TRUE(QDir(folder_.path()).mkdir("maps"));
  BuildingClassifier::builtIn(false).save(path("outside.json").toStdString());
  write("maps/yard.handmap",
        R"({"format":"handmap","version":1,"buildings":[],"handmap:model":"../outside.json"})");
  ASSERT_TRUE(window_->files().open(path("maps/yard.handmap")));
  EXPECT_FALSE(window_->teach().classifier());
  ASSERT_EQ(texts().size(), 1);
  EXPECT_TRUE(texts().first().contains("../outside.json")) << texts().first().toStdString();
  ASSERT_TRUE(press("Read them"));
  EXPECT_TRUE(window_->teach().classifier());
  EXPECT_TRUE(document_.trustsReferences());

  window_->files().replace({});
  EXPECT_FALSE(document_.trustsReferences());
  ASSERT_TRUE(window_->files().open(path("maps/yard.handmap")));
  EXPECT_TRUE(texts().isEmpty()) << "asked once for each drawing";
  EXPECT_TRUE(window_->teach().classifier());

  write("maps/other.handmap",
        R"({"format":"handmap","version":1,"buildings":[],"handmap:model":"../outside.json"})");
  ASSERT_TRUE(window_->files().open(path("maps/other.handmap")));
  EXPECT_EQ(texts().size(), 1);
  window_->files().replace({});
  EXPECT_TRUE(texts().isEmpty()) << "the question was of another drawing";
}

TEST_F(DocumentWindow, NothingIsWrittenOverWhatIsRead) {
  QDir().mkpath(path("R"));
  write("R/frames.csv", "frame,time_s,stop,pan_deg,left,right,points\n");
  write("R/odometry.tum", "# as it was");
  runALittle();
  dialogs_->paths = {path("mine.handmap")};
  trigger("file.save");
  const QByteArray mine = contentOf("mine.handmap");
  dialogs_->paths = {path("R/odometry.tum"), path("mine.handmap"), path("R/frames.csv"),
                     path("R/recording.json")};
  for (const char* id :
       {"file.export_trajectory", "file.export_map", "file.export_png", "file.save_as"}) {
    trigger(id);
    const QString said = texts().first();
    EXPECT_TRUE(said.contains("recording") || said.contains("belongs to the drawing"))
        << id << ": " << said.toStdString();
  }
  EXPECT_EQ(contentOf("R/odometry.tum"), "# as it was");
  EXPECT_EQ(contentOf("mine.handmap"), mine);
  EXPECT_FALSE(QFile::exists(path("R/recording.json")));
}

TEST_F(DocumentWindow, FitsASmallScreen) {
  constexpr QSize kSmall(790, 550);  // 800 × 600 without the frame
  window_->docks().showRunDocks(true, true);
  for (const char* id : {"run.teach", "help.shortcuts"}) trigger(id);
  window_->transport().setSource("a recording with quite a long name");
  window_->showNormal();
  window_->resize(kSmall);
  QTest::qWait(1);
  EXPECT_EQ(window_->size(), kSmall);
  auto* more = window_->transport().findChild<QToolButton*>("qt_toolbar_ext_button");
  ASSERT_TRUE(more);
  EXPECT_FALSE(more->isVisible()) << "buttons of the run hide behind »";
}

TEST_F(DocumentWindow, FloatingPanelsAreFoundAgainOnASmallerScreen) {
  trigger("run.teach");
  auto* panel = window_->findChild<QDockWidget*>("teach");
  ASSERT_TRUE(panel->isFloating() && panel->isVisible());
  panel->resize(3000, 2000);
  panel->move(2500, 1500);
  ASSERT_TRUE(window_->close());
  window_ = std::make_unique<MainWindow>(document_, settings_);
  window_->show();
  panel = window_->findChild<QDockWidget*>("teach");
  if (!panel->isVisible()) trigger("run.teach");
  EXPECT_TRUE(window_->screen()->availableGeometry().contains(panel->frameGeometry()))
      << panel->width() << " x " << panel->height() << " at " << panel->x() << ", " << panel->y();
}

TEST_F(DocumentWindow, NoTwoEntriesOfAMenuShareALetter) {
  const std::function<void(const QList<QAction*>&)> check = [&](const QList<QAction*>& entries) {
    QSet<QString> letters;
    for (const QAction* entry : entries) {
      const QString letter = QKeySequence::mnemonic(entry->text()).toString();
      if (!letter.isEmpty()) {
        EXPECT_FALSE(letters.contains(letter)) << entry->text().toStdString();
        letters.insert(letter);
      }
      if (entry->menu() != nullptr) check(entry->menu()->actions());
    }
  };
  ASSERT_FALSE(window_->menuBar()->actions().isEmpty());
  check(window_->menuBar()->actions());
}

TEST_F(DocumentWindow, EveryKeyOfTheSheetReachesItsAction) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
  window_->canvas().setFocus();
  for (const ActionSpec& spec : actionTable()) {
    if (!*spec.keys) continue;
    QAction* action = window_->findChild<QAction*>(QLatin1String(spec.id));
    int times = 0;
    QObject::disconnect(action, &QAction::triggered, nullptr, nullptr);  // whatever it would do
    QObject::connect(action, &QAction::triggered, window_.get(), [&times] { ++times; });
    action->setEnabled(true);
    action->setVisible(true);
    for (const QKeySequence& keys : QKeySequence::listFromString(QLatin1String(spec.keys))) {
      times = 0;
      QTest::keySequence(window_->windowHandle(), keys);
      EXPECT_EQ(times, 1) << spec.id << " by " << keys.toString().toStdString();
    }
    QObject::disconnect(action, &QAction::triggered, nullptr, nullptr);
  }
}

TEST_F(DocumentWindow, TheKeyOfTheSimulatorOpensItsMenu) {
  trigger("run.simulator");
  QWidget* menu = QApplication::activePopupWidget();
  ASSERT_TRUE(menu);
  menu->close();
}

}  // namespace
}  // namespace handmap
