#include "widgets/calibration/calibration_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScreen>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/recording/recording_files.h"
#include "widgets/calibration/board_view.h"
#include "widgets/calibration/calibration_words.h"
#include "widgets/messages/dialogs.h"

namespace handmap {

namespace {

constexpr int kLook_ms = 60;
constexpr qint64 kShowTaken_ms = 1200;
constexpr QSize kSize(900, 560);

}  // namespace

CalibrationDialog::CalibrationDialog(Dialogs& dialogs, RigAccess access, QWidget* parent)
    : QDialog(parent),
      dialogs_(dialogs),
      access_(std::move(access)),
      view_(new BoardPairView),
      needs_(new QListWidget),
      verdict_(new QLabel),
      words_(new QLabel) {
  setObjectName("calibration_dialog");
  setWindowTitle(tr("Calibrate cameras"));
  auto* columns = new QHBoxLayout;
  columns->addWidget(makeForm());
  auto* seen = new QVBoxLayout;
  seen->addWidget(view_, 1);
  QFont large = verdict_->font();
  large.setPointSizeF(large.pointSizeF() * 1.3);
  verdict_->setFont(large);
  verdict_->setObjectName("calibration_verdict");
  verdict_->setWordWrap(true);
  seen->addWidget(verdict_);
  columns->addLayout(seen, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(columns, 1);
  words_->setObjectName("calibration_words");
  words_->setWordWrap(true);
  words_->hide();
  layout->addWidget(words_);
  makeButtons();
  connect(&looking_, &QTimer::timeout, this, &CalibrationDialog::look);
  connect(&work_, &CalibrationWork::failed, this, [this](const Failure& failure) {
    end();
    verdict_->clear();
    tell(failure.hint.isEmpty() ? failure.message : failure.message + '\n' + failure.hint);
  });
  connect(&work_, &CalibrationWork::calibrated, this, &CalibrationDialog::showResult);
  view_->clear(
      tr("Print a checkerboard, glue it on something flat, and measure its squares. Press Start "
         "and hold it before both cameras: what is needed is taken by itself."));
  resize(kSize.boundedTo(screen()->availableSize() - QSize(20, 60)));
}

QWidget* CalibrationDialog::makeForm() {
  auto* side = new QWidget;
  auto* form = new QFormLayout(side);
  form->setContentsMargins(0, 0, 0, 0);
  left_ = new QComboBox;
  right_ = new QComboBox;
  for (QComboBox* box : {left_, right_}) {
    box->setEditable(true);
    box->setInsertPolicy(QComboBox::NoInsert);
    box->setToolTip(tr("A device (/dev/video0), a video file, or the URL of a network camera"));
    box->setMinimumContentsLength(14);
  }
  left_->setObjectName("calibration_left");
  right_->setObjectName("calibration_right");
  right_->lineEdit()->setPlaceholderText(tr("none: both images in one"));
  form->addRow(tr("Camera"), left_);
  form->addRow(tr("Right camera"), right_);
  columns_ = new QSpinBox;
  rows_ = new QSpinBox;
  for (QSpinBox* box : {columns_, rows_}) box->setRange(3, 50);
  columns_->setValue(9);
  rows_->setValue(6);
  columns_->setToolTip(tr("Where four squares meet: one less than there are squares"));
  rows_->setToolTip(columns_->toolTip());
  form->addRow(tr("Inner corners across"), columns_);
  form->addRow(tr("Inner corners down"), rows_);
  square_ = new QDoubleSpinBox;
  square_->setRange(1.0, 1000.0);
  square_->setDecimals(2);
  square_->setSuffix(tr(" mm"));
  square_->setValue(30.0);
  square_->setToolTip(tr("The side of a square, measured: all distances hang on it"));
  form->addRow(tr("Squares"), square_);
  keep_ = new QLineEdit;
  keep_->setObjectName("calibration_keep");
  keep_->setPlaceholderText(tr("not kept"));
  keep_->setToolTip(tr("For “handmap-cli calibrate”, to do it again with the same pictures"));
  form->addRow(tr("Keep pictures in"), withBrowse(keep_));
  needs_->setObjectName("calibration_needs");
  needs_->setSelectionMode(QAbstractItemView::NoSelection);
  needs_->setFocusPolicy(Qt::NoFocus);
  form->addRow(needs_);
  listCameras();
  return side;
}

QWidget* CalibrationDialog::withBrowse(QLineEdit* edit) {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* browse = new QToolButton;
  browse->setText(QStringLiteral("…"));
  browse->setToolTip(tr("Choose a folder"));
  layout->addWidget(edit, 1);
  layout->addWidget(browse);
  connect(browse, &QToolButton::clicked, this, [this, edit] {
    const QString chosen = dialogs_.folderToOpen(tr("Keep pictures in"), edit->text());
    if (!chosen.isEmpty()) edit->setText(chosen);
  });
  return row;
}

void CalibrationDialog::makeButtons() {
  auto* buttons = new QDialogButtonBox;
  start_ = buttons->addButton(tr("&Start"), QDialogButtonBox::ActionRole);
  calibrate_ = buttons->addButton(tr("&Calibrate now"), QDialogButtonBox::ActionRole);
  save_ = buttons->addButton(tr("Save and &use…"), QDialogButtonBox::AcceptRole);
  auto* close = buttons->addButton(QDialogButtonBox::Close);
  start_->setObjectName("calibration_start");
  calibrate_->setObjectName("calibration_now");
  save_->setObjectName("calibration_save");
  calibrate_->setEnabled(false);
  save_->setEnabled(false);
  start_->setDefault(true);
  connect(start_, &QPushButton::clicked, this, &CalibrationDialog::toggle);
  connect(calibrate_, &QPushButton::clicked, this, &CalibrationDialog::finish);
  connect(save_, &QPushButton::clicked, this, &CalibrationDialog::save);
  connect(close, &QPushButton::clicked, this, &CalibrationDialog::reject);
  layout()->addWidget(buttons);
}

void CalibrationDialog::listCameras() {
  for (const std::string& name : access_.cameras(CameraKind::Video)) {
    for (QComboBox* box : {left_, right_}) box->addItem(QString::fromStdString(name));
  }
  right_->setEditText({});
}

void CalibrationDialog::setCamera(const CameraRig& camera) {
  camera_ = camera;
  left_->setEditText(QString::fromStdString(camera.left));
  right_->setEditText(QString::fromStdString(camera.right));
}

std::optional<CameraRig> CalibrationDialog::enteredCamera() {
  CameraRig camera = camera_;
  camera.left = left_->currentText().trimmed().toStdString();
  camera.right = right_->currentText().trimmed().toStdString();
  const auto refuse = [this](QWidget* field, const QString& words) {
    field->setFocus();
    tell(words);
    return std::nullopt;
  };
  if (camera.left.empty()) return refuse(left_, tr("Choose a camera."));
  if (columns_->value() == rows_->value()) {
    return refuse(rows_, tr("A board with as many corners across as down does not tell which side "
                            "is up: use another one."));
  }
  tell({});
  return camera;
}

void CalibrationDialog::toggle() {
  if (looking_.isActive()) {
    work_.stop();
    end();
  } else {
    begin();
  }
}

/// On top of what was taken, unless the cameras or the board are others now.
void CalibrationDialog::begin() {
  const auto camera = enteredCamera();
  if (!camera) return;
  const QString with = QStringLiteral("%1 %2 %3 %4 %5 %6")
                           .arg(left_->currentText(), right_->currentText())
                           .arg(columns_->value())
                           .arg(rows_->value())
                           .arg(square_->value())
                           .arg(keep_->text());
  if (with != begun_with_) {
    const Board board{{columns_->value(), rows_->value()}, square_->value() / 1000.0};
    work_.begin(board, keep_->text().trimmed().toStdString());
    begun_with_ = with;
    needs_->clear();
    taken_ = 0;
  }
  captured_.reset();
  camera_ = *camera;
  work_.look(*camera, access_);
  view_->clear(tr("Waiting for the first picture"));
  start_->setText(tr("&Stop"));
  save_->setEnabled(false);
  looking_.start(kLook_ms);
}

void CalibrationDialog::finish() {
  end();
  verdict_->setText(tr("Calibrating: this takes some seconds."));
  start_->setEnabled(false);
  work_.finish();
}

void CalibrationDialog::end() {
  looking_.stop();
  start_->setText(taken_ > 0 ? tr("&Start again") : tr("&Start"));
  start_->setEnabled(true);
  calibrate_->setEnabled(false);
}

void CalibrationDialog::look() {
  if (const auto status = work_.newest()) {
    view_->show(status);
    showStatus(*status);
    if (status->enough) return finish();
  }
  const auto monitor = work_.monitor();
  for (const DeviceStatus& device : monitor->status().devices) {
    const bool troubled =
        device.state == DeviceState::Lost || device.state == DeviceState::Degraded;
    tell(troubled ? QString::fromStdString(device.detail) : QString());
  }
}

void CalibrationDialog::showStatus(const CaptureStatus& status) {
  if (status.taken > taken_ || needs_->count() == 0) showNeeds(status.missing);
  if (status.taken > taken_) {
    taken_ = status.taken;
    since_taken_.start();
  }
  const bool just_taken = since_taken_.isValid() && since_taken_.elapsed() < kShowTaken_ms;
  const QString count = tr("%1 of %2 pairs").arg(status.taken).arg(BoardSurvey::kEnough);
  verdict_->setText(count + QStringLiteral(" · ") +
                    inWords(just_taken ? BoardVerdict::Taken : status.verdict, status.missing));
  calibrate_->setEnabled(status.taken >= static_cast<int>(kLeastPairs));
}

void CalibrationDialog::showNeeds(const std::vector<BoardNeed>& missing) {
  needs_->clear();
  for (const BoardNeed need : kAllBoardNeeds) {
    const bool is_missing = std::find(missing.begin(), missing.end(), need) != missing.end();
    needs_->addItem((is_missing ? QStringLiteral("○ ") : QStringLiteral("✓ ")) + inWords(need));
  }
}

void CalibrationDialog::showResult(const std::shared_ptr<const CapturedCalibration>& captured) {
  end();
  captured_ = captured;
  view_->show(captured);
  verdict_->setText(inWords(captured->result));
  tell({});
  save_->setEnabled(true);
  save_->setDefault(true);
}

void CalibrationDialog::save() {
  const QString path = dialogs_.fileToSave({tr("Save the calibration"),
                                            {},
                                            tr("Calibrations (*.yml)"),
                                            QStringLiteral("calib.yml"),
                                            QStringLiteral("yml")});
  if (path.isEmpty()) return;
  try {
    refuseFileOfRecording(path.toStdString());
    writeFileAtomically(path.toStdString(), formatStereoCalibration(captured_->result.calibration));
  } catch (const Error& error) {
    return tell(QString::fromStdString(error.what()));
  }
  CameraRig camera = camera_;
  camera.calibration = path.toStdString();
  Q_EMIT calibrated(camera);
  accept();
}

void CalibrationDialog::tell(const QString& words) {
  words_->setText(words);
  words_->setVisible(!words.isEmpty());
}

/// However it is closed, the cameras are free again.
void CalibrationDialog::done(int result) {
  work_.stop();
  end();
  QDialog::done(result);
}

}  // namespace handmap
