// The past of a run in the window: looked at, played again, and changed.
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>

#include "core/map/map_io.h"
#include "tests/journeys/window_test.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/document/map_document.h"
#include "widgets/run/overlays/run_strip.h"
#include "widgets/run/panels/said_panel.h"
#include "widgets/run/panels/timeline.h"
#include "widgets/run/panels/why_panel.h"
#include "widgets/run/words/phase_words.h"
#include "widgets/tools/toolbox.h"

namespace handmap {
namespace {

class LookingBack : public WindowTest {
 protected:
  LookingBack() : window_(open()) { runSimulator(*window_); }

  PlaybackActions& past() { return window_->runs().past(); }
  int shown() { return window_->transport().timeline().value(); }
  int done() { return window_->transport().timeline().done(); }
  bool waitDone() {
    return QTest::qWaitFor([this] { return done() > 0 && !window_->run().isActive(); },
                           kPatienceMs);
  }
  bool waitForPast(int index) {
    return QTest::qWaitFor([this, index] { return done() >= index; }, kPatienceMs);
  }
  bool waitForRevision() {
    QSignalSpy revised(&window_->run(), &RunController::revised);
    return revised.wait(kPatienceMs);
  }
  void pressMessage(const QString& text) {
    for (auto* button : window_->messages().findChildren<QPushButton*>()) {
      if (button->text() == text) return button->click();
    }
    FAIL() << "no button " << text.toStdString() << " in " << message(*window_).toStdString();
  }
  std::unique_ptr<MainWindow> window_;
};

TEST_F(LookingBack, PausesShowsThePastAndGoesOnFromThere) {
  ASSERT_TRUE(waitForPast(5));
  past().seek(3);
  EXPECT_EQ(shown(), 3);
  EXPECT_FALSE(past().playback().atNewest());
  ASSERT_TRUE(
      QTest::qWaitFor([this] { return window_->run().state() != RunState::Running; }, kPatienceMs));
  EXPECT_TRUE(window_->runs().stateInWords().startsWith("Looking back"));
  action(*window_, "run.back")->trigger();
  EXPECT_EQ(shown(), 2);
  action(*window_, "run.step")->trigger();
  EXPECT_EQ(shown(), 3);
  action(*window_, "run.run")->trigger();
  ASSERT_TRUE(waitDone());
  ASSERT_TRUE(QTest::qWaitFor([this] { return past().playback().atNewest(); }, kPatienceMs));
  EXPECT_EQ(shown(), done());
  EXPECT_TRUE(window_->runs().stateInWords().startsWith("Done"));
}

TEST_F(LookingBack, ANewDrawingHasNoPast) {
  ASSERT_TRUE(waitForPast(3));
  ASSERT_TRUE(action(*window_, "run.back")->isEnabled());
  action(*window_, "file.new")->trigger();
  for (const char* id : {"run.back", "run.newest", "run.bookmark"}) {
    EXPECT_FALSE(action(*window_, id)->isEnabled()) << id;
  }
}

TEST_F(LookingBack, AnObservationIsGoneThroughPhaseByPhase) {
  ASSERT_TRUE(waitForPast(2));
  action(*window_, "run.pause")->trigger();
  ASSERT_TRUE(
      QTest::qWaitFor([this] { return window_->run().state() == RunState::Paused; }, kPatienceMs));
  action(*window_, "run.step")->trigger();  // the one that it is in the midst of
  const int begun = done();
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return done() == begun + 1 && window_->run().state() == RunState::Paused; },
      kPatienceMs));
  const int before = done();
  QStringList names;
  QObject::connect(&window_->runs(), &TransportActions::phaseShown, window_.get(),
                   [&](const Phase& phase, int, int) { names << PhaseWords::name(phase); });
  action(*window_, "run.phase")->trigger();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !names.isEmpty(); }, kPatienceMs));
  EXPECT_EQ(done(), before + 1);
  auto* strip = window_->findChild<RunStrip*>();
  EXPECT_TRUE(strip->words().contains("Phase 1 of")) << strip->words().toStdString();
  const auto whole = window_->run().history()->at(done());
  for (std::size_t i = 1; i < whole->phases->size(); ++i) action(*window_, "run.phase")->trigger();
  EXPECT_EQ(names.size(), static_cast<qsizetype>(whole->phases->size()));
  EXPECT_EQ(names.front(), "Way");
  EXPECT_TRUE(strip->words().contains("Phase"));
  action(*window_, "run.phase")->trigger();  // the whole
  EXPECT_FALSE(strip->words().contains("Phase"));
  EXPECT_EQ(done(), before + 1);
  action(*window_, "run.back")->trigger();
  EXPECT_EQ(shown(), before);
  action(*window_, "run.phase")->trigger();  // it still knows how it came about
  EXPECT_TRUE(strip->words().contains("Phase 1 of"));
}

TEST_F(LookingBack, TheWindowMayGoWhileAWallIsAskedWhy) {
  ASSERT_TRUE(waitForPast(2));
  action(*window_, "run.why")->trigger();
  ASSERT_TRUE(window_->runPanels().why.isVisible());
  window_->close();
  window_.reset();  // what it then does wrong only sanitizers see
}

