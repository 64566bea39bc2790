#include "tests/cli/program.h"

#include <fstream>
#include <iterator>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace handmap {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void writeText(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

void replaceIn(const fs::path& path, const std::string& from, const std::string& to) {
  std::string text = contentOf(path);
  const auto place = text.find(from);
  ASSERT_NE(place, std::string::npos) << from << " is not in " << path;
  writeText(path, text.replace(place, from.size(), to));
}

CliTest::CliTest() : before_(fs::current_path()) {
  for (const auto& entry : fs::directory_iterator(HANDMAP_TEST_DATA)) {
    if (entry.path().extension() == ".handmap") fs::copy(entry.path(), folder_.path());
  }
  fs::current_path(folder_.path());
}

CliTest::~CliTest() { fs::current_path(before_); }

pid_t CliTest::start(const std::vector<std::string>& arguments) {
  std::vector<std::string> words = arguments;
  words.insert(words.begin(), HANDMAP_CLI);
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  constexpr int kWrite = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "stdout", kWrite, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "stderr", kWrite, 0600);
  pid_t program = 0;
  EXPECT_EQ(posix_spawn(&program, HANDMAP_CLI, &actions, nullptr, argv.data(), environ), 0);
  posix_spawn_file_actions_destroy(&actions);
  return program;
}

Outcome CliTest::finish(pid_t program) {
  int status = 0;
  waitpid(program, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contentOf("stdout"), contentOf("stderr")};
}

std::string complaints(const std::string& err) {
  std::string kept;
  for (std::size_t begin = 0; begin < err.size();) {
    const std::size_t end = std::min(err.find('\n', begin), err.size() - 1) + 1;
    const std::string line = err.substr(begin, end - begin);
    if (line.find("frames/s") == std::string::npos && !line.ends_with(" %\n")) kept += line;
    begin = end;
  }
  return kept;
}

void expectDone(const Outcome& outcome, const std::string& out) {
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, out);
  EXPECT_EQ(complaints(outcome.err), "");
}

void expectFailed(const Outcome& outcome, int status, const std::string& err) {
  EXPECT_EQ(outcome.status, status);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, err);
}

}  // namespace handmap
