// The taught model of the drawing: loaded when the drawing is opened, written beside it when the
// drawing is saved.
#pragma once

#include <QObject>
#include <filesystem>
#include <optional>

#include "app/gui/shell/shell.h"

namespace handmap {

class FileActions;
class MapDocument;
class TeachPanel;

class MapModel : public QObject {
  Q_OBJECT
 public:
  /// What it is given must outlive it.
  MapModel(const Shell& shell, MapDocument& document, FileActions& files, TeachPanel& teach,
           QObject* parent);

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

  const Shell& shell_;
  MapDocument& document_;
  FileActions& files_;
  TeachPanel& teach_;
  bool of_drawing_ = false;  ///< the model of the panel belongs to the drawing
};

}  // namespace handmap
