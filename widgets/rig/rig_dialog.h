// Puts a rig together: what there is and where it is connected, tried on the spot.
#pragma once

#include <QDialog>
#include <QTimer>

#include "widgets/rig/rig_trial.h"

class QLabel;
class QPushButton;

namespace handmap {

class Dialogs;
class LivePanel;
class RigForm;
class RigPreviewView;

class RigDialog : public QDialog {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(RigDialog)
 public:
  /// Both must outlive it.
  RigDialog(Dialogs& dialogs, RigAccess access, QWidget* parent = nullptr);
  ~RigDialog() override;

  RigForm& form() { return *form_; }
  /// Reads a rig file; false: it cannot be read, and the person was told.
  bool open(const QString& path);
  using QDialog::open;
  bool save(const QString& path);
  /// Its devices are free again.
  void endTrial();

 public Q_SLOTS:
  void done(int result) override;

 Q_SIGNALS:
  /// The person wants to run with it.
  void chosen(const handmap::Rig& rig);
  void fileUsed(const QString& path);
  void calibrationWanted();

 private:
  QWidget* makeTrialSide();
  void makeButtons();
  void askToOpen();
  void askToSave();
  void comeBack();
  void toggleTrial();
  void look();
  void use();
  void tell(const QString& words);
  /// nullopt: it cannot be; the person was told.
  std::optional<Rig> enteredRig();

  Dialogs& dialogs_;
  RigAccess access_;
  RigTrial trial_;
  RigForm* form_;
  RigPreviewView* preview_;
  LivePanel* devices_;
  QPushButton* try_;
  QLabel* words_;
  QTimer looking_;
  bool trying_ = false;
  QString path_;
};

}  // namespace handmap
