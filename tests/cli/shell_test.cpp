// What a shell and man(1) are told of the program: completion in a real bash, and the page.
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <set>

#include <fmt/format.h>

#include "tests/cli/program.h"

namespace handmap {
namespace {

namespace fs = std::filesystem;

const fs::path kResources = fs::path(HANDMAP_SOURCES) / "resources";

std::set<std::string> wordsIn(const std::string& text, const std::string& pattern) {
  std::set<std::string> words;
  const std::regex expression(pattern, std::regex::multiline);
  for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at) {
    words.insert((*at)[1]);
  }
  return words;
}

class ShellTest : public CliTest {
 protected:
  static std::set<std::string> commands() {
    const std::string help = run({"--help"}).out;
    return wordsIn(help.substr(help.find("Subcommands:")), "^  ([a-z-]+) ");
  }
  static std::set<std::string> optionsOf(const std::string& command) {
    return wordsIn(run({command, "--help"}).out, "^  (?:-[a-z],)?(--[a-z-]+)");
  }
  /// What commands of bash print on either stream.
  static std::string printed(const std::string& script) {
    writeText("lines.bash", script);
    EXPECT_NE(std::system("bash lines.bash > printed 2>&1"), -1);
    return contentOf("printed");
  }
};

/// `handmap-cli` on the path of a shell is one that tells what it is called with, but helps as the
/// real one.
class Completion : public ShellTest {
 protected:
  Completion() {
    fs::create_directory("bin");
    writeText("bin/handmap-cli",
              "#!/bin/sh\ncase \" $* \" in *' --help '*) exec '" HANDMAP_CLI
              "' \"$@\" ;; esac\nfor word; do printf '<%s>' \"$word\"; done >> called\necho >> "
              "called\n");
    fs::permissions("bin/handmap-cli", fs::perms::owner_all);
  }

  /// What is offered for the last of these words.
  static std::set<std::string> offered(const std::vector<std::string>& words) {
    std::string line = "COMP_WORDS=(";
    for (const std::string& word : words) line += "'" + word + "' ";
    const std::string script = "PATH=$PWD/bin:$PATH; compopt() { :; }; . '" +
                               (kResources / "completions/handmap-cli.bash").string() + "'; " +
                               line + "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _handmap_cli " +
                               words.front() + "; printf \"%s\\n\" \"${COMPREPLY[@]}\"";
    return wordsIn(printed(script), "^(.+)$");
  }

