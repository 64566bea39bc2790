#include "widgets/importing/import_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <algorithm>
#include <variant>

#include "core/geometry/pose2.h"
#include "core/recording/sensor_place.h"
#include "widgets/background/failure.h"
#include "widgets/rig/rig_preview.h"

namespace handmap {

namespace {

using Answer = std::variant<std::shared_ptr<const Log>, Question, Failure>;

Answer readInBackground(const QStringList& files, const LogOptions& options) {
  try {
    std::vector<std::filesystem::path> paths;
    for (const QString& file : files) paths.emplace_back(file.toStdString());
    return std::make_shared<const Log>(readLogs(paths, options));
  } catch (const Question& question) {
    return question;
  } catch (const Error& error) {
    return failureOf(error);
  } catch (const std::exception& error) {
    return Failure{ErrorCode::RunFailed, QString::fromUtf8(error.what()), {}};
  }
}

std::optional<double> chosen(const QComboBox& units) {
  const QVariant factor = units.currentData();
  return factor.isValid() ? std::optional(factor.toDouble()) : std::nullopt;
}

}  // namespace

ImportDialog::ImportDialog(const QStringList& files, QWidget* parent)
    : QDialog(parent),
      files_(files),
      preview_(new RigPreviewView),
      words_(new QLabel),
      metres_(new QComboBox),
      seconds_(new QComboBox),
      radians_(new QComboBox),
      angles_(new QLineEdit),
      rate_(new QLineEdit),
      columns_(new QLineEdit),
      sensor_(new QLineEdit),
      self_(std::make_shared<Lifeline<ImportDialog>>(*this)) {
  setObjectName("import_dialog");
  setWindowTitle(tr("Import a log"));
  resize(760, 460);
  auto* columns = new QHBoxLayout;
  auto* form = new QFormLayout;
  columns->addWidget(preview_, 1);
  columns->addLayout(form);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  import_ = buttons->addButton(tr("Import…"), QDialogButtonBox::AcceptRole);
  import_->setDefault(true);
  // It has the focus while it is all that can be pressed: Return would leave.
  buttons->button(QDialogButtonBox::Cancel)->setAutoDefault(false);
  auto* another = buttons->addButton(tr("&Another File…"), QDialogButtonBox::ActionRole);
  another->setToolTip(tr("Such as the poses that belong to the scans."));
  another->setObjectName("import_another");
  import_->setObjectName("import_import");
  connect(another, &QPushButton::clicked, this, &ImportDialog::anotherFileWanted);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  words_->setWordWrap(true);
  words_->setObjectName("import_words");
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(columns, 1);
  layout->addWidget(words_);
  layout->addWidget(buttons);
  form->addRow(tr("Lengths"), metres_);
  form->addRow(tr("Times"), seconds_);
  form->addRow(tr("Headings"), radians_);
  form->addRow(tr("Directions"), angles_);
  form->addRow(tr("Scans a second"), rate_);
  form->addRow(tr("Columns"), columns_);
  form->addRow(tr("Place of the sensor"), sensor_);
  addFields();
  read();
}

ImportDialog::~ImportDialog() {
  self_->cut();
  for (const QLineEdit* field : {angles_, rate_, columns_, sensor_})
    field->disconnect(this);  // they lose the focus
}

void ImportDialog::addFields() {
  const QString as_they_look = tr("As they look");
  for (QComboBox* units : {metres_, seconds_, radians_}) units->addItem(as_they_look);
  metres_->addItem(tr("metres"), 1.0);
  metres_->addItem(tr("centimetres"), 0.01);
  metres_->addItem(tr("millimetres"), 0.001);
  seconds_->addItem(tr("seconds"), 1.0);
  seconds_->addItem(tr("milliseconds"), 1e-3);
  seconds_->addItem(tr("microseconds"), 1e-6);
  seconds_->addItem(tr("nanoseconds"), 1e-9);
  radians_->addItem(tr("radians"), 1.0);
  radians_->addItem(tr("degrees"), toRadians(1.0));
  columns_->setMinimumWidth(fontMetrics().averageCharWidth() * 28);
  angles_->setPlaceholderText(tr("first:step, e.g. -90:0.5"));
  angles_->setToolTip(tr("Of the ranges of a scan: degrees, 0 ahead, positive to the left."));
  rate_->setPlaceholderText(tr("where there are no times"));
  columns_->setPlaceholderText(tr("e.g. time=1,ranges=2-362"));
  sensor_->setPlaceholderText(tr("x,y,z, e.g. 0.3,0,1.7"));
  sensor_->setToolTip(
      tr("Where on the robot the scanner is: ahead, left, up, metres, and how far it "
         "is turned to the left, degrees."));
  sensor_->setObjectName("import_sensor");
  angles_->setObjectName("import_angles");
  metres_->setObjectName("import_metres");
  for (QComboBox* units : {metres_, seconds_, radians_}) {
    connect(units, &QComboBox::currentIndexChanged, this, &ImportDialog::read);
  }
  for (QLineEdit* field : {angles_, rate_, columns_, sensor_}) {
    connect(field, &QLineEdit::editingFinished, this, [this] {
      if (typed() != typed_) read();  // else a click on “Import…” finds it reading
    });
  }
}

void ImportDialog::add(const QString& file) {
  raise();
  activateWindow();
  if (file.isEmpty()) return;
  files_ << file;
  read();
}

/// Where a question is answered.
QLineEdit& ImportDialog::fieldOf(const std::string& option) const {
  return *(option == "angles" ? angles_ : option == "rate" ? rate_ : columns_);
}

QStringList ImportDialog::typed() const {
  return {angles_->text(), rate_->text(), columns_->text(), sensor_->text()};
}

/// Throws Usage.
LogOptions ImportDialog::options() const {
  LogOptions options;
  options.metres = chosen(*metres_);
  options.seconds = chosen(*seconds_);
  options.radians = chosen(*radians_);
  const QString angles = angles_->text().trimmed();
  const QString columns = columns_->text().trimmed();
  if (!angles.isEmpty()) setAngles(angles.toStdString(), options);
  const QString sensor = sensor_->text().trimmed();
  if (!sensor.isEmpty()) options.sensor = parseSensorPlace(sensor.toStdString());
  if (!columns.isEmpty()) setColumns(columns.toStdString(), options);
  bool is_rate = false;
  const double rate_hz = rate_->text().toDouble(&is_rate);
  if (is_rate && rate_hz > 0.0) options.rate_hz = rate_hz;
  return options;
}

void ImportDialog::read() {
  log_.reset();
  typed_ = typed();
  import_->setEnabled(false);
  LogOptions told;
  try {
    told = options();
  } catch (const Error& error) {
    return ask(QString::fromStdString(error.what()), {});
  }
  words_->setText(tr("Reading…"));
  startInBackground([self = self_, request = ++request_, files = files_, told] {
    self->post([request, answer = readInBackground(files, told)](ImportDialog& dialog) {
      if (request != dialog.request_) return;
      if (const auto* failure = std::get_if<Failure>(&answer)) {
        dialog.ask(failure->message, failure->hint);
      } else if (const auto* question = std::get_if<Question>(&answer)) {
        dialog.ask(QString::fromStdString(question->what()),
                   QString::fromStdString(question->text()));
        dialog.fieldOf(question->option()).setFocus();
      } else {
        dialog.show(std::get<std::shared_ptr<const Log>>(answer));
      }
    });
  });
}

void ImportDialog::show(const std::shared_ptr<const Log>& log) {
  const auto first =
      std::ranges::find_if(log->scans, [](const LoggedScan& scan) { return !scan.points.empty(); });
  if (first == log->scans.end()) {
    return ask(tr("There is no scan in it."), tr("Poses alone are no recording."));
  }
  log_ = log;
  RigPreview preview;
  preview.number = request_;
  preview.points = first->points;
  preview_->show(preview);
  QStringList words{tr("%n scan(s)", nullptr, static_cast<int>(log->scans.size())) + ", " +
                    tr("%n pose(s)", nullptr, static_cast<int>(log->poses.size()))};
  for (const std::string& note : log->notes) words << QString::fromStdString(note);
  words_->setText(words.join('\n'));
  import_->setEnabled(true);
}

void ImportDialog::ask(const QString& message, const QString& hint) {
  preview_->clear(message);
  words_->setText(hint);
}

}  // namespace handmap
