// Run, pause, step, stop, and going through the phases of a step: what the transport does, and what
// of a run it has shown.
#pragma once

#include <QObject>
#include <QTimer>

#include "app/gui/run/drive_start.h"
#include "app/gui/run/playback_actions.h"
#include "app/gui/run/run_controller.h"
#include "widgets/run/worker/phase_stepper.h"

namespace handmap {

class FileActions;
class MapDocument;
class RunViews;
class SourceActions;

class TransportActions : public QObject {
  Q_OBJECT
 public:
  /// What it is given must outlive it.
  TransportActions(const Shell& shell, MapDocument& document, FileActions& files,
                   SourceActions& sources, RunController& run, RunViews& views,
                   TransportBar& transport);

  /// From the drawing, or on from a pause.
  void runOrResume();
  PlaybackActions& past() { return past_; }
  /// E.g. "Running, 12 of 60".
  QString stateInWords() const;

 Q_SIGNALS:
  void stateChanged();  ///< stateInWords()
  /// In the middle of an observation.
  void phaseShown(const handmap::Phase& phase, int number, int count);

 private:
  void connectActions();
  void connectRun();
  void start(RunController::Begin begin);
  void tellTrim();
  QStringList comingBack() const;
  void onNews(const RunNews& news);
  void onRevised();
  void show(const std::shared_ptr<const Snapshot>& snapshot);
  void nextPhase();
  void onFinished(bool cancelled);
  /// The robot or the drawing is another one.
  void forget();
  void update();
  QString whereInWords() const;
  QString openingInWords() const;

  const Shell& shell_;
  MapDocument& document_;
  SourceActions& sources_;
  RunController& run_;
  RunViews& views_;
  TransportBar& transport_;
  PlaybackActions past_;
  DriveStart drive_start_;
  PhaseStepper phases_;
  bool phases_wanted_ = false;             ///< of the next snapshot
  std::shared_ptr<const Snapshot> last_;   ///< of the latest run: its newest
  std::shared_ptr<const Snapshot> shown_;  ///< what is looked at
  QTimer waiting_;
  bool finished_ = false;  ///< the latest run came to its end
};

}  // namespace handmap
