// The fields of a rig.
#pragma once

#include <QWidget>

#include "drivers/rig/rig.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;
class QSpinBox;

namespace handmap {

class Dialogs;

class RigForm : public QWidget {
  Q_OBJECT
 public:
  /// `dialogs` must outlive it.
  explicit RigForm(Dialogs& dialogs, QWidget* parent = nullptr);

  /// Throws BadInput for what is missing or does not go together.
  Rig rig() const;
  void setRig(const Rig& rig);
  /// Looks anew which ports and cameras there are.
  void listPorts();

 private:
  enum class Sees { SideBySide, TwoCameras, Hokuyo, Rplidar, Ros, RosCloud };
  void makeSensorRows(QFormLayout& form);
  void makeMotionRows(QFormLayout& form);
  QComboBox* addPort(QFormLayout& form, const QString& label, const QString& hint);
  QDoubleSpinBox* addNumber(QFormLayout& form, const QString& label, double low, double high,
                            const QString& suffix);
  QWidget* withBrowse(QLineEdit* edit, bool folder);
  void showRows();
  Sees sees() const;
  static ScannerKind scannerOf(Sees sees);
  bool hasCamera() const { return sees() == Sees::SideBySide || sees() == Sees::TwoCameras; }

  Dialogs& dialogs_;
  QFormLayout* form_;
  QLineEdit* name_;
  QComboBox* sees_;
  QComboBox* left_;
  QComboBox* right_;
  QLineEdit* calibration_;
  QWidget* calibration_row_;
  QSpinBox* width_;
  QSpinBox* height_;
  QComboBox* scanner_port_;
  QLineEdit* scanner_topic_;
  QDoubleSpinBox* x_;
  QDoubleSpinBox* y_;
  QDoubleSpinBox* z_;
  QDoubleSpinBox* yaw_;
  QDoubleSpinBox* pitch_;
  QDoubleSpinBox* range_;
  QCheckBox* has_head_;
  QComboBox* head_port_;
  QComboBox* odometry_;
  QComboBox* odometry_port_;
  QLineEdit* odometry_topic_;
  QLineEdit* record_;
  Rig kept_;  ///< what has no field stays as it was read
};

}  // namespace handmap
