#include "app/gui/editing/paper_reading.h"

#include <QBuffer>

namespace handmap {

QImage imageOf(const cv::Mat& page) {
  return QImage(page.data, page.cols, page.rows, static_cast<qsizetype>(page.step),
                QImage::Format_BGR888)
      .copy();
}

std::string pngOf(const QImage& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return bytes.toStdString();
}

}  // namespace handmap
