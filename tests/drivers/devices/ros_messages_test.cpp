#include "drivers/rosbridge/ros_messages.h"

#include <QCborArray>
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "core/base/error.h"
#include "drivers/emulators/ros_emulated_messages.h"
#include "drivers/rosbridge/bounded_message.h"
#include "drivers/rosbridge/ros_publications.h"

namespace handmap {
namespace {

QCborMap with(QCborMap message, const char* key, const QCborValue& value) {
  message[QLatin1String(key)] = value;
  return message;
}

class RosMessagesOf : public testing::TestWithParam<RosVersion> {};

TEST_P(RosMessagesOf, StampsOfBothFormsAreRead) {
  const Pose2 pose{3.0, -4.0, 2.5};
  const auto read = readOdometry(RosValue(emulated::odometry(123.25, pose, GetParam()), "/odom"));
  EXPECT_NEAR(read.stamp_s, 123.25, 1e-6);
  EXPECT_NEAR(read.pose.heading, 2.5, 1e-12);
  EXPECT_EQ(read.pose.y, -4.0);
}

TEST_P(RosMessagesOf, TheCalibrationOfACameraIsRead) {
  const auto read = readCameraInfo(
      RosValue(emulated::cameraInfo({640, 480}, {500, 501, 320, 240, 0, {}}, 0.12, GetParam()),
               "/camera_info"));
  EXPECT_EQ(read.size, cv::Size(640, 480));
  EXPECT_EQ(read.distortion.size(), 5U);
  EXPECT_EQ(read.matrix(1, 1), 501.0);
  EXPECT_EQ(read.rectification, cv::Matx33d::eye());
  EXPECT_NEAR(read.projection(0, 3), -60.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Versions, RosMessagesOf,
                         testing::Values(RosVersion::Ros1, RosVersion::Ros2));

TEST(RosMessages, ACalibrationThatCannotBeIsRefused) {
  const QCborMap good =
      emulated::cameraInfo({640, 480}, {500, 500, 320, 240, 0, {}}, 0.0, RosVersion::Ros2);
  const QCborArray eight = {1, 0, 0, 0, 1, 0, 0, 0};
  for (const QCborMap& bad :
       {with(good, "k", eight), with(good, "k", QCborArray{"1"}), with(good, "width", -1),
        with(good, "width", 1'000'000), with(good, "d", QCborArray{std::nan("")}),
        with(good, "d", QCborArray{1e300}), with(good, "p", QCborValue())}) {
    EXPECT_THROW(readCameraInfo(RosValue(bad, "/camera_info")), Error);
  }
}

TEST(RosMessages, OdometryThatCannotBeIsRefused) {
  const char* const good = R"({"header":{"stamp":{"sec":1,"nanosec":0}},"pose":{"pose":{
      "position":{"x":1,"y":2,"z":0},"orientation":{"x":0,"y":0,"z":0,"w":1}}}})";
  EXPECT_NO_THROW(readOdometry(RosValue(parseJsonMessage(good), "/odom")));
  for (const auto& [from, to] :
       {std::pair("\"w\":1", "\"w\":0"), std::pair("\"x\":1", "\"x\":null"),
        std::pair("\"x\":1", "\"x\":1e300"), std::pair("\"sec\":1", "\"sec\":\"1\""),
        std::pair("\"header\"", "\"heather\""), std::pair("\"orientation\"", "\"o\"")}) {
    QByteArray bad = good;
    bad.replace(from, to);
    EXPECT_THROW(readOdometry(RosValue(parseJsonMessage(bad), "/odom")), Error) << to;
  }
}

TEST(RosMessages, LaserScansBecomePointsWhereSomethingWas) {
  const float infinity = std::numeric_limits<float>::infinity();
  const QCborMap message = emulated::laserScan(
      5.0, {1.0F, 2.0F, infinity, 3.0F, 99.0F, 0.01F, 2.0F, 2.0F}, RosVersion::Ros2);
  const auto scan = readLaserScan(RosValue(message, "/scan"));
  ASSERT_EQ(scan.points.size(), 6U);
  EXPECT_EQ(std::count_if(scan.points.begin(), scan.points.end(), isMeasured), 5);
  EXPECT_NEAR(scan.points[0].x, -1.0F, 1e-6F);  // behind
  EXPECT_NEAR(scan.points[1].y, -std::sqrt(2.0F), 1e-6F);
  EXPECT_EQ(scan.stamp_s, 5.0);
  EXPECT_EQ(scan.reach_m, 30.0);
  // In JSON what is not a number is null.
  const QCborArray list = {1.0, nullptr, 3.0};
  EXPECT_EQ(readLaserScan(RosValue(with(message, "ranges", list), "/scan")).points.size(), 3U);
  const auto timed = readLaserScan(RosValue(with(message, "time_increment", 0.01), "/scan"));
  EXPECT_NEAR(timed.stamp_s, 5.04, 1e-9);
  EXPECT_THROW(readLaserScan(RosValue(with(message, "ranges", 1), "/scan")), Error);
  EXPECT_THROW(readLaserScan(RosValue(with(message, "angle_increment", QCborValue()), "/scan")),
               Error);
}

