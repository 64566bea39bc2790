// Files made from what is on the screen. All are atomic; all throw Error (RunFailed).
#pragma once

#include <QImage>
#include <QString>

class QWidget;

namespace handmap {

/// The widget as it looks, at twice the resolution of an ordinary screen.
QImage pictureOf(QWidget& widget);
void writePicture(const QImage& picture, const QString& path);

}  // namespace handmap
