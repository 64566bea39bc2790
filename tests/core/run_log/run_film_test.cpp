#include "core/run_log/run_film.h"

#include <csignal>
#include <fstream>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>
#include <sys/resource.h>

#include "core/base/error.h"
#include "core/recording/image_file.h"
#include "core/run_log/run_part.h"
#include "core/session/run_session.h"
#include "core/simulation/simulated_source.h"
#include "core/simulation/world.h"
#include "tests/core/base/temporary_folder.h"

namespace handmap {
namespace {

namespace fs = std::filesystem;

class RunFilms : public testing::Test {
 protected:
  /// Three frames of a run, each told twice.
  void film(const fs::path& path) const {
    const World world = twoRowWorld(3);
    RunSettings settings;
    settings.threads = 1;
    RunSession session(world.map, simulate(world, {}, 3), settings);
    RunFilm film(path, world.map);
    for (int i = 0; i < 3; ++i) {
      const auto snapshot = session.step();
      ASSERT_TRUE(snapshot);
      film.add(*snapshot);
      film.add(*snapshot);
    }
    film.finish();
  }
  /// Where two pictures differ.
  static int apart(const cv::Mat& a, const cv::Mat& b) {
    cv::Mat difference;
    cv::absdiff(a, b, difference);
    return cv::countNonZero(difference.reshape(1));
  }

  test::TemporaryFolder folder_;
};

TEST_F(RunFilms, AreNumberedPicturesOnWhichTheRobotMoves) {
  film(folder_.path() / "film");
  EXPECT_FALSE(fs::exists(folder_.path() / "film/000003.png"));
  const cv::Mat first = readImage(folder_.path() / "film/000000.png");
  const cv::Mat last = readImage(folder_.path() / "film/000002.png");
  EXPECT_EQ(first.size(), cv::Size(1280, 720));
  EXPECT_GT(apart(first, last), 100);
  EXPECT_GT(apart(first, cv::Mat(first.size(), first.type(), first.at<cv::Vec3b>(0, 0))), 1000);
}

TEST_F(RunFilms, AreVideos) {
  const fs::path path = folder_.path() / "film.avi";
  EXPECT_TRUE(RunFilm::isVideo(path));
  film(path);
  cv::VideoCapture video(path.string());
  ASSERT_TRUE(video.isOpened());
  cv::Mat picture;
  int pictures = 0;
  while (video.read(picture)) ++pictures;
  EXPECT_EQ(pictures, 3);
}

/// As a disk that is full: no file may grow beyond so many bytes.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : signal_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit now = before_;
    now.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &now);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, signal_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
  void (*signal_)(int);
};

TEST_F(RunFilms, OnAFullDiskTheOldOneStays) {
  for (const char* name : {"film.mp4", "film.avi", "film.mkv"}) {
    const fs::path path = folder_.path() / name;
    std::ofstream(path) << "the old one";
    {
      const FullDisk disk(12'000);
      EXPECT_THROW(film(path), Error) << name;
    }
    EXPECT_EQ(fs::file_size(path), 11U) << name;
    EXPECT_FALSE(fs::exists(runPartOf(path))) << name;
    film(path);
    EXPECT_GT(fs::file_size(path), 12'000U) << name;
  }
}

TEST_F(RunFilms, OverwriteNoFolderThatHoldsSomething) {
  std::ofstream(folder_.path() / "mine.txt") << "mine";
  EXPECT_THROW(RunFilm(folder_.path(), twoRowWorld(3).map), Error);
  EXPECT_THROW(RunFilm(folder_.path() / "nowhere/film.avi", twoRowWorld(3).map), Error);
}

}  // namespace
}  // namespace handmap
