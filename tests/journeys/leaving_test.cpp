// What would be lost with a run is asked about; what belongs to a recording stays with it.
#include <QPushButton>
#include <QSignalSpy>
#include <QThread>
#include <algorithm>

#include "app/gui/files/file_actions.h"
#include "app/gui/run/live_robot.h"
#include "core/map/map_io.h"
#include "core/recording/recording.h"
#include "core/simulation/simulated_source.h"
#include "drivers/virtual/virtual_rig.h"
#include "tests/journeys/scripted_dialogs.h"
#include "tests/journeys/window_test.h"
#include "widgets/document/map_document.h"
#include "widgets/messages/message_bar.h"
#include "widgets/run/panels/timeline.h"

namespace handmap {
namespace {

class Leaving : public WindowTest {
 protected:
  Leaving() {
    auto dialogs = std::make_unique<ScriptedDialogs>();
    dialogs_ = dialogs.get();
    window_ = std::make_unique<MainWindow>(document_, settings_, std::move(dialogs));
    window_->show();
    world_ = twoRowWorld(3);
  }
  ~Leaving() override { document_.undoStack().setClean(); }

  void record(const QString& name, int observations) const {
    auto source = simulate(world_, {}, 3);
    RecordingWriter writer(path(name).toStdString(), source->info());
    for (int i = 0; i < observations; ++i) writer.add(*source->next());
  }
  bool openRecording(const QString& name) {
    QSignalSpy opened(&window_->sources(), &SourceActions::robotChanged);
    window_->sources().openRecording(path(name));
    return opened.wait(kPatienceMs);
  }
  void runToTheEnd() {
    window_->transport().setSpeed(0.0);
    window_->runs().runOrResume();
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return window_->run().result() && !window_->run().isActive(); }, kPatienceMs));
  }
  bool saysWhatToPress() const {
    const auto messages = window_->findChild<MessageBar*>()->messages();
    return std::ranges::any_of(messages, [](const Message* message) {
      return message->text().contains(QStringLiteral("is open: 8 "));
    });
  }
  RunSetupPanel& setup() { return window_->runPanels().setup; }

  World world_;
  ScriptedDialogs* dialogs_ = nullptr;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(Leaving, AFinishedRunThatNobodyAcceptedIsAskedAbout) {
  record("drive", 8);
  document_.reset(world_.map);
  ASSERT_TRUE(openRecording("drive"));
  runToTheEnd();
  EXPECT_FALSE(window_->files().mayLeave()) << "cancelled";
  EXPECT_EQ(dialogs_->asked, QStringList{"Leave this run?"});
  window_->sources().openRecording(path("drive"));
  EXPECT_EQ(dialogs_->asked.size(), 2) << "another source";
  action(*window_, "file.new")->trigger();
  EXPECT_EQ(dialogs_->asked.size(), 3);
  EXPECT_FALSE(window_->close());
  EXPECT_EQ(dialogs_->asked.size(), 4);
  ASSERT_TRUE(window_->run().result());
  dialogs_->choices = {0, 1};  // accept; do not save the drawing
  EXPECT_TRUE(window_->files().mayLeave());
  EXPECT_TRUE(document_.isModified());
  EXPECT_TRUE(document_.map().buildings[0].estimate);
  document_.undoStack().setClean();
  dialogs_->asked.clear();
  EXPECT_TRUE(window_->files().mayLeave());
  EXPECT_TRUE(dialogs_->asked.isEmpty());
}

