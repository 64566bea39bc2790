#include "widgets/run/overlays/run_strip.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/run/words/words.h"
#include "widgets/style/elided_label.h"

namespace handmap {

namespace {

constexpr int kMargin = 10;
constexpr int kBesideRuler = 44;  // the lower edge is that of what the tools offer
constexpr int kBelowRuler = 26;

/// Never colour alone: full, half and empty.
QString signOf(Certainty certainty) {
  switch (certainty) {
    case Certainty::Sure:
      return QStringLiteral("●");
    case Certainty::Rough:
      return QStringLiteral("◐");
    case Certainty::Lost:
      break;
  }
  return QStringLiteral("○");
}

}  // namespace

RunStrip::RunStrip(QWidget& over)
    : QFrame(&over),
      certainty_(new ElidedLabel),
      place_(new ElidedLabel),
      follow_(new QToolButton),
      phase_(new QLabel) {
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  certainty_->setToolTip(tr("How far off the shown place is at most, nine times of ten"));
  place_->setToolTip(tr("Where the robot is"));
  place_->setMinimumWidth(1);  // how sure it is comes first
  follow_->setAutoRaise(true);
  follow_->setToolTip(tr("Whether the view follows the robot: off, follow, follow and turn"));
  follow_->setFocusPolicy(Qt::TabFocus);
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(8, 2, 4, 2);
  rows->setSpacing(0);
  rows->setSizeConstraint(QLayout::SetNoConstraint);  // on a narrow canvas it is narrower
  auto* layout = new QHBoxLayout;
  rows->addLayout(layout);
  layout->addWidget(certainty_);
  layout->addWidget(place_);
  layout->addWidget(follow_);
  phase_->setWordWrap(true);
  phase_->setContentsMargins(0, 0, 8, 3);
  rows->addWidget(phase_);
  connect(follow_, &QToolButton::clicked, this, &RunStrip::followRequested);
  over.installEventFilter(this);
  phase_->hide();
  setMode(FollowRobot::Mode::Off);
  applyPalette();
  showNothing();
}

void RunStrip::show(const FrameReport& report, const Map& map) {
  const Certainty kind = certaintyOf(report).kind;
  QFont font = certainty_->font();
  font.setBold(kind == Certainty::Lost);
  certainty_->setFont(font);
  certainty_->setText(signOf(kind) + QLatin1Char(' ') + Words::certainty(report));
  place_->setText(QStringLiteral(" · ") + Words::place(report.pose, map));
  setAccessibleName(words());
  setVisible(true);
  place();
}

void RunStrip::showPhase(const QString& text) {
  if (phase_->text() == text) return;
  phase_->setText(text);
  phase_->setVisible(!text.isEmpty());
  setAccessibleName(words());
  place();
}

void RunStrip::showNothing() {
  certainty_->clear();
  place_->clear();
  showPhase({});
  hide();
}

QString RunStrip::words() const {
  const QString line = certainty_->text() + place_->text();
  return phase_->text().isEmpty() ? line : line + QLatin1Char('\n') + phase_->text();
}

void RunStrip::setMode(FollowRobot::Mode mode) {
  switch (mode) {
    case FollowRobot::Mode::Off:
      follow_->setText(tr("Follow: off"));
      break;
    case FollowRobot::Mode::Follow:
      follow_->setText(tr("Follow: on"));
      break;
    case FollowRobot::Mode::FollowAndTurn:
      follow_->setText(tr("Follow: and turn"));
      break;
  }
  QFont font = follow_->font();
  font.setBold(mode != FollowRobot::Mode::Off);
  follow_->setFont(font);
  place();
}

void RunStrip::place() {
  layout()->activate();  // else a layout within another one goes by the texts before
  const QSize room = parentWidget()->size() - QSize(kBesideRuler + kMargin, kBelowRuler + kMargin);
  setGeometry(QRect(QPoint(kBesideRuler, kBelowRuler), sizeHint().boundedTo(room)));
  raise();
}

bool RunStrip::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) place();
  return QFrame::eventFilter(watched, event);
}

void RunStrip::applyPalette() {
  QPalette colours = parentWidget()->palette();
  QColor ground = colours.color(QPalette::Base);
  ground.setAlpha(225);
  colours.setColor(QPalette::Window, ground);
  if (colours != palette()) setPalette(colours);
}

void RunStrip::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::ParentChange || event->type() == QEvent::StyleChange) applyPalette();
}

}  // namespace handmap
