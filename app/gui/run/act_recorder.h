// Writes what a person says during a live drive beside its recording, in the order in which it is
// said, in threads that the window does not wait for.
#pragma once

#include <QObject>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "core/session/acts.h"
#include "widgets/background/background.h"

namespace handmap {

class ActRecorder : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(ActRecorder)
 public:
  explicit ActRecorder(QObject* parent = nullptr);
  ~ActRecorder() override;

  void add(const std::filesystem::path& folder, const Act& act);
  /// These in place of all that were said on that drive.
  void replace(const std::filesystem::path& folder, const std::vector<Act>& acts);

 Q_SIGNALS:
  void failed(const QString& message);

 private:
  using Job = std::function<void()>;  ///< throws what went wrong
  void write();

  void add(Job job);

  std::deque<Job> waiting_;
  bool busy_ = false;
  std::shared_ptr<Lifeline<ActRecorder>> self_;  ///< shared with the thread
};

}  // namespace handmap
