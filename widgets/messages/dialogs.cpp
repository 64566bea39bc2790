#include "widgets/messages/dialogs.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QInputDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>

namespace handmap {

namespace {

/// What is saved is of the kind that was chosen, whatever the name was before.
void takeEnding(QFileDialog& dialog, const QString& filter) {
  static const QRegularExpression kEnding(QStringLiteral(R"(\*\.([\w.]+))"));
  const QString ending = kEnding.match(filter).captured(1);
  if (ending.isEmpty()) return;
  const QFileInfo file(dialog.selectedFiles().value(0));
  const QString before = u'.' + dialog.defaultSuffix();
  const QString name = file.fileName().endsWith(before) ? file.fileName().chopped(before.size())
                                                        : file.completeBaseName();
  dialog.setDefaultSuffix(ending);
  if (!name.isEmpty()) dialog.selectFile(name + QLatin1Char('.') + ending);
}

/// "Campus v1.2" is a name without an ending, and "plan.jpg" no PNG: what tells its kind is added.
QString withEnding(const QString& path, const QFileDialog& dialog) {
  static const QRegularExpression kEnding(QStringLiteral(R"(\*(\.[\w.]+))"));
  auto endings = kEnding.globalMatch(dialog.nameFilters().join(u' '));
  if (path.isEmpty() || !endings.hasNext() || dialog.defaultSuffix().isEmpty()) return path;
  while (endings.hasNext()) {
    if (path.endsWith(endings.next().captured(1), Qt::CaseInsensitive)) return path;
  }
  return path + QLatin1Char('.') + dialog.defaultSuffix();
}

class SystemDialogs : public Dialogs {
 public:
  explicit SystemDialogs(QWidget& window) : window_(window) {}

  QString fileToOpen(const File& file) override {
    return QFileDialog::getOpenFileName(&window_, file.title, file.folder, file.filter);
  }

  QString fileToSave(const File& file) override {
    QFileDialog dialog(&window_, file.title, file.folder, file.filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(file.suffix);
    dialog.selectFile(file.suggestion);
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog,
                     [&dialog](const QString& filter) { takeEnding(dialog, filter); });
    if (dialog.exec() != QDialog::Accepted) return {};
    const QString chosen = dialog.selectedFiles().value(0);
    const QString path = withEnding(chosen, dialog);
    return path == chosen || mayReplace(path) ? path : QString();
  }

  QString folderToOpen(const QString& title, const QString& folder) override {
    return QFileDialog::getExistingDirectory(&window_, title, folder);
  }

  int choose(const Question& question) override {
    QMessageBox box(QMessageBox::Question, question.title, question.text, QMessageBox::Cancel,
                    &window_);
    QList<QAbstractButton*> buttons;
    for (const QString& answer : question.answers) {
      buttons << box.addButton(answer, QMessageBox::AcceptRole);
    }
    if (!buttons.isEmpty()) box.setDefaultButton(qobject_cast<QPushButton*>(buttons.front()));
    box.exec();
    return static_cast<int>(buttons.indexOf(box.clickedButton()));
  }

  QList<double> numbers(const QString& title, const QList<Number>& lines) override {
    QDialog dialog(&window_);
    constexpr int kBesideTitle = 160;  // pixels: icon and buttons of the frame
    dialog.setWindowTitle(title);
    dialog.setMinimumWidth(dialog.fontMetrics().horizontalAdvance(title) + kBesideTitle);
    auto* form = new QFormLayout(&dialog);
    QList<QDoubleSpinBox*> fields;
    for (const Number& line : lines) {
      auto* field = new QDoubleSpinBox;
      field->setLocale(QLocale::c());
      field->setDecimals(line.decimals);
      field->setRange(line.low, line.high);
      field->setValue(line.value);
      field->setSuffix(line.suffix);
      form->addRow(line.label, field);
      fields << field;
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    form->addRow(buttons);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    if (!fields.isEmpty()) fields.front()->selectAll();  // what is typed replaces it
    if (dialog.exec() != QDialog::Accepted) return {};
    QList<double> values;
    for (const QDoubleSpinBox* field : fields) values << field->value();
    return values;
  }

  QString typedOrKnown(const QString& title, const QString& label,
                       const QStringList& known) override {
    QInputDialog dialog(&window_);
    dialog.setWindowTitle(title);
    dialog.setLabelText(label);
    dialog.setComboBoxItems(known);
    dialog.setComboBoxEditable(true);
    if (const auto* box = dialog.findChild<QComboBox*>()) box->lineEdit()->selectAll();
    return dialog.exec() == QDialog::Accepted ? dialog.textValue().trimmed() : QString();
  }

 private:
  /// The dialog has asked for another name.
  bool mayReplace(const QString& path) {
    if (!QFileInfo::exists(path)) return true;
    const int answer =
        choose({QObject::tr("Replace?"),
                QObject::tr("“%1” is there already.").arg(QFileInfo(path).fileName()),
                {QObject::tr("&Replace")}});
    return answer == 0;
  }

  QWidget& window_;
};

}  // namespace

std::unique_ptr<Dialogs> systemDialogs(QWidget& window) {
  return std::make_unique<SystemDialogs>(window);
}

}  // namespace handmap
