// The fields of a rig.
#pragma once

#include <QWidget>
#include <functional>
#include <memory>

#include "core/rig/rig.h"
#include "widgets/background/background.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;
class QSpinBox;
class QUrl;

namespace handmap {

class Dialogs;

class RigForm : public QWidget {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(RigForm)
 public:
  /// `dialogs` must outlive it.
  /// `cameras`: see RigAccess.
  using Cameras = std::function<std::vector<std::string>(CameraKind)>;
  RigForm(Dialogs& dialogs, Cameras cameras, QWidget* parent = nullptr);
  ~RigForm() override;

  /// Throws BadInput, in plain words, for what is missing or does not go together; the field to be
  /// mended then has the focus.
  Rig rig() const;
  void setRig(const Rig& rig);
  /// As far as it is entered: what is missing is empty.
  CameraRig camera() const;
  void setCamera(const CameraRig& camera);
  /// Looks anew which ports and cameras there are.
  void listPorts();

 Q_SIGNALS:
  void calibrationWanted();

 private:
  enum class Sees {
    SideBySide,
    TwoCameras,
    FireWire,
    Vision,
    RosCameras,
    Hokuyo,
    Rplidar,
    Ros,
    RosCloud
  };
  void makeSensorRows(QFormLayout& form);
  void makeMotionRows(QFormLayout& form);
  void makeOutputRows(QFormLayout& form);
  void checkEntered() const;
  void need(QLineEdit* field, const QString& words) const;
  void need(QComboBox* field, const QString& words) const;
  static bool isBridge(const QUrl& url);  ///< by its scheme
  void needBridge(QLineEdit* field) const;
  QLineEdit* addBridge(QFormLayout& form, const QString& label);
  QComboBox* addPort(QFormLayout& form, const QString& label, const QString& hint);
  QDoubleSpinBox* addNumber(QFormLayout& form, const QString& label, double low, double high,
                            const QString& suffix);
  QWidget* withBrowse(QLineEdit* edit, bool folder);
  void offerMotions();
  std::vector<QLineEdit*> bridges() const;
  void shareBridge();
  void showRows();
  Sees sees() const;
  static ScannerKind scannerOf(Sees sees);
  static CameraKind cameraOf(Sees sees);
  static Sees seesOf(const CameraRig& camera);
  void listCameras();
  bool seesWithTwo() const { return sees() == Sees::TwoCameras || sees() == Sees::Vision; }
  bool hasCamera() const { return sees() <= Sees::RosCameras; }

  Dialogs& dialogs_;
  Cameras cameras_;
  std::shared_ptr<Lifeline<RigForm>> self_;  ///< shared with who asks for cameras
  QFormLayout* form_;
  QLineEdit* name_;
  QComboBox* sees_;
  QComboBox* left_;
  QComboBox* right_;
  QLineEdit* camera_ros_;
  QLineEdit* left_topic_;
  QLineEdit* right_topic_;
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
  QLineEdit* publish_ros_;
  QSpinBox* foxglove_;
  QCheckBox* beyond_;
  QComboBox* ros_version_;
  Rig kept_;  ///< what has no field stays as it was read
};

}  // namespace handmap
