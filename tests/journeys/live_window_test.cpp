// A live robot in the window: the virtual rig, devices that fall silent, one drive after another.
#include <QDir>
#include <QElapsedTimer>
#include <QPushButton>
#include <QTcpServer>
#include <QTreeWidget>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "app/gui/rig/rig_actions.h"
#include "app/gui/run/live_robot.h"
#include "core/method/pose_trust.h"
#include "core/simulation/ray_cast.h"
#include "core/simulation/world.h"
#include "drivers/connected/connected_devices.h"
#include "drivers/emulators/hokuyo_emulator.h"
#include "drivers/emulators/odometry_emulator.h"
#include "drivers/emulators/rosbridge_emulator.h"
#include "drivers/virtual/stereo_rig.h"
#include "tests/journeys/window_test.h"
#include "widgets/rig/live_panel.h"

namespace handmap {
namespace {

class LiveWindow : public WindowTest {
 protected:
  /// Its scans tell the motion, too.
  static Rig scannerAlone(std::string name) {
    Rig rig;
    rig.name = std::move(name);
    rig.scanner = ScannerRig{};
    rig.odometry.kind = OdometryRigKind::Scan;
    return rig;
  }
  /// None of its devices ever says anything.
  static Robot silentRobot(const Rig& rig) {
    return liveRobot(rig, [](const Rig&, RigMonitor&) { return RigDevices{}; });
  }
  static void runVirtualRig(MainWindow& window) {
    RunSetup setup;
    setup.settings.slam.slam_particles = 5;
    window.runPanels().setup.setSetup(setup);
    window.sources().openVirtualRig();
    window.runs().runOrResume();
  }
  static bool waitForSteps(MainWindow& window) {
    return QTest::qWaitFor([&] { return window.run().result() != nullptr; }, kPatienceMs);
  }
  static QString panelText(MainWindow& window) {
    QString text;
    const auto* tree = window.rigs().panel().findChild<QTreeWidget*>();
    for (int row = 0; row < tree->topLevelItemCount(); ++row) {
      for (int column = 0; column < tree->columnCount(); ++column) {
        text += tree->topLevelItem(row)->text(column) + ' ';
      }
    }
    return text + window.rigs().panel().findChild<QLabel*>("live_counts")->text();
  }
  static QPushButton* button(MainWindow& window, const QString& text) {
    for (auto* found : window.messages().findChildren<QPushButton*>()) {
      if (found->text() == text) return found;
    }
    return nullptr;
  }
};

TEST_F(LiveWindow, ALiveRobotRunsUntilThePersonEndsTheDrive) {
  const auto window = open();
  window->docks().setOpen(true);
  runVirtualRig(*window);
  EXPECT_TRUE(window->rigs().panel().isVisible());
  ASSERT_TRUE(waitForSteps(*window));
  EXPECT_TRUE(QTest::qWaitFor([&] { return panelText(*window).contains("ready"); }, kPatienceMs));
  EXPECT_TRUE(panelText(*window).contains("Scanner")) << panelText(*window).toStdString();
  EXPECT_FALSE(window->runs().stateInWords().contains(" of "))
      << window->runs().stateInWords().toStdString();
  action(*window, "run.stop")->trigger();
  EXPECT_EQ(window->runs().stateInWords().left(9), "Finishing");
  ASSERT_TRUE(waitFor(*window, RunState::Idle));
  EXPECT_TRUE(window->runs().stateInWords().startsWith("Done"))
      << window->runs().stateInWords().toStdString();
  EXPECT_TRUE(action(*window, "run.accept")->isEnabled());
  EXPECT_TRUE(panelText(*window).contains("observations taken"));
  // And once more.
  action(*window, "run.run")->trigger();
  ASSERT_TRUE(waitForSteps(*window));
  action(*window, "run.stop")->trigger();
  ASSERT_TRUE(waitFor(*window, RunState::Idle));
}

TEST_F(LiveWindow, APausedDriveIsEndedToo) {
  const auto window = open();
  runVirtualRig(*window);
  ASSERT_TRUE(waitForSteps(*window));
  action(*window, "run.pause")->trigger();
  ASSERT_TRUE(waitFor(*window, RunState::Paused));
  action(*window, "run.stop")->trigger();
  ASSERT_TRUE(waitFor(*window, RunState::Idle));
  EXPECT_TRUE(window->runs().stateInWords().startsWith("Done"));
}

TEST_F(LiveWindow, TheWindowClosesInTheMiddleOfADrive) {
  auto window = open();
  runVirtualRig(*window);
  ASSERT_TRUE(waitForSteps(*window));
  EXPECT_TRUE(window->close());
  EXPECT_FALSE(window->run().isActive());
}

TEST_F(LiveWindow, AStopBeforeTheFirstObservationIsAnEnd) {
  const auto window = open();
  window->sources().openVirtualRig();
  Rig rig = scannerAlone("silent");
  window->sources().setRobot(silentRobot(rig));
  window->runs().runOrResume();
  EXPECT_EQ(window->runs().stateInWords(), "Waiting for the robot");
  QTest::qWait(300);
  action(*window, "run.stop")->trigger();
  ASSERT_TRUE(waitFor(*window, RunState::Idle));
}

TEST_F(LiveWindow, EachDriveGetsThePortOfTheDriveBefore) {
  const auto window = open();
  window->sources().openVirtualRig();
  QTcpServer free;
  ASSERT_TRUE(free.listen(QHostAddress::LocalHost));
  Rig rig = scannerAlone("silent");
  rig.publish.foxglove = free.serverPort();
  free.close();
  const auto is_looked_on = [&] {
    const auto devices = window->run().live()->monitor()->status().devices;
    return !devices.empty() && devices[0].state == DeviceState::Ready;
  };
  for (const bool is_another : {true, false, true, true}) {
    if (is_another) {
      window->sources().setRobot(silentRobot(rig));
    }
    window->runs().runOrResume();
    EXPECT_TRUE(QTest::qWaitFor(is_looked_on, kPatienceMs));
    action(*window, "run.stop")->trigger();
    ASSERT_TRUE(waitFor(*window, RunState::Idle));
  }
}

TEST_F(LiveWindow, ARobotThatWaitsForItsStartOffersToPlaceIt) {
  const auto window = open();
  Rig rig;
  rig.name = "Cart";
  rig.scanner = ScannerRig{};
  window->sources().useLive(liveRobot(rig, {}));
  ASSERT_TRUE(message(*window).contains("Draw where it starts"));
  EXPECT_TRUE(action(*window, "draw.start")->isChecked()) << "no house is moved instead";
  action(*window, "draw.select")->trigger();
  QPushButton* place = button(*window, "Place the start");
  ASSERT_NE(place, nullptr);
  place->click();
  EXPECT_TRUE(action(*window, "draw.start")->isChecked());
  window->sources().useLive(liveRobot(rig, {}));
  Map map = document_.map();
  map.start = Pose2{1.0, 2.0, 0.0};
  document_.setStart(map.start);
  EXPECT_TRUE(QTest::qWaitFor([&] { return button(*window, "Place the start") == nullptr; }));
  window->sources().useLive(liveRobot(rig, {}));
  EXPECT_FALSE(message(*window).contains("Draw where it starts")) << "it has one";
}

TEST_F(LiveWindow, WhatRunsAtOnceIsNotAskedFor) {
  const auto window = open();
  window->sources().openVirtualRig();
  Rig rig = scannerAlone("Cart");
  QObject::connect(&window->sources(), &SourceActions::robotChanged, &window->runs(),
                   &TransportActions::runOrResume, Qt::SingleShotConnection);  // as --run
  window->sources().useLive(silentRobot(rig));
  EXPECT_FALSE(message(*window).contains("Press Run")) << message(*window).toStdString();
  action(*window, "run.stop")->trigger();
  ASSERT_TRUE(waitFor(*window, RunState::Idle));
}

TEST_F(LiveWindow, ADeadScannerIsSaidAndSoIsARecordingThatEnds) {
  const auto window = open();
  window->sources().openVirtualRig();
  VirtualDrive drive{twoRowWorld(3), 3};
  drive.faults = parseFaults("scanner:unplug@3+4");
  Rig rig = virtualRig(drive);
  rig.record = path("drives").toStdString();
  window->sources().setRobot(liveRobot(rig, virtualDevices(drive)));
  window->runs().runOrResume();
  ASSERT_TRUE(waitForSteps(*window));
  ASSERT_TRUE(QTest::qWaitFor([&] { return settings_.contains("live/recording"); }, kPatienceMs));
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return message(*window).contains("Nothing has been observed"); }, kPatienceMs));
  EXPECT_TRUE(message(*window).contains("unplugged")) << message(*window).toStdString();
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return !message(*window).contains("Nothing has been observed"); }, kPatienceMs));
  QDir(path("drives")).removeRecursively();
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return message(*window).contains("The recording has ended, the drive goes on"); },
      kPatienceMs));
  EXPECT_TRUE(window->run().isActive());
}

