// Makes sure that a log is read as it is meant: what it holds in words, its first scan in a
// picture.
#pragma once

#include <QDialog>
#include <memory>

#include "core/logs/log.h"
#include "widgets/background/background.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace handmap {

class RigPreviewView;

class ImportDialog : public QDialog {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(ImportDialog)
 public:
  explicit ImportDialog(const QStringList& files, QWidget* parent = nullptr);
  ~ImportDialog() override;

  /// As it is read now; nullptr before that, and where it cannot be.
  const std::shared_ptr<const Log>& log() const { return log_; }
  /// Reads it together with those that there are.
  void add(const QString& file);

 Q_SIGNALS:
  /// Such as the poses that belong to the scans.
  void anotherFileWanted();

 private:
  void addFields();
  QLineEdit& fieldOf(const std::string& option) const;
  QStringList typed() const;
  LogOptions options() const;
  void read();
  void show(const std::shared_ptr<const Log>& log);
  void ask(const QString& message, const QString& hint);

  QStringList files_;
  QStringList typed_;  ///< that it is read with
  std::shared_ptr<const Log> log_;
  int request_ = 0;  ///< an answer to another one is dropped
  RigPreviewView* preview_;
  QLabel* words_;
  QComboBox* metres_;
  QComboBox* seconds_;
  QComboBox* radians_;
  QLineEdit* angles_;
  QLineEdit* rate_;
  QLineEdit* columns_;
  QLineEdit* sensor_;
  QPushButton* import_;
  std::shared_ptr<Lifeline<ImportDialog>> self_;  ///< shared with the threads that read
};

}  // namespace handmap
