#include "core/experiments/trial_folder.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/experiments/trial_table.h"

namespace handmap {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kMostBytes = 1ULL << 30;

[[noreturn]] void failed(const fs::path& path, const std::string& reason) {
  throw Error(ErrorCode::RunFailed, fmt::format("{}: {}", path.string(), reason));
}

std::vector<fs::path> tablesIn(const fs::path& folder) {
  std::vector<fs::path> tables;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("trials-") && name.ends_with(".csv")) tables.push_back(entry.path());
  }
  std::sort(tables.begin(), tables.end());
  return tables;
}

/// Where the whole lines of a table end; 0 while its head is not whole.
std::size_t wholeLines(const std::string& text) {
  if (std::count(text.begin(), text.end(), '\n') < 2) return 0;
  return text.rfind('\n') + 1;
}

}  // namespace

std::map<TrialKey, Trial> readTrials(const fs::path& folder, const TrialSettings& settings) {
  std::map<TrialKey, Trial> trials;
  for (const fs::path& table : tablesIn(folder)) {
    for (const Trial& trial : parseTrials(readFile(table, kMostBytes), table.string(), settings)) {
      const auto [known, is_new] = trials.emplace(trial.key, trial);
      if (is_new || trialLine(known->second) == trialLine(trial)) continue;
      throwBadInput(table.string(), "",
                    fmt::format("trial {} of {} at {} m again, with another result",
                                trial.key.number, nameOf(trial.key.method), trial.key.sigma_m),
                    "the same result, or no second one");
    }
  }
  return trials;
}

TrialWriter::TrialWriter(const fs::path& folder, const Shard& shard, const TrialSettings& settings)
    : path_(folder / fmt::format("trials-{}-of-{}.csv", shard.index, shard.count)) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) failed(folder, error.message());
  file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file_ < 0) failed(path_, std::strerror(errno));
  try {
    // Where the file system cannot lock, one has to take care oneself.
    if (flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      failed(path_, "another process writes it");
    }
    const std::size_t whole = wholeLines(readFile(path_, kMostBytes));
    if (ftruncate(file_, static_cast<off_t>(whole)) != 0) failed(path_, std::strerror(errno));
    if (whole == 0) append(trialTableHead(settings));
  } catch (...) {
    close(file_);
    throw;
  }
}

TrialWriter::~TrialWriter() { close(file_); }

void TrialWriter::add(const Trial& trial) { append(trialLine(trial)); }

void TrialWriter::append(const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = write(file_, text.data() + done, text.size() - done);
    if (count < 0 && errno != EINTR) failed(path_, std::strerror(errno));
    if (count > 0) done += static_cast<std::size_t>(count);
  }
}

}  // namespace handmap
