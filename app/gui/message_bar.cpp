#include "app/gui/message_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QTimer>
#include <QToolButton>

namespace handmap {

namespace {

constexpr int kInfoStaysMs = 12'000;

QStyle::StandardPixmap pictureOf(MessageBar::Kind kind) {
  switch (kind) {
    case MessageBar::Kind::Info:
      return QStyle::SP_MessageBoxInformation;
    case MessageBar::Kind::Warning:
      return QStyle::SP_MessageBoxWarning;
    case MessageBar::Kind::Error:
      return QStyle::SP_MessageBoxCritical;
  }
  return QStyle::SP_MessageBoxInformation;
}

QColor tintOf(MessageBar::Kind kind) {
  switch (kind) {
    case MessageBar::Kind::Info:
      return QColor(0, 114, 178);
    case MessageBar::Kind::Warning:
      return QColor(230, 159, 0);
    case MessageBar::Kind::Error:
      return QColor(204, 51, 17);
  }
  return {};
}

}  // namespace

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent), icon_(new QLabel), text_(new QLabel), timer_(new QTimer(this)) {
  setAutoFillBackground(true);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(10, 4, 6, 4);
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::PlainText);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  buttons_ = new QHBoxLayout;
  auto* close = new QToolButton;
  close->setIcon(style()->standardIcon(QStyle::SP_TitleBarCloseButton));
  close->setAutoRaise(true);
  close->setToolTip(tr("Close this message"));
  layout->addWidget(icon_);
  layout->addWidget(text_, 1);
  layout->addLayout(buttons_);
  layout->addWidget(close);
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  timer_->setSingleShot(true);
  timer_->setInterval(kInfoStaysMs);
  connect(timer_, &QTimer::timeout, this, &QWidget::hide);
  hide();
}

void MessageBar::show(Kind kind, const QString& message, const QString& hint) {
  kind_ = kind;
  text_->setText(hint.isEmpty() ? message : message + QLatin1Char('\n') + hint);
  while (const QLayoutItem* item = buttons_->takeAt(0)) {
    item->widget()->deleteLater();
    delete item;
  }
  icon_->setPixmap(style()->standardIcon(pictureOf(kind)).pixmap(18, 18));
  applyColours();
  kind == Kind::Info ? timer_->start() : timer_->stop();
  setVisible(true);
}

void MessageBar::addAction(const QString& text, std::function<void()> action) {
  auto* button = new QPushButton(text);
  buttons_->addWidget(button);
  connect(button, &QPushButton::clicked, this, [this, action = std::move(action)] {
    hide();
    action();
  });
  timer_->stop();
}

void MessageBar::applyColours() {
  // A tint of the window's own colour keeps the text readable in light and dark.
  const QColor base = parentWidget() != nullptr ? parentWidget()->palette().window().color()
                                                : palette().window().color();
  const QColor tint = tintOf(kind_);
  const auto mixed = [](int a, int b) { return (3 * a + b) / 4; };
  QPalette tinted = palette();
  tinted.setColor(QPalette::Window,
                  QColor(mixed(base.red(), tint.red()), mixed(base.green(), tint.green()),
                         mixed(base.blue(), tint.blue())));
  setPalette(tinted);
}

void MessageBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::ParentChange) applyColours();
  QFrame::changeEvent(event);
}

}  // namespace handmap
