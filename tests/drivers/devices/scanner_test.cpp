#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "drivers/emulators/hokuyo_emulator.h"
#include "drivers/emulators/rplidar_emulator.h"
#include "drivers/scanner/hokuyo_scanner.h"
#include "drivers/scanner/rplidar_scanner.h"
#include "tests/drivers/devices/waiting.h"

namespace handmap {
namespace {

using test::StateLog;
using test::waitUntil;

/// A room of 8 × 4 m without a wall behind; the scanner 3 m from the wall ahead, 1 m from the left
/// one.
double room(double angle) {
  const Vec2 direction = unitVector(angle);
  double range = std::numeric_limits<double>::infinity();
  if (direction.x() > 1e-9) range = std::min(range, 3.0 / direction.x());
  if (direction.y() > 1e-9) range = std::min(range, 1.0 / direction.y());
  if (direction.y() < -1e-9) range = std::min(range, -3.0 / direction.y());
  return range < 12.0 ? range : std::numeric_limits<double>::infinity();
}

/// Metres from the nearest wall of the room.
double offTheWalls(const RangePoint& point) {
  const double ahead = std::abs(point.x - 3.0F);
  const double left = std::abs(point.y - 1.0F);
  const double right = std::abs(point.y + 3.0F);
  return std::min({ahead, left, right});
}

struct Scans {
  explicit Scans(RangeSensor& sensor, RigClock clock) : log(sensor) {
    QObject::connect(&sensor, &RangeSensor::scanned, &log.context,
                     [this, clock](double time_s, const std::vector<RangePoint>& points) {
                       delays.push_back(clock() - time_s);
                       last = points;
                       ++count;
                       for (const RangePoint& point : points) {
                         worst = std::max(worst, offTheWalls(point));
                       }
                     });
  }
  bool comes(int more = 3) {
    const int before = count;
    return waitUntil([&] { return count >= before + more; });
  }
  StateLog log;
  std::vector<RangePoint> last;
  std::vector<double> delays;
  double worst = 0.0;  ///< of all points
  int count = 0;
};

class HokuyoOnPort : public testing::TestWithParam<EmulatedPort::Kind> {};

TEST_P(HokuyoOnPort, ScansTheRoom) {
  HokuyoEmulator emulator(GetParam(), room);
  const RigClock clock = startedRigClock();
  HokuyoScanner scanner(parsePortAddress(emulator.port().address(), 115200), clock);
  Scans scans(scanner, clock);
  scanner.open();
  ASSERT_TRUE(scans.comes(10));
  EXPECT_TRUE(scans.log.is(DeviceState::Ready));
  EXPECT_EQ(scans.log.details.back(), "Emulated");
  EXPECT_GT(scans.last.size(), 600U);
  EXPECT_LT(scans.worst, 0.01);
  for (const double delay : scans.delays) EXPECT_GE(delay, 0.009);  // half a scan at least
  scanner.close();
  EXPECT_TRUE(waitUntil([&] { return !emulator.isMeasuring() && !emulator.isLaserOn(); }));
  EXPECT_TRUE(scans.log.is(DeviceState::Closed));
}

INSTANTIATE_TEST_SUITE_P(Kinds, HokuyoOnPort,
                         testing::Values(EmulatedPort::Kind::PseudoTerminal,
                                         EmulatedPort::Kind::Tcp));

TEST(HokuyoScanner, OneThatWasLeftMeasuringIsTakenOver) {
  HokuyoEmulator emulator(EmulatedPort::Kind::PseudoTerminal, room);
  const RigClock clock = startedRigClock();
  for (int round = 0; round < 2; ++round) {
    HokuyoScanner scanner(parsePortAddress(emulator.port().address(), 115200), clock);
    Scans scans(scanner, clock);
    scanner.open();
    ASSERT_TRUE(scans.comes());
    if (round == 0) emulator.setDead(true);  // does not hear that it should stop
    scanner.close();
    test::pass(50);
    emulator.setDead(false);
    EXPECT_EQ(emulator.isMeasuring(), round == 0);
  }
}

// A sum has six bits: bytes lost and doubled in one line would pass now and then.
TEST(HokuyoScanner, LostBytesCostScansButNeverGivePointsThatAreNotThere) {
  HokuyoEmulator emulator(EmulatedPort::Kind::PseudoTerminal, room);
  const RigClock clock = startedRigClock();
  HokuyoScanner scanner(parsePortAddress(emulator.port().address(), 115200), clock);
  Scans scans(scanner, clock);
  scanner.open();
  ASSERT_TRUE(scans.comes());
  emulator.port().setFaults({.dropped = 1e-4});
  ASSERT_TRUE(waitUntil([&] { return scanner.damagedAnswers() > 10; }));
  ASSERT_TRUE(scans.comes());
  EXPECT_LT(scans.worst, 0.01);
}

TEST(HokuyoScanner, ComesBackAfterUnpluggingSilenceAndAJumpOfItsClock) {
  HokuyoEmulator emulator(EmulatedPort::Kind::PseudoTerminal, room);
  const RigClock clock = startedRigClock();
  HokuyoScanner scanner(parsePortAddress(emulator.port().address(), 115200), clock);
  Scans scans(scanner, clock);
  scanner.open();
  ASSERT_TRUE(scans.comes());
  emulator.port().unplug();
  ASSERT_TRUE(waitUntil([&] { return scans.log.is(DeviceState::Lost); }));
  emulator.port().plug();
  ASSERT_TRUE(scans.comes());
  emulator.setDead(true);
  ASSERT_TRUE(waitUntil([&] { return scans.log.is(DeviceState::Lost); }));
  EXPECT_NE(scans.log.details.back().find("no whole scan"), std::string::npos);
  emulator.setDead(false);
  ASSERT_TRUE(scans.comes());
  emulator.jumpClock(-3'600'000);
  ASSERT_TRUE(scans.comes(5));
  emulator.jumpClock(3'000'000);
  ASSERT_TRUE(scans.comes(5));
  EXPECT_LT(*std::max_element(scans.delays.begin(), scans.delays.end()), 60.0);
  EXPECT_GE(*std::min_element(scans.delays.begin(), scans.delays.end()), 0.0);
}

TEST(HokuyoScanner, AnotherDeviceAtThePortIsNamed) {
  RplidarEmulator emulator(EmulatedPort::Kind::PseudoTerminal, room,
                           RplidarEmulator::Express::None);
  HokuyoScanner scanner(parsePortAddress(emulator.port().address(), 115200), startedRigClock());
  const StateLog log(scanner);
  scanner.open();
  ASSERT_TRUE(waitUntil([&] { return log.is(DeviceState::Lost); }));
  EXPECT_NE(log.details.back().find("does not answer as a Hokuyo"), std::string::npos);
}

class RplidarExpress : public testing::TestWithParam<RplidarEmulator::Express> {};

TEST_P(RplidarExpress, ScansTheRoom) {
  RplidarEmulator emulator(EmulatedPort::Kind::PseudoTerminal, room, GetParam());
  const RigClock clock = startedRigClock();
  RplidarScanner scanner(parsePortAddress(emulator.port().address(), 115200), clock);
  Scans scans(scanner, clock);
  scanner.open();
  ASSERT_TRUE(scans.comes(10));
  EXPECT_TRUE(scans.log.is(DeviceState::Ready));
  EXPECT_GT(scans.last.size(), 300U);
  // Angles are told to a 64th of a degree, ranges to a millimetre; walls are seen at a slant.
  EXPECT_LT(scans.worst, 0.05);
  scanner.close();
  EXPECT_TRUE(waitUntil([&] { return !emulator.isMeasuring(); }));
}

TEST_P(RplidarExpress, LostBytesCostTurnsButTheRoomStaysAsItIs) {
  RplidarEmulator emulator(EmulatedPort::Kind::Tcp, room, GetParam());
  const RigClock clock = startedRigClock();
  RplidarScanner scanner(parsePortAddress(emulator.port().address(), 115200), clock);
  Scans scans(scanner, clock);
  scanner.open();
  ASSERT_TRUE(scans.comes());
  emulator.port().setFaults({.dropped = 1e-4});
  ASSERT_TRUE(waitUntil([&] { return scanner.damagedAnswers() > 5; }));
  ASSERT_TRUE(scans.comes(5));
  // A node has no sum: a wrong one may get through. Capsules have.
  if (GetParam() != RplidarEmulator::Express::None) {
    EXPECT_LT(scans.worst, 0.05);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, RplidarExpress,
                         testing::Values(RplidarEmulator::Express::None,
                                         RplidarEmulator::Express::Capsules,
                                         RplidarEmulator::Express::Dense));

TEST(RplidarScanner, OneThatReportsAnErrorIsResetAndComesBackAfterUnplugging) {
  RplidarEmulator emulator(EmulatedPort::Kind::PseudoTerminal, room,
                           RplidarEmulator::Express::Dense);
  emulator.setHealth(2);
  const RigClock clock = startedRigClock();
  RplidarScanner scanner(parsePortAddress(emulator.port().address(), 115200), clock);
  Scans scans(scanner, clock);
  scanner.open();
  ASSERT_TRUE(scans.comes());
  EXPECT_EQ(emulator.resets(), 1);
  EXPECT_TRUE(scans.log.was(DeviceState::Degraded));
  emulator.port().unplug();
  ASSERT_TRUE(waitUntil([&] { return scans.log.is(DeviceState::Lost); }));
  emulator.port().plug();
  ASSERT_TRUE(scans.comes());
  emulator.setDead(true);
  ASSERT_TRUE(waitUntil([&] { return scans.log.is(DeviceState::Lost); }));
  emulator.setDead(false);
  ASSERT_TRUE(scans.comes());
}

}  // namespace
}  // namespace handmap
