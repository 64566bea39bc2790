#include "widgets/rig/rig_dialog.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QVBoxLayout>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/recording/recording_files.h"
#include "widgets/messages/dialogs.h"
#include "widgets/rig/live_panel.h"
#include "widgets/rig/rig_form.h"
#include "widgets/rig/rig_preview.h"

namespace handmap {

namespace {

constexpr int kLookAtTrial_ms = 100;
constexpr QSize kSize(860, 600);
const QString kFilter = QStringLiteral("Rigs (*.json)");

std::filesystem::path folderOf(const QString& path) {
  return std::filesystem::absolute(path.toStdString()).parent_path();
}

}  // namespace

RigDialog::RigDialog(Dialogs& dialogs, RigAccess access, QWidget* parent)
    : QDialog(parent),
      dialogs_(dialogs),
      access_(std::move(access)),
      form_(new RigForm(dialogs, access_.cameras)),
      preview_(new RigPreviewView),
      devices_(new LivePanel),
      try_(new QPushButton(tr("&Try"))),
      words_(new QLabel) {
  setObjectName("rig_dialog");
  setWindowTitle(tr("Connect a robot"));
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(form_);
  auto* columns = new QHBoxLayout;
  columns->addWidget(scroll, 1);
  columns->addWidget(makeTrialSide(), 1);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(columns, 1);
  words_->setWordWrap(true);
  words_->setObjectName("rig_words");
  words_->hide();
  layout->addWidget(words_);
  makeButtons();
  connect(&looking_, &QTimer::timeout, this, &RigDialog::look);
  connect(form_, &RigForm::calibrationWanted, this, &RigDialog::calibrationWanted);
  connect(&trial_, &RigTrial::failed, this, [this](const Failure& failure) {
    endTrial();
    tell(failure.hint.isEmpty() ? failure.message : failure.message + '\n' + failure.hint);
  });
  preview_->clear(tr("Press Try: what the robot sees appears here."));
  resize(kSize.boundedTo(screen()->availableSize() - QSize(20, 60)));
}

RigDialog::~RigDialog() = default;

QWidget* RigDialog::makeTrialSide() {
  auto* side = new QWidget;
  auto* layout = new QVBoxLayout(side);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(preview_, 3);
  layout->addWidget(devices_, 2);
  try_->setObjectName("rig_try");
  try_->setToolTip(tr("Open all devices and look at what they say"));
  layout->addWidget(try_);
  connect(try_, &QPushButton::clicked, this, &RigDialog::toggleTrial);
  return side;
}

void RigDialog::makeButtons() {
  auto* buttons = new QDialogButtonBox;
  auto* open = buttons->addButton(tr("&Open…"), QDialogButtonBox::ActionRole);
  auto* save = buttons->addButton(tr("&Save…"), QDialogButtonBox::ActionRole);
  auto* ports = buttons->addButton(tr("&List ports anew"), QDialogButtonBox::ActionRole);
  auto* use = buttons->addButton(tr("&Use this robot"), QDialogButtonBox::AcceptRole);
  auto* cancel = buttons->addButton(QDialogButtonBox::Cancel);
  use->setObjectName("rig_use");
  use->setDefault(true);
  connect(open, &QPushButton::clicked, this, &RigDialog::askToOpen);
  connect(save, &QPushButton::clicked, this, &RigDialog::askToSave);
  connect(ports, &QPushButton::clicked, form_, &RigForm::listPorts);
  connect(use, &QPushButton::clicked, this, &RigDialog::use);
  connect(cancel, &QPushButton::clicked, this, &RigDialog::reject);
  layout()->addWidget(buttons);
}

void RigDialog::tell(const QString& words) {
  words_->setText(words);
  words_->setVisible(!words.isEmpty());
}

std::optional<Rig> RigDialog::enteredRig() {
  try {
    Rig rig = form_->rig();
    tell({});
    return rig;
  } catch (const Error& error) {
    tell(QString::fromStdString(error.what()));
    return std::nullopt;
  }
}

bool RigDialog::open(const QString& path) {
  try {
    const std::filesystem::path file = std::filesystem::absolute(path.toStdString());
    form_->setRig(readRig(file));
  } catch (const Error& error) {
    tell(QString::fromStdString(error.what()));
    return false;
  }
  path_ = path;
  tell({});
  Q_EMIT fileUsed(path);
  return true;
}

bool RigDialog::save(const QString& path) {
  const auto rig = enteredRig();
  if (!rig) return false;
  try {
    refuseFileOfRecording(path.toStdString());
    writeFileAtomically(path.toStdString(), formatRig(*rig, folderOf(path)));
  } catch (const Error& error) {
    tell(QString::fromStdString(error.what()));
    return false;
  }
  path_ = path;
  tell(tr("Saved: %1").arg(path));
  Q_EMIT fileUsed(path);
  return true;
}

void RigDialog::askToOpen() {
  const QString path = dialogs_.fileToOpen({tr("Open a rig"), path_, kFilter, {}, {}});
  comeBack();
  if (!path.isEmpty()) open(path);
}

void RigDialog::askToSave() {
  if (!enteredRig()) return;
  const QString path = dialogs_.fileToSave({tr("Save the rig"), QFileInfo(path_).path(), kFilter,
                                            QStringLiteral("robot.json"), QStringLiteral("json")});
  comeBack();
  if (!path.isEmpty()) save(path);
}

/// From the choice of a file, which gives the keys to the window below it.
void RigDialog::comeBack() {
  raise();
  activateWindow();
}

void RigDialog::toggleTrial() {
  if (trying_) return endTrial();
  const auto rig = enteredRig();
  if (!rig) return;
  trying_ = true;
  try_->setText(tr("Stop &trying"));
  preview_->clear(tr("Waiting for the first picture"));
  trial_.start(*rig, access_);
  devices_->follow([this] { return trial_.monitor(); });
  looking_.start(kLookAtTrial_ms);
}

void RigDialog::endTrial() {
  if (!std::exchange(trying_, false)) return;
  looking_.stop();
  trial_.stop();
  devices_->follow({});
  try_->setText(tr("&Try"));
}

void RigDialog::look() {
  const RigPreview preview = trial_.monitor()->preview();
  if (preview.number > 0) preview_->show(preview);
}

void RigDialog::use() {
  const auto rig = enteredRig();
  if (!rig) return;
  Q_EMIT chosen(*rig);
  accept();
}

/// However it is closed, its devices are free again.
void RigDialog::done(int result) {
  endTrial();
  QDialog::done(result);
}

}  // namespace handmap
