#include "widgets/run/panels/charts_panel.h"

#include <QAreaSeries>
#include <QEvent>
#include <QLabel>
#include <QLineSeries>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/run/panels/budget_table.h"
#include "widgets/run/panels/plot.h"
#include "widgets/style/colours.h"

namespace handmap {

namespace {

constexpr int kRedraw_ms = 150;  // charts are slow to draw, and nobody reads them faster
constexpr std::array<Qt::PenStyle, 3> kLines = {Qt::SolidLine, Qt::DashLine, Qt::DotLine};
constexpr std::array<const char*, 3> kLineSigns = {"━", "╍", "┈"};

QString inColour(const QColor& colour, const QString& text) {
  return QStringLiteral("<span style='color:%1'>%2</span>").arg(colour.name(), text);
}

/// Of the buildings whose change is drawn: two inks, three lines.
QPen changePen(std::size_t line, const Colours& colours) {
  const Role role = line < kLines.size() ? Role::Corrected : Role::Text;
  return {colours[role], 1.5, kLines[line % kLines.size()]};
}

}  // namespace

ChartsPanel::ChartsPanel(QWidget* parent) : QWidget(parent) {
  auto* inner = new QWidget;
  inner->setLayout(new QVBoxLayout);
  inner->layout()->setContentsMargins(0, 0, 0, 0);
  inner->layout()->setSpacing(0);
  auto* area = new QScrollArea;
  area->setFrameShape(QFrame::NoFrame);
  area->setWidgetResizable(true);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setWidget(inner);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(area);
  content_ = inner;

  pose_plot_ = addPlot(tr("Robot: how sure its place is, and how far off (m)"));
  pose_legend_ = addLegend();
  change_plot_ = addPlot(tr("Buildings: how far from the drawn place (m)"));
  change_legend_ = addLegend();
  error_plot_ = addPlot(tr("Buildings: how far from the true place, mean (m)"));
  time_plot_ = addPlot(tr("Time per observation (ms)"));
  budget_table_ = new BudgetTable;
  inner->layout()->addWidget(budget_table_);
  likelihood_plot_ = addPlot(tr("How well what was seen fits the map (higher: better)"));
  size_plot_ = addPlot(tr("Particles that count (effective sample size)"));
  addSeries();
  soon_.setSingleShot(true);
  soon_.setInterval(kRedraw_ms);
  later_.setSingleShot(true);
  later_.setInterval(kRedraw_ms / 2);
  connect(&soon_, &QTimer::timeout, this, [this] {
    redrawReports();
    later_.start();
  });
  connect(&later_, &QTimer::timeout, this, [this] {
    redrawChanges();
    budget_table_->setBudget(budget_);
  });
  applyPalette();
  error_plot_->hide();
  showSampleSize(false);
  redraw();
}

Plot* ChartsPanel::addPlot(const QString& title) {
  auto* plot = new Plot(title);
  connect(plot, &Plot::timeChosen, this, &ChartsPanel::timeChosen);
  content_->layout()->addWidget(plot);
  return plot;
}

QLabel* ChartsPanel::addLegend() {
  auto* legend = new QLabel;
  legend->setAutoFillBackground(true);
  legend->setBackgroundRole(QPalette::Base);
  legend->setContentsMargins(8, 0, 8, 2);
  legend->setWordWrap(true);
  content_->layout()->addWidget(legend);
  return legend;
}

void ChartsPanel::addSeries() {
  spread_line_ = pose_plot_->addLine();
  pose_error_line_ = pose_plot_->addLine();
  for (QLineSeries*& line : change_lines_) line = change_plot_->addLine();
  map_error_line_ = error_plot_->addLine();
  likelihood_line_ = likelihood_plot_->addLine();
  size_line_ = size_plot_->addLine();
  QLineSeries* below = nullptr;
  for (std::size_t i = 0; i < kStages.size(); ++i) {
    tops_[i] = new QLineSeries(this);
    areas_[i] = new QAreaSeries(tops_[i], below);
    time_plot_->add(areas_[i]);
    below = tops_[i];
  }
}

void ChartsPanel::setDrawing(const Map& drawing) {
  changes_.setDrawing(drawing);
  redrawSoon();
}

void ChartsPanel::setTruth(const std::vector<StampedPose>& trajectory) {
  truth_ = Trajectory(trajectory, "truth");
}

void ChartsPanel::setTrueMiddles(const std::optional<TrueMiddles>& truth) {
  changes_.setTruth(truth);
  error_plot_->setVisible(truth.has_value());
}

void ChartsPanel::showSampleSize(bool shown) { size_plot_->setVisible(shown); }

void ChartsPanel::add(const std::vector<FrameReport>& reports) {
  for (const FrameReport& report : reports) {
    const auto true_pose = truth_.empty() ? std::nullopt : truth_.at(report.time_s);
    std::optional<double> error;
    if (true_pose) error = (true_pose->position() - report.pose.position()).norm();
    series_.add(report, error);
    budget_.add(report);
  }
  redrawSoon();
}

void ChartsPanel::addSnapshot(const Snapshot& snapshot) {
  if (snapshot.map) changes_.add(snapshot.report.time_s, *snapshot.map);
  redrawSoon();
}

void ChartsPanel::setCursor(std::optional<double> time_s) {
  for (Plot* plot :
       {pose_plot_, change_plot_, error_plot_, time_plot_, likelihood_plot_, size_plot_}) {
    plot->setCursor(time_s);
  }
}

void ChartsPanel::clear() {
  series_.clear();
  changes_.clear();
  budget_.clear();
  setCursor({});
  redrawSoon();
}

/// At once when the panel is shown, then a few times a second, a half at a time: all together would
/// hold the window for two frames.
void ChartsPanel::redrawSoon() {
  if (isVisible() && !soon_.isActive()) soon_.start();
}

void ChartsPanel::showEvent(QShowEvent* event) {
  redraw();
  QWidget::showEvent(event);
}

void ChartsPanel::redraw() {
  redrawReports();
  redrawChanges();
  budget_table_->setBudget(budget_);
}

void ChartsPanel::redrawReports() {
  QList<QPointF> spreads;
  QList<QPointF> errors;
  QList<QPointF> sizes;
  QList<QPointF> likelihoods;
  std::array<QList<QPointF>, kStages.size()> sums;
  double greatest_m = 0.0;
  double greatest_size = 0.0;
  double greatest_ms = 0.0;
  double least_nats = 0.0;
  double greatest_nats = 0.0;
  for (const ReportSeries::Point& point : series_.points()) {
    spreads.append({point.time_s, point.spread_m});
    sizes.append({point.time_s, point.effective_sample_size});
    greatest_m = std::max(greatest_m, point.spread_m);
    greatest_size = std::max(greatest_size, point.effective_sample_size);
    if (!std::isnan(point.error_m)) {
      errors.append({point.time_s, point.error_m});
      greatest_m = std::max(greatest_m, point.error_m);
    }
    if (!std::isnan(point.log_likelihood)) {
      likelihoods.append({point.time_s, point.log_likelihood});
      least_nats = std::min(least_nats, point.log_likelihood);
      greatest_nats = std::max(greatest_nats, point.log_likelihood);
    }
    double sum_ms = 0.0;
    for (std::size_t i = 0; i < kStages.size(); ++i) {
      sum_ms += point.ms.*kStages[i].ms;
      sums[i].append({point.time_s, sum_ms});
    }
    greatest_ms = std::max(greatest_ms, sum_ms);
  }
  spread_line_->replace(spreads);
  pose_error_line_->replace(errors);
  size_line_->replace(sizes);
  likelihood_line_->replace(likelihoods);
  likelihood_plot_->setVisible(!likelihoods.isEmpty());
  for (std::size_t i = 0; i < kStages.size(); ++i) tops_[i]->replace(sums[i]);
  const double first = spreads.isEmpty() ? 0.0 : spreads.front().x();
  const double last = spreads.isEmpty() ? 1.0 : spreads.back().x();
  pose_plot_->setRanges(first, last, greatest_m);
  size_plot_->setRanges(first, last, greatest_size);
  time_plot_->setRanges(first, last, greatest_ms);
  likelihood_plot_->setRanges(first, last, greatest_nats, least_nats);
  const Colours& colours = Colours::of(palette());
  QString legend =
      inColour(colours[Role::Trajectory], tr("━ nine times of ten it is no farther off"));
  if (!errors.isEmpty()) {
    legend += QStringLiteral(" &nbsp; ") + inColour(colours[Role::Truth], tr("╍ true error"));
  }
  pose_legend_->setText(legend);
}

void ChartsPanel::redrawChanges() {
  const std::vector<std::size_t> farthest = changes_.farthest(kMostBuildings);
  const Colours& colours = Colours::of(palette());
  QStringList legend;
  double greatest = 0.0;
  for (std::size_t line = 0; line < kMostBuildings; ++line) {
    QList<QPointF> points;
    if (line < farthest.size()) {
      for (const auto& [time_s, moment] : changes_.moments()) {
        if (farthest[line] >= moment.moved_m.size()) continue;
        points.append({time_s, static_cast<double>(moment.moved_m[farthest[line]])});
        greatest = std::max(greatest, points.back().y());
      }
      const Building& building = changes_.drawing().buildings[farthest[line]];
      legend << inColour(changePen(line, colours).color(),
                         QString::fromUtf8(kLineSigns[line % kLineSigns.size()]) +
                             QString::fromStdString(building.id).toHtmlEscaped());
    }
    change_lines_[line]->replace(points);
  }
  change_legend_->setText(legend.join(QStringLiteral(" &nbsp; ")));
  QList<QPointF> errors;
  double greatest_error = 0.0;
  for (const auto& [time_s, moment] : changes_.moments()) {
    if (!moment.mean_error_m) continue;
    errors.append({time_s, *moment.mean_error_m});
    greatest_error = std::max(greatest_error, *moment.mean_error_m);
  }
  map_error_line_->replace(errors);
  const auto& moments = changes_.moments();
  const double first = moments.empty() ? 0.0 : moments.begin()->first;
  const double last = moments.empty() ? 1.0 : moments.rbegin()->first;
  change_plot_->setRanges(first, last, greatest);
  error_plot_->setRanges(first, last, greatest_error);
}

void ChartsPanel::applyPalette() {
  const Colours& colours = Colours::of(palette());
  for (Plot* plot :
       {pose_plot_, change_plot_, error_plot_, time_plot_, likelihood_plot_, size_plot_}) {
    plot->applyPalette();
  }
  spread_line_->setPen(QPen(colours[Role::Trajectory], 1.5));
  pose_error_line_->setPen(QPen(colours[Role::Truth], 1.5, Qt::DashLine));
  map_error_line_->setPen(QPen(colours[Role::Truth], 1.5, Qt::DashLine));
  size_line_->setPen(QPen(colours.particle(1.0), 1.5));
  likelihood_line_->setPen(QPen(colours[Role::LocalMap], 1.5));
  for (std::size_t line = 0; line < kMostBuildings; ++line) {
    change_lines_[line]->setPen(changePen(line, colours));
  }
  for (std::size_t i = 0; i < kStages.size(); ++i) {
    const QBrush brush = stageBrush(i, palette());
    areas_[i]->setBrush(brush);
    areas_[i]->setPen(QPen(brush.color(), 1.0));
  }
}

void ChartsPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) {
    applyPalette();
    redrawSoon();
  }
  QWidget::changeEvent(event);
}

}  // namespace handmap
