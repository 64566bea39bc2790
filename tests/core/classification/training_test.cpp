#include "core/classification/training.h"

#include <gtest/gtest.h>

#include "tests/core/base/expect_error.h"
#include "tests/core/base/temporary_folder.h"
#include "tests/core/classification/painted_street.h"

namespace handmap {
namespace {

constexpr TrainingOptions kQuick{.vectors = 40};

std::vector<WindowLabel> labelsOf(const test::PaintedStreet& street) {
  return windowLabels(street.classes, test::kBuildingClass, {});
}

TrainingSet paintedSet(FeatureSet features, int images = 10) {
  TrainingSet set(features);
  for (int i = 0; i < images; ++i) {
    const test::PaintedStreet street = test::paintStreet(static_cast<std::uint64_t>(i));
    set.add(street.image, labelsOf(street));
  }
  return set;
}

const BuildingClassifier& painted() {
  static const auto kClassifier = trainClassifier(paintedSet({}), kQuick);
  return kClassifier.value();
}

bool same(const cv::Mat1f& a, const cv::Mat1f& b) {
  return a.size() == b.size() && cv::countNonZero(a != b) == 0;
}

TEST(Training, TeachesWhatBuildingsLookLike) {
  for (const FeatureSet features : {FeatureSet{}, FeatureSet{FeatureFamily::Handmap, false},
                                    FeatureSet{FeatureFamily::Paper, true}}) {
    const auto classifier = trainClassifier(paintedSet(features), kQuick);
    Confusion unseen;
    for (const std::uint64_t seed : {101U, 102U, 103U, 104U}) {
      const test::PaintedStreet street = test::paintStreet(seed);
      judge(classifier.value(), street.image, labelsOf(street), unseen);
    }
    EXPECT_EQ(unseen.buildings() + unseen.others(), 4 * 80);
    EXPECT_GT(unseen.balancedAccuracy(), 0.95);
    const Confusion& crossed = classifier->record().cross_validated;
    EXPECT_EQ(crossed.buildings() + crossed.others(), 10 * 80);
    EXPECT_NEAR(crossed.balancedAccuracy(), unseen.balancedAccuracy(), 0.05);
  }
}

TEST(Training, TeachesTrees) {
  const auto classifier = trainClassifier(paintedSet({}), {.trees = true});
  Confusion unseen;
  for (const std::uint64_t seed : {101U, 102U, 103U, 104U}) {
    const test::PaintedStreet street = test::paintStreet(seed);
    judge(classifier.value(), street.image, labelsOf(street), unseen);
  }
  EXPECT_GT(unseen.balancedAccuracy(), 0.95);
  EXPECT_NEAR(classifier->record().cross_validated.balancedAccuracy(), unseen.balancedAccuracy(),
              0.05);
}

TEST(Training, DependsOnTheSeedAlone) {
  const std::string first = painted().toJson();
  EXPECT_TRUE(trainClassifier(paintedSet({}), kQuick)->toJson() == first);
  EXPECT_FALSE(trainClassifier(paintedSet({}), {.seed = 2, .vectors = 40})->toJson() == first);
}

TEST(Training, FindsNothingInLabelsWithoutMeaning) {
  TrainingSet set({});
  RandomStream random(1);
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    std::vector<WindowLabel> labels(80);
    for (WindowLabel& label : labels) {
      label = random.uniform() < 0.5 ? WindowLabel::Building : WindowLabel::Other;
    }
    set.add(test::paintStreet(seed).image, labels);
  }
  EXPECT_NEAR(trainClassifier(set, kQuick)->record().cross_validated.balancedAccuracy(), 0.5, 0.1);
}

TEST(Training, OfOneImageThatIsHalfPainted) {
  const test::PaintedStreet street = test::paintStreet(1);
  std::vector<WindowLabel> labels = labelsOf(street);
  for (std::size_t i = 0; i < labels.size(); i += 3) labels[i] = WindowLabel::Unknown;
  TrainingSet set({});
  set.add(street.image, labels);
  EXPECT_LT(set.samples().rows(), 60);
  const auto classifier = trainClassifier(set, kQuick);
  EXPECT_GT(classifier->record().cross_validated.balancedAccuracy(), 0.8);
}

TEST(Training, NeedsBothClasses) {
  TrainingSet set({});
  set.add(test::paintStreet(1).image, std::vector(80, WindowLabel::Other));
  test::expectBadInput([&] { trainClassifier(set, kQuick); },
                       {"found 0 windows of buildings", "at least 5"});
  TrainingSet buildings({});
  buildings.add(test::paintStreet(1).image, std::vector(80, WindowLabel::Building));
  test::expectBadInput([&] { trainClassifier(buildings, kQuick); }, {"0 windows of others"});
}

TEST(Training, TellsItsProgressAndStops) {
  std::vector<double> shares;
  std::stop_source stop;
  const auto classifier = trainClassifier(paintedSet({}), kQuick, stop.get_token(), [&](double s) {
    shares.push_back(s);
    if (s > 0.3) stop.request_stop();
  });
  EXPECT_FALSE(classifier.has_value());
  EXPECT_LT(shares.back(), 0.5);
  shares.clear();
  EXPECT_TRUE(trainClassifier(paintedSet({}), kQuick, {}, [&](double s) { shares.push_back(s); }));
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_NEAR(shares.back(), 1.0, 1e-9);
}

TEST(BuildingClassifier, JudgesOnlyTheWindowsThatAreWanted) {
  const cv::Mat3b image = test::paintStreet(50).image;
  const cv::Mat1f all = painted().probabilities(image);
  cv::Mat1b wanted = noWindows(image.size());
  EXPECT_EQ(cv::countNonZero(painted().probabilities(image, wanted) != 0.5F), 0);
  wanted(2, 3) = 1;
  wanted(6, 9) = 255;
  const cv::Mat1f some = painted().probabilities(image, wanted);
  for (int row = 0; row < all.rows; ++row) {
    for (int column = 0; column < all.cols; ++column) {
      const bool is_wanted = wanted(row, column) != 0;
      EXPECT_NEAR(some(row, column), is_wanted ? all(row, column) : 0.5F, 1e-5F);
    }
  }
  test::expectBadInput([&] { painted().probabilities(image, cv::Mat1b(3, 3, std::uint8_t{1})); },
                       {"found 3 × 3, expected 10 × 8"});
}

TEST(BuildingClassifier, OfEqualizedFeaturesKnowsTheStreetAtDusk) {
  constexpr FeatureSet kEqualized{FeatureFamily::Equalized, true};
  const auto classifier = trainClassifier(paintedSet(kEqualized), {.trees = true}).value();
  EXPECT_NE(classifier.toJson().find("\"features\":\"equalized\""), std::string::npos);
  Confusion unseen;
  for (const std::uint64_t seed : {101U, 102U, 103U, 104U}) {
    const test::PaintedStreet street = test::paintStreet(seed);
    judge(classifier, cv::Mat(street.image / 8), labelsOf(street), unseen);
  }
  EXPECT_GT(unseen.balancedAccuracy(), 0.95);

  const cv::Mat3b image = test::paintStreet(50).image;
  const cv::Mat1f all = classifier.probabilities(image);
  cv::Mat1b wanted = noWindows(image.size());
  EXPECT_EQ(cv::countNonZero(classifier.probabilities(image, wanted) != 0.5F), 0);
  wanted(2, 3) = 1;
  const cv::Mat1f some = classifier.probabilities(image, wanted);
  EXPECT_EQ(some(2, 3), all(2, 3));
  EXPECT_EQ(some(2, 4), 0.5F);
}

TEST(BuildingClassifier, IsTheSameAfterSavingAndLoading) {
  const test::TemporaryFolder folder;
  painted().save(folder.path() / "model.json");
  const BuildingClassifier loaded = BuildingClassifier::load(folder.path() / "model.json");
  EXPECT_TRUE(loaded.toJson() == painted().toJson());
  EXPECT_EQ(loaded.features(), painted().features());
  const cv::Mat3b image = test::paintStreet(51).image;
  EXPECT_TRUE(same(loaded.probabilities(image), painted().probabilities(image)));
}

TEST(BuildingClassifier, ComesWithTheProgram) {
  for (const bool colour : {true, false}) {
    const BuildingClassifier classifier = BuildingClassifier::builtIn(colour);
    EXPECT_EQ(classifier.features(), (FeatureSet{FeatureFamily::Handmap, colour}));
    EXPECT_GT(classifier.record().cross_validated.balancedAccuracy(), 0.9);
    // Painted streets are not what it was taught with, but a road is no building there either.
    const test::PaintedStreet street = test::paintStreet(3);
    const cv::Mat1f probabilities = classifier.probabilities(street.image);
    EXPECT_LT(probabilities(7, 5), 0.5F);
  }
}

struct Damage {
  std::string from;
  std::string to;
  std::vector<std::string> words;
};

void expectRefused(std::string text, const Damage& damage) {
  const auto place = text.find(damage.from);
  ASSERT_NE(place, std::string::npos) << damage.from;
  text.replace(place, damage.from.size(), damage.to);
  test::expectBadInput([&] { BuildingClassifier::parse(text, "model.json"); }, damage.words);
}

TEST(BuildingClassifier, RefusesDamagedModels) {
  const std::vector<Damage> damages = {
      {"handmap-building-classifier", "handmap", {"format: found", "handmap-building-classifier"}},
      {"\"version\":2", "\"version\":1", {"version: found 1, expected 2"}},
      {"\"window\":16", "\"window\":8", {"window: found 8, expected 16"}},
      {"\"features\":\"handmap\"", "\"features\":\"more\"", {"features: found \"more\""}},
      {"\"features\":\"handmap\"", "\"features\":\"paper\"", {"mean: found 77 numbers", "6"}},
      {"\"mean\":[", "\"mean\":[1e999,", {"model.json"}},
      {"\"mean\":[", "\"mean\":[0,", {"mean: found 78 numbers, expected 77"}},
      {"\"mean\":[", "\"mean\":[null,", {"mean"}},
      {"\"vectors\":[\n[", "\"vectors\":[\n[0,", {"vectors[0]: found 78 numbers"}},
      {"\"weights\":[", "\"weights\":[0,", {"weights: found 41 numbers, expected 40"}},
      {"\"gamma\":", "\"gamma\":-", {"gamma"}},
      {"\"bias\":", "\"biased\":", {"bias"}},
      {"]]}", "]]", {"model.json"}},
  };
  const std::string whole = painted().toJson();
  for (const Damage& damage : damages) expectRefused(whole, damage);
  test::expectBadInput([] { BuildingClassifier::parse("", "model.json"); }, {"model.json"});
  test::expectBadInput([] { BuildingClassifier::load("no-such.json"); }, {"no-such.json"});
}

std::string paintedTrees(FeatureFamily family) {
  return trainClassifier(paintedSet({family, true}), {.trees = true})->toJson();
}

TEST(BuildingClassifier, OfTreesIsTheSameAfterReading) {
  for (const FeatureFamily family : {FeatureFamily::Handmap, FeatureFamily::Equalized}) {
    const std::string text = paintedTrees(family);
    EXPECT_NE(text.find("\"version\":3"), std::string::npos);
    EXPECT_TRUE(BuildingClassifier::parse(text, "model.json").toJson() == text);
  }
}

TEST(BuildingClassifier, RefusesDamagedTrees) {
  const std::string whole = paintedTrees(FeatureFamily::Equalized);
  const auto trees = whole.find("\"trees\":[");
  ASSERT_NE(trees, std::string::npos);
  const std::string head = whole.substr(0, trees);
  const auto with = [&](const std::string& nodes) { return head + "\"trees\":" + nodes + "}"; };
  EXPECT_NO_THROW(BuildingClassifier::parse(with("[[0,1,2,-1,1,0,-1,-1,0]]"), "model.json"));
  for (const auto& [nodes, words] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"[]", {"trees", "at least one tree"}},
           {"[[]]", {"trees[0]: found 0 numbers"}},
           {"[[-1,1]]", {"trees[0]: found 2 numbers"}},
           {"[[61,1,2,-1,1,0,-1,-1,0]]", {"trees[0][0]"}},  // no such feature
           {"[[0,1,3,-1,1,0,-1,-1,0]]", {"trees[0][2]"}},   // no such node
           {"[[0,1,1,-1,1,0,-1,-1,0]]", {"trees[0][2]"}},   // both ways to one
           {"[[0,1,0,-1,1,0,-1,-1,0]]", {"trees[0][2]"}},   // round in a circle
           {"[[0,1,2,-1,1,0,0,-1,2]]", {"trees[0][8]"}},    // a branch at the end
           {"[[0,1e99,2,-1,1,0,-1,-1,0]]", {"trees[0][1]"}}}) {
    test::expectBadInput(
        [&, &nodes = nodes] { BuildingClassifier::parse(with(nodes), "model.json"); }, words);
  }
}

}  // namespace
}  // namespace handmap
