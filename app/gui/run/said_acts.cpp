#include "app/gui/run/said_acts.h"

#include <QPointer>
#include <QUndoCommand>

#include "core/session/redone_acts.h"
#include "widgets/document/map_document.h"

namespace handmap {

/// Of what was said; the drawing's part stands beside it in the same macro.
class SaidActs::Command : public QUndoCommand {
 public:
  Command(SaidActs& acts, State before, State after)
      : acts_(&acts), run_(acts.run_), before_(std::move(before)), after_(std::move(after)) {}

  void redo() override {
    if (said_ && acts_) acts_->restore(run_, after_);
    said_ = true;
  }
  void undo() override {
    if (acts_) acts_->restore(run_, before_);
  }

 private:
  QPointer<SaidActs> acts_;
  int run_;
  State before_;
  State after_;
  bool said_ = false;
};

SaidActs::SaidActs(MapDocument& document, QObject* parent) : QObject(parent), document_(document) {}

void SaidActs::begin(const std::vector<StampedPose>& given) {
  ++run_;
  now_ = {given, {}};
  Q_EMIT changed();
}

std::vector<StampedPose> SaidActs::poses() const {
  std::vector<StampedPose> poses = now_.given;
  for (const Said& said : now_.said) {
    if (said.act.kind == Act::Kind::ForgetPoses) poses.clear();
    if (said.act.kind == Act::Kind::RobotIsHere) give(poses, {said.act.time_s, said.act.pose});
  }
  return poses;
}

void SaidActs::say(const std::vector<Said>& said, const QString& text,
                   const std::function<void()>& change) {
  State state = now_;
  state.said.insert(state.said.end(), said.begin(), said.end());
  push(state, text, change);
}

void SaidActs::givePoses(const std::vector<StampedPose>& poses, const QString& text) {
  push({poses, {}}, text, {});
}

void SaidActs::takeBack(std::size_t index) {
  if (index >= now_.said.size()) return;
  State state = now_;
  const Said gone = state.said[index];
  state.said.erase(state.said.begin() + static_cast<std::ptrdiff_t>(index));
  const QString text = tr("Take back what was said");
  push(state, text, [this, gone, text] {
    if (!gone.before) return;
    const Building* there = document_.map().find(gone.before->id);
    if (there == nullptr) {
      document_.add({.buildings = {*gone.before}}, text);
      return;
    }
    Building building = *there;
    building.shape = gone.before->shape;
    building.fixed = gone.before->fixed;
    document_.apply({.buildings = {std::move(building)}}, text);
  });
  want();
}

/// The drawing is changed first, so that it is undone last.
void SaidActs::push(const State& state, const QString& text, const std::function<void()>& change) {
  QUndoStack& stack = document_.undoStack();
  stack.beginMacro(text);
  if (change) change();
  stack.push(new Command(*this, now_, state));
  now_ = state;
  stack.endMacro();
  Q_EMIT changed();
}

void SaidActs::restore(int run, const State& state) {
  if (run != run_) return;
  now_ = state;
  Q_EMIT changed();
  want();
}

/// Later and once: the drawing's part of the step, and perhaps more steps, are still to come.
void SaidActs::want() {
  if (std::exchange(wanted_, true)) return;
  QMetaObject::invokeMethod(
      this,
      [this] {
        wanted_ = false;
        Q_EMIT wanted();
      },
      Qt::QueuedConnection);
}

}  // namespace handmap
