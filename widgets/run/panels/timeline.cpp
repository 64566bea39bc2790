#include "widgets/run/panels/timeline.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

namespace handmap {

namespace {

constexpr double kMarginPx = 8.0;
constexpr int kNearPx = 4;               // of a mark
constexpr double kHandlesBelowPx = 4.0;  // the middle of the strip
constexpr double kHandlePx = 8.0;        // of a handle, to either side

QColor colourOf(TimelineMark mark) {
  switch (mark) {
    case TimelineMark::Skipped:
      return {0xd0, 0x30, 0x30};
    case TimelineMark::Gap:
    case TimelineMark::Guessed:
      return {0xe0, 0x90, 0x10};
    case TimelineMark::Given:
      return {0x20, 0x90, 0x50};
    case TimelineMark::Bookmark:
      break;
  }
  return {0x30, 0x70, 0xd0};
}

}  // namespace

Timeline::Timeline(QWidget* parent) : QAbstractSlider(parent) {
  setOrientation(Qt::Horizontal);
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setMouseTracking(true);
  setAccessibleName(tr("Timeline"));
  setToolTip(tr("Click: look at that moment · Shift+drag: play this again and again"));
  setPageStep(20);
  clear();
}

QSize Timeline::sizeHint() const { return {400, fontMetrics().height() + 6}; }
QSize Timeline::minimumSizeHint() const { return {100, sizeHint().height()}; }

void Timeline::setExtent(int done, int count) {
  done_ = done;
  count_ = count;
  share_ = 0.0;
  setRange(0, this->count());
  setEnabled(done > 0 || trim_);
  update();
}

void Timeline::setShareOfStep(double share) {
  share_ = share;
  update();
}

void Timeline::setIndex(int index) {
  const QSignalBlocker silent(this);
  setValue(index);
  update();
}

void Timeline::clear() {
  std::erase_if(marks_, [](const Mark& mark) { return mark.mark != TimelineMark::Bookmark; });
  loop_.reset();
  loop_begin_.reset();
  setExtent(0, 0);
  setIndex(0);
}

void Timeline::addMark(int index, TimelineMark mark, const QString& text) {
  marks_.push_back({index, mark, text});
  update();
}

void Timeline::removeMarks(TimelineMark mark) {
  std::erase_if(marks_, [mark](const Mark& other) { return other.mark == mark; });
  update();
}

void Timeline::toggleBookmark(int index) {
  const auto removed = std::erase_if(marks_, [index](const Mark& mark) {
    return mark.mark == TimelineMark::Bookmark && mark.index == index;
  });
  if (removed == 0) addMark(index, TimelineMark::Bookmark, tr("Bookmark at %1").arg(index));
  update();
}

std::optional<int> Timeline::nextBookmark() const {
  std::set<int> places;
  for (const Mark& mark : marks_) {
    if (mark.mark == TimelineMark::Bookmark && mark.index <= done_) places.insert(mark.index);
  }
  if (places.empty()) return std::nullopt;
  const auto after = places.upper_bound(value());
  return after == places.end() ? *places.begin() : *after;
}

void Timeline::setLoop(std::optional<PlayRange> loop) {
  loop_ = loop;
  update();
}

double Timeline::xOf(double index) const {
  const auto [from, to] = ends();
  return from + index / std::max(count(), 1) * (to - from);
}

int Timeline::indexAt(double x) const {
  const auto [from, to] = ends();
  const double share = (x - from) / std::max(1.0, to - from);
  return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * count()));
}

void Timeline::setTrim(const std::optional<TimelineTrim>& trim) {
  const bool other = !trim || !shown_ || trim->first != shown_->first || trim->last != shown_->last;
  trim_ = trim;
  dragged_ = Handle::None;
  if (other || done_ == 0) shown_ = trim_;
  setEnabled(done_ > 0 || trim_);
  update();
}

void Timeline::beginTrimmed() {
  shown_ = trim_;
  update();
}

double Timeline::xOfFrame(int frame) const {
  const double share =
      trim_ ? static_cast<double>(frame - trim_->first) / (trim_->last - trim_->first) : 0.0;
  return kMarginPx + share * (width() - 2.0 * kMarginPx);
}

int Timeline::frameAt(double x) const {
  const double share = (x - kMarginPx) / std::max(1.0, width() - 2.0 * kMarginPx);
  return trim_->first +
         static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * (trim_->last - trim_->first)));
}

std::pair<double, double> Timeline::ends() const {
  if (trim_ && shown_) return {xOfFrame(shown_->from), xOfFrame(shown_->to)};
  return {kMarginPx, width() - kMarginPx};
}

/// Below the strip, so that the knob at its end is not in their way.
Timeline::Handle Timeline::handleAt(const QPointF& at) const {
  if (!trim_ || at.y() < 0.5 * height() + kHandlesBelowPx) return Handle::None;
  const double to_from = std::abs(at.x() - xOfFrame(trim_->from));
  const double to_to = std::abs(at.x() - xOfFrame(trim_->to));
  if (std::min(to_from, to_to) > kHandlePx) return Handle::None;
  return to_from < to_to ? Handle::From : Handle::To;
}

