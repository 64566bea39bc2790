#include "widgets/rig/live_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace handmap {

namespace {

constexpr int kLook_ms = 250;
constexpr int kMostReasons = 3;
enum Column { NameColumn, StateColumn, RateColumn, AgeColumn, Columns };

QString roleInWords(DeviceRole role) {
  switch (role) {
    case DeviceRole::Odometry:
      return LivePanel::tr("Wheels");
    case DeviceRole::Scanner:
      return LivePanel::tr("Scanner");
    case DeviceRole::Camera:
      return LivePanel::tr("Camera");
    case DeviceRole::Head:
      return LivePanel::tr("Head");
    case DeviceRole::ToRos:
      return LivePanel::tr("To ROS");
    case DeviceRole::ToFoxglove:
      return LivePanel::tr("To Foxglove");
  }
  return {};
}

/// Never by colour alone: the words say it too.
const char* signOf(DeviceState state) {
  switch (state) {
    case DeviceState::Ready:
      return "\u25cf";  // full
    case DeviceState::Degraded:
      return "\u25d0";  // half
    case DeviceState::Connecting:
      return "\u25cc";  // dotted
    case DeviceState::Lost:
      return "\u2715";  // a cross
    case DeviceState::Closed:
      return "\u25cb";  // empty
  }
  return "";
}

QString refusedInWords(const RigStatus& status) {
  std::vector<std::pair<std::string, long>> reasons(status.refused.begin(), status.refused.end());
  std::stable_sort(reasons.begin(), reasons.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  if (reasons.size() > kMostReasons) reasons.resize(kMostReasons);
  QStringList words;
  for (const auto& [reason, count] : reasons) {
    words << LivePanel::tr("%1 × %2").arg(count).arg(QString::fromStdString(reason));
  }
  return words.isEmpty() ? QString() : LivePanel::tr("Not used: ") + words.join(", ");
}

QString recordingInWords(const RecordingStatus& recording) {
  if (recording.folder.empty()) return {};
  if (!recording.error.empty()) {
    return LivePanel::tr("The recording has ended, the run goes on: %1")
        .arg(QString::fromStdString(recording.error));
  }
  return LivePanel::tr("Recorded: %1 in %2")
      .arg(recording.observations)
      .arg(QString::fromStdString(recording.folder));
}

QString stateOf(const DeviceStatus& device) {
  static constexpr const char* kWords[] = {QT_TRANSLATE_NOOP("handmap::LivePanel", "closed"),
                                           QT_TRANSLATE_NOOP("handmap::LivePanel", "connecting"),
                                           QT_TRANSLATE_NOOP("handmap::LivePanel", "ready"),
                                           QT_TRANSLATE_NOOP("handmap::LivePanel", "degraded"),
                                           QT_TRANSLATE_NOOP("handmap::LivePanel", "lost")};
  return LivePanel::tr(kWords[static_cast<int>(device.state)]);
}

}  // namespace

LivePanel::LivePanel(QWidget* parent)
    : QWidget(parent),
      devices_(new QTreeWidget),
      counts_(new QLabel),
      look_around_(new QPushButton(tr("Look around"))) {
  setObjectName("live_panel");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  devices_->setObjectName("live_devices");
  devices_->setAccessibleName(tr("Devices"));
  devices_->setColumnCount(Columns);
  devices_->setHeaderLabels({tr("Device"), tr("State"), tr("Rate"), tr("Age")});
  devices_->setRootIsDecorated(false);
  devices_->setSelectionMode(QAbstractItemView::NoSelection);
  devices_->setFocusPolicy(Qt::NoFocus);
  devices_->header()->setStretchLastSection(false);
  devices_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  devices_->header()->setSectionResizeMode(StateColumn, QHeaderView::Stretch);
  devices_->setMinimumHeight(60);
  counts_->setWordWrap(true);
  counts_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  counts_->setObjectName("live_counts");
  look_around_->setToolTip(tr("Stop the robot; its head then looks into all directions"));
  look_around_->hide();
  layout->addWidget(devices_, 1);
  layout->addWidget(counts_);
  layout->addWidget(look_around_);
  connect(look_around_, &QPushButton::clicked, this, [this] {
    if (const auto monitor = monitor_ ? monitor_() : nullptr) monitor->lookAround();
  });
  connect(&timer_, &QTimer::timeout, this, &LivePanel::look);
}

void LivePanel::follow(Monitor monitor) {
  look();  // what there was to say last
  monitor_ = std::move(monitor);
  look_around_->setEnabled(bool(monitor_));
  if (!monitor_) return timer_.stop();
  look();
  timer_.start(kLook_ms);
}

void LivePanel::clear() {
  follow({});
  devices_->clear();
  counts_->clear();
  look_around_->hide();
}

void LivePanel::look() {
  if (const auto monitor = monitor_ ? monitor_() : nullptr) show(monitor->status());
}

void LivePanel::show(const RigStatus& status) {
  while (devices_->topLevelItemCount() > static_cast<int>(status.devices.size())) {
    delete devices_->takeTopLevelItem(devices_->topLevelItemCount() - 1);
  }
  bool has_head = false;
  for (int row = 0; row < static_cast<int>(status.devices.size()); ++row) {
    const DeviceStatus& device = status.devices[static_cast<std::size_t>(row)];
    if (row == devices_->topLevelItemCount()) devices_->addTopLevelItem(new QTreeWidgetItem);
    QTreeWidgetItem& item = *devices_->topLevelItem(row);
    item.setText(NameColumn, QString::fromUtf8(signOf(device.state)) + QLatin1Char(' ') +
                                 roleInWords(device.role));
    item.setText(StateColumn, stateOf(device));
    item.setToolTip(StateColumn, QString::fromStdString(device.detail));
    item.setText(RateColumn, device.rate_hz > 0.0 ? tr("%1 Hz").arg(device.rate_hz, 0, 'f', 1)
                                                  : QStringLiteral("\u2013"));
    item.setText(AgeColumn, device.age_s ? tr("%1 s").arg(*device.age_s, 0, 'f', 1)
                                         : QStringLiteral("\u2013"));
    has_head |= device.role == DeviceRole::Head;
  }
  look_around_->setVisible(has_head);
  QStringList lines;
  for (const DeviceStatus& device : status.devices) {  // the column has no room for them
    if (!device.detail.empty())
      lines << roleInWords(device.role) + QStringLiteral(": ") +
                   QString::fromStdString(device.detail);
  }
  lines << tr("%1 observations taken, %2 passed over for newer ones")
               .arg(status.given)
               .arg(status.passed_over);
  for (const QString& line : {QString::fromStdString(status.activity), refusedInWords(status),
                              recordingInWords(status.recording)}) {
    if (!line.isEmpty()) lines << line;
  }
  counts_->setText(lines.join(QLatin1Char('\n')));
}

}  // namespace handmap
