// What a person says on a drive: kept beside its recording, and said again by a run of that.
#include "core/session/acts.h"

#include <QPushButton>
#include <QSignalSpy>

#include "app/gui/run/act_recorder.h"
#include "core/simulation/simulated_source.h"
#include "tests/journeys/window_test.h"
#include "widgets/document/map_document.h"

namespace handmap {
namespace {

Act poseAt(double time_s) { return {time_s, Act::Kind::RobotIsHere, {1.0, 2.0, 0.0}, {}, {}}; }

TEST(ActRecorder, WritesInTheOrderInWhichThingsWereSaid) {
  const QTemporaryDir folder;
  const std::filesystem::path path = folder.path().toStdString();
  constexpr int kCount = 12;
  {
    ActRecorder recorder;
    for (int i = 0; i < kCount; ++i) recorder.add(path, poseAt(i));
    QTest::qWait(20);
  }  // some of it is not yet written
  ASSERT_TRUE(waitForBackground(std::chrono::seconds(30)));
  const std::vector<Act> acts = readActs(path);
  ASSERT_EQ(acts.size(), static_cast<std::size_t>(kCount));
  for (int i = 0; i < kCount; ++i) EXPECT_EQ(acts[static_cast<std::size_t>(i)].time_s, i);
}

TEST(ActRecorder, AFolderThatIsGoneIsTold) {
  ActRecorder recorder;
  QSignalSpy failed(&recorder, &ActRecorder::failed);
  recorder.add("/nowhere/at/all", poseAt(0.0));
  ASSERT_TRUE(failed.wait(kPatienceMs));
  EXPECT_TRUE(failed[0][0].toString().contains("acts.jsonl"));
}

class ActsTest : public WindowTest {
 protected:
  ActsTest() {
    const World world = twoRowWorld(3);
    auto source = simulate(world, {}, 3);
    RecordingWriter writer(path("drive").toStdString(), source->info());
    for (int i = 0; i < 6; ++i) {
      const auto observation = source->next();
      times_.push_back(observation->time_s);
      writer.add(*observation);
    }
    document_.reset(world.map);
    first_ = world.map.buildings[0];
    const std::filesystem::path folder = path("drive").toStdString();
    appendAct(folder, {times_[2], Act::Kind::RobotIsHere, *world.map.start, {}, {}});
    right_ = Rectangle{{1.0, 2.0}, 30.0, 10.0, 0.0};
    appendAct(folder, {times_[3], Act::Kind::BuildingIsRight, {}, first_.id, right_});
    appendAct(folder,
              {times_[4], Act::Kind::BuildingIsNotThere, {}, world.map.buildings[1].id, {}});
    window_ = open();
    window_->sources().openRecording(path("drive"));
  }
  bool waitForMessage(const QString& part) {
    return QTest::qWaitFor([&] { return message(*window_).contains(part); }, kPatienceMs);
  }
  void runToTheEnd() {
    window_->transport().setSpeed(0.0);
    window_->runs().runOrResume();
    ASSERT_TRUE(waitFor(*window_, RunState::Idle));
  }

  std::vector<double> times_;
  Building first_;
  Rectangle right_;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(ActsTest, ARunOfTheRecordingDoesThemAgain) {
  ASSERT_TRUE(waitForMessage("3 thing"));
  const Map before = document_.map();
  runToTheEnd();
  const RunController& run = window_->run();
  ASSERT_EQ(run.settings().given_poses.size(), 1U);
  EXPECT_NEAR(run.settings().given_poses[0].time_s, times_[2], 1e-6);
  const Building* held = run.drawing().find(first_.id);
  ASSERT_NE(held, nullptr);
  EXPECT_TRUE(held->fixed);
  EXPECT_EQ(std::get<Rectangle>(held->shape).width, right_.width);
  EXPECT_EQ(run.drawing().buildings.size(), before.buildings.size() - 1);
  EXPECT_EQ(document_.map(), run.drawing());
  while (document_.undoStack().canUndo()) document_.undoStack().undo();
  EXPECT_EQ(document_.map(), before);
}

TEST_F(ActsTest, TheyCanBeLeftOut) {
  ASSERT_TRUE(waitForMessage("3 thing"));
  for (auto* button : window_->messages().findChildren<QPushButton*>()) {
    if (button->text() == "Leave it out") button->click();
  }
  const Map before = document_.map();
  runToTheEnd();
  EXPECT_TRUE(window_->run().settings().given_poses.empty());
  EXPECT_EQ(document_.map(), before);
}

}  // namespace
}  // namespace handmap
