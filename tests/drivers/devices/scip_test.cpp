#include "drivers/scanner/scip.h"

#include <cmath>

#include <gtest/gtest.h>

namespace handmap {
namespace {

// The examples of Hokuyo's specification of the encoding: 1234 in two characters, 5432 in three,
// 16000000 in four.
TEST(Scip, NumbersAreEncodedAsInTheSpecification) {
  EXPECT_EQ(scipEncode(1234, 2), "CB");
  EXPECT_EQ(scipEncode(5432, 3), "1Dh");
  EXPECT_EQ(scipEncode(16'000'000, 4), "m2@0");
  for (const std::uint32_t value : {0U, 1U, 63U, 64U, 5432U, 262'143U}) {
    EXPECT_EQ(scipDecode(scipEncode(value, 3)), value);
  }
  EXPECT_EQ(scipDecode("0 0"), std::nullopt);
  EXPECT_EQ(scipDecode("0p0"), std::nullopt);
}

std::string summed(const std::string& text) { return text + scipSum(text); }

std::optional<ScipAnswer> answerOf(ScipReader& reader, const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    if (const auto answer = reader.take(line)) return answer;
  }
  return std::nullopt;
}

const std::vector<std::string> kParameters = {"MODL:x", "DMIN:23",   "DMAX:60000", "ARES:1440",
                                              "AMIN:0", "AMAX:1080", "AFRT:540",   "SCAN:2400"};

// Firmwares differ in whether the semicolon counts.
TEST(Scip, ParametersAreReadWithEitherWayToSum) {
  for (const bool with_semicolon : {false, true}) {
    ScipReader reader;
    std::vector<std::string> lines = {"PP", summed("00")};
    for (const std::string& text : kParameters) {
      lines.push_back(text + ';' + scipSum(with_semicolon ? text + ';' : text));
    }
    lines.emplace_back();
    const auto answer = answerOf(reader, lines);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->echo, "PP");
    EXPECT_EQ(answer->status, "00");
    const auto parameters = parseScipParameters(*answer);
    ASSERT_TRUE(parameters);
    EXPECT_EQ(parameters->least_mm, 23);
    EXPECT_EQ(parameters->front_step, 540);
    EXPECT_NEAR(parameters->scanTime_s(), 0.01875, 1e-9);
  }
}

TEST(Scip, ParametersThatCannotBeAreRefused) {
  for (const char* wrong : {"AMAX:0", "ARES:0", "DMAX:20", "SCAN:nan", "AMAX:99999"}) {
    auto changed = kParameters;
    for (auto& line : changed) {
      if (line.substr(0, 5) == std::string(wrong).substr(0, 5)) line = wrong;
    }
    EXPECT_FALSE(parseScipParameters({"PP", "00", changed})) << wrong;
  }
  EXPECT_FALSE(parseScipParameters({"PP", "00", {kParameters.begin() + 1, kParameters.end() - 1}}));
}

TEST(Scip, DamagedAnswersAreDroppedAndTheNextIsRead) {
  ScipReader reader;
  const std::vector<std::string> good = {"MD", summed("99"), summed("m2@0"), summed("1Dh1Dh"), ""};
  for (std::size_t line = 1; line < 4; ++line) {
    for (std::size_t at = 0; at < good[line].size(); ++at) {
      auto bad = good;
      bad[line][at] = static_cast<char>(bad[line][at] ^ 1);
      EXPECT_FALSE(answerOf(reader, bad)) << line << " " << at;
    }
  }
  EXPECT_EQ(reader.damaged(), 3 + 5 + 7);
  EXPECT_TRUE(answerOf(reader, good));
}

TEST(Scip, AnAnswerWithoutEndTakesNoMemory) {
  ScipReader reader;
  for (int i = 0; i < 100'000; ++i) reader.take(summed("1Dh"));
  EXPECT_FALSE(reader.take(""));
  EXPECT_EQ(reader.damaged(), 1);
}

TEST(Scip, ScansBecomePointsWithoutTheCodesOfErrors) {
  ScipParameters parameters;
  parameters.least_mm = 20;
  parameters.most_mm = 4000;
  parameters.steps_a_turn = 8;
  parameters.first_step = 2;
  parameters.last_step = 6;
  parameters.front_step = 4;
  const std::string data = scipEncode(1000, 3) + scipEncode(0, 3) + scipEncode(2000, 3) +
                           scipEncode(4001, 3) + scipEncode(3000, 3);
  const ScipAnswer answer{"MD", "99", {scipEncode(77, 4), data.substr(0, 7), data.substr(7)}};
  const auto scan = parseScipScan(answer, parameters);
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->stamp_ms, 77U);
  const auto points = scipPoints(*scan, parameters);
  ASSERT_EQ(points.size(), 3U);
  EXPECT_NEAR(points[0].y, -1.0F, 1e-6F);  // a quarter to the right
  EXPECT_NEAR(points[1].x, 2.0F, 1e-6F);   // ahead
  EXPECT_NEAR(points[2].y, 3.0F, 1e-6F);   // a quarter to the left
  EXPECT_EQ(points[2].w, 1.0F);
  ScipScan coded = *scan;
  coded.ranges_mm[1] = 6;
  const auto with_code = scipPoints(coded, parameters);
  ASSERT_EQ(with_code.size(), 4U);
  EXPECT_FALSE(isMeasured(with_code[1])) << "not that nothing came back";
  EXPECT_NEAR(std::atan2(with_code[1].y, with_code[1].x), -kPi / 4.0, 1e-6);
  ScipAnswer cut = answer;
  cut.lines.back().pop_back();
  EXPECT_FALSE(parseScipScan(cut, parameters));
}

TEST(Scip, StampsGoOnWhenTheyBeginAnew) {
  ScipClock clock;
  EXPECT_EQ(clock.seconds(0xfffff0), 0.0);
  EXPECT_NEAR(clock.seconds(0x000010), 0.032, 1e-9);
  EXPECT_NEAR(clock.seconds(0x00000f), 0.031, 1e-9);
  double last = 0.0;
  for (int i = 0; i < 3'000'000; ++i) {  // 20 h of 25 ms
    last = clock.seconds(static_cast<std::uint32_t>((0x10 + 25LL * i) & 0xffffff));
  }
  EXPECT_NEAR(last, 0.032 + 25e-3 * 2'999'999, 1e-3);
}

}  // namespace
}  // namespace handmap
