// The unsaved work of a session, as its recovery file holds it.
#pragma once

#include <QDateTime>
#include <QString>
#include <string>

#include "core/map/map.h"
#include "widgets/teach/teaching.h"

namespace handmap {

struct UnsavedWork {
  QString project;        ///< the file of the drawing; empty: never saved
  QString origin;         ///< the file beside which paths of the map lie, see MapDocument::origin()
  QDateTime written;      ///< UTC
  bool modified = false;  ///< the drawing is another than the project's file holds
  Map map;
  Teaching teaching;

  /// The file's name, else the map's, else "Untitled".
  QString name() const;
};

std::string formatWork(const UnsavedWork& work);
/// Throws Error.
UnsavedWork readWork(const QString& file);

}  // namespace handmap
