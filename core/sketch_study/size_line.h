// How drawn sizes follow from true ones: a line in logarithms about the means of each drawing.
#pragma once

#include <vector>

#include "core/sketch_study/drawn_errors.h"

namespace handmap {

/// ln drawn = ln true + bias + (slope - 1) (ln true - its mean in the drawing).
struct SizeLine {
  double slope = 1.0;
  double bias = 0.0;   ///< mean of ln drawn / true
  double sigma = 0.0;  ///< about the line

  double tells(double true_size, double middle) const;  ///< of ln drawn / true
};

SizeLine sizeLine(const std::vector<DrawnErrors>& drawings);

/// Mean of ln true size of a drawing's outlines; 0 without any.
double middleSize(const DrawnErrors& drawing);

}  // namespace handmap
