// Runs the real handmap-cli in a folder of its own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/types.h>

#include "tests/core/base/temporary_folder.h"

namespace handmap {

struct Outcome {
  int status = -1;  ///< exit status; -1 where a signal ended the program
  std::string out;
  std::string err;
};

/// The text of a file, empty where there is none.
std::string contentOf(const std::filesystem::path& path);
void writeText(const std::filesystem::path& path, const std::string& text);
/// Replaces the first occurrence of `from`, which must be there.
void replaceIn(const std::filesystem::path& path, const std::string& from, const std::string& to);

/// The working folder is a fresh one with the maps of tests/data in it.
class CliTest : public testing::Test {
 protected:
  CliTest();
  ~CliTest() override;

  /// Not waited for; its outputs go to the files "stdout" and "stderr".
  static pid_t start(const std::vector<std::string>& arguments);
  static Outcome finish(pid_t program);
  static Outcome run(const std::vector<std::string>& arguments) { return finish(start(arguments)); }

 private:
  std::filesystem::path before_;
  test::TemporaryFolder folder_;
};

/// stderr without the progress that a slow machine sees.
std::string complaints(const std::string& err);
/// Done, with this on stdout and no complaints.
void expectDone(const Outcome& outcome, const std::string& out);
/// Failed with this status, saying this on stderr, and nothing on stdout.
void expectFailed(const Outcome& outcome, int status, const std::string& err);

}  // namespace handmap
