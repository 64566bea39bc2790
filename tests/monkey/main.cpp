// monkey SEQUENCES [FIRST_SEED]: plays as many random sequences, some in each process, so that a
// crash is a finding and not the end. A sequence that fails is shrunk and printed; `monkey --play
// "STEPS"` plays it again. Exit status 1: something was found.
#include <QCoreApplication>
#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTimer>

#include <fmt/format.h>

#include "app/gui/application.h"
#include "tests/monkey/playground.h"
#include "widgets/background/background.h"

namespace {

using namespace handmap;

constexpr std::uint32_t kInOneProcess = 50;
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

int search(std::uint32_t count, std::uint32_t first) {
  int found = 0;
  std::uint32_t played = 0;
  for (std::uint32_t seed = first; seed < first + count;) {
    const std::uint32_t batch = std::min(kInOneProcess, first + count - seed);
    const Outcome outcome = outcomeOf({"--seeds", QString::number(seed), QString::number(batch)});
    played += batch;
    seed += batch;
    if (outcome.well) continue;
    ++found;
    const qsizetype last = outcome.said.lastIndexOf("seed ");
    const std::uint32_t its = outcome.said.mid(last + 5).section(u'\n', 0, 0).toUInt();
    const Steps steps = stepsOf(its);
    fmt::print("seed {} failed: {}\n{}\n", its,
               outcome.said.mid(last).section(u'\n', 1).toStdString(),
               outcome.error.right(4000).toStdString());
    fmt::print("as a test: monkey --play \"{}\"\n",
               inWords(fails(steps) ? shrunk(steps) : steps).toStdString());
    std::fflush(stdout);
    played -= seed - its - 1;
    seed = its + 1;  // the rest of the batch
  }
  fmt::print("{} sequences, {} failed\n", played, found);
  return found == 0 ? 0 : 1;
}

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
  return search(count, arguments.value(2, "1").toUInt());
}
