// Connecting a live robot: the dialog, the rig file, and the panel of its devices during a run.
#pragma once

#include <QObject>
#include <QPointer>

#include "app/gui/calibration/calibration_dialog.h"
#include "app/gui/rig/rig_dialog.h"

class QSettings;

namespace handmap {

class ActionSet;
class Docks;
class MessageBar;
class RunActions;
class RunController;

class RigActions : public QObject {
  Q_OBJECT
 public:
  /// All of it must outlive this object.
  struct Parts {
    QWidget& window;
    RunController& run;
    RunActions& runs;
    Docks& docks;
    ActionSet& actions;
    MessageBar& messages;
    QSettings& settings;
    Dialogs& dialogs;
  };
  RigActions(const Parts& parts, QObject* parent);

  /// The robot of a rig file; what is wrong with the file is a message.
  void openRig(const QString& path);
  void showDialog();
  RigDialog* dialog() { return dialog_; }  ///< nullptr when there is none
  void showCalibration();
  CalibrationDialog* calibration() { return calibration_; }  ///< nullptr when there is none

 private:
  void use(const Rig& rig);
  void followRun();

  Parts parts_;
  QPointer<RigDialog> dialog_;
  QPointer<CalibrationDialog> calibration_;
};

}  // namespace handmap
