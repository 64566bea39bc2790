#include "app/gui/rig/rig_actions.h"

#include <QFileInfo>
#include <QSettings>
#include <filesystem>

#include "app/gui/rig/live_panel.h"
#include "app/gui/rig/rig_form.h"
#include "app/gui/run/live_robot.h"
#include "app/gui/run/run_actions.h"
#include "app/gui/shell/docks.h"
#include "app/gui/shell/message_bar.h"
#include "core/base/error.h"
#include "drivers/connected/connected_devices.h"
#include "widgets/actions/action_set.h"

namespace handmap {

namespace {
constexpr auto kRigKey = "files/rig";
}

RigActions::RigActions(const Parts& parts, QObject* parent) : QObject(parent), parts_(parts) {
  parts_.actions.on("run.connect", this, [this] { showDialog(); });
  parts_.actions.on("run.calibrate", this, [this] { showCalibration(); });
  connect(&parts_.run, &RunController::stateChanged, this, &RigActions::followRun);
  connect(&parts_.runs, &RunActions::runForgotten, this, &RigActions::followRun);
}

void RigActions::showDialog() {
  if (!dialog_) {
    dialog_ = new RigDialog(parts_.dialogs, connectedDevices(), &parts_.window);
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog_, &RigDialog::chosen, this, &RigActions::use);
    connect(dialog_, &RigDialog::calibrationWanted, this, &RigActions::showCalibration);
    connect(dialog_, &RigDialog::fileUsed, this,
            [this](const QString& path) { parts_.settings.setValue(kRigKey, path); });
    const QString last = parts_.settings.value(kRigKey).toString();
    if (QFileInfo::exists(last)) dialog_->open(last);
  }
  dialog_->show();
  dialog_->raise();
  dialog_->activateWindow();
}

/// With the cameras of the rig that is being put together; what is found goes back there.
void RigActions::showCalibration() {
  if (!calibration_) {
    QWidget* over = dialog_ ? static_cast<QWidget*>(dialog_) : &parts_.window;
    calibration_ = new CalibrationDialog(parts_.dialogs, connectedDevices(), over);
    calibration_->setAttribute(Qt::WA_DeleteOnClose);
    connect(calibration_, &CalibrationDialog::calibrated, this, [this](const CameraRig& camera) {
      showDialog();
      dialog_->form().setCamera(camera);
    });
    if (dialog_) calibration_->setCamera(dialog_->form().camera());
  }
  if (dialog_) dialog_->endTrial();  // a camera has one reader
  calibration_->show();
  calibration_->raise();
  calibration_->activateWindow();
}

void RigActions::openRig(const QString& path) {
  try {
    use(readRig(std::filesystem::absolute(path.toStdString())));
    parts_.settings.setValue(kRigKey, path);
  } catch (const Error& error) {
    parts_.messages.show(MessageBar::Kind::Error, QString::fromStdString(error.what()),
                         QString::fromStdString(error.hint()));
  }
}

void RigActions::use(const Rig& rig) {
  parts_.runs.setRobot(liveRobot(rig, connectedDevices()));
  parts_.messages.show(
      MessageBar::Kind::Info, tr("“%1” is the robot now.").arg(QString::fromStdString(rig.name)),
      tr("Draw where it starts: press, drag to where it looks, release. Then press Run; Stop ends "
         "the drive."));
}

/// Its devices are looked at while the run goes on; what they said last stays.
void RigActions::followRun() {
  const auto link = parts_.run.live();
  LivePanel& panel = parts_.docks.live();
  if (!link) {
    panel.clear();
  } else if (parts_.run.isActive()) {
    panel.follow([link] { return link->monitor(); });
  } else {
    panel.follow({});
  }
  parts_.docks.showLiveDock(link != nullptr);
}

}  // namespace handmap
