// The files of pictures that a drawing may lie upon.
#pragma once

#include <QImage>
#include <QString>
#include <optional>

#include "core/map/underlay_fit.h"

namespace handmap {

/// "*.png *.jpg …", and the same for dialogs: "Pictures (*.png *.jpg …)".
QString pictureEndings();
QString pictureFilter();
/// Whether the name is that of a picture; the file itself may still be anything.
bool isPictureName(const QString& path);

struct PictureHead {
  QSize size;  ///< pixels
  std::optional<PictureGeometry> geometry;
};

/// What its head, and the world file beside it, say. Throws Error (BadInput) for what is no
/// picture, for one that is too large, and for a world file that is none.
PictureHead readPictureHead(const QString& path);

struct Picture {
  QImage image;
  QSize size;  ///< of the file; the image may be smaller
};

/// Throws Error (BadInput). Slow: not in the thread of the window.
Picture readPicture(const QString& path);

}  // namespace handmap
