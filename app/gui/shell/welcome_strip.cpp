#include "app/gui/shell/welcome_strip.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>

#include "widgets/style/icons.h"

namespace handmap {

WelcomeStrip::WelcomeStrip(QWidget* parent)
    : QFrame(parent), lines_(new QBoxLayout(QBoxLayout::LeftToRight)), buttons_(new QGridLayout) {
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Base);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(12, 6, 6, 6);
  layout->addLayout(lines_, 1);
  auto* text = new QLabel(tr(
      "<b>Draw the map you remember</b>; Handmap finds the robot on it and corrects the drawing."));
  text->setWordWrap(true);
  lines_->addWidget(text, 1);
  lines_->addLayout(buttons_);
  addWay("run", tr("Demonstration"), tr("Watch a simulated robot correct a drawing"),
         &WelcomeStrip::demonstrationRequested);
  addWay("rectangle", tr("Draw"), tr("Start with an empty drawing"), &WelcomeStrip::drawRequested);
  addWay("record", tr("Open recording"), tr("What a real robot has seen"),
         &WelcomeStrip::recordingRequested);
  addWay("robot", tr("Simulator"), tr("A robot among buildings that you have a sketch of"),
         &WelcomeStrip::simulatorRequested);
  addWay("start", tr("Robot"), tr("Connect a live robot: camera or scanner, head, wheels"),
         &WelcomeStrip::robotRequested);
  addWay("select", tr("Tour"), tr("Where things are, in five steps"), &WelcomeStrip::tourRequested);
  auto* close = new QToolButton;
  close->setIcon(style()->standardIcon(QStyle::SP_TitleBarCloseButton));
  close->setAutoRaise(true);
  close->setToolTip(tr("Do not show this again"));
  connect(close, &QToolButton::clicked, this, [this] {
    hide();
    Q_EMIT closed();
  });
  layout->addWidget(close, 0, Qt::AlignTop);
}

/// Beside the text, below it, or in two rows below it: no button is cut off.
void WelcomeStrip::resizeEvent(QResizeEvent* event) {
  constexpr int kLeastText = 300;
  constexpr int kClose = 60;  // the button that closes it, and margins
  int row = 0;
  for (const QPushButton* way : ways_) row += way->sizeHint().width() + buttons_->spacing();
  lines_->setDirection(width() >= row + kLeastText ? QBoxLayout::LeftToRight
                                                   : QBoxLayout::TopToBottom);
  const int count = static_cast<int>(ways_.size());
  const int columns = width() >= row + kClose ? count : (count + 1) / 2;
  for (int i = 0; i < count; ++i) {
    buttons_->removeWidget(ways_[static_cast<std::size_t>(i)]);
    buttons_->addWidget(ways_[static_cast<std::size_t>(i)], i / columns, i % columns);
  }
  QFrame::resizeEvent(event);
}

void WelcomeStrip::addWay(const QString& icon_name, const QString& text, const QString& hint,
                          Request request) {
  auto* button = new QPushButton(icon(icon_name), text);
  button->setToolTip(hint);
  connect(button, &QPushButton::clicked, this, [this, request] { Q_EMIT(this->*request)(); });
  buttons_->addWidget(button, 0, static_cast<int>(ways_.size()));
  ways_.push_back(button);
}

}  // namespace handmap