TEST_F(LiveWindow, ARobotThatSaysNothingFromTheBeginningIsSaid) {
  const auto window = open();
  window->sources().openVirtualRig();
  VirtualDrive drive{twoRowWorld(3), 3};
  drive.faults = parseFaults("scanner:unplug@0+11");
  window->sources().setRobot(liveRobot(virtualRig(drive), virtualDevices(drive)));
  window->runs().runOrResume();
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return message(*window).contains("Nothing has been observed yet"); }, kPatienceMs));
  EXPECT_TRUE(message(*window).contains("unplugged")) << message(*window).toStdString();
  ASSERT_TRUE(waitForSteps(*window));
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return !message(*window).contains("Nothing has been observed"); }, kPatienceMs));
}

/// Of a scanner that works and wheels that are dead, the wheels are named.
TEST_F(LiveWindow, WhyNothingIsObservedIsOfTheDeviceThatIsDead) {
  const auto window = open();
  window->sources().openVirtualRig();
  HokuyoEmulator laser(EmulatedPort::Kind::Tcp, [](double) { return 3.0; });
  Rig rig;
  rig.name = "Cart";
  rig.scanner = ScannerRig{};
  rig.scanner->port = laser.port().address();
  rig.odometry = {OdometryRigKind::Lines, "/dev/no-such-port", ""};
  window->sources().setRobot(liveRobot(rig, connectedDevices()));
  window->runs().runOrResume();
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return message(*window).contains("Nothing has been observed yet"); }, kPatienceMs));
  EXPECT_TRUE(message(*window).contains("/dev/no-such-port is not there"))
      << message(*window).toStdString();
}

