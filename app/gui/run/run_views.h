// Everything that shows a run beside the canvas' items, kept in step with what the canvas shows:
// the line of words, the view that follows, charts, table, log, and why a wall stands where it is.
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "app/gui/run/run_panels.h"
#include "app/gui/run/story_teller.h"
#include "app/gui/shell/shell.h"

namespace handmap {

class FileActions;
class FollowRobot;
class MapCanvas;
class MapDocument;
class RobotPointer;
class RunController;
class RunOverlays;
class RunStrip;
class SourceActions;
struct Phase;
struct Snapshot;

class RunViews : public QObject {
  Q_OBJECT
 public:
  /// What it is given must outlive it.
  RunViews(const Shell& shell, MapCanvas& canvas, MapDocument& document, FileActions& files,
           const SourceActions& sources, RunController& run, RunOverlays& overlays,
           const RunPanels& panels);

  /// The image of that moment.
  void showPicture(const std::shared_ptr<const Snapshot>& snapshot);
  /// Everything of that moment but the image.
  void show(const Snapshot& snapshot);
  /// In the middle of an observation; until the next snapshot is shown.
  void showPhase(const Phase& phase, int number, int count);
  /// In the log.
  void note(double time_s, const QString& text);

 Q_SIGNALS:
  /// Somebody wants to see that moment of the recording.
  void timeChosen(double time_s);

 private:
  void connectRun();
  void connectFollowing();
  void showRobotAt(const std::optional<Pose2>& pose);
  void connectTable();
  void connectWhy();
  void compare();
  void showTruth(const std::vector<StampedPose>& trajectory);
  void forget();
  void onShown(const Snapshot& snapshot);
  void clear();
  void showBuilding(const QString& id);
  void askWhy();
  void updateWhy();
  void tellStory();
  void hearStory(const std::shared_ptr<const WallStory>& story, bool kept);
  void showWindows();
  void forgetStory();

  const Shell& shell_;
  MapCanvas& canvas_;
  MapDocument& document_;
  const SourceActions& sources_;
  RunController& run_;
  RunOverlays& overlays_;
  RunPanels panels_;
  RunStrip* strip_;
  FollowRobot* follow_;
  RobotPointer* pointer_;
  StoryTeller teller_;
  std::shared_ptr<const WallStory> story_;
  QTimer story_later_;  ///< the answer to what is asked, again
};

}  // namespace handmap