TEST_F(LookingBack, WhatIsStillToComeIsComputedFirst) {
  ASSERT_TRUE(waitForPast(1));
  const int goal = window_->transport().timeline().maximum() - 2;
  past().seek(goal);
  ASSERT_TRUE(waitForPast(goal));
  ASSERT_TRUE(
      QTest::qWaitFor([this] { return window_->run().state() != RunState::Running; }, kPatienceMs));
  EXPECT_GE(shown(), goal);
}

TEST_F(LookingBack, StaysInThePastWhileTheRunHasEnded) {
  ASSERT_TRUE(waitDone());
  past().seek(1);
  EXPECT_EQ(shown(), 1);
  EXPECT_TRUE(action(*window_, "run.newest")->isEnabled());
  action(*window_, "run.newest")->trigger();
  EXPECT_EQ(shown(), done());
  EXPECT_FALSE(action(*window_, "run.newest")->isEnabled());
}

TEST_F(LookingBack, AChangedDrawingIsTakenOrNot) {
  ASSERT_TRUE(waitDone());
  EXPECT_FALSE(action(*window_, "run.recompute")->isEnabled());
  const std::string before = formatMap(window_->run().result()->map());
  const QString gone = QString::fromStdString(document_.map().buildings.back().id);
  document_.setSelection({gone});
  document_.removeSelected();
  ASSERT_TRUE(action(*window_, "run.recompute")->isEnabled());
  for (const bool take : {false, true}) {
    QSignalSpy ready(&window_->run(), &RunController::revisionReady);
    action(*window_, "run.recompute")->trigger();
    ASSERT_TRUE(ready.wait(kPatienceMs));
    pressMessage(take ? "Take the new result" : "Keep the old result");
    EXPECT_FALSE(window_->run().isRevising());
    const Map& refined = window_->run().result()->map();
    EXPECT_EQ(formatMap(refined) == before, !take);
    EXPECT_EQ(refined.buildings.size(), document_.map().buildings.size() + (take ? 0 : 1));
  }
  EXPECT_FALSE(action(*window_, "run.recompute")->isEnabled());
  // And back, to the byte.
  document_.undoStack().undo();
  QSignalSpy ready(&window_->run(), &RunController::revisionReady);
  action(*window_, "run.recompute")->trigger();
  ASSERT_TRUE(ready.wait(kPatienceMs));
  pressMessage("Take the new result");
  EXPECT_EQ(formatMap(window_->run().result()->map()), before);
}

TEST_F(LookingBack, AStoppedRunThatIsRecomputedGoesOn) {
  ASSERT_TRUE(waitForPast(4));
  action(*window_, "run.stop")->trigger();
  ASSERT_TRUE(waitFor(*window_, RunState::Idle));
  const int stopped_at = done();
  const int all = window_->transport().timeline().maximum();
  ASSERT_LT(stopped_at, all);
  document_.setSelection({QString::fromStdString(document_.map().buildings.back().id)});
  document_.removeSelected();
  QSignalSpy ready(&window_->run(), &RunController::revisionReady);
  action(*window_, "run.recompute")->trigger();
  ASSERT_TRUE(ready.wait(kPatienceMs));
  pressMessage("Take the new result");
  EXPECT_EQ(window_->run().state(), RunState::Paused);
  action(*window_, "run.run")->trigger();
  ASSERT_TRUE(waitDone());
  EXPECT_EQ(done(), all);
  EXPECT_TRUE(window_->runs().stateInWords().startsWith("Done"));
}

TEST_F(LookingBack, APoseThatIsGivenIsTakenInTheMiddleAndTheRunGoesOn) {
  ASSERT_TRUE(waitForPast(4));
  past().seek(4);
  const Pose2 given{40.0, 1.0, 0.1};
  Q_EMIT window_->tools().robotPoseGiven(given);
  ASSERT_TRUE(waitForRevision());
  ASSERT_EQ(window_->run().settings().given_poses.size(), 1U);
  EXPECT_EQ(window_->run().settings().given_poses[0].pose, given);
  ASSERT_TRUE(window_->run().history());
  EXPECT_GE(window_->run().history()->newest(), 4);
  window_->runs().past().playback().toNewest();
  window_->run().resume();
  ASSERT_TRUE(waitDone());
  EXPECT_TRUE(action(*window_, "run.forget_poses")->isEnabled());
  action(*window_, "run.forget_poses")->trigger();
  ASSERT_TRUE(waitForRevision());
  EXPECT_TRUE(window_->run().settings().given_poses.empty());
}

