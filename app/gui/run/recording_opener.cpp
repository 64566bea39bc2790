#include "app/gui/run/recording_opener.h"

#include "app/gui/run/demonstration.h"
#include "core/bag_import/bag_import.h"
#include "core/kitti_raw/kitti_raw.h"
#include "core/plausibility/plausibility.h"

namespace handmap {

namespace {

template <typename Answer>
Answer answerOf(const std::function<Answer()>& open) {
  try {
    return open();
  } catch (const Error& error) {
    return failureOf(error);
  } catch (const std::exception& error) {
    return Failure{ErrorCode::RunFailed, QString::fromUtf8(error.what()), {}};
  }
}

}  // namespace

RecordingOpener::RecordingOpener(QObject* parent)
    : QObject(parent), self_(std::make_shared<Lifeline<RecordingOpener>>(*this)) {}

RecordingOpener::~RecordingOpener() {
  self_->cut();
  stop_.request_stop();
}

void RecordingOpener::forget() {
  ++request_;
  simulates_ = false;
  stop_.request_stop();
  stop_ = {};
}

void RecordingOpener::forgetSimulation() {
  if (simulates_) forget();
}

void RecordingOpener::begin(std::function<Answer()> open) {
  startInBackground([self = self_, request = request_, open = std::move(open)] {
    self->post([request, answer = answerOf(open)](RecordingOpener& opener) {
      if (request != opener.request_) return;
      if (const auto* opened = std::get_if<Opened>(&answer)) {
        Q_EMIT opener.opened(opened->recording, opened->acts, opened->doubts, opened->notes);
      } else if (const auto* poses = std::get_if<Poses>(&answer)) {
        Q_EMIT opener.posesOpened(*poses);
      } else if (const auto* robot = std::get_if<Robot>(&answer)) {
        Q_EMIT opener.simulated(*robot);
      } else {
        Q_EMIT opener.failed(std::get<Failure>(answer));
      }
    });
  });
}

void RecordingOpener::open(const QString& folder) {
  forget();
  begin([stop = stop_.get_token(), path = std::filesystem::path(folder.toStdString())]() -> Answer {
    auto recording = std::make_shared<const Recording>(openRecording(path, stop));
    Doubts doubts = doubtsOf(*recording, stop);
    return Opened{std::move(recording), readActs(path), std::move(doubts)};
  });
}

void RecordingOpener::import(const std::shared_ptr<const Log>& log, const QString& folder) {
  // The notes of the log itself stand in the dialog.
  make(folder,
       [log](const Making& making) { writeLog(*log, making.folder, making.name, making.notes); });
}

void RecordingOpener::import(const std::shared_ptr<const Bag>& bag, const ToldTopics& topics,
                             const QString& folder) {
  make(folder, [bag, topics](const Making& making) {
    importBag(*bag, planOf(*bag, topics), making.folder, making.name, making.notes, {},
              making.stop);
  });
}

void RecordingOpener::importDrive(const QString& drive, const QString& folder) {
  make(folder, [from = std::filesystem::path(drive.toStdString())](const Making& making) {
    importKittiRaw(from, making.folder, making.name, making.notes, {}, making.stop);
  });
}

void RecordingOpener::make(const QString& folder, std::function<void(const Making& making)> write) {
  forget();
  begin([stop = stop_.get_token(), write = std::move(write),
         path = std::filesystem::path(folder.toStdString())]() -> Answer {
    std::vector<std::string> notes;
    write({path, path.filename().string(), notes, stop});
    auto recording = std::make_shared<const Recording>(openRecording(path, stop));
    Doubts doubts = doubtsOf(*recording, stop);
    return Opened{std::move(recording), {}, std::move(doubts), std::move(notes)};
  });
}

void RecordingOpener::readAgain(const std::shared_ptr<const Recording>& recording,
                                const Remedy& remedy, const std::vector<Act>& acts) {
  forget();
  begin([stop = stop_.get_token(), recording, remedy, acts]() -> Answer {
    auto read = std::make_shared<const Recording>(remedied(*recording, remedy));
    Doubts doubts = doubtsOf(*read, stop);
    return Opened{std::move(read), acts, std::move(doubts)};
  });
}

void RecordingOpener::openPoses(const QString& tum_file) {
  forget();
  begin([path = tum_file.toStdString()]() -> Answer { return readTum(path).poses(); });
}

void RecordingOpener::simulate(const Map& drawing, std::uint64_t seed) {
  forget();
  simulates_ = true;
  begin([drawing, seed]() -> Answer { return simulationOfDrawing(drawing, seed); });
}

}  // namespace handmap
