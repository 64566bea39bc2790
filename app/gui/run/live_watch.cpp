#include "app/gui/run/live_watch.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSettings>
#include <algorithm>
#include <csignal>
#include <utility>

#include "app/gui/run/live_robot.h"
#include "app/gui/run/run_controller.h"
#include "app/gui/run/source_actions.h"
#include "core/recording/recording.h"
#include "widgets/messages/message_bar.h"

namespace handmap {

namespace {

constexpr int kLook_ms = 250;
constexpr double kSpinUp_s = 8.0;  // of a scanner, until it turns
constexpr auto kSilentTopic = "live_silent";
constexpr auto kLostTopic = "live_lost";
constexpr auto kCutOffTopic = "live_cut_off";
constexpr auto kFolderKey = "live/recording";  // while one is written
constexpr auto kProcessKey = "live/process";

/// Another window may be recording yet.
bool isAlive(qint64 process) { return process > 0 && kill(static_cast<pid_t>(process), 0) == 0; }

/// What is wrong with what the robot sees with, or drives on; empty where the devices know nothing.
QString whySilent(const RigStatus& status) {
  for (const DeviceRole role :
       {DeviceRole::Scanner, DeviceRole::Camera, DeviceRole::Head, DeviceRole::Odometry}) {
    for (const DeviceStatus& device : status.devices) {
      // One that is ready tells its name there.
      if (device.role == role && device.state != DeviceState::Ready && !device.detail.empty())
        return QString::fromStdString(device.detail);
    }
  }
  return QString::fromStdString(status.last_refusal);
}

bool knowsMotion(const RigStatus& status) {
  return std::any_of(status.devices.begin(), status.devices.end(), [](const DeviceStatus& device) {
    return device.role == DeviceRole::Odometry && device.state == DeviceState::Ready;
  });
}

/// Seconds since something was observed that should have been since. Between two stops a robot with
/// a head is silent as it should be, unless something of it is gone.
double silence(const RigStatus& status, double now_s) {
  bool has_head = false;
  double gone_s = 0.0;
  for (const DeviceStatus& device : status.devices) {
    if (device.role > DeviceRole::Head) continue;
    has_head = has_head || device.role == DeviceRole::Head;
    if (device.state == DeviceState::Lost) gone_s = std::max(gone_s, device.age_s.value_or(now_s));
  }
  if (!status.observation_age_s) return now_s < kSpinUp_s ? 0.0 : has_head ? gone_s : now_s;
  return has_head ? gone_s : *status.observation_age_s;
}

}  // namespace

LiveWatch::LiveWatch(const Shell& shell, RunController& run, SourceActions& sources,
                     QObject* parent)
    : QObject(parent),
      shell_(shell),
      run_(run),
      sources_(sources),
      settings_(shell.settings),
      self_(std::make_shared<Lifeline<LiveWatch>>(*this)) {
  connect(&timer_, &QTimer::timeout, this, &LiveWatch::look);
  connect(&run_, &RunController::begun, this, [this] {
    silent_s_ = 0;
    is_told_ended_ = false;
    lost_ = {};
  });
  connect(&run_, &RunController::stateChanged, this, &LiveWatch::follow);
  connect(&run_, &RunController::newsArrived, this, [this](const RunNews& news) {
    if (run_.live() && run_.isActive()) {
      tellLost(lost_.hear(news.newest->report), news.newest->report.start_refuted);
    }
  });
}

LiveWatch::~LiveWatch() {
  self_->cut();
  note({});
}

void LiveWatch::follow() {
  if (run_.live() && run_.isActive()) {
    if (!timer_.isActive()) timer_.start(kLook_ms);
    return;
  }
  if (!timer_.isActive()) return;
  timer_.stop();
  note({});
  for (const char* topic : {kSilentTopic, kLostTopic}) shell_.messages.withdraw(topic);
}

void LiveWatch::look() {
  const auto link = run_.live();
  const auto monitor = link ? link->monitor() : nullptr;
  if (!monitor) return;
  const RigStatus status = monitor->status();
  if (run_.state() != RunState::Stopping) tellSilence(status, monitor->now());
  tellRecording(status.recording);
}

void LiveWatch::tellSilence(const RigStatus& status, double now_s) {
  const int silent_s = static_cast<int>(silence(status, now_s));
  const int told_s = std::exchange(silent_s_, silent_s);
  if (silent_s == told_s) return;
  if (silent_s == 0) return shell_.messages.withdraw(kSilentTopic);
  const QString words =
      !status.observation_age_s ? tr("Nothing has been observed yet, after %1 s.")
      : knowsMotion(status)
          ? tr("Nothing has been observed for %1 s: the robot is shown by its odometry alone.")
          : tr("Nothing has been observed for %1 s, and nothing tells where the robot drives.");
  shell_.messages.show(MessageBar::Kind::Warning, words.arg(silent_s), whySilent(status),
                       kSilentTopic);
}

void LiveWatch::tellLost(LostAndFound::News news, bool start_refuted) {
  if (news == LostAndFound::News::Lost) {
    shell_.messages.show(MessageBar::Kind::Warning,
                         start_refuted ? tr("The robot is not where the drive is said to begin: "
                                            "it sees something else than it saw there before.")
                                       : tr("It is no longer known where the robot is."),
                         tr("If you see it, say so with “Robot is here”."), kLostTopic);
  } else if (news == LostAndFound::News::Found) {
    shell_.messages.show(MessageBar::Kind::Info, tr("It is known again where the robot is."), {},
                         kLostTopic);
  }
}

void LiveWatch::tellRecording(const RecordingStatus& recording) {
  if (recording.error.empty()) return note(QString::fromStdString(recording.folder));
  note({});
  if (std::exchange(is_told_ended_, true)) return;
  shell_.messages.show(MessageBar::Kind::Error, tr("The recording has ended, the drive goes on."),
                       QString::fromStdString(recording.error));
}

/// So that the next start knows of it, whatever becomes of this one.
void LiveWatch::note(const QString& folder) {
  if (folder == noted_) return;
  noted_ = folder;
  if (folder.isEmpty()) {
    settings_.remove(kFolderKey);
    settings_.remove(kProcessKey);
  } else {
    settings_.setValue(kFolderKey, QFileInfo(folder).absoluteFilePath());
    settings_.setValue(kProcessKey, QCoreApplication::applicationPid());
  }
  settings_.sync();
}

void LiveWatch::offerCutOff() {
  const QString folder = settings_.value(kFolderKey).toString();
  const qint64 process = settings_.value(kProcessKey).toLongLong();
  if (folder.isEmpty() || isAlive(process)) return;
  settings_.remove(kFolderKey);
  settings_.remove(kProcessKey);
  startInBackground([self = self_, folder] {
    int rows = 0;
    try {
      rows = static_cast<int>(openRecording(folder.toStdString()).rows.size());
    } catch (const std::exception&) {
      return;  // it ended before its first observation
    }
    self->post([folder, rows](LiveWatch& watch) {
      Message& message = watch.shell_.messages.ask(
          tr("The program ended in the middle of a drive. Its recording is whole, up to its last "
             "observation: %n of them.",
             nullptr, rows),
          folder, kCutOffTopic);
      message.addAction(tr("Open it"), [&watch, folder] { watch.sources_.openRecording(folder); });
    });
  });
}

}  // namespace handmap
