// "New from template": drawings to begin with, ours and those that somebody has kept.
#pragma once

#include <QObject>

#include "app/gui/shell/shell.h"

class QMenu;
class QWidget;

namespace handmap {

class FileActions;
class MapDocument;

class TemplateMenu : public QObject {
  Q_OBJECT
 public:
  /// What it is given must outlive it.
  TemplateMenu(const Shell& shell, MapDocument& document, FileActions& files, QObject* parent);

  QMenu& menu() { return *menu_; }
  /// Keeps the drawing, under a name that is asked for, to begin with later.
  void keep();
  static QString folder();  ///< of those that somebody has kept

 private:
  void fill();
  void addEntry(const QString& text, const QString& path);
  void begin(const QString& path);

  const Shell& shell_;
  MapDocument& document_;
  FileActions& files_;
  QMenu* menu_;
};

}  // namespace handmap
