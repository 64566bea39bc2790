// A drive on the command line, with a ROS that is not there: what it is told and what it says.
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "drivers/emulators/ros_emulated_messages.h"
#include "drivers/emulators/rosbridge_emulator.h"
#include "tests/drivers/devices/waiting.h"

namespace handmap {
namespace {

constexpr int kPatience_ms = 60'000;

constexpr auto kYard = R"({"format": "handmap", "version": 1,
  "start": {"x": 0, "y": 0, "heading_deg": 0},
  "buildings": [
    {"id": "N", "shape": "rectangle", "x": 2, "y": 14, "width": 24, "depth": 10, "heading_deg": 0},
    {"id": "S", "shape": "rectangle", "x": -3, "y": -12, "width": 18, "depth": 8, "heading_deg": 0},
    {"id": "E", "shape": "rectangle", "x": 20, "y": -1, "width": 8, "depth": 9, "heading_deg": 0}]})";

/// What a scanner at the start of the yard measures; infinity where nothing is.
std::vector<float> yardAround() {
  struct Box {
    double left, low, right, high;
  };
  constexpr Box kBoxes[] = {{-10, 9, 14, 19}, {-12, -16, 6, -8}, {16, -5.5, 24, 3.5}};
  constexpr int kRays = 360;
  std::vector<float> ranges;
  for (int i = 0; i < kRays; ++i) {
    const double bearing = -M_PI + 2.0 * M_PI * i / kRays;
    double nearest = INFINITY;
    for (const Box& box : kBoxes) {
      // The robot is outside: the last of the two slabs to be entered is where the box begins.
      const auto enters = [](double direction, double low, double high) {
        return std::pair(std::min(low / direction, high / direction),
                         std::max(low / direction, high / direction));
      };
      const auto [x_in, x_out] = enters(std::cos(bearing), box.left, box.right);
      const auto [y_in, y_out] = enters(std::sin(bearing), box.low, box.high);
      const double in = std::max(x_in, y_in);
      if (in > 0.0 && in < std::min(x_out, y_out)) nearest = std::min(nearest, in);
    }
    ranges.push_back(static_cast<float>(nearest));
  }
  return ranges;
}

class CommandedDrive : public testing::Test {
 protected:
  CommandedDrive() {
    write("yard.handmap", kYard);
    const std::string url = ros_.url().toString().toStdString();
    write("rig.json", fmt::format(R"({{"format": "handmap-rig", "version": 1,
              "scanner": {{"kind": "ros", "port": "{}", "topic": "/scan"}},
              "odometry": {{"kind": "scan"}}, "publish": {{"ros": "{}"}}}})",
                                  url, url));
    program_.setWorkingDirectory(folder_.path());
    program_.start(QStringLiteral(HANDMAP_CLI),
                   {"run", "--map", "yard.handmap", "--rig", "rig.json", "--trajectory", "way.tum",
                    "--slam-particles", "10"});
  }
  ~CommandedDrive() override {
    program_.kill();
    program_.waitForFinished();
  }

  void write(const char* name, const std::string& text) const {
    QFile file(folder_.filePath(QLatin1String(name)));
    ASSERT_TRUE(file.open(QFile::WriteOnly));
    file.write(QByteArray::fromStdString(text));
  }
  /// The scanner measures, or not, until something holds.
  bool goesOnUntil(bool measuring, const std::function<bool()>& holds) {
    return test::waitUntil(
        [&] {
          if (measuring && last_.hasExpired(100)) {
            last_.start();
            ros_.publish(QStringLiteral("/scan"),
                         emulated::laserScan(1.5e9 + 1e-3 * static_cast<double>(clock_.elapsed()),
                                             yardAround(), RosVersion::Ros2));
          }
          said_ += program_.readAllStandardError();
          return holds();
        },
        kPatience_ms);
  }
  bool says(const char* words, bool measuring = true) {
    return goesOnUntil(measuring, [&] { return said_.contains(words); });
  }
  bool isObserving() {
    return goesOnUntil(true, [&] { return poses_ > 5; });
  }
  /// As Ctrl-C does it.
  int end() {
    program_.terminate();
    EXPECT_TRUE(goesOnUntil(true, [&] { return program_.state() == QProcess::NotRunning; }));
    return program_.exitCode();
  }

  QTemporaryDir folder_;
  RosbridgeEmulator ros_;
  QProcess program_;
  QElapsedTimer clock_ = started();
  QElapsedTimer last_ = started();
  QByteArray said_;
  int poses_ = 0;
  QMetaObject::Connection counting_ = QObject::connect(
      &ros_, &RosbridgeEmulator::published, &ros_,
      [this](const QString& topic) { poses_ += topic == QLatin1String("/handmap/pose"); });

 private:
  static QElapsedTimer started() {
    QElapsedTimer clock;
    clock.start();
    return clock;
  }
};

TEST_F(CommandedDrive, APoseThatIsGivenInRvizDoesItAgain) {
  ASSERT_TRUE(goesOnUntil(true, [&] { return ros_.hasSubscriber(QStringLiteral("/initialpose")); }))
      << said_.toStdString();
  ASSERT_TRUE(isObserving()) << said_.toStdString();
  const QCborMap point{
      {QStringLiteral("x"), 0.4}, {QStringLiteral("y"), -0.3}, {QStringLiteral("z"), 0.0}};
  const QCborMap ahead{{QStringLiteral("x"), 0},
                       {QStringLiteral("y"), 0},
                       {QStringLiteral("z"), 0},
                       {QStringLiteral("w"), 1}};
  const QCborMap header{{QStringLiteral("stamp"),
                         QCborMap{{QStringLiteral("sec"), 0}, {QStringLiteral("nanosec"), 0}}},
                        {QStringLiteral("frame_id"), QStringLiteral("map")}};
  ros_.publish(
      QStringLiteral("/initialpose"),
      {{QStringLiteral("header"), header},
       {QStringLiteral("pose"),
        QCborMap{{QStringLiteral("pose"), QCborMap{{QStringLiteral("position"), point},
                                                   {QStringLiteral("orientation"), ahead}}}}}});
  EXPECT_TRUE(says("handmap-cli: a pose was given: done again through 0.4, -0.3\n"))
      << said_.toStdString();
  const int before = poses_;
  EXPECT_TRUE(goesOnUntil(true, [&] { return poses_ > before + 5; })) << "the drive goes on";
  EXPECT_EQ(end(), 0) << said_.toStdString();
  EXPECT_TRUE(QFile::exists(folder_.filePath(QStringLiteral("way.tum"))));
}

TEST_F(CommandedDrive, WhoIsLostWithADeadScannerIsFoundWhenItReturns) {
  ASSERT_TRUE(isObserving()) << said_.toStdString();
  EXPECT_TRUE(says("handmap-cli: it is no longer known where the robot is\n", false))
      << said_.toStdString();
  EXPECT_TRUE(says("handmap-cli: it is known again where the robot is\n")) << said_.toStdString();
  EXPECT_EQ(end(), 0) << said_.toStdString();
}

}  // namespace
}  // namespace handmap
