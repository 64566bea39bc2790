// A camera over a printed sheet, looked through in threads of their own. The newest image counts;
// those that come while it is looked at are dropped.
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <stop_token>

#include "app/gui/editing/paper_reading.h"
#include "core/paper/sheet_watch.h"
#include "widgets/background/background.h"

namespace handmap {

class SheetCamera : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(SheetCamera)
 public:
  explicit SheetCamera(QObject* parent = nullptr);
  ~SheetCamera() override;

  // None of this waits.

  /// A device, an address or a video, as a rig names a camera; in place of the one before.
  void watch(const QString& source);
  void stop();

 Q_SIGNALS:
  /// Not while a hand is over the sheet, nor while it moves.
  void seen(const std::shared_ptr<const handmap::PaperReading>& reading);
  /// When that has changed.
  void sightChanged(handmap::SheetSight sight);
  /// Of the camera: it is lost, a video is at its end.
  void troubled(const QString& words);

 private:
  struct Newest;

  std::stop_source stop_;
  int request_ = 0;                              ///< what an earlier one says is dropped
  std::shared_ptr<Lifeline<SheetCamera>> self_;  ///< shared with the threads
};

}  // namespace handmap
