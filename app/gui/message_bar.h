// One message above the canvas, with what can be done about it. Never a dialog.
#pragma once

#include <QFrame>
#include <functional>

class QHBoxLayout;
class QLabel;
class QTimer;
class QToolButton;

namespace handmap {

class MessageBar : public QFrame {
  Q_OBJECT
 public:
  enum class Kind { Info, Warning, Error };

  explicit MessageBar(QWidget* parent = nullptr);

  /// In place of what was shown. Infos go by themselves, unless they have an action.
  void show(Kind kind, const QString& message, const QString& hint = {});
  /// Adds a button to the message that is shown; it closes the message.
  void addAction(const QString& text, std::function<void()> action);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void applyColours();

  Kind kind_ = Kind::Info;
  QLabel* icon_;
  QLabel* text_;
  QHBoxLayout* buttons_;
  QTimer* timer_;
};

}  // namespace handmap
