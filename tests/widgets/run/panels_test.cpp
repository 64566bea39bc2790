#include <QCheckBox>
#include <QItemSelectionModel>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSlider>
#include <QSpinBox>
#include <QTableView>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include "core/classification/building_classifier.h"
#include "core/map/certainty.h"
#include "widgets/pictures/camera_image.h"
#include "widgets/run/panels/buildings_panel.h"
#include "widgets/run/panels/camera_panel.h"
#include "widgets/run/panels/charts_panel.h"
#include "widgets/run/panels/layers_panel.h"
#include "widgets/run/panels/run_setup_panel.h"
#include "widgets/run/panels/timeline.h"
#include "widgets/run/panels/transport_bar.h"

namespace handmap {
namespace {

TEST(LayersPanel, EverySwitchTellsOfItsLayer) {
  LayersPanel panel;
  std::vector<std::pair<Layer, bool>> heard;
  QObject::connect(&panel, &LayersPanel::toggled, &panel,
                   [&heard](Layer layer, bool on) { heard.emplace_back(layer, on); });
  for (const LayerSpec& spec : kLayers) {
    EXPECT_EQ(panel.isOn(spec.layer), spec.usual);
    panel.setOn(spec.layer, !spec.usual);
    ASSERT_EQ(heard.back(), std::pair(spec.layer, !spec.usual)) << spec.text;
    EXPECT_EQ(panel.isOn(spec.layer), !spec.usual);
  }
  EXPECT_EQ(heard.size(), kLayers.size());
}

TEST(LayersPanel, EachLayerHasAnOpacityButPicturesAndTheGrid) {
  LayersPanel panel;
  std::map<Layer, double> heard;
  QObject::connect(&panel, &LayersPanel::opacityChanged, &panel,
                   [&heard](Layer layer, double share) { heard[layer] = share; });
  for (auto* slider : panel.findChildren<QSlider*>()) {
    EXPECT_FALSE(slider->accessibleName().isEmpty());
    slider->setValue(40);
  }
  EXPECT_EQ(heard.size(), kLayers.size() - 2);
  EXPECT_FALSE(heard.contains(Layer::Grid));
  EXPECT_DOUBLE_EQ(heard[Layer::Band], 0.4);
}

TEST(LayersPanel, ListsOnlyWhatThereIs) {
  LayersPanel panel;
  panel.show();
  std::map<Layer, bool> heard;
  QObject::connect(&panel, &LayersPanel::toggled, &panel,
                   [&heard](Layer layer, bool on) { heard[layer] = on; });
  const auto listed = [&panel] {
    int count = 0;
    for (const auto* box : panel.findChildren<QCheckBox*>()) count += box->isVisible() ? 1 : 0;
    return count;
  };
  panel.setAvailable(Layer::Truth, false);
  panel.setRun(false, false);
  EXPECT_EQ(listed(), 3) << "drawing, pictures and grid";
  EXPECT_FALSE(heard[Layer::Corrected]);
  panel.setRun(true, false);
  EXPECT_TRUE(heard[Layer::Corrected]);
  EXPECT_FALSE(panel.isAvailable(Layer::Particles)) << "the method has none";
  panel.setRun(true, true);
  EXPECT_EQ(listed(), static_cast<int>(kLayers.size()) - 1);
}

TEST(LayersPanel, WhatIsShownAndHowStronglyOutlivesTheProgram) {
  const QTemporaryDir folder;
  QSettings settings(folder.filePath("settings.ini"), QSettings::IniFormat);
  const auto slider_of = [](LayersPanel& panel, const QString& layer) {
    for (auto* slider : panel.findChildren<QSlider*>()) {
      if (slider->accessibleName().startsWith(layer)) return slider;
    }
    return static_cast<QSlider*>(nullptr);
  };
  {
    LayersPanel panel;
    panel.setOn(Layer::Changes, false);
    panel.setOn(Layer::Points, true);
    slider_of(panel, "Swarms")->setValue(35);
    panel.save(settings);
  }
  LayersPanel again;
  std::map<Layer, double> heard;
  QObject::connect(&again, &LayersPanel::opacityChanged, &again,
                   [&heard](Layer layer, double share) { heard[layer] = share; });
  again.restore(settings);
  EXPECT_FALSE(again.isOn(Layer::Changes));
  EXPECT_TRUE(again.isOn(Layer::Points));
  EXPECT_FALSE(again.isOn(Layer::Sight));
  EXPECT_EQ(slider_of(again, "Swarms")->value(), 35);
  EXPECT_DOUBLE_EQ(heard.at(Layer::Swarms), 0.35);
  EXPECT_EQ(heard.size(), 1U);
}

TEST(CameraPanel, SaysWhichViewOfAStopItIsAndWhatPlacedTheWall) {
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->image = cv::Mat1b::zeros(48, 64);
  snapshot->report.frame = snapshot->pictured = 7;
  CameraPanel panel;
  panel.setSnapshot(snapshot);
  EXPECT_FALSE(panel.caption().contains(QStringLiteral("looks")));
  auto panned = std::make_shared<Snapshot>(*snapshot);
  panned->panning = {toRadians(60.0), 6, 6};
  panel.setSnapshot(panned);
  EXPECT_TRUE(panel.caption().contains(QStringLiteral("looks 60° (6 of 6)")))
      << panel.caption().toStdString();
  panel.resize(320, 240);
  const QImage plain = panel.grab().toImage();
  panel.setWitnesses({cv::Rect(16, 16, 16, 16), cv::Rect(32, 16, 16, 16)});
  EXPECT_TRUE(panel.caption().contains(QStringLiteral("2 window")));
  EXPECT_NE(panel.grab().toImage(), plain);
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
  Map refined = mapWith(12.5, 38.0, Estimate{0.25, 0.1, 0.5, 4});
  setSides(refined.buildings[0], {{{0.2, true}, {0.3, true}, {2.0, false}, {0.4, true}}});
  setDoubt(refined.buildings[0], 0.3);
  model.setRefined(refined);
  ASSERT_EQ(model.rowCount(), 1);
  const auto text = [&model](int column) {
    return model.data(model.index(0, column), Qt::DisplayRole).toString();
  };
  EXPECT_EQ(text(BuildingsModel::Name), "N1");
  EXPECT_EQ(text(BuildingsModel::Moved), "2.50");
  EXPECT_EQ(text(BuildingsModel::Doubt), "30");
  EXPECT_EQ(text(BuildingsModel::SigmaRight), "0.20");
  EXPECT_EQ(text(BuildingsModel::SigmaUp), "0.30");
  EXPECT_EQ(text(BuildingsModel::SigmaLeft), "(2.00)") << "nobody saw it";
  EXPECT_EQ(text(BuildingsModel::SigmaDown), "0.40");
  EXPECT_EQ(text(BuildingsModel::Observations), "4");
  EXPECT_EQ(text(BuildingsModel::DrawnX), "10.00");
  EXPECT_EQ(text(BuildingsModel::NowX), "12.50");
  EXPECT_EQ(text(BuildingsModel::Wider), "-2.00");
  EXPECT_EQ(text(BuildingsModel::Deeper), "0");
  EXPECT_EQ(text(BuildingsModel::Turned), "0");
  EXPECT_EQ(text(BuildingsModel::Sure), "0.40") << "the worst of those that were seen";
  EXPECT_TRUE(text(BuildingsModel::Why).startsWith("wrong in about 30 of 100"));
  EXPECT_EQ(text(BuildingsModel::Error), "–");
  forgetCertainty(refined.buildings[0]);
  refined.buildings[0].estimate->observations = 0;
  model.setRefined(refined);
  EXPECT_EQ(text(BuildingsModel::Why), "not recognised: it moves with the others");
  setDoubt(refined.buildings[0], 0.4);
  model.setRefined(refined);
  EXPECT_TRUE(text(BuildingsModel::Why).startsWith("not recognised")) << "why comes first";
  model.setDrawing({});
  EXPECT_EQ(model.rowCount(), 0);
}

TEST(BuildingsModel, TheSigmasAreThoseOfTheDirectionsOfTheMap) {
  BuildingsModel model;
  Map drawing = mapWith(10.0, 40.0, {});
  std::get<Rectangle>(drawing.buildings[0].shape).heading = kPi / 2.0;  // ahead is up
  model.setDrawing(drawing);
  Map refined = drawing;
  refined.buildings[0].estimate = Estimate{0.1, 0.1, 0.1, 3};
  setSides(refined.buildings[0], {{{1.0, true}, {2.0, true}, {3.0, true}, {4.0, true}}});
  model.setRefined(refined);
  const auto number = [&model](int column) {
    return model.data(model.index(0, column), BuildingsModel::kSortRole).toDouble();
  };
  EXPECT_EQ(number(BuildingsModel::SigmaUp), 1.0);
  EXPECT_EQ(number(BuildingsModel::SigmaLeft), 2.0);
  EXPECT_EQ(number(BuildingsModel::SigmaDown), 3.0);
  EXPECT_EQ(number(BuildingsModel::SigmaRight), 4.0);
}

/// Three buildings, moved by 2, 10 and 1 m; the last has a name with a comma.
struct Row {
  Row() {
    for (int i = 0; i < 3; ++i) {
      Building building;
      building.id = "N" + std::to_string(i);
      building.shape = Rectangle{{20.0 * i, 0.0}, 10.0, 10.0, 0.0};
      drawing.buildings.push_back(building);
    }
    drawing.uncertainty = {2.0, 3.0};
    drawing.buildings[2].name = "Bar, \"Inn\"";
    refined = drawing;
    const double moved[] = {2.0, 10.0, 1.0};
    for (std::size_t i = 0; i < 3; ++i) {
      Building& building = refined.buildings[i];
      std::get<Rectangle>(building.shape).centre.y() = moved[i];
      building.estimate = Estimate{0.1, 0.1, 0.1, 3};
    }
    setSides(refined.buildings[0], {{{0.2, true}, {0.3, false}, {0.2, true}, {0.3, true}}});
  }
  Map drawing;
  Map refined;
};

TEST(BuildingsPanel, SortsByNumbersAndIsInStepWithTheSelection) {
  const Row row;
  BuildingsPanel panel;
  panel.model().setDrawing(row.drawing);
  panel.model().setRefined(row.refined);
  const auto first = [&panel] { return panel.table().model()->index(0, 0).data().toString(); };
  EXPECT_EQ(first(), "N1") << "ten comes before two";
  panel.table().sortByColumn(BuildingsModel::Moved, Qt::AscendingOrder);
  EXPECT_EQ(first(), "N2 · Bar, \"Inn\"");
  QStringList heard = {"nothing"};
  QObject::connect(&panel, &BuildingsPanel::selectionChanged, &panel,
                   [&heard](const QStringList& ids) { heard = ids; });
  panel.select({"N0", "unknown"});
  EXPECT_EQ(heard, QStringList{"nothing"}) << "who was told does not tell";
  ASSERT_EQ(panel.table().selectionModel()->selectedRows().size(), 1);
  EXPECT_EQ(panel.table().selectionModel()->selectedRows()[0].data().toString(), "N0");
  panel.table().selectRow(0);
  EXPECT_EQ(heard, QStringList{"N2"});
  Map other = row.refined;
  other.buildings.pop_back();  // another set of rows
  panel.select({"N1"});
  panel.model().setRefined(other);
  EXPECT_EQ(panel.table().selectionModel()->selectedRows()[0].data().toString(), "N1");
}

TEST(BuildingsPanel, TheSuspiciousComeFirstAndAreNotTicked) {
  Row row;
  setDoubt(row.refined.buildings[2], 0.7);
  BuildingsPanel panel;
  panel.model().setDrawing(row.drawing);
  panel.model().setRefined(row.refined);
  const auto name = [&panel](int at) { return panel.table().model()->index(at, 0).data(); };
  EXPECT_EQ(name(0).toString(), "N2 · Bar, \"Inn\"");
  EXPECT_EQ(name(1).toString(), "N1") << "10 m, and drawn to about 3 m";
  EXPECT_EQ(panel.model().leftOut(), QStringList{"N2"});
  auto* accept = panel.findChild<QPushButton*>("accept_ticked");
  EXPECT_EQ(accept->text(), "Accept 2 of 3");
  const QModelIndex first = panel.table().model()->index(0, 0);
  panel.table().model()->setData(first, Qt::Checked, Qt::CheckStateRole);
  panel.table().model()->setData(panel.table().model()->index(1, 0), Qt::Unchecked,
                                 Qt::CheckStateRole);
  EXPECT_EQ(panel.model().leftOut(), QStringList{"N1"});
  panel.model().setRefined(row.refined);
  EXPECT_EQ(panel.model().leftOut(), QStringList{"N1"}) << "what the person said stays";
  panel.model().setAllTaken(false);
  EXPECT_FALSE(accept->isEnabled());
}

TEST(BuildingsPanel, CopiesAsCsv) {
  const Row row;
  BuildingsPanel panel;
  panel.model().setDrawing(row.drawing);
  panel.model().setRefined(row.refined);
  const QStringList lines = panel.csv().split('\n');
  ASSERT_EQ(lines.size(), 5);  // titles, three, and the end of the last line
  EXPECT_TRUE(lines[0].startsWith("Building,Moved (m),")) << lines[0].toStdString();
  EXPECT_FALSE(lines[0].contains("Off")) << "the truth is not known";
  EXPECT_TRUE(lines[1].startsWith("N1,10.000,")) << lines[1].toStdString();
  EXPECT_TRUE(
      lines[2].startsWith("N0,2.000,0.000,0.000,0.000,0.300,3 of 4 walls seen,0.000,0.200,,"
                          "0.200,0.300,3,"))
      << "a wall that nobody saw has no figure: " << lines[2].toStdString();
  EXPECT_TRUE(lines[3].startsWith("\"N2 · Bar, \"\"Inn\"\"\",")) << lines[3].toStdString();
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

TEST(RunSetupPanel, AsksForParticlesWhereTheMethodHasThem) {
  RunSetupPanel panel;
  const auto asked = [&panel] {
    QStringList words;
    for (const QLabel* label : panel.findChildren<QLabel*>())
      if (!label->isHidden()) words << label->text();
    return words;
  };
  for (const char* word : {"Particles", "Swarm", "Iterations"})
    EXPECT_FALSE(asked().contains(word));
  RunSetup setup;
  setup.settings.method = Method::Paper;
  panel.setSetup(setup);
  for (const char* word : {"Particles", "Swarm", "Iterations"}) EXPECT_TRUE(asked().contains(word));
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

}  // namespace
}  // namespace handmap
