#include "widgets/run/words/words.h"

#include <gtest/gtest.h>

#include "core/map/certainty.h"
#include "core/map/map_changes.h"

namespace handmap {
namespace {

FrameReport report(double sigma_m, double heading_sigma_deg) {
  FrameReport report;
  report.pose_sigma = {sigma_m, sigma_m, toRadians(heading_sigma_deg)};
  return report;
}

TEST(Words, SayHowSureThePoseIs) {
  // Of a round Gaussian nine tenths are within 2.146 σ; of a heading within 1.645.
  EXPECT_EQ(Words::certainty(report(0.14, 0.5)), "Sure to 0.3 m; heading to 1°");
  EXPECT_EQ(Words::certainty(report(1.4, 2.0)), "Roughly here: within 3.0 m; heading to 4°");
  EXPECT_EQ(Words::certainty(report(10.0, 2.0)), "Lost: may be anywhere within 21 m");
  EXPECT_EQ(certaintyOf(report(0.1, 20.0)).kind, Certainty::Rough) << "the heading is not sure";
  EXPECT_EQ(certaintyOf(report(0.1, 90.0)).kind, Certainty::Lost) << "there is none";
}

TEST(Words, SayWhereNothingOfTheDrawingIsRecognised) {
  FrameReport astray = report(0.14, 0.5);
  astray.unrecognised_m = 49.0;
  EXPECT_EQ(Words::certainty(astray), "Sure to 0.3 m; heading to 1°");
  astray.unrecognised_m = 107.0;
  EXPECT_EQ(Words::certainty(astray),
            "Unsure: nothing of the drawing recognised for 107 m; if it was right before, within "
            "0.3 m");
  EXPECT_EQ(certaintyOf(astray).kind, Certainty::Rough);
  astray = report(10.0, 2.0);
  astray.unrecognised_m = 200.0;
  EXPECT_EQ(Words::certainty(astray),
            "Lost: may be anywhere within 21 m; nothing of the drawing recognised for 200 m");
}

TEST(Words, ALongEllipseIsAsWideAsItIsLong) {
  FrameReport along = report(1.0, 1.0);
  along.pose_xy = 0.999;  // on a diagonal: √2 m along, nothing across
  EXPECT_NEAR(certaintyOf(along).within_m, 1.645 * std::sqrt(2.0), 0.02);
}

Building building(const char* id, double x, int observations) {
  Building building;
  building.id = id;
  building.shape = Rectangle{{x, 0.0}, 10.0, 10.0, 0.0};
  building.estimate = Estimate{0.1, 0.1, 0.1, observations};
  return building;
}

TEST(Words, SayWhatTheRobotIsBeside) {
  Map map;
  map.buildings = {building("N1", 0.0, 1), building("N2", 30.0, 1)};
  map.buildings[1].name = "Library";
  EXPECT_EQ(Words::place({21.0, 0.0, 0.0}, map), "4.0 m from N2 · Library");
  EXPECT_EQ(Words::place({500.0, -7.0, 0.0}, map), "at x 500 m, y -7 m");
  EXPECT_EQ(Words::place({0.0, 0.0, 0.0}, {}), "at x 0 m, y 0 m");
}

TEST(Words, SumUpWhatARunHasChanged) {
  Map drawing;
  Map refined;
  for (int i = 0; i < 9; ++i) {
    const std::string id = "L" + std::to_string(i);
    drawing.buildings.push_back(building(id.c_str(), 0.0, 0));
    refined.buildings.push_back(building(id.c_str(), 0.3 + 0.5 * i, i < 8 ? 3 : 0));
  }
  EXPECT_EQ(Words::changes(changesOf(drawing, refined), drawing),
            "8 building(s) moved by 0.3 to 3.8 m, 1 was (were) not recognised.");
  setDoubt(refined.buildings[3], 0.6);
  setDoubt(refined.buildings[5], 0.7);
  const QString with_doubt = Words::changes(changesOf(drawing, refined), drawing);
  EXPECT_TRUE(with_doubt.endsWith("2 is (are) doubtful: look at L5, L3."))
      << with_doubt.toStdString();
  for (Building& doubtful : refined.buildings) setDoubt(doubtful, 0.5);
  EXPECT_TRUE(Words::changes(changesOf(drawing, refined), drawing).endsWith("L0, L1, L2, L3, …."));
}

Map mapOf(const Building& building) {
  Map map;
  map.uncertainty = {3.0, 1.0};
  map.buildings = {building};
  return map;
}

TEST(Words, SayWhatSpeaksForAndAgainstABuilding) {
  const Map drawing = mapOf(building("L3", 0.0, 0));
  Map refined = mapOf(building("L3", 7.0, 12));
  setSides(refined.buildings[0], {{{0.1, true}, {0.2, true}, {3.0, false}, {0.2, true}}});
  const TrueMiddles middles(mapOf(building("L3", 7.5, 0)));
  const QString words = Words::building(drawing, refined, 0, &middles);
  for (const char* said : {"moved by 7.0 m", "0.5 m from where it truly is", "seen in 12",
                           "right ±0.10 m", "nobody saw: left", "2.3 times"}) {
    EXPECT_TRUE(words.contains(said)) << said << " in " << words.toStdString();
  }
  EXPECT_FALSE(words.contains("Doubtful"));
  EXPECT_TRUE(Words::building(drawing, mapOf(building("L3", 0.0, 0)), 0, nullptr)
                  .contains("Not recognised"));
}

TEST(Words, TurnedAndGrownAreToldLikeMoved) {
  const Map drawing = mapOf(building("L3", 0.0, 0));
  Map refined = mapOf(building("L3", 1.1, 12));
  refined.buildings[0].shape = Rectangle{{1.1, 0.0}, 19.0, 10.0, toRadians(20.0)};
  EXPECT_EQ(Words::change(changeOf(drawing.buildings[0], refined.buildings[0])),
            "moved by 1.1 m, turned by 20°, grown by 9.0 m");
  const QString summary = Words::changes(changesOf(drawing, refined), drawing);
  EXPECT_TRUE(summary.contains("1 turned by up to 20°")) << summary.toStdString();
  EXPECT_TRUE(summary.contains("1 grown or shrunk by up to 9.0 m")) << summary.toStdString();
}

TEST(Words, NameThoseOfWhichOneSideWasSeen) {
  const Map drawing = mapOf(building("L3", 0.0, 0));
  Map refined = mapOf(building("L3", 1.0, 12));
  setSides(refined.buildings[0], {{{0.1, false}, {0.2, true}, {3.0, false}, {0.2, false}}});
  EXPECT_TRUE(Words::changes(changesOf(drawing, refined), drawing)
                  .contains("Of 1 (L3) only one side was seen"));
  EXPECT_TRUE(Words::building(drawing, refined, 0, nullptr).contains("Only one side was seen"));
}

/// One sentence, with its reason, and nothing beside it that says the contrary.
TEST(Words, ADoubtIsOneSentence) {
  const Map drawing = mapOf(building("L3", 0.0, 0));
  Map unmet = mapOf(building("L3", 0.3, 0));
  setDoubt(unmet.buildings[0], 0.4);
  const QString words = Words::building(drawing, unmet, 0, nullptr);
  EXPECT_TRUE(
      words.contains("did not recognise it. Of 100 buildings with such signs about 40 were wrong."))
      << words.toStdString();
  EXPECT_FALSE(words.contains("Against the drawing"));
  EXPECT_FALSE(words.contains('%'));
  const Map kept = mapOf(building("L3", 0.3, 4));
  EXPECT_TRUE(Words::doubt(drawing, kept, 0, concernsOf(drawing, kept)).isEmpty());
}

TEST(Words, DirectionsAreThoseOfAMapWithYUp) {
  EXPECT_EQ(Words::direction(0.0), "right");
  EXPECT_EQ(Words::direction(kPi / 2.0), "upper");
  EXPECT_EQ(Words::direction(-3.0 * kPi / 4.0), "lower left");
  EXPECT_EQ(Words::direction(-kPi), "left");
}

}  // namespace
}  // namespace handmap
