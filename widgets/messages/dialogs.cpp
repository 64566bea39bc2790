#include "widgets/messages/dialogs.h"

#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>

namespace handmap {

namespace {

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
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
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

 private:
  QWidget& window_;
};

}  // namespace

std::unique_ptr<Dialogs> systemDialogs(QWidget& window) {
  return std::make_unique<SystemDialogs>(window);
}

}  // namespace handmap
