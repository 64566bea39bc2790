// A run over the time of its recording: how sure the pose is and how far it is off where the truth
// is known, how far each building moved, the time that each stage takes, and, for the published
// method, the effective sample size of its particles. (That of the default method is of poses that
// a smoother has already weighed: it stays near one and says nothing.)
#pragma once

#include <QTimer>
#include <QWidget>
#include <array>
#include <optional>

#include "widgets/run/panels/change_series.h"
#include "widgets/run/panels/frame_budget.h"
#include "widgets/run/panels/report_series.h"

class QAreaSeries;
class QLabel;
class QLineSeries;

namespace handmap {

class BudgetTable;
class Plot;

class ChartsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ChartsPanel(QWidget* parent = nullptr);

  /// Begin anew.
  void setDrawing(const Map& drawing);
  void clear();
  /// What is off is only known of what comes later.
  void setTruth(const std::vector<StampedPose>& trajectory);
  void setTrueMiddles(const std::optional<TrueMiddles>& truth);
  void showSampleSize(bool shown);

  void add(const std::vector<FrameReport>& reports);
  /// In any order.
  void addSnapshot(const Snapshot& snapshot);
  /// The moment that is shown elsewhere.
  void setCursor(std::optional<double> time_s);

 Q_SIGNALS:
  void timeChosen(double time_s);

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  static constexpr std::size_t kMostBuildings = 6;

  Plot* addPlot(const QString& title);
  QLabel* addLegend();
  void addSeries();
  void redrawSoon();
  void redraw();
  void redrawReports();
  void redrawChanges();
  void applyPalette();

  QWidget* content_;
  ReportSeries series_;
  ChangeSeries changes_;
  FrameBudget budget_;
  Trajectory truth_;
  QTimer soon_;
  QTimer later_;
  Plot* pose_plot_;
  Plot* change_plot_;
  Plot* error_plot_;
  Plot* time_plot_;
  Plot* likelihood_plot_;
  Plot* size_plot_;
  QLineSeries* spread_line_;
  QLineSeries* pose_error_line_;
  QLineSeries* map_error_line_;
  QLineSeries* likelihood_line_;
  QLineSeries* size_line_;
  QLabel* pose_legend_;
  QLabel* change_legend_;
  std::array<QLineSeries*, kMostBuildings> change_lines_{};
  std::array<QLineSeries*, kStages.size()> tops_{};  ///< summed up to and with the stage
  std::array<QAreaSeries*, kStages.size()> areas_{};
  BudgetTable* budget_table_;
};

}  // namespace handmap
