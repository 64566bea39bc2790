// A robot that is not there and drives around a campus for as long as one likes, for long drives of
// the window and of the command line: emulated_robot FOLDER [SPEED_M_S] writes drawing.handmap and
// rig.json there (a UST-10LX over TCP, odometry of ROS, told over the same rosbridge), starts when
// somebody listens to its odometry, and prints every ten seconds how old the told poses are and how
// far off, against what they say of themselves.
#include <QCborArray>
#include <QCborMap>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTimer>
#include <algorithm>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/map/map_io.h"
#include "core/simulation/ray_cast.h"
#include "core/simulation/route.h"
#include "core/simulation/world.h"
#include "drivers/emulators/hokuyo_emulator.h"
#include "drivers/emulators/ros_emulated_messages.h"
#include "drivers/emulators/rosbridge_emulator.h"

namespace handmap {
namespace {

constexpr std::uint64_t kSeed = 3;
constexpr double kEpoch_s = 1.7e9;     // the robot's clock when it is switched on
constexpr double kDrift_m = 1.01;      // of a metre of the odometry
constexpr double kDrift_rad_m = 5e-4;  // and how it turns on the way
constexpr double kReach_m = 30.0;
constexpr double kNoise_m = 0.03;

/// The way around thrice, so that a second lap begins where and as it ends.
Route laps(const Map& map) {
  const auto home = std::find(map.route.rbegin(), map.route.rend(), map.route.front());
  std::vector<Vec2> points;
  for (int lap = 0; lap < 3; ++lap) points.insert(points.end(), map.route.begin(), home.base());
  return Route(points);
}

/// Once around, again and again, from when it is started.
class Round {
 public:
  Round(const World& world, double speed_m_s)
      : route_(laps(world.map)), speed_m_s_(speed_m_s), length_m_(route_.length() / 3.0) {}
  void start() { clock_.start(); }
  bool isUnderWay() const { return clock_.isValid(); }
  double now() const {
    return isUnderWay() ? 1e-9 * static_cast<double>(clock_.nsecsElapsed()) : 0.0;
  }
  double driven_m() const { return speed_m_s_ * now(); }
  Pose2 pose() const {
    const double s = driven_m();
    return route_.poseAt(s < length_m_ ? s : length_m_ + std::fmod(s, length_m_));
  }

 private:
  Route route_;
  double speed_m_s_;
  double length_m_;  // of a lap
  QElapsedTimer clock_;
};

/// What the scanner measures from where the robot is.
class Sight {
 public:
  Sight(const World& world, const Round& round) : round_(round) {
    for (std::size_t i = 0; i < world.map.buildings.size(); ++i) {
      const Polygon wall = world.wallsOf(i);
      for (std::size_t k = 0; k < wall.size(); ++k) {
        walls_.push_back({wall[k], wall[(k + 1) % wall.size()]});
      }
    }
  }
  double operator()(double angle) {
    const Pose2 pose = round_.pose();
    const Vec2 direction(std::cos(pose.heading + angle), std::sin(pose.heading + angle));
    double range_m = kNoHit;
    for (const Segment& wall : walls_) {
      range_m = std::min(range_m, rayToSegment(pose.position(), direction, wall));
    }
    return range_m > kReach_m ? kNoHit : std::max(0.1, range_m + noise_(random_));
  }

 private:
  const Round& round_;
  std::vector<Segment> walls_;
  std::minstd_rand random_;
  std::normal_distribution<double> noise_{0.0, kNoise_m};
};

/// The odometry, which drifts.
class Wheels {
 public:
  explicit Wheels(const Round& round) : round_(round), last_(round.pose()) {}
  Pose2 pose() {
    const Pose2 now = round_.pose();
    Pose2 step = between(last_, now);
    const double length_m = step.position().norm();
    step.x *= kDrift_m;
    step.y *= kDrift_m;
    step.heading += kDrift_rad_m * length_m;
    told_ = told_ * step;
    last_ = now;
    return told_;
  }

