// Five steps that show a newcomer where things are: a note beside each, with a frame around it.
#pragma once

#include <QFrame>
#include <QPointer>
#include <vector>

class QLabel;
class QPushButton;

namespace handmap {

class Tour : public QFrame {
  Q_OBJECT
 public:
  struct Step {
    QPointer<QWidget> target;  ///< of the same window
    QString title;
    QString text;
  };
  Tour(std::vector<Step> steps, QWidget& window);

  void begin();

 Q_SIGNALS:
  void ended();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void show(std::size_t step);
  void place();
  void end();

  std::vector<Step> steps_;
  std::size_t step_ = 0;
  QLabel* text_;
  QPushButton* back_;
  QPushButton* next_;
  QWidget* frame_;
};

}  // namespace handmap
