// Writes what a person says during a live drive beside its recording, in the order in which it is
// said, in threads that the window does not wait for.
#pragma once

#include <QObject>
#include <deque>
#include <filesystem>
#include <memory>

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

 Q_SIGNALS:
  void failed(const QString& message);

 private:
  struct Line {
    std::filesystem::path folder;
    Act act;
  };
  void write();

  std::deque<Line> waiting_;
  bool busy_ = false;
  std::shared_ptr<Lifeline<ActRecorder>> self_;  ///< shared with the thread
};

}  // namespace handmap
