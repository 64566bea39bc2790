// Every way to leave a run, in every state of it.
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <atomic>

#include "app/gui/files/file_actions.h"
#include "app/gui/run/recording_opener.h"
#include "core/base/error.h"
#include "core/map/map_io.h"
#include "tests/journeys/window_test.h"
#include "widgets/document/map_document.h"
#include "widgets/messages/dialogs.h"

namespace handmap {
namespace {

using Leave = std::function<void(MainWindow&)>;

/// The welcome strip's.
void press(MainWindow& window, const QString& text) {
  for (auto* button : window.findChildren<QPushButton*>()) {
    if (button->text() == text) return button->click();
  }
  FAIL() << "no button " << text.toStdString();
}

class RunEndingTest : public WindowTest {
 protected:
  /// Each leaves the run; some begin another.
  std::vector<std::pair<const char*, Leave>> ways() const {
    const QString drawing = path("empty.handmap");
    writeMap({}, drawing.toStdString());
    return {{"quit", [](MainWindow& window) { EXPECT_TRUE(window.close()); }},
            {"new", [](MainWindow& window) { action(window, "file.new")->trigger(); }},
            {"draw", [](MainWindow& window) { press(window, "Draw"); }},
            {"simulator", [](MainWindow& window) { window.sources().openTwoRows(); }},
            {"another run",
             [](MainWindow& window) {
               window.sources().openTwoRows();
               window.runs().runOrResume();
               window.sources().openTwoRows();
             }},
            {"open", [drawing](MainWindow& window) { EXPECT_TRUE(window.files().open(drawing)); }},
            {"discard", [](MainWindow& window) { window.run().discard(); }}};
  }

  /// Leaves a run that `prepare` has brought somewhere; nothing of it may be heard after.
  void leaveAfter(const std::function<void(MainWindow&)>& prepare) {
    for (const auto& [name, leave] : ways()) {
      SCOPED_TRACE(name);
      const auto window = open();
      runSimulator(*window);
      prepare(*window);
      leave(*window);
      EXPECT_EQ(window->run().state(), RunState::Idle);
      EXPECT_EQ(window->run().result(), nullptr);
      QSignalSpy news(&window->run(), &RunController::newsArrived);
      QSignalSpy opened(&window->run(), &RunController::sourceOpened);
      QSignalSpy finished(&window->run(), &RunController::finished);
      ASSERT_TRUE(waitForBackground(std::chrono::seconds(30)));
      QTest::qWait(30);
      EXPECT_EQ(news.count() + opened.count() + finished.count(), 0);
      EXPECT_FALSE(window->run().isActive());
    }
  }
};

TEST_F(RunEndingTest, AtItsBeginning) {
  leaveAfter([](MainWindow&) {});
}

TEST_F(RunEndingTest, WhenItHasEndedAndNobodyHasHeardOfIt) {
  leaveAfter([](MainWindow&) { ASSERT_TRUE(waitForBackground(std::chrono::seconds(60))); });
}

TEST_F(RunEndingTest, InTheMiddle) {
  leaveAfter([](MainWindow& window) {
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.run().result() != nullptr; }, kPatienceMs));
  });
}

TEST_F(RunEndingTest, Paused) {
  leaveAfter([](MainWindow& window) {
    action(window, "run.pause")->trigger();
    ASSERT_TRUE(waitFor(window, RunState::Paused));
  });
}

TEST_F(RunEndingTest, Stepping) {
  leaveAfter([](MainWindow& window) {
    action(window, "run.pause")->trigger();
    ASSERT_TRUE(waitFor(window, RunState::Paused));
    action(window, "run.step")->trigger();
  });
}

TEST_F(RunEndingTest, Stopping) {
  leaveAfter([](MainWindow& window) { action(window, "run.stop")->trigger(); });
}

TEST_F(RunEndingTest, WhileTheRobotIsBeingOpened) {
  leaveAfter([](MainWindow& window) {
    // One that opens until it is stopped.
    Robot robot;
    robot.connect = [](const ReplayOptions&, const std::stop_token& stop,
                       const std::function<void(double)>& progress) {
      while (!stop.stop_requested()) progress(0.5);
      return std::unique_ptr<ObservationSource>();
    };
    window.sources().setRobot(robot);
    window.runs().runOrResume();
    QTest::qWait(20);
    EXPECT_TRUE(window.run().isActive());
  });
}

/// Like the devices of a rig: they are on as long as it is open.
class Failing : public ObservationSource {
 public:
  explicit Failing(std::shared_ptr<std::atomic<bool>> is_on) : is_on_(std::move(is_on)) {
    *is_on_ = true;
  }
  ~Failing() override { *is_on_ = false; }
  const SourceInfo& info() const override { return info_; }
  std::optional<Observation> next() override {
    throw Error(ErrorCode::RunFailed, "the scanner burns");
  }

 private:
  std::shared_ptr<std::atomic<bool>> is_on_;
  SourceInfo info_;
};

TEST_F(RunEndingTest, ByItsFailureLeavesNoDeviceOn) {
  const auto window = open();
  window->sources().openTwoRows();
  Robot robot;
  const auto is_on = std::make_shared<std::atomic<bool>>(false);
  robot.connect = [is_on](const ReplayOptions&, const std::stop_token&,
                          const std::function<void(double)>&) {
    return std::make_unique<Failing>(is_on);
  };
  window->sources().setRobot(robot);
  QSignalSpy failed(&window->run(), &RunController::failed);
  window->runs().runOrResume();
  ASSERT_TRUE(QTest::qWaitFor([&] { return failed.count() == 1; }, kPatienceMs));
  EXPECT_TRUE(QTest::qWaitFor([&] { return !*is_on; }, kPatienceMs));
}

TEST_F(RunEndingTest, WithTheWindow) {
  for (const int ms : {0, 5, 50}) {
    auto window = open();
    runSimulator(*window);
    window->sources().openRecording(path("nowhere"));
    QTest::qWait(ms);
    window.reset();
    QTest::qWait(5);
  }
}

TEST_F(RunEndingTest, AnOfferOfADiscardedRunIsNotTakenUp) {
  const auto window = open();
  runSimulator(*window);
  ASSERT_TRUE(waitFor(*window, RunState::Idle));
  const QPointer<QPushButton> accept = window->messages().findChild<QPushButton*>();
  ASSERT_TRUE(accept);
  const Map drawn = document_.map();
  window->runs().runOrResume();
  ASSERT_TRUE(QTest::qWaitFor([&] { return window->run().result() != nullptr; }, kPatienceMs));
  if (accept) accept->click();
  EXPECT_EQ(document_.map(), drawn);
}

}  // namespace
}  // namespace handmap
