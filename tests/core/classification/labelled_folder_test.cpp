#include "core/classification/labelled_folder.h"

#include <gtest/gtest.h>

#include "core/recording/image_file.h"
#include "tests/core/base/expect_error.h"
#include "tests/core/base/temporary_folder.h"
#include "tests/core/classification/painted_street.h"

namespace handmap {
namespace {

namespace fs = std::filesystem;

class Labelled : public testing::Test {
 protected:
  Labelled() {
    fs::create_directories(folder_.images);
    fs::create_directories(folder_.labels);
    add("b", test::paintStreet('b'));
    add("a", test::paintStreet('a'));
    files_.write("images/notes.txt", "not an image");
  }

  void add(const std::string& name, const test::PaintedStreet& street) const {
    writePng(street.image, folder_.images / (name + ".png"));
    writePng(street.classes, folder_.labels / (name + ".png"));
  }

  void expectRefused(const std::vector<std::string>& words) const {
    const auto ignore = [](const cv::Mat&, const std::vector<WindowLabel>&, double) {};
    test::expectBadInput([&] { forEachLabelled(folder_, ignore); }, words);
  }

  test::TemporaryFolder files_;
  LabelledFolder folder_{files_.path() / "images", files_.path() / "labels", 1, {}};
};

TEST_F(Labelled, ImagesComeInTheOrderOfTheirNames) {
  std::vector<double> shares;
  forEachLabelled(
      folder_, [&](const cv::Mat& image, const std::vector<WindowLabel>& labels, double share) {
        const test::PaintedStreet street = test::paintStreet(shares.empty() ? 'a' : 'b');
        EXPECT_EQ(cv::norm(image, street.image), 0.0);
        EXPECT_EQ(labels, windowLabels(street.classes, 1, {}));
        shares.push_back(share);
      });
  EXPECT_EQ(shares, (std::vector{0.5, 1.0}));
}

TEST_F(Labelled, ImagesAreVariedTheSameWayForTheSameSeed) {
  folder_.variations = 2;
  const auto images = [&] {
    std::vector<cv::Mat> seen;
    forEachLabelled(
        folder_, [&](const cv::Mat& image, const std::vector<WindowLabel>& labels, double) {
          EXPECT_EQ(labels,
                    windowLabels(test::paintStreet(seen.size() < 3 ? 'a' : 'b').classes, 1, {}));
          seen.push_back(image.clone());
        });
    return seen;
  };
  const std::vector<cv::Mat> first = images();
  ASSERT_EQ(first.size(), 6U);
  EXPECT_EQ(cv::norm(first[3], test::paintStreet('b').image), 0.0);
  EXPECT_GT(cv::norm(first[4], first[3], cv::NORM_L1) / (3.0 * 160 * 128), 2.0);
  EXPECT_GT(cv::norm(first[5], first[4]), 0.0);
  const std::vector<cv::Mat> second = images();
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(cv::norm(first[i], second[i]), 0.0);
  folder_.seed = 2;
  EXPECT_GT(cv::norm(images()[1], first[1]), 0.0);
}

TEST_F(Labelled, FoldersMustMatch) {
  fs::remove(folder_.labels / "b.png");
  expectRefused({"labels/b.png: found no such file", "the labels of b.png"});
  writePng(cv::Mat1b(128, 144, std::uint8_t{0}), folder_.labels / "b.png");
  expectRefused({"labels/b.png", "144 × 128 pixels", "160 × 128 as its image"});
  writePng(test::paintStreet(1).image, folder_.labels / "b.png");
  expectRefused({"labels/b.png: found a colour image"});
}

TEST_F(Labelled, ImagesMustBeThereAndReadable) {
  files_.write("images/b.png", "\x89PNG\r\n");
  expectRefused({"images/b.png"});
  fs::remove_all(folder_.images);
  expectRefused({"images: found no folder that can be read"});
  fs::create_directory(folder_.images);
  expectRefused({"images: found no images"});
}

}  // namespace
}  // namespace handmap
