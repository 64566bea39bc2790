// Changing the past of a run: another drawing, a pose that is given, a building that is right or
// not there. The run is done again from what was perceived; the person takes what comes of it, or
// keeps what is.
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "app/gui/run/act_recorder.h"
#include "app/gui/run/said_acts.h"
#include "app/gui/shell/shell.h"
#include "core/method/snapshot.h"
#include "core/recording/trajectory.h"
#include "widgets/background/time_left.h"
#include "widgets/run/worker/run_worker.h"

class QGraphicsScene;

namespace handmap {

class MapCanvas;
class MapDocument;
class PathItem;
class PlaybackActions;
class RunController;
class SaidPanel;
class Toolbox;

/// How the results of two runs over the same observations differ, in plain words.
QString differenceInWords(const Snapshot& before, const Snapshot& after);

class RevisionActions : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY(RevisionActions)
 public:
  /// What it is given must outlive it.
  RevisionActions(const Shell& shell, MapDocument& document, RunController& run, MapCanvas& canvas,
                  Toolbox& tools, PlaybackActions& past, SaidPanel& panel);
  ~RevisionActions() override;

  QString whyNot() const;
  void updateActions();
  std::vector<Act> acts() const;  ///< that were said of this run
  /// In place of those that were given.
  void takePoses(const std::vector<StampedPose>& poses);

 private:
  enum class Then { Ask, Take };

  /// With the drawing as it is now.
  void revise(const std::vector<StampedPose>& given, Then then, const QString& text);
  void say(const std::vector<Said>& said, const QString& text, const QString& doing,
           const std::function<void()>& change = {});
  void give(double time_s, const Pose2& pose);
  /// Where the recording of a live drive lies; empty: there is none, or it is broken.
  std::filesystem::path recordingFolder() const;
  QString inWords(const Said& said) const;
  double shownTime() const;
  void setRight();
  void removeNotThere();
  void onReady();
  void onWanted();
  void connectSaid();
  void forget();

  const Shell& shell_;
  MapDocument& document_;
  RunController& run_;
  MapCanvas& canvas_;
  Toolbox& tools_;
  PlaybackActions& past_;
  SaidPanel& panel_;
  SaidActs acts_;
  std::unique_ptr<PathItem> outcome_;  ///< of a revision that is not taken yet
  Then then_ = Then::Ask;
  QString text_;
  TimeLeft left_;
  ActRecorder recorder_;
};

}  // namespace handmap
