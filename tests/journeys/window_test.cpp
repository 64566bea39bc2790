// Whole ways through the window, without a display.
#include "tests/journeys/window_test.h"

#include <QFile>
#include <QPushButton>

#include <gtest/gtest.h>

#include "app/gui/files/exports.h"
#include "app/gui/files/file_actions.h"
#include "core/map/map_io.h"
#include "core/recording/recording.h"
#include "core/simulation/simulated_source.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/run/panels/layers_panel.h"
#include "widgets/teach/teach_panel.h"

namespace handmap {
namespace {

TEST_F(WindowTest, ARunGoesToItsEndAndIsAcceptedAsOneStep) {
  const auto window = open();
  runSimulator(*window);
  const Map drawn = window->document().map();
  EXPECT_TRUE(action(*window, "run.pause")->isEnabled());
  EXPECT_FALSE(action(*window, "run.run")->isEnabled());
  ASSERT_TRUE(waitFor(*window, RunState::Idle));
  EXPECT_TRUE(window->runs().stateInWords().startsWith("Done"));
  const auto score = window->results().score();
  ASSERT_TRUE(score && score->maps && score->trajectories);
  EXPECT_LT(score->maps->corrected.front, score->maps->drawn.front);
  EXPECT_EQ(window->document().map(), drawn) << "a run never writes into the drawing";

  action(*window, "run.accept")->trigger();
  EXPECT_NE(window->document().map(), drawn);
  EXPECT_EQ(window->document().undoStack().count(), 1);
  action(*window, "edit.undo")->trigger();
  EXPECT_EQ(window->document().map(), drawn);
}

TEST_F(WindowTest, KeysOfDisabledCommandsSayWhyNot) {
  const auto window = open();
  QTest::keyClick(&window->canvas(), Qt::Key_F5);
  EXPECT_TRUE(message(*window).contains("no recording, robot or simulator is open"))
      << message(*window).toStdString();
  QStringList offered;
  for (const auto* button : window->messages().findChildren<QPushButton*>()) {
    offered << button->text();
  }
  EXPECT_EQ(offered.size(), 3) << offered.join(", ").toStdString();
  QTest::keyClick(&window->canvas(), Qt::Key_F6);
  EXPECT_TRUE(message(*window).contains("nothing is running")) << message(*window).toStdString();
}

TEST_F(WindowTest, ThereIsNoPastToLookAtBeforeARun) {
  const auto window = open();
  for (const char* id : {"run.back", "run.newest", "run.bookmark", "run.next_bookmark"})
    EXPECT_FALSE(action(*window, id)->isEnabled()) << id;
}

TEST_F(WindowTest, PauseStepResumeStop) {
  const auto window = open();
  runSimulator(*window);
  action(*window, "run.pause")->trigger();
  ASSERT_TRUE(waitFor(*window, RunState::Paused));
  const QString before = window->runs().stateInWords();
  action(*window, "run.step")->trigger();
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        return window->run().state() == RunState::Paused && window->runs().stateInWords() != before;
      },
      kPatienceMs));
  action(*window, "run.run")->trigger();
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return window->run().state() != RunState::Paused; }, kPatienceMs));
  action(*window, "run.stop")->trigger();  // grey if the run was faster
  ASSERT_TRUE(waitFor(*window, RunState::Idle));
  EXPECT_TRUE(action(*window, "run.run")->isEnabled());
  EXPECT_FALSE(action(*window, "run.stop")->isEnabled());
}

TEST_F(WindowTest, AStepFromRestTakesOneObservation) {
  const auto window = open();
  window->sources().openTwoRows();
  action(*window, "run.step")->trigger();
  ASSERT_TRUE(waitFor(*window, RunState::Paused));
  EXPECT_TRUE(window->runs().stateInWords().startsWith("Paused, 1 of"))
      << window->runs().stateInWords().toStdString();
}

