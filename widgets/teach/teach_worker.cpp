#include "widgets/teach/teach_worker.h"

#include "core/recording/image_file.h"

namespace handmap {

TeachWorker::TeachWorker(TeachJob job, QObject* parent) : QObject(parent), job_(std::move(job)) {}

void TeachWorker::start() {
  thread_ = std::jthread([this](const std::stop_token& stop) {
    try {
      work(stop);
    } catch (const std::exception& error) {
      Q_EMIT failed(QString::fromUtf8(error.what()));
    }
  });
}

void TeachWorker::work(const std::stop_token& stop) {
  std::vector<cv::Mat> images;
  bool colour = job_.colour;
  for (const TeachJob::Image& image : job_.images) {
    if (stop.stop_requested()) break;
    images.push_back(readImage(image.path));
    colour = colour && images.back().channels() == 3;
  }
  TrainingSet set({FeatureFamily::Handmap, colour});
  for (std::size_t i = 0; i < images.size(); ++i) set.add(images[i], job_.images[i].labels);
  std::optional<BuildingClassifier> classifier;
  if (!stop.stop_requested()) {
    classifier = trainClassifier(set, job_.options, stop,
                                 [this](double share) { Q_EMIT progressed(share); });
  }
  if (classifier) {
    Q_EMIT finished(std::make_shared<const BuildingClassifier>(std::move(*classifier)));
  } else {
    Q_EMIT cancelled();
  }
}

}  // namespace handmap
