#include "widgets/teach/teach_worker.h"

#include "core/recording/image_file.h"

namespace handmap {

namespace {

/// nullopt when the stop was requested.
std::optional<BuildingClassifier> train(const TeachJob& job, const std::stop_token& stop,
                                        const std::function<void(double)>& progress) {
  std::vector<cv::Mat> images;
  bool colour = job.colour;
  for (const TeachJob::Image& image : job.images) {
    if (stop.stop_requested()) return std::nullopt;
    images.push_back(readImage(image.path));
    colour = colour && images.back().channels() == 3;
  }
  TrainingSet set({FeatureFamily::Handmap, colour});
  for (std::size_t i = 0; i < images.size(); ++i) {
    if (stop.stop_requested()) return std::nullopt;
    set.add(images[i], job.images[i].labels);
  }
  return trainClassifier(set, job.options, stop, progress);
}

}  // namespace

TeachWorker::TeachWorker(TeachJob job, QObject* parent)
    : QObject(parent),
      job_(std::move(job)),
      self_(std::make_shared<Lifeline<TeachWorker>>(*this)) {}

TeachWorker::~TeachWorker() {
  self_->cut();
  stop_.request_stop();
}

void TeachWorker::start() {
  startInBackground([self = self_, job = job_, stop = stop_.get_token()] {
    try {
      auto trained = train(job, stop, [&self](double share) {
        self->post([share](TeachWorker& worker) { Q_EMIT worker.progressed(share); });
      });
      if (!trained) {
        self->post([](TeachWorker& worker) { Q_EMIT worker.cancelled(); });
        return;
      }
      const auto classifier = std::make_shared<const BuildingClassifier>(std::move(*trained));
      self->post([classifier](TeachWorker& worker) { Q_EMIT worker.finished(classifier); });
    } catch (const std::exception& error) {
      const QString message = QString::fromUtf8(error.what());
      self->post([message](TeachWorker& worker) { Q_EMIT worker.failed(message); });
    }
  });
}

}  // namespace handmap
