// The paper's experiments with few trials.
#include <algorithm>
#include <csignal>
#include <thread>

#include "tests/cli/program.h"

namespace handmap {
namespace {

namespace fs = std::filesystem;

class Evaluate : public CliTest {
 protected:
  /// At a σ that both methods master.
  static Outcome evaluate(const std::string& what, std::vector<std::string> more) {
    more.insert(more.begin(), {"evaluate", what, "--trials", "2", "--sigmas", "1",
                               "--slam-particles", "30", "--out", "trials"});
    return run(more);
  }

  static void expectReport(const Outcome& outcome, const std::string& title) {
    expectDone(outcome, contentOf("trials/report.md"));
    EXPECT_EQ(outcome.out.substr(0, title.size()), title);
  }
};

TEST_F(Evaluate, PrintsTheReportItWrites) {
  const Outcome outcome = evaluate("table2", {});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, contentOf(fs::path(HANDMAP_CLI_EXPECTED) / "evaluate-table2.txt"));
  EXPECT_EQ(contentOf("trials/report.md"), outcome.out);
  EXPECT_EQ(contentOf("trials/report.csv"),
            "sigma_m,method,trials,loose,loose_low,loose_high,strict,strict_low,strict_high\n"
            "1,handmap,2,2,0.3424,1.0000,2,0.3424,1.0000\n"
            "1,paper,2,2,0.3424,1.0000,2,0.3424,1.0000\n");
  EXPECT_TRUE(fs::exists("trials/table2-loose.png"));
  // The same trials make the other tables.
  const std::string trials = contentOf("trials/trials-1-of-1.csv");
  expectReport(evaluate("fig8", {"--merge"}), "# Figure 8");
  EXPECT_TRUE(fs::exists("trials/fig8-x.png"));
  EXPECT_TRUE(fs::exists("trials/fig8-front-1m.png"));
  expectReport(evaluate("way", {}), "# Errors over the way");
  EXPECT_TRUE(fs::exists("trials/way-pose-1m.png"));
  EXPECT_EQ(contentOf("trials/trials-1-of-1.csv"), trials);
}

TEST_F(Evaluate, TellsTheTimeOfAFrameBesideThePapers) {
  const Outcome outcome =
      run({"evaluate", "table1", "--trials", "1", "--threads", "1", "--out", "times"});
  expectDone(outcome, contentOf("times/report.md"));
  EXPECT_EQ(outcome.out.rfind("# Table 1: processing time of a frame", 0), 0U);
  const std::string csv = contentOf("times/report.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 8) << csv;  // six combinations and ours
  for (const char* row : {"\npaper,10,50,", "\npaper,20,150,", "\nhandmap,,,"}) {
    EXPECT_NE(csv.find(row), std::string::npos) << row;
  }
  for (const char* published : {"| 26 |", "| 46 |", "| 64 |", "| 50 |", "| 106 |", "| 126 |"}) {
    EXPECT_NE(outcome.out.find(published), std::string::npos) << published;
  }
  EXPECT_TRUE(fs::exists("times/table1.png"));
}

TEST_F(Evaluate, ComparesWhatWasStatedWithWhatIsSo) {
  ASSERT_EQ(run({"simulate", "--seed", "3", "--out", "real"}).status, 0);
  const Outcome outcome =
      run({"evaluate", "reliability", "--trials", "1", "--sigmas", "1", "--recording", "real",
           "--map", "real/sketch.handmap", "--truth", "real/truth.handmap", "--out", "stated"});
  expectDone(outcome, contentOf("stated/report.md"));
  const std::string csv = contentOf("stated/report.csv");
  EXPECT_EQ(csv.rfind("subject,runs,from,to,statements,stated,true,true_low,true_high\n", 0), 0U);
  for (const char* subject : {"\npose within 1 m,simulated,", "\npose within 5 m,real,",
                              "\nwall within its sigma,real,"}) {
    EXPECT_NE(csv.find(subject), std::string::npos) << subject << "\n" << csv;
  }
  EXPECT_NE(outcome.out.find("| real, sketch | pose within 1 m |"), std::string::npos);
  EXPECT_TRUE(fs::exists("stated/reliability-walls.png"));
}

TEST_F(Evaluate, MergesShards) {
  const std::string methods = "--methods=paper";
  const Outcome second = evaluate("table2", {methods, "--shard", "2/2", "--threads", "1"});
  EXPECT_EQ(second.out, "trials: shard 2/2 is done, 1 trials were run\n");
  EXPECT_NE(evaluate("table2", {methods, "--merge"}).out.find("**Not whole: 1 of 2"),
            std::string::npos);
  EXPECT_EQ(evaluate("table2", {methods, "--shard", "1/2"}).out,
            "trials: shard 1/2 is done, 1 trials were run\n");
  expectDone(evaluate("table2", {methods, "--shard", "1/2"}),
             "trials: shard 1/2 is done, 0 trials were run\n");
  expectReport(evaluate("table2", {methods, "--merge"}), "# Table 2");
  const std::string merged = contentOf("trials/report.md") + contentOf("trials/report.csv") +
                             contentOf("trials/table2-strict.png");
  fs::rename("trials", "shards");
  EXPECT_EQ(evaluate("table2", {methods}).status, 0);
  EXPECT_EQ(merged, contentOf("trials/report.md") + contentOf("trials/report.csv") +
                        contentOf("trials/table2-strict.png"));
}

TEST_F(Evaluate, RefusesOtherSettingsAndDamage) {
  EXPECT_EQ(evaluate("table2", {"--methods", "paper", "--shard", "1/2"}).status, 0);
  expectFailed(evaluate("table2", {"--merge", "--seed", "2"}), 2,
               "handmap-cli: error: trials/trials-1-of-2.csv: line 1: seed: found 1, expected 2\n"
               "hint: a folder holds trials of one setting: take the same, or another folder\n");
  replaceIn("trials/trials-1-of-2.csv", "paper,1,0,", "paper,1,zero,");
  expectFailed(evaluate("table2", {}), 2,
               "handmap-cli: error: trials/trials-1-of-2.csv: line 3: found \"zero\", expected a "
               "whole number from 0 to 2147483647\n");
  fs::remove("trials/trials-1-of-2.csv");
  expectFailed(evaluate("table2", {"--merge"}), 2,
               "handmap-cli: error: trials: found no trials, expected tables trials-*.csv\n");
}

TEST_F(Evaluate, TellsWrongUsage) {
  const auto refuses = [](const std::vector<std::string>& more, const std::string& reason) {
    std::vector<std::string> words = {"evaluate", "table2", "--out", "trials"};
    words.insert(words.end(), more.begin(), more.end());
    expectFailed(run(words), 1,
                 "handmap-cli: error: " + reason + "\nhint: handmap-cli evaluate --help\n");
  };
  for (const std::string shard : {"0/2", "3/2", "1", "1/2/3", "a/b", "1/100001"}) {
    refuses({"--shard", shard},
            "--shard: found " + shard + ", expected I/N with I from 1 to N, N up to 100000");
  }
  refuses({"--sigmas", "1,-5"},
          "--sigmas: found 1,-5, expected up to 20 numbers from 0.01 to 1000, as 1,5,12.5");
  refuses({"--methods", "ours"}, "--methods: found ours, expected handmap, paper or handmap,paper");
  refuses({"--merge", "--shard", "1/2"}, "--shard excludes --merge");
  expectFailed(run({"evaluate", "fig9", "--out", "trials"}), 1,
               "handmap-cli: error: found fig9, expected table1, table2, fig8, way or reliability\n"
               "hint: handmap-cli evaluate --help\n");
  expectFailed(run({"evaluate", "table2", "--recording", "real", "--map", "m", "--truth", "t",
                    "--out", "trials"}),
               1, "handmap-cli: error: --recording: only with reliability\n");
  expectFailed(run({"evaluate", "reliability", "--recording", "real", "--out", "trials"}), 1,
               "handmap-cli: error: found 1 --recording, 0 --map and 0 --truth, expected as many "
               "of each\n");
  expectFailed(run({"evaluate", "table1", "--merge", "--out", "trials"}), 1,
               "handmap-cli: error: --shard and --merge: only with table2, fig8 and way\n");
  EXPECT_FALSE(fs::exists("trials"));
  expectFailed(run({"evaluate", "fig8", "--out", "row-truth.handmap"}), 1,
               "handmap-cli: error: row-truth.handmap: found something there, expected a folder or "
               "nothing\n");
}

TEST_F(Evaluate, KeepsItsTrialsWhenInterrupted) {
  const pid_t program = start({"evaluate", "fig8", "--methods", "paper", "--trials", "1000",
                               "--slam-particles", "5", "--threads", "1", "--out", "trials"});
  const auto lines = [] {
    const std::string table = contentOf("trials/trials-1-of-1.csv");
    return std::count(table.begin(), table.end(), '\n');
  };
  for (int i = 0; i < 1000 && lines() < 4; ++i) {  // until two trials are done
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(kill(program, SIGINT), 0);
  const Outcome outcome = finish(program);
  EXPECT_EQ(outcome.status, 130);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("interrupted, " + std::to_string(lines() - 2) + " trials were run"),
            std::string::npos)
      << outcome.err;
  EXPECT_GE(lines(), 4);
  EXPECT_LT(lines(), 1002);
  EXPECT_FALSE(fs::exists("trials/report.md"));
}

}  // namespace
}  // namespace handmap
