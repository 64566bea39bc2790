// The messages over the lower edge of the canvas: the newest and what is still to be answered; the
// others behind a button. Never a dialog, and what lies below does not move.
#pragma once

#include <QFrame>
#include <QPointer>
#include <functional>

#include "widgets/messages/message.h"

class QToolButton;
class QVBoxLayout;

namespace handmap {

class MessageBar : public QFrame {
  Q_OBJECT
 public:
  using Kind = Message::Kind;

  /// Lies over `over`; without one it is a widget as any other.
  explicit MessageBar(QWidget* over = nullptr);

  /// What is only told goes by itself. In place of the message of the same topic, where there is
  /// one; without a topic, the same text again counts up. The reference is for the moment: the
  /// message is gone when it is closed.
  Message& show(Kind kind, const QString& text, const QString& hint = {},
                const QString& topic = {});
  /// A message that no other takes the place of and that stays until it is answered.
  Message& ask(const QString& text, const QString& hint = {}, const QString& topic = {});
  /// A button of the latest message.
  void addAction(const QString& text, std::function<void()> action);
  /// Takes away all but unanswered questions.
  void clear();

  /// Takes away what nobody needs to answer any more.
  void withdraw(const QString& topic);

  QList<Message*> messages() const;  ///< the newest first

 Q_SIGNALS:
  void shown(const QString& text);

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  Message& add(const QString& topic);
  void remove(Message& message);
  void keepBounded();
  void layOut();
  void place();

  QVBoxLayout* layout_;
  QToolButton* more_;
  QPointer<Message> latest_;
  bool all_shown_ = false;
};

}  // namespace handmap
