#include "widgets/run/overlays/run_overlays.h"

#include <QApplication>
#include <QFontMetricsF>
#include <QGraphicsScene>
#include <QPainter>

#include <gtest/gtest.h>

#include "core/map/certainty.h"
#include "core/tape/tape.h"
#include "widgets/run/overlays/particles_item.h"

namespace handmap {
namespace {

constexpr double kScale = 8.0;  // pixels per metre
const QRectF kArea(0.0, 0.0, 60.0, 60.0);

/// A snapshot with everything in it, each in a place of its own.
std::shared_ptr<Snapshot> fullSnapshot() {
  auto snapshot = std::make_shared<Snapshot>();
  Building building;
  building.id = "N1";
  building.shape = Rectangle{{40.0, 45.0}, 20.0, 10.0, 0.0};
  building.estimate = Estimate{1.0, 1.0, 0.0, 3};
  Map map;
  map.buildings = {building};
  snapshot->map = Lazy<Map>([map] { return map; });
  snapshot->report.time_s = 1.0;
  snapshot->report.pose = {20.0, 30.0, kPi / 2};
  snapshot->report.pose_sigma = {4.0, 1.0, 0.1};
  snapshot->particles = {{{10.0, 5.0, 0.0}, 1.0}};
  snapshot->swarms = {{0, {Rectangle{{30.0, 22.0}, 6.0, 4.0, 0.0}.corners()}}};
  snapshot->trajectory =
      SharedListWriter(std::vector<StampedPose>{{0.0, {2.0, 15.0, 0.0}}, {1.0, {12.0, 15.0, 0.0}}})
          .share();
  snapshot->odometry =
      SharedListWriter(std::vector<StampedPose>{{0.0, {2.0, 20.0, 0.0}}, {1.0, {12.0, 20.0, 0.0}}})
          .share();
  LocalMap local_map(0.1, 20.0);
  // A patch of wall 10 m ahead and 5 m to the left of the robot.
  local_map.cells()(cv::Rect(local_map.columnOf(10.0) - 5, local_map.columnOf(5.0) - 5, 10, 10)) =
      1.0F;
  snapshot->local_map = LazyLocalMap(20.0, [local_map] { return local_map; });
  snapshot->truth = Pose2{50.0, 20.0, 0.0};
  return snapshot;
}

/// The building of fullSnapshot(), drawn 12 m farther down.
Map drawnElsewhere() {
  Map drawing = *fullSnapshot()->map;
  std::get<Rectangle>(drawing.buildings[0].shape).centre.y() -= 12.0;
  drawing.buildings[0].estimate.reset();
  return drawing;
}

class RunOverlaysTest : public testing::Test {
 protected:
  RunOverlaysTest() {
    for (const LayerSpec& spec : kLayers) overlays_.setLayerVisible(spec.layer, true);
  }
  QImage picture() {
    QImage image((kArea.size() * kScale).toSize(), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.translate(0.0, image.height());
    painter.scale(1.0, -1.0);  // y up, as the canvas has it
    scene_.render(&painter, image.rect(), kArea);
    return image;
  }
  /// The colour least like the white background within 1 m of a point.
  static QColor darkestNear(const QImage& image, double x, double y) {
    QColor darkest(Qt::white);
    const QPoint centre(static_cast<int>(x * kScale),
                        image.height() - 1 - static_cast<int>(y * kScale));
    for (int dy = -8; dy <= 8; ++dy) {
      for (int dx = -8; dx <= 8; ++dx) {
        const QPoint at = centre + QPoint(dx, dy);
        if (image.valid(at) && image.pixelColor(at).value() + image.pixelColor(at).lightness() <
                                   darkest.value() + darkest.lightness()) {
          darkest = image.pixelColor(at);
        }
      }
    }
    return darkest;
  }
  static bool isBlank(const QColor& colour) { return colour == QColor(Qt::white); }

  QGraphicsScene scene_;
  RunOverlays overlays_{scene_, 100.0};
};

TEST_F(RunOverlaysTest, NothingIsShownBeforeARun) {
  const QImage image = picture();
  QImage blank = image;
  blank.fill(Qt::white);
  EXPECT_EQ(image, blank);
}

TEST_F(RunOverlaysTest, EverythingLiesWhereItIsInTheMap) {
  overlays_.show(*fullSnapshot());
  const QImage image = picture();
  const QColor wall = darkestNear(image, 30.0, 45.0);
  EXPECT_GT(wall.blue(), wall.red()) << "the corrected map is blue";
  const QColor particle = darkestNear(image, 10.0, 5.0);
  EXPECT_GT(particle.red(), particle.blue()) << "particles are orange";
  EXPECT_FALSE(isBlank(darkestNear(image, 7.0, 15.0))) << "trajectory";
  EXPECT_FALSE(isBlank(darkestNear(image, 7.0, 20.0))) << "odometry";
  // Ahead is up here, left is to smaller x.
  EXPECT_FALSE(isBlank(darkestNear(image, 15.0, 40.0))) << "local map";
  EXPECT_TRUE(isBlank(darkestNear(image, 25.0, 40.0))) << "local map, mirrored";
  EXPECT_FALSE(isBlank(darkestNear(image, 20.0, 30.0))) << "robot";
  EXPECT_FALSE(isBlank(darkestNear(image, 50.0, 20.0))) << "true robot";
  EXPECT_TRUE(isBlank(darkestNear(image, 57.0, 5.0)));
}

TEST_F(RunOverlaysTest, NothingIsDrawnAheadOfTheRobot) {
  auto early = fullSnapshot();
  early->report.time_s = 0.5;
  overlays_.setTruth({{0.0, {2.0, 10.0, 0.0}}, {1.0, {12.0, 10.0, 0.0}}});
  overlays_.show(*early);
  for (const double y : {10.0, 15.0, 20.0})
    EXPECT_TRUE(isBlank(darkestNear(picture(), 9.0, y))) << "way at y = " << y;
  overlays_.show(*fullSnapshot());
  for (const double y : {10.0, 15.0, 20.0})
    EXPECT_FALSE(isBlank(darkestNear(picture(), 9.0, y))) << "way at y = " << y;
}

TEST_F(RunOverlaysTest, EachLayerHasItsSwitch) {
  overlays_.setDrawing(drawnElsewhere());
  overlays_.show(*fullSnapshot());
  const std::vector<std::pair<Layer, QPointF>> places = {
      {Layer::Particles, {10.0, 5.0}}, {Layer::Trajectory, {7.0, 15.0}},
      {Layer::Odometry, {7.0, 20.0}},  {Layer::LocalMap, {15.0, 40.0}},
      {Layer::Truth, {50.0, 20.0}},    {Layer::Swarms, {33.0, 22.0}},
      {Layer::Changes, {40.0, 37.0}},  {Layer::PoseSpread, {23.8, 30.0}},
  };
  for (const auto& [layer, at] : places) {
    EXPECT_FALSE(isBlank(darkestNear(picture(), at.x(), at.y())));
    overlays_.setLayerVisible(layer, false);
    EXPECT_TRUE(isBlank(darkestNear(picture(), at.x(), at.y())));
    overlays_.setLayerVisible(layer, true);
    EXPECT_FALSE(isBlank(darkestNear(picture(), at.x(), at.y())));
  }
}

/// In the middle of a building stands its name.
TEST_F(RunOverlaysTest, HowFarABuildingMovedIsSaidBelowItsName) {
  Map drawing = drawnElsewhere();
  std::get<Rectangle>(drawing.buildings[0].shape).centre = {37.0, 45.0};
  for (const LayerSpec& spec : kLayers)
    overlays_.setLayerVisible(spec.layer, spec.layer == Layer::Changes);
  overlays_.setDrawing(drawing);
  overlays_.show(*fullSnapshot());
  const QImage shown = picture();
  for (double x = 29.0; x < 35.5; x += 0.25)
    EXPECT_TRUE(isBlank(darkestNear(shown, x, 45.0))) << "at x = " << x;
  const double line_m = QFontMetricsF(QApplication::font()).height() / kScale;
  bool is_said = false;
  for (double x = 38.0; x < 42.0; x += 0.25)
    is_said = is_said || !isBlank(darkestNear(shown, x, 45.0 - 1.5 * line_m));
  EXPECT_TRUE(is_said);
}

/// The robot of fullSnapshot() looks up: rays to the lower wall of the building, which lies 10 m
/// ahead and from x = 30 to 50, and a point of its own to the left.
std::shared_ptr<const Perceived> seenFrom(const Pose2& robot) {
  auto seen = std::make_shared<Perceived>();
  for (double x = 40.0; x >= 32.0; x -= 0.5) {
    const Vec2 end = robot.toOwn({x, 40.0});
    Ray ray;
    ray.bearing = static_cast<float>(std::atan2(end.y(), end.x()));
    ray.range = static_cast<float>(end.norm());
    ray.wall = 1.0F;
    ray.returned = true;
    seen->percept.scan.rays.push_back(ray);
  }
  seen->percept.points = {{2.0F, 15.0F, 0.5F, 0.0F}};  // at (5, 32)
  return seen;
}

TEST_F(RunOverlaysTest, WhatTheRobotSeesIsShownWhileItIsKept) {
  const auto snapshot = fullSnapshot();
  for (const LayerSpec& spec : kLayers) overlays_.setLayerVisible(spec.layer, false);
  const auto seen = seenFrom(snapshot->report.pose);
  snapshot->seen = PastSight(seen);
  overlays_.show(*snapshot);
  const std::vector<std::pair<Layer, QPointF>> places = {
      {Layer::Points, {5.0, 32.0}},
      {Layer::SeenWalls, {36.0, 40.0}},
      {Layer::Sight, {20.0, 50.0}},  // 20 m ahead: its limit
  };
  for (const auto& [layer, at] : places) {
    EXPECT_TRUE(isBlank(darkestNear(picture(), at.x(), at.y())));
    overlays_.setLayerVisible(layer, true);
    EXPECT_FALSE(isBlank(darkestNear(picture(), at.x(), at.y()))) << static_cast<int>(layer);
    overlays_.setLayerVisible(layer, false);
  }
  overlays_.setLayerVisible(Layer::SeenWalls, true);
  EXPECT_TRUE(isBlank(darkestNear(picture(), 46.0, 40.0))) << "a part that no ray met";
  overlays_.show(*fullSnapshot());  // of which nothing is kept any more
  EXPECT_TRUE(isBlank(darkestNear(picture(), 36.0, 40.0)));
}

TEST_F(RunOverlaysTest, APhaseIsShownUntilTheNextSnapshot) {
  Phase phase;
  phase.shown = *fullSnapshot();
  phase.walls = {{{52.0, 5.0}, {58.0, 5.0}}};
  overlays_.showPhase(phase);
  EXPECT_FALSE(isBlank(darkestNear(picture(), 55.0, 5.0)));
  EXPECT_FALSE(isBlank(darkestNear(picture(), 7.0, 20.0))) << "and all else";
  overlays_.show(*fullSnapshot());
  EXPECT_TRUE(isBlank(darkestNear(picture(), 55.0, 5.0)));
}

TEST_F(RunOverlaysTest, OutlinesAndBandsAreSwitchedApart) {
  overlays_.show(*fullSnapshot());
  const auto at_wall = [this] { return darkestNear(picture(), 30.0, 45.0).lightness(); };
  const int both = at_wall();
  overlays_.setLayerVisible(Layer::Corrected, false);
  const int band_alone = at_wall();
  EXPECT_GT(band_alone, both);
  EXPECT_LT(band_alone, 255);
  overlays_.setLayerVisible(Layer::Band, false);
  EXPECT_EQ(at_wall(), 255);
}

TEST_F(RunOverlaysTest, TheBandReachesOneSigmaToBothSides) {
  overlays_.show(*fullSnapshot());
  overlays_.setLayerVisible(Layer::Corrected, false);
  const QImage image = picture();
  const auto at = [&image](double x) {
    return image.pixelColor(static_cast<int>(x * kScale),
                            image.height() - 1 - static_cast<int>(45.0 * kScale));
  };
  EXPECT_FALSE(isBlank(at(29.2)));
  EXPECT_FALSE(isBlank(at(30.8)));
  EXPECT_TRUE(isBlank(at(28.5)));
  EXPECT_TRUE(isBlank(at(31.5)));
}

/// fullSnapshot() with another certainty of its building.
std::shared_ptr<Snapshot> snapshotWith(const std::function<void(Building&)>& change) {
  auto snapshot = fullSnapshot();
  Map map = *snapshot->map;
  change(map.buildings[0]);
  snapshot->map = Lazy<Map>([map] { return map; });
  return snapshot;
}

TEST_F(RunOverlaysTest, AWallThatNobodySawIsDashedAndHasNoBand) {
  overlays_.show(*snapshotWith([](Building& building) {
    setSides(building, {{{1.0, true}, {1.0, true}, {1.0, false}, {1.0, true}}});
  }));
  const QImage image = picture();
  const auto painted = [&image](double x) {  // rows of the left or the right wall
    int rows = 0;
    for (double y = 42.0; y < 48.0; y += 0.125) {
      const QPoint at(static_cast<int>(x * kScale),
                      image.height() - 1 - static_cast<int>(y * kScale));
      rows += isBlank(image.pixelColor(at)) ? 0 : 1;
    }
    return rows;
  };
  EXPECT_EQ(painted(50.0), 48);
  EXPECT_EQ(painted(50.7), 48) << "its band";
  EXPECT_GT(painted(30.0), 10);
  EXPECT_LT(painted(30.0), 40) << "dashes";
  EXPECT_EQ(painted(30.7), 0) << "no band";
}

TEST_F(RunOverlaysTest, ADoubtfulBuildingIsHatched) {
  overlays_.show(*fullSnapshot());
  EXPECT_TRUE(isBlank(darkestNear(picture(), 40.0, 45.0)));
  overlays_.show(*snapshotWith([](Building& building) { setDoubt(building, 0.4); }));
  EXPECT_FALSE(isBlank(darkestNear(picture(), 40.0, 45.0)));
}

TEST_F(RunOverlaysTest, LabelsAreToldWhereTheCorrectedBuildingsStand) {
  QHash<QString, QPolygonF> told;
  QObject::connect(&overlays_, &RunOverlays::outlinesChanged, &overlays_,
                   [&told](const QHash<QString, QPolygonF>& outlines) { told = outlines; });
  overlays_.show(*fullSnapshot());
  ASSERT_TRUE(told.contains("N1"));
  EXPECT_EQ(told["N1"].boundingRect(), QRectF(30.0, 40.0, 20.0, 10.0));
  overlays_.setLayerVisible(Layer::Corrected, false);
  EXPECT_TRUE(told.isEmpty()) << "a label does not stand on what is not shown";
  overlays_.setLayerVisible(Layer::Corrected, true);
  EXPECT_FALSE(told.isEmpty());
  overlays_.clear();
  EXPECT_TRUE(told.isEmpty());
}

TEST_F(RunOverlaysTest, SnapshotsMayComeInAnyOrder) {
  auto later = fullSnapshot();
  later->report.pose = {50.0, 10.0, 0.0};
  later->truth.reset();
  overlays_.show(*fullSnapshot());
  const QImage first = picture();
  overlays_.show(*later);
  EXPECT_NE(picture(), first);
  overlays_.show(*fullSnapshot());
  EXPECT_EQ(picture(), first);
}

TEST_F(RunOverlaysTest, ALayerCanBeFaint) {
  overlays_.show(*fullSnapshot());
  const int strong = darkestNear(picture(), 7.0, 15.0).lightness();
  overlays_.setLayerOpacity(Layer::Trajectory, 0.2);
  const int faint = darkestNear(picture(), 7.0, 15.0).lightness();
  EXPECT_GT(faint, strong + 30);
  EXPECT_LT(faint, 255);
}

TEST_F(RunOverlaysTest, TheRaysOfAWallAreShownUntilTheyAreTakenAway) {
  WallStory story;
  story.wall = {{5.0, 55.0}, {15.0, 55.0}};
  WallWitness witness;
  witness.pose = {10.0, 40.0, 0.0};
  witness.returns = {{10.0, 55.0}};
  story.witnesses = {witness};
  story.rays = 1;
  overlays_.showStory(&story, 0);
  EXPECT_FALSE(isBlank(darkestNear(picture(), 10.0, 47.0))) << "the ray";
  EXPECT_FALSE(isBlank(darkestNear(picture(), 6.0, 55.0))) << "the wall";
  overlays_.setLayerVisible(Layer::Rays, false);
  EXPECT_TRUE(isBlank(darkestNear(picture(), 10.0, 47.0)));
  overlays_.setLayerVisible(Layer::Rays, true);
  overlays_.showStory(nullptr, {});
  EXPECT_TRUE(isBlank(darkestNear(picture(), 10.0, 47.0)));
}

TEST_F(RunOverlaysTest, TheNumberOfItemsDoesNotDependOnTheNumberOfParticles) {
  overlays_.show(*fullSnapshot());
  const auto before = scene_.items().size();
  auto many = fullSnapshot();
  many->particles.assign(10'000, {{10.0, 5.0, 0.0}, 1e-4});
  overlays_.show(*many);
  EXPECT_EQ(scene_.items().size(), before);
}

TEST_F(RunOverlaysTest, ClearTakesEverythingAway) {
  overlays_.setTruth({{0.0, {5.0, 50.0, 0.0}}, {1.0, {15.0, 50.0, 0.0}}});
  overlays_.show(*fullSnapshot());
  overlays_.clear();
  QImage blank = picture();
  blank.fill(Qt::white);
  EXPECT_EQ(picture(), blank);
}

TEST_F(RunOverlaysTest, TheTrueWayIsThereBeforeTheRun) {
  overlays_.setTruth({{0.0, {5.0, 50.0, 0.0}}, {1.0, {15.0, 50.0, 0.0}}});
  const QColor way = darkestNear(picture(), 10.0, 50.0);
  EXPECT_GT(way.green(), way.red());
}

TEST(ParticlesItem, ManyBecomeADensityOfTheSamePlace) {
  std::vector<ParticleView> particles;
  for (std::size_t i = 0; i <= ParticlesItem::kDensityFrom; ++i) {
    const double t = static_cast<double>(i) / ParticlesItem::kDensityFrom;
    particles.push_back({{20.0 + 10.0 * t, 30.0 + static_cast<double>(i % 2), 0.0}, 1e-5});
  }
  QGraphicsScene scene;
  auto* item = new ParticlesItem;
  scene.addItem(item);
  item->setParticles(particles);
  EXPECT_TRUE(item->showsDensity());
  QImage image(480, 480, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  scene.render(&painter, image.rect(), QRectF(0.0, 0.0, 60.0, 60.0));
  const auto painted = [&image](double x, double y) {
    return image.pixelColor(static_cast<int>(x * 8.0), static_cast<int>(y * 8.0)) != Qt::white ||
           image.pixelColor(static_cast<int>(x * 8.0), static_cast<int>(y * 8.0) + 1) != Qt::white;
  };
  EXPECT_TRUE(painted(25.0, 30.0));
  EXPECT_FALSE(painted(35.0, 30.0));
  particles.resize(ParticlesItem::kDensityFrom);
  item->setParticles(particles);
  EXPECT_FALSE(item->showsDensity());
}

}  // namespace
}  // namespace handmap
