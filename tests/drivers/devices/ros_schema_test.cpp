#include "drivers/rosbridge/ros_schema.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/bags/field_writer.h"
#include "core/base/error.h"
#include "drivers/emulators/ros_emulated_messages.h"
#include "drivers/rosbridge/ros_messages.h"
#include "drivers/rosbridge/ros_publications.h"

namespace handmap {
namespace {

std::vector<float> numbersOf(const std::vector<RangePoint>& points) {
  std::vector<float> numbers;
  for (const RangePoint& p : points) numbers.insert(numbers.end(), {p.x, p.y, p.z});
  return numbers;
}

RosValue throughCdr(const std::string& type, const QCborMap& message) {
  const RosSchema schema = RosSchema::known(type);
  return {schema.read(schema.write(RosValue(message, "/t")), "/t"), "/t"};
}

TEST(RosSchema, WhatIsWrittenReadsBackTheSame) {
  const auto odometry = readOdometry(throughCdr(
      "nav_msgs/msg/Odometry", emulated::odometry(1.7e9, {1.5, -2.0, 0.5}, RosVersion::Ros2)));
  EXPECT_NEAR(odometry.stamp_s, 1.7e9, 1e-6);
  EXPECT_NEAR(odometry.pose.heading, 0.5, 1e-12);
  EXPECT_EQ(odometry.base, "base");
  std::vector<float> ranges(7, 2.5F);
  ranges[3] = std::numeric_limits<float>::infinity();
  const QCborMap scan = emulated::laserScan(5.25, ranges, RosVersion::Ros2);
  const auto rays = numbersOf(readLaserScan(throughCdr("sensor_msgs/msg/LaserScan", scan)).points);
  const auto same = numbersOf(readLaserScan(RosValue(scan, "/t")).points);
  ASSERT_EQ(rays.size(), same.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!std::isfinite(same[i])) continue;
    EXPECT_NEAR(rays[i], same[i], 1e-5F) << i;  // angles: float32
  }
  const std::vector<RangePoint> points(3, RangePoint{1, 2, 3, 1});
  const auto cloud = throughCdr("sensor_msgs/msg/PointCloud2",
                                emulated::pointCloud(5.25, points, RosVersion::Ros2));
  EXPECT_EQ(numbersOf(readPointCloud(cloud).points), numbersOf(points));
}

/// Every byte that a run tells ROS is that of the message.
TEST(RosSchema, APoseIsTheBytesOfRos) {
  const QCborMap pose = poseMessage({rosTimeOf(7.5), QStringLiteral("map"), RosVersion::Ros2},
                                    {1.0, 2.0, 0.0}, 0.25 * Eigen::Matrix3d::Identity());
  FieldWriter bytes = FieldWriter::cdr();
  bytes.stamp(7.5);
  bytes.text("map");
  for (const double value : {1.0, 2.0, 0.0, 0.0, 0.0, 0.0, 1.0}) bytes.put(value);
  for (int i = 0; i < 36; ++i) bytes.put(i == 0 || i == 7 || i == 35 ? 0.25 : 0.0);
  EXPECT_EQ(
      RosSchema::known("geometry_msgs/msg/PoseWithCovarianceStamped").write(RosValue(pose, "/t")),
      bytes.bytes());
}

TEST(RosSchema, TextsOfRos1AreUnderstood) {
  const RosSchema schema("pkg/Thing",
                         "# a remark\n"
                         "uint8 KIND=3  # a constant\nstring NAME = none\n"
                         "Header header\nInner[2] parts\nint16[] numbers  # behind a field\n"
                         "================\nMSG: std_msgs/Header\n"
                         "uint32 seq\ntime stamp\nstring frame_id\n"
                         "================\nMSG: pkg/Inner\nbool on\nbyte[] data\n",
                         MessageEncoding::Ros1);
  FieldWriter bytes;
  for (const std::uint32_t number : {9U, 50U, 500'000'000U}) bytes.put(number);
  bytes.text("odom");
  for (const int on : {1, 0}) {
    bytes.put(static_cast<std::uint8_t>(on));
    bytes.sized<std::uint32_t>("ab");
  }
  bytes.count(2);
  for (const int number : {-5, 6}) bytes.put(static_cast<std::int16_t>(number));
  const RosValue read(schema.read(bytes.bytes(), "/t"), "/t");
  EXPECT_EQ(read.at("header").at("stamp").at("nsecs").integer(0, 1'000'000'000), 500'000'000);
  const auto parts = read.at("parts").items(10);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_TRUE(parts[0].at("on").flag());
  EXPECT_EQ(parts[1].at("data").bytes(10), QByteArray("ab"));
  EXPECT_EQ(read.at("numbers").numbers(10), (std::vector{-5.0, 6.0}));
  EXPECT_FALSE(read.find("KIND"));
  for (std::size_t cut = 0; cut < bytes.bytes().size(); ++cut) {
    EXPECT_THROW(schema.read(bytes.bytes().substr(0, cut), "/t"), Error) << cut;
  }
}

TEST(RosSchema, BigEndianAndBoundsOfRos2AreUnderstood) {
  const RosSchema schema("pkg/msg/Thing", "string<=9 name\nfloat64[<=4] values\n",
                         MessageEncoding::Cdr);
  const std::string bytes("\0\0\0\0\0\0\0\2x\0\0\0\0\0\0\1\0\0\0\0\x3f\xf0\0\0\0\0\0\0", 28);
  EXPECT_EQ(RosValue(schema.read(bytes, "/t"), "/t").at("values").numbers(4), std::vector{1.0});
}

TEST(RosSchema, TextsThatAreNoneAreRefused) {
  for (const char* text :
       {"float64", "Nobody x\n", "float64[ x\n", "float64[-1] x\n", "float64[99999999] x\n",
        "pkg/Thing inside\n", "A a\n====\nMSG: pkg/A\nB b\n====\nMSG: pkg/B\nA a\n"}) {
    EXPECT_THROW(RosSchema("pkg/Thing", text, MessageEncoding::Cdr), Error) << text;
  }
}

/// An array that says it is long holds no more than the message.
TEST(RosSchema, NothingIsAllocatedOnAMessagesWord) {
  const RosSchema schema("pkg/Thing", "Void[] nothing\n====\nMSG: pkg/Void\n",
                         MessageEncoding::Ros1);
  EXPECT_THROW(schema.read(std::string_view("\xff\xff\xff\x7f", 4), "/t"), Error);
}

}  // namespace
}  // namespace handmap