TEST_F(WindowTest, TeachingOpensItsPanelAndTellsProblems) {
  const auto window = open();
  EXPECT_FALSE(window->teach().isVisible());
  action(*window, "run.teach")->trigger();
  EXPECT_TRUE(window->teach().isVisible());
  EXPECT_FALSE(window->teach().loadModel(path("none.json")));
  EXPECT_TRUE(message(*window).contains("none.json")) << message(*window).toStdString();
}

TEST_F(WindowTest, ClosesInTheMiddleOfARun) {
  auto window = open();
  runSimulator(*window);
  EXPECT_TRUE(window->close());
  EXPECT_FALSE(window->run().isActive());
  window.reset();
  EXPECT_TRUE(settings_.contains("window/geometry"));
}

TEST_F(WindowTest, AnotherDrawingEndsTheRun) {
  const auto window = open();
  runSimulator(*window);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window->run().result() != nullptr; }, kPatienceMs));
  action(*window, "file.new")->trigger();
  EXPECT_EQ(window->run().state(), RunState::Idle);
  EXPECT_EQ(window->run().result(), nullptr);
  EXPECT_FALSE(action(*window, "run.run")->isEnabled()) << "the simulator lived in that drawing";
  EXPECT_FALSE(action(*window, "run.accept")->isEnabled());
}

TEST_F(WindowTest, ABadFileIsAMessageAndTheDrawingStays) {
  const auto window = open();
  window->sources().openTwoRows();
  const Map before = window->document().map();
  QFile file(path("torn.handmap"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("{\"format\": \"handmap\",");
  file.close();
  EXPECT_FALSE(window->files().open(file.fileName()));
  EXPECT_TRUE(message(*window).contains("torn.handmap")) << message(*window).toStdString();
  EXPECT_EQ(window->document().map(), before);
}

TEST_F(WindowTest, AFolderThatIsNoRecordingIsAMessage) {
  const auto window = open();
  window->sources().openRecording(path("nowhere"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return message(*window).contains("nowhere"); }, kPatienceMs));
  EXPECT_FALSE(action(*window, "run.run")->isEnabled());
}

TEST_F(WindowTest, ADoubtAboutUnitsIsNotHiddenByWhatIsSaidLater) {
  auto source = simulate(twoRowWorld(3), {}, 3);
  RecordingWriter writer(path("far").toStdString(), source->info());
  while (auto observation = source->next()) {
    for (RangePoint& p : *observation->views[0].points) p = {1000 * p.x, 1000 * p.y, p.z, p.w};
    writer.add(*observation);
  }
  const auto window = open();
  const auto doubt = [&]() -> Message* {
    for (Message* message : window->messages().messages())
      if (message->text().contains("millimetres")) return message;
    return nullptr;
  };
  window->sources().openRecording(path("far"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return doubt() != nullptr; }, kPatienceMs));
  window->messages().show(MessageBar::Kind::Warning, "something else");
  EXPECT_TRUE(doubt()->isVisible());
  window->sources().openTwoRows();
  EXPECT_EQ(doubt(), nullptr) << "of a recording that is no more";
}

TEST_F(WindowTest, ADrawingWithoutAStartIsToldAtTheRun) {
  const auto window = open();
  window->sources().openTwoRows();
  window->document().setStart({});
  window->runs().runOrResume();
  ASSERT_TRUE(waitFor(*window, RunState::Idle));
  EXPECT_TRUE(message(*window).contains("start")) << message(*window).toStdString();
  window->document().undoStack().setClean();
}

TEST_F(WindowTest, TheSimulatorTakesTheDrawingItself) {
  const auto window = open();
  EXPECT_THROW(simulationOfDrawing({}, 1), Error);
  window->sources().openTwoRows();
  const Map drawing = window->document().map();
  const Robot robot = simulationOfDrawing(drawing, 3);
  ASSERT_TRUE(robot.truth_map);
  EXPECT_NE(robot.truth_map->buildings, drawing.buildings);
  EXPECT_EQ(simulationOfDrawing(drawing, 3).truth_map, robot.truth_map);
  EXPECT_GT(robot.connect({}, {}, {})->info().observations, 1);
}

