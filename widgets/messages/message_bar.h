// The messages above the canvas, the newest on top. Never a dialog.
#pragma once

#include <QPointer>
#include <QWidget>
#include <functional>

#include "widgets/messages/message.h"

class QVBoxLayout;

namespace handmap {

class MessageBar : public QWidget {
  Q_OBJECT
 public:
  using Kind = Message::Kind;

  explicit MessageBar(QWidget* parent = nullptr);

  /// Infos go by themselves, unless they have a button. In place of the message of the same topic,
  /// where there is one; without a topic, the same text again counts up. The reference is for the
  /// moment: the message is gone when it is closed.
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

 private:
  Message& add(const QString& topic);
  void remove(Message& message);
  void keepBounded();

  QVBoxLayout* layout_;
  QPointer<Message> latest_;
};

}  // namespace handmap
