#include "widgets/run/panels/plot.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QKeyEvent>
#include <QLegend>
#include <QLineSeries>
#include <QMouseEvent>
#include <QPainter>
#include <QValueAxis>
#include <algorithm>
#include <cmath>

#include "widgets/style/colours.h"

namespace handmap {

namespace {

constexpr int kLeastWidth = 180;
constexpr int kHeight = 120;
constexpr double kStepsAcross = 100.0;  // of the arrow keys

}  // namespace

double niceTop(double value) {
  if (!(value > 0.0)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (value <= factor * power) return factor * power;
  }
  return 10.0 * power;
}

Plot::Plot(const QString& title, QWidget* parent)
    : QChartView(parent), chart_(new QChart), times_(new QValueAxis), values_(new QValueAxis) {
  setChart(chart_);
  chart_->setMargins(QMargins(0, 0, 6, 0));
  chart_->layout()->setContentsMargins(0, 0, 0, 0);
  chart_->setBackgroundRoundness(0.0);
  chart_->legend()->hide();
  times_->setLabelFormat(QStringLiteral("%.0f s"));
  times_->setTickCount(3);
  values_->setLabelFormat(QStringLiteral("%g"));
  values_->setTickCount(3);
  chart_->addAxis(times_, Qt::AlignBottom);
  chart_->addAxis(values_, Qt::AlignLeft);
  setRenderHint(QPainter::Antialiasing);
  setFrameShape(QFrame::NoFrame);
  setMinimumWidth(kLeastWidth);
  setFixedHeight(kHeight);
  setFocusPolicy(Qt::TabFocus);
  setToolTip(tr("Click, or press the left and right keys, to look at another moment"));
  setTitle(title);
  applyPalette();
}

void Plot::setTitle(const QString& title) {
  chart_->setTitle(title);
  setAccessibleName(title);
}

void Plot::add(QAbstractSeries* series) {
  chart_->addSeries(series);
  series->attachAxis(times_);
  series->attachAxis(values_);
}

QLineSeries* Plot::addLine() {
  auto* line = new QLineSeries;
  add(line);
  return line;
}

void Plot::setRanges(double first_s, double last_s, double greatest, double least) {
  times_->setRange(first_s, std::max(last_s, first_s + 1.0));
  values_->setRange(least < 0.0 ? -niceTop(-least) : 0.0, niceTop(greatest));
}

void Plot::setCursor(std::optional<double> time_s) {
  cursor_s_ = time_s;
  viewport()->update();
}

void Plot::drawForeground(QPainter* painter, const QRectF&) {
  if (!cursor_s_ || *cursor_s_ < times_->min() || *cursor_s_ > times_->max()) return;
  const QRectF area = chart_->plotArea();
  const double share = (*cursor_s_ - times_->min()) / (times_->max() - times_->min());
  const double x = chart_->mapToScene(area.topLeft()).x() + share * area.width();
  painter->setPen(QPen(Colours::of(palette())[Role::Selection], 1.5));
  painter->drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
}

void Plot::choose(QPointF position) {
  const QPointF value = chart_->mapToValue(chart_->mapFromScene(mapToScene(position.toPoint())));
  Q_EMIT timeChosen(std::clamp(value.x(), times_->min(), times_->max()));
}

void Plot::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) choose(event->position());
  QChartView::mousePressEvent(event);
}

void Plot::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) choose(event->position());
}

void Plot::keyPressEvent(QKeyEvent* event) {
  const int direction = event->key() == Qt::Key_Left ? -1 : event->key() == Qt::Key_Right ? 1 : 0;
  if (direction == 0) return QChartView::keyPressEvent(event);
  const double step = (times_->max() - times_->min()) / kStepsAcross;
  const double from = cursor_s_.value_or(times_->max());
  Q_EMIT timeChosen(std::clamp(from + direction * step, times_->min(), times_->max()));
}

void Plot::applyPalette() {
  const QColor text = palette().color(QPalette::Text);
  QColor grid = text;
  grid.setAlpha(40);
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * 0.85);
  chart_->setBackgroundBrush(palette().base());
  chart_->setTitleBrush(text);
  chart_->setTitleFont(small);
  for (QValueAxis* axis : {times_, values_}) {
    axis->setLabelsColor(text);
    axis->setLabelsFont(small);
    axis->setGridLineColor(grid);
    axis->setLinePenColor(grid);
  }
}

}  // namespace handmap
