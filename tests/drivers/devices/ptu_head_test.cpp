#include "drivers/pan_tilt/ptu_head.h"

#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include "drivers/emulators/ptu_emulator.h"
#include "tests/drivers/devices/waiting.h"

namespace handmap {
namespace {

using test::pass;
using test::StateLog;
using test::waitUntil;

constexpr double kHaste = 20.0;

struct Rig {
  explicit Rig(EmulatedPort::Kind kind = EmulatedPort::Kind::PseudoTerminal)
      : emulator(kind, kHaste),
        head(parsePortAddress(emulator.port().address(), PtuHead::kBaud), startedRigClock()),
        log(head) {
    QObject::connect(&head, &PanTiltHead::arrived, &head, [this](double pan, double tilt) {
      ++arrivals;
      where = {pan, tilt};
    });
  }
  bool becomesReady() {
    head.open();
    return waitUntil([this] { return log.is(DeviceState::Ready); });
  }
  bool looksAt(double pan_deg, double tilt_deg, int timeout_ms = 30000) {
    arrivals = 0;
    head.lookAt(toRadians(pan_deg), toRadians(tilt_deg));
    return waitUntil([this] { return arrivals > 0; }, timeout_ms) &&
           std::abs(toDegrees(where.pan) - pan_deg) < 0.1 &&
           std::abs(toDegrees(where.tilt) - tilt_deg) < 0.1;
  }

