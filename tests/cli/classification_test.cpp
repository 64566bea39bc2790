// Teaching what buildings look like, and looking for them.
#include <nlohmann/json.hpp>

#include "core/recording/image_file.h"
#include "tests/cli/program.h"
#include "tests/core/classification/painted_street.h"

namespace handmap {
namespace {

namespace fs = std::filesystem;

class Classification : public CliTest {
 protected:
  Classification() {
    for (const char* folder : {"images", "labels"}) fs::create_directory(folder);
    for (int i = 0; i < 4; ++i) {
      const test::PaintedStreet street = test::paintStreet(static_cast<std::uint64_t>(i));
      const std::string name = std::to_string(i) + ".png";
      writePng(street.image, "images/" + name);
      writePng(street.classes, "labels/" + name);
    }
  }

  static Outcome train(std::vector<std::string> more = {}) {
    std::vector<std::string> words{"train",  "--images", "images", "--labels",
                                   "labels", "--out",    "model"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }

  static void expectRefused(const std::string& err) {
    expectFailed(train(), 2, "handmap-cli: error: " + err);
    EXPECT_FALSE(fs::exists("model"));
  }
};

TEST_F(Classification, IsTaughtAndFindsTheHouse) {
  const Outcome taught = train({"--validate-images", "images", "--validate-labels", "labels"});
  EXPECT_EQ(taught.status, 0);
  EXPECT_EQ(taught.out.find("320 windows, "), 0U) << taught.out;
  EXPECT_NE(taught.out.find("\ncross-validated "), std::string::npos) << taught.out;
  EXPECT_NE(taught.out.find("\nvalidation                  1.000      1.000   1.000  1.000\n"),
            std::string::npos)
      << taught.out;

  const test::PaintedStreet street = test::paintStreet(99);
  writePng(street.image, "street.png");
  const Outcome found = run({"classify", "--model", "model", "street.png", "--json"});
  EXPECT_EQ(found.status, 0);
  const nlohmann::json json = nlohmann::json::parse(found.out);
  EXPECT_EQ(json.at("window"), 16);
  EXPECT_EQ(json.at("columns"), 10);
  EXPECT_EQ(json.at("rows"), 8);
  int right = 0;
  int buildings = 0;
  for (int row = 0; row < 8; ++row) {
    const auto& judgements = json.at("building").at(static_cast<std::size_t>(row));
    for (int column = 0; column < 10; ++column) {
      const bool judged = judgements.at(static_cast<std::size_t>(column)).get<double>() >= 0.5;
      right += judged == (street.classes(16 * row + 8, 16 * column + 8) == test::kBuildingClass);
      buildings += judged;
    }
  }
  EXPECT_GT(right, 75);

  const Outcome shown = run({"classify", "--model", "model", "street.png", "--out", "overlay.png"});
  expectDone(shown, std::to_string(buildings) + " of 80 windows show a building\n");
  const cv::Mat overlay = readImage("overlay.png");
  EXPECT_EQ(overlay.size(), street.image.size());
  EXPECT_GT(cv::norm(overlay, street.image), 0.0);
}

TEST_F(Classification, HasModelsOfItsOwn) {
  writePng(cv::Mat1b(64, 64, std::uint8_t{90}), "grey.png");
  for (const std::string image : {"images/0.png", "grey.png"}) {
    const Outcome found = run({"classify", image});
    EXPECT_EQ(found.status, 0) << found.err;
    EXPECT_NE(found.out.find(" windows show a building\n"), std::string::npos) << found.out;
  }
}

TEST_F(Classification, IsTheSameForTheSameSeed) {
  train({"--features", "paper", "--grey", "--seed", "7"});
  const std::string first = contentOf("model");
  EXPECT_NE(first.find("\"features\":\"paper\",\"colour\":false"), std::string::npos);
  train({"--features", "paper", "--grey", "--seed", "7"});
  EXPECT_EQ(contentOf("model"), first);
}

TEST_F(Classification, RefusesImagesThatCannotTeach) {
  fs::rename("labels/3.png", "labels/other.png");
  expectRefused("labels/3.png: found no such file, expected the labels of 3.png\n");
  writePng(cv::Mat1b(64, 64, std::uint8_t{1}), "labels/3.png");
  expectRefused("labels/3.png: found 64 × 64 pixels, expected 160 × 128 as its image\n");
  writeText("images/0.png", "");
  expectRefused("images/0.png: found an empty file, expected a PNG or JPEG image\n");
  fs::remove_all("images");
  expectRefused("images: found no folder that can be read, expected one with images\n");
}

TEST_F(Classification, RefusesToLearnFromOneClass) {
  expectFailed(train({"--label", "77"}), 2,
               "handmap-cli: error: training images: found 0 windows of buildings, expected at "
               "least 5\n");
  EXPECT_FALSE(fs::exists("model"));
}

TEST_F(Classification, RefusesOtherModelsAndImages) {
  train({"--features", "paper"});
  const auto classify = [](const std::string& image) {
    return run({"classify", "--model", "model", image});
  };
  writePng(cv::Mat1b(64, 64, std::uint8_t{1}), "grey.png");
  expectFailed(classify("grey.png"), 2,
               "handmap-cli: error: grey.png: building classifier: image: found grey, expected "
               "colour, or a model for grey images\n");
  replaceIn("model", "\"version\":2", "\"version\":9");
  expectFailed(classify("images/0.png"), 2,
               "handmap-cli: error: model: version: found 9, expected 2; train the model again\n");
  expectFailed(classify("none.png"), 2,
               "handmap-cli: error: none.png: found no such file, expected a readable file\n");
  expectFailed(run({"classify"}), 1,
               "handmap-cli: error: image is required\n"
               "hint: handmap-cli classify --help\n");
}

TEST_F(Classification, ARunTakesTheModelThatItsMapNames) {
  train({"--features", "paper"});
  ASSERT_EQ(run({"simulate", "--images", "--width", "64", "--height", "64", "--out", "rec"}).status,
            0);
  replaceIn("rec/sketch.handmap", "\"version\": 1,",
            "\"version\": 1, \"handmap:model\": \"../model\",");
  const auto one_stop = [](std::vector<std::string> more) {
    more.insert(more.begin(), {"run", "--map", "rec/sketch.handmap", "--recording", "rec", "--to",
                               "0", "--slam-particles", "5"});
    return run(more);
  };
  // The rendered images are grey and the model is for colours: so it shows that it is asked.
  const Outcome taken = one_stop({"--allow-outside"});
  EXPECT_NE(taken.err.find("found grey, expected colour"), std::string::npos) << taken.err;
  const Outcome other = one_stop({"--model", "none", "--out", "refined.handmap"});
  EXPECT_EQ(other.status, 0) << other.err;
  EXPECT_NE(contentOf("refined.handmap").find("\"handmap:model\": \"model\""), std::string::npos);

  const std::string refused =
      "handmap-cli: error: rec/sketch.handmap: handmap:model: found \"../model\", outside of the "
      "folder of the map, expected a file in that folder\n"
      "hint: put it beside the map, or allow what lies outside (--allow-outside) if you trust the "
      "map\n";
  expectFailed(one_stop({}), 2, refused);
  expectFailed(run({"validate", "rec/sketch.handmap"}), 2, refused);
  expectDone(run({"validate", "rec/sketch.handmap", "--allow-outside"}),
             "ok: rec/sketch.handmap: map of 6 buildings\n");
  fs::remove("model");
  expectFailed(one_stop({"--allow-outside"}), 2,
               "handmap-cli: error: rec/../model: found no such file, expected a readable file\n"
               "hint: the map names this model as its own; --model takes another, or none\n");
}

}  // namespace
}  // namespace handmap
