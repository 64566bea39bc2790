#include "core/experiments/trial_table.h"

#include <gtest/gtest.h>

#include "core/base/text.h"
#include "tests/core/base/comma_locale.h"
#include "tests/core/base/expect_error.h"
#include "tests/core/experiments/made_trial.h"

namespace handmap {
namespace {

using test::expectBadInput;
using test::madeTrial;

const Trial kTrial = madeTrial({Method::Paper, 12.5, 7}, 0.75);

std::string table() { return trialTableHead({}) + trialLine(kTrial); }

std::vector<Trial> parse(const std::string& text) { return parseTrials(text, "t.csv", {}); }

std::string replaced(const std::string& from, const std::string& to) {
  std::string text = table();
  const std::size_t place = text.rfind(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

TEST(TrialTable, ReadsWhatItWrites) {
  const test::CommaLocale comma;
  const std::vector<Trial> trials = parse(table());
  ASSERT_EQ(trials.size(), 1U);
  EXPECT_EQ(trials[0].key, kTrial.key);
  EXPECT_EQ(trials[0].buildings[5].drawn, kTrial.buildings[5].drawn);
  EXPECT_EQ(trials[0].buildings[5].found, kTrial.buildings[5].found);
  EXPECT_EQ(trials[0].buildings[0].iou, 0.75);
  EXPECT_TRUE(trials[0].buildings[0].overlaps);
  ASSERT_EQ(trials[0].way.size(), 3U);
  EXPECT_EQ(trials[0].way[2].odometry, 1.0);
  EXPECT_EQ(trialLine(trials[0]), trialLine(kTrial));
}

TEST(TrialTable, RoundsNoFailureToASuccess) {
  const Trial trial = madeTrial({Method::Handmap, 1.0, 0}, 0.49999);
  const Trial read = parse(trialTableHead({}) + trialLine(trial)).at(0);
  EXPECT_TRUE(read.loose());
  EXPECT_FALSE(read.strict());
}

TEST(TrialTable, LeavesOutALineThatWasNotFinished) {
  const std::string whole = table();
  const std::string head = trialTableHead({});
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_TRUE(parse(whole.substr(0, length)).empty()) << length;
  }
  EXPECT_EQ(parse(whole + whole.substr(head.size(), 40)).size(), 1U);
}

TEST(TrialTable, RefusesOtherSettings) {
  TrialSettings settings;
  settings.seed = 2;
  expectBadInput([&] { parseTrials(table(), "t.csv", settings); },
                 {"t.csv: line 1: seed: found 1, expected 2", "another folder"});
  settings = {};
  settings.slam_particles = 50;
  expectBadInput([&] { parseTrials(table(), "t.csv", settings); },
                 {"slam_particles: found 100, expected 50"});
  settings = {};
  settings.keeping = Keeping::Nothing;
  expectBadInput([&] { parseTrials(table(), "t.csv", settings); },
                 {"drawings_keep_side_and_order: found true, expected false"});
}

TEST(TrialTable, RefusesADamagedOne) {
  expectBadInput([] { parse(replaced("paper,", "pape,")); },
                 {"t.csv: line 3: found \"pape\", expected handmap or paper"});
  expectBadInput([] { parse(replaced(",12.5,7,", ",12.5,")); }, {"line 3: found 51 fields", "52"});
  expectBadInput([] { parse(replaced("paper,", "\xff\xfe,")); }, {"t.csv: line 3: found"});
  expectBadInput([] { parse(replaced(",7,", ",-7,")); }, {"line 3", "whole number"});
  expectBadInput([] { parse(replaced(",7,", ",1e99,")); }, {"line 3", "whole number"});
  expectBadInput([] { parse(replaced("0.75,1", "nan,1")); }, {"line 3", "nan", "from 0 to 1"});
  expectBadInput([] { parse(replaced("0.75,1", "0.75,2")); },
                 {"line 3", "whole number from 0 to 1"});
  expectBadInput([] { parse(replaced(" 12\n", "\n")); }, {"line 3: found 8 numbers of the way"});
  expectBadInput([] { parse(replaced(" 12\n", " -1\n")); }, {"line 3", "\"-1\""});
  expectBadInput([] { parse(replaced("N1_iou", "N1_uoi")); }, {"line 2: found other columns"});
  expectBadInput([] { parse(replaced("# ", "")); }, {"line 1: found no settings"});
  expectBadInput([] { parse(replaced("\"seed\":1", "\"seed\":")); }, {"t.csv: line 1"});
  expectBadInput([] { parse(replaced("\"seed\":1,", "")); }, {"t.csv: line 1", "seed"});
}

}  // namespace
}  // namespace handmap
