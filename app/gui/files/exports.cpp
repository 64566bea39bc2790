#include "app/gui/files/exports.h"

#include <QBuffer>
#include <QObject>
#include <QPainter>
#include <QWidget>

#include "core/base/error.h"
#include "core/base/text.h"

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
  if (picture.isNull()) {
    throw Error(ErrorCode::RunFailed,
                QObject::tr("there is not enough memory for the picture").toStdString());
  }
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!picture.save(&buffer, "PNG")) {
    throw Error(ErrorCode::RunFailed,
                QObject::tr("%1: cannot be encoded as PNG").arg(path).toStdString());
  }
  writeFileAtomically(path.toStdString(), bytes.toStdString());
}

}  // namespace handmap
