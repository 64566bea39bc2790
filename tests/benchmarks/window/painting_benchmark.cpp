// The canvas painted with a whole run on it: particles, and as many layers as the panel has.
#include <QApplication>
#include <QGraphicsScene>
#include <QImage>
#include <QPainter>

#include <benchmark/benchmark.h>

#include "core/base/random.h"
#include "core/map/certainty.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/document/map_document.h"
#include "widgets/run/overlays/path_item.h"
#include "widgets/run/overlays/run_overlays.h"

namespace handmap {
namespace {

constexpr QSize kCanvas(960, 640);
constexpr int kBuildings = 40;
constexpr int kPoses = 2000;
constexpr std::size_t kLayersPainted = 20;

Map street(double off_m) {
  Map map;
  map.start = Pose2{0.0, 0.0, 0.0};
  for (int i = 0; i < kBuildings; ++i) {
    Building building;
    building.id = "L" + std::to_string(i);
    const int column = i / 2;
    building.shape =
        Rectangle{{15.0 * column + off_m, i % 2 == 0 ? 15.0 : -15.0}, 12.0, 9.0, 0.05 * i};
    map.buildings.push_back(building);
  }
  return map;
}

Map corrected() {
  Map map = street(1.5);
  for (std::size_t i = 0; i < map.buildings.size(); ++i) {
    Building& building = map.buildings[i];
    building.estimate = Estimate{0.2, 0.2, 0.3, 12};
    setSides(building, {{{0.2, true}, {0.3, true}, {2.0, false}, {0.4, true}}});
    if (i % 8 == 0) setDoubt(building, 0.3);
  }
  return map;
}

/// Everything that a run can show.
Snapshot snapshotWith(std::size_t particles) {
  RandomStream random(1, 0);
  Snapshot snapshot;
  snapshot.report.pose = {150.0, 0.0, 0.0};
  snapshot.report.pose_sigma = {0.5, 0.3, 0.02};
  for (std::size_t i = 0; i < particles; ++i) {
    const Pose2 pose{150.0 + random.normal(0.0, 5.0), random.normal(0.0, 2.0), random.normal()};
    snapshot.particles.push_back({pose, random.uniform()});
  }
  const Map map = corrected();
  for (std::size_t b = 15; b < 25; ++b) {
    SwarmView swarm{b, {}};
    for (int i = 0; i < 20; ++i) {
      Rectangle member = map.buildings[b].box();
      member.centre += Vec2(random.normal(), random.normal());
      swarm.members.push_back(member.corners());
    }
    snapshot.swarms.push_back(swarm);
  }
  SharedListWriter<StampedPose> way;
  SharedListWriter<StampedPose> odometry;
  for (int i = 0; i < kPoses; ++i) {
    const double x = 150.0 * i / kPoses;
    way.push_back({0.1 * i, {x, 0.0, 0.0}});
    odometry.push_back({0.1 * i, {x, 0.01 * x, 0.0}});
  }
  snapshot.trajectory = way.share();
  snapshot.odometry = odometry.share();
  snapshot.truth = snapshot.report.pose;
  snapshot.map = Lazy<Map>([map] { return map; });
  snapshot.local_map = LazyLocalMap(40.0, [] {
    LocalMap local_map(0.1, 40.0);
    local_map.cells()(cv::Rect(100, 100, 400, 8)) = 1.0F;
    return local_map;
  });
  return snapshot;
}

WallStory story() {
  WallStory story;
  story.wall = {{140.0, 10.0}, {152.0, 10.0}};
  for (int i = 0; i < 50; ++i) {
    WallWitness witness;
    witness.pose = {130.0 + 0.5 * i, 0.0, 0.0};
    for (int ray = 0; ray < 40; ++ray) witness.returns.push_back({140.0 + 0.3 * ray, 10.0});
    story.rays += witness.returns.size();
    story.witnesses.push_back(witness);
  }
  return story;
}

/// The canvas as in the window, with every layer of the panel on it, and more ways and outlines.
class Shown {
 public:
  explicit Shown(std::size_t particles) : snapshot_(snapshotWith(particles)) {
    document_.reset(street(0.0));
    canvas_.resize(kCanvas);
    overlays_.setDrawing(street(0.0));
    overlays_.setTruthMap(street(1.4));
    overlays_.setTruth(snapshot_.trajectory.all());
    overlays_.show(snapshot_);
    overlays_.showStory(&story_, 3);
    for (std::size_t i = kLayers.size(); i < kLayersPainted; ++i) {
      more_.push_back(std::make_unique<PathItem>(Role::Odometry));
      more_.back()->setPoses(snapshot_.odometry.all());
      more_.back()->setBuildings(street(0.1 * static_cast<double>(i)).buildings);
      canvas_.scene()->addItem(more_.back().get());
    }
    canvas_.zoomToFit();
  }

  void paint() { canvas_.viewport()->render(&image_); }
  void show() { overlays_.show(snapshot_); }
  void showOnly(Layer layer) {
    for (const LayerSpec& spec : kLayers) {
      overlays_.setLayerVisible(spec.layer, spec.layer == layer);
    }
    for (const auto& item : more_) item->hide();
  }

 private:
  MapDocument document_;
  MapCanvas canvas_{document_};
  RunOverlays overlays_{*canvas_.scene(), kOverlayZ};
  Snapshot snapshot_;
  WallStory story_ = story();
  std::vector<std::unique_ptr<PathItem>> more_;
  QImage image_{kCanvas, QImage::Format_RGB32};
};

void painting(benchmark::State& state) {
  Shown shown(static_cast<std::size_t>(state.range(0)));
  shown.paint();
  for (auto _ : state) shown.paint();
  state.counters["layers"] = static_cast<double>(kLayersPainted);
}
BENCHMARK(painting)->Arg(100)->Arg(10'000)->Arg(50'000)->Unit(benchmark::kMillisecond);

/// The ground, the drawing and one layer of the panel.
void paintingOfALayer(benchmark::State& state) {
  const LayerSpec& spec = kLayers.at(static_cast<std::size_t>(state.range(0)));
  Shown shown(10'000);
  shown.showOnly(spec.layer);
  shown.paint();
  for (auto _ : state) shown.paint();
  state.SetLabel(spec.text);
}
BENCHMARK(paintingOfALayer)
    ->DenseRange(0, static_cast<int>(kLayers.size()) - 1)
    ->Unit(benchmark::kMillisecond);

/// What a new snapshot costs before it is painted.
void showing(benchmark::State& state) {
  Shown shown(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) shown.show();
}
BENCHMARK(showing)->Arg(100)->Arg(10'000)->Arg(50'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace handmap

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication app(argc, argv);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
