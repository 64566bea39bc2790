// What a file or folder is to the window, whether it is named on the command line, chosen or
// dropped.
#pragma once

#include <QMimeData>
#include <QString>

namespace handmap {

/// Log: what is made into a recording first: bags, tables, drives of KITTI's raw data.
enum class FileKind { Drawing, Recording, Log, Rig, Picture, Unknown };

/// By its name, and where that says too little by its beginning.
FileKind fileKindOf(const QString& path);

/// The file or folder that is dragged; empty for several, and for what is not known.
QString draggedPath(const QMimeData& data);

}  // namespace handmap
