// Training in a thread of its own. What it has to say comes as queued signals. Nothing here waits:
// a worker that is destroyed requests the stop and is silent at once; its thread ends by itself.
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/classification/training.h"
#include "widgets/background/background.h"

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
  Q_DISABLE_COPY_MOVE(TeachWorker)
 public:
  explicit TeachWorker(TeachJob job, QObject* parent = nullptr);
  ~TeachWorker() override;

  /// Once, after the signals are connected.
  void start();
  void cancel() { stop_.request_stop(); }

 Q_SIGNALS:
  void progressed(double share);
  // One of these is the last one.
  void finished(const std::shared_ptr<const handmap::BuildingClassifier>& classifier);
  void cancelled();
  void failed(const QString& message);

 private:
  TeachJob job_;
  std::stop_source stop_;
  std::shared_ptr<Lifeline<TeachWorker>> self_;  ///< shared with the thread
};

}  // namespace handmap
