#include "core/recording/view_reader.h"

#include <gtest/gtest.h>

#include "core/base/text.h"
#include "tests/core/base/expect_error.h"
#include "tests/core/recording/example_recording.h"

namespace handmap {
namespace {

using test::exampleImage;
using test::expectBadInput;

class ViewReaderTest : public testing::Test {
 protected:
  ViewReader reader() const { return ViewReader(recording_); }
  View imagesOf(ViewReader& reader, std::size_t row) const {
    View view;
    reader.readImages(recording_.rows[row], view);
    return view;
  }
  void writeImage(const std::string& name, const cv::Mat& image) const {
    writePng(image, example_.path() / name);
  }

  test::ExampleRecording example_;
  Recording recording_ = openRecording(example_.path());
};

TEST_F(ViewReaderTest, ReadsWhatTheRowNames) {
  ViewReader read = reader();
  const View view = imagesOf(read, 2);
  EXPECT_TRUE(test::sameImage(view.left, exampleImage(20)));
  EXPECT_TRUE(test::sameImage(view.right, exampleImage(21)));
  EXPECT_FALSE(view.points);
  View points;
  read.readPoints(recording_.rows[2], points);
  ASSERT_EQ(points.points->size(), 2U);
  EXPECT_EQ(points.points->front().x, 2.0F);
  EXPECT_TRUE(points.left.empty());
}

TEST_F(ViewReaderTest, WantsAnIdForEachPointWhereThereAreIds) {
  const std::filesystem::path ids =
      (recording_.folder / recording_.rows[2].points).replace_extension(".ids");
  View points;
  writeFileAtomically(ids, std::string("\7\0\0\0\3\1\0\0", 8));
  reader().readPoints(recording_.rows[2], points);
  EXPECT_EQ(points.ids, (std::vector<std::uint32_t>{7, 259}));
  writeFileAtomically(ids, "four");
  expectBadInput([&] { reader().readPoints(recording_.rows[2], points); },
                 {".ids: found 4 bytes, expected 4 bytes for each of 2 points"});
}

TEST_F(ViewReaderTest, WantsOneSizeOfAllImages) {
  writeImage("image_1/1.png", exampleImage(1, 34, 16));
  writeImage("image_0/3.png", exampleImage(1, 32, 18));
  ViewReader read = reader();
  expectBadInput([&] { imagesOf(read, 1); },
                 {"image_1/1.png: found 34 × 16 pixels, expected 32 × 16 as the images before"});
  EXPECT_NO_THROW(imagesOf(read, 2));
  expectBadInput([&] { imagesOf(read, 3); }, {"image_0/3.png: found 32 × 18 pixels"});
}

TEST_F(ViewReaderTest, WantsTheSizeThatTheCalibrationTells) {
  recording_.camera->cx = 40.0;
  ViewReader read = reader();
  expectBadInput([&] { imagesOf(read, 0); },
                 {"image_0/0.png: found 32 × 16 pixels, expected images that the calibration "
                  "belongs to: its principal point is at x = 40 px"});
}

TEST_F(ViewReaderTest, WantsBothImagesOfOneTime) {
  ViewReader read = reader();
  recording_.rows[1].right_time_s = recording_.rows[1].time_s - 0.009;
  EXPECT_NO_THROW(imagesOf(read, 1));
  recording_.rows[1].right_time_s = recording_.rows[1].time_s - 0.011;
  expectBadInput([&] { imagesOf(read, 1); },
                 {"image_1/1.png: found the right image taken at 10.989 s, the left one at 11 s, "
                  "expected both within 0.01 s"});
}

TEST_F(ViewReaderTest, TellsOfWhatCannotBeRead) {
  std::filesystem::remove(example_.path() / "image_1/4.png");
  example_.folder().write("points/4.bin", "short");
  writeImage("image_0/5.png", cv::Mat1b(16, 32, std::uint8_t{0}));
  ViewReader read = reader();
  expectBadInput([&] { imagesOf(read, 4); }, {"image_1/4.png: found no such file"});
  View view;
  expectBadInput([&] { read.readPoints(recording_.rows[4], view); },
                 {"points/4.bin: found 5 bytes"});
  expectBadInput([&] { imagesOf(read, 5); }, {"image_0/5.png: found 100 % of the pixels black"});
}

}  // namespace
}  // namespace handmap
