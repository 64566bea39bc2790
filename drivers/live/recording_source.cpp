#include "drivers/live/recording_source.h"

#include "core/base/error.h"
#include "core/recording/as_written.h"

namespace handmap {

namespace {

class RecordingSource : public ObservationSource {
 public:
  RecordingSource(std::unique_ptr<ObservationSource> source, const std::filesystem::path& folder,
                  RecordingListener listener)
      : source_(std::move(source)),
        writer_(std::make_unique<RecordingWriter>(folder, source_->info())),
        info_(writer_->info()),
        listener_(std::move(listener)) {
    status_.folder = folder.string();
    info_.visual_odometry = false;  // it is the recording's own now
    tell();
  }

  const SourceInfo& info() const override { return info_; }

  std::optional<Observation> next() override {
    std::optional<Observation> observation = source_->next();
    if (!observation) {
      writer_.reset();
      return observation;
    }
    observation = asReplayed(std::move(*observation));
    write(*observation);
    return observation;
  }

 private:
  void write(const Observation& observation) {
    if (!writer_) return;
    try {
      writer_->add(observation);
      ++status_.observations;
    } catch (const Error& error) {
      writer_.reset();
      status_.error = error.what();
    }
    tell();
  }
  void tell() const {
    if (listener_) listener_(status_);
  }

  std::unique_ptr<ObservationSource> source_;
  std::unique_ptr<RecordingWriter> writer_;  ///< nullptr: ended
  SourceInfo info_;
  RecordingListener listener_;
  RecordingStatus status_;
};

}  // namespace

std::unique_ptr<ObservationSource> recorded(std::unique_ptr<ObservationSource> source,
                                            const std::filesystem::path& folder,
                                            RecordingListener listener) {
  return std::make_unique<RecordingSource>(std::move(source), folder, std::move(listener));
}

}  // namespace handmap
