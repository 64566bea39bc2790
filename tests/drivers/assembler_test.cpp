#include "drivers/live/assembler.h"

#include <cmath>
#include <limits>
#include <map>

#include <gtest/gtest.h>

namespace handmap {
namespace {

Rig laserCart() {
  Rig rig;
  rig.scanner = ScannerRig{};
  rig.odometry = {OdometryRigKind::Lines, "x", ""};
  return rig;
}

Rig stopAndLook() {
  Rig rig;
  rig.camera = CameraRig{};
  rig.head = HeadRig{"x"};
  rig.odometry = {OdometryRigKind::Lines, "x", ""};
  rig.stops = sixPans();
  return rig;
}

std::vector<RangePoint> onePoint() { return {{1.0F, 0.0F, 0.0F, 1.0F}}; }

struct Assembled {
  explicit Assembled(const Rig& rig)
      : assembler(rig, {[this](Observation o) { observations.push_back(std::move(o)); },
                        [this](double pan) { looks.push_back(pan); },
                        [this](const std::string& reason) { ++refused[reason]; }}) {}
  Assembled(const Assembled&) = delete;

  std::vector<Observation> observations;
  std::vector<double> looks;
  std::map<std::string, int> refused;
  Assembler assembler;
};

TEST(Assembler, WaitsForTheOdometryOfAScanAndInterpolates) {
  Assembled heard(laserCart());
  heard.assembler.moved(1.0, {1.0, 0.0, 0.0}, 1.0);
  heard.assembler.scanned(1.05, onePoint(), 1.06);
  EXPECT_TRUE(heard.observations.empty());
  heard.assembler.moved(1.1, {2.0, 0.0, 0.0}, 1.1);
  ASSERT_EQ(heard.observations.size(), 1U);
  EXPECT_EQ(heard.observations[0].time_s, 1.05);
  EXPECT_NEAR(heard.observations[0].odometry.x, 1.5, 1e-9);
  EXPECT_FALSE(heard.observations[0].standing);
  EXPECT_TRUE(heard.refused.empty());
}

TEST(Assembler, PointsAreMovedToWhereTheScannerIs) {
  Rig rig = laserCart();
  rig.scanner->mount = {0.5, 0.25, 0.75, kPi / 2.0};
  Assembled heard(rig);
  heard.assembler.moved(1.0, {}, 1.0);
  heard.assembler.scanned(1.0, onePoint(), 1.0);
  ASSERT_EQ(heard.observations.size(), 1U);
  const RangePoint point = heard.observations[0].views[0].points->front();
  EXPECT_NEAR(point.x, 0.5, 1e-6);
  EXPECT_NEAR(point.y, 1.25, 1e-6);
  EXPECT_NEAR(point.z, 0.75, 1e-6);
}

/// Scans and odometries a second; odometry comes late and never quite at its time.
class AssemblerAt : public testing::TestWithParam<std::pair<double, double>> {};

TEST_P(AssemblerAt, EveryScanGetsTheOdometryAroundIt) {
  const double scans_hz = GetParam().first;
  const double odometries_hz = GetParam().second;
  Assembled heard(laserCart());
  constexpr double kFor_s = 20.0;
  int scans = 0;
  int odometries = 0;
  const auto odometry_time = [&](int i) {
    return (i + 0.1 * std::sin(5.0 * i)) / odometries_hz + 1.0;
  };
  for (double now = 1.0; now < 1.0 + kFor_s; now += 0.001) {
    if (odometry_time(odometries) + 0.05 < now) {
      const double time_s = odometry_time(odometries++);
      heard.assembler.moved(time_s, {time_s, 0.0, 0.0}, now);
    }
    if (1.001 + scans / scans_hz < now) {
      heard.assembler.scanned(1.001 + scans++ / scans_hz, onePoint(), now);
    }
    heard.assembler.tick(now);
  }
  const double lost_at_most = 1.5 * scans_hz;  // at the beginning, while the rate is not yet known
  const double waiting_at_most = 1.5 * scans_hz / odometries_hz + 3.0;
  EXPECT_GE(static_cast<double>(heard.observations.size()), scans - lost_at_most - waiting_at_most);
  for (const Observation& observation : heard.observations) {
    EXPECT_NEAR(observation.odometry.x, observation.time_s, 1e-9);
  }
  const auto later = heard.refused["no odometry at the time of an observation"];
  EXPECT_LE(later, lost_at_most);
  EXPECT_EQ(heard.refused.size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(Rates, AssemblerAt,
                         testing::Values(std::pair(40.0, 20.0), std::pair(10.0, 1.0),
                                         std::pair(40.0, 1.0), std::pair(10.0, 50.0)));

TEST(Assembler, OdometryTooFarApartIsSaidAndHoldsNothingUp) {
  Assembled heard(laserCart());
  heard.assembler.moved(1.0, {}, 1.0);
  heard.assembler.scanned(2.4, onePoint(), 2.4);
  heard.assembler.moved(2.6, {}, 2.6);  // what was in between is known now: nothing
  EXPECT_EQ(heard.refused["odometry too far apart around an observation"], 1);
  heard.assembler.scanned(2.6, onePoint(), 2.6);
  EXPECT_EQ(heard.observations.size(), 1U);
}

TEST(Assembler, GivesUpOnOdometryThatDoesNotCome) {
  Assembled heard(laserCart());
  heard.assembler.moved(1.0, {}, 1.0);
  heard.assembler.scanned(1.2, onePoint(), 1.2);
  heard.assembler.tick(1.5);
  EXPECT_TRUE(heard.refused.empty());
  heard.assembler.tick(1.8);
  EXPECT_EQ(heard.refused["no odometry at the time of an observation"], 1);
  // It comes back: what was measured in between stays unknown, the run goes on.
  heard.assembler.moved(5.0, {3.0, 0.0, 0.0}, 5.0);
  heard.assembler.scanned(5.0, onePoint(), 5.0);
  ASSERT_EQ(heard.observations.size(), 1U);
  EXPECT_EQ(heard.observations[0].odometry.x, 3.0);
}

TEST(Assembler, DoesNotUseWhatIsLateRepeatedOrFromTheFuture) {
  Assembled heard(laserCart());
  Assembler& assembler = heard.assembler;
  assembler.moved(10.0, {}, 10.0);
  assembler.moved(10.0, {9.0, 0.0, 0.0}, 10.0);
  assembler.moved(99.0, {9.0, 0.0, 0.0}, 10.0);
  assembler.moved(std::numeric_limits<double>::quiet_NaN(), {}, 10.0);
  assembler.moved(10.1, {std::numeric_limits<double>::infinity(), 0.0, 0.0}, 10.1);
  assembler.scanned(7.0, onePoint(), 10.0);
  assembler.scanned(10.0, onePoint(), 10.0);
  assembler.scanned(10.0, onePoint(), 10.0);
  assembler.scanned(9.9, onePoint(), 10.0);
  assembler.scanned(10.05, {}, 10.05);
  ASSERT_EQ(heard.observations.size(), 1U);
  EXPECT_EQ(heard.observations[0].odometry, Pose2{});
  EXPECT_EQ(heard.refused["odometry repeated or out of order"], 1);
  EXPECT_EQ(heard.refused["odometry stamped in the future"], 2);
  EXPECT_EQ(heard.refused["odometry that is not finite"], 1);
  EXPECT_EQ(heard.refused["scan late"], 1);
  EXPECT_EQ(heard.refused["scan repeated or out of order"], 2);
  EXPECT_EQ(heard.refused["scan without a single return"], 1);
}

TEST(Assembler, NamesAScanThatComesAgainThoughTheRobotHasMoved) {
  std::vector<RangePoint> scan;
  for (int i = 0; i < 30; ++i) scan.push_back({5.0F, 0.1F * static_cast<float>(i), 0.0F, 1.0F});
  Assembled heard(laserCart());
  const auto see = [&](double time_s, const Pose2& pose, const std::vector<RangePoint>& points) {
    heard.assembler.moved(time_s, pose, time_s);
    heard.assembler.scanned(time_s, points, time_s);
  };
  see(1.0, {}, scan);
  see(1.2, {0.05, 0.0, 0.0}, scan);  // as good as standing
  EXPECT_EQ(heard.observations.size(), 2U);
  see(1.4, {0.2, 0.0, 0.0}, scan);
  see(1.6, {0.0, 0.0, 0.1}, scan);
  EXPECT_EQ(heard.observations.size(), 2U);
  EXPECT_EQ(heard.refused["the same scan again, though the robot has moved"], 2);
  scan[7].x += 0.01F;
  see(1.8, {0.5, 0.0, 0.0}, scan);
  EXPECT_EQ(heard.observations.size(), 3U);
  see(2.0, {0.9, 0.0, 0.0}, {scan.begin(), scan.begin() + 5});  // so few may be the same
  see(2.2, {1.3, 0.0, 0.0}, {scan.begin(), scan.begin() + 5});
  EXPECT_EQ(heard.observations.size(), 5U);
  std::vector<RangePoint> open_field(40, notMeasured(0.0, 0.0F));  // the same everywhere
  open_field.push_back({5.0F, 0.0F, 0.0F, 1.0F});
  see(2.4, {1.7, 0.0, 0.0}, open_field);
  see(2.6, {2.1, 0.0, 0.0}, open_field);
  EXPECT_EQ(heard.observations.size(), 7U);
}

TEST(Assembler, RaysThatWereNotMeasuredKeepTheirDirections) {
  Rig rig = laserCart();
  rig.scanner->mount = {0.5, 0.25, 0.75, kPi / 2.0};
  Assembled heard(rig);
  heard.assembler.moved(1.0, {}, 1.0);
  heard.assembler.scanned(1.0, {notMeasured(0.0, 0.0F), {2.0F, 0.0F, 0.0F, 1.0F}}, 1.0);
  ASSERT_EQ(heard.observations.size(), 1U);
  const std::vector<RangePoint>& points = *heard.observations[0].views[0].points;
  ASSERT_EQ(points.size(), 2U);
  EXPECT_FALSE(isMeasured(points[0]));
  EXPECT_NEAR(std::atan2(points[0].y, points[0].x), kPi / 2.0, 1e-6);
  heard.assembler.moved(1.1, {}, 1.1);
  heard.assembler.scanned(1.1, {notMeasured(0.0, 0.0F)}, 1.1);
  EXPECT_EQ(heard.refused["scan without a single return"], 1);
}

TEST(Assembler, WhereTheScannerFallsSilentItGoesOnByOdometryAlone) {
  Assembled heard(laserCart());
  heard.assembler.tick(5.0);
  EXPECT_TRUE(heard.observations.empty()) << "the drive has not begun";
  heard.assembler.moved(5.0, {}, 5.0);
  heard.assembler.scanned(5.0, onePoint(), 5.0);
  for (int i = 1; i <= 40; ++i) {
    const double now_s = 5.0 + 0.05 * i;
    heard.assembler.moved(now_s, {0.07 * i, 0.0, 0.0}, now_s);
    heard.assembler.tick(now_s);
    if (now_s < 5.99) {
      EXPECT_EQ(heard.observations.size(), 1U);
    }
  }
  ASSERT_GE(heard.observations.size(), 5U) << "four times a second";
  ASSERT_LE(heard.observations.size(), 6U);
  EXPECT_TRUE(seesAnything(heard.observations[0]));
  EXPECT_FALSE(seesAnything(heard.observations.back()));
  EXPECT_FALSE(heard.observations.back().views.at(0).points->empty()) << "so that it is recorded";
  EXPECT_NEAR(heard.observations.back().odometry.x, 2.8, 0.3);
  heard.assembler.moved(7.1, {3.0, 0.0, 0.0}, 7.1);
  heard.assembler.scanned(7.1, onePoint(), 7.1);
  EXPECT_TRUE(seesAnything(heard.observations.back()));
  const std::size_t count = heard.observations.size();
  heard.assembler.tick(7.5);
  EXPECT_EQ(heard.observations.size(), count);
  // Odometry that is silent too tells nothing more.
  heard.assembler.tick(9.5);
  heard.assembler.tick(10.0);
  EXPECT_EQ(heard.observations.size(), count);
}

TEST(Assembler, BetweenTwoStopsItIsSilentAsItShouldBe) {
  Assembled heard(stopAndLook());
  for (int i = 0; i < 100; ++i) {
    heard.assembler.moved(0.1 * i, {0.1 * i, 0.0, 0.0}, 0.1 * i);
    heard.assembler.tick(0.1 * i);
  }
  EXPECT_TRUE(heard.observations.empty());
}

TEST(Assembler, WithoutMeasuredOdometryNothingIsWaitedFor) {
  Rig rig = laserCart();
  rig.odometry = {OdometryRigKind::Scan, "", ""};
  Assembled heard(rig);
  heard.assembler.scanned(1.0, onePoint(), 1.0);
  heard.assembler.scanned(1.1, onePoint(), 1.1);
  ASSERT_EQ(heard.observations.size(), 2U);
  EXPECT_LT(heard.observations[0].frame, heard.observations[1].frame);
}

TEST(Assembler, MemoryStaysBoundedWhenOdometryNeverComes) {
  Assembled heard(laserCart());
  for (int i = 0; i < 400; ++i) heard.assembler.scanned(1.0 + 0.001 * i, onePoint(), 1.4);
  EXPECT_GE(heard.refused["too many observations that wait for odometry"], 200);
}

TEST(Assembler, LargeScansWaitInSmallNumbers) {
  Assembled heard(laserCart());
  const std::vector<RangePoint> large(500'000, {1.0F, 0.0F, 0.0F, 1.0F});  // 8 MB
  for (int i = 0; i < 40; ++i) heard.assembler.scanned(1.0 + 0.001 * i, large, 1.1);
  EXPECT_GE(heard.refused["too many observations that wait for odometry"], 5);
}

TEST(Assembler, ALookAroundIsOneObservation) {
  Assembled heard(stopAndLook());
  Assembler& assembler = heard.assembler;
  double now = 0.0;
  const Pose2 here{4.0, 5.0, 0.5};
  for (; now < 1.25; now += 0.1) assembler.moved(now, here, now);
  ASSERT_EQ(heard.looks.size(), 1U);
  for (int pan = 0; pan < 6; ++pan) {
    now += 0.01;
    assembler.pairTaken(now, cv::Mat1b::zeros(4, 4), cv::Mat1b::zeros(4, 4), now);
    ASSERT_EQ(heard.looks.size(), static_cast<std::size_t>(pan) + 1) << "on the way";
    now += 0.5;
    assembler.headArrived(heard.looks.back(), now);
    now += 0.3;
    assembler.pairTaken(now, cv::Mat1b::ones(4, 4), cv::Mat1b::ones(4, 4), now);
  }
  ASSERT_EQ(heard.observations.size(), 1U);
  const Observation& observation = heard.observations[0];
  EXPECT_TRUE(observation.standing);
  EXPECT_EQ(observation.odometry, here);
  ASSERT_EQ(observation.views.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(observation.views[i].pan, sixPans().pans[i]);
    EXPECT_EQ(observation.views[i].left.at<unsigned char>(0, 0), 1) << "taken after the arrival";
  }
  EXPECT_EQ(heard.looks.size(), 7U) << "and ahead again";
}

TEST(Assembler, AnInterruptedLookAroundIsForgotten) {
  Assembled heard(stopAndLook());
  Assembler& assembler = heard.assembler;
  double now = 0.0;
  for (; now < 1.25; now += 0.1) assembler.moved(now, {}, now);
  now += 0.5;
  assembler.headArrived(0.0, now);
  now += 0.3;
  assembler.pairTaken(now, cv::Mat1b::ones(4, 4), cv::Mat1b::ones(4, 4), now);
  now += 0.1;
  assembler.moved(now, {1.0, 0.0, 0.0}, now);
  EXPECT_TRUE(heard.observations.empty());
  EXPECT_EQ(heard.refused["look around: the robot drove on while it looked around"], 1);
}

}  // namespace
}  // namespace handmap
