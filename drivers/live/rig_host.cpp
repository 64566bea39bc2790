#include "drivers/live/rig_host.h"

#include <QEventLoop>
#include <QTimer>
#include <exception>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "drivers/live/assembler.h"

namespace handmap {

namespace {

constexpr int kTick_ms = 50;
/// For the last commands to leave: halt, laser off.
constexpr int kRest_ms = 200;

}  // namespace

/// What lives in the thread.
class RigHost::Hosting {
 public:
  using Describe = std::function<void(const std::shared_ptr<const Rectifier>&)>;
  Hosting(const Rig& rig, const MakeDevices& make, RigMonitor& monitor, Inbox& inbox,
          std::atomic<double>& reach_m, Describe describe)
      : monitor_(monitor),
        inbox_(inbox),
        reach_m_(reach_m),
        describe_(std::move(describe)),
        mount_(rig.scanner ? rig.scanner->mount : ScannerMount{}),
        assembler_(rig,
                   {[this](Observation observation) { whole_.push_back(std::move(observation)); },
                    [this](double pan) { look(pan); },
                    [this](const std::string& reason) { monitor_.refused(reason); }}),
        devices_(make(rig, monitor)) {
    connectSensors();
    connectHead();
    QObject::connect(&ticking_, &QTimer::timeout, &context_,
                     [this] { guarded([this] { tick(); }); });
  }

  void open() {
    forEach([](Device& device) { device.open(); });
    ticking_.start(kTick_ms);
  }

  void close() {
    ticking_.stop();
    if (devices_.head) devices_.head->halt();
    forEach([](Device& device) { device.close(); });
  }

 private:
  void tick() {
    if (monitor_.takeLookAround()) assembler_.lookAround();
    assembler_.tick(monitor_.now());
    monitor_.setActivity(assembler_.activity());
  }

  /// What a device says may never end the event loop.
  template <typename Work>
  void guarded(Work work) {
    try {
      work();
    } catch (const std::exception& error) {
      monitor_.refused(phrase("unexpected error"), error.what());
    }
    give();
  }

  template <typename Work>
  void forEach(Work work) {
    if (devices_.odometry) work(*devices_.odometry);
    if (devices_.scanner) work(*devices_.scanner);
    if (devices_.camera) work(*devices_.camera);
    if (devices_.head) work(*devices_.head);
  }

  void watch(Device& device, DeviceRole role) {
    monitor_.add(role);
    QObject::connect(
        &device, &Device::stamped, &context_,
        [this, role](double time_s, double stamp_s) { monitor_.stamped(role, time_s, stamp_s); });
    QObject::connect(&device, &Device::stateChanged, &context_,
                     [this, role](DeviceState state, const QString& detail) {
                       monitor_.setState(role, state, detail.toStdString());
                       if (role == DeviceRole::Head && state == DeviceState::Lost) {
                         guarded([this] { assembler_.headLost(); });
                       }
                     });
  }

  void connectSensors() {
    if (devices_.odometry) {
      watch(*devices_.odometry, DeviceRole::Odometry);
      QObject::connect(devices_.odometry.get(), &OdometrySensor::lookAsked, &context_,
                       [this] { guarded([this] { assembler_.lookAround(); }); });
      QObject::connect(devices_.odometry.get(), &OdometrySensor::framed, &context_,
                       [this](const OdometryFrames& frames) { monitor_.framed(frames); });
      QObject::connect(devices_.odometry.get(), &OdometrySensor::moved, &context_,
                       [this](double time_s, const Pose2& pose) {
                         monitor_.datum(DeviceRole::Odometry, time_s);
                         monitor_.moved(time_s, pose);
                         guarded([&] { assembler_.moved(time_s, pose, monitor_.now()); });
                       });
    }
    if (devices_.scanner) {
      watch(*devices_.scanner, DeviceRole::Scanner);
      QObject::connect(devices_.scanner.get(), &RangeSensor::reaches, &context_,
                       [this](double range_m) { reach_m_ = range_m; });
      QObject::connect(devices_.scanner.get(), &RangeSensor::scanned, &context_,
                       [this](double time_s, const std::vector<RangePoint>& points) {
                         monitor_.datum(DeviceRole::Scanner, time_s);
                         monitor_.show(inRobotFrame(points, mount_));
                         guarded([&] { assembler_.scanned(time_s, points, monitor_.now()); });
                       });
    }
    if (devices_.camera) {
      watch(*devices_.camera, DeviceRole::Camera);
      QObject::connect(devices_.camera.get(), &PairCamera::described, &context_, describe_);
      QObject::connect(
          devices_.camera.get(), &PairCamera::pairTaken, &context_,
          [this](double time_s, const cv::Mat& left, const cv::Mat& right) {
            monitor_.datum(DeviceRole::Camera, time_s);
            monitor_.show(left, right);
            guarded([&] { assembler_.pairTaken(time_s, left, right, monitor_.now()); });
          });
    }
  }

