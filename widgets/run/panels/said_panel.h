// What a person has said on a run, one row each, with a cross that takes it back.
#pragma once

#include <QWidget>

class QListWidget;

namespace handmap {

class SaidPanel : public QWidget {
  Q_OBJECT
 public:
  explicit SaidPanel(QWidget* parent = nullptr);

  void setRows(const QStringList& rows);
  int count() const;

 Q_SIGNALS:
  void takeBackWanted(int row);

 private:
  QWidget* rowOf(const QString& text, int row);

  QListWidget* rows_;
};

}  // namespace handmap
