// A bare page to draw on, for tests of what reads drawings.
#pragma once

#include "core/paper/trace.h"

namespace handmap::test {

inline const cv::Scalar kPaper(225, 235, 238);

inline cv::Mat page() { return cv::Mat(1130, 1600, CV_8UC3, kPaper); }

/// The shapes that are taken without a person.
inline std::vector<TracedShape> sure(const Trace& trace) {
  std::vector<TracedShape> shapes = trace.shapes;
  std::erase_if(shapes, [](const TracedShape& shape) { return shape.confidence < kSureOfShape; });
  return shapes;
}

}  // namespace handmap::test
