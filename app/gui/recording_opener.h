// Opens recordings in threads of their own: a big one takes its time.
#pragma once

#include <QObject>
#include <memory>
#include <stop_token>

#include "core/recording/recording.h"
#include "widgets/background/background.h"
#include "widgets/run/run_worker.h"

namespace handmap {

class RecordingOpener : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(RecordingOpener)
 public:
  explicit RecordingOpener(QObject* parent = nullptr);
  ~RecordingOpener() override;

  /// What was asked for before is forgotten, and ends.
  void open(const QString& folder);
  void forget();

 Q_SIGNALS:
  void opened(const std::shared_ptr<const handmap::Recording>& recording);
  void failed(const handmap::RunFailure& failure);

 private:
  int request_ = 0;                                  ///< an answer to another one is dropped
  std::stop_source stop_;                            ///< of the latest
  std::shared_ptr<Lifeline<RecordingOpener>> self_;  ///< shared with the threads
};

}  // namespace handmap
