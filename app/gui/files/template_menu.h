// "New from template": drawings to begin with, ours and those that somebody has kept.
#pragma once

#include <QObject>

class QMenu;
class QWidget;

namespace handmap {

class Dialogs;
class FileActions;
class MapDocument;
class MessageBar;

class TemplateMenu : public QObject {
  Q_OBJECT
 public:
  /// All of it must outlive this object.
  struct Parts {
    QWidget& window;
    MapDocument& document;
    FileActions& files;
    MessageBar& messages;
    Dialogs& dialogs;
  };
  TemplateMenu(const Parts& parts, QObject* parent);

  QMenu& menu() { return *menu_; }
  /// Keeps the drawing, under a name that is asked for, to begin with later.
  void keep();
  static QString folder();  ///< of those that somebody has kept

 private:
  void fill();
  void addEntry(const QString& text, const QString& path);
  void begin(const QString& path);

  Parts parts_;
  QMenu* menu_;
};

}  // namespace handmap