TEST_F(LiveWindow, AHeadLooksAroundInEachDriveOfAWindowAndADeadCameraIsSaid) {
  const auto window = open();
  window->docks().setOpen(true);
  window->sources().openVirtualRig(VirtualRigKind::StereoHead);
  VirtualDrive drive{furnished(twoRowWorld(3), 3), 3};
  QStringList told;
  QObject::connect(&window->runs(), &TransportActions::stateChanged, &guard_,
                   [&] { told << window->runs().stateInWords(); });
  for (const bool is_second : {false, true}) {
    if (is_second) drive.faults = {{DeviceRole::Camera, FaultKind::Unplug, 5.0, 1000.0}};
    window->sources().setRobot(liveRobot(virtualStereoRig(), virtualStereoDevices(drive)));
    told.clear();
    window->runs().runOrResume();
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return window->runs().stateInWords().startsWith("Waiting for the robot: "); }, 1000))
        << "not a second without a word";
    ASSERT_TRUE(QTest::qWaitFor([&] { return panelText(*window).contains("looks around: 2 of 6"); },
                                kPatienceMs))
        << panelText(*window).toStdString();
    if (is_second) {
      EXPECT_TRUE(QTest::qWaitFor(
          [&] { return message(*window).contains("Nothing has been observed"); }, kPatienceMs));
      EXPECT_TRUE(message(*window).contains("unplugged")) << message(*window).toStdString();
    } else {
      ASSERT_TRUE(waitForSteps(*window));
      EXPECT_TRUE(told.contains("Waiting for the robot: the head looks around: 3 of 6"))
          << told.join("; ").toStdString();
      EXPECT_FALSE(message(*window).contains("Nothing has been observed"));
    }
    action(*window, "run.stop")->trigger();
    ASSERT_TRUE(waitFor(*window, RunState::Idle));
  }
}

/// The drawing still says where the first drive began.
TEST_F(LiveWindow, ASecondDriveAsksWhereTheRobotBegins) {
  const auto window = open();
  window->sources().openVirtualRig();
  VirtualDrive drive{twoRowWorld(3), 3};
  drive.speed_m_s = 10.0;
  drive.step_m = 0.5;
  window->sources().setRobot(liveRobot(virtualRig(drive), virtualDevices(drive)));
  const auto driveFor = [&](int ms) {
    ASSERT_TRUE(waitForSteps(*window));
    QTest::qWait(ms);
    action(*window, "run.stop")->trigger();
    ASSERT_TRUE(waitFor(*window, RunState::Idle));
  };
  window->runs().runOrResume();
  driveFor(1500);
  const std::optional<Pose2> start = document_.map().start;
  for (const char* answer : {"Where it stopped", "At the start of the drawing"}) {
    window->runs().runOrResume();
    EXPECT_FALSE(window->run().isActive());
    ASSERT_TRUE(message(*window).contains("Where does the robot begin?"))
        << message(*window).toStdString();
    button(*window, answer)->click();
    EXPECT_TRUE(window->run().isActive());
    EXPECT_FALSE(message(*window).contains("Where does the robot begin?"));
    EXPECT_GT((document_.map().start->position() - start->position()).norm(), 2.0);
    driveFor(1500);
  }
  document_.setStart(start);  // whoever places it anew has said it
  window->runs().runOrResume();
  EXPECT_TRUE(window->run().isActive());
  driveFor(0);
}