/// Whether it was left behind finished or in the middle.
TEST_F(Leaving, NothingOfARunIsLeftWithAnotherRobot) {
  document_.reset(world_.map);
  for (const bool finished : {true, false}) {
    window_->sources().setRobot(simulatedRobot("other", world_, 3));
    if (finished) {
      runToTheEnd();
    } else {
      window_->runs().runOrResume();
      ASSERT_TRUE(QTest::qWaitFor([&] { return window_->run().result() != nullptr; }, kPatienceMs));
    }
    auto* accept = window_->findChild<QPushButton*>("accept_ticked");
    ASSERT_TRUE(QTest::qWaitFor([&] { return accept->isEnabled(); }, kPatienceMs));
    window_->sources().setRobot(simulatedRobot("other", world_, 4));
    EXPECT_FALSE(accept->isEnabled()) << "in the review";
    EXPECT_FALSE(action(*window_, "run.accept")->isEnabled());
    EXPECT_FALSE(message(*window_).contains("The run is done")) << message(*window_).toStdString();
  }
}

TEST_F(Leaving, WhatWasAcceptedAndTakenBackIsAskedAbout) {
  record("drive", 8);
  document_.reset(world_.map);
  ASSERT_TRUE(openRecording("drive"));
  runToTheEnd();
  action(*window_, "run.accept")->trigger();
  action(*window_, "edit.undo")->trigger();
  EXPECT_FALSE(window_->files().mayLeave()) << "cancelled";
  EXPECT_EQ(dialogs_->asked, QStringList{"Leave this run?"});
}

TEST_F(Leaving, WhatMayGoIsAskedAboutOnce) {
  record("drive", 8);
  document_.reset(world_.map);
  ASSERT_TRUE(openRecording("drive"));
  runToTheEnd();
  dialogs_->choices = {1};
  EXPECT_TRUE(window_->files().mayLeave());
  EXPECT_TRUE(window_->files().mayLeave());
  EXPECT_EQ(dialogs_->asked.size(), 1);
}

TEST_F(Leaving, WhatASimulatorGaveIsNotAskedAbout) {
  runSimulator(*window_);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window_->run().result() && !window_->run().isActive(); },
                              kPatienceMs));
  EXPECT_TRUE(window_->files().mayLeave());
  EXPECT_TRUE(dialogs_->asked.isEmpty());
}

TEST_F(Leaving, ALiveDriveThatIsNotRecordedIsAskedAbout) {
  document_.reset(world_.map);
  Robot robot = virtualRobot(world_, 3, VirtualRigKind::Laser);
  robot.truth_map.reset();  // as a real one, which is not had again
  window_->sources().setRobot(std::move(robot));
  window_->runs().runOrResume();
  ASSERT_TRUE(QTest::qWaitFor([&] { return window_->run().result() != nullptr; }, kPatienceMs));
  EXPECT_FALSE(window_->close());
  EXPECT_EQ(dialogs_->asked, QStringList{"Leave this run?"});
  EXPECT_TRUE(window_->run().isActive());
  dialogs_->choices = {0};
  EXPECT_TRUE(window_->close());
}

TEST_F(Leaving, ADriveThatGoesOnIsNotEndedWithoutAWord) {
  document_.reset(world_.map);
  const VirtualDrive drive{world_, 3};
  Rig rig = virtualRig(drive);
  rig.record = path("drives").toStdString();
  window_->sources().setRobot(liveRobot(rig, virtualDevices(drive)));
  window_->runs().runOrResume();
  ASSERT_TRUE(QTest::qWaitFor([&] { return window_->run().result() != nullptr; }, kPatienceMs));
  action(*window_, "file.new")->trigger();
  EXPECT_EQ(dialogs_->asked, QStringList{"Leave this run?"});
  EXPECT_FALSE(window_->files().open(path("other.handmap")));
  EXPECT_FALSE(window_->close());
  EXPECT_TRUE(window_->run().isActive());
  EXPECT_EQ(document_.map().buildings.size(), world_.map.buildings.size());
  dialogs_->choices = {0};
  EXPECT_TRUE(window_->close());
  EXPECT_EQ(dialogs_->asked.size(), 4);
}

