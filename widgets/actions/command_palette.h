// Every command by a few letters of its name: typed, chosen, done.
#pragma once

#include <QFrame>
#include <QPointer>

class QLineEdit;
class QListWidget;
class QListWidgetItem;

namespace handmap {

class ActionSet;

/// Lies over the window, at its top; goes when something else gets the focus.
class CommandPalette : public QFrame {
  Q_OBJECT
 public:
  CommandPalette(const ActionSet& actions, QWidget& window);

  void open();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fill();
  void run(const QListWidgetItem* item);
  void close();

  const ActionSet& actions_;
  QLineEdit* typed_;
  QListWidget* list_;
  QPointer<QWidget> focus_before_;
};

}  // namespace handmap