TEST_F(LookingBack, ABuildingIsRightOrNotThere) {
  ASSERT_TRUE(waitDone());
  const std::string right = document_.map().buildings[0].id;
  const std::size_t count = document_.map().buildings.size();
  const Rectangle corrected = window_->run().result()->map().buildings[0].box();
  document_.setSelection({QString::fromStdString(right)});
  action(*window_, "run.right")->trigger();
  EXPECT_TRUE(document_.map().buildings[0].fixed);
  EXPECT_LT((document_.map().buildings[0].box().centre - corrected.centre).norm(), 1e-6);
  ASSERT_TRUE(waitForRevision());
  EXPECT_TRUE(window_->run().drawing().buildings[0].fixed);
  document_.setSelection({QString::fromStdString(document_.map().buildings[1].id)});
  action(*window_, "run.not_there")->trigger();
  ASSERT_TRUE(waitForRevision());
  EXPECT_EQ(window_->run().result()->map().buildings.size(), count - 1);
}

TEST_F(LookingBack, WhatWasSaidIsUndoneWithTheRun) {
  ASSERT_TRUE(waitDone());
  const Building drawn = document_.map().buildings[0];
  const std::string before = formatMap(window_->run().result()->map());
  document_.setSelection({QString::fromStdString(drawn.id)});
  action(*window_, "run.right")->trigger();
  ASSERT_TRUE(waitForRevision());
  EXPECT_EQ(window_->runPanels().said.count(), 1);
  document_.undoStack().undo();
  ASSERT_TRUE(waitForRevision());
  EXPECT_EQ(document_.map().buildings[0], drawn);
  EXPECT_FALSE(window_->run().drawing().buildings[0].fixed);
  EXPECT_EQ(formatMap(window_->run().result()->map()), before);
  EXPECT_EQ(window_->runPanels().said.count(), 0);
  document_.undoStack().redo();
  ASSERT_TRUE(waitForRevision());
  EXPECT_TRUE(window_->run().drawing().buildings[0].fixed);
  EXPECT_EQ(window_->runPanels().said.count(), 1);
}

TEST_F(LookingBack, APoseThatWasGivenIsUndone) {
  ASSERT_TRUE(waitDone());
  Q_EMIT window_->tools().robotPoseGiven({40.0, 1.0, 0.1});
  ASSERT_TRUE(waitForRevision());
  ASSERT_EQ(window_->run().settings().given_poses.size(), 1U);
  document_.undoStack().undo();
  ASSERT_TRUE(waitForRevision());
  EXPECT_TRUE(window_->run().settings().given_poses.empty());
}

TEST_F(LookingBack, EachActHasACrossThatTakesItBackAlone) {
  ASSERT_TRUE(waitDone());
  const std::vector<Building> drawn = document_.map().buildings;
  document_.setSelection({QString::fromStdString(drawn[1].id)});
  action(*window_, "run.not_there")->trigger();
  ASSERT_TRUE(waitForRevision());
  document_.setSelection({QString::fromStdString(drawn[0].id)});
  action(*window_, "run.right")->trigger();
  ASSERT_TRUE(waitForRevision());
  SaidPanel& said = window_->runPanels().said;
  ASSERT_EQ(said.count(), 2);
  QSignalSpy revised(&window_->run(), &RunController::revised);
  said.findChildren<QToolButton*>().front()->click();  // of what is not there
  ASSERT_TRUE(revised.wait(kPatienceMs));
  EXPECT_EQ(said.count(), 1);
  EXPECT_TRUE(document_.map().find(drawn[0].id)->fixed);
  ASSERT_NE(document_.map().find(drawn[1].id), nullptr);
  EXPECT_EQ(window_->run().result()->map().buildings.size(), drawn.size());
  document_.undoStack().undo();  // it is not there after all
  ASSERT_TRUE(waitForRevision());
  EXPECT_EQ(document_.map().find(drawn[1].id), nullptr);
  EXPECT_EQ(said.count(), 2);
}

TEST_F(LookingBack, ARevisionThatIsLeftIsForgotten) {
  ASSERT_TRUE(waitDone());
  for (const char* leave : {"file.new", "run.run", "quit"}) {
    document_.setSelection({QString::fromStdString(document_.map().buildings.back().id)});
    action(*window_, "run.not_there")->trigger();
    EXPECT_TRUE(window_->run().isRevising());
    if (leave == std::string("quit")) {
      window_.reset();
      break;
    }
    document_.undoStack().setClean();  // nobody is to be asked
    action(*window_, leave)->trigger();
    EXPECT_FALSE(window_->run().isRevising());
    if (leave == std::string("file.new")) runSimulator(*window_);
    ASSERT_TRUE(waitDone());
  }
}

/// Of forty observations a second some come late, on a busy machine thousands.
TEST_F(LookingBack, OnlyAGapThatAPersonWouldMissIsMarked) {
  ASSERT_TRUE(waitDone());
  QSignalSpy noted(&past(), &PlaybackActions::noted);
  std::vector<FrameReport> reports(200);
  for (std::size_t i = 0; i < reports.size(); ++i) {
    reports[i].time_s = 1e6 + 0.025 * static_cast<double>(i) + (i >= 100 ? 0.4 : 0.0);
  }
  past().begin();
  past().onNews(reports, 200, 0);
  EXPECT_EQ(noted.size(), 0);
  reports.front().time_s = reports.back().time_s + 1.5;
  reports.resize(1);
  past().onNews(reports, 201, 0);
  EXPECT_EQ(noted.size(), 1);
}

}  // namespace
}  // namespace handmap
