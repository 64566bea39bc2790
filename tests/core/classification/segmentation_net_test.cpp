#include "core/classification/segmentation_net.h"

#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/classification/load_classifier.h"
#include "tests/core/base/temporary_folder.h"
#include "tests/core/classification/tiny_network.h"

namespace handmap {
namespace {

/// Grey on the left, red on the right from column 32 on.
cv::Mat3b street() {
  cv::Mat3b image(48, 70, cv::Vec3b(128, 128, 128));
  image.colRange(32, 70) = cv::Vec3b(20, 20, 240);
  return image;
}

class SegmentationNetTest : public testing::Test {
 protected:
  std::string complaint(const std::filesystem::path& path,
                        std::optional<int> building_class = 2) const {
    try {
      SegmentationNet::load(path, building_class);
      return "none";
    } catch (const Error& error) {
      return error.what();
    }
  }

  test::TemporaryFolder folder_;
};

TEST_F(SegmentationNetTest, JudgesWholeWindows) {
  const auto net = loadClassifier(folder_.write("net.onnx", redIsBuilding()), 2);
  const cv::Mat1f windows = net->probabilities(street());
  ASSERT_EQ(windows.size(), cv::Size(4, 3));
  for (int row = 0; row < windows.rows; ++row) {
    EXPECT_LT(windows(row, 0), 0.1F);
    EXPECT_LT(windows(row, 1), 0.3F);  // the network sees the image a little stretched
    EXPECT_GT(windows(row, 2), 0.7F);
    EXPECT_GT(windows(row, 3), 0.9F);
  }
  const cv::Mat1f another =
      SegmentationNet::load(folder_.path() / "net.onnx", 0)->probabilities(street());
  EXPECT_LT(another(0, 3), 0.1F);
}

TEST_F(SegmentationNetTest, TakesGreyImages) {
  const auto net = SegmentationNet::load(folder_.write("net.onnx", redIsBuilding()), 2);
  EXPECT_EQ(net->probabilities(cv::Mat1b(32, 32, std::uint8_t{128})).size(), cv::Size(2, 2));
}

TEST_F(SegmentationNetTest, ReadsWhatLiesBeside) {
  const auto path = folder_.write("net.onnx", redIsBuilding());
  EXPECT_TRUE(complaint(path, {}).ends_with("found no number of its class for buildings"));
  folder_.write("net.json", R"({"building_class": 2, "width": 96, "height": 64})");
  const auto net = SegmentationNet::load(path);
  EXPECT_GT(net->probabilities(street())(1, 3), 0.9F);
  // Red as it is on the average: nothing is redder any more.
  folder_.write("net.json", R"({"building_class": 2, "mean": [1, 0, 0], "deviation": [1, 1, 1]})");
  EXPECT_LT(SegmentationNet::load(path)->probabilities(street())(1, 3), 0.5F);
  folder_.write("net.json", R"({"building_class": 2, "width": 96})");
  EXPECT_NE(complaint(path).find("\"width\" and \"height\", or neither"), std::string::npos);
  folder_.write("net.json", R"({"building_class": 2, "deviation": [1, 0, 1]})");
  EXPECT_NE(complaint(path).find("deviation[1]"), std::string::npos);
}

TEST_F(SegmentationNetTest, OneClassIsAProbabilityOrItsLogit) {
  const auto path = folder_.write("net.onnx", tinyNetwork({{4.0F, -2.0F, -2.0F}}, {-2.0F}));
  const cv::Mat1f windows = SegmentationNet::load(path, 0)->probabilities(street());
  EXPECT_LT(windows(0, 0), 0.3F);
  EXPECT_GT(windows(0, 3), 0.9F);
}

TEST_F(SegmentationNetTest, WhatIsNoneIsRefused) {
  EXPECT_NE(complaint(folder_.path() / "gone.onnx").find("found no file"), std::string::npos);
  EXPECT_NE(complaint(folder_.write("torn.onnx", redIsBuilding().substr(0, 70))).find("torn.onnx"),
            std::string::npos);
  EXPECT_NE(complaint(folder_.write("text.onnx", "not a network")).find("in ONNX form"),
            std::string::npos);
  EXPECT_NE(complaint(folder_.write("empty.onnx", "")).find("empty.onnx"), std::string::npos);
  EXPECT_NE(complaint(folder_.write("net.onnx", redIsBuilding()), 3).find("1×3×32×32"),
            std::string::npos)
      << complaint(folder_.path() / "net.onnx", 3);
  const auto net = SegmentationNet::load(folder_.path() / "net.onnx", 2);
  EXPECT_THROW(net->probabilities(cv::Mat1b(8, 8, std::uint8_t{0})), Error);
  EXPECT_THROW(net->probabilities(cv::Mat1f(32, 32, 0.0F)), Error);
}

TEST_F(SegmentationNetTest, AnyNumberOfThreadsMayAsk) {
  const auto net = SegmentationNet::load(folder_.write("net.onnx", redIsBuilding()), 2);
  const cv::Mat1f expected = net->probabilities(street());
  std::vector<std::jthread> threads;
  std::atomic<int> different = 0;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      if (cv::norm(net->probabilities(street()), expected, cv::NORM_INF) != 0.0) ++different;
    });
  }
  threads.clear();
  EXPECT_EQ(different, 0);
}

}  // namespace
}  // namespace handmap
