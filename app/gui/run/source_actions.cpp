#include "app/gui/run/source_actions.h"

#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QSettings>

#include "app/gui/files/file_actions.h"
#include "app/gui/run/recording_settings.h"
#include "app/gui/run/run_controller.h"
#include "core/kitti_raw/kitti_raw.h"
#include "core/map/places.h"
#include "core/session/redone_acts.h"
#include "widgets/actions/action_set.h"
#include "widgets/document/map_document.h"
#include "widgets/importing/bag_dialog.h"
#include "widgets/importing/import_dialog.h"
#include "widgets/messages/dialogs.h"
#include "widgets/messages/message_bar.h"

namespace handmap {

namespace {

const QString kDoubtTopic = QStringLiteral("recording-doubt-");
constexpr auto kRecordingFolderKey = "files/recording_folder";
constexpr auto kStartTopic = "where_it_starts";
constexpr auto kNotReadyTopic = "not ready";
constexpr auto kImportTopic = "import";
constexpr auto kNotesTopic = "import notes";

}  // namespace

SourceActions::SourceActions(const Shell& shell, MapDocument& document, FileActions& files,
                             RunController& run, RunSetupPanel& setup)
    : QObject(&shell.window),
      shell_(shell),
      document_(document),
      files_(files),
      run_(run),
      setup_(setup),
      opener_(this) {
  shell_.actions.on("run.open_recording", this, [this] { askForRecording(); });
  shell_.actions.on("file.import_log", this, [this] {
    if (const QString file = chosenLog(); !file.isEmpty()) importLog(file);
  });
  shell_.actions.on("run.load_poses", this, [this] { askForPoses(); });
  addSimulatorMenu();
  shell_.actions.on("run.simulate", this, [this] { simulateDrawing(); });
  connect(&document_, &MapDocument::mapChanged, this, [this] {
    if (!missing()) shell_.messages.withdraw(kNotReadyTopic);
  });
  connect(&files_, &FileActions::drawingReplaced, this, &SourceActions::onDrawingReplaced);
  connect(&run_, &RunController::failed, this, &SourceActions::tell);
  connect(&opener_, &RecordingOpener::opened, this, &SourceActions::onOpened);
  connect(&opener_, &RecordingOpener::posesOpened, this, &SourceActions::usePoses);
  connect(&opener_, &RecordingOpener::simulated, this, &SourceActions::setRobot);
  connect(&opener_, &RecordingOpener::failed, this, &SourceActions::tell);
  connect(&document_, &MapDocument::mapChanged, this, [this] {
    if (document_.map().start) shell_.messages.withdraw(kStartTopic);
  });
  connect(&setup_, &RunSetupPanel::replayChanged, this, [this] {
    if (robot_ && !robot_->folder.isEmpty())
      keepSettingsOfRecording(shell_.settings, robot_->folder, setup_.replay());
    Q_EMIT trimChanged();
  });
  updateActions();
}

void SourceActions::addSimulatorMenu() {
  auto* menu = new QMenu(&shell_.window);
  menu->addAction(tr("&Two rows of buildings"), this, &SourceActions::openTwoRows);
  menu->addAction(tr("A &campus"), this, [this] { openSimulation(campusSimulation(seed())); });
  menu->addAction(tr("&Around a campus"), this, [this] { openSimulation(loopSimulation(seed())); });
  menu->addAction(tr("A &quarter with fences and hedges"), this,
                  [this] { openSimulation(quarterSimulation(seed())); });
  menu->addAction(&shell_.actions["run.simulate"]);
  menu->addSeparator();
  menu->addAction(tr("A &live robot (virtual rig)"), this, [this] { openVirtualRig(); });
  menu->addAction(tr("A live robot with a &stereo head"), this,
                  [this] { openVirtualRig(VirtualRigKind::StereoHead); });
  menu->addAction(tr("The d&emonstration"), this, &SourceActions::openDemonstration);
  shell_.actions["run.simulator"].setMenu(menu);
  shell_.actions.on("run.simulator", this, [this, menu] {  // by its key
    menu->popup(shell_.window.mapToGlobal(shell_.window.rect().center()));
  });
}

std::uint64_t SourceActions::seed() const { return setup_.setup().settings.seed; }

void SourceActions::tell(const Failure& failure) {
  shell_.messages.withdraw(kImportTopic);
  shell_.messages.show(MessageBar::Kind::Error, failure.message, failure.hint);
  Q_EMIT failed(failure);
}

void SourceActions::setRobot(Robot robot) {
  run_.discard();
  opener_.forget();
  withdrawDoubts();
  robot_ = std::move(robot);
  given_poses_.clear();
  const QString& folder = robot_->folder;
  if (!folder.isEmpty() && !asked_replay_)
    setup_.setReplay(settingsOfRecording(shell_.settings, folder));
  else if (!robot_->live)
    setup_.setReplay(asked_replay_.value_or(ReplayOptions()));
  asked_replay_.reset();
  updateActions();
  Q_EMIT robotChanged();
  Q_EMIT trimChanged();
}

std::optional<TimelineTrim> SourceActions::trim() const {
  if (!robot_ || robot_->first_frame >= robot_->last_frame) return std::nullopt;
  const ReplayOptions replay = setup_.replay();
  const auto frame = [this](int wanted) {
    return std::clamp(wanted, robot_->first_frame, robot_->last_frame);
  };
  return TimelineTrim{robot_->first_frame, robot_->last_frame, frame(replay.from),
                      frame(replay.to.value_or(robot_->last_frame))};
}

/// What is not trimmed is told as that, so that a recording that grows is taken to its end.
void SourceActions::setTrim(int from, int to) {
  if (!robot_) return;
  ReplayOptions replay = setup_.replay();
  replay.from = from > robot_->first_frame ? from : 0;
  replay.to = to < robot_->last_frame ? std::optional(to) : std::nullopt;
  setup_.setReplay(replay);
  Q_EMIT setup_.replayChanged();
}

void SourceActions::onDrawingReplaced() {
  run_.discard();
  opener_.forgetSimulation();
  shell_.messages.clear();
  if (robot_ && robot_->truth_map) robot_.reset();  // it lived in the drawing before
  updateActions();
}

void SourceActions::updateActions() {
  shell_.actions.setEnabled({"run.load_poses"}, robot_ && !robot_->live,
                            tr("no recording or simulator is open"));
}

// --- Recordings

/// Where the last one was; at first beside the drawing.
QString SourceActions::recordingFolder() const {
  return shell_.settings.value(kRecordingFolderKey, QFileInfo(document_.filePath()).path())
      .toString();
}

void SourceActions::askForRecording() {
  const QString folder = shell_.dialogs.folderToOpen(tr("Open a recording"), recordingFolder());
  if (folder.isEmpty()) return;
  shell_.settings.setValue(kRecordingFolderKey, folder);
  openRecording(folder);
}

const QStringList& SourceActions::logEndings() {
  static const QStringList kEndings = {"log", "clf", "csv", "tum",  "txt",
                                       "npy", "npz", "bag", "mcap", "db3"};
  return kEndings;
}

QString SourceActions::logFilter() {
  return tr("Logs and bags (%1)")
             .arg(QStringLiteral("*.") + logEndings().join(QLatin1String(" *."))) +
         QStringLiteral(";;") + tr("All files (*)");
}

QString SourceActions::chosenLog() {
  return shell_.dialogs.fileToOpen({tr("Import a log"), recordingFolder(), logFilter(), {}, {}});
}

void SourceActions::importBag(const QString& file) {
  auto* dialog = new BagDialog(file, &shell_.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog, file] {
    const QString folder = folderForImport(file);
    if (!folder.isEmpty()) opener_.import(dialog->bag(), dialog->topics(), folder);
  });
  dialog->open();
}

