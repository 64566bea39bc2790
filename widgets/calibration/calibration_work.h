// The thread that looks through the cameras while a person holds a checkerboard before them.
#pragma once

#include <QObject>
#include <memory>

#include "core/calibration/board_capture.h"
#include "widgets/background/background.h"
#include "widgets/background/failure.h"
#include "widgets/rig/rig_access.h"

namespace handmap {

class CalibrationWork : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(CalibrationWork)
 public:
  explicit CalibrationWork(QObject* parent = nullptr);
  ~CalibrationWork() override;

  // None of this waits.

  /// Forgets what was taken. `keep`: see BoardCapture.
  void begin(const Board& board, const std::filesystem::path& keep);
  /// Opens the cameras and looks, on top of what was taken since begin().
  void look(const CameraRig& camera, const RigAccess& access);
  /// Looks no more, and calibrates with what was taken.
  void finish();
  void stop();

  /// nullptr before the first look.
  std::shared_ptr<const CaptureStatus> newest() const;
  /// Of the cameras; nullptr before they were opened.
  std::shared_ptr<RigMonitor> monitor() const { return monitor_; }

 Q_SIGNALS:
  void failed(const handmap::Failure& failure);
  void calibrated(const std::shared_ptr<const handmap::CapturedCalibration>& captured);

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
  std::shared_ptr<RigMonitor> monitor_;
  std::stop_source stop_;
  std::shared_ptr<Lifeline<CalibrationWork>> self_;  ///< shared with the threads
};

}  // namespace handmap
