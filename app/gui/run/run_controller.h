// The one run of the window: starts it, hands on what it says, keeps its result.
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "app/gui/run/robot.h"
#include "drivers/pace/pace.h"
#include "widgets/background/background.h"
#include "widgets/run/panels/run_setup_panel.h"
#include "widgets/run/worker/run_worker.h"

namespace handmap {

enum class RunState { Idle, Running, Paused, Stopping };

class RunController : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  ~RunController() override;

  /// How what newsArrived() brings is made ready for being shown; see RunMailbox.
  void setPrepare(RunMailbox::Prepare prepare) { prepare_ = std::move(prepare); }
  RunState state() const { return state_; }
  bool isActive() const { return state_ != RunState::Idle; }
  /// Of the latest run, also when it has ended; nullptr before its first whole step.
  std::shared_ptr<const RunResult> result() const;
  /// The drawing that the latest run was given.
  const Map& drawing() const { return drawing_; }
  /// How it was asked for; see revise().
  const RunSettings& settings() const { return settings_; }
  /// Its past; nullptr where there was none yet.
  const std::shared_ptr<const RunHistory>& history() const { return history_; }
  /// What it has perceived; nullptr before its source is open.
  std::shared_ptr<const Tape> tape() const;
  /// Counts the runs, also those that were discarded: an offer that was made about one is to be
  /// taken up about the same.
  int number() const { return number_; }

  enum class Begin { Running, WithOneStep, WithPhases };
  /// Only when idle.
  void start(const Map& drawing, const Robot& robot, const RunSetup& setup,
             Begin begin = Begin::Running);
  void pause();
  void resume();
  /// Works in one observation and pauses.
  void step();
  /// The same; what comes of it tells its phases.
  void stepPhases();
  /// As fast as can be until so many are worked in, then pauses.
  void runUntil(int index);
  /// Takes effect at once; finished() says when it has. The first time it only ends the drive of a
  /// live robot: what was found is then smoothed, as at the end of a recording.
  void stop();
  /// Of the latest run; nullptr where its robot is not live.
  std::shared_ptr<LiveLink> live() const { return live_; }
  /// Forgets the run and its result at once: nothing more is heard of it. It ends by itself.
  void discard();
  /// Times the clock of the source; 0: as fast as possible.
  void setSpeed(double speed);

  /// Whether the latest run may be done again from what it has perceived.
  bool canRevise() const;
  /// Does the latest run again as far as it has come, in the background, with another drawing and
  /// with these poses given. The run itself stands still meanwhile, if its robot is not live. The
  /// one before, if it is not yet taken, is dropped.
  void revise(const Map& drawing, const std::vector<StampedPose>& given_poses);
  bool isRevising() const { return revision_ != nullptr; }
  /// From revisionReady() on: what it has come to.
  std::shared_ptr<const RunResult> revision() const;
  /// The run goes on as the revision: its past, its drawing and its result are that one's.
  void takeRevision();
  void dropRevision();

 Q_SIGNALS:
  /// A run was started; nothing of it is there yet.
  void begun();
  void stateChanged(handmap::RunState state);
  void sourceOpened(const std::shared_ptr<const handmap::SourceInfo>& source);
  void newsArrived(const handmap::RunNews& news);
  /// Somebody who looks on says where the robot of this drive was.
  void poseGiven(double time_s, const handmap::Pose2& pose);
  void progressed(double share_of_step);
  void frameSkipped(int frame, const QString& reason);
  void finished(bool cancelled);
  void failed(const handmap::Failure& failure);
  void revisionProgressed(double share);
  void revisionReady();
  void revisionFailed(const handmap::Failure& failure);
  /// All that was shown of the run is another one's now; newsArrived() with all of it follows.
  void revised();

 private:
  /// A run that is done again.
  struct Revision {
    std::unique_ptr<RunWorker> worker;
    Map drawing;
    RunSettings settings;
    RunNews news;  ///< all of it so far
    bool ready = false;
    bool at_end = false;
    bool goes_on = false;  ///< the run was running when it was asked for
  };
  void listenToRevision();
  void pass(const RunNews& news);
  void setState(RunState state);
  void end();
  /// Nothing more is read of the source: it is closed, and what it held is free.
  void endFeed();
  /// It is silent from here on; it may be the sender, so it goes later.
  void letGo();
  void listenTo(RunWorker& worker);

  RunMailbox::Prepare prepare_;
  RunState state_ = RunState::Idle;
  int number_ = 0;
  double speed_ = 1.0;
  Map drawing_;
  RunSettings settings_;
  std::shared_ptr<Pace> pace_;
  std::unique_ptr<RunWorker> worker_;
  std::shared_ptr<LiveLink> live_;
  std::shared_ptr<Lifeline<RunController>> self_ =
      std::make_shared<Lifeline<RunController>>(*this);  ///< shared with who looks on
  std::shared_ptr<const RunResult> last_result_;
  std::shared_ptr<RunFeed> feed_;  ///< of the latest run, also when that has ended
  RunFeed::Closed closing_;        ///< of the feed that was ended last
  std::shared_ptr<const RunHistory> history_;
  std::unique_ptr<Revision> revision_;
  bool at_end_ = false;  ///< the latest run came to the end of its source
};

}  // namespace handmap
