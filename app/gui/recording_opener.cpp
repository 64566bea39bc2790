#include "app/gui/recording_opener.h"

#include <variant>

namespace handmap {

namespace {

using Opened = std::shared_ptr<const Recording>;
using Answer = std::variant<Opened, RunFailure>;

Answer opening(const std::filesystem::path& folder, const std::stop_token& stop) {
  try {
    return std::make_shared<const Recording>(openRecording(folder, stop));
  } catch (const Error& error) {
    return failureOf(error);
  } catch (const std::exception& error) {
    return RunFailure{ErrorCode::RunFailed, QString::fromUtf8(error.what()), {}};
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
  stop_.request_stop();
  stop_ = {};
}

void RecordingOpener::open(const QString& folder) {
  forget();
  startInBackground([self = self_, request = request_, stop = stop_.get_token(),
                     path = std::filesystem::path(folder.toStdString())] {
    self->post([request, answer = opening(path, stop)](RecordingOpener& opener) {
      if (request != opener.request_) return;
      if (const Opened* recording = std::get_if<Opened>(&answer)) {
        Q_EMIT opener.opened(*recording);
      } else {
        Q_EMIT opener.failed(std::get<RunFailure>(answer));
      }
    });
  });
}

}  // namespace handmap
