// The ways in, at the first start: a strip above the canvas, in nobody's way.
#pragma once

#include <QFrame>
#include <vector>

class QBoxLayout;
class QGridLayout;
class QPushButton;

namespace handmap {

class WelcomeStrip : public QFrame {
  Q_OBJECT
 public:
  explicit WelcomeStrip(QWidget* parent = nullptr);

 Q_SIGNALS:
  void drawRequested();
  void recordingRequested();
  void simulatorRequested();
  void robotRequested();
  void tourRequested();
  void demonstrationRequested();
  void closed();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  using Request = void (WelcomeStrip::*)();
  void addWay(const QString& icon_name, const QString& text, const QString& hint, Request request);

  QBoxLayout* lines_;  ///< text and buttons, beside or over one another
  QGridLayout* buttons_;
  std::vector<QPushButton*> ways_;  ///< that a first start may take
};

}  // namespace handmap
