// Files of what a run came to: the corrected map, the robot's way, a page of it, its moments.
#pragma once

#include <QObject>
#include <functional>
#include <optional>
#include <vector>

#include "app/gui/shell/shell.h"
#include "core/map/map.h"
#include "core/session/acts.h"

namespace handmap {

class FileActions;
class MapDocument;
class RunController;
class SourceActions;

class RunExports : public QObject {
  Q_OBJECT
 public:
  /// What it is given must outlive it.
  RunExports(const Shell& shell, MapDocument& document, FileActions& files,
             const SourceActions& sources, RunController& run);

  /// What a person has said of the run, for its recording.
  void setActs(std::function<std::vector<Act>()> acts) { acts_ = std::move(acts); }

 private:
  /// With where the drawing is now said to lie. nullopt: no run has a result.
  std::optional<Map> refinedMap() const;
  QString nameOf(const QString& what) const;  ///< without an ending
  void exportMap();
  void exportTrajectory();
  void exportReport();
  void exportMcap();
  void exportFilm();
  void exportRecording();
  void updateActions();

  const Shell& shell_;
  MapDocument& document_;
  FileActions& files_;
  const SourceActions& sources_;
  RunController& run_;
  std::function<std::vector<Act>()> acts_;
};

}  // namespace handmap
