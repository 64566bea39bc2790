#include "widgets/run/charts_panel.h"

#include <QAreaSeries>
#include <QChart>
#include <QChartView>
#include <QEvent>
#include <QGraphicsLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLegend>
#include <QLineSeries>
#include <QPainter>
#include <QVBoxLayout>
#include <QValueAxis>
#include <algorithm>
#include <cmath>

#include "widgets/style/colours.h"

namespace handmap {

namespace {

struct Stage {
  const char* name;
  double StageTimes::*ms;
  Qt::BrushStyle pattern;  ///< never colour alone
};

constexpr std::array<Stage, 5> kStageSpecs = {{
    {QT_TRANSLATE_NOOP("handmap::ChartsPanel", "read"), &StageTimes::read, Qt::Dense6Pattern},
    {QT_TRANSLATE_NOOP("handmap::ChartsPanel", "stereo"), &StageTimes::stereo, Qt::BDiagPattern},
    {QT_TRANSLATE_NOOP("handmap::ChartsPanel", "classify"), &StageTimes::classify,
     Qt::Dense4Pattern},
    {QT_TRANSLATE_NOOP("handmap::ChartsPanel", "local map"), &StageTimes::local_map,
     Qt::FDiagPattern},
    {QT_TRANSLATE_NOOP("handmap::ChartsPanel", "slam"), &StageTimes::slam, Qt::SolidPattern},
}};

/// The smallest of 1, 2, 5 · 10ⁿ that is not below `value`.
double niceTop(double value) {
  if (!(value > 0.0)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (value <= factor * power) return factor * power;
  }
  return 10.0 * power;
}

}  // namespace

ChartsPanel::ChartsPanel(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  size_plot_ = addPlot(tr("Effective sample size (particles)"));
  time_plot_ = addPlot(tr("Time per observation (ms)"));
  addSeries();
  applyPalette();
  clear();
}

ChartsPanel::Plot ChartsPanel::addPlot(const QString& title) {
  auto* chart = new QChart;
  chart->setTitle(title);
  chart->setMargins(QMargins(0, 0, 6, 0));
  chart->layout()->setContentsMargins(0, 0, 0, 0);
  chart->setBackgroundRoundness(0.0);
  chart->legend()->hide();
  const Plot plot{chart, new QValueAxis, new QValueAxis};
  plot.frames->setLabelFormat(QStringLiteral("%.0f"));
  plot.frames->setTickCount(3);
  plot.values->setLabelFormat(QStringLiteral("%g"));
  plot.values->setTickCount(3);
  chart->addAxis(plot.frames, Qt::AlignBottom);
  chart->addAxis(plot.values, Qt::AlignLeft);
  auto* view = new QChartView(chart);
  view->setRenderHint(QPainter::Antialiasing);
  view->setFrameShape(QFrame::NoFrame);
  view->setMinimumSize(180, 90);
  layout()->addWidget(view);
  return plot;
}

void ChartsPanel::addSeries() {
  size_line_ = new QLineSeries;
  size_plot_.chart->addSeries(size_line_);
  size_line_->attachAxis(size_plot_.frames);
  size_line_->attachAxis(size_plot_.values);

  QLineSeries* below = nullptr;
  for (std::size_t i = 0; i < kStages; ++i) {
    tops_[i] = new QLineSeries(this);
    stages_[i] = new QAreaSeries(tops_[i], below);
    time_plot_.chart->addSeries(stages_[i]);
    stages_[i]->attachAxis(time_plot_.frames);
    stages_[i]->attachAxis(time_plot_.values);
    below = tops_[i];
  }
  layout()->addWidget(makeLegend());
}

QWidget* ChartsPanel::makeLegend() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(8, 0, 8, 2);
  layout->addStretch();
  for (std::size_t i = 0; i < kStages; ++i) {
    samples_[i] = new QLabel;
    names_[i] = new QLabel(tr(kStageSpecs[i].name));
    layout->addWidget(samples_[i]);
    layout->addWidget(names_[i]);
  }
  layout->addStretch();
  row->setAutoFillBackground(true);
  row->setBackgroundRole(QPalette::Base);
  return row;
}

void ChartsPanel::add(const std::vector<FrameReport>& reports) {
  for (const FrameReport& report : reports) series_.add(report);
  redraw();
}

void ChartsPanel::clear() {
  series_.clear();
  redraw();
}

void ChartsPanel::redraw() {
  QList<QPointF> sizes;
  std::array<QList<QPointF>, kStages> sums;
  std::array<bool, kStages> used{};
  double greatest_size = 0.0;
  double greatest_ms = 0.0;
  for (const ReportSeries::Point& point : series_.points()) {
    sizes.append({point.frame, point.effective_sample_size});
    greatest_size = std::max(greatest_size, point.effective_sample_size);
    double sum_ms = 0.0;
    for (std::size_t i = 0; i < kStages; ++i) {
      const double ms = point.ms.*kStageSpecs[i].ms;
      used[i] = used[i] || ms >= 0.05;
      sum_ms += ms;
      sums[i].append({point.frame, sum_ms});
    }
    greatest_ms = std::max(greatest_ms, sum_ms);
  }
  size_line_->replace(sizes);
  for (std::size_t i = 0; i < kStages; ++i) {
    tops_[i]->replace(sums[i]);
    stages_[i]->setVisible(used[i]);
    samples_[i]->setVisible(used[i]);
    names_[i]->setVisible(used[i]);
  }
  const double first = sizes.isEmpty() ? 0.0 : sizes.front().x();
  const double last = sizes.isEmpty() ? 2.0 : std::max(sizes.back().x(), first + 2.0);
  for (const Plot& plot : {size_plot_, time_plot_}) plot.frames->setRange(first, last);
  size_plot_.values->setRange(0.0, niceTop(greatest_size));
  time_plot_.values->setRange(0.0, niceTop(greatest_ms));
}

void ChartsPanel::applyPalette() {
  const Colours& colours = Colours::of(palette());
  const QColor text = palette().color(QPalette::Text);
  QColor grid = text;
  grid.setAlpha(40);
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * 0.85);
  for (const Plot& plot : {size_plot_, time_plot_}) {
    plot.chart->setBackgroundBrush(palette().base());
    plot.chart->setTitleBrush(text);
    plot.chart->setTitleFont(small);
    for (QValueAxis* axis : {plot.frames, plot.values}) {
      axis->setLabelsColor(text);
      axis->setLabelsFont(small);
      axis->setGridLineColor(grid);
      axis->setLinePenColor(grid);
    }
  }
  size_line_->setPen(QPen(colours.particle(1.0), 1.5));
  for (std::size_t i = 0; i < kStages; ++i) {
    QColor colour = text;
    colour.setAlpha(i + 1 == kStages ? 110 : 190);
    stages_[i]->setBrush(QBrush(colour, kStageSpecs[i].pattern));
    stages_[i]->setPen(QPen(colour, 1.0));
    QPixmap sample(14, 10);
    sample.fill(palette().color(QPalette::Base));
    QPainter painter(&sample);
    painter.setPen(colour);
    painter.setBrush(stages_[i]->brush());
    painter.drawRect(sample.rect().adjusted(0, 0, -1, -1));
    painter.end();
    samples_[i]->setPixmap(sample);
    names_[i]->setFont(small);
  }
}

void ChartsPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) applyPalette();
  QWidget::changeEvent(event);
}

}  // namespace handmap
