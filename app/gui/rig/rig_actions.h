// Connecting a live robot: the dialog, the rig file, and the panel of its devices during a run.
#pragma once

#include <QObject>
#include <QPointer>

#include "app/gui/shell/shell.h"
#include "widgets/calibration/calibration_dialog.h"
#include "widgets/rig/rig_dialog.h"

namespace handmap {

class FileActions;
class LivePanel;
class RunController;
class SourceActions;

class RigActions : public QObject {
  Q_OBJECT
 public:
  /// What it is given must outlive it.
  RigActions(const Shell& shell, RunController& run, SourceActions& sources, FileActions& files,
             QObject* parent);

  /// The robot of a rig file; what is wrong with the file is a message.
  void openRig(const QString& path);
  void showDialog();
  RigDialog* dialog() { return dialog_; }  ///< nullptr when there is none
  void showCalibration();
  LivePanel& panel() { return *panel_; }
  CalibrationDialog* calibration() { return calibration_; }  ///< nullptr when there is none

 private:
  void use(const Rig& rig);
  void followRun();

  const Shell& shell_;
  RunController& run_;
  SourceActions& sources_;
  FileActions& files_;
  LivePanel* panel_;
  QPointer<RigDialog> dialog_;
  QPointer<CalibrationDialog> calibration_;
};

}  // namespace handmap
