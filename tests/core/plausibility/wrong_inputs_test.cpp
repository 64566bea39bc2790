// Walks the table of wrong inputs in the page of the room: each is made, and what that page says is
// said, as surely, with file and place; the remedy, where there is one, leaves no doubt.
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/plausibility/drawing.h"
#include "core/plausibility/plausibility.h"
#include "core/recording/validation.h"
#include "tests/core/plausibility/yard_drive.h"

namespace handmap {
namespace {

using test::YardDrive;

struct Said {
  std::string text;
  bool is_certain = false;
};
using Wrong = std::function<std::vector<Said>(const test::TemporaryFolder&)>;

std::vector<Said> saidBy(const Doubts& doubts) {
  std::vector<Said> said;
  for (const Doubt& doubt : doubts)
    said.push_back({doubt.message + "\n" + doubt.hint, doubt.certain});
  return said;
}

std::vector<Said> saidOf(const Recording& recording) {
  const Doubts doubts = doubtsOf(recording);
  for (const Doubt& doubt : doubts) {
    if (!doubt.remedy) continue;
    const Doubts left = doubtsOf(remedied(recording, *doubt.remedy));
    EXPECT_TRUE(left.empty()) << doubt.remedy->name << " leaves " << left[0].message;
  }
  return saidBy(doubts);
}

Wrong drive(const std::function<void(YardDrive&)>& spoil) {
  return [spoil](const test::TemporaryFolder& folder) -> std::vector<Said> {
    YardDrive drive;
    spoil(drive);
    try {
      return saidOf(recorded(folder, drive));
    } catch (const Error& error) {
      return {{error.what(), true}};
    }
  };
}

/// Files of a right drive that are changed afterwards.
Wrong files(const std::function<void(const test::TemporaryFolder&)>& spoil) {
  return [spoil](const test::TemporaryFolder& folder) {
    writeYardDrive(folder, {});
    spoil(folder);
    return saidOf(openRecording(folder.path()));
  };
}

Wrong points(float xx, float xy, float yx, float yy, float raise_m = 0.0F) {
  return drive([=](YardDrive& drive) {
    drive.point = [=](const RangePoint& p) {
      return RangePoint{xx * p.x + xy * p.y, yx * p.x + yy * p.y, p.z + raise_m, 1.0F};
    };
  });
}

Wrong poses(const std::function<Pose2(const Pose2&)>& as) {
  return drive([as](YardDrive& drive) {
    drive.pose = [as](const StampedPose& p) { return StampedPose{p.time_s, as(p.pose)}; };
  });
}

Wrong odometryTimes(double scale, double more_s) {
  return drive([=](YardDrive& drive) {
    drive.pose = [=](const StampedPose& p) {
      return StampedPose{scale * p.time_s + more_s, p.pose};
    };
  });
}

Wrong times(double scale) {
  return drive(
      [=](YardDrive& drive) { drive.time = [=](double time_s) { return scale * time_s; }; });
}

/// Along a gentle bend, with quaternions made of degrees as if they were radians.
Wrong degrees(const std::function<double(double)>& told) {
  return drive([told](YardDrive& drive) {
    drive.way = [](int i) {
      const double turn = 0.02 * i - 0.6;
      return Pose2{40.0 * std::sin(turn), -40.0 * std::cos(turn), turn};
    };
    drive.pose = [told](const StampedPose& p) {
      const double heading = normalizedAngle(told(toDegrees(p.pose.heading)));
      return StampedPose{p.time_s, {p.pose.x, p.pose.y, heading}};
    };
  });
}

Wrong spread(double times) {
  return drive([=](YardDrive& drive) {
    drive.point = [=](const RangePoint& p) {
      const Vec2 q = std::hypot(p.x, p.y) * unitVector(times * std::atan2(p.y, p.x));
      return RangePoint{static_cast<float>(q.x()), static_cast<float>(q.y()), p.z, 1.0F};
    };
  });
}

/// One building inside of the bend, one outside.
Map yard(double scale, double y_sign) {
  Map map;
  map.start = Pose2{0, 0, 0};
  map.buildings.resize(2);
  map.buildings[0].id = "A";
  map.buildings[0].shape = Rectangle{{0, y_sign * scale * 36}, scale * 44, scale * 52, 0};
  map.buildings[1].id = "B";
  map.buildings[1].shape = Rectangle{{scale * 30, y_sign * scale * -25}, scale * 60, scale * 30, 0};
  return map;
}

Wrong drawing(const Map& map) {
  return [map](const test::TemporaryFolder&) { return saidBy(doubtsOfDrawing(map, "m")); };
}

Wrong misspelt() {
  Map map = yard(1, 1);
  map.buildings[0].unknown["fixd"] = "true";
  return drawing(map);
}

/// Three times as far around the bend.
std::vector<Said> wayThroughBuildings(const test::TemporaryFolder& folder) {
  YardDrive drive;
  drive.pose = [](const StampedPose& p) {
    return StampedPose{p.time_s, {3 * p.pose.x, 3 * p.pose.y, p.pose.heading}};
  };
  const Recording recording = recorded(folder, drive);
  EXPECT_TRUE(doubtsOfWay(recording, yard(1, 1), "m").empty());
  return saidBy(doubtsOfWay(recording, yard(1, -1), "m"));
}

/// Straight along a street of which the walls at y = `walls_m` are seen.
Recording street(const test::TemporaryFolder& folder, const std::vector<float>& walls_m) {
  std::string table = "frame,time_s,points\n";
  std::vector<StampedPose> poses;
  for (int i = 0; i < 50; ++i) {
    const double x = 1.5 * i;
    poses.push_back({1.0 * i, {x, 0.0, 0.0}});
    std::vector<RangePoint> points;
    for (int wall = -15; wall < 90; ++wall) {
      if (std::abs(wall - x) >= 20.0 || wall % 30 >= 18) continue;
      for (const float y : walls_m) points.push_back({static_cast<float>(wall - x), y, 0.5F, 1.0F});
    }
    const std::string name = "points/" + std::to_string(i) + ".bin";
    folder.write(name, test::pointBytes(points));
    table += fmt::format("{},{},{}\n", i, i, name);
  }
  folder.write("recording.json", R"({"format": "handmap-recording", "version": 1})");
  folder.write("frames.csv", table);
  folder.write("odometry.tum", formatTum(poses));
  return openRecording(folder.path());
}

Map drawnStreet(double y_sign, bool both_sides) {
  Map map;
  map.start = Pose2{0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    for (const double side : {y_sign, -y_sign}) {
      if (side != y_sign && !both_sides) continue;
      map.buildings.emplace_back().shape =
          Rectangle{{30.0 * i + 9.0, side * 12.0}, 20.0, 10.0, 0.0};
    }
  }
  return map;
}

Wrong straight(const std::vector<float>& walls_m, const std::optional<Map>& map) {
  return [=](const test::TemporaryFolder& folder) {
    const Recording recording = street(folder, walls_m);
    std::vector<Said> said = saidOf(recording);
    if (!map) return said;
    const std::vector<Said> more = saidBy(doubtsOfWay(recording, *map, "m"));
    said.insert(said.end(), more.begin(), more.end());
    return said;
  };
}

std::vector<Said> clocksApart(const test::TemporaryFolder& folder) {
  YardDrive drive;
  drive.pose = [](const StampedPose& p) { return StampedPose{p.time_s + 5.0, p.pose}; };
  const Recording recording = recorded(folder, drive);
  EXPECT_TRUE(doubtsOf(recording).empty());
  const std::vector<std::string> problems = problemsOf(recording);
  EXPECT_EQ(problems.size(), 10U);
  return {{problems.empty() ? "" : "frames.csv: found " + problems[0], true}};
}

/// w x y z in place of x y z w.
void rotateQuaternions(const test::TemporaryFolder& folder) {
  std::istringstream lines(folder.read("odometry.tum"));
  std::string text;
  std::string time, x, y, z, qx, qy, qz, qw;
  while (lines >> time >> x >> y >> z >> qx >> qy >> qz >> qw) {
    text += fmt::format("{} {} {} {} {} {} {} {}\n", time, x, y, z, qw, qx, qy, qz);
  }
  folder.write("odometry.tum", text);
}

std::vector<Said> wFirst(const test::TemporaryFolder& folder) {
  writeYardDrive(folder, {});
  rotateQuaternions(folder);
  try {
    return saidOf(openRecording(folder.path()));
  } catch (const Error& error) {
    return {{error.what(), true}};
  }
}

const float kHalf = std::sqrt(0.5F);

const std::map<std::string, Wrong> kWrongs{
    {"points in millimetres", points(1000, 0, 0, 1000)},
    {"points in centimetres", points(100, 0, 0, 100)},
    {"odometry in millimetres", poses([](const Pose2& p) {
       return Pose2{1000 * p.x, 1000 * p.y, p.heading};
     })},
    {"odometry in centimetres", poses([](const Pose2& p) {
       return Pose2{100 * p.x, 100 * p.y, p.heading};
     })},
    {"times in nanoseconds", times(1e9)},
    {"times in microseconds", times(1e6)},
    {"times in milliseconds", times(1e3)},
    {"frames in milliseconds, odometry in seconds", drive([](YardDrive& drive) {
       drive.time = [](double time_s) { return 1e3 * time_s; };
       drive.pose = [](const StampedPose& p) { return StampedPose{1e-3 * p.time_s, p.pose}; };
     })},
    {"odometry in milliseconds, frames in seconds", odometryTimes(1e3, 0.0)},
    {"clocks of two machines", odometryTimes(1.0, 1.7e9)},
    {"clocks 5 s apart", clocksApart},
    {"x right, y forward", points(0, -1, 1, 0)},
    {"x backwards", points(-1, 0, 0, -1)},
    {"y right", points(1, 0, 0, -1)},
    {"a laser upside down", points(1, 0, 0, -1)},
    {"a laser that counts clockwise", points(1, 0, 0, -1)},
    {"a laser turned by 45°", points(kHalf, -kHalf, kHalf, kHalf)},
    {"a laser turned by 90°", points(0, 1, -1, 0)},
    {"a field of view of 270° taken for 180°", spread(180.0 / 270.0)},
    {"quaternions with w first", wFirst},
    {"quaternions left at 0 0 0 1", poses([](const Pose2& p) {
       return Pose2{p.x, p.y, 0.0};
     })},
    {"headings clockwise", poses([](const Pose2& p) {
       return Pose2{p.x, p.y, -p.heading};
     })},
    {"headings from y", poses([](const Pose2& p) {
       return Pose2{p.x, p.y, p.heading - kPi / 2};
     })},
    {"headings of a compass", poses([](const Pose2& p) {
       return Pose2{p.x, p.y, kPi / 2 - p.heading};
     })},
    {"headings in degrees", degrees([](double deg) { return deg; })},
    {"headings in degrees from 0 to 360",
     degrees([](double deg) { return deg < 0.0 ? deg + 360.0 : deg; })},
    {"headings of a compass in degrees",
     degrees([](double deg) { return std::fmod(450.0 - deg, 360.0); })},
    {"heights counted from the sensor", drive([](YardDrive& drive) {
       const auto number = std::make_shared<int>(0);
       drive.point = [number](const RangePoint& p) {
         return RangePoint{p.x, p.y, ++*number % 3 == 0 ? 0.5F : -1.7F, 1.0F};
       };
     })},
    {"drawing in millimetres", drawing(yard(1000, 1))},
    {"drawing in centimetres", drawing(yard(100, 1))},
    {"drawing with y down, a way through its buildings", wayThroughBuildings},
    {"drawing with y down, a street of one side", straight({6.0F}, drawnStreet(-1, false))},
    {"a mirrored laser on a straight drive, with a drawing",
     straight({-6.0F}, drawnStreet(1, false))},
    {"a mirrored laser on a straight drive", straight({-6.0F}, {})},
    {"drawing with y down, a street alike on both sides",
     straight({-6.0F, 6.0F}, drawnStreet(-1, true))},
    {"a misspelt key of the recording",
     drive([](YardDrive& drive) { drive.json = R"("range_limit": 40)"; })},
    {"a misspelt key of the drawing", misspelt()},
    {"a range limit that cuts",
     drive([](YardDrive& drive) { drive.json = R"("range_limit_m": 12)"; })},
    {"half of the points files missing",
     drive([](YardDrive& drive) { drive.has_points = [](int i) { return i % 2 == 0; }; })},
    {"a scanner that froze", files([](const test::TemporaryFolder& folder) {
       for (int i = 41; i < 50; ++i) {
         folder.write(fmt::format("points/{}.bin", i), folder.read("points/40.bin"));
       }
     })},
    {"one file in many rows",
     drive([](YardDrive& drive) { drive.file = [](int i) { return i > 40 && i < 50 ? 40 : i; }; })},
    {"gaps in the odometry",
     drive([](YardDrive& drive) { drive.has_pose = [](int i) { return i < 20 || i > 35; }; })},
    {"w = 0 everywhere", drive([](YardDrive& drive) {
       drive.point = [](const RangePoint& p) { return RangePoint{p.x, p.y, p.z, 0.0F}; };
     })},
    {"a NaN in each scan", files([](const test::TemporaryFolder& folder) {
       for (int i = 0; i < 60; ++i) {
         const std::string name = fmt::format("points/{}.bin", i);
         folder.write(name, folder.read(name) + test::pointBytes({{NAN, 1.0F, 0.0F, 1.0F}}));
       }
     })},
    {"points of x y z, without w", files([](const test::TemporaryFolder& folder) {
       for (int i = 0; i < 60; ++i) {
         const std::string name = fmt::format("points/{}.bin", i);
         const std::string all = folder.read(name);
         std::string planar;
         for (std::size_t at = 0; at < all.size(); at += 16) planar += all.substr(at, 12);
         folder.write(name, planar);
       }
     })},
    {"empty scans", files([](const test::TemporaryFolder& folder) {
       for (int i = 0; i < 60; i += 4) folder.write(fmt::format("points/{}.bin", i), "");
     })},
    {"no odometry", files([](const test::TemporaryFolder& folder) {
       std::filesystem::remove(folder.path() / "odometry.tum");
     })},
    {"no range limit", drive([](YardDrive& drive) { drive.json = R"("name": "yard")"; })},
};

struct Row {
  std::string wrong;
  std::string found;
  std::string cause;
  std::string sure;
};

void PrintTo(const Row& row, std::ostream* stream) { *stream << row.wrong; }

/// Of the first table of the page.
std::vector<Row> rowsOfPage() {
  std::ifstream page(HANDMAP_SOURCES "/core/plausibility/README.md");
  const std::regex cells("\\| (.*?) \\| (.*?) ?\\| (.*?) ?\\| (.*?) ?\\|");
  std::vector<Row> rows;
  std::smatch match;
  for (std::string line; std::getline(page, line);) {
    if (std::regex_match(line, match, cells)) {
      rows.push_back({match[1], match[2], match[3], match[4]});
    } else if (line.empty() && !rows.empty()) {
      break;
    }
  }
  if (!rows.empty()) rows.erase(rows.begin());  // the heading
  return rows;
}

class WrongInput : public testing::TestWithParam<Row> {};

TEST_P(WrongInput, IsSaidAsThePageSays) {
  const Row& row = GetParam();
  const auto wrong = kWrongs.find(row.wrong);
  ASSERT_NE(wrong, kWrongs.end()) << "nothing here makes it";
  const test::TemporaryFolder folder;
  const std::vector<Said> said = wrong->second(folder);
  if (row.found.starts_with("nothing")) {
    EXPECT_TRUE(said.empty()) << said[0].text;
    EXPECT_EQ(row.sure, "");
    return;
  }
  ASSERT_EQ(said.size(), 1U) << (said.empty() ? "" : said[1].text);
  for (const std::string& part : {row.found, row.cause}) {
    EXPECT_NE(said[0].text.find(part), std::string::npos) << said[0].text;
  }
  EXPECT_TRUE(std::regex_search(said[0].text, std::regex("^.+: found "))) << said[0].text;
  EXPECT_EQ(said[0].is_certain, row.sure.starts_with("error")) << said[0].text;
  EXPECT_TRUE(said[0].is_certain || row.sure.starts_with("warning"));
}

INSTANTIATE_TEST_SUITE_P(Page, WrongInput, testing::ValuesIn(rowsOfPage()), [](const auto& tested) {
  return std::regex_replace(tested.param.wrong, std::regex("[^a-zA-Z0-9]+"), "_");
});

TEST(WrongInputs, AllThatAreMadeStandInThePage) {
  std::set<std::string> rows;
  for (const Row& row : rowsOfPage()) rows.insert(row.wrong);
  for (const auto& [name, wrong] : kWrongs) EXPECT_TRUE(rows.contains(name)) << name;
}

}  // namespace
}  // namespace handmap
