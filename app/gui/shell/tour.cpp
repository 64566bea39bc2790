#include "app/gui/shell/tour.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace handmap {

namespace {

constexpr int kWidth = 340;
constexpr int kGap = 10;

/// Around what is spoken of; lets every click through.
class Frame : public QWidget {
 public:
  explicit Frame(QWidget* window) : QWidget(window) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 3.0));
    painter.drawRect(rect().adjusted(1, 1, -2, -2));
  }
};

}  // namespace

Tour::Tour(std::vector<Step> steps, QWidget& window)
    : QFrame(&window),
      steps_(std::move(steps)),
      text_(new QLabel),
      back_(new QPushButton(tr("Back"))),
      next_(new QPushButton(tr("Next"))),
      frame_(new Frame(&window)) {
  setObjectName(QStringLiteral("tour"));
  setAccessibleName(tr("Tour"));
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::RichText);
  auto* leave = new QPushButton(tr("End the tour"));
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(leave);
  buttons->addStretch();
  buttons->addWidget(back_);
  buttons->addWidget(next_);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(text_);
  layout->addLayout(buttons);
  back_->setObjectName(QStringLiteral("tour_back"));
  next_->setObjectName(QStringLiteral("tour_next"));
  next_->setDefault(true);
  connect(leave, &QPushButton::clicked, this, &Tour::end);
  connect(back_, &QPushButton::clicked, this, [this] { show(step_ - 1); });
  connect(next_, &QPushButton::clicked, this,
          [this] { step_ + 1 < steps_.size() ? show(step_ + 1) : end(); });
  window.installEventFilter(this);
  hide();
  frame_->hide();
}

void Tour::begin() { show(0); }

void Tour::show(std::size_t step) {
  step_ = step;
  const Step& now = steps_[step];
  text_->setText(
      QStringLiteral("<b>%1</b><br>%2")
          .arg(tr("%1 of %2: %3").arg(step + 1).arg(steps_.size()).arg(now.title), now.text));
  back_->setEnabled(step > 0);
  next_->setText(step + 1 < steps_.size() ? tr("Next") : tr("Done"));
  setVisible(true);
  place();
  next_->setFocus();
}

/// Beside the target where there is room, else over it.
void Tour::place() {
  const QWidget* window = parentWidget();
  const QWidget* target = steps_[step_].target;
  resize(kWidth, heightForWidth(kWidth) > 0 ? heightForWidth(kWidth) : sizeHint().height());
  QRect about(window->rect().center(), QSize(1, 1));
  const bool shown = target && target->isVisible();
  if (shown) about = {target->mapTo(window, QPoint()), target->size()};
  frame_->setVisible(shown);
  frame_->setGeometry(about.adjusted(-3, -3, 3, 3));
  frame_->raise();
  QPoint at = about.topLeft();
  if (about.right() + kGap + width() < window->width())
    at.setX(about.right() + kGap);
  else if (about.left() - kGap - width() > 0)
    at.setX(about.left() - kGap - width());
  else
    at = about.center() -
         QPoint(width() / 2, about.height() < height() ? height() + about.height() : height() / 2);
  move(std::clamp(at.x(), 0, std::max(0, window->width() - width())),
       std::clamp(at.y(), 0, std::max(0, window->height() - height())));
  raise();
}

void Tour::end() {
  hide();
  frame_->hide();
  Q_EMIT ended();
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize && isVisible()) place();
  return QFrame::eventFilter(watched, event);
}

void Tour::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) return end();
  QFrame::keyPressEvent(event);
}

}  // namespace handmap
