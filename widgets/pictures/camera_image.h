// Images of cameras as pictures of the window.
#pragma once

#include <QImage>

#include <opencv2/core/mat.hpp>

namespace handmap {

/// Grey or BGR, 8 bit; a null image for anything else.
QImage cameraImage(const cv::Mat& image);
/// The same, but valid only as long as the image it is of.
QImage sharedImage(const cv::Mat& image);

}  // namespace handmap
