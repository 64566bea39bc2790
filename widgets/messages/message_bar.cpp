#include "widgets/messages/message_bar.h"

#include <QVBoxLayout>

namespace handmap {

namespace {
constexpr qsizetype kMostMessages = 4;
}

MessageBar::MessageBar(QWidget* parent) : QWidget(parent), layout_(new QVBoxLayout(this)) {
  layout_->setContentsMargins(0, 0, 0, 0);
  layout_->setSpacing(1);
  hide();
}

Message& MessageBar::show(Kind kind, const QString& text, const QString& hint,
                          const QString& topic) {
  Message& message = add(topic.isEmpty() ? text : topic);
  message.setText(kind, text, hint);
  Q_EMIT shown(text);
  return message;
}

Message& MessageBar::ask(const QString& text, const QString& hint, const QString& topic) {
  Message& message = show(Kind::Info, text, hint, topic);
  message.setQuestion();
  return message;
}

void MessageBar::addAction(const QString& text, std::function<void()> action) {
  if (latest_) latest_->addAction(text, std::move(action));
}

void MessageBar::clear() {
  for (Message* message : messages()) {
    if (!message->isQuestion()) remove(*message);
  }
}

void MessageBar::withdraw(const QString& topic) {
  for (Message* message : messages()) {
    if (message->topic() == topic) remove(*message);
  }
}

QList<Message*> MessageBar::messages() const {
  QList<Message*> messages;
  for (int i = 0; i < layout_->count(); ++i) {
    messages << static_cast<Message*>(layout_->itemAt(i)->widget());
  }
  return messages;
}

Message& MessageBar::add(const QString& topic) {
  for (Message* message : messages()) {
    if (message->topic() != topic) continue;
    latest_ = message;
    return *message;
  }
  auto* message = new Message(topic);
  connect(message, &Message::dismissed, this, [this, message] { remove(*message); });
  layout_->insertWidget(0, message);
  latest_ = message;
  keepBounded();
  setVisible(true);
  return *message;
}

void MessageBar::keepBounded() {
  const QList<Message*> all = messages();
  qsizetype too_many = all.size() - kMostMessages;
  for (qsizetype i = all.size() - 1; i > 0 && too_many > 0; --i) {
    if (all[i]->isQuestion()) continue;
    remove(*all[i]);
    --too_many;
  }
}

void MessageBar::remove(Message& message) {
  layout_->removeWidget(&message);
  message.setParent(nullptr);  // found no more, though the slot of its button may still work
  message.deleteLater();
  setVisible(layout_->count() > 0);
}

}  // namespace handmap