  PtuEmulator emulator;
  PtuHead head;
  StateLog log;
  Look where;
  int arrivals = 0;
};

class PtuHeadOnPort : public testing::TestWithParam<EmulatedPort::Kind> {};

TEST_P(PtuHeadOnPort, SwitchesEchoAndWordsOffAndLooksAround) {
  Rig rig(GetParam());
  ASSERT_TRUE(rig.becomesReady());
  for (const double pan : {60.0, 120.0, -60.0, 0.0}) {
    EXPECT_TRUE(rig.looksAt(pan, -10.0)) << pan;
    EXPECT_NEAR(rig.emulator.pan().position, pan * 3600.0 / 185.1428, 1.0);
  }
  for (const std::string& command : rig.emulator.takeCommands()) EXPECT_NE(command, "DS");
}

INSTANTIATE_TEST_SUITE_P(Kinds, PtuHeadOnPort,
                         testing::Values(EmulatedPort::Kind::PseudoTerminal,
                                         EmulatedPort::Kind::Tcp));

TEST(PtuHead, AnotherResolutionAndNarrowLimitsAreKeptTo) {
  Rig rig;
  rig.emulator.pan().resolution_arcsec = 92.5714;
  rig.emulator.pan().least = -1000;
  rig.emulator.pan().most = 1000;
  ASSERT_TRUE(rig.becomesReady());
  EXPECT_TRUE(rig.looksAt(20.0, 0.0));
  rig.arrivals = 0;
  rig.head.lookAt(toRadians(90.0), 0.0);
  ASSERT_TRUE(waitUntil([&] { return rig.arrivals > 0; }));
  EXPECT_EQ(rig.emulator.pan().position, 1000.0);
}

TEST(PtuHead, HaltStopsItOnTheWay) {
  Rig rig;
  rig.emulator.pan().acceleration = 100.0;  // slow enough to be caught
  ASSERT_TRUE(rig.becomesReady());
  rig.head.lookAt(toRadians(150.0), 0.0);
  ASSERT_TRUE(waitUntil([&] { return rig.emulator.pan().position > 50.0; }));
  rig.head.halt();
  ASSERT_TRUE(waitUntil([&] { return !rig.emulator.pan().moving(); }));
  EXPECT_LT(rig.emulator.pan().position, 2900.0);
  EXPECT_EQ(rig.arrivals, 0);
  EXPECT_TRUE(rig.looksAt(0.0, 0.0));
}

TEST(PtuHead, ANewWayReplacesTheOneUnderWay) {
  Rig rig;
  rig.emulator.pan().acceleration = 100.0;
  ASSERT_TRUE(rig.becomesReady());
  rig.head.lookAt(toRadians(150.0), 0.0);
  ASSERT_TRUE(waitUntil([&] { return rig.emulator.pan().position > 50.0; }));
  EXPECT_TRUE(rig.looksAt(-10.0, 5.0));
  EXPECT_EQ(rig.arrivals, 1);
}

TEST(PtuHead, EchoAndWordsInTheMiddleOfARunAreStood) {
  Rig rig;
  ASSERT_TRUE(rig.becomesReady());
  rig.emulator.setEcho(true);
  rig.emulator.setVerbose(true);
  EXPECT_TRUE(rig.looksAt(30.0, 0.0));
}

TEST(PtuHead, DroppedBytesAreMadeGood) {
  Rig rig;
  rig.emulator.port().setFaults({.dropped = 0.005});
  ASSERT_TRUE(waitUntil([&] { return rig.becomesReady(); }, 120000));
  for (const double pan : {30.0, -30.0}) EXPECT_TRUE(rig.looksAt(pan, 0.0, 120000));
}

TEST(PtuHead, DoubledBytesAreMadeGood) {
  Rig rig;
  rig.emulator.port().setFaults({.doubled = 0.005});
  ASSERT_TRUE(waitUntil([&] { return rig.becomesReady(); }, 120000));
  for (const double pan : {30.0, -30.0}) EXPECT_TRUE(rig.looksAt(pan, 0.0, 120000));
}

TEST(PtuHead, LateAnswersAreNotTakenForThoseOfLaterCommands) {
  Rig rig;
  ASSERT_TRUE(rig.becomesReady());
  rig.emulator.port().setFaults({.delay_ms = 1300});
  EXPECT_TRUE(rig.looksAt(25.0, -5.0, 120000));
}

TEST(PtuHead, ALimitThatIsHitResetsTheHeadAndTheWayIsFinished) {
  Rig rig;
  ASSERT_TRUE(rig.becomesReady());
  rig.emulator.pan().obstacle = 500.0;
  EXPECT_TRUE(rig.looksAt(60.0, 0.0));
  EXPECT_TRUE(rig.log.was(DeviceState::Degraded));
  EXPECT_NE(rig.log.details[rig.log.details.size() - 1], "the head ran against its pan limit");
  EXPECT_TRUE(rig.log.is(DeviceState::Ready));
  const auto commands = rig.emulator.takeCommands();
  EXPECT_EQ(std::count(commands.begin(), commands.end(), "R"), 1);
}

TEST(PtuHead, ALimitHitTwiceOnOneWayLeavesItStanding) {
  Rig rig;
  rig.emulator.pan().obstacle = 500.0;
  rig.emulator.pan().obstacle_stays = true;
  ASSERT_TRUE(rig.becomesReady());
  rig.head.lookAt(toRadians(60.0), 0.0);
  ASSERT_TRUE(waitUntil([&] {
    return rig.log.is(DeviceState::Degraded) &&
           rig.log.details.back().find("twice") != std::string::npos;
  }));
  pass(300);
  EXPECT_EQ(rig.arrivals, 0);
  EXPECT_TRUE(rig.looksAt(-30.0, 0.0));
}

TEST(PtuHead, UnpluggedAndPluggedInAgainItGoesOnWithItsWay) {
  Rig rig;
  rig.emulator.pan().acceleration = 100.0;
  ASSERT_TRUE(rig.becomesReady());
  for (int round = 0; round < 2; ++round) {
    const double pan = round == 0 ? 60.0 : -60.0;
    rig.arrivals = 0;
    rig.head.lookAt(toRadians(pan), 0.0);
    ASSERT_TRUE(waitUntil([&] { return rig.emulator.pan().moving(); }));
    rig.emulator.port().unplug();
    ASSERT_TRUE(waitUntil([&] { return rig.log.is(DeviceState::Lost); }));
    rig.emulator.setEcho(true);  // it lost its power as well
    rig.emulator.setVerbose(true);
    rig.emulator.port().plug();
    ASSERT_TRUE(waitUntil([&] { return rig.arrivals > 0; }));
    EXPECT_NEAR(toDegrees(rig.where.pan), pan, 0.1);
  }
}

TEST(PtuHead, AHeadThatFallsSilentIsLostAndFoundAgain) {
  Rig rig;
  ASSERT_TRUE(rig.becomesReady());
  rig.emulator.setDead(true);
  ASSERT_TRUE(waitUntil([&] { return rig.log.is(DeviceState::Degraded); }));
  EXPECT_NE(rig.log.details.back().find("does not answer"), std::string::npos);
  ASSERT_TRUE(waitUntil([&] { return rig.log.is(DeviceState::Lost); }, 60000));
  EXPECT_NE(rig.log.details.back().find("does not answer"), std::string::npos);
  rig.emulator.setDead(false);
  EXPECT_TRUE(waitUntil([&] { return rig.log.is(DeviceState::Ready); }));
}

TEST(PtuHead, CloseHaltsIt) {
  Rig rig;
  rig.emulator.pan().acceleration = 100.0;
  ASSERT_TRUE(rig.becomesReady());
  rig.head.lookAt(toRadians(150.0), 0.0);
  ASSERT_TRUE(waitUntil([&] { return rig.emulator.pan().position > 50.0; }));
  rig.head.close();
  EXPECT_TRUE(rig.log.is(DeviceState::Closed));
  ASSERT_TRUE(waitUntil([&] { return !rig.emulator.pan().moving(); }));
  EXPECT_LT(rig.emulator.pan().position, 2900.0);
}

TEST(PtuHead, WorksThroughAPairOfPseudoTerminalsMadeBySocat) {
  const QString socat = QStandardPaths::findExecutable(QStringLiteral("socat"));
  if (socat.isEmpty()) GTEST_SKIP() << "socat is not installed";
  const QTemporaryDir folder;
  const QString ours = folder.filePath(QStringLiteral("ours"));
  PtuEmulator emulator(EmulatedPort::Kind::PseudoTerminal, kHaste);
  QProcess process;
  process.start(socat, {QStringLiteral("pty,raw,echo=0,link=%1").arg(ours),
                        QStringLiteral("file:%1,raw,echo=0")
                            .arg(QString::fromStdString(emulator.port().address()))});
  ASSERT_TRUE(waitUntil([&] { return QFile::exists(ours); }));
  PtuHead head(parsePortAddress(ours.toStdString(), PtuHead::kBaud), startedRigClock());
  const StateLog log(head);
  int arrivals = 0;
  QObject::connect(&head, &PanTiltHead::arrived, &head, [&] { ++arrivals; });
  head.open();
  head.lookAt(toRadians(45.0), 0.0);
  EXPECT_TRUE(waitUntil([&] { return arrivals == 1; }));
  process.kill();
  EXPECT_TRUE(waitUntil([&] { return log.is(DeviceState::Lost); }));
  process.waitForFinished();
}

}  // namespace
}  // namespace handmap
