#include "drivers/camera/raw_images.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

TEST(RawImages, BytesInTurnBecomeOneImageEach) {
  // 3 × 2 pixels of three cameras: hundreds tell the camera, units the pixel.
  std::vector<std::uint8_t> bytes;
  for (int pixel = 0; pixel < 6; ++pixel) {
    for (int camera = 0; camera < 3; ++camera) {
      bytes.push_back(static_cast<std::uint8_t>(100 * camera / 2 + pixel));
    }
  }
  const auto three = deinterlaced(bytes.data(), {3, 2}, 3);
  ASSERT_EQ(three.size(), 3U);
  for (int camera = 0; camera < 3; ++camera) {
    for (int pixel = 0; pixel < 6; ++pixel) {
      EXPECT_EQ(three[static_cast<std::size_t>(camera)](pixel / 3, pixel % 3),
                100 * camera / 2 + pixel);
    }
  }
  const auto two = deinterlaced(bytes.data(), {3, 3}, 2);
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[0](0, 1), bytes[2]);
  EXPECT_EQ(two[1](2, 2), bytes[17]);
}

TEST(RawImages, ATileIsNamedByItsLetters) {
  EXPECT_EQ(bayerTileOf(0x52474742), BayerTile::Rggb);
  EXPECT_EQ(bayerTileOf(0x47425247), BayerTile::Gbrg);
  EXPECT_EQ(bayerTileOf(0x47524247), BayerTile::Grbg);
  EXPECT_EQ(bayerTileOf(0x42474752), BayerTile::Bggr);
  EXPECT_EQ(bayerTileOf(0x59595959), BayerTile::None) << "YYYY: grey";
  EXPECT_EQ(bayerTileOf(0), BayerTile::None);
}

/// What a sensor with that tile sees of a wall of one colour.
cv::Mat1b seen(const std::string& tile, const cv::Vec3b& bgr) {
  cv::Mat1b raw(16, 16);
  for (int v = 0; v < raw.rows; ++v) {
    for (int u = 0; u < raw.cols; ++u) {
      const char letter = tile[static_cast<std::size_t>(2 * (v % 2) + u % 2)];
      raw(v, u) = bgr[letter == 'B' ? 0 : letter == 'G' ? 1 : 2];
    }
  }
  return raw;
}

TEST(RawImages, EveryTileGivesTheColourOfTheWall) {
  const cv::Vec3b brick(40, 90, 200);
  for (const auto& [name, tile] :
       {std::pair("RGGB", BayerTile::Rggb), std::pair("GBRG", BayerTile::Gbrg),
        std::pair("GRBG", BayerTile::Grbg), std::pair("BGGR", BayerTile::Bggr)}) {
    const cv::Mat image = developed(seen(name, brick), tile);
    ASSERT_EQ(image.type(), CV_8UC3) << name;
    EXPECT_EQ(image.at<cv::Vec3b>(8, 8), brick) << name;
    EXPECT_EQ(image.at<cv::Vec3b>(7, 9), brick) << name;
  }
  const cv::Mat1b grey = seen("GGGG", brick);
  EXPECT_EQ(developed(grey, BayerTile::None).data, grey.data);
}

}  // namespace
}  // namespace handmap
