// Everything that shows a run beside the canvas' items, kept in step with what the canvas shows:
// the line of words, the view that follows, charts, table, log, and why a wall stands where it is.
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "app/gui/run/story_teller.h"

namespace handmap {

class ActionSet;
class Docks;
class FollowRobot;
class MapCanvas;
class MapDocument;
class RunController;
class RunOverlays;
class RunStrip;
struct Phase;
struct Snapshot;

class RunViews : public QObject {
  Q_OBJECT
 public:
  /// All of it must outlive this object.
  struct Parts {
    MapCanvas& canvas;
    MapDocument& document;
    RunController& run;
    RunOverlays& overlays;
    Docks& docks;
    ActionSet& actions;
  };
  RunViews(const Parts& parts, QObject* parent);

  /// A run begins: what it is compared with.
  void begin();
  /// In the middle of an observation; until the next snapshot is shown.
  void showPhase(const Phase& phase, int number, int count);

 Q_SIGNALS:
  /// Somebody wants to see that moment of the recording.
  void timeChosen(double time_s);

 private:
  void connectFollowing();
  void connectTable();
  void connectWhy();
  void show(const Snapshot& snapshot);
  void clear();
  void showBuilding(const QString& id);
  void tellStory();
  void hearStory(const std::shared_ptr<const WallStory>& story, bool kept);
  void showWindows();
  void forgetStory();

  Parts parts_;
  RunStrip* strip_;
  FollowRobot* follow_;
  StoryTeller teller_;
  std::shared_ptr<const WallStory> story_;
  QTimer story_later_;  ///< the answer to what is asked, again
};

}  // namespace handmap
