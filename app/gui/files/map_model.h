// The taught model of the drawing: loaded when the drawing is opened, written beside it when the
// drawing is saved.
#pragma once

#include <QObject>
#include <filesystem>
#include <optional>

namespace handmap {

class Dialogs;
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
    Dialogs& dialogs;
  };
  MapModel(const Parts& parts, QObject* parent);

  /// Asks when something was taught and is in no file. False: somebody wants to stay.
  bool mayClose();
  void loadOfDrawing();

 private:
  /// Throws Error.
  void writeBeside(const QString& map_path);
  bool saveModel();
  /// nullopt: none, or one that may not be read. Throws Error.
  std::optional<std::filesystem::path> modelToRead() const;
  void saveWithMap();

  Parts parts_;
  bool of_drawing_ = false;  ///< the model of the panel belongs to the drawing
};

}  // namespace handmap
