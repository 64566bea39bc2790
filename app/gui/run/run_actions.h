// What the Run menu and the transport do, and what a run shows: the one place where the run meets
// the widgets.
#pragma once

#include <QObject>
#include <optional>

#include "app/gui/run/demonstration.h"
#include "app/gui/run/playback_actions.h"
#include "app/gui/run/recording_opener.h"
#include "app/gui/run/run_controller.h"
#include "app/gui/run/run_score.h"
#include "widgets/run/worker/phase_stepper.h"

class QSettings;
class QWidget;

namespace handmap {

class ActionSet;
class BuildingsPanel;
class CameraPanel;
class ChartsPanel;
class Dialogs;
class FileActions;
class LayersPanel;
class MapDocument;
class MessageBar;
class RunOverlays;
class RunSetupPanel;
class TransportBar;

class RunActions : public QObject {
  Q_OBJECT
 public:
  /// All of it must outlive this object.
  struct Parts {
    QWidget& window;
    MapDocument& document;
    RunController& run;
    FileActions& files;
    ActionSet& actions;
    MessageBar& messages;
    QSettings& settings;
    Dialogs& dialogs;
    RunOverlays& overlays;
    TransportBar& transport;
    LayersPanel& layers;
    RunSetupPanel& setup;
    ChartsPanel& charts;
    CameraPanel& camera;
    BuildingsPanel& buildings;
  };
  explicit RunActions(const Parts& parts);

  void openRecording(const QString& folder);
  /// False: the user wants to keep the drawing.
  bool openDemonstration();
  bool openTwoRows();
  /// A live robot that is simulated, among two rows of buildings; it starts when the run does.
  bool openVirtualRig(VirtualRigKind kind = VirtualRigKind::Laser);
  void askForRecording();
  void setRobot(Robot robot);

  /// From the drawing, or on from a pause.
  void runOrResume();

  PlaybackActions& past() { return past_; }

  /// The latest run against the truth. nullopt before its first step.
  std::optional<RunScore> score() const;
  /// E.g. "Running, 12 of 60".
  QString stateInWords() const;

 Q_SIGNALS:
  void stateChanged();  ///< stateInWords()
  void robotChanged();
  void runBegan(bool has_camera);
  void runForgotten();
  /// The run is to be done again with them.
  void posesGiven(const std::vector<handmap::StampedPose>& poses);
  /// In the middle of an observation.
  void phaseShown(const handmap::Phase& phase, int number, int count);
  /// A recording could not be opened, or the run failed; the user has been told.
  void failed(const handmap::Failure& failure);

 private:
  void connectActions();
  void connectRun();
  void addSimulatorMenu();
  void start(RunController::Begin begin);
  bool openSimulation(const Demonstration& simulation);
  void simulateDrawing();
  void askForPoses();
  void usePoses(const std::vector<StampedPose>& poses);
  void tellActs();
  RunSetup redoActs();
  void acceptRefinement();
  void onDrawingReplaced();
  void onSourceOpened(std::shared_ptr<const SourceInfo> source);
  void onNews(const RunNews& news);
  void onRevised();
  void show(const std::shared_ptr<const Snapshot>& snapshot);
  void nextPhase();
  void onFinished(bool cancelled);
  void onFrameSkipped(int frame, const QString& reason);
  void updateActions();
  /// False, and the user knows: there is nothing that a robot could be found on.
  bool isReady(bool may_start_on_route);
  /// Of a run at its end; true: there was something to tell.
  bool warnOfResult();
  /// A button on the latest message.
  void offer(const QString& action, const QString& text);
  void fail(const Failure& failure);
  std::uint64_t seed() const;

  Parts parts_;
  PlaybackActions past_;
  PhaseStepper phases_;
  bool phases_wanted_ = false;  ///< of the next snapshot
  RecordingOpener opener_;
  std::optional<Robot> robot_;
  std::shared_ptr<const SourceInfo> source_;  ///< of the latest run
  std::shared_ptr<const Snapshot> last_;      ///< of the latest run: its newest
  std::shared_ptr<const Snapshot> shown_;     ///< what is looked at
  std::vector<StampedPose> given_poses_;      ///< of the runs that begin with this robot
  int skipped_ = 0;
  bool finished_ = false;  ///< the latest run came to its end
};

}  // namespace handmap
