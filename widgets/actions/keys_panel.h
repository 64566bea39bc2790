// The sheet of all commands and their keys, where the keys can be changed.
#pragma once

#include <QWidget>

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace handmap {

class ActionSet;

class KeysPanel : public QWidget {
  Q_OBJECT
 public:
  explicit KeysPanel(const ActionSet& actions, QWidget* parent = nullptr);

 Q_SIGNALS:
  void keysChanged();

 private:
  void fill();
  void showKeys();
  void filter(const QString& text);
  QString chosen() const;  ///< id; empty: none
  void choose();
  void apply(bool take_from_others);
  void reset(bool all);

  const ActionSet& actions_;
  QTreeWidget* tree_;
  QLineEdit* search_;
  QKeySequenceEdit* edit_;
  QPushButton* usual_;
  QPushButton* all_usual_;
  QLabel* clash_;
  QPushButton* take_;
};

}  // namespace handmap
