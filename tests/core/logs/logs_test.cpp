#include <cmath>
#include <cstring>
#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "core/logs/array.h"
#include "core/logs/log.h"
#include "core/recording/recording.h"
#include "tests/core/base/expect_error.h"
#include "tests/core/base/temporary_folder.h"

namespace handmap {
namespace {

template <typename Number>
std::string npy(const std::string& type, const std::string& shape,
                const std::vector<Number>& values) {
  std::string header =
      "{'descr': '" + type + "', 'fortran_order': False, 'shape': (" + shape + "), }";
  header.resize(118, ' ');
  std::string content = "\x93NUMPY";
  content += std::string("\x01\x00\x76\x00", 4) + header;
  content.append(reinterpret_cast<const char*>(values.data()), sizeof(Number) * values.size());
  return content;
}

std::string little(std::size_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i, value >>= 8U) text += static_cast<char>(value & 0xffU);
  return text;
}

std::string deflated(const std::string& content) {
  std::string out(compressBound(content.size()) + 64, '\0');
  z_stream stream{};
  deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  std::string in = content;
  stream.next_in = reinterpret_cast<Bytef*>(in.data());
  stream.avail_in = static_cast<uInt>(in.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

/// As numpy.savez (packed: savez_compressed) writes it.
std::string npz(const std::map<std::string, std::string>& arrays, bool packed) {
  std::string file;
  std::string directory;
  for (const auto& [array, content] : arrays) {
    const std::string name = array + ".npy";
    const std::string data = packed ? deflated(content) : content;
    const std::string common = little(20, 2) + little(0, 2) + little(packed ? 8 : 0, 2) +
                               little(0, 8) + little(data.size(), 4) + little(content.size(), 4) +
                               little(name.size(), 2);
    directory += "PK\x01\x02" + little(20, 2) + common + little(0, 2 + 2 + 2 + 2 + 4) +
                 little(file.size(), 4) + name;
    file += "PK\x03\x04" + common + little(0, 2) + name + data;
  }
  const std::size_t at = file.size();
  return file + directory + "PK\x05\x06" + little(0, 4) + little(arrays.size(), 2) +
         little(arrays.size(), 2) + little(directory.size(), 4) + little(at, 4) + little(0, 2);
}

class Logs : public testing::Test {
 protected:
  Log read(const std::string& name, const std::string& content,
           const LogOptions& options = {}) const {
    return readLogs({folder_.write(name, content)}, options);
  }
  std::string asked(const std::string& name, const std::string& content) const {
    try {
      read(name, content);
    } catch (const Question& question) {
      return question.option();
    }
    return "nothing";
  }
  test::TemporaryFolder folder_;
};

TEST_F(Logs, ArraysOfAllKindsOfNumbers) {
  EXPECT_EQ(parseNpy(npy<double>("<f8", "2, 2", {1, 2, 3, 4}), "a").values,
            (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(parseNpy(npy<std::int16_t>("<i2", "2,", {-1, 300}), "a").values,
            (std::vector<double>{-1, 300}));
  EXPECT_EQ(parseNpy(npy<std::uint8_t>("|u1", "", {7}), "a").values, std::vector<double>{7});
  EXPECT_EQ(parseNpy(npy<std::uint16_t>(">u2", "1,", {0x0100}), "a").values,
            std::vector<double>{1});
  std::string columns_first = npy<float>("<f4", "2, 3", {1, 4, 2, 5, 3, 6});
  columns_first.replace(columns_first.find("False"), 5, "True ");
  EXPECT_EQ(parseNpy(columns_first, "a").values, (std::vector<double>{1, 2, 3, 4, 5, 6}));
}

TEST_F(Logs, DamagedArraysAreRefused) {
  const std::string whole = npy<double>("<f8", "2, 2", {1, 2, 3, 4});
  test::expectBadInput([&] { parseNpy(whole.substr(0, 140), "a.npy"); }, {"a.npy", "4 values"});
  test::expectBadInput([&] { parseNpy("PK", "a.npy"); }, {"no array"});
  test::expectBadInput([&] { parseNpy(npy<double>("|O8", "1,", {1}), "a.npy"); }, {"descr"});
  test::expectBadInput(
      [&] { parseNpy(npy<double>("<f8", "99999999999, 99999999999", {1}), "a.npy"); }, {"at most"});
  for (const bool packed : {false, true}) {
    const std::string zip = npz({{"ranges", whole}}, packed);
    EXPECT_EQ(parseNpz(zip, "z").at("ranges").values, (std::vector<double>{1, 2, 3, 4}));
    for (std::size_t size = 0; size < zip.size(); ++size) {
      EXPECT_THROW(parseNpz(std::string_view(zip).substr(0, size), "z"), Error) << size;
    }
  }
}

TEST_F(Logs, ATableOfRanges) {
  std::string text = "time,x,y,theta_deg";
  for (int i = 0; i < 180; ++i) text += ",range_" + std::to_string(i);
  text += "\n";
  for (int row = 0; row < 3; ++row) {
    text += fmt::format("{},{},0,90", 0.1 * row, row);
    for (int i = 0; i < 180; ++i) text += i == 90 ? ",5" : i < 90 ? ",30" : ",nan";
    text += "\n";
  }
  const Log log = read("a.csv", text);
  ASSERT_EQ(log.scans.size(), 3U);
  ASSERT_EQ(log.scans[0].points.size(), 1U);  // 30 is how far it reaches
  EXPECT_NEAR(log.scans[0].points[0].x, 5.0, 1e-6);
  ASSERT_EQ(log.poses.size(), 3U);
  EXPECT_NEAR(log.poses[1].pose.heading, kPi / 2, 1e-9);
}

/// The ray that says so leaves no point; its neighbours do.
TEST_F(Logs, WhatAScannerGivesForNothingIsNoWall) {
  for (const char* range : {"0", "inf", "nan", "12", "12.5", "", "-1"}) {
    std::string text = "time,range_max";
    for (int i = 0; i < 181; ++i) text += ",range_" + std::to_string(i);
    for (int row = 0; row < 3; ++row) {
      text += fmt::format("\n{},12", 0.1 * row);
      for (int i = 0; i < 181; ++i) text += "," + std::string(i == 90 ? range : "5");
    }
    const Log log = read("a.csv", text + "\n");
    ASSERT_EQ(log.scans.size(), 3U) << range;
    const auto measured = std::ranges::count_if(log.scans[0].points, isMeasured);
    EXPECT_EQ(measured, 180) << range;
  }
}

TEST_F(Logs, RangesInMillimetresBesidePosesInMetresOrMillimetres) {
  for (const double unit : {1.0, 1000.0}) {
    std::string text = "time,x,y,theta";
    for (int i = 0; i < 181; ++i) text += ",range_" + std::to_string(i);
    text += "\n";
    for (int row = 0; row < 9; ++row) {
      text += fmt::format("{},{},0,0", 0.5 * row, unit * 0.25 * row);  // half a metre a second
      for (int i = 0; i < 181; ++i) text += fmt::format(",{}", 3000 + i);
      text += "\n";
    }
    const Log log = read("a.csv", text);
    EXPECT_NEAR(log.poses.at(8).pose.x, 2.0, 1e-9) << unit;
    EXPECT_NEAR(log.scans.at(0).points.at(90).x, 3.09, 1e-6) << unit;
  }
}

TEST_F(Logs, PosesInMillimetresOfAFileOfTheirOwn) {
  std::string text = "time,x,y,yaw\n";
  for (int i = 0; i < 9; ++i) text += fmt::format("{},{},0,0\n", 0.25 * i, 400.0 * i);
  const Log log = read("a.csv", text);
  EXPECT_NEAR(log.poses.at(8).pose.x, 3.2, 1e-9);
  ASSERT_EQ(log.notes.size(), 1U);
  EXPECT_NE(log.notes[0].find("poses taken as millimetres"), std::string::npos) << log.notes[0];
}

TEST_F(Logs, UnitsInTheNamesOfColumns) {
  const Log log = read("a.csv", "Time [ms],X [mm],Y(mm),Heading (deg)\n500,1000,2000,90\n");
  ASSERT_EQ(log.poses.size(), 1U);
  EXPECT_NEAR(log.poses[0].time_s, 0.5, 1e-9);
  EXPECT_NEAR(log.poses[0].pose.y, 2.0, 1e-9);
  EXPECT_NEAR(log.poses[0].pose.heading, kPi / 2, 1e-9);
}

/// Of poses and of ranges each their own; and what no role has is said.
TEST_F(Logs, UnitsOfPosesAreNotThoseOfRangesAndUnknownColumnsAreTold) {
  for (const char* unit : {"", "_mm"}) {
    std::string text = "stamp_ms,pos_x_m,pos_y_m,yaw_deg,battery";
    for (int i = 0; i < 181; ++i) text += fmt::format(",r{}{}", i, unit);
    for (int row = 0; row < 3; ++row) {
      text += fmt::format("\n{},{},0,90,11.9", 500 * row, row);
      for (int i = 0; i < 181; ++i) text += fmt::format(",{}", 3000 + i);
    }
    const Log log = read("a.csv", text + "\n");
    ASSERT_EQ(log.poses.size(), 3U);
    EXPECT_NEAR(log.poses[2].time_s, 1.0, 1e-9);
    EXPECT_NEAR(log.poses[2].pose.x, 2.0, 1e-9);
    EXPECT_NEAR(log.poses[2].pose.heading, kPi / 2, 1e-9);
    EXPECT_NEAR(log.scans.at(0).points.at(90).x, 3.09, 1e-6) << unit;
    ASSERT_FALSE(log.notes.empty());
    EXPECT_TRUE(log.notes.back().ends_with("nothing is made of: battery")) << log.notes.back();
  }
}

TEST_F(Logs, ATableOfPointsAndOneOfPoses) {
  std::string text = "t;px;py\n";
  for (int row = 0; row < 40; ++row) {
    text += fmt::format("{};{};{}\n", row / 10 * 100, 3000 + row, -2000);
  }
  const Log log = read("a.csv", text);
  ASSERT_EQ(log.scans.size(), 4U);
  EXPECT_NEAR(log.scans[1].time_s, 0.1, 1e-9);
  EXPECT_NEAR(log.scans[0].points[0].x, 3.0, 1e-6);
  const Log poses = read("b.tum", "0 1 2 0 0 0 0.7071068 0.7071068\n1 2 2 0 0 0 0 1\n");
  ASSERT_EQ(poses.poses.size(), 2U);
  EXPECT_NEAR(poses.poses[0].pose.heading, kPi / 2, 1e-6);
}

TEST_F(Logs, ATableWithDecimalCommas) {
  for (const char* header : {"time;x;y;yaw\n", ""}) {
    LogOptions options;
    if (*header == '\0')
      options.columns = {{"time", "1"}, {"x", "2"}, {"y", "3"}, {"heading", "4"}};
    const Log log =
        read("a.csv", std::string(header) + "0,5;1,25;-2;0\n1,5;1,75;-2;0,01\n", options);
    ASSERT_EQ(log.poses.size(), 2U);
    EXPECT_NEAR(log.poses[0].time_s, 0.5, 1e-9);
    EXPECT_NEAR(log.poses[1].pose.x, 1.75, 1e-9);
  }
  EXPECT_THROW(read("a.csv", "time;x;y;yaw\n0;1,234,5;0;0\n"), Error);
}

TEST_F(Logs, OfCarmen) {
  std::string text = "# comment\nPARAM robot 1\n";
  for (int i = 0; i < 3; ++i) {
    text += "FLASER 180";
    for (int r = 0; r < 180; ++r) text += r == 0 ? " 4" : " 81.83";
    text += fmt::format(" 0 0 0 {} 2 1.5 {} host 0\n", i, 100 + i);
  }
  const Log log = read("a.log", text);
  ASSERT_EQ(log.scans.size(), 3U);
  ASSERT_EQ(log.scans[0].points.size(), 1U);
  EXPECT_NEAR(log.scans[0].points[0].y, -4.0, 1e-5);
  EXPECT_EQ(log.poses[2].pose.x, 2.0);
  EXPECT_EQ(log.poses[2].time_s, 102.0);
  test::expectBadInput([&] { read("b.log", "FLASER 180 1 2\n"); },
                       {"b.log: line 1: found 4 fields"});
}

TEST_F(Logs, OfArrays) {
  std::vector<double> ranges(2 * 181, 3.0);
  for (std::size_t i = 0; i < ranges.size(); ++i) ranges[i] += 0.01 * static_cast<double>(i);
  const Log log = read("a.npz", npz({{"ranges", npy<double>("<f8", "2, 181", ranges)},
                                     {"times", npy<double>("<f8", "2,", {5, 6})},
                                     {"poses", npy<float>("<f4", "2, 3", {0, 0, 0, 1, 0, 0})}},
                                    true));
  ASSERT_EQ(log.scans.size(), 2U);
  EXPECT_EQ(log.scans[0].points.size(), 181U);
  EXPECT_EQ(log.poses[1].pose.x, 1.0);
  EXPECT_EQ(log.poses[1].time_s, 6.0);
}

TEST_F(Logs, PointsThatNoScannerSeesAreLeftOut) {
  LogOptions options;
  options.rate_hz = 10.0;
  const float far = -1.7e38F;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Log log = read(
      "a.npy", npy<float>("<f4", "1, 5, 3", {far, far, far, 1, 2, 3, nan, 0, 0, 4, 5, 6, 7, 8, 9}),
      options);
  ASSERT_EQ(log.scans.size(), 1U);
  ASSERT_EQ(log.scans[0].points.size(), 3U);
  EXPECT_EQ(log.scans[0].points[0].y, 2.0F);
}

TEST_F(Logs, WhatCannotBeSeenIsAskedFor) {
  EXPECT_EQ(asked("a.csv", "1,2,3\n4,5,6\n"), "columns");
  EXPECT_EQ(asked("a.npy", npy<double>("<f8", "1, 181", std::vector<double>(181, 2.0))), "rate");
  std::string odd = "time";
  for (int i = 0; i < 17; ++i) odd += ",r" + std::to_string(i);
  odd += "\n0";
  for (int i = 0; i < 17; ++i) odd += "," + std::to_string(i + 1);
  EXPECT_EQ(asked("b.csv", odd + "\n"), "angles");
  LogOptions options;
  options.angles = RayAngles{0.0, 0.1};
  EXPECT_EQ(read("b.csv", odd + "\n", options).scans.size(), 1U);
}

TEST_F(Logs, BecomeARecording) {
  Log log;
  for (int i = 0; i < 5; ++i) {
    log.scans.push_back({0.1 * i, {{5, 1, 0, 1}, {0, 20, 0, 1}}});
    if (i > 0) log.poses.push_back({0.1 * i, {1.0 * i, 0, 0}});
  }
  std::vector<std::string> notes;
  const auto path = folder_.path() / "rec";
  EXPECT_EQ(writeLog(log, path, "mine", notes), 4U);
  EXPECT_EQ(notes, std::vector<std::string>{"1 scans before or after the poses are left out"});
  const Recording recording = openRecording(path);
  EXPECT_EQ(recording.rows.size(), 4U);
  EXPECT_EQ(recording.range_limit_m, 20.0);
  EXPECT_EQ(recording.odometry.poses().size(), 4U);
  log.poses.clear();
  writeLog(log, folder_.path() / "alone", "mine", notes);
  EXPECT_TRUE(openRecording(folder_.path() / "alone").odometry.empty());
}

}  // namespace
}  // namespace handmap
