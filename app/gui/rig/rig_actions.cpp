#include "app/gui/rig/rig_actions.h"

#include <QFileInfo>
#include <QMainWindow>
#include <QSettings>
#include <filesystem>

#include "app/gui/files/file_actions.h"
#include "app/gui/rig/connected_rigs.h"
#include "app/gui/run/live_robot.h"
#include "app/gui/run/run_controller.h"
#include "app/gui/run/source_actions.h"
#include "app/gui/shell/docks.h"
#include "core/base/error.h"
#include "drivers/connected/connected_devices.h"
#include "widgets/actions/action_set.h"
#include "widgets/messages/message_bar.h"
#include "widgets/rig/live_panel.h"
#include "widgets/rig/rig_form.h"

namespace handmap {

namespace {
constexpr auto kRigKey = "files/rig";
}

RigActions::RigActions(const Shell& shell, RunController& run, SourceActions& sources,
                       FileActions& files, QObject* parent)
    : QObject(parent),
      shell_(shell),
      run_(run),
      sources_(sources),
      files_(files),
      panel_(new LivePanel) {
  shell_.docks.add({"live", tr("Robot"), Docks::Group::Run, Docks::When::Now}, panel_);
  shell_.actions.on("run.connect", this, [this] { showDialog(); });
  shell_.actions.on("run.calibrate", this, [this] { showCalibration(); });
  connect(&run_, &RunController::stateChanged, this, &RigActions::followRun);
  connect(&files, &FileActions::drawingReplaced, this, &RigActions::followRun);
}

void RigActions::showDialog() {
  if (!dialog_) {
    dialog_ = new RigDialog(shell_.dialogs, rigAccess(connectedDevices()), &shell_.window);
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog_, &RigDialog::chosen, this, &RigActions::use);
    connect(dialog_, &RigDialog::calibrationWanted, this, &RigActions::showCalibration);
    connect(dialog_, &RigDialog::fileUsed, this,
            [this](const QString& path) { shell_.settings.setValue(kRigKey, path); });
    const QString last = shell_.settings.value(kRigKey).toString();
    if (QFileInfo::exists(last)) dialog_->open(last);
  }
  dialog_->show();
  dialog_->raise();
  dialog_->activateWindow();
}

/// With the cameras of the rig that is being put together; what is found goes back there.
void RigActions::showCalibration() {
  if (!calibration_) {
    QWidget* over = dialog_ ? static_cast<QWidget*>(dialog_) : &shell_.window;
    calibration_ = new CalibrationDialog(shell_.dialogs, rigAccess(connectedDevices()), over);
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
    shell_.settings.setValue(kRigKey, path);
  } catch (const Error& error) {
    shell_.messages.show(MessageBar::Kind::Error, QString::fromStdString(error.what()),
                         QString::fromStdString(error.hint()));
  }
}

void RigActions::use(const Rig& rig) {
  if (files_.mayLeaveRun()) sources_.useLive(liveRobot(rig, connectedDevices()));
}

/// Its devices are looked at while the run goes on; what they said last stays.
void RigActions::followRun() {
  const auto link = run_.live();
  if (!link) {
    panel_->clear();
  } else if (run_.isActive()) {
    panel_->follow([link] { return link->monitor(); });
  } else {
    panel_->follow({});
  }
  shell_.docks.setPossible(*panel_, link != nullptr);
}

}  // namespace handmap
