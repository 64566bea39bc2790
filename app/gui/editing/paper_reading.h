// A drawing on paper that was read, from a photo or through a camera.
#pragma once

#include <QImage>
#include <string>
#include <vector>

#include "core/paper/trace.h"

namespace handmap {

struct PaperReading {
  Trace trace;
  std::vector<int> numbers;  ///< of the shapes, the same from image to image; empty: of a photo
  std::string page;          ///< as a file of PNG
  std::string trouble;       ///< why there may be no shapes; empty: nothing is wrong
};

QImage imageOf(const cv::Mat& page);
/// `image` as a file of PNG.
std::string pngOf(const QImage& image);

}  // namespace handmap
