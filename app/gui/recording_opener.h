// Opens recordings in a thread of its own: a big one takes its time.
#pragma once

#include <QObject>
#include <memory>
#include <thread>

#include "core/recording/recording.h"
#include "widgets/run/run_worker.h"

namespace handmap {

class RecordingOpener : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// What was asked for before is forgotten.
  void open(const QString& folder);

 Q_SIGNALS:
  void opened(const std::shared_ptr<const handmap::Recording>& recording);
  void failed(const handmap::RunFailure& failure);

 private:
  int request_ = 0;
  std::jthread thread_;
};

}  // namespace handmap