TEST_F(Leaving, WhatIsStillWrittenIsAskedAbout) {
  const auto write = [this] {
    dialogs_->paths = {path("long.html")};
    window_->files().exportInBackground({"Export", "long", {}, "html", "The report"},
                                        [](const QString&, const std::stop_token& stop) {
                                          while (!stop.stop_requested()) QThread::msleep(1);
                                          return false;
                                        });
    dialogs_->asked.clear();
  };
  write();
  EXPECT_FALSE(window_->close()) << "cancelled";
  EXPECT_EQ(dialogs_->asked, QStringList{"Stop writing?"});
  ASSERT_EQ(window_->messages().messages().size(), 1);
  QTest::mouseClick(window_->messages().findChild<QPushButton*>(), Qt::LeftButton);
  ASSERT_TRUE(waitForBackground(std::chrono::seconds(30)));
  QCoreApplication::processEvents();
  EXPECT_TRUE(window_->close()) << "by its button it was stopped";
  EXPECT_EQ(dialogs_->asked.size(), 1);
  window_->show();
  write();
  dialogs_->choices = {0};
  EXPECT_TRUE(window_->close());
}

TEST_F(Leaving, ARunThatTakesAPartSaysSo) {
  record("drive", 8);
  document_.reset(world_.map);
  ASSERT_TRUE(openRecording("drive"));
  window_->sources().setTrim(2, 7);
  window_->transport().setSpeed(0.0);
  window_->runs().runOrResume();
  EXPECT_TRUE(message(*window_).contains("begins with frame 2")) << message(*window_).toStdString();
}

TEST_F(Leaving, WhatIsAcceptedTwiceIsTold) {
  record("drive", 8);
  document_.reset(world_.map);
  ASSERT_TRUE(openRecording("drive"));
  runToTheEnd();
  action(*window_, "run.accept")->trigger();
  action(*window_, "run.accept")->trigger();
  EXPECT_EQ(document_.undoStack().count(), 1);
  EXPECT_TRUE(message(*window_).contains("already")) << message(*window_).toStdString();
}

TEST_F(Leaving, AnotherLanguageBringsTheRecordingAndItsRunBack) {
  record("drive", 8);
  writeMap(world_.map, path("m.handmap").toStdString());
  ASSERT_TRUE(window_->files().open(path("m.handmap")));
  ASSERT_TRUE(openRecording("drive"));
  runToTheEnd();
  QStringList opened;
  window_->files().setWindowOpener([&](const QStringList& arguments) { opened = arguments; });
  window_->files().startAgain();
  EXPECT_TRUE(dialogs_->asked.isEmpty()) << "nothing is lost";
  EXPECT_EQ(opened, (QStringList{path("m.handmap"), "--recording", path("drive"), "--run", "--fast",
                                 "--seed", "1"}));
}

TEST_F(Leaving, ARunThatBeginsAtOnceIsNotAskedFor) {
  record("drive", 8);
  document_.reset(world_.map);
  ASSERT_TRUE(openRecording("drive"));
  EXPECT_TRUE(saysWhatToPress());
  QObject::connect(&window_->sources(), &SourceActions::robotChanged, &window_->runs(),
                   &TransportActions::runOrResume, Qt::SingleShotConnection);
  ASSERT_TRUE(openRecording("drive"));
  QCoreApplication::processEvents();
  EXPECT_FALSE(saysWhatToPress());
}

TEST_F(Leaving, WhichPartIsTakenBelongsToTheRecording) {
  record("one", 8);
  record("two", 8);
  ASSERT_TRUE(openRecording("one"));
  window_->sources().setTrim(2, 5);
  EXPECT_EQ(setup().replay().from, 2);
  EXPECT_EQ(setup().replay().to, 5);
  ASSERT_TRUE(openRecording("two"));
  EXPECT_EQ(setup().replay().from, 0) << "nobody asked for it of this one";
  EXPECT_FALSE(setup().replay().to);
  ASSERT_TRUE(openRecording("one"));
  EXPECT_EQ(setup().replay().from, 2);
  EXPECT_EQ(setup().replay().to, 5);
  window_->sources().setTrim(0, window_->sources().trim()->last);
  EXPECT_FALSE(setup().replay().to) << "to the end, wherever that is";
}

}  // namespace
}  // namespace handmap
