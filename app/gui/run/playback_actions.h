// Looking back: the timeline, and the keys that go back, on and around in the past of a run.
#pragma once

#include <QObject>

#include "app/gui/shell/shell.h"
#include "widgets/run/worker/playback.h"

namespace handmap {

class RunController;
class TransportBar;

class PlaybackActions : public QObject {
  Q_OBJECT
 public:
  /// What it is given must outlive it.
  PlaybackActions(const Shell& shell, RunController& run, TransportBar& transport,
                  QObject* parent = nullptr);

  Playback& playback() { return playback_; }
  const Playback& playback() const { return playback_; }
  /// Of the latest run, or of none; its marks are those that follow.
  void begin();
  /// The latest run has so much of a past now.
  void onNews(const std::vector<FrameReport>& reports, int done, int count);
  void onSkipped(int frame, const QString& reason);
  void showGiven(const std::vector<StampedPose>& given);

  /// To a moment of the past; one that is still to come is computed first. The run stands still,
  /// if its robot is not live.
  void seek(int index);
  void seekTime(double time_s);
  void updateActions();

 Q_SIGNALS:
  /// Something that was marked on the timeline.
  void noted(double time_s, const QString& text);

 private:
  void markGap(const FrameReport& report, int index);

  const Shell& shell_;
  RunController& run_;
  TransportBar& transport_;
  Playback playback_;
  std::optional<FrameReport> last_report_;
  double usual_step_s_ = 0.0;  ///< between observations
  int done_ = 0;
};

}  // namespace handmap
