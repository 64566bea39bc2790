// What people and broken disks hand in: a clear word, exit status 2, nothing written.
#include <functional>
#include <optional>

#include "tests/cli/program.h"

namespace handmap {
namespace {

namespace fs = std::filesystem;

struct Case {
  std::string name;
  std::function<void()> spoil;  ///< changes map.handmap or the recording rec
  std::string err;              ///< after "handmap-cli: error: "
};

void PrintTo(const Case& bad, std::ostream* stream) { *stream << bad.name; }

/// Three frames of points and images.
void writeRecording() {
  fs::create_directories("rec/points");
  fs::create_directories("rec/image_0");
  fs::create_directories("rec/image_1");
  writeText("rec/recording.json", R"({"format": "handmap-recording", "version": 1, "camera": {}})");
  writeText("rec/calib.txt",
            "P0: 100 0 80 0 0 100 48 0 0 0 1 0\nP1: 100 0 80 -50 0 100 48 0 0 0 1 0\n");
  writeText("rec/frames.csv",
            "frame,time_s,stop,pan_deg,left,right,points\n"
            "0,0.0,,,image_0/0.png,image_1/0.png,points/0.bin\n"
            "1,1.0,,,image_0/1.png,image_1/1.png,points/1.bin\n"
            "2,2.0,,,image_0/2.png,image_1/2.png,points/2.bin\n");
  writeText("rec/odometry.tum", "0 0 0 0 0 0 0 1\n1 2 0 0 0 0 0 1\n2 4 0 0 0 0 0 1\n");
  const std::vector<float> points{10, 14, 1, 1, 11, 14, 1, 1, 12, 14, 1, 1};
  const std::string bytes(reinterpret_cast<const char*>(points.data()), 4 * points.size());
  for (const std::string frame : {"0", "1", "2"}) {
    writeText("rec/points/" + frame + ".bin", bytes);
    for (const std::string camera : {"0", "1"}) {
      fs::copy(fs::path(HANDMAP_TEST_DATA) / "tiles-160x96.png",
               "rec/image_" + camera + "/" + frame + ".png");
    }
  }
}

class BadInput : public CliTest, public testing::WithParamInterface<Case> {
 protected:
  BadInput() {
    fs::copy("row-drawn.handmap", "map.handmap");
    writeRecording();
  }
};

TEST_P(BadInput, IsToldAndNothingIsWritten) {
  GetParam().spoil();
  expectFailed(run({"run", "--map", "map.handmap", "--recording", "rec", "--out", "out.handmap",
                    "--trajectory", "out.tum", "--report", "out.json"}),
               2, "handmap-cli: error: " + GetParam().err);
  for (const char* output : {"out.handmap", "out.tum", "out.json"}) {
    EXPECT_FALSE(fs::exists(output));
  }
}

std::function<void()> mapIs(const std::string& text) {
  return [=] { writeText("map.handmap", text); };
}
std::function<void()> mapHas(const std::string& from, const std::string& to) {
  return [=] { replaceIn("map.handmap", from, to); };
}
std::function<void()> fileIs(const std::string& name, const std::string& text) {
  return [=] { writeText("rec/" + name, text); };
}
std::function<void()> fileHas(const std::string& name, const std::string& from,
                              const std::string& to) {
  return [=] { replaceIn("rec/" + name, from, to); };
}
std::function<void()> gone(const std::string& name) {
  return [=] { fs::remove_all(name); };
}

/// With that as the calibration of OpenCV, or none.
std::function<void()> unrectified(const std::optional<std::string>& calibration) {
  return [=] {
    replaceIn("rec/recording.json", "{}", R"({"rectified": false, "calibration": "calib.yml"})");
    if (calibration) writeText("rec/calib.yml", *calibration);
  };
}

std::string nameOf(const testing::TestParamInfo<Case>& info) { return info.param.name; }

const char* const kEmptyMap = R"({"format": "handmap", "version": 1, "buildings": []})";

INSTANTIATE_TEST_SUITE_P(
    Maps, BadInput,
    testing::Values(
        Case{"Missing", gone("map.handmap"),
             "map.handmap: found no such file, expected a readable file\n"},
        Case{"Folder",
             [] {
               fs::remove("map.handmap");
               fs::create_directory("map.handmap");
             },
             "map.handmap: found no regular file, expected a file\n"},
        Case{"Empty", mapIs(""),
             "map.handmap: line 1, column 1: no valid JSON: syntax error while parsing value - "
             "unexpected end of input; expected '[', '{', or a literal\n"},
        Case{"Truncated", [] { fs::resize_file("map.handmap", 300); },
             "map.handmap: line 9, column 1: no valid JSON: syntax error while parsing value - "
             "unexpected end of input; expected '[', '{', or a literal\n"},
        Case{"NoJsonObject", mapIs("[1, 2]"),
             "map.handmap: found an array of 2, expected an object\n"},
        Case{"OtherFormat", mapHas("\"handmap\"", "\"geojson\""),
             "map.handmap: format: found \"geojson\" (string), expected \"handmap\"\n"},
        Case{"NewerVersion", mapHas("\"version\": 1", "\"version\": 2"),
             "map.handmap: version: found 2, this program reads up to 1\nhint: update the program "
             "to open this map\n"},
        Case{"NoBuilding", mapIs(kEmptyMap),
             "map.handmap: buildings: found none, expected at least one\n"},
        Case{"NoStart", mapHas("\"start\"", "\"begin\""),
             "map.handmap: start: found none, expected where the robot starts\n"},
        Case{"NotFinite", mapHas("\"x\": 22", "\"x\": 1e999"),
             "map.handmap: line 8: buildings[0].x: found a number too large to represent, expected "
             "a finite number\n"},
        Case{"Huge", mapHas("\"x\": 22", "\"x\": 1e300"),
             "map.handmap: buildings[0].x: found 1e+300, expected a number from -1000000 to "
             "1000000\n"},
        Case{"NegativeWidth", mapHas("\"width\": 26", "\"width\": -26"),
             "map.handmap: buildings[0].width: found -26, expected a number > 0 and at most "
             "100000\n"},
        Case{"WrongType", mapHas("\"width\": 26", "\"width\": \"26 m\""),
             "map.handmap: buildings[0].width: found \"26 m\" (string), expected a number > 0 and "
             "at most 100000\n"},
        Case{"OneIdTwice", mapHas("\"id\": \"X\"", "\"id\": \"N1\""),
             "map.handmap: buildings[2].id: found \"N1\", the id of buildings[0], expected an id "
             "that is unique in the file\n"}),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    Recordings, BadInput,
    testing::Values(
        Case{"Missing", gone("rec"),
             "rec: found no such folder, expected the folder of a recording\n"},
        Case{"NoJson", gone("rec/recording.json"),
             "rec: found neither recording.json nor a KITTI sequence, expected recording.json, or "
             "times.txt and image_0 or image_2\n"},
        Case{"EmptyJson", fileIs("recording.json", ""),
             "rec/recording.json: line 1, column 1: no valid JSON: syntax error while parsing "
             "value - unexpected end of input; expected '[', '{', or a literal\n"},
        Case{"NewerVersion", fileHas("recording.json", "1", "7"),
             "rec/recording.json: version: found 7, this program reads up to 2\nhint: update the "
             "program to open this recording\n"},
        Case{"WrongType", fileHas("recording.json", "{}", "\"front\""),
             "rec/recording.json: camera: found \"front\" (string), expected an object\n"},
        Case{"NoFrames", gone("rec/frames.csv"),
             "rec/frames.csv: found no such file, expected a readable file\n"},
        Case{"EmptyFrames", fileIs("frames.csv", ""),
             "rec/frames.csv: found no rows, expected a header line and rows\n"},
        Case{"FrameNotFinite", fileHas("frames.csv", "1.0", "nan"),
             "rec/frames.csv: line 3: time_s: found \"nan\", expected a finite number, at most "
             "1000000000000\n"},
        Case{"TimeGoesBack", fileHas("frames.csv", "2.0", "0.5"),
             "rec/frames.csv: line 4: time_s: found 0.5 after 1, expected times that increase\n"},
        Case{"RowCutOff",
             fileHas("frames.csv", "1,1.0,,,image_0/1.png,image_1/1.png,points/1.bin", "1,1.0,,"),
             "rec/frames.csv: line 3: found 4 fields, expected 7\n"},
        Case{"ImageOutside", fileHas("frames.csv", "image_0/1.png", "../../1.png"),
             "rec/frames.csv: line 3: left: found \"../../1.png\", expected a path inside the "
             "folder\n"}),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    Calibrations, BadInput,
    testing::Values(
        Case{"Missing", gone("rec/calib.txt"),
             "rec/calib.txt: found no such file, expected a readable file\n"},
        Case{"Empty", fileIs("calib.txt", ""),
             "rec/calib.txt: found no line P0:, expected the 12 numbers of the camera\n"},
        Case{"Truncated", fileIs("calib.txt", "P0: 100 0 80 0 0 100 48 0 0 0 1 0\nP1: 100 0 80"),
             "rec/calib.txt: line 2: P1: found 3 numbers, expected 12\n"},
        Case{"NotFinite", fileHas("calib.txt", "-50", "-inf"),
             "rec/calib.txt: line 2: P1: found \"-inf\", expected a finite number\n"},
        Case{"ZeroBaseline", fileHas("calib.txt", "-50", "0"),
             "rec/calib.txt: P0 and P1: found a baseline of 0 m, expected one > 0 and at most 100 "
             "m: the right camera to the right of the left one\n"},
        Case{"NegativeBaseline", fileHas("calib.txt", "-50", "50"),
             "rec/calib.txt: P0 and P1: found a baseline of -0.5 m, expected one > 0 and at most "
             "100 m: the right camera to the right of the left one\n"},
        Case{"HugeBaseline", fileHas("calib.txt", "-50", "-50e6"),
             "rec/calib.txt: P0 and P1: found a baseline of 5e+05 m, expected one > 0 and at most "
             "100 m: the right camera to the right of the left one\n"},
        Case{"UnrectifiedMissing", unrectified({}),
             "rec/calib.yml: found no such file, expected a readable file\n"},
        Case{"UnrectifiedEmpty", unrectified(""),
             "rec/calib.yml: found an empty file, expected a YAML or XML file of OpenCV with M1 D1 "
             "M2 D2 R T\n"},
        Case{"UnrectifiedTruncated", unrectified("%YAML:1.0\n---\nimage_width: 160\n"),
             "rec/calib.yml: image_height: found nothing, expected the size of the images, 1 to "
             "32768 pixels\n"},
        Case{"UnrectifiedWithoutMatrix",
             unrectified("%YAML:1.0\n---\nimage_width: 160\nimage_height: 96\n"),
             "rec/calib.yml: M1: found nothing, expected a matrix\n"},
        Case{"UnrectifiedOfKitti",
             fileHas("recording.json", "{}", R"({"rectified": false, "calibration": "calib.txt"})"),
             "rec/recording.json: camera.calibration: found \"calib.txt\" (string), expected a "
             ".yml, .yaml or .xml of OpenCV (\"rectified\" is false)\n"}),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    Odometries, BadInput,
    testing::Values(
        Case{"Empty", fileIs("odometry.tum", ""),
             "rec/odometry.tum: found no pose, expected lines of time x y z qx qy qz qw\n"},
        Case{"Truncated", fileHas("odometry.tum", "2 4 0 0 0 0 0 1\n", "2 4 0"),
             "rec: frame 2 is at 2 s, but the odometry ends at 1 s\nhint: end earlier: --to 1\n"},
        Case{"NotFinite", fileHas("odometry.tum", "2 4", "2 nan"),
             "rec/odometry.tum: line 3: found \"nan\", expected a finite number, at most "
             "100000000\n"},
        Case{"Huge", fileHas("odometry.tum", "2 4", "2 1e30"),
             "rec/odometry.tum: line 3: found \"1e30\", expected a finite number, at most "
             "100000000\n"},
        Case{"WrongType", fileHas("odometry.tum", "2 4", "2 four"),
             "rec/odometry.tum: line 3: found \"four\", expected a finite number, at most "
             "100000000\n"},
        Case{"NoRotation", fileHas("odometry.tum", "2 4 0 0 0 0 0 1", "2 4 0 0 0 0 0 0"),
             "rec/odometry.tum: line 3: found a quaternion of length 0, expected length 1\n"},
        Case{"TimeGoesBack", fileHas("odometry.tum", "2 4", "0.5 4"),
             "rec/odometry.tum: line 3: found time 0.5 after 1, expected times that increase\n"},
        Case{"StartsLate", fileHas("odometry.tum", "0 0 0 0 0 0 0 1\n", ""),
             "rec: frame 0 is at 0 s, but the odometry starts late, at 1 s\nhint: begin later: "
             "--from 1\n"},
        Case{"EndsEarly", fileHas("odometry.tum", "2 4 0 0 0 0 0 1\n", ""),
             "rec: frame 2 is at 2 s, but the odometry ends at 1 s\nhint: end earlier: --to 1\n"}),
    nameOf);

class BadFrame : public BadInput {};

TEST_P(BadFrame, IsToldAndSkipped) {
  GetParam().spoil();
  const bool images = GetParam().err.find("image_") != std::string::npos;
  const Outcome outcome = run({"run", "--map", "map.handmap", "--recording", "rec", "--source",
                               images ? "images" : "points", "--out", "out.handmap"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out.find("2 observations used, 1 skipped\n"), 0U) << outcome.out;
  // Nothing in what is left looks like a building.
  EXPECT_EQ(
      outcome.err.find("handmap-cli: frame 1 skipped: " + GetParam().err +
                       "handmap-cli: warning: No building was recognised in 2 observations: "),
      0U)
      << outcome.err;
  EXPECT_TRUE(fs::exists("out.handmap"));
  expectFailed(run({"validate", "rec"}), 2, "handmap-cli: error: frame 1: " + GetParam().err);
}

std::string pointsOf(std::initializer_list<float> values) {
  return {reinterpret_cast<const char*>(values.begin()), sizeof(float) * values.size()};
}

INSTANTIATE_TEST_SUITE_P(
    Cli, BadFrame,
    testing::Values(
        Case{"ImageMissing", gone("rec/image_1/1.png"),
             "rec/image_1/1.png: found no such file, expected a readable file\n"},
        Case{"ImageEmpty", fileIs("image_0/1.png", ""),
             "rec/image_0/1.png: found an empty file, expected a PNG or JPEG image\n"},
        Case{"ImageTruncated", [] { fs::resize_file("rec/image_0/1.png", 60); },
             "rec/image_0/1.png: found an image that is cut off, expected a whole one\n"},
        Case{"NoImage", fileIs("image_0/1.png", "a picture"),
             "rec/image_0/1.png: found no image, expected a PNG or JPEG image\n"},
        Case{"RightImageLate",
             [] {
               replaceIn("rec/frames.csv", "right,points", "right,points,right_time_s");
               replaceIn("rec/frames.csv", "0.bin", "0.bin,0");
               replaceIn("rec/frames.csv", "1.bin", "1.bin,1.25");
               replaceIn("rec/frames.csv", "2.bin", "2.bin,2.01");
             },
             "rec/image_1/1.png: found the right image taken at 1.25 s, the left one at 1 s, "
             "expected both within 0.01 s\n"},
        Case{"PointsMissing", gone("rec/points/1.bin"),
             "rec/points/1.bin: found no such file, expected a readable file\n"},
        Case{
            "PointsTruncated", fileIs("points/1.bin", "7 bytes"),
            "rec/points/1.bin: found 7 bytes, expected 16 bytes a point (x y z w) or 12 (x y z)\n"},
        Case{"WeightOutside", fileIs("points/1.bin", pointsOf({10, 14, 1, 2})),
             "rec/points/1.bin: found 1 points with w outside 0 … 1, expected w from 0 to 1: how "
             "surely a point is on a building, no intensity\n"}),
    nameOf);

}  // namespace
}  // namespace handmap
