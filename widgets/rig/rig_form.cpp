#include "widgets/rig/rig_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCompleter>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSerialPortInfo>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStringListModel>
#include <QToolButton>
#include <QUrl>
#include <algorithm>

#include "widgets/messages/dialogs.h"

namespace handmap {

namespace {

constexpr int kMostPixels = 16384;
constexpr int kMostPort = 65535;

QString cameraHint() {
  return RigForm::tr(
      "A device (/dev/video0), a video file, or the URL of a network camera; on FireWire the "
      "number of the head or “first”; of GigE and USB3 Vision its name");
}
QString portHint() {
  return RigForm::tr(
      "A serial port (/dev/ttyUSB0, with a rate: /dev/ttyUSB0@115200) or an address "
      "(192.168.0.10, host:port); of ROS a rosbridge (ws://host:9090) or a "
      "Foxglove bridge (foxglove://host:8765)");
}

void sayWhere(QComboBox& box, bool over_ros) {
  box.lineEdit()->setPlaceholderText(over_ros
                                         ? RigForm::tr("ws://host:9090 or foxglove://host:8765")
                                         : RigForm::tr("/dev/ttyUSB0, or an address"));
}

void offer(QComboBox& box, const QStringList& choices) {
  const QString now = box.currentText();
  box.clear();
  box.addItems(choices);
  box.setEditText(now);
}

}  // namespace

RigForm::RigForm(Dialogs& dialogs, Cameras cameras, QWidget* parent)
    : QWidget(parent),
      dialogs_(dialogs),
      cameras_(std::move(cameras)),
      self_(std::make_shared<Lifeline<RigForm>>(*this)),
      form_(new QFormLayout(this)),
      name_(new QLineEdit) {
  form_->setContentsMargins(4, 4, 4, 4);
  form_->setRowWrapPolicy(QFormLayout::WrapLongRows);
  name_->setObjectName("rig_name");
  form_->addRow(tr("Name"), name_);
  makeSensorRows(*form_);
  makeMotionRows(*form_);
  makeOutputRows(*form_);
  connect(sees_, &QComboBox::currentIndexChanged, this, &RigForm::offerMotions);
  connect(sees_, &QComboBox::currentIndexChanged, this, &RigForm::showRows);
  connect(sees_, &QComboBox::currentIndexChanged, this, &RigForm::listCameras);
  connect(odometry_, &QComboBox::currentIndexChanged, this, &RigForm::showRows);
  connect(foxglove_, &QSpinBox::valueChanged, this, &RigForm::showRows);
  connect(has_head_, &QCheckBox::toggled, this, &RigForm::showRows);
  connect(publish_ros_, &QLineEdit::textChanged, this, &RigForm::showRows);
  for (QLineEdit* field : bridges())
    connect(field, &QLineEdit::editingFinished, this, &RigForm::shareBridge);
  listPorts();
  Rig rig;
  rig.name = tr("My robot").toStdString();
  rig.camera = CameraRig{};
  rig.odometry.kind = OdometryRigKind::Visual;
  setRig(rig);
}

RigForm::~RigForm() { self_->cut(); }

void RigForm::makeSensorRows(QFormLayout& form) {
  sees_ = new QComboBox;
  sees_->setObjectName("rig_sees");
  sees_->addItem(tr("Stereo camera, both images in one"), static_cast<int>(Sees::SideBySide));
  sees_->addItem(tr("Two cameras"), static_cast<int>(Sees::TwoCameras));
  sees_->addItem(tr("Stereo head on FireWire (Bumblebee)"), static_cast<int>(Sees::FireWire));
  sees_->addItem(tr("Two GigE or USB3 Vision cameras"), static_cast<int>(Sees::Vision));
  sees_->addItem(tr("Two cameras over ROS"), static_cast<int>(Sees::RosCameras));
  sees_->addItem(tr("Laser scanner: Hokuyo"), static_cast<int>(Sees::Hokuyo));
  sees_->addItem(tr("Laser scanner: RPLIDAR"), static_cast<int>(Sees::Rplidar));
  sees_->addItem(tr("Laser scanner over ROS"), static_cast<int>(Sees::Ros));
  sees_->addItem(tr("Point cloud over ROS"), static_cast<int>(Sees::RosCloud));
  form.addRow(tr("Sees with"), sees_);
  left_ = addPort(form, tr("Camera"), cameraHint());
  left_->setObjectName("rig_camera");
  right_ = addPort(form, tr("Right camera"), cameraHint());
  camera_ros_ = addBridge(form, tr("Bridge to ROS"));
  camera_ros_->setObjectName("rig_camera_ros");
  left_topic_ = new QLineEdit(QStringLiteral("/left/image_raw/compressed"));
  right_topic_ = new QLineEdit(QStringLiteral("/right/image_raw/compressed"));
  form.addRow(tr("Topic of the left"), left_topic_);
  form.addRow(tr("Topic of the right"), right_topic_);
  calibration_ = new QLineEdit;
  calibration_->setObjectName("rig_calibration");
  calibration_->setToolTip(tr("calib.yml as “handmap-cli calibrate” writes it"));
  calibration_row_ = withBrowse(calibration_, false);
  auto* calibrate = new QToolButton;
  calibrate->setObjectName("rig_calibrate");
  calibrate->setText(tr("Calibrate…"));
  calibrate->setToolTip(tr("Hold a checkerboard before the cameras"));
  calibration_row_->layout()->addWidget(calibrate);
  connect(calibrate, &QToolButton::clicked, this, &RigForm::calibrationWanted);
  form.addRow(tr("Calibration"), calibration_row_);
  width_ = new QSpinBox;
  height_ = new QSpinBox;
  for (const auto& [box, label] :
       {std::pair(width_, tr("Image width")), std::pair(height_, tr("Image height"))}) {
    box->setRange(0, kMostPixels);
    box->setSpecialValueText(tr("as it comes"));
    box->setSuffix(tr(" px"));
    form.addRow(label, box);
  }
  scanner_port_ = addPort(form, tr("Scanner"), portHint());
  scanner_port_->setObjectName("rig_scanner");
  scanner_topic_ = new QLineEdit(QStringLiteral("/scan"));
  form.addRow(tr("Topic"), scanner_topic_);
  x_ = addNumber(form, tr("Sensor ahead"), -100.0, 100.0, tr(" m"));
  y_ = addNumber(form, tr("Sensor left"), -100.0, 100.0, tr(" m"));
  z_ = addNumber(form, tr("Sensor height"), -100.0, 100.0, tr(" m"));
  yaw_ = addNumber(form, tr("Turned left"), -360.0, 360.0, tr("°"));
  pitch_ = addNumber(form, tr("Looks down by"), -360.0, 360.0, tr("°"));
  range_ = addNumber(form, tr("Sees at most"), 1.0, 200.0, tr(" m"));
}

void RigForm::makeMotionRows(QFormLayout& form) {
  has_head_ = new QCheckBox(tr("It stops, and a pan-tilt head (PTU-D46) looks around"));
  form.addRow(has_head_);
  head_port_ = addPort(form, tr("Head"), portHint());
  odometry_ = new QComboBox;
  odometry_->setObjectName("rig_odometry");
  form.addRow(tr("Motion from"), odometry_);
  odometry_port_ = addPort(form, tr("Wheels"), portHint());
  odometry_port_->setObjectName("rig_wheels");
  odometry_topic_ = new QLineEdit(QStringLiteral("/odom"));
  form.addRow(tr("Topic"), odometry_topic_);
}

void RigForm::makeOutputRows(QFormLayout& form) {
  record_ = new QLineEdit;
  record_->setPlaceholderText(tr("not recorded"));
  record_->setToolTip(tr("Each run gets a new folder in it"));
  form.addRow(tr("Record into"), withBrowse(record_, true));
  publish_ros_ = addBridge(form, tr("Send to ROS"));
  publish_ros_->setObjectName("rig_publish_ros");
  publish_ros_->setPlaceholderText(tr("not sent; ws://host:9090 or foxglove://host:8765"));
  publish_ros_->setToolTip(
      tr("Pose, frames, occupancy grid and buildings are published there, and /initialpose is "
         "heard"));
  publish_ros_->setCompleter(new QCompleter(new QStringListModel(this), this));
  publish_ros_->completer()->setCompletionMode(QCompleter::UnfilteredPopupCompletion);
  ros_version_ = new QComboBox;
  ros_version_->setObjectName("rig_ros_version");
  ros_version_->addItem(QStringLiteral("ROS 2"), 2);
  ros_version_->addItem(QStringLiteral("ROS 1"), 1);
  form.addRow(tr("Version of ROS"), ros_version_);
  foxglove_ = new QSpinBox;
  foxglove_->setObjectName("rig_foxglove");
  foxglove_->setRange(0, kMostPort);
  foxglove_->setSpecialValueText(tr("off"));
  foxglove_->setToolTip(tr("Foxglove connects to this port; its own choice is 8765"));
  form.addRow(tr("Foxglove port"), foxglove_);
  beyond_ = new QCheckBox(tr("From other machines too"));
  form.addRow(beyond_);
}

QLineEdit* RigForm::addBridge(QFormLayout& form, const QString& label) {
  auto* edit = new QLineEdit;
  edit->setPlaceholderText(QStringLiteral("ws://host:9090, foxglove://host:8765"));
  form.addRow(label, edit);
  return edit;
}

QComboBox* RigForm::addPort(QFormLayout& form, const QString& label, const QString& hint) {
  auto* box = new QComboBox;
  box->setEditable(true);
  box->setInsertPolicy(QComboBox::NoInsert);
  box->setToolTip(hint);
  form.addRow(label, box);
  return box;
}

QDoubleSpinBox* RigForm::addNumber(QFormLayout& form, const QString& label, double low, double high,
                                   const QString& suffix) {
  auto* box = new QDoubleSpinBox;
  box->setRange(low, high);
  box->setDecimals(3);
  box->setSingleStep(0.1);
  box->setSuffix(suffix);
  form.addRow(label, box);
  return box;
}

QWidget* RigForm::withBrowse(QLineEdit* edit, bool folder) {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* browse = new QToolButton;
  browse->setText(QStringLiteral("…"));
  browse->setToolTip(folder ? tr("Choose a folder") : tr("Choose a file"));
  layout->addWidget(edit, 1);
  layout->addWidget(browse);
  connect(browse, &QToolButton::clicked, this, [this, edit, folder] {
    const QString chosen = folder
                               ? dialogs_.folderToOpen(tr("Record into"), edit->text())
                               : dialogs_.fileToOpen({tr("Calibration of the camera"),
                                                      edit->text(),
                                                      tr("Calibrations (*.yml *.yaml *.xml *.txt)"),
                                                      {},
                                                      {}});
    if (!chosen.isEmpty()) edit->setText(chosen);
  });
  return row;
}

RigForm::Sees RigForm::sees() const { return static_cast<Sees>(sees_->currentData().toInt()); }

ScannerKind RigForm::scannerOf(Sees sees) {
  switch (sees) {
    case Sees::Rplidar:
      return ScannerKind::Rplidar;
    case Sees::Ros:
      return ScannerKind::Ros;
    case Sees::RosCloud:
      return ScannerKind::RosCloud;
    default:
      return ScannerKind::Hokuyo;
  }
}

CameraKind RigForm::cameraOf(Sees sees) {
  if (sees == Sees::FireWire) return CameraKind::FireWire;
  return sees == Sees::Vision ? CameraKind::Vision : CameraKind::Video;
}

RigForm::Sees RigForm::seesOf(const CameraRig& camera) {
  if (!camera.ros.empty()) return Sees::RosCameras;
  if (camera.kind == CameraKind::FireWire) return Sees::FireWire;
  if (camera.kind == CameraKind::Vision) return Sees::Vision;
  return camera.right.empty() ? Sees::SideBySide : Sees::TwoCameras;
}

/// No images for a laser, no scans for a camera; what was chosen stays where it can.
void RigForm::offerMotions() {
  using Kind = OdometryRigKind;
  const QVariant chosen = odometry_->currentData();
  const QSignalBlocker quiet(odometry_);
  odometry_->clear();
  const auto offer = [this](const QString& words, Kind kind) {
    odometry_->addItem(words, static_cast<int>(kind));
  };
  offer(tr("Wheels: lines of text"), Kind::Lines);
  offer(tr("Wheels over ROS"), Kind::Ros);
  if (hasCamera()) offer(tr("No wheels: the images"), Kind::Visual);
  if (!hasCamera()) offer(tr("No wheels: the scans"), Kind::Scan);
  offer(tr("Nothing"), Kind::None);
  const int same = chosen.isValid() ? odometry_->findData(chosen) : -1;
  const Kind alone = hasCamera() ? Kind::Visual : Kind::Scan;
  odometry_->setCurrentIndex(same >= 0 ? same : odometry_->findData(static_cast<int>(alone)));
}

std::vector<QLineEdit*> RigForm::bridges() const {
  return {camera_ros_, scanner_port_->lineEdit(), odometry_port_->lineEdit(), publish_ros_};
}

/// One is enough: the fields of others that go over ROS and are empty get it too.
void RigForm::shareBridge() {
  const auto fields = bridges();
  const auto has = [](const QLineEdit* field) { return isBridge(QUrl(field->text().trimmed())); };
  const auto known = std::find_if(fields.begin(), fields.end(), has);
  if (known == fields.end()) return;
  const QString url = (*known)->text().trimmed();
  static_cast<QStringListModel*>(publish_ros_->completer()->model())->setStringList({url});
  const auto odometry = static_cast<OdometryRigKind>(odometry_->currentData().toInt());
  const std::pair<QLineEdit*, bool> over_ros[] = {
      {camera_ros_, sees() == Sees::RosCameras},
      {scanner_port_->lineEdit(), sees() == Sees::Ros || sees() == Sees::RosCloud},
      {odometry_port_->lineEdit(), odometry == OdometryRigKind::Ros}};
  for (const auto& [field, is_over_ros] : over_ros) {
    if (is_over_ros && field->text().trimmed().isEmpty()) field->setText(url);
  }
}

void RigForm::showRows() {
  shareBridge();
  const bool camera = hasCamera();
  const auto odometry = static_cast<OdometryRigKind>(odometry_->currentData().toInt());
  const bool ros = odometry == OdometryRigKind::Ros;
  const bool over_ros = sees() == Sees::RosCameras;
  form_->setRowVisible(left_, camera && !over_ros);
  form_->setRowVisible(right_, seesWithTwo());
  form_->setRowVisible(calibration_row_, camera);
  calibration_->setPlaceholderText(over_ros ? tr("empty: as the robot says (camera_info)")
                                            : QString());
  for (QWidget* row : {camera_ros_, left_topic_, right_topic_}) {
    form_->setRowVisible(row, over_ros);
  }
  form_->setRowVisible(width_, camera && !over_ros);
  form_->setRowVisible(height_, camera && !over_ros);
  form_->setRowVisible(pitch_, camera);
  form_->setRowVisible(scanner_port_, !camera);
  form_->setRowVisible(scanner_topic_, sees() == Sees::Ros || sees() == Sees::RosCloud);
  form_->setRowVisible(has_head_, camera);
  form_->setRowVisible(head_port_, camera && has_head_->isChecked());
  form_->setRowVisible(odometry_port_, ros || odometry == OdometryRigKind::Lines);
  form_->setRowVisible(odometry_topic_, ros);
  form_->setRowVisible(beyond_, foxglove_->value() > 0);
  const bool scans_over_ros = sees() == Sees::Ros || sees() == Sees::RosCloud;
  sayWhere(*scanner_port_, scans_over_ros);
  sayWhere(*odometry_port_, ros);
  form_->setRowVisible(
      ros_version_, ros || over_ros || scans_over_ros || !publish_ros_->text().trimmed().isEmpty());
}

void RigForm::listPorts() {
  QStringList serial;
  for (const QSerialPortInfo& port : QSerialPortInfo::availablePorts()) {
    serial << port.systemLocation();
  }
  for (QComboBox* box : {scanner_port_, head_port_, odometry_port_}) offer(*box, serial);
  listCameras();
}

/// Who asks what is on a bus waits for a second: not the window.
void RigForm::listCameras() {
  startInBackground([self = self_, list = cameras_, kind = cameraOf(sees())] {
    QStringList cameras;
    try {
      for (const std::string& name : list(kind)) cameras << QString::fromStdString(name);
    } catch (const std::exception&) {
      return;  // a bus that is not there has no cameras
    }
    self->post([kind, cameras](RigForm& form) {
      if (cameraOf(form.sees()) != kind) return;
      for (QComboBox* box : {form.left_, form.right_}) offer(*box, cameras);
    });
  });
}

}  // namespace handmap