/// Wheels and a laser on a cart that somebody drives straight on, or carries while it is off.
class Cart {
 public:
  explicit Cart(const Map& map) : pose_(*map.start), switched_on_(pose_) {
    for (const Building& building : map.buildings) {
      const Polygon wall = building.footprint();
      for (std::size_t i = 0; i < wall.size(); ++i) {
        walls_.push_back({wall[i], wall[(i + 1) % wall.size()]});
      }
    }
    moved_.start();
  }
  Rig rig() {
    Rig rig;
    rig.name = "Cart";
    rig.range_limit_m = 30.0;
    rig.scanner = ScannerRig{};
    rig.scanner->port = laser_.port().address();
    rig.odometry = {OdometryRigKind::Lines, wheels_.port().address(), ""};
    return rig;
  }
  void drive(double speed_m_s) {
    pose();
    speed_m_s_ = speed_m_s;
  }
  void carry(double ahead_m) { switched_on_ = pose_ = pose() * Pose2{ahead_m, 0.0, 0.0}; }
  const Pose2& pose() {
    pose_ = pose_ * Pose2{speed_m_s_ * 1e-9 * static_cast<double>(moved_.nsecsElapsed()), 0.0, 0.0};
    moved_.start();
    return pose_;
  }

 private:
  double range(double angle) {
    const Vec2 direction(std::cos(pose_.heading + angle), std::sin(pose_.heading + angle));
    double range_m = kNoHit;
    for (const Segment& wall : walls_) {
      range_m = std::min(range_m, rayToSegment(pose_.position(), direction, wall));
    }
    return range_m > 30.0 ? kNoHit : range_m + noise_(random_);
  }

  Pose2 pose_;
  Pose2 switched_on_;
  double speed_m_s_ = 0.0;
  QElapsedTimer moved_;
  std::vector<Segment> walls_;
  std::minstd_rand random_;
  std::normal_distribution<double> noise_{0.0, 0.02};
  HokuyoEmulator laser_{EmulatedPort::Kind::Tcp, [this](double angle) { return range(angle); }};
  OdometryEmulator wheels_{EmulatedPort::Kind::PseudoTerminal,
                           [this](double) { return between(switched_on_, pose()); },
                           OdometryEmulator::Form::Fields};
};

/// Switched off, driven on by hand, and said to be where it stopped.
TEST_F(LiveWindow, ARobotThatWasCarriedIsMissedAtOnceAndPlacedAgain) {
  const Map map = loopWorld(3).map;
  document_.reset(map);
  const auto window = open();
  Cart cart(map);
  window->sources().setRobot(liveRobot(cart.rig(), connectedDevices()));
  const auto report = [&] { return window->run().result()->last->report; };
  const auto drive = [&](int ms) {
    ASSERT_TRUE(waitForSteps(*window));
    cart.drive(5.0);
    QTest::qWait(ms);
    cart.drive(0.0);
    QTest::qWait(500);
  };
  const auto stop = [&] {
    action(*window, "run.stop")->trigger();
    ASSERT_TRUE(waitFor(*window, RunState::Idle));
  };
  window->runs().runOrResume();
  drive(3000);
  stop();
  cart.carry(30.0);
  window->runs().runOrResume();
  button(*window, "Where it stopped")->click();
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return message(*window).contains("not where the drive is said to begin"); }, 5000));
  drive(1000);
  EXPECT_EQ(certaintyOf(report()).kind, Certainty::Lost);
  Q_EMIT window->run().poseGiven(report().time_s, cart.pose() * Pose2{1.0, -0.5, 0.05});
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return message(*window).contains("It is known again where the robot is"); },
      kPatienceMs));
  EXPECT_LT(between(cart.pose(), report().pose).position().norm(), 2.5);
  stop();
  // It stands where it stopped.
  window->runs().runOrResume();
  button(*window, "Where it stopped")->click();
  drive(1000);
  EXPECT_EQ(certaintyOf(report()).kind, Certainty::Sure);
  stop();
  // Whoever does not say either places it.
  window->runs().runOrResume();
  button(*window, "Place the start")->click();
  EXPECT_TRUE(action(*window, "draw.start")->isChecked());
  EXPECT_FALSE(window->run().isActive());
}