TEST_F(WindowTest, LayersReachTheCanvas) {
  const auto window = open();
  window->sources().openTwoRows();
  window->canvas().zoomToFit();
  window->runPanels().layers.setOn(Layer::Truth, true);
  const auto picture = [&] { return window->canvas().viewport()->grab().toImage(); };
  const QImage all = picture();
  for (const Layer layer : {Layer::Drawing, Layer::Grid, Layer::Truth}) {
    window->runPanels().layers.setOn(layer, false);
    EXPECT_NE(picture(), all);
    window->runPanels().layers.setOn(layer, true);
    EXPECT_EQ(picture(), all);
  }
  action(*window, "view.grid")->trigger();
  EXPECT_FALSE(window->runPanels().layers.isOn(Layer::Grid));
}

TEST_F(WindowTest, PicturesAreWrittenWholeOrNotAtAll) {
  const auto window = open();
  writePicture(pictureOf(window->canvas()), path("canvas.png"));
  const QImage back(path("canvas.png"));
  EXPECT_EQ(back.size(), window->canvas().size() * 2);
  EXPECT_THROW(writePicture(back, path("no/such/folder.png")), Error);
}

TEST_F(WindowTest, ATaughtModelIsSavedAndOpenedWithItsMap) {
  const auto window = open();
  TeachPanel& teach = window->teach();
  const auto chosen = [&] {
    return window->runPanels().setup.setup().settings.perception.classifier;
  };
  auto* button = teach.findChild<QPushButton*>("save_with_map");
  EXPECT_FALSE(button->isEnabled());
  document_.save(path("yard.handmap"));
  teach.setModel(std::make_shared<const BuildingClassifier>(BuildingClassifier::builtIn(false)));
  EXPECT_FALSE(teach.isUnsaved());
  button->click();
  EXPECT_TRUE(message(*window).contains("yard.handmap")) << message(*window).toStdString();
  EXPECT_TRUE(QFile::exists(path("yard.model.json")));
  EXPECT_FALSE(document_.isModified());

  window->files().replace({});  // another drawing: the model goes with its own
  EXPECT_FALSE(teach.classifier());
  EXPECT_FALSE(chosen());
  ASSERT_TRUE(window->files().open(path("yard.handmap")));
  ASSERT_TRUE(chosen());
  EXPECT_EQ(chosen(), teach.classifier());
  EXPECT_EQ(teach.classifier()->toJson(), BuildingClassifier::builtIn(false).toJson());

  window->files().replace({});
  QFile::remove(path("yard.model.json"));
  EXPECT_TRUE(window->files().open(path("yard.handmap"))) << "the map opens without it";
  EXPECT_TRUE(message(*window).contains("yard.model.json")) << message(*window).toStdString();
  EXPECT_FALSE(chosen());
}

TEST_F(WindowTest, SavingTheMapSavesWhatWasTaughtAndIsInNoFile) {
  const auto window = open();
  document_.save(path("yard.handmap"));
  TeachPanel& teach = window->teach();
  ASSERT_TRUE(window->files().save());
  EXPECT_FALSE(QFile::exists(path("yard.model.json"))) << "nothing was taught";
  teach.setModel(std::make_shared<const BuildingClassifier>(BuildingClassifier::builtIn(true)));
  teach.setUnsaved();
  ASSERT_TRUE(window->files().save());
  EXPECT_TRUE(QFile::exists(path("yard.model.json")));
  EXPECT_FALSE(teach.isUnsaved());
  EXPECT_EQ(readMap(path("yard.handmap").toStdString()).model, "yard.model.json");
}

}  // namespace
}  // namespace handmap