void Timeline::dragHandle(double x) {
  const int frame = frameAt(x);
  if (dragged_ == Handle::From) trim_->from = std::min(frame, trim_->to - 1);
  if (dragged_ == Handle::To) trim_->to = std::max(frame, trim_->from + 1);
  if (done_ == 0) shown_ = trim_;
  update();
}

void Timeline::paintHandles(QPainter& painter) const {
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette().color(QPalette::Text));
  const double top = 0.5 * height() + kHandlesBelowPx;
  for (const int frame : {trim_->from, trim_->to}) {
    const double x = xOfFrame(frame);
    painter.drawPolygon(QPolygonF(
        {QPointF(x, top), QPointF(x + 5.0, height() - 1.0), QPointF(x - 5.0, height() - 1.0)}));
  }
}

void Timeline::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double middle = 0.5 * height();
  const auto strip = [&](double from, double to, double half, const QColor& colour) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawRoundedRect(
        QRectF(QPointF(xOf(from), middle - half), QPointF(xOf(to), middle + half)), 2.0, 2.0);
  };
  QColor still_open = palette().color(QPalette::Text);
  still_open.setAlphaF(0.18F);
  QColor done = palette().color(QPalette::Highlight);
  strip(0, std::max(count(), 1), 3.0, still_open);
  if (loop_) {
    QColor band = done;
    band.setAlphaF(0.35F);
    strip(loop_->first, loop_->last, 0.5 * height() - 1.0, band);
  }
  if (trim_) paintHandles(painter);
  if (!isEnabled()) done = still_open;
  strip(0, std::min(done_ + share_, static_cast<double>(count())), 3.0, done);
  for (const Mark& mark : marks_) {
    if (mark.index > count()) continue;
    painter.setPen(QPen(colourOf(mark.mark), 2.0));
    painter.drawLine(QPointF(xOf(mark.index), 2.0), QPointF(xOf(mark.index), height() - 2.0));
  }
  if (done_ == 0) return;
  painter.setPen(QPen(palette().color(QPalette::Base), 1.5));
  painter.setBrush(hasFocus() ? palette().color(QPalette::Highlight)
                              : palette().color(QPalette::Text));
  painter.drawEllipse(QPointF(xOf(value()), middle), 6.0, 6.0);
}

void Timeline::toMouse(double x) {
  const int index = indexAt(x);
  if (index == value()) return;
  setIndex(index);
  Q_EMIT seekWanted(index);
}

void Timeline::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  dragged_ = handleAt(event->position());
  if (dragged_ != Handle::None || done_ == 0) return;
  if (event->modifiers() & Qt::ShiftModifier) {
    loop_begin_ = std::min(indexAt(event->position().x()), done_);
    return setLoop(std::nullopt);
  }
  setSliderDown(true);
  toMouse(event->position().x());
}

void Timeline::mouseMoveEvent(QMouseEvent* event) {
  if (dragged_ != Handle::None) {
    dragHandle(event->position().x());
  } else if (loop_begin_) {
    const int here = std::min(indexAt(event->position().x()), done_);
    setLoop(PlayRange{std::min(*loop_begin_, here), std::max(*loop_begin_, here)});
  } else if (isSliderDown()) {
    toMouse(event->position().x());
  }
}

void Timeline::mouseReleaseEvent(QMouseEvent* event) {
  setSliderDown(false);
  if (dragged_ != Handle::None) {
    dragHandle(event->position().x());
    dragged_ = Handle::None;
    Q_EMIT trimWanted(trim_->from, trim_->to);
    return;
  }
  if (!loop_begin_) return;
  mouseMoveEvent(event);
  loop_begin_.reset();
  if (loop_ && loop_->last - loop_->first < 2) loop_.reset();
  update();
  Q_EMIT loopWanted(loop_);
}

void Timeline::keyPressEvent(QKeyEvent* event) {
  const auto seek = [this](int index) {
    if (done_ > 0) Q_EMIT seekWanted(std::clamp(index, 1, done_));
  };
  switch (event->key()) {
    case Qt::Key_Left:
      return seek(value() - 1);
    case Qt::Key_Right:
      return seek(value() + 1);
    case Qt::Key_PageUp:
      return seek(value() - pageStep());
    case Qt::Key_PageDown:
      return seek(value() + pageStep());
    case Qt::Key_Home:
      return seek(1);
    case Qt::Key_End:
      return seek(done_);
    default:
      event->ignore();
  }
}

QString Timeline::textAt(int index) const {
  QStringList lines;
  for (const Mark& mark : marks_) {
    if (std::abs(xOf(mark.index) - xOf(index)) <= kNearPx && !lines.contains(mark.text)) {
      lines << mark.text;
    }
  }
  if (lines.isEmpty()) lines << tr("%1 of %2").arg(index).arg(count()) << toolTip();
  return lines.mid(0, 6).join(QLatin1Char('\n'));
}

bool Timeline::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QAbstractSlider::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const Handle handle = handleAt(help->pos());
  QString text = textAt(indexAt(help->pos().x()));
  if (handle == Handle::From)
    text = tr("The next run begins with frame %1 · drag it").arg(trim_->from);
  if (handle == Handle::To) text = tr("The next run ends with frame %1 · drag it").arg(trim_->to);
  QToolTip::showText(help->globalPos(), text, this);
  return true;
}

}  // namespace handmap
