// Effective sample size and time per observation, over the run.
#pragma once

#include <QList>
#include <QWidget>
#include <array>

#include "widgets/run/report_series.h"

class QAreaSeries;
class QChart;
class QLabel;
class QLineSeries;
class QValueAxis;

namespace handmap {

class ChartsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ChartsPanel(QWidget* parent = nullptr);

  void add(const std::vector<FrameReport>& reports);
  void clear();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  static constexpr std::size_t kStages = 5;

  struct Plot {
    QChart* chart;
    QValueAxis* frames;
    QValueAxis* values;
  };
  Plot addPlot(const QString& title);
  void addSeries();
  QWidget* makeLegend();
  void redraw();
  void applyPalette();

  ReportSeries series_;
  Plot size_plot_;
  Plot time_plot_;
  QLineSeries* size_line_;
  std::array<QLineSeries*, kStages> tops_{};  ///< summed up to and with the stage
  std::array<QAreaSeries*, kStages> stages_{};
  std::array<QLabel*, kStages> samples_{};
  std::array<QLabel*, kStages> names_{};
};

}  // namespace handmap
