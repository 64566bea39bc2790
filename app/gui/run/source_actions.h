// What a run gets its observations from: a recording, a simulator or a live robot, and what a
// person has said about it.
#pragma once

#include <QObject>
#include <optional>

#include "app/gui/run/demonstration.h"
#include "app/gui/run/recording_opener.h"
#include "app/gui/shell/shell.h"
#include "widgets/run/panels/run_setup_panel.h"
#include "widgets/run/panels/timeline.h"

namespace handmap {

class FileActions;
class MapDocument;
class RunController;

class SourceActions : public QObject {
  Q_OBJECT
 public:
  /// What it is given must outlive it.
  SourceActions(const Shell& shell, MapDocument& document, FileActions& files, RunController& run,
                RunSetupPanel& setup);

  /// With what was asked for of it the last time, or with `replay`.
  void openRecording(const QString& folder, std::optional<ReplayOptions> replay = {});
  /// False: the user wants to keep the drawing.
  bool openDemonstration();
  bool openTwoRows();
  /// Through the drawing where there is one, else two rows of buildings.
  void openSimulator();
  /// A live robot that is simulated, among two rows of buildings; it starts when the run does.
  bool openVirtualRig(VirtualRigKind kind = VirtualRigKind::Laser);
  void askForRecording();
  /// Shows what the log of another program holds; once it is right, makes a recording of it. Also
  /// of the folder of a bag or of a drive of KITTI's raw data.
  void importLog(const QString& file);
  /// Of the names of logs, without dots.
  static const QStringList& logEndings();
  static QString logFilter();
  void setRobot(Robot robot);
  /// The same of a live one, and says what is to be done.
  void useLive(Robot robot);
  /// The part of the recording that the next run takes. nullopt: there is no recording.
  std::optional<TimelineTrim> trim() const;
  void setTrim(int from, int to);

  /// nullopt: none is chosen yet.
  const std::optional<Robot>& robot() const { return robot_; }
  /// False, and the user knows: there is nothing that a robot could be found on.
  bool isReady(bool may_start_on_route = false);
  /// As the panel says, with what a person said on that drive or gave for the next run. The drawing
  /// is changed as it was on the drive, which can be undone.
  RunSetup nextSetup();

  void tell(const Failure& failure);

 Q_SIGNALS:
  void robotChanged();
  void trimChanged();
  /// The demonstration is best watched at this speed, times the clock of the robot.
  void speedWanted(double speed);
  /// The run is to be done again with them.
  void posesGiven(const std::vector<handmap::StampedPose>& poses);
  /// A recording could not be opened, or the run failed; the user has been told.
  void failed(const handmap::Failure& failure);

 private:
  /// What a drawing needs before a robot can be found on it, and the action that leads there.
  struct Missing {
    const char* message;
    const char* hint;
    const char* action;
    const char* offer;
  };
  /// nullptr: nothing.
  const Missing* missing(bool may_start_on_route = false) const;
  void addSimulatorMenu();
  void onOpened(const std::shared_ptr<const Recording>& recording, const std::vector<Act>& acts,
                const Doubts& doubts, const std::vector<std::string>& notes);
  void tellNotes(const std::vector<std::string>& notes);
  void withdrawDoubts();
  void tellDoubts(const std::shared_ptr<const Recording>& recording, const std::vector<Act>& acts,
                  const Doubts& doubts);
  bool openSimulation(const Demonstration& simulation);
  void simulateDrawing();
  QString recordingFolder() const;
  QString chosenLog();
  void importBag(const QString& file);
  void importDrive(const QString& folder);
  QString folderForImport(const QString& file);
  void askForPoses();
  void usePoses(const std::vector<StampedPose>& poses);
  void tellActs();
  void onDrawingReplaced();
  void updateActions();
  std::uint64_t seed() const;

  const Shell& shell_;
  MapDocument& document_;
  FileActions& files_;
  RunController& run_;
  RunSetupPanel& setup_;
  RecordingOpener opener_;
  std::optional<Robot> robot_;
  std::optional<ReplayOptions> asked_replay_;  ///< of the recording that is being opened
  std::vector<StampedPose> given_poses_;       ///< of the runs that begin with this robot
};

}  // namespace handmap
