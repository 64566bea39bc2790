#include <QCheckBox>
#include <QSettings>
#include <QSpinBox>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include "widgets/run/buildings_model.h"
#include "widgets/run/camera_panel.h"
#include "widgets/run/charts_panel.h"
#include "widgets/run/layers_panel.h"
#include "widgets/run/run_setup_panel.h"
#include "widgets/run/timeline.h"
#include "widgets/run/transport_bar.h"

namespace handmap {
namespace {

TEST(LayersPanel, EverySwitchTellsOfItsLayer) {
  LayersPanel panel;
  std::vector<std::pair<Layer, bool>> heard;
  QObject::connect(&panel, &LayersPanel::toggled, &panel,
                   [&heard](Layer layer, bool on) { heard.emplace_back(layer, on); });
  for (const LayerSpec& spec : kLayers) {
    EXPECT_TRUE(panel.isOn(spec.layer));
    panel.setOn(spec.layer, false);
    ASSERT_EQ(heard.back(), std::pair(spec.layer, false)) << spec.text;
    EXPECT_FALSE(panel.isOn(spec.layer));
  }
  EXPECT_EQ(heard.size(), kLayers.size());
}

TEST(LayersPanel, ALayerWithNothingToShowIsGrey) {
  LayersPanel panel;
  panel.setAvailable(Layer::Truth, false);
  int grey = 0;
  for (const auto* box : panel.findChildren<QCheckBox*>()) grey += box->isEnabled() ? 0 : 1;
  EXPECT_EQ(grey, 1);
}

Map mapWith(double x, double width, std::optional<Estimate> estimate) {
  Building building;
  building.id = "N1";
  building.shape = Rectangle{{x, 5.0}, width, 10.0, 0.0};
  building.estimate = estimate;
  Map map;
  map.buildings = {building};
  return map;
}

TEST(BuildingsModel, ShowsTheChangeAgainstTheDrawing) {
  BuildingsModel model;
  model.setDrawing(mapWith(10.0, 40.0, {}));
  EXPECT_EQ(model.rowCount(), 0);
  model.setRefined(mapWith(12.5, 38.0, Estimate{0.25, 0.1, 0.5, 4}));
  ASSERT_EQ(model.rowCount(), 1);
  const auto text = [&model](int column) {
    return model.data(model.index(0, column), Qt::DisplayRole).toString();
  };
  EXPECT_EQ(text(BuildingsModel::Id), "N1");
  EXPECT_EQ(text(BuildingsModel::X), "12.50");
  EXPECT_EQ(text(BuildingsModel::SigmaX), "0.25");
  EXPECT_EQ(text(BuildingsModel::Width), "38.00");
  EXPECT_EQ(text(BuildingsModel::SigmaWidth), "0.50");
  EXPECT_EQ(text(BuildingsModel::MovedX), "+2.50");
  EXPECT_EQ(text(BuildingsModel::MovedY), "0.00");
  EXPECT_EQ(text(BuildingsModel::Widened), "-2.00");
  model.setDrawing({});
  EXPECT_EQ(model.rowCount(), 0);
}

TEST(BuildingsModel, LeavesOutWhatTheRunHasNotSeen) {
  BuildingsModel model;
  model.setDrawing(mapWith(10.0, 40.0, {}));
  model.setRefined(mapWith(10.0, 40.0, {}));
  EXPECT_EQ(model.rowCount(), 0);
}

TEST(RunSetupPanel, GivesBackWhatItWasGiven) {
  RunSetup setup;
  setup.settings.method = Method::Paper;
  setup.settings.slam.slam_particles = 321;
  setup.settings.slam.pso_particles = 7;
  setup.settings.slam.pso_iterations = 0;
  setup.settings.seed = 99;
  setup.settings.threads = 2;
  setup.replay.kind = SourceKind::Points;
  setup.replay.from = 40;
  setup.replay.to = 0;
  setup.replay.every = 3;
  setup.settings.perception.classify = false;
  RunSetupPanel panel;
  panel.setSetup(setup);
  const RunSetup back = panel.setup();
  EXPECT_EQ(back.settings.method, Method::Paper);
  EXPECT_EQ(back.settings.slam.slam_particles, 321);
  EXPECT_EQ(back.settings.slam.pso_particles, 7);
  EXPECT_EQ(back.settings.slam.pso_iterations, 0);
  EXPECT_EQ(back.settings.seed, 99U);
  EXPECT_EQ(back.settings.threads, 2);
  EXPECT_EQ(back.replay.kind, SourceKind::Points);
  EXPECT_EQ(back.replay.from, 40);
  EXPECT_EQ(back.replay.to, 0);
  EXPECT_EQ(back.replay.every, 3);
  EXPECT_FALSE(back.settings.perception.classify);
}

TEST(RunSetupPanel, WhatWasTaughtTellsBuildings) {
  RunSetupPanel panel;
  EXPECT_TRUE(panel.setup().settings.perception.classify);
  EXPECT_EQ(panel.setup().settings.perception.classifier, nullptr);
  const auto taught =
      std::make_shared<const BuildingClassifier>(BuildingClassifier::builtIn(false));
  panel.setTaughtClassifier(taught);
  EXPECT_EQ(panel.setup().settings.perception.classifier, taught);
  panel.setSetup({});
  EXPECT_EQ(panel.setup().settings.perception.classifier, nullptr);
}

TEST(RunSetupPanel, TheDefaultsAreThoseOfTheMethod) {
  const RunSetup shown = RunSetupPanel().setup();
  const RunSetup defaults;
  EXPECT_EQ(shown.settings.slam.slam_particles, defaults.settings.slam.slam_particles);
  EXPECT_EQ(shown.settings.slam.pso_particles, defaults.settings.slam.pso_particles);
  EXPECT_EQ(shown.settings.seed, defaults.settings.seed);
  EXPECT_EQ(shown.replay.to, defaults.replay.to);
}

TEST(RunSetupPanel, KeepsTheMethodBetweenSessionsAndBearsNonsense) {
  const QTemporaryDir folder;
  QSettings settings(folder.filePath("s.ini"), QSettings::IniFormat);
  RunSetupPanel first;
  RunSetup setup;
  setup.settings.slam.slam_particles = 42;
  first.setSetup(setup);
  first.save(settings);
  settings.setValue("run/swarm", "many");
  settings.setValue("run/iterations", -5);
  RunSetupPanel second;
  second.restore(settings);
  EXPECT_EQ(second.setup().settings.slam.slam_particles, 42);
  EXPECT_EQ(second.setup().settings.slam.pso_particles, RunSetup().settings.slam.pso_particles);
  EXPECT_EQ(second.setup().settings.slam.pso_iterations, 0);
}

TEST(TransportBar, TakesTheNearestSpeed) {
  TransportBar bar;
  for (const double speed : {1.0, 2.0, 5.0, 10.0, 0.0}) {
    bar.setSpeed(speed);
    EXPECT_EQ(bar.speed(), speed);
  }
  bar.setSpeed(4.5);
  EXPECT_EQ(bar.speed(), 5.0);
}

TEST(TransportBar, ShowsHowFarItIsAndWhereIsLooked) {
  TransportBar bar;
  EXPECT_FALSE(bar.timeline().isEnabled());
  bar.setExtent(4, 10);
  FrameReport report;
  report.time_s = 12.34;
  bar.setShown(3, 10, report);
  EXPECT_TRUE(bar.timeline().isEnabled());
  EXPECT_EQ(bar.timeline().value(), 3);
  EXPECT_EQ(bar.timeline().maximum(), 10);
  bar.setExtent(5, 0);  // without an end
  EXPECT_EQ(bar.timeline().maximum(), 5);
  bar.resize(600, 60);
  const QImage before = bar.grab().toImage();
  bar.setExtent(2, 10);
  EXPECT_NE(bar.grab().toImage(), before);
}

TEST(CameraPanel, TakesGreyAndColourAndRefusesTheRest) {
  const QImage grey = cameraImage(cv::Mat1b(4, 6, uchar{200}));
  EXPECT_EQ(grey.size(), QSize(6, 4));
  EXPECT_EQ(grey.pixelColor(0, 0), QColor(200, 200, 200));
  const QImage colour = cameraImage(cv::Mat3b(4, 6, cv::Vec3b(255, 0, 0)));
  EXPECT_EQ(colour.pixelColor(0, 0), QColor(0, 0, 255));  // OpenCV keeps blue first
  EXPECT_TRUE(cameraImage(cv::Mat1f(4, 6, 0.5F)).isNull());
  EXPECT_TRUE(cameraImage({}).isNull());
}

TEST(CameraPanel, UnknownDisparitiesAreBlack) {
  cv::Mat1f disparity(2, 2, 10.0F);
  disparity(0, 0) = -1.0F;
  const QImage image = disparityImage(disparity);
  EXPECT_EQ(image.pixelColor(0, 0), QColor(Qt::black));
  EXPECT_NE(image.pixelColor(1, 1), QColor(Qt::black));
  EXPECT_TRUE(disparityImage({}).isNull());
}

TEST(ChartsPanel, TakesAnyNumberOfReports) {
  ChartsPanel panel;
  panel.resize(300, 300);
  std::vector<FrameReport> reports(5000);
  for (std::size_t i = 0; i < reports.size(); ++i) {
    reports[i].frame = static_cast<int>(i);
    reports[i].effective_sample_size = 50.0;
    reports[i].ms.slam = 20.0;
  }
  const QImage before = panel.grab().toImage();
  panel.add(reports);
  const QImage after = panel.grab().toImage();
  EXPECT_NE(before, after);
  panel.clear();
  EXPECT_NE(panel.grab().toImage(), after);
}

}  // namespace
}  // namespace handmap
