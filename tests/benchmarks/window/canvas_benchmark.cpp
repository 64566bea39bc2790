// What the canvas takes for a frame with many buildings: painting, picking and dragging one of
// them, all in sight and near by. The window is 1280 × 800 pixels without a display.
#include <QApplication>
#include <QImage>
#include <QMouseEvent>
#include <cmath>
#include <random>

#include <benchmark/benchmark.h>

#include "widgets/canvas/hit_test.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/panels/drawing_layers_panel.h"
#include "widgets/panels/issues_panel.h"
#include "widgets/panels/objects_panel.h"
#include "widgets/panels/property_panel.h"
#include "widgets/tools/toolbox.h"

namespace handmap {
namespace {

constexpr double kPitch = 30.0;  // metres

/// A square of houses, a third of them L-shapes, all turned a little.
Map town(std::int64_t buildings) {
  Map map;
  const auto side = static_cast<std::int64_t>(std::ceil(std::sqrt(buildings)));
  for (std::int64_t i = 0; i < buildings; ++i) {
    const std::int64_t row = i / side;
    const Vec2 at(static_cast<double>(i % side) * kPitch, static_cast<double>(row) * kPitch);
    const double heading = 0.37 * static_cast<double>(i);
    Building building;
    building.id = "H" + std::to_string(i);
    building.name = "House " + std::to_string(i);
    if (i % 3 == 0) {
      Polygon l_shape = {{-10, -6}, {10, -6}, {10, 2}, {0, 2}, {0, 6}, {-10, 6}};
      for (Vec2& corner : l_shape) corner = Pose2{at.x(), at.y(), heading}.toOuter(corner);
      building.shape = l_shape;
    } else {
      building.shape = Rectangle{at, 20.0, 10.0, heading};
    }
    map.buildings.push_back(building);
  }
  return map;
}

class Scene {
 public:
  Scene(std::int64_t buildings, bool near) : frame_(1280, 800, QImage::Format_RGB32) {
    document_.reset(town(buildings));
    canvas_.resize(frame_.size());
    canvas_.show();
    QCoreApplication::processEvents();
    middle_ = document_.map().buildings[static_cast<std::size_t>(buildings / 2)].box().centre;
    if (near)
      canvas_.zoomToRect({middle_.x() - 150.0, middle_.y() - 100.0, 300.0, 200.0});
    else
      canvas_.zoomToFit();
  }

  MapDocument& document() { return document_; }
  void paint() { canvas_.viewport()->render(&frame_); }
  QPointF middle() const {
    return canvas_.viewportTransform().map(QPointF(middle_.x(), middle_.y()));
  }
  void mouse(QEvent::Type type, QPointF at, Qt::MouseButton button = Qt::LeftButton) {
    const bool held = type != QEvent::MouseButtonRelease;
    QMouseEvent event(type, at, canvas_.viewport()->mapToGlobal(at), button,
                      held ? Qt::LeftButton : Qt::NoButton, Qt::NoModifier);
    QCoreApplication::sendEvent(canvas_.viewport(), &event);
  }

 private:
  MapDocument document_;
  MapCanvas canvas_{document_};
  Toolbox tools_{document_, canvas_};
  ObjectsPanel objects_{document_};
  PropertyPanel properties_{document_};
  IssuesPanel issues_{document_};
  DrawingLayersPanel layers_{document_};
  QImage frame_;
  Vec2 middle_;
};

void paint(benchmark::State& state) {
  Scene scene(state.range(0), state.range(1) != 0);
  for (auto _ : state) scene.paint();
}

void pick(benchmark::State& state) {
  Scene scene(state.range(0), true);
  std::mt19937 random(1);
  const double side = kPitch * std::sqrt(static_cast<double>(state.range(0)));
  std::uniform_real_distribution<double> place(0.0, side);
  static_cast<void>(scene.document().buildingIndex());
  for (auto _ : state)
    benchmark::DoNotOptimize(objectAt(scene.document(), {place(random), place(random)}, 1.0));
}

/// A click: what is under the pointer is found, selected and shown.
void click(benchmark::State& state) {
  Scene scene(state.range(0), state.range(1) != 0);
  for (auto _ : state) {
    scene.document().setSelection({});
    scene.mouse(QEvent::MouseButtonPress, scene.middle());
    scene.mouse(QEvent::MouseButtonRelease, scene.middle());
    scene.paint();
  }
}

/// Each move of the pointer while one building is dragged, with the frame that shows it.
void drag(benchmark::State& state) {
  Scene scene(state.range(0), state.range(1) != 0);
  scene.mouse(QEvent::MouseButtonPress, scene.middle());
  int step = 0;
  for (auto _ : state) {
    step = (step + 1) % 60;
    scene.mouse(QEvent::MouseMove, scene.middle() + QPointF(5.0 + step, step / 2.0), Qt::NoButton);
    scene.paint();
  }
}

/// Letting it go: the command, what the panels of the window make of it and the first frame.
void drop(benchmark::State& state) {
  Scene scene(state.range(0), state.range(1) != 0);
  for (auto _ : state) {
    state.PauseTiming();
    scene.mouse(QEvent::MouseButtonPress, scene.middle());
    scene.mouse(QEvent::MouseMove, scene.middle() + QPointF(6.0, 3.0), Qt::NoButton);
    scene.mouse(QEvent::MouseMove, scene.middle() + QPointF(7.0, 3.0), Qt::NoButton);
    state.ResumeTiming();
    scene.mouse(QEvent::MouseButtonRelease, scene.middle() + QPointF(7.0, 3.0));
    scene.paint();
    state.PauseTiming();
    scene.document().undoStack().undo();
    state.ResumeTiming();
  }
}

const std::vector<std::vector<std::int64_t>> kTowns = {{10'000, 20'000}, {0, 1}};

BENCHMARK(paint)
    ->ArgNames({"buildings", "near"})
    ->ArgsProduct(kTowns)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(pick)->ArgName("buildings")->Arg(10'000)->Arg(20'000)->Unit(benchmark::kMillisecond);
BENCHMARK(click)
    ->ArgNames({"buildings", "near"})
    ->ArgsProduct(kTowns)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(drag)
    ->ArgNames({"buildings", "near"})
    ->ArgsProduct(kTowns)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(drop)
    ->ArgNames({"buildings", "near"})
    ->ArgsProduct(kTowns)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace handmap

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication application(argc, argv);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
