#include "widgets/run/panels/why_panel.h"

#include <QComboBox>
#include <QTableWidget>

#include <gtest/gtest.h>

namespace handmap {
namespace {

Map twoBuildings() {
  Map map;
  for (const char* id : {"N1", "N2"}) {
    Building building;
    building.id = id;
    building.shape = Rectangle{{0.0, 0.0}, 20.0, 10.0, 0.0};
    building.estimate = Estimate{0.1, 0.1, 0.1, 3};
    map.buildings.push_back(building);
  }
  return map;
}

WallStory story() {
  WallStory story;
  story.sigma_m = 0.2;
  story.seen = true;
  story.tolerance_m = 0.5;
  story.drawn_m = -2.0;
  story.drawn_sigma_m = 3.0;
  story.drawn_share = 0.1;
  for (const double time_s : {4.0, 7.5}) {
    WallWitness witness;
    witness.time_s = time_s;
    witness.returns.resize(3);
    witness.share = 0.45;
    witness.pull_m = 0.9;
    story.witnesses.push_back(witness);
  }
  story.rays = 6;
  return story;
}

TEST(WhyPanel, AsksAboutTheWallThatIsChosen) {
  WhyPanel panel;
  std::vector<std::pair<std::size_t, std::size_t>> asked;
  QObject::connect(
      &panel, &WhyPanel::wallAsked, &panel,
      [&asked](std::size_t building, std::size_t wall) { asked.emplace_back(building, wall); });
  panel.setMap(twoBuildings());
  EXPECT_FALSE(panel.asked());
  EXPECT_TRUE(asked.empty());
  panel.ask(1, 2);
  ASSERT_EQ(asked.size(), 1U);
  EXPECT_EQ(asked.back(), std::pair(std::size_t{1}, std::size_t{2}));
  const auto combos = panel.findChildren<QComboBox*>();
  combos[1]->setCurrentIndex(0);
  EXPECT_EQ(asked.back(), std::pair(std::size_t{1}, std::size_t{0}));
  combos[0]->setCurrentIndex(0);
  EXPECT_EQ(asked.back().first, 0U);
  const std::size_t before = asked.size();
  panel.setMap(twoBuildings());  // of the next observation
  EXPECT_EQ(asked.size(), before);
  EXPECT_EQ(panel.asked()->building, 0U);
}

TEST(WhyPanel, SaysWhatPlacedTheWall) {
  WhyPanel panel;
  panel.setMap(twoBuildings());
  panel.ask(0, 0);
  panel.setStory(story(), true);
  for (const char* said : {"2.00 m outwards", "±0.20 m", "weight 10.0 %", "6 rays", "0.5 m"}) {
    EXPECT_TRUE(panel.words().contains(said)) << said << " in " << panel.words().toStdString();
  }
  EXPECT_EQ(panel.findChild<QTableWidget*>()->rowCount(), 2);
  panel.setStory({}, true);
  EXPECT_TRUE(panel.words().contains("No ray ended"));
  panel.setStory({}, false);
  EXPECT_TRUE(panel.words().contains("not kept"));
  EXPECT_EQ(panel.findChild<QTableWidget*>()->rowCount(), 0);
}

TEST(WhyPanel, AnObservationLeadsToItsTime) {
  WhyPanel panel;
  panel.setMap(twoBuildings());
  panel.ask(0, 0);
  panel.setStory(story(), true);
  double time_s = 0.0;
  std::optional<std::size_t> witness;
  QObject::connect(&panel, &WhyPanel::timeChosen, &panel, [&](double at) { time_s = at; });
  QObject::connect(&panel, &WhyPanel::witnessChosen, &panel,
                   [&](std::optional<std::size_t> which) { witness = which; });
  auto* table = panel.findChild<QTableWidget*>();
  table->setCurrentCell(1, 0);
  EXPECT_EQ(witness, 1U);
  Q_EMIT table->cellActivated(1, 0);
  EXPECT_EQ(time_s, 7.5);
  panel.clear();
  EXPECT_EQ(table->rowCount(), 0);
}

}  // namespace
}  // namespace handmap
