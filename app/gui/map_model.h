// The taught model of the drawing: loaded when the drawing is opened, written beside it when the
// drawing is saved.
#pragma once

#include <QObject>

namespace handmap {

class FileActions;
class MapDocument;
class MessageBar;
class TeachPanel;

class MapModel : public QObject {
  Q_OBJECT
 public:
  /// All of it must outlive this object.
  struct Parts {
    MapDocument& document;
    FileActions& files;
    TeachPanel& teach;
    MessageBar& messages;
  };
  MapModel(const Parts& parts, QObject* parent);

 private:
  /// Throws Error.
  void writeBeside(const QString& map_path);
  void loadOfDrawing();
  void saveWithMap();

  Parts parts_;
  bool of_drawing_ = false;  ///< the model of the panel belongs to the drawing
};

}  // namespace handmap
