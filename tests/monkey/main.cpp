// monkey SEQUENCES [FIRST_SEED]: plays as many random sequences, some in each process, so that a
// crash is a finding and not the end. A sequence that fails is shrunk and printed; `monkey --play
// "STEPS"` plays it again. Exit status 1: something was found.
#include <QCoreApplication>
#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTimer>
#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "app/gui/window/application.h"
#include "tests/monkey/playground.h"
#include "widgets/background/background.h"

namespace {

using namespace handmap;

constexpr std::uint32_t kInOneProcess = 20;
constexpr int kPatienceMs = 120'000;  // for one sequence, under sanitizers on a slow machine

QtMessageHandler default_handler = nullptr;

void dropNoise(QtMsgType type, const QMessageLogContext& context, const QString& message) {
  if (!message.startsWith(QLatin1String("This plugin does not support"))) {
    default_handler(type, context, message);
  }
}

/// The process that plays: `--play STEPS`, or `--seeds FIRST COUNT`.
int play(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  default_handler = qInstallMessageHandler(dropNoise);
  Application app(argc, argv);
  QStandardPaths::setTestModeEnabled(true);
  QApplication::setQuitOnLastWindowClosed(false);
  const QStringList arguments = QApplication::arguments();
  Playground playground;
  const auto tell = [](const QString& wrong) {
    if (!wrong.isEmpty()) fmt::print("wrong: {}\n", wrong.toStdString());
    return wrong.isEmpty();
  };
  if (arguments.value(1) == "--play")
    return tell(playground.play(parsedSteps(arguments.value(2)))) ? 0 : 1;
  const std::uint32_t first = arguments.value(2).toUInt();
  for (std::uint32_t seed = first; seed < first + arguments.value(3).toUInt(); ++seed) {
    fmt::print("seed {}\n", seed);
    std::fflush(stdout);
    if (!tell(playground.play(stepsOf(seed)))) return 1;
  }
  return 0;
}

struct Outcome {
  bool well = false;
  QString said;  ///< the last lines
  QString error;
};

/// Waits as long as it says something.
Outcome outcomeOf(const QStringList& arguments) {
  QProcess process;
  process.start(QCoreApplication::applicationFilePath(), arguments);
  Outcome outcome;
  while (process.state() != QProcess::NotRunning) {
    if (!process.waitForReadyRead(kPatienceMs) && process.state() == QProcess::Running) {
      if (process.waitForFinished(0)) break;
      outcome.error = "it hangs\n";
      process.kill();
    }
    outcome.said += QString::fromUtf8(process.readAllStandardOutput());
    process.waitForFinished(1);
  }
  outcome.said += QString::fromUtf8(process.readAllStandardOutput());
  outcome.error += QString::fromUtf8(process.readAllStandardError());
  outcome.well = process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0;
  return outcome;
}

bool fails(const Steps& steps) { return !outcomeOf({"--play", inWords(steps)}).well; }

/// Leaves out whatever can be left out; it takes time for bad luck to strike again, so each try is
/// made twice.
Steps shrunk(Steps steps) {
  for (std::size_t part = std::max<std::size_t>(1, steps.size() / 2); part > 0; part /= 2) {
    for (std::size_t at = 0; at + part <= steps.size();) {
      Steps fewer = steps;
      fewer.erase(fewer.begin() + static_cast<long>(at),
                  fewer.begin() + static_cast<long>(at + part));
      if (fails(fewer) || fails(fewer)) {
        steps = std::move(fewer);
      } else {
        at += part;
      }
    }
  }
  return steps;
}

/// Batches of seeds that several processes play beside each other; most of a sequence is waiting.
class Search {
 public:
  Search(std::uint32_t count, std::uint32_t first) : next_(first), end_(first + count) {}

  int run() {
    std::vector<std::jthread> players(2 * std::max(1U, std::thread::hardware_concurrency()));
    for (std::jthread& player : players) player = std::jthread([this] { playBatches(); });
    players.clear();
    fmt::print("{} sequences, {} failed\n", played_, found_);
    return found_ == 0 ? 0 : 1;
  }

 private:
  void playBatches() {
    while (true) {
      const std::uint32_t first = next_.fetch_add(kInOneProcess);
      if (first >= end_) return;
      play(first, std::min(first + kInOneProcess, end_));
    }
  }

  void play(std::uint32_t seed, std::uint32_t end) {
    while (seed < end) {
      const Outcome outcome =
          outcomeOf({"--seeds", QString::number(seed), QString::number(end - seed)});
      const qsizetype last = outcome.said.lastIndexOf("seed ");
      const std::uint32_t its = outcome.said.mid(last + 5).section(u'\n', 0, 0).toUInt();
      const std::uint32_t next = outcome.well ? end : std::max(its, seed) + 1;
      played_ += next - seed;
      seed = next;
      if (!outcome.well) tell(its, outcome.said.mid(last).section(u'\n', 1), outcome.error);
    }
  }

  void tell(std::uint32_t seed, const QString& said, const QString& error) {
    ++found_;
    const Steps steps = stepsOf(seed);
    const std::string shortest = inWords(fails(steps) ? shrunk(steps) : steps).toStdString();
    const std::scoped_lock lock(telling_);
    fmt::print("seed {} failed: {}\n{}\nas a test: monkey --play \"{}\"\n", seed,
               said.toStdString(), error.right(4000).toStdString(), shortest);
    std::fflush(stdout);
  }

  std::atomic<std::uint32_t> next_;
  const std::uint32_t end_;
  std::atomic<std::uint32_t> played_ = 0;
  std::atomic<int> found_ = 0;
  std::mutex telling_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2 && argv[1][0] == '-') return play(argc, argv);
  const QCoreApplication app(argc, argv);
  const QStringList arguments = QCoreApplication::arguments();
  bool ok = false;
  const std::uint32_t count = arguments.value(1).toUInt(&ok);
  if (!ok || count == 0) {
    fmt::print(stderr, "usage: monkey SEQUENCES [FIRST_SEED] | --play STEPS\n");
    return 1;
  }
  return Search(count, arguments.value(2, "1").toUInt()).run();
}
