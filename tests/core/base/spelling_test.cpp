#include "core/base/spelling.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

TEST(Spelling, TheNearestIsMeant) {
  const std::vector<std::string_view> known{"run", "range_limit_m", "camera", "rectified"};
  EXPECT_EQ(likelyMeant("runn", known), "run");
  EXPECT_EQ(likelyMeant("range_limit", known), "range_limit_m");
  EXPECT_EQ(likelyMeant("camrea", known), "camera");
  EXPECT_EQ(likelyMeant("Rectified", known), "rectified");
  EXPECT_EQ(likelyMeant("licence", known), std::nullopt);
  EXPECT_EQ(likelyMeant("fly", known), std::nullopt);
}

}  // namespace
}  // namespace handmap
