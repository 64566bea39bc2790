#include "app/gui/run/act_recorder.h"

namespace handmap {

namespace {

/// What went wrong; empty: nothing.
QString writing(const std::filesystem::path& folder, const Act& act) {
  try {
    appendAct(folder, act);
    return {};
  } catch (const std::exception& error) {
    return QString::fromUtf8(error.what());
  }
}

}  // namespace

ActRecorder::ActRecorder(QObject* parent)
    : QObject(parent), self_(std::make_shared<Lifeline<ActRecorder>>(*this)) {}

/// What still waits is written all the same.
ActRecorder::~ActRecorder() {
  self_->cut();
  if (waiting_.empty()) return;
  startInBackground([lines = std::move(waiting_)] {
    for (const Line& line : lines) writing(line.folder, line.act);
  });
}

void ActRecorder::add(const std::filesystem::path& folder, const Act& act) {
  waiting_.push_back({folder, act});
  if (!busy_) write();
}

void ActRecorder::write() {
  busy_ = !waiting_.empty();
  if (!busy_) return;
  startInBackground([self = self_, line = waiting_.front()] {
    self->post([message = writing(line.folder, line.act)](ActRecorder& recorder) {
      if (!message.isEmpty()) Q_EMIT recorder.failed(message);
      recorder.write();
    });
  });
  waiting_.pop_front();
}

}  // namespace handmap