/// REP 117, and what many drivers do besides: nothing came back as far as the scanner reaches, or
/// it could not be measured whether anything did.
TEST(RosMessages, WhatAScannerGivesForNothingIsNoWall) {
  const auto points = [](float range, double farthest) {
    const QCborMap message = emulated::laserScan(
        5.0, {2.0F, range, 2.0F, 2.0F, 2.0F, 2.0F, 2.0F, 2.0F}, RosVersion::Ros2);
    return readLaserScan(RosValue(with(message, "range_max", farthest), "/scan")).points;
  };
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const double farthest : {12.0, 11.99, 5.6, static_cast<double>(11.99F)}) {
    const auto most = static_cast<float>(farthest);
    for (const float range :
         {most, std::nextafter(most, kInfinity), most + 1.0F, kInfinity, 0.0F}) {
      EXPECT_EQ(points(range, farthest).size(), 7U) << range << " of " << farthest;
    }
    for (const float range : {-kInfinity, kNone, -1.0F, 0.049F}) {
      const auto scan = points(range, farthest);
      ASSERT_EQ(scan.size(), 8U) << range;
      EXPECT_FALSE(isMeasured(scan[1])) << range;
      EXPECT_NEAR(std::atan2(scan[1].y, scan[1].x), -0.75 * kPi, 1e-6) << "its direction";
    }
    EXPECT_TRUE(isMeasured(points(std::nextafter(most, 0.0F), farthest)[1]));
    EXPECT_EQ(points(0.05F, farthest).size(), 8U);
  }
}

TEST(RosMessages, PointCloudsAreReadWithinTheirBounds) {
  const float none = std::numeric_limits<float>::quiet_NaN();
  const std::vector<RangePoint> points = {{1, 2, 3, 0}, {none, 0, 0, 0}, {-4, 5, 0.5F, 0}};
  const QCborMap message = emulated::pointCloud(7.0, points, RosVersion::Ros1);
  const auto cloud = readPointCloud(RosValue(message, "/points"));
  ASSERT_EQ(cloud.points.size(), 2U);
  EXPECT_EQ(cloud.points[1].x, -4.0F);
  EXPECT_EQ(cloud.points[1].z, 0.5F);
  EXPECT_EQ(cloud.points[1].w, 1.0F);
  const QByteArray data = message[QLatin1String("data")].toByteArray();
  const QString base64 = QString::fromLatin1(data.toBase64());
  EXPECT_EQ(readPointCloud(RosValue(with(message, "data", base64), "/points")).points.size(), 2U);
  for (const auto& [key, value] :
       std::initializer_list<std::pair<const char*, QCborValue>>{{"width", 4},
                                                                 {"height", 2},
                                                                 {"width", 3'000'000},
                                                                 {"height", qint64{4294967296}},
                                                                 {"width", -1},
                                                                 {"point_step", 8},
                                                                 {"point_step", 0},
                                                                 {"row_step", 10},
                                                                 {"row_step", 1LL << 40},
                                                                 {"data", data.left(47)},
                                                                 {"data", QStringLiteral("***")},
                                                                 {"fields", QCborArray{}},
                                                                 {"is_bigendian", QCborValue()}}) {
    EXPECT_THROW(readPointCloud(RosValue(with(message, key, value), "/points")), Error) << key;
  }
}

TEST(RosMessages, ImagesAreDecodedAndDamagedOnesRefused) {
  std::vector<unsigned char> file;
  cv::imencode(".png", cv::Mat(40, 60, CV_8UC3, cv::Scalar(1, 2, 3)), file);
  const QByteArray bytes(reinterpret_cast<const char*>(file.data()),
                         static_cast<qsizetype>(file.size()));
  const auto read =
      readImage(RosValue(emulated::compressedImage(1.0, bytes, RosVersion::Ros2), "/left"));
  EXPECT_EQ(read.image.size(), cv::Size(60, 40));
  for (const QByteArray& bad :
       {QByteArray(), bytes.left(20), bytes.left(bytes.size() - 20), QByteArray("not an image")}) {
    EXPECT_THROW(
        readImage(RosValue(emulated::compressedImage(1.0, bad, RosVersion::Ros2), "/left")), Error);
  }
}

