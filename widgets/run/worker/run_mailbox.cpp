#include "widgets/run/worker/run_mailbox.h"

#include <utility>

namespace handmap {

RunMailbox::RunMailbox(QObject* parent)
    : QObject(parent), timer_(this), lifeline_(std::make_shared<Lifeline<RunMailbox>>(*this)) {
  timer_.setSingleShot(true);
  timer_.setInterval(16);
  connect(&timer_, &QTimer::timeout, this, &RunMailbox::prepare);
}

RunMailbox::~RunMailbox() { lifeline_->cut(); }

void RunMailbox::post(std::shared_ptr<const Snapshot> snapshot) {
  {
    const std::scoped_lock lock(mutex_);
    news_.reports.push_back(snapshot->report);
    news_.newest = std::move(snapshot);
    if (std::exchange(pending_, true)) return;
  }
  QMetaObject::invokeMethod(
      this, [this] { timer_.start(); }, Qt::QueuedConnection);
}

void RunMailbox::prepare() {
  if (!prepare_) return flush();
  if (next_.newest) return;
  next_ = taken();
  if (!next_.newest) return;
  startInBackground([lifeline = lifeline_, prepare = prepare_, snapshot = next_.newest] {
    try {
      prepare(*snapshot);
    } catch (...) {  // NOLINT(bugprone-empty-catch): who shows it meets it again, and tells it
    }
    lifeline->post([snapshot](RunMailbox& mailbox) {
      if (mailbox.next_.newest == snapshot) mailbox.deliver();
    });
  });
}

RunNews RunMailbox::taken() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(news_, {});
}

void RunMailbox::deliver() {
  const RunNews news = std::exchange(next_, {});
  {
    const std::scoped_lock lock(mutex_);
    pending_ = news_.newest != nullptr;
    if (pending_) timer_.start();
  }
  if (news.newest) Q_EMIT arrived(news);
}

void RunMailbox::flush() {
  RunNews news = taken();
  if (news.newest) next_.newest = std::move(news.newest);
  next_.reports.insert(next_.reports.end(), news.reports.begin(), news.reports.end());
  deliver();
}

}  // namespace handmap
