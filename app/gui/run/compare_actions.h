// The drawing, and what a run made of it, beside a true map: figures in a panel, and arrows on the
// canvas for as long as it is there.
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "app/gui/shell/shell.h"
#include "core/map/map.h"

namespace handmap {

class ComparisonPanel;
class ErrorArrowsItem;
class FileActions;
class MapCanvas;
class MapDocument;
class RunController;
class SourceActions;

class CompareActions : public QObject {
  Q_OBJECT
 public:
  /// What it is given must outlive it.
  CompareActions(const Shell& shell, MapDocument& document, MapCanvas& canvas, FileActions& files,
                 const SourceActions& sources, RunController& run, QObject* parent);

 private:
  /// With the truth of what the run takes its observations from, where that is known.
  void begin();
  void ask();
  void open(const QString& path);
  /// Says so instead where both have too little in common.
  void compare(const Map& truth, const QString& name);
  void update();
  void updateSoon();
  void end();
  void save();

  const Shell& shell_;
  MapDocument& document_;
  FileActions& files_;
  const SourceActions& sources_;
  RunController& run_;
  ErrorArrowsItem* arrows_;  ///< of the scene
  ComparisonPanel* panel_;
  std::optional<Map> truth_;  ///< while both are compared
  QString truth_name_;
  QTimer soon_;
};

}  // namespace handmap
