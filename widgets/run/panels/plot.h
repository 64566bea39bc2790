// A chart over the time of the recording: one value axis, a line where the shown moment is, and a
// click that chooses another.
#pragma once

#include <QChartView>
#include <QList>
#include <optional>

class QChart;
class QLineSeries;
class QValueAxis;

namespace handmap {

/// The smallest of 1, 2, 5 · 10ⁿ that is not below `value`.
double niceTop(double value);

class Plot : public QChartView {
  Q_OBJECT
 public:
  explicit Plot(const QString& title, QWidget* parent = nullptr);

  /// With both axes; goes with the plot.
  QLineSeries* addLine();
  void add(QAbstractSeries* series);
  /// From 0, or a round number below `least`, to one above `greatest`.
  void setRanges(double first_s, double last_s, double greatest, double least = 0.0);
  void setTitle(const QString& title);
  void setCursor(std::optional<double> time_s);
  void applyPalette();

 Q_SIGNALS:
  void timeChosen(double time_s);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void drawForeground(QPainter* painter, const QRectF& rect) override;

 private:
  void choose(QPointF position);

  QChart* chart_;
  QValueAxis* times_;
  QValueAxis* values_;
  std::optional<double> cursor_s_;
};

}  // namespace handmap
