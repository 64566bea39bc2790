#include "app/gui/run/drive_start.h"

#include <cmath>
#include <utility>

#include "app/gui/run/robot.h"
#include "core/method/pose_trust.h"
#include "widgets/actions/action_set.h"
#include "widgets/document/map_document.h"
#include "widgets/messages/message_bar.h"

namespace handmap {

namespace {

constexpr double kElsewhere_m = 1.0;  // nearer, and a start is drawn no better
constexpr double kElsewhere_rad = 0.2;
constexpr auto kTopic = "drive_start";

}  // namespace

DriveStart::DriveStart(const Shell& shell, MapDocument& document)
    : QObject(&shell.window), shell_(shell), document_(document) {}

void DriveStart::ended(const std::shared_ptr<LiveLink>& link, const Snapshot& newest,
                       const std::shared_ptr<const Tape>& tape) {
  end_ = End{link, newest.report.pose, document_.map().start, newest.trajectory, tape};
  if (certaintyOf(newest.report).kind == Certainty::Lost) end_->pose.reset();
}

bool DriveStart::ask(const Robot& robot, std::function<void()> begin) {
  const std::optional<Pose2> start = document_.map().start;
  // Where the truth is known it is simulated, and begins anew each time.
  if (!end_ || !start || !robot.live || robot.truth_map) return false;
  if (end_->robot.lock() != robot.live || end_->start != start) return false;
  const Pose2 moved = end_->pose ? between(*start, *end_->pose) : Pose2{};
  const double off_m = moved.position().norm();
  if (end_->pose && off_m < kElsewhere_m && std::abs(moved.heading) < kElsewhere_rad) {
    look();
    return false;
  }
  MessageBar& messages = shell_.messages;
  messages.ask(
      tr("Where does the robot begin?"),
      end_->pose
          ? tr("Its last drive ended %1 m from the start of the drawing.").arg(off_m, 0, 'f', 1)
          : tr("When its last drive ended it was not known where it was."),
      kTopic);
  if (end_->pose) {
    messages.addAction(tr("Where it stopped"), [this, begin, pose = *end_->pose] {
      document_.setStart(pose);
      answer(begin);
    });
  }
  messages.addAction(tr("At the start of the drawing"), [this, begin] { answer(begin); });
  messages.addAction(tr("Place the start"), [this] {
    end_.reset();
    shell_.actions["draw.start"].trigger();
  });
  return true;
}

void DriveStart::answer(const std::function<void()>& begin) {
  look();
  end_.reset();
  begin();
}

void DriveStart::look() {
  const auto tape = end_->tape.lock();
  if (tape && end_->pose)
    seen_ = std::make_shared<SeenPlace>(*tape, end_->way, *document_.map().start);
}

}  // namespace handmap
