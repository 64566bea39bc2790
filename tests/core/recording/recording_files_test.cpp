#include "core/recording/recording_files.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/text.h"
#include "tests/core/base/temporary_folder.h"

namespace handmap {
namespace {

namespace fs = std::filesystem;

class RecordingFiles : public testing::Test {
 protected:
  RecordingFiles() {
    fs::create_directories(recording_ / "points");
    fs::create_directories(recording_ / "out");
    put("recording.json", R"({"format":"handmap-recording","version":1,
      "camera":{"calibration":"Cameras.yml"}})");
    put("frames.csv", "frame,time_s,stop,pan_deg,left,right,points\n0,0,,,,,points/000000.bin\n");
    put("odometry.tum", "");
    put("Cameras.yml", "");
    put("points/000000.bin", "");
    put("refined.handmap", "");
    put("out/report.json", "");
  }
  void put(const std::string& name, const std::string& text) const {
    writeFileAtomically(recording_ / name, text);
  }
  bool belongs(const fs::path& file) const { return recordingOf(file).has_value(); }

  TemporaryFolder folder_;
  fs::path recording_ = folder_.path() / "R";
};

TEST_F(RecordingFiles, AreThoseThatTheFormatAndTheTableName) {
  for (const char* name : {"recording.json", "frames.csv", "odometry.tum", "truth.tum", "calib.txt",
                           "acts.jsonl", "Cameras.yml", "points/000000.bin", "points/000000.ids",
                           "ODOMETRY.tum", "cameras.YML", "./points/../odometry.tum"}) {
    EXPECT_TRUE(belongs(recording_ / name)) << name;
  }
  for (const char* name : {"refined.handmap", "out/report.json", "out/odometry.tum", "way.tum",
                           "points/000001.bin", "000000.bin"}) {
    EXPECT_FALSE(belongs(recording_ / name)) << name;
  }
  EXPECT_FALSE(belongs(folder_.path() / "odometry.tum"));
}

TEST_F(RecordingFiles, AreFoundBehindLinks) {
  fs::create_directory_symlink(recording_, folder_.path() / "link");
  fs::create_symlink(recording_ / "frames.csv", folder_.path() / "table.csv");
  EXPECT_TRUE(belongs(folder_.path() / "link" / "truth.tum"));
  EXPECT_TRUE(belongs(folder_.path() / "table.csv"));
}

TEST_F(RecordingFiles, OfAKittiSequence) {
  const fs::path kitti = folder_.path() / "00";
  fs::create_directories(kitti / "image_2");
  for (const char* name : {"times.txt", "calib.txt"}) writeFileAtomically(kitti / name, "");
  for (const char* name : {"times.txt", "image_2/000000.png", "poses.txt"}) {
    EXPECT_TRUE(belongs(kitti / name)) << name;
  }
  EXPECT_FALSE(belongs(kitti / "refined.handmap"));
}

TEST_F(RecordingFiles, AreRefusedByName) {
  try {
    refuseFileOfRecording(recording_ / "frames.csv");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("frames.csv: found a file of the recording"),
              std::string::npos);
  }
  EXPECT_THROW(refuseFileOfRecording(recording_ / "odometry.tum", NewOdometry::Allowed), Error);
  fs::remove(recording_ / "odometry.tum");
  EXPECT_THROW(refuseFileOfRecording(recording_ / "odometry.tum"), Error);
  EXPECT_NO_THROW(refuseFileOfRecording(recording_ / "odometry.tum", NewOdometry::Allowed));
}

TEST_F(RecordingFiles, ADamagedRecordingIsOneToo) {
  put("recording.json", "{");
  put("frames.csv", std::string("\0\xff", 2));
  EXPECT_TRUE(belongs(recording_ / "odometry.tum"));
}

}  // namespace
}  // namespace handmap
