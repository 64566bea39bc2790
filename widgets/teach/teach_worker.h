// Training in a thread of its own. What it has to say comes as queued signals; only the destructor
// waits: it cancels, and training gives up within a fraction of a second.
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <memory>
#include <stop_token>
#include <thread>
#include <vector>

#include "core/classification/training.h"

namespace handmap {

/// Copies of all that training needs.
struct TeachJob {
  struct Image {
    std::filesystem::path path;
    std::vector<WindowLabel> labels;
  };
  std::vector<Image> images;
  bool colour = true;  ///< where all of the images have colours
  TrainingOptions options;
};

class TeachWorker : public QObject {
  Q_OBJECT
 public:
  explicit TeachWorker(TeachJob job, QObject* parent = nullptr);

  /// Once, after the signals are connected.
  void start();
  void cancel() { thread_.request_stop(); }

 Q_SIGNALS:
  void progressed(double share);
  // One of these is the last one.
  void finished(const std::shared_ptr<const handmap::BuildingClassifier>& classifier);
  void cancelled();
  void failed(const QString& message);

 private:
  void work(const std::stop_token& stop);

  TeachJob job_;
  std::jthread thread_;  // last: ends before what it uses
};

}  // namespace handmap
