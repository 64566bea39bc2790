#include "core/sketch_study/size_line.h"

#include <algorithm>
#include <cmath>

namespace handmap {

double SizeLine::tells(double true_size, double middle) const {
  return bias + (slope - 1.0) * (std::log(true_size) - middle);
}

double middleSize(const DrawnErrors& drawing) {
  double sum = 0.0;
  double count = 0.0;
  for (const DrawnError& error : drawing.of) {
    if (!error.log_size) continue;
    sum += std::log(error.size);
    ++count;
  }
  return count > 0.0 ? sum / count : 0.0;
}

SizeLine sizeLine(const std::vector<DrawnErrors>& drawings) {
  double count = 0.0;
  double sum = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  for (const DrawnErrors& drawing : drawings) {
    const double middle = middleSize(drawing);
    for (const DrawnError& error : drawing.of) {
      if (!error.log_size) continue;
      const double x = std::log(error.size) - middle;
      ++count;
      sum += *error.log_size;
      xx += x * x;
      xy += x * *error.log_size;
    }
  }
  SizeLine line{xx > 0.0 ? 1.0 + xy / xx : 1.0, sum / std::max(1.0, count), 0.0};
  double square = 0.0;
  for (const DrawnErrors& drawing : drawings) {
    const double middle = middleSize(drawing);
    for (const DrawnError& error : drawing.of) {
      if (!error.log_size) continue;
      square += std::pow(*error.log_size - line.tells(error.size, middle), 2);
    }
  }
  line.sigma = std::sqrt(square / std::max(1.0, count - 2.0));
  return line;
}

}  // namespace handmap
