// Buttons that lie on the canvas: what a finger needs to finish, and how points snap.
#pragma once

#include <QWidget>

class QToolButton;

namespace handmap {

class Tool;

class CanvasChips : public QWidget {
  Q_OBJECT
 public:
  explicit CanvasChips(QWidget* canvas);

  void show(const Tool& tool);  ///< what can be done now
  void setSnapText(const QString& text);
  void place();  ///< at the lower edge of the canvas

 Q_SIGNALS:
  void doneRequested();
  void backRequested();
  void cancelRequested();
  void snapRequested();

 private:
  QToolButton* add(const char* name, const QString& text, const QString& tip);

  QToolButton* snap_;
  QToolButton* back_;
  QToolButton* cancel_;
  QToolButton* done_;
};

}  // namespace handmap