TEST_F(LiveWindow, DeadWheelsAreSaid) {
  const auto window = open();
  window->sources().openVirtualRig();
  VirtualDrive drive{twoRowWorld(3), 3};
  drive.faults = parseFaults("odometry:unplug@2+60");
  window->sources().setRobot(liveRobot(virtualRig(drive), virtualDevices(drive)));
  window->runs().runOrResume();
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return message(*window).contains("nothing tells where the robot drives"); },
      kPatienceMs));
  EXPECT_TRUE(message(*window).contains("unplugged")) << message(*window).toStdString();
}

TEST_F(LiveWindow, WhoIsLostWithADeadScannerIsFoundWhenItReturns) {
  const auto window = open();
  window->sources().openVirtualRig();
  VirtualDrive drive{twoRowWorld(3), 3};
  drive.speed_m_s = 0.05;
  drive.step_m = 0.01;
  drive.faults = parseFaults("scanner:unplug@4+6");
  Rig rig = virtualRig(drive);
  rig.odometry.kind = OdometryRigKind::Scan;
  window->sources().setRobot(liveRobot(rig, virtualDevices(drive)));
  window->runs().runOrResume();
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return message(*window).contains("It is no longer known where the robot is"); },
      kPatienceMs));
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return message(*window).contains("It is known again where the robot is"); },
      kPatienceMs));
  EXPECT_FALSE(message(*window).contains("no longer known"));
}

TEST_F(LiveWindow, ADriveThatWasCutOffIsOffered) {
  auto window = open();
  window->sources().openVirtualRig();
  VirtualDrive drive{twoRowWorld(3), 3};
  Rig rig = virtualRig(drive);
  rig.record = path("drives").toStdString();
  window->sources().setRobot(liveRobot(rig, virtualDevices(drive)));
  window->runs().runOrResume();
  ASSERT_TRUE(waitForSteps(*window));
  ASSERT_TRUE(QTest::qWaitFor([&] { return settings_.contains("live/recording"); }, kPatienceMs));
  const QString folder = settings_.value("live/recording").toString();
  action(*window, "run.stop")->trigger();
  ASSERT_TRUE(waitFor(*window, RunState::Idle));
  EXPECT_FALSE(settings_.contains("live/recording")) << "it has ended";
  window->offerRecovery();
  QTest::qWait(200);
  EXPECT_FALSE(message(*window).contains("middle of a drive"));
  action(*window, "run.accept")->trigger();  // whoever opens another one is asked of this run
  // As it is after a kill.
  settings_.setValue("live/recording", folder);
  settings_.setValue("live/process", 0);
  window->offerRecovery();
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return message(*window).contains("middle of a drive"); }, kPatienceMs));
  EXPECT_TRUE(message(*window).contains(folder));
  button(*window, "Open it")->click();
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return window->sources().robot() && !window->sources().robot()->live; }, kPatienceMs));
}

TEST_F(LiveWindow, APoseThatIsGivenInRvizIsRobotIsHere) {
  const auto window = open();
  RosbridgeEmulator ros;
  window->sources().openVirtualRig();
  VirtualDrive drive{twoRowWorld(3), 3};
  Rig rig = virtualRig(drive);
  rig.publish.ros = ros.url().toString().toStdString();
  window->sources().setRobot(liveRobot(rig, virtualDevices(drive)));
  QCborMap pose;
  QObject::connect(&ros, &RosbridgeEmulator::published, &guard_,
                   [&](const QString& topic, const QCborMap& told) {
                     if (topic == QLatin1String("/handmap/pose")) pose = told;
                   });
  window->runs().runOrResume();
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return !pose.isEmpty() && ros.hasSubscriber(QStringLiteral("/initialpose")); },
      kPatienceMs));
  ros.publish(QStringLiteral("/initialpose"), pose);
  EXPECT_TRUE(QTest::qWaitFor([&] { return window->run().settings().given_poses.size() == 1; },
                              kPatienceMs));
  EXPECT_TRUE(window->run().isActive()) << "the drive goes on from there";
}

}  // namespace
}  // namespace handmap