void SourceActions::importDrive(const QString& drive) {
  const QString folder = folderForImport(drive);
  if (!folder.isEmpty()) opener_.importDrive(drive, folder);
}

/// Empty: the user does not want to any more. What is made in it takes the place of the run.
QString SourceActions::folderForImport(const QString& file) {
  const QFileInfo info(file);
  const QString name =
      info.isDir() ? info.baseName() + QStringLiteral("-recording") : info.baseName();
  QString folder =
      shell_.dialogs.fileToSave({tr("A new folder for the recording"), info.path(), {}, name, {}});
  if (folder.isEmpty() || !files_.mayLeaveRun()) return {};
  shell_.messages.show(MessageBar::Kind::Info,
                       tr("A recording is being made of “%1”…").arg(info.fileName()), {},
                       kImportTopic);
  return folder;
}

void SourceActions::importLog(const QString& file) {
  if (isKittiRaw(file.toStdString())) return importDrive(file);
  if (isBag(file.toStdString())) return importBag(file);
  auto* dialog = new ImportDialog({file}, &shell_.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &ImportDialog::anotherFileWanted, dialog,
          [this, dialog] { dialog->add(chosenLog()); });
  connect(dialog, &QDialog::accepted, this, [this, dialog, file] {
    const auto log = dialog->log();
    const QString folder = folderForImport(file);
    if (log && !folder.isEmpty()) opener_.import(log, folder);
  });
  dialog->open();
}

