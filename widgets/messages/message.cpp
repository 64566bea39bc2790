#include "widgets/messages/message.h"

#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QTimer>
#include <QToolButton>
#include <utility>

namespace handmap {

namespace {

constexpr int kInfoStaysMs = 12'000;
constexpr int kWarningStaysMs = 40'000;
constexpr int kBesideWord = 8;  // pixels, in a button
constexpr int kMostBeside = 2;  // buttons beside the text

QStyle::StandardPixmap pictureOf(Message::Kind kind) {
  switch (kind) {
    case Message::Kind::Info:
      return QStyle::SP_MessageBoxInformation;
    case Message::Kind::Warning:
      return QStyle::SP_MessageBoxWarning;
    case Message::Kind::Error:
      return QStyle::SP_MessageBoxCritical;
  }
  return QStyle::SP_MessageBoxInformation;
}

QColor tintOf(Message::Kind kind) {
  switch (kind) {
    case Message::Kind::Info:
      return QColor(0, 114, 178);
    case Message::Kind::Warning:
      return QColor(230, 159, 0);
    case Message::Kind::Error:
      return QColor(204, 51, 17);
  }
  return {};
}

}  // namespace

Message::Message(QString topic, QWidget* parent)
    : QFrame(parent),
      topic_(std::move(topic)),
      icon_(new QLabel),
      picture_(new QLabel),
      text_(new QLabel),
      body_(new QBoxLayout(QBoxLayout::LeftToRight)),
      buttons_(new QHBoxLayout),
      timer_(new QTimer(this)) {
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Window);  // which is tinted, whatever it lies on
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(10, 4, 6, 4);
  picture_->hide();
  text_->setObjectName("message_text");
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::PlainText);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* close = new QToolButton;
  close->setObjectName("close");
  close->setIcon(style()->standardIcon(QStyle::SP_TitleBarCloseButton));
  close->setAutoRaise(true);
  close->setToolTip(tr("Close this message"));
  close->setAccessibleName(close->toolTip());
  layout->addWidget(icon_);
  layout->addWidget(picture_);
  buttons_->setSpacing(4);
  body_->addWidget(text_, 1);
  body_->addLayout(buttons_);
  body_->setAlignment(buttons_, Qt::AlignRight);
  layout->addLayout(body_, 1);
  layout->addWidget(close);
  connect(close, &QToolButton::clicked, this, [this] {
    Q_EMIT dismissed();
    Q_EMIT putOff();
  });
  timer_->setSingleShot(true);
  connect(timer_, &QTimer::timeout, this, &Message::dismissed);
}

QString Message::text() const { return text_->text(); }

void Message::setText(Kind kind, const QString& text, const QString& hint) {
  const QString plain = hint.isEmpty() ? text : text + QLatin1Char('\n') + hint;
  times_ = plain == plain_ ? times_ + 1 : 1;
  plain_ = plain;
  kind_ = kind;
  text_->setText(times_ == 1 ? plain : tr("%1 (%2 times)").arg(plain).arg(times_));
  icon_->setPixmap(style()->standardIcon(pictureOf(kind)).pixmap(18, 18));
  while (const QLayoutItem* item = buttons_->takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
  body_->setDirection(QBoxLayout::LeftToRight);
  applyColours();
  letGoInTime();
}

void Message::addAction(const QString& text, std::function<void()> action, Then then) {
  auto* button = new QPushButton(text);
  // Several are to stand in one row of a small window.
  button->setMaximumWidth(button->fontMetrics().horizontalAdvance(text) + 2 * kBesideWord);
  buttons_->addWidget(button);
  // Many leave the text no room beside them.
  if (buttons_->count() > kMostBeside) body_->setDirection(QBoxLayout::TopToBottom);
  connect(button, &QPushButton::clicked, this, [this, then, action = std::move(action)] {
    if (then == Then::Close) Q_EMIT dismissed();
    action();
  });
  letGoInTime();
  Q_EMIT resized();
}

void Message::setPicture(const QImage& picture) {
  picture_->setPixmap(QPixmap::fromImage(picture));
  picture_->setVisible(!picture.isNull());
  Q_EMIT resized();
}

void Message::setQuestion() {
  question_ = true;
  letGoInTime();
}

/// What can be read and no more goes by itself.
void Message::letGoInTime() {
  const bool only_told = kind_ != Kind::Error && !question_ && buttons_->count() == 0;
  if (!only_told) return timer_->stop();
  timer_->start(kind_ == Kind::Info ? kInfoStaysMs : kWarningStaysMs);
}

void Message::applyColours() {
  // A tint of the window's own colour keeps the text readable in light and dark.
  const QColor base = QGuiApplication::palette().window().color();
  const QColor tint = tintOf(kind_);
  const auto mixed = [](int a, int b) { return (3 * a + b) / 4; };
  QPalette tinted = QGuiApplication::palette();
  tinted.setColor(QPalette::Window,
                  QColor(mixed(base.red(), tint.red()), mixed(base.green(), tint.green()),
                         mixed(base.blue(), tint.blue())));
  setPalette(tinted);
}

void Message::changeEvent(QEvent* event) {
  if (event->type() == QEvent::ApplicationPaletteChange) applyColours();
  QFrame::changeEvent(event);
}

}  // namespace handmap
