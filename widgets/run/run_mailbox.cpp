#include "widgets/run/run_mailbox.h"

#include <utility>

namespace handmap {

RunMailbox::RunMailbox(QObject* parent) : QObject(parent), timer_(this) {
  timer_.setSingleShot(true);
  timer_.setInterval(16);
  connect(&timer_, &QTimer::timeout, this, &RunMailbox::flush);
}

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

void RunMailbox::flush() {
  RunNews news;
  {
    const std::scoped_lock lock(mutex_);
    news = std::exchange(news_, {});
    pending_ = false;
  }
  if (news.newest) Q_EMIT arrived(news);
}

}  // namespace handmap
