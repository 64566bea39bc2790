// The ways in, at the first start: a strip above the canvas, in nobody's way.
#pragma once

#include <QFrame>

namespace handmap {

class WelcomeStrip : public QFrame {
  Q_OBJECT
 public:
  explicit WelcomeStrip(QWidget* parent = nullptr);

 Q_SIGNALS:
  void drawRequested();
  void recordingRequested();
  void simulatorRequested();
  void demonstrationRequested();
  void closed();

 private:
  using Request = void (WelcomeStrip::*)();
  void addWay(const QString& icon_name, const QString& text, const QString& hint, Request request);
};

}  // namespace handmap
