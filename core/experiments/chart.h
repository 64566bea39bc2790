// Simple charts as pictures: lines and markers with their 95 % intervals, as bars or as bands.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/experiments/statistics.h"

namespace handmap {

/// Colours and markers mean the same everywhere; safe for colour-blind eyes (Okabe and Ito), and
/// never colour alone.
enum class SeriesLook { Drawing, Handmap, Paper, Odometry };

struct ChartPoint {
  double x = 0.0;
  Interval y;
};

struct ChartSeries {
  std::string name;
  SeriesLook look = SeriesLook::Drawing;
  std::vector<ChartPoint> points;
};

/// Texts are ASCII: the fonts of OpenCV have no more.
struct Chart {
  enum class Kind { Bars, Band };  ///< how intervals are shown; bands have no markers

  std::string title;
  std::string x_label;  ///< with units; x is 0 or more
  std::string y_label;
  Kind kind = Kind::Bars;
  std::vector<std::string> categories;  ///< names of x = 0, 1, …; empty: numbers
  std::optional<double> y_max;          ///< absent: as high as the intervals are; from 0
  std::vector<ChartSeries> series;
};

/// 8 bit, BGR.
cv::Mat drawn(const Chart& chart);

/// Of values from 0 to `most`: 1, 2 or 5 times a power of ten, so that there are five to eleven.
double tickStep(double most);

}  // namespace handmap