void SourceActions::openRecording(const QString& folder, std::optional<ReplayOptions> replay) {
  if (!files_.mayLeaveRun()) return;
  opener_.open(folder);
  asked_replay_ = std::move(replay);
}

void SourceActions::onOpened(const std::shared_ptr<const Recording>& recording,
                             const std::vector<Act>& acts, const Doubts& doubts,
                             const std::vector<std::string>& notes) {
  shell_.messages.withdraw(kImportTopic);
  // Said first: a run that begins at once takes it away.
  shell_.messages.show(
      MessageBar::Kind::Info,
      tr("“%1” is open: %n frame(s).", nullptr, static_cast<int>(recording->rows.size()))
          .arg(QString::fromStdString(recording->name)),
      document_.map().start ? tr("Press Run to localize on the drawing.")
                            : tr("Draw the buildings and where the robot starts, or open "
                                 "the drawing; then press Run."));
  Robot robot = recordedRobot(recording);
  robot.acts = acts;
  setRobot(std::move(robot));
  tellActs();
  tellDoubts(recording, acts, doubts);
  tellNotes(notes);
}

void SourceActions::tellNotes(const std::vector<std::string>& notes) {
  shell_.messages.withdraw(kNotesTopic);
  if (notes.empty()) return;
  QStringList lines;
  for (const std::string& note : notes) lines << QString::fromStdString(note);
  shell_.messages.show(MessageBar::Kind::Warning, tr("Of what was imported:"), lines.join(u'\n'),
                       kNotesTopic);
}

void SourceActions::withdrawDoubts() {
  for (const Message* message : shell_.messages.messages()) {
    const QString topic = message->topic();
    if (topic.startsWith(kDoubtTopic)) shell_.messages.withdraw(topic);
  }
}

/// With a button that reads the recording as it is likely meant, which no later message hides.
void SourceActions::tellDoubts(const std::shared_ptr<const Recording>& recording,
                               const std::vector<Act>& acts, const Doubts& doubts) {
  for (const Doubt& doubt : doubts) {
    Message& message = shell_.messages.show(
        doubt.certain ? MessageBar::Kind::Error : MessageBar::Kind::Warning,
        QString::fromStdString(doubt.message), QString::fromStdString(doubt.hint),
        kDoubtTopic + QString::fromStdString(doubt.code));
    if (doubt.certain || doubt.remedy) message.setQuestion();  // it stays over a run
    if (!doubt.remedy) continue;
    message.addAction(QString::fromStdString(doubt.remedy->name),
                      [this, recording, acts, remedy = *doubt.remedy] {
                        withdrawDoubts();
                        opener_.readAgain(recording, remedy, acts);
                      });
    break;  // the others are looked for anew then
  }
}

void SourceActions::tellActs() {
  const auto count = static_cast<int>(robot_->acts.size());
  if (count == 0) return;
  shell_.messages
      .show(MessageBar::Kind::Info,
            tr("On that drive somebody said %n thing(s): where the robot was, or which building "
               "is right or not there. The run does it again.",
               nullptr, count))
      .addAction(tr("Leave it out"), [this, acts = robot_->acts] {
        if (robot_ && robot_->acts == acts) robot_->acts.clear();
      });
}

// --- Simulators

bool SourceActions::openSimulation(const Demonstration& simulation) {
  if (!files_.replace(simulation.sketch)) return false;
  setRobot(simulation.robot);
  return true;
}

bool SourceActions::openDemonstration() {
  if (!openSimulation(demonstration())) return false;
  Q_EMIT speedWanted(kDemonstrationSpeed);
  return true;
}

bool SourceActions::openVirtualRig(VirtualRigKind kind) {
  return openSimulation(liveSimulation(seed(), kind));
}

