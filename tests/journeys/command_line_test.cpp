#include "app/gui/window/command_line.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace handmap {
namespace {

CommandLine parsed(const QStringList& arguments) {
  return parseCommandLine(QStringList{"handmap"} + arguments);
}

ErrorCode refusal(const QStringList& arguments) {
  try {
    parsed(arguments);
  } catch (const Error& error) {
    return error.code();
  }
  ADD_FAILURE() << "not refused: " << arguments.join(' ').toStdString();
  return {};
}

TEST(CommandLine, NothingIsAWindowWithNothing) {
  const CommandLine line = parsed({});
  EXPECT_TRUE(line.map.isEmpty());
  EXPECT_FALSE(line.run);
  EXPECT_FALSE(line.isBatch());
}

TEST(CommandLine, TakesEveryOption) {
  const CommandLine line = parsed({"m.handmap", "--recording", "r", "--from", "40", "--source",
                                   "points", "--seed", "7", "--run", "--exit-after-run"});
  EXPECT_EQ(line.map, "m.handmap");
  EXPECT_EQ(line.recording, "r");
  EXPECT_EQ(line.replay->from, 40);
  EXPECT_EQ(line.replay->kind, SourceKind::Points);
  EXPECT_EQ(line.seed, 7);
  EXPECT_TRUE(line.run);
  EXPECT_TRUE(line.isBatch());
}

TEST(CommandLine, AReportIsABatchAndRuns) {
  const CommandLine line = parsed({"--demo", "--offscreen-report", "out"});
  EXPECT_TRUE(line.isBatch());
  EXPECT_TRUE(line.run);
  EXPECT_EQ(line.report_folder, "out");
}

TEST(CommandLine, RefusesWhatCannotBe) {
  for (const QStringList& arguments : std::vector<QStringList>{{"a.handmap", "b.handmap"},
                                                               {"--from", "x"},
                                                               {"--from", "-1"},
                                                               {"--seed", "1e3"},
                                                               {"--source", "radar"},
                                                               {"--unheard-of"},
                                                               {"--run"},
                                                               {"--run", "--recording", "r"},
                                                               {"--demo", "m.handmap"}}) {
    EXPECT_EQ(refusal(arguments), ErrorCode::Usage);
  }
}

}  // namespace
}  // namespace handmap
