#include "drivers/odometry_lines/line_odometry.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "drivers/emulators/odometry_emulator.h"
#include "drivers/odometry_lines/odometry_line.h"
#include "tests/drivers/devices/waiting.h"

namespace handmap {
namespace {

using test::StateLog;
using test::waitUntil;
using Form = OdometryEmulator::Form;

TEST(OdometryLine, BothFormsAreRead) {
  for (const char* line : {"odom,12.5,1,-2e0,4.0", " odom, 12.5, 1, -2, 4 \r",
                           R"({"t":12.5,"x":1,"y":-2,"yaw":4,"battery":11.9})"}) {
    const OdometryLine read = parseOdometryLine(line);
    EXPECT_EQ(read.stamp_s, 12.5);
    EXPECT_EQ(read.pose.x, 1.0);
    EXPECT_EQ(read.pose.y, -2.0);
    EXPECT_NEAR(read.pose.heading, 4.0 - 2.0 * kPi, 1e-12);
  }
  EXPECT_EQ(parseOdometryLine("odom,1,2,3,0*09").pose.y, 3.0);
}

TEST(OdometryLine, OthersAreRefusedWithAWord) {
  for (const std::string line :
       {"", "odom", "odom,1,2,3", "odom,1,2,3,4,5", "odom,1,nan,3,4", "odom,1,2,1e300,4",
        "odom,inf,2,3,4", "odom,1,2,3,4*00", "ODOM,1,2,3,4", "{}", "{\"t\":1",
        R"({"t":1,"x":"2","y":3,"yaw":4})", R"({"t":1,"x":2,"y":3,"yaw":1e9})"}) {
    try {
      parseOdometryLine(line);
      ADD_FAILURE() << line;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::BadInput);
      EXPECT_NE(std::string(error.what()).find("expected"), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW(parseOdometryLine(std::string(100'000, '[')), Error);
  EXPECT_THROW(parseOdometryLine("{\"t\":" + std::string(100'000, '[')), Error);
}

/// 2 m/s in a circle of 10 m.
Pose2 circle(double time_s) {
  const double turned = 0.2 * time_s;
  return {10.0 * std::sin(turned), 10.0 * (1.0 - std::cos(turned)), normalizedAngle(turned)};
}

struct Base {
  explicit Base(EmulatedPort::Kind kind, Form form)
      : emulator(kind, circle, form),
        clock(startedRigClock()),
        odometry(parsePortAddress(emulator.port().address(), 115200), clock),
        log(odometry) {
    QObject::connect(&odometry, &OdometrySensor::moved, &odometry,
                     [this](double time_s, const Pose2& pose) {
                       // The emulator and the rig began at the same time, but for milliseconds.
                       const Pose2 expected = circle(time_s);
                       worst = std::max(worst, (pose.position() - expected.position()).norm());
                       if (time_s <= last_s) ++backwards;
                       last_s = time_s;
                       ++count;
                     });
  }
  bool comes(int more) {
    const int before = count;
    return waitUntil([&] { return count >= before + more; });
  }
  OdometryEmulator emulator;
  RigClock clock;
  LineOdometry odometry;
  StateLog log;
  double worst = 0.0;
  double last_s = -1.0;
  int backwards = 0;
  int count = 0;
};

class LineOdometryOf : public testing::TestWithParam<std::tuple<EmulatedPort::Kind, Form>> {};

TEST_P(LineOdometryOf, MovesInTheRigsTime) {
  Base base(std::get<0>(GetParam()), std::get<1>(GetParam()));
  base.odometry.open();
  ASSERT_TRUE(base.comes(30));
  EXPECT_TRUE(base.log.is(DeviceState::Ready));
  EXPECT_EQ(base.backwards, 0);
  EXPECT_LT(base.worst, 0.5);  // 0.25 s at 2 m/s: a busy machine
}

INSTANTIATE_TEST_SUITE_P(
    Forms, LineOdometryOf,
    testing::Combine(testing::Values(EmulatedPort::Kind::PseudoTerminal, EmulatedPort::Kind::Tcp),
                     testing::Values(Form::Fields, Form::FieldsWithChecksum, Form::Json)));

TEST(LineOdometry, TheBaseMayAskToLookAround) {
  Base base(EmulatedPort::Kind::PseudoTerminal, Form::Fields);
  int asked = 0;
  QObject::connect(&base.odometry, &OdometrySensor::lookAsked, &base.odometry, [&] { ++asked; });
  base.odometry.open();
  ASSERT_TRUE(base.comes(2));
  base.emulator.say("look\r\n{\"look\":true}\n");
  EXPECT_TRUE(waitUntil([&] { return asked == 2; }));
  EXPECT_EQ(base.odometry.refusedLines(), 0);
}

TEST(LineOdometry, OtherLinesArePassedOverAndMuchOfThemIsSaid) {
  Base base(EmulatedPort::Kind::PseudoTerminal, Form::Fields);
  base.odometry.open();
  ASSERT_TRUE(base.comes(5));
  base.emulator.say("battery 11.9 V\n");
  ASSERT_TRUE(base.comes(5));
  EXPECT_EQ(base.odometry.refusedLines(), 1);
  EXPECT_TRUE(base.log.is(DeviceState::Ready));
  for (int i = 0; i < 20; ++i) base.emulator.say("odom,1,2,3\n");
  ASSERT_TRUE(waitUntil([&] { return base.log.is(DeviceState::Degraded); }));
  EXPECT_NE(base.log.details.back().find("odom,1,2,3"), std::string::npos);
  EXPECT_TRUE(waitUntil([&] { return base.log.is(DeviceState::Ready); }));
}

TEST(LineOdometry, ACheckedLineThatIsDamagedIsNotBelieved) {
  Base base(EmulatedPort::Kind::PseudoTerminal, Form::FieldsWithChecksum);
  base.emulator.port().setFaults({.dropped = 2e-3, .doubled = 2e-3});
  base.odometry.open();
  ASSERT_TRUE(waitUntil([&] { return base.odometry.refusedLines() > 10; }));
  EXPECT_LT(base.worst, 0.5);
}

TEST(LineOdometry, AJumpOfTheClockIsSaidAndCostsNothing) {
  Base base(EmulatedPort::Kind::PseudoTerminal, Form::Json);
  base.odometry.open();
  ASSERT_TRUE(base.comes(10));
  for (const double jump : {3600.0, -7200.0}) {
    base.emulator.jumpClock(jump);
    ASSERT_TRUE(base.comes(10));
    EXPECT_TRUE(base.log.is(DeviceState::Degraded));
    EXPECT_NE(base.log.details.back().find("clock"), std::string::npos);
  }
  EXPECT_EQ(base.odometry.clockJumps(), 2);
  EXPECT_EQ(base.backwards, 0);
  EXPECT_LT(base.worst, 0.5);
}

TEST(LineOdometry, UnpluggedOrSilentItIsSaidAndItComesBack) {
  Base base(EmulatedPort::Kind::PseudoTerminal, Form::Fields);
  base.odometry.open();
  ASSERT_TRUE(base.comes(5));
  base.emulator.port().unplug();
  ASSERT_TRUE(waitUntil([&] { return base.log.is(DeviceState::Lost); }));
  base.emulator.port().plug();
  ASSERT_TRUE(base.comes(5));
  base.emulator.setDead(true);
  ASSERT_TRUE(waitUntil([&] {
    return base.log.is(DeviceState::Degraded) &&
           base.log.details.back().find("no odometry") != std::string::npos;
  }));
  base.emulator.setDead(false);
  ASSERT_TRUE(base.comes(5));
  EXPECT_TRUE(waitUntil([&] { return base.log.is(DeviceState::Ready); }));
}

}  // namespace
}  // namespace handmap