/// A drawing that there is is what the robot is to drive through.
void SourceActions::openSimulator() {
  document_.map().buildings.empty() ? void(openTwoRows()) : simulateDrawing();
}

bool SourceActions::openTwoRows() { return openSimulation(twoRowSimulation(seed())); }

void SourceActions::simulateDrawing() {
  if (isReady(true) && files_.mayLeaveRun()) opener_.simulate(document_.map(), seed());
}

// --- Poses that are given

void SourceActions::askForPoses() {
  const QString file = shell_.dialogs.fileToOpen({tr("Open poses of the robot"),
                                                  recordingFolder(),
                                                  tr("Poses in TUM form (*.tum *.txt)"),
                                                  {},
                                                  {}});
  if (!file.isEmpty()) opener_.openPoses(file);
}

/// The run that there is, is done again with them; else the next one goes through them.
void SourceActions::usePoses(const std::vector<StampedPose>& poses) {
  given_poses_ = poses;
  if (run_.canRevise()) return Q_EMIT posesGiven(poses);
  shell_.messages
      .show(MessageBar::Kind::Info, tr("The next run goes through %n given pose(s).", nullptr,
                                       static_cast<int>(poses.size())))
      .addAction(tr("Forget them"), [this] { given_poses_.clear(); });
}

// --- Before a run

RunSetup SourceActions::nextSetup() {
  RunSetup setup = setup_.setup();
  setup.settings.given_poses = given_poses_;
  if (robot_->acts.empty()) return setup;
  const RedoneActs done = redone(document_.map(), robot_->acts);
  MapChange changed;
  QStringList gone;
  const auto places = placesOf(done.drawing.buildings);
  for (const Building& building : document_.map().buildings) {
    const auto now = places.find(building.id);
    if (now == places.end())
      gone << QString::fromStdString(building.id);
    else if (!(done.drawing.buildings[now->second] == building))
      changed.buildings.push_back(done.drawing.buildings[now->second]);
  }
  if (!changed.isEmpty()) document_.apply(changed, tr("Buildings that are right"));
  if (!gone.isEmpty()) document_.remove(gone);
  if (setup.settings.given_poses.empty()) setup.settings.given_poses = done.poses;
  return setup;
}

void SourceActions::useLive(Robot robot) {
  const QString text = tr("“%1” is the robot now.").arg(robot.name);
  const bool has_start = document_.map().start.has_value();
  // Said first: a run that begins at once takes it away.
  if (has_start) {
    shell_.messages.show(MessageBar::Kind::Info, text, tr("Press Run; Stop ends the drive."));
  } else {
    shell_.messages
        .show(MessageBar::Kind::Info, text,
              tr("Draw where it starts: press, drag to where it looks, release. Then press Run; "
                 "Stop ends the drive."),
              kStartTopic)
        .addAction(tr("Place the start"), [this] { shell_.actions["draw.start"].trigger(); });
  }
  setRobot(std::move(robot));
  if (!has_start) shell_.actions["draw.start"].trigger();  // what is pressed next is no house
}

const SourceActions::Missing* SourceActions::missing(bool may_start_on_route) const {
  static constexpr Missing kBuildings{
      QT_TR_NOOP("There are no buildings yet to find the robot among."),
      QT_TR_NOOP("Draw at least one that the robot comes by."), "draw.rectangle",
      QT_TR_NOOP("Draw")};
  static constexpr Missing kStart{
      QT_TR_NOOP("The map has no start."),
      QT_TR_NOOP("Press where the robot begins, drag to where it looks, release."), "draw.start",
      QT_TR_NOOP("Place the start")};
  const Map& drawing = document_.map();
  if (drawing.buildings.empty()) return &kBuildings;
  return drawing.start || (may_start_on_route && !drawing.route.empty()) ? nullptr : &kStart;
}

bool SourceActions::isReady(bool may_start_on_route) {
  const Missing* what = missing(may_start_on_route);
  if (what == nullptr) return true;
  shell_.messages.show(MessageBar::Kind::Error, tr(what->message), tr(what->hint), kNotReadyTopic)
      .addAction(tr(what->offer), [this, what] { shell_.actions[what->action].trigger(); });
  Q_EMIT failed({ErrorCode::BadInput, tr(what->message), tr(what->hint)});
  return false;
}

}  // namespace handmap