 private:
  const Round& round_;
  Pose2 last_;
  Pose2 told_;
};

double stampOf(const QCborMap& message) {
  const QCborMap stamp = message[QStringLiteral("header")].toMap()[QStringLiteral("stamp")].toMap();
  return stamp[QStringLiteral("sec")].toDouble() +
         1e-9 * stamp[QStringLiteral("nanosec")].toDouble();
}

class Told {
 public:
  Told(const RosbridgeEmulator& ros, const Round& round) : round_(round) {
    QObject::connect(
        &ros, &RosbridgeEmulator::published, &context_,
        [this](const QString& topic, const QCborMap& message) { take(topic, message); });
  }
  void print() {
    std::sort(ages_s_.begin(), ages_s_.end());
    const auto age = [this](double share) {
      return ages_s_[static_cast<std::size_t>(share * static_cast<double>(ages_s_.size() - 1))];
    };
    fmt::print("{:.0f} s, {:.0f} m driven: {} poses told", round_.now(), round_.driven_m(),
               ages_s_.size());
    if (!ages_s_.empty()) {
      fmt::print(
          ", {:.3f} s old (nine of ten within {:.3f}, all within {:.3f}), {:.2f} m off, told as "
          "{:.2f} m",
          age(0.5), age(0.9), age(1.0), off_m_, sigma_m_);
    }
    fmt::print("\n");
    std::fflush(stdout);
    ages_s_.clear();
  }

 private:
  void take(const QString& topic, const QCborMap& message) {
    if (topic != QLatin1String("/handmap/pose")) return;
    ages_s_.push_back(kEpoch_s + round_.now() - stampOf(message));
    const QCborMap estimate = message[QStringLiteral("pose")].toMap();
    const QCborArray covariance = estimate[QStringLiteral("covariance")].toArray();
    sigma_m_ = std::sqrt(covariance[0].toDouble() + covariance[7].toDouble());
    const QCborMap at =
        estimate[QStringLiteral("pose")].toMap()[QStringLiteral("position")].toMap();
    const Vec2 told(at[QStringLiteral("x")].toDouble(), at[QStringLiteral("y")].toDouble());
    off_m_ = (told - round_.pose().position()).norm();
  }

  QObject context_;
  const Round& round_;
  std::vector<double> ages_s_;
  double off_m_ = 0.0;
  double sigma_m_ = 0.0;  // of the position, as the last told pose says
};

void drive(const std::filesystem::path& folder, double speed_m_s) {
  const World world = loopWorld(kSeed);
  Round round(world, speed_m_s);
  HokuyoEmulator laser(EmulatedPort::Kind::Tcp, Sight(world, round));
  RosbridgeEmulator ros;
  Told told(ros, round);
  std::filesystem::create_directories(folder);
  writeMap(perturbed(world.map, 2.0, kSeed), folder / "drawing.handmap");
  const std::string bridge = ros.url().toString().toStdString();
  std::ofstream(folder / "rig.json") << fmt::format(
      R"({{"format": "handmap-rig", "version": 1, "name": "Emulated robot", "range_limit_m": 30,
 "scanner": {{"kind": "hokuyo", "port": "{}"}},
 "odometry": {{"kind": "ros", "port": "{}", "topic": "/odom"}},
 "publish": {{"ros": "{}"}}, "record": "recordings"}}
)",
      laser.port().address(), bridge, bridge);
  Wheels wheels(round);
  QTimer odometry;
  QObject::connect(&odometry, &QTimer::timeout, &odometry, [&] {
    if (!ros.hasSubscriber(QStringLiteral("/odom"))) return;
    if (!round.isUnderWay()) round.start();  // so that it starts where the drawing says
    ros.publish(QStringLiteral("/odom"),
                emulated::odometry(kEpoch_s + round.now(), wheels.pose(), RosVersion::Ros2));
  });
  odometry.start(20);
  QTimer report;
  QObject::connect(&report, &QTimer::timeout, &report, [&told] { told.print(); });
  report.start(10'000);
  QCoreApplication::exec();
}

}  // namespace
}  // namespace handmap

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  std::setlocale(LC_ALL, "C");
  if (argc < 2) {
    fmt::print(stderr, "emulated_robot FOLDER [SPEED_M_S]\n");
    return 1;
  }
  try {
    handmap::drive(argv[1], argc > 2 ? std::atof(argv[2]) : 1.5);
  } catch (const handmap::Error& error) {
    fmt::print(stderr, "emulated_robot: {}\n", error.what());
    return static_cast<int>(error.code());
  }
  return 0;
}
