#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/map/map_io.h"

namespace handmap {
namespace {

Map parsed(const std::string& member) {
  return parseMap(R"({"format":"handmap","version":1,"buildings":[],)"
                  R"("start":{"x":1,"y":2,"heading_deg":90},)"
                  R"("handmap:start_uncertainty":)" +
                      member + "}",
                  "yard.handmap");
}

TEST(StartUncertainty, IsReadFromItsMember) {
  const Map map = parsed(R"({"position_m":2.5,"heading_deg":20})");
  const auto uncertainty = map.start_uncertainty;
  ASSERT_TRUE(uncertainty);
  EXPECT_DOUBLE_EQ(uncertainty->position, 2.5);
  EXPECT_DOUBLE_EQ(toDegrees(uncertainty->heading), 20.0);
}

TEST(StartUncertainty, MayBeAbsentAndBeTakenAway) {
  EXPECT_FALSE(Map().start_uncertainty);
  Map map = parsed(R"({"position_m":2.5,"heading_deg":20})");
  map.start_uncertainty.reset();
  EXPECT_EQ(formatMap(map).find("start_uncertainty"), std::string::npos);
}

TEST(StartUncertainty, SurvivesTheFile) {
  Map map;
  map.start = Pose2{1.0, 2.0, 0.0};
  map.start_uncertainty = StartUncertainty{1.25, toRadians(12.5)};
  const Map again = parseMap(formatMap(map), "again");
  EXPECT_EQ(again, map);
  EXPECT_NEAR(again.start_uncertainty->heading, toRadians(12.5), 1e-12);
}

TEST(StartUncertainty, OfNonsenseTheFileAndThePlaceAreTold) {
  for (const char* member :
       {R"(7)", R"({"position_m":"near"})", R"({"position_m":-1})", R"({"heading_deg":400})"}) {
    try {
      parsed(member);
      ADD_FAILURE() << member;
    } catch (const Error& error) {
      const std::string text = error.what();
      EXPECT_NE(text.find("yard.handmap: handmap:start_uncertainty"), std::string::npos) << text;
      EXPECT_NE(text.find("expected"), std::string::npos) << text;
    }
  }
}

}  // namespace
}  // namespace handmap
