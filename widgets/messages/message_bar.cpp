#include "widgets/messages/message_bar.h"

#include <QApplication>
#include <QEvent>
#include <QToolButton>
#include <QVBoxLayout>

namespace handmap {

namespace {
constexpr qsizetype kMostMessages = 8;
constexpr int kWidest = 760;     // pixels: longer lines are hard to read
constexpr int kBesideEdge = 10;  // pixels
constexpr int kAboveEdge = 52;   // pixels: what the tools offer and the scale are below
}  // namespace

MessageBar::MessageBar(QWidget* over)
    : QFrame(over), layout_(new QVBoxLayout), more_(new QToolButton) {
  setAttribute(Qt::WA_NoMousePropagation);  // a click on a message is none on the map
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Window);  // the canvas below has another
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  layout_->setSpacing(1);
  rows->addLayout(layout_);
  rows->addWidget(more_, 0, Qt::AlignRight);
  more_->setObjectName("more_messages");
  more_->setAutoRaise(true);
  more_->setFocusPolicy(Qt::NoFocus);
  connect(more_, &QToolButton::clicked, this, [this] {
    all_shown_ = !all_shown_;
    layOut();
  });
  if (over != nullptr) over->installEventFilter(this);
  layOut();
}

Message& MessageBar::show(Kind kind, const QString& text, const QString& hint,
                          const QString& topic) {
  Message& message = add(topic.isEmpty() ? text : topic);
  message.setText(kind, text, hint);
  layOut();
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

/// The newest is on top, also where one of its topic was further down.
Message& MessageBar::add(const QString& topic) {
  for (Message* message : messages()) {
    if (message->topic() != topic) continue;
    layout_->removeWidget(message);
    layout_->insertWidget(0, message);
    latest_ = message;
    return *message;
  }
  auto* message = new Message(topic);
  connect(message, &Message::dismissed, this, [this, message] { remove(*message); });
  connect(message, &Message::resized, this, &MessageBar::place);
  layout_->insertWidget(0, message);
  latest_ = message;
  keepBounded();
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
  // Back to what it lies on, not on to whatever comes next.
  if (parentWidget() != nullptr && message.isAncestorOf(QApplication::focusWidget()))
    parentWidget()->setFocus();
  layout_->removeWidget(&message);
  message.setParent(nullptr);  // found no more, though the slot of its button may still work
  message.deleteLater();
  layOut();
}

void MessageBar::layOut() {
  const QList<Message*> all = messages();
  int behind = 0;
  for (qsizetype i = 0; i < all.size(); ++i) {
    const bool first = i == 0 || all[i]->isQuestion();
    all[i]->setVisible(first || all_shown_);
    if (!first) ++behind;
  }
  if (behind == 0) all_shown_ = false;
  more_->setVisible(behind > 0);
  more_->setText(all_shown_ ? tr("Only the newest") : tr("%n earlier message(s)", nullptr, behind));
  more_->setAccessibleName(more_->text());
  setVisible(!all.isEmpty());
  place();
}

void MessageBar::place() {
  if (parentWidget() == nullptr || isHidden()) return;
  const QSize room = parentWidget()->size();
  const int width = std::min(kWidest, room.width() - 2 * kBesideEdge);
  layout()->activate();
  const int wanted =
      layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width) : sizeHint().height();
  const int height = std::min(wanted, room.height() - kAboveEdge);
  setGeometry((room.width() - width) / 2, room.height() - kAboveEdge - height, width, height);
  raise();
}

/// What is in a message now may need more lines.
bool MessageBar::event(QEvent* event) {
  const bool known = QFrame::event(event);
  if (event->type() == QEvent::LayoutRequest) place();
  return known;
}

bool MessageBar::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) place();
  return QFrame::eventFilter(watched, event);
}

}  // namespace handmap
