#include "widgets/run/panels/transport_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolBar>
#include <QVBoxLayout>
#include <cmath>

#include "core/method/snapshot.h"
#include "widgets/run/panels/timeline.h"
#include "widgets/style/elided_label.h"

namespace handmap {

namespace {

struct Speed {
  double factor;
  const char* text;
};
constexpr Speed kSpeeds[] = {{0.1, "0.1\u00d7"}, {0.25, "0.25\u00d7"}, {0.5, "0.5\u00d7"},
                             {1.0, "1\u00d7"},   {2.0, "2\u00d7"},     {5.0, "5\u00d7"},
                             {10.0, "10\u00d7"}, {20.0, "20\u00d7"},   {0.0, "max"}};
constexpr int kUsual = 3;  // of kSpeeds

}  // namespace

TransportBar::TransportBar(QWidget* parent)
    : QWidget(parent),
      source_(new ElidedLabel),
      tool_bar_(new QToolBar),
      speed_(new QComboBox),
      timeline_(new Timeline),
      frame_(new QLabel) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(8, 2, 8, 2);
  rows->setSpacing(0);
  rows->addWidget(timeline_);
  auto* layout = new QHBoxLayout;
  rows->addLayout(layout);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  tool_bar_->setIconSize({20, 20});
  tool_bar_->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Preferred);
  for (const Speed& speed : kSpeeds) speed_->addItem(QString::fromUtf8(speed.text), speed.factor);
  speed_->setCurrentIndex(kUsual);
  speed_->setAccessibleName(tr("Speed"));
  speed_->setToolTip(tr("Speed: times the clock of the recording"));
  source_->setMinimumWidth(fontMetrics().horizontalAdvance("No robot"));
  frame_->setMinimumWidth(fontMetrics().horizontalAdvance("000 / 000 \u00b7 000.0 s"));
  layout->addWidget(tool_bar_);
  layout->addWidget(speed_);
  layout->addSpacing(8);
  layout->addWidget(source_);
  layout->addStretch(1);
  layout->addWidget(frame_);
  connect(speed_, &QComboBox::currentIndexChanged, this, [this] { Q_EMIT speedChanged(speed()); });
  setSource({});
  clearProgress();
}

double TransportBar::speed() const { return speed_->currentData().toDouble(); }

void TransportBar::setSpeed(double speed) {
  int best = speed_->count() - 1;  // fastest
  for (int i = 0; speed > 0.0 && i < speed_->count() - 1; ++i) {
    if (std::abs(speed_->itemData(i).toDouble() - speed) <
        std::abs(speed_->itemData(best).toDouble() - speed)) {
      best = i;
    }
  }
  speed_->setCurrentIndex(best);
}

void TransportBar::setSource(const QString& name) {
  source_->setText(name.isEmpty() ? tr("No robot yet") : name);
  source_->setToolTip(tr("Where the observations come from") + QLatin1Char('\n') + name);
}

void TransportBar::setExtent(int done, int count) { timeline_->setExtent(done, count); }

void TransportBar::setShown(int index, int count, const FrameReport& report) {
  timeline_->setIndex(index);
  const QString how_far = count > 0 ? tr("%1 / %2").arg(index).arg(count) : tr("%1").arg(index);
  frame_->setText(tr("%1 \u00b7 %2 s").arg(how_far).arg(report.time_s, 0, 'f', 1));
}

void TransportBar::setPhase(int index, int count, const QString& phase) {
  const QString how_far = count > 0 ? tr("%1 / %2").arg(index).arg(count) : tr("%1").arg(index);
  frame_->setText(tr("%1 \u00b7 %2").arg(how_far, phase));
}

void TransportBar::setSpeedEnabled(bool enabled) { speed_->setEnabled(enabled); }

void TransportBar::setShareOfStep(double share) {
  timeline_->setShareOfStep(share);
  if (timeline_->done() > 0) return;
  opening_.update(share, steadySeconds());
  frame_->setText(tr("%1 %%2").arg(static_cast<int>(100.0 * share)).arg(opening_.inWords()));
}

void TransportBar::clearProgress() {
  timeline_->clear();
  opening_.begin();
  frame_->setText(QStringLiteral("\u2013"));
}

}  // namespace handmap
