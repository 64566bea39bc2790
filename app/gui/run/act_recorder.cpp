#include "app/gui/run/act_recorder.h"

namespace handmap {

namespace {

/// What went wrong; empty: nothing.
QString writing(const std::function<void()>& job) {
  try {
    job();
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
  startInBackground([jobs = std::move(waiting_)] {
    for (const Job& job : jobs) writing(job);
  });
}

void ActRecorder::add(const std::filesystem::path& folder, const Act& act) {
  add([folder, act] { appendAct(folder, act); });
}

void ActRecorder::replace(const std::filesystem::path& folder, const std::vector<Act>& acts) {
  add([folder, acts] { writeActs(folder, acts); });
}

void ActRecorder::add(Job job) {
  waiting_.push_back(std::move(job));
  if (!busy_) write();
}

void ActRecorder::write() {
  busy_ = !waiting_.empty();
  if (!busy_) return;
  startInBackground([self = self_, job = waiting_.front()] {
    self->post([message = writing(job)](ActRecorder& recorder) {
      if (!message.isEmpty()) Q_EMIT recorder.failed(message);
      recorder.write();
    });
  });
  waiting_.pop_front();
}

}  // namespace handmap
