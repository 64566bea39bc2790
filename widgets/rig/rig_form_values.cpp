// What is entered as a rig, and a rig as what is entered.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QSpinBox>
#include <QUrl>

#include "core/base/error.h"
#include "core/geometry/pose2.h"
#include "widgets/rig/rig_form.h"

namespace handmap {

namespace {

std::string textOf(const QComboBox& box) { return box.currentText().trimmed().toStdString(); }
std::string textOf(const QLineEdit& edit) { return edit.text().trimmed().toStdString(); }

void refuse(QWidget* field, const QString& words) {
  field->setFocus();
  throw Error(ErrorCode::BadInput, words.toStdString());
}

}  // namespace

void RigForm::need(QLineEdit* field, const QString& words) const {
  if (field->isVisibleTo(this) && textOf(*field).empty()) refuse(field, words);
}

void RigForm::need(QComboBox* field, const QString& words) const {
  if (field->isVisibleTo(this) && textOf(*field).empty()) refuse(field, words);
}

bool RigForm::isBridge(const QUrl& url) {
  const QString scheme = url.scheme();
  return scheme == QLatin1String("ws") || scheme == QLatin1String("wss") ||
         scheme == QLatin1String("foxglove") || scheme == QLatin1String("foxgloves");
}

void RigForm::needBridge(QLineEdit* field) const {
  if (!field->isVisibleTo(this)) return;
  const QUrl url(field->text().trimmed());
  if (!isBridge(url) || url.host().isEmpty()) {
    refuse(field, tr("Enter where the bridge to ROS is: ws://host:9090 or foxglove://host:8765."));
  }
}

/// What a person has forgotten, in the words of the fields.
void RigForm::checkEntered() const {
  const bool two = seesWithTwo();
  need(left_, two ? tr("Choose the left camera.") : tr("Choose a camera."));
  need(right_, tr("Choose the right camera."));
  needBridge(camera_ros_);
  need(left_topic_, tr("Enter the topic of the left images."));
  need(right_topic_, tr("Enter the topic of the right images."));
  if (sees() != Sees::RosCameras)
    need(calibration_, tr("Choose the calibration of the camera: calib.yml."));
  need(scanner_port_, tr("Choose where the scanner is connected."));
  need(scanner_topic_, tr("Enter the topic of the scanner."));
  need(head_port_, tr("Choose where the head is connected."));
  need(odometry_port_, tr("Choose where the wheels are connected."));
  need(odometry_topic_, tr("Enter the topic of the wheels."));
  if (!publish_ros_->text().trimmed().isEmpty()) needBridge(publish_ros_);
  const auto odometry = static_cast<OdometryRigKind>(odometry_->currentData().toInt());
  const bool wheels = odometry == OdometryRigKind::Lines || odometry == OdometryRigKind::Ros;
  if (hasCamera() && has_head_->isChecked() && !wheels) {
    refuse(odometry_,
           tr("A robot that stops to look around needs wheels that measure its motion."));
  }
}

CameraRig RigForm::camera() const {
  CameraRig camera = kept_.camera.value_or(CameraRig{});
  const bool ros = sees() == Sees::RosCameras;
  camera.kind = cameraOf(sees());
  if (seesWithTwo() || ros) camera.right_first = false;
  camera.ros = ros ? textOf(*camera_ros_) : std::string();
  camera.left = ros ? textOf(*left_topic_) : textOf(*left_);
  camera.right = ros ? textOf(*right_topic_) : std::string();
  if (seesWithTwo()) camera.right = textOf(*right_);
  camera.calibration = textOf(*calibration_);
  camera.width = ros ? 0 : width_->value();
  camera.height = ros ? 0 : height_->value();
  if (ros) camera.rate_hz = camera.right_delay_s = 0.0;
  camera.mount = {x_->value(), y_->value(), z_->value(), toRadians(pitch_->value()),
                  toRadians(yaw_->value())};
  return camera;
}

Rig RigForm::rig() const {
  checkEntered();
  Rig rig = kept_;
  rig.name = textOf(*name_);
  if (rig.name.empty()) rig.name = tr("My robot").toStdString();
  rig.range_limit_m = range_->value();
  if (hasCamera()) {
    rig.camera = camera();
    rig.scanner.reset();
    rig.head.reset();
    if (has_head_->isChecked()) rig.head = HeadRig{textOf(*head_port_)};
  } else {
    ScannerRig scanner;
    scanner.kind = scannerOf(sees());
    scanner.port = textOf(*scanner_port_);
    scanner.topic = textOf(*scanner_topic_);
    scanner.mount = {x_->value(), y_->value(), z_->value(), toRadians(yaw_->value())};
    rig.scanner = scanner;
    rig.camera.reset();
    rig.head.reset();
  }
  if (!rig.head) rig.stops.reset();
  rig.odometry = {static_cast<OdometryRigKind>(odometry_->currentData().toInt()),
                  textOf(*odometry_port_), textOf(*odometry_topic_)};
  if (rig.stops && rig.odometry.kind != OdometryRigKind::Ros) rig.stops->topic.clear();
  rig.ros_version = ros_version_->currentData().toInt();
  rig.publish.ros = textOf(*publish_ros_);
  rig.publish.foxglove = foxglove_->value();
  rig.publish.beyond_this_machine = foxglove_->value() > 0 && beyond_->isChecked();
  rig.record = textOf(*record_);
  // One set of checks for what a person enters and what a file says.
  return parseRig(formatRig(rig, {}), tr("The rig").toStdString(), {});
}

void RigForm::setCamera(const CameraRig& camera) {
  kept_.camera = camera;
  const Sees sees = seesOf(camera);
  sees_->setCurrentIndex(sees_->findData(static_cast<int>(sees)));
  if (sees == Sees::RosCameras) {
    camera_ros_->setText(QString::fromStdString(camera.ros));
    left_topic_->setText(QString::fromStdString(camera.left));
    right_topic_->setText(QString::fromStdString(camera.right));
  } else {
    left_->setEditText(QString::fromStdString(camera.left));
    right_->setEditText(QString::fromStdString(camera.right));
  }
  calibration_->setText(QString::fromStdString(camera.calibration.string()));
  width_->setValue(camera.width);
  height_->setValue(camera.height);
  x_->setValue(camera.mount.x);
  y_->setValue(camera.mount.y);
  z_->setValue(camera.mount.z);
  yaw_->setValue(toDegrees(camera.mount.yaw));
  pitch_->setValue(toDegrees(camera.mount.pitch));
}

void RigForm::setRig(const Rig& rig) {
  kept_ = rig;
  name_->setText(QString::fromStdString(rig.name));
  range_->setValue(rig.range_limit_m);
  if (rig.camera) setCamera(*rig.camera);
  if (rig.scanner) {
    const ScannerRig& scanner = *rig.scanner;
    for (const Sees sees : {Sees::Hokuyo, Sees::Rplidar, Sees::Ros, Sees::RosCloud}) {
      if (scannerOf(sees) != scanner.kind) continue;
      sees_->setCurrentIndex(sees_->findData(static_cast<int>(sees)));
    }
    scanner_port_->setEditText(QString::fromStdString(scanner.port));
    if (!scanner.topic.empty()) scanner_topic_->setText(QString::fromStdString(scanner.topic));
    x_->setValue(scanner.mount.x);
    y_->setValue(scanner.mount.y);
    z_->setValue(scanner.mount.z);
    yaw_->setValue(toDegrees(scanner.mount.yaw));
  }
  offerMotions();
  has_head_->setChecked(rig.head.has_value());
  if (rig.head) head_port_->setEditText(QString::fromStdString(rig.head->port));
  odometry_->setCurrentIndex(odometry_->findData(static_cast<int>(rig.odometry.kind)));
  odometry_port_->setEditText(QString::fromStdString(rig.odometry.port));
  if (!rig.odometry.topic.empty()) {
    odometry_topic_->setText(QString::fromStdString(rig.odometry.topic));
  }
  ros_version_->setCurrentIndex(ros_version_->findData(rig.ros_version));
  publish_ros_->setText(QString::fromStdString(rig.publish.ros));
  foxglove_->setValue(rig.publish.foxglove);
  beyond_->setChecked(rig.publish.beyond_this_machine);
  record_->setText(QString::fromStdString(rig.record.string()));
  showRows();
}

}  // namespace handmap
