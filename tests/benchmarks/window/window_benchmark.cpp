// What who looks on has to wait for: the window to come up, what is drawn to be new, the event loop
// to answer, and memory to stay what it is.
#include <QElapsedTimer>
#include <QEventLoop>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <algorithm>
#include <atomic>
#include <ctime>
#include <fstream>
#include <thread>

#include <benchmark/benchmark.h>
#include <unistd.h>

#include "app/gui/run/result_actions.h"
#include "app/gui/run/source_actions.h"
#include "app/gui/run/transport_actions.h"
#include "app/gui/window/application.h"
#include "app/gui/window/main_window.h"
#include "core/session/run_history.h"
#include "core/simulation/simulated_source.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/run/overlays/run_overlays.h"
#include "widgets/run/panels/transport_bar.h"
#include "widgets/run/worker/run_mailbox.h"

namespace handmap {
namespace {

using Clock = std::chrono::steady_clock;

double secondsNow() {
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

double residentMb() {
  std::ifstream file("/proc/self/statm");
  double pages = 0.0;
  file >> pages >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1048576.0;
}

/// What this thread has computed so far, without what the machine did meanwhile.
double computedMs() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// p50, p99, p99.9 and the worst of times in milliseconds.
void count(benchmark::State& state, std::vector<double> ms, const std::string& of = {}) {
  if (ms.empty()) return;
  std::sort(ms.begin(), ms.end());
  const auto at = [&](double share) {
    return ms[static_cast<std::size_t>(share * static_cast<double>(ms.size() - 1))];
  };
  state.counters[of + "p50_ms"] = at(0.5);
  state.counters[of + "p99_ms"] = at(0.99);
  state.counters[of + "p999_ms"] = at(0.999);
  state.counters[of + "worst_ms"] = ms.back();
}

/// The event loop as in the program: QTest::qWait() sleeps ten milliseconds between events.
void live(std::chrono::milliseconds time) {
  QEventLoop loop;
  QTimer::singleShot(time, &loop, &QEventLoop::quit);
  loop.exec();
}

struct Window {
  Window() : settings(folder.filePath("settings.ini"), QSettings::IniFormat) {
    window = std::make_unique<MainWindow>(document, settings);
    window->show();
    static_cast<void>(QTest::qWaitForWindowExposed(window.get()));
  }
  QTemporaryDir folder;
  QSettings settings;
  MapDocument document;
  std::unique_ptr<MainWindow> window;
};

void comesUp(benchmark::State& state) {
  for (auto _ : state) {
    Window window;
    window.window->grab();
  }
}
BENCHMARK(comesUp)->Unit(benchmark::kMillisecond);

/// How long a thread that does nothing but sleep for milliseconds is kept waiting.
class Idle {
 public:
  std::vector<double> gapsMs() {
    thread_.request_stop();
    thread_.join();
    return gaps_ms_;
  }

 private:
  std::vector<double> gaps_ms_;
  std::jthread thread_{[this](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      const double before_s = secondsNow();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      gaps_ms_.push_back(1e3 * (secondsNow() - before_s));
    }
  }};
};

/// One run after another at the speed of the computer; a heart beats in the event loop, another one
/// beside: the machine's own stalls. `computed`: between two beats, by the thread of the window.
void stalls(benchmark::State& state) {
  std::vector<double> gaps;
  std::vector<double> computed;
  for (auto _ : state) {
    Window one;
    MainWindow& window = *one.window;
    window.sources().openTwoRows();
    window.transport().setSpeed(0.0);
    QTimer heart;
    heart.setTimerType(Qt::PreciseTimer);
    QElapsedTimer since;
    double computed_ms = computedMs();
    QObject::connect(&heart, &QTimer::timeout, &heart, [&] {
      gaps.push_back(1e-6 * static_cast<double>(since.nsecsElapsed()));
      computed.push_back(computedMs() - computed_ms);
      since.start();
      computed_ms = computedMs();
    });
    Idle idle;
    since.start();
    heart.start(1);
    QTimer again;
    QObject::connect(&again, &QTimer::timeout, &again, [&] {
      if (!window.run().isActive()) window.runs().runOrResume();
    });
    again.start(50);
    live(std::chrono::seconds(state.range(0)));
    count(state, idle.gapsMs(), "machine_");
  }
  count(state, gaps);
  count(state, computed, "computed_");
}
BENCHMARK(stalls)->ArgName("s")->Arg(20)->Arg(600)->Iterations(1)->Unit(benchmark::kSecond);

/// Snapshots of a run come so many times a second; how old is what has just been drawn?
void ageOfWhatIsDrawn(benchmark::State& state) {
  const World world = twoRowWorld(1);
  RunSession session(perturbed(world.map, 3.0, 1), simulate(world, {}, 1), {});
  std::vector<std::shared_ptr<const Snapshot>> run;
  while (auto snapshot = session.step()) run.push_back(std::move(snapshot));

  MapDocument document;
  document.reset(perturbed(world.map, 3.0, 1));
  MapCanvas canvas(document);
  canvas.resize(1000, 700);
  canvas.show();
  canvas.zoomToFit();
  RunOverlays overlays(*canvas.scene(), kOverlayZ);
  RunMailbox mailbox;
  mailbox.setPrepare(overlays.preparation());
  std::vector<double> ages;
  QObject::connect(&mailbox, &RunMailbox::arrived, &mailbox, [&](const RunNews& news) {
    overlays.show(*news.newest);
    canvas.viewport()->repaint();
    ages.push_back(1e3 * (secondsNow() - news.newest->report.time_s));
  });
  for (auto _ : state) {
    const std::jthread source([&](const std::stop_token& stop) {
      auto next = Clock::now();
      for (std::size_t i = 0; !stop.stop_requested(); ++i) {
        auto snapshot = std::make_shared<Snapshot>(*run[i % run.size()]);
        snapshot->report.time_s = secondsNow();
        mailbox.post(std::move(snapshot));
        next += std::chrono::microseconds(1'000'000 / state.range(0));
        std::this_thread::sleep_until(next);
      }
    });
    live(std::chrono::seconds(5));
  }
  count(state, ages);
}
BENCHMARK(ageOfWhatIsDrawn)->Arg(400)->Iterations(1)->Unit(benchmark::kSecond);

/// As those of a run: the way grows, a window of it changes each time.
void pastOfARun(benchmark::State& state) {
  constexpr std::size_t kWindow = 12;
  for (auto _ : state) {
    RunHistory history;
    SharedListWriter<StampedPose> way;
    const double before_mb = residentMb();
    for (int i = 1; i <= state.range(0); ++i) {
      way.push_back({0.1 * i, {0.1 * i, 0.0, 0.0}});
      for (std::size_t k = way.size() - std::min(kWindow, way.size()); k < way.size(); ++k) {
        way.set(k, {way[k].time_s, {way[k].pose.x, 1e-3 * i, 0.0}});
      }
      Snapshot snapshot;
      snapshot.index = i;
      snapshot.report.time_s = 0.1 * i;
      snapshot.particles.resize(100);
      snapshot.image = cv::Mat1b(370, 1226);
      snapshot.trajectory = way.share();
      history.add(snapshot);
    }
    state.counters["MB"] = residentMb() - before_mb;
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(pastOfARun)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

}  // namespace
}  // namespace handmap

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  handmap::Application app(argc, argv);
  QStandardPaths::setTestModeEnabled(true);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