  /// What the program is called with after this was typed into bash, each line with Return.
  static std::string typed(const std::string& keys) {
    writeText("bashrc", "PATH=$PWD/bin:$PATH\nHISTFILE=\nbind 'set bell-style none'\n. '" +
                            (kResources / "completions/handmap-cli.bash").string() + "'\n");
    writeText("keys", keys + "exit\n");
    printed("script -qec 'bash --noprofile --rcfile bashrc -i' /dev/null < keys");
    return contentOf("called");
  }
};

TEST_F(Completion, OffersEveryCommandAndOption) {
  std::set<std::string> expected = commands();
  EXPECT_GE(expected.size(), 19U);
  expected.insert({"--help", "--version"});
  EXPECT_EQ(offered({"handmap-cli", ""}), expected);
  for (const std::string& command : commands()) {
    EXPECT_EQ(offered({"handmap-cli", command, "--"}), optionsOf(command)) << command;
  }
}

TEST_F(Completion, OffersTheValuesThatAreTold) {
  using Words = std::set<std::string>;
  EXPECT_EQ(offered({"handmap-cli", "run", "--source", ""}), (Words{"auto", "images", "points"}));
  EXPECT_EQ(offered({"handmap-cli", "run", "--source", "=", "p"}), Words{"points"});
  EXPECT_EQ(offered({"handmap-cli", "run", "--source", "="}), (Words{"auto", "images", "points"}));
  EXPECT_EQ(offered({"handmap-cli", "run", "--virtual-rig", ""}), (Words{"camera", "laser"}));
  EXPECT_EQ(offered({"handmap-cli", "run", "--odometry", "s"}), Words{"scan"});
  EXPECT_EQ(offered({"handmap-cli", "evaluate", "ta"}), (Words{"table1", "table2"}));
  EXPECT_EQ(offered({"handmap-cli", "report", "--language", "j"}), Words{"ja"});
}

TEST_F(Completion, OfFilesInARealBash) {
  if (printed("script --version").find("util-linux") == std::string::npos) {
    GTEST_SKIP() << "no script";
  }
  fs::create_directory("my place");
  fs::create_directory("my place/recording");
  writeText("my place/own way.tum", "");
  writeText("my place/recalled.txt", "");
  EXPECT_EQ(typed("handmap-cli val\tmy\town\t\n"
                  "handmap-cli run --record my\tr\t --odometry vis\t\n"
                  "handmap-cli run --odometry my\tow\t\n"
                  "handmap-cli sket\t row-tr\t\n"),
            "<validate><my place/own way.tum>\n"
            "<run><--record>"
            "<my place/recording/><--odometry><visual>\n"
            "<run><--odometry><my place/own way.tum>\n"
            "<sketch-stats><row-truth.handmap>\n");
}

TEST_F(ShellTest, AnImportAsksAtATerminalForWhatItCannotSee) {
  if (printed("script --version").find("util-linux") == std::string::npos) {
    GTEST_SKIP() << "no script";
  }
  std::string table;
  for (int i = 0; i < 30; ++i) table += fmt::format("{},{},{}\n", 0.1 * (i / 10), 3 + i, 2 - i);
  writeText("odd.csv", table);
  writeText("answers", "time=1,x=2,y=3\n");
  const std::string said =
      printed("script -qec '" HANDMAP_CLI " import odd.csv --out rec' /dev/null < answers");
  EXPECT_NE(said.find("expected to know which hold what"), std::string::npos) << said;
  EXPECT_NE(said.find("rec: recording of "), std::string::npos) << said;
  EXPECT_EQ(run({"validate", "rec"}).status, 0);
}

class ManPage : public ShellTest {
 protected:
  void SetUp() override {
    if (printed("groff --version").find("GNU") == std::string::npos) GTEST_SKIP() << "no groff";
    printed("'" + (kResources / "man/options.sh").string() + "' '" HANDMAP_CLI "' < '" +
            (kResources / "man/handmap-cli.1.in").string() + "' > handmap-cli.1");
    page_ = printed("groff -man -K utf8 -T utf8 -P -cbou -r LL=2000n handmap-cli.1");
  }

  /// From a heading to the next one of its kind.
  std::string under(const std::string& heading, const std::string& indent = "") const {
    const std::size_t begin = page_.find("\n" + indent + heading + "\n");
    if (begin == std::string::npos) return {};
    const std::size_t first = page_.find('\n', begin + 1);
    std::smatch next;
    const std::string rest = page_.substr(first);
    std::regex_search(rest, next, std::regex("\n" + indent + "[A-Za-z]"));
    return rest.substr(0, static_cast<std::size_t>(next.position()));
  }

  std::string page_;  ///< as it is read, each paragraph on one line
};

TEST_F(ManPage, IsCleanAndTellsEveryCommandAndOption) {
  EXPECT_EQ(printed("groff -man -K utf8 -ww -z handmap-cli.1"), "");
  EXPECT_EQ(wordsIn(under("COMMANDS"), "^       ([a-z-]+)(?:$| )"), commands());
  for (const std::string& command : commands()) {
    std::set<std::string> told = wordsIn(under(command, "   "), "^       (--[a-z-]+)");
    told.insert("--help");
    EXPECT_EQ(told, optionsOf(command)) << command;
  }
  EXPECT_EQ(wordsIn(under("EXIT STATUS"), "^       (\\d+)"),
            wordsIn(run({"--help"}).out, "(?:status: |, )(\\d+) "));
}

TEST_F(ManPage, ItsExamplesAreOfThisProgram) {
  const std::string examples = under("EXAMPLES");
  const std::regex line("handmap-cli ([a-z-]+)(.*)");
  int count = 0;
  for (std::sregex_iterator at(examples.begin(), examples.end(), line), end; at != end; ++at) {
    ++count;
    const std::set<std::string> known = optionsOf((*at)[1]);
    for (const std::string& option : wordsIn((*at)[2], " (--[a-z-]+)")) {
      EXPECT_TRUE(known.contains(option)) << at->str();
    }
  }
  EXPECT_GE(count, 10);
  const std::size_t first = examples.find("handmap-cli");
  const std::string said =
      printed("set -e\nhandmap-cli() { '" HANDMAP_CLI "' \"$@\"; }\n" +
              examples.substr(first, examples.find("\n\n", first) - first) + "\necho done");
  EXPECT_TRUE(said.ends_with("\ndone\n")) << said;
}

}  // namespace
}  // namespace handmap