  void connectHead() {
    if (!devices_.head) return;
    watch(*devices_.head, DeviceRole::Head);
    QObject::connect(devices_.head.get(), &PanTiltHead::arrived, &context_,
                     [this](double pan, double) {
                       monitor_.datum(DeviceRole::Head, monitor_.now());
                       guarded([&] { assembler_.headArrived(pan, monitor_.now()); });
                     });
  }

  void look(double pan) {
    if (devices_.head) devices_.head->lookAt(pan, 0.0);
  }

  /// Scans that waited for the same odometry are given together: none is passed over for another.
  void give() {
    if (whole_.empty()) return;
    const Observation& newest = whole_.back();
    if (seesAnything(newest)) monitor_.observed(newest.time_s);
    monitor_.passedOver(static_cast<long>(inbox_.put(std::exchange(whole_, {}))));
  }

  RigMonitor& monitor_;
  Inbox& inbox_;
  std::atomic<double>& reach_m_;
  Describe describe_;
  const ScannerMount mount_;
  QObject context_;
  QTimer ticking_;
  std::vector<Observation> whole_;
  Assembler assembler_;
  RigDevices devices_;  // last: they go first
};

RigHost::RigHost(const Rig& rig, MakeDevices make, std::shared_ptr<RigMonitor> monitor)
    : monitor_(std::move(monitor)) {
  std::promise<void> opened;
  auto is_open = opened.get_future();
  thread_ = std::thread([this, rig, make = std::move(make), promise = std::move(opened)]() mutable {
    work(rig, make, std::move(promise));
  });
  try {
    is_open.get();
  } catch (...) {
    thread_.join();
    throw;
  }
  on_end_.emplace(monitor_->endToken(), [this] { end(); });
}

RigHost::~RigHost() {
  on_end_.reset();
  end();
  thread_.join();
}

void RigHost::end() {
  inbox_.close();
  const std::scoped_lock lock(mutex_);
  if (loop_ != nullptr) QMetaObject::invokeMethod(loop_, &QEventLoop::quit, Qt::QueuedConnection);
}

void RigHost::work(const Rig& rig, const MakeDevices& make, std::promise<void> opened) {
  QEventLoop loop;
  std::optional<Hosting> hosting;
  try {
    hosting.emplace(rig, make, *monitor_, inbox_, reach_m_,
                    [this](const auto& rectifier) { describe(rectifier); });
    hosting->open();
  } catch (...) {
    opened.set_exception(std::current_exception());
    return;
  }
  {
    const std::scoped_lock lock(mutex_);
    loop_ = &loop;
  }
  opened.set_value();
  turn(loop);
  {
    const std::scoped_lock lock(mutex_);
    loop_ = nullptr;
  }
  hosting->close();
  QTimer::singleShot(kRest_ms, &loop, &QEventLoop::quit);
  turn(loop);
}

/// Until it is told to quit; what a device throws ends neither it nor the program.
void RigHost::turn(QEventLoop& loop) {
  for (bool again = true; again;) {
    try {
      loop.exec();
      again = false;
    } catch (const std::exception& error) {
      monitor_->refused(phrase("unexpected error"), error.what());
    }
  }
}

void RigHost::describe(const std::shared_ptr<const Rectifier>& rectifier) {
  const std::scoped_lock lock(mutex_);
  rectifier_ = rectifier;
}

std::shared_ptr<const Rectifier> RigHost::rectifier() {
  const std::scoped_lock lock(mutex_);
  return rectifier_;
}

std::optional<Observation> RigHost::next(const std::stop_token& stop) { return inbox_.take(stop); }

}  // namespace handmap