Map twoBuildings() {
  Map map;
  map.start = Pose2{0.0, 0.0, 0.0};
  map.buildings.resize(2);
  map.buildings[0].id = "A";
  map.buildings[0].shape = Rectangle{{10.0, 5.0}, 8.0, 4.0, 0.0};
  map.buildings[1].id = "B";
  map.buildings[1].shape =
      Polygon{{20.0, 0.0}, {26.0, 0.0}, {26.0, 2.0}, {22.0, 2.0}, {22.0, 6.0}, {20.0, 6.0}};
  return map;
}

TEST(RosPublications, TheGridHasTheBuildingsAreas) {
  const QCborMap grid = gridMessage({}, occupancyOf(twoBuildings()));
  const QCborMap info = grid[QLatin1String("info")].toMap();
  const QCborArray data = grid[QLatin1String("data")].toArray();
  const qint64 width = info[QLatin1String("width")].toInteger();
  EXPECT_EQ(data.size(), width * info[QLatin1String("height")].toInteger());
  double area = 0.0;
  for (const auto& cell : data) area += cell.toInteger() == 100 ? 0.0625 : 0.0;
  EXPECT_NEAR(area, 32.0 + 12.0 + 8.0, 0.01);
  const QCborMap origin = info[QLatin1String("origin")].toMap()[QLatin1String("position")].toMap();
  const auto cell = [&](double x, double y) {
    const auto column = static_cast<qint64>((x - origin[QLatin1String("x")].toDouble()) / 0.25);
    const auto row = static_cast<qint64>((y - origin[QLatin1String("y")].toDouble()) / 0.25);
    return data[row * width + column].toInteger();
  };
  EXPECT_EQ(cell(10.0, 5.0), 100);
  EXPECT_EQ(cell(21.0, 5.0), 100);
  EXPECT_EQ(cell(24.0, 5.0), 0);  // in the notch
  EXPECT_EQ(cell(0.0, 0.0), 0);
}

TEST(RosPublications, TheGridKeepsItsPlaceWhileBuildingsMoveALittle) {
  Map map = twoBuildings();
  const OccupancyGrid before = occupancyOf(map);
  map.buildings[0].shape = Rectangle{{10.02, 5.0}, 8.0, 4.0, 0.0};
  EXPECT_EQ(occupancyOf(map), before) << "not by half a cell";
  map.buildings[0].shape = Rectangle{{10.6, 5.3}, 8.0, 4.0, 0.0};
  const OccupancyGrid after = occupancyOf(map);
  EXPECT_NE(after, before);
  EXPECT_EQ(after.origin, before.origin);
  EXPECT_EQ(after.cells.size(), before.cells.size());
}

TEST(RosPublications, ALargeMapGetsLargerCells) {
  Map map = twoBuildings();
  map.buildings[1].shape = Rectangle{{100'000.0, 100'000.0}, 50.0, 50.0, 0.3};
  const QCborMap grid = gridMessage({}, occupancyOf(map));
  EXPECT_LT(grid[QLatin1String("data")].toArray().size(), 1'010'000);
  EXPECT_GT(grid[QLatin1String("info")].toMap()[QLatin1String("resolution")].toDouble(), 50.0);
}

TEST(RosPublications, StampsHaveTheFormOfTheirRos) {
  for (const auto version : {RosVersion::Ros1, RosVersion::Ros2}) {
    const RosHeader header{{12, 34}, QStringLiteral("map"), version};
    const QCborMap message =
        poseMessage(header, {1.0, 2.0, 0.5},
                    Eigen::Matrix3d{{0.01, 0.02, 0.0}, {0.02, 0.04, 0.0}, {0.0, 0.0, 0.09}});
    const QCborMap stamp = message[QLatin1String("header")].toMap()[QLatin1String("stamp")].toMap();
    EXPECT_EQ(stamp[QLatin1String(version == RosVersion::Ros1 ? "nsecs" : "nanosec")].toInteger(),
              34);
    EXPECT_EQ(stamp.size(), 2);
    const QCborArray covariance =
        message[QLatin1String("pose")].toMap()[QLatin1String("covariance")].toArray();
    EXPECT_EQ(covariance.size(), 36);
    EXPECT_NEAR(covariance[35].toDouble(), 0.09, 1e-12);
    EXPECT_EQ(covariance[1].toDouble(), 0.02);
    EXPECT_EQ(covariance[6].toDouble(), 0.02);
    EXPECT_EQ(covariance[7].toDouble(), 0.04);
  }
}

}  // namespace
}  // namespace handmap
