#include "app/gui/exports.h"

#include <QPainter>
#include <QSaveFile>
#include <QWidget>

#include "core/base/error.h"

namespace handmap {

QImage pictureOf(QWidget& widget) {
  constexpr int kScale = 2;
  QImage picture(widget.size() * kScale, QImage::Format_RGB32);
  picture.setDevicePixelRatio(kScale);
  picture.fill(widget.palette().color(QPalette::Window));
  widget.render(&picture);
  return picture;
}

void writePicture(const QImage& picture, const QString& path) {
  QSaveFile file(path);
  if (!file.open(QIODevice::WriteOnly) || !picture.save(&file, "PNG") || !file.commit()) {
    throw Error(
        ErrorCode::RunFailed,
        (path + QStringLiteral(": cannot be written: ") + file.errorString()).toStdString());
  }
}

}  // namespace handmap
