#include "widgets/canvas/canvas_chips.h"

#include <QHBoxLayout>
#include <QToolButton>

#include "widgets/canvas/tool.h"

namespace handmap {

namespace {

constexpr int kMargin = 10;
constexpr int kFingerPx = 32;

}  // namespace

CanvasChips::CanvasChips(QWidget* canvas) : QWidget(canvas) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  snap_ = add("snap_chip", QString(), tr("What points snap to: click for the next"));
  back_ = add("back_chip", tr("Back"), tr("Take the last point back (Backspace)"));
  cancel_ = add("cancel_chip", tr("Cancel"), tr("Drop what is begun (Esc)"));
  done_ = add("done_chip", tr("Done"), tr("Finish what is drawn (Enter)"));
  connect(snap_, &QToolButton::clicked, this, &CanvasChips::snapRequested);
  connect(back_, &QToolButton::clicked, this, &CanvasChips::backRequested);
  connect(cancel_, &QToolButton::clicked, this, &CanvasChips::cancelRequested);
  connect(done_, &QToolButton::clicked, this, &CanvasChips::doneRequested);
}

QToolButton* CanvasChips::add(const char* name, const QString& text, const QString& tip) {
  auto* chip = new QToolButton;
  chip->setObjectName(QLatin1String(name));
  chip->setText(text);
  chip->setToolTip(tip);
  chip->setAccessibleName(text);
  chip->setAccessibleDescription(tip);
  chip->setMinimumHeight(kFingerPx);
  chip->setAutoFillBackground(true);
  chip->setFocusPolicy(Qt::NoFocus);  // each has its key on the canvas
  layout()->addWidget(chip);
  return chip;
}

void CanvasChips::show(const Tool& tool) {
  back_->setVisible(tool.canTakeBack());
  cancel_->setVisible(tool.isBusy());
  done_->setVisible(tool.canFinish());
  place();
}

void CanvasChips::setSnapText(const QString& text) {
  snap_->setText(text);
  snap_->setAccessibleName(text);
  place();
}

void CanvasChips::place() {
  adjustSize();
  move(kMargin, parentWidget()->height() - height() - kMargin);
}

}  // namespace handmap
