// Opens recordings and files of poses, and makes worlds of drawings, in threads of their own: a big
// one takes its time.
#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <memory>
#include <stop_token>
#include <variant>

#include "app/gui/run/robot.h"
#include "core/bag_import/bag_plan.h"
#include "core/logs/log.h"
#include "core/plausibility/doubt.h"
#include "core/recording/recording.h"
#include "core/session/acts.h"
#include "widgets/background/background.h"
#include "widgets/background/failure.h"

namespace handmap {

class RecordingOpener : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(RecordingOpener)
 public:
  explicit RecordingOpener(QObject* parent = nullptr);
  ~RecordingOpener() override;

  /// What was asked for before is forgotten, and ends.
  void open(const QString& folder);
  /// The same recording, read as it is likely meant.
  void readAgain(const std::shared_ptr<const Recording>& recording, const Remedy& remedy,
                 const std::vector<Act>& acts);
  /// Makes a recording of a log in that new folder and opens it.
  void import(const std::shared_ptr<const Log>& log, const QString& folder);
  /// The same of a bag, whose topics serve as told.
  void import(const std::shared_ptr<const Bag>& bag, const ToldTopics& topics,
              const QString& folder);
  /// The same of a drive of KITTI's raw data.
  void importDrive(const QString& drive, const QString& folder);
  void openPoses(const QString& tum_file);
  /// See simulationOfDrawing().
  void simulate(const Map& drawing, std::uint64_t seed);
  void forget();
  /// What was asked for of a drawing that is gone.
  void forgetSimulation();

 Q_SIGNALS:
  /// With what a person said while it was made, what in its numbers is likely not meant so, and
  /// what its import took for granted or left out.
  void opened(const std::shared_ptr<const handmap::Recording>& recording,
              const std::vector<handmap::Act>& acts, const handmap::Doubts& doubts,
              const std::vector<std::string>& notes);
  void posesOpened(const std::vector<handmap::StampedPose>& poses);
  void simulated(const handmap::Robot& robot);
  void failed(const handmap::Failure& failure);

 private:
  struct Opened {
    std::shared_ptr<const Recording> recording;
    std::vector<Act> acts;
    Doubts doubts;
    std::vector<std::string> notes = {};
  };
  using Poses = std::vector<StampedPose>;
  using Answer = std::variant<Opened, Poses, Robot, Failure>;

  /// Of a recording that is made of something else.
  struct Making {
    std::filesystem::path folder;
    std::string name;
    std::vector<std::string>& notes;
    std::stop_token stop;
  };
  void make(const QString& folder, std::function<void(const Making& making)> write);
  void begin(std::function<Answer()> open);

  bool simulates_ = false;                           ///< the latest request
  int request_ = 0;                                  ///< an answer to another one is dropped
  std::stop_source stop_;                            ///< of the latest
  std::shared_ptr<Lifeline<RecordingOpener>> self_;  ///< shared with the threads
};

}  // namespace handmap
