#include "app/gui/recording_opener.h"

namespace handmap {

void RecordingOpener::open(const QString& folder) {
  const int request = ++request_;
  const auto deliver = [this, request](auto say) {
    QMetaObject::invokeMethod(
        this, [this, request, say] { request == request_ ? say() : void(); }, Qt::QueuedConnection);
  };
  // The thread before this one ends by itself; a new one waits for it, not the GUI.
  thread_ = std::jthread([this, deliver, path = std::filesystem::path(folder.toStdString()),
                          before = std::move(thread_)]() mutable {
    if (before.joinable()) before.join();
    try {
      auto recording = std::make_shared<const Recording>(openRecording(path));
      deliver([this, recording] { Q_EMIT opened(recording); });
    } catch (const Error& error) {
      deliver([this, failure = failureOf(error)] { Q_EMIT failed(failure); });
    } catch (const std::exception& error) {
      const RunFailure failure{ErrorCode::RunFailed, QString::fromUtf8(error.what()), {}};
      deliver([this, failure] { Q_EMIT failed(failure); });
    }
  });
}

}  // namespace handmap
