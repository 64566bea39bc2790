// What a person has to know of a live drive without looking for it, in the message bar: that
// nothing is observed any more, that the robot is lost, that its recording had to end. And of a
// drive that was cut off: what is left of it.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>

#include "app/gui/shell/shell.h"
#include "core/rig/rig_monitor.h"
#include "core/session/lost_and_found.h"
#include "widgets/background/background.h"

namespace handmap {

class RunController;
class SourceActions;

class LiveWatch : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(LiveWatch)
 public:
  /// All must outlive it.
  LiveWatch(const Shell& shell, RunController& run, SourceActions& sources,
            QObject* parent = nullptr);
  ~LiveWatch() override;

  /// Offers the recording of a drive that ended with the program, where there is one.
  void offerCutOff();

 private:
  void follow();
  void look();
  void tellSilence(const RigStatus& status, double now_s);
  void tellRecording(const RecordingStatus& recording);
  void tellLost(LostAndFound::News news, bool start_refuted);
  void note(const QString& folder);

  const Shell& shell_;
  RunController& run_;
  SourceActions& sources_;
  QSettings& settings_;  ///< outlives the window and what its shell names
  QTimer timer_;
  QString noted_;     ///< the folder that this window records into
  int silent_s_ = 0;  ///< as it was told
  bool is_told_ended_ = false;
  LostAndFound lost_;                          ///< of this drive
  std::shared_ptr<Lifeline<LiveWatch>> self_;  ///< shared with the thread that reads
};

}  // namespace handmap
