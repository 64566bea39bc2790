// Calibrates the cameras of a rig: a person holds a checkerboard before them, the program takes
// what it needs, says what is still missing, and shows how good the result is.
#pragma once

#include <QDialog>
#include <QElapsedTimer>
#include <QTimer>

#include "widgets/calibration/calibration_work.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QSpinBox;

namespace handmap {

class BoardPairView;
class Dialogs;

class CalibrationDialog : public QDialog {
  Q_OBJECT
 public:
  /// `dialogs` must outlive it.
  CalibrationDialog(Dialogs& dialogs, RigAccess access, QWidget* parent = nullptr);

  /// The cameras to begin with.
  void setCamera(const CameraRig& camera);

 public Q_SLOTS:
  void done(int result) override;

 Q_SIGNALS:
  /// It was saved, and `camera` names it.
  void calibrated(const handmap::CameraRig& camera);

 private:
  QWidget* makeForm();
  void makeButtons();
  QWidget* withBrowse(QLineEdit* edit);
  void listCameras();
  /// nullopt: something is missing, and the person was told.
  std::optional<CameraRig> enteredCamera();
  void toggle();
  void begin();
  void finish();
  void end();
  void look();
  void showStatus(const CaptureStatus& status);
  void showNeeds(const std::vector<BoardNeed>& missing);
  void showResult(const std::shared_ptr<const CapturedCalibration>& captured);
  void save();
  void tell(const QString& words);

  Dialogs& dialogs_;
  RigAccess access_;
  CalibrationWork work_;
  CameraRig camera_;  ///< what has no field stays as it was given
  QComboBox* left_;
  QComboBox* right_;
  QSpinBox* columns_;
  QSpinBox* rows_;
  QDoubleSpinBox* square_;
  QLineEdit* keep_;
  BoardPairView* view_;
  QListWidget* needs_;
  QLabel* verdict_;
  QLabel* words_;
  QPushButton* start_;
  QPushButton* calibrate_;
  QPushButton* save_;
  QTimer looking_;
  QElapsedTimer since_taken_;
  int taken_ = 0;
  QString begun_with_;  ///< what the pairs so far were taken with
  std::shared_ptr<const CapturedCalibration> captured_;
};

}  // namespace handmap
