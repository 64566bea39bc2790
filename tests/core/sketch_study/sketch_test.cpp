#include "core/sketch_study/sketch.h"

#include <fstream>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/sketch_study/figures.h"
#include "tests/core/base/temporary_folder.h"

namespace handmap {
namespace {

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

std::string square(const std::string& key, const std::string& id, int x, int y, int size) {
  return "{\"type\":\"Feature\",\"properties\":{\"" + key + "\":" + id +
         "},\"geometry\":{\"type\":\"Polygon\",\"coordinates\":[[[" + std::to_string(x) + "," +
         std::to_string(y) + "],[" + std::to_string(x) + "," + std::to_string(y + size) + "],[" +
         std::to_string(x + size) + "," + std::to_string(y + size) + "],[" +
         std::to_string(x + size) + "," + std::to_string(y) + "]]]}}";
}

std::string collection(const std::vector<std::string>& features) {
  std::string text = "{\"type\":\"FeatureCollection\",\"features\":[";
  for (const std::string& feature : features)
    text += (&feature == &features[0] ? "" : ",") + feature;
  return text + "]}";
}

std::string group(const std::string& truth, const std::string& drawn, const std::string& kind) {
  return "{\"BaseAlign\":{\"0\":[" + truth + "]},\"SketchAlign\":{\"0\":[" + drawn +
         "]},\"genType\":\"" + kind + "\"}";
}

class AlignedSketch : public testing::Test {
 protected:
  AlignedSketch() {
    write(folder_.path() / "base.geojson",
          collection({square("id", "1", 0, 0, 10), square("id", "2", 100, 0, 10),
                      square("id", "3", 0, 100, 10), square("id", "4", 14, 0, 10),
                      square("id", "5", 200, 200, 10), square("id", "6", 220, 200, 10)}));
    write(folder_.path() / "a.jpg.geojson",
          collection({square("sid", "\"S1\"", 0, 0, 5), square("sid", "\"S2\"", 50, 0, 5),
                      "{\"type\":\"Feature\",\"properties\":{\"sid\":\"S3\"},\"geometry\":{"
                      "\"type\":\"Point\",\"coordinates\":[3,52]}}",
                      square("sid", "\"S4\"", 100, 100, 9), square("sid", "\"S9\"", 70, 70, 5)}));
    write(folder_.path() / "alignment.json",
          "{\"a.jpg\":{\"1\":" + group("1", "\"S1\"", "No generalization") +
              ",\"2\":" + group("2", "\"S2\"", "No generalization") +
              ",\"3\":" + group("3", "\"S3\"", "Collapse") +
              ",\"4\":" + group("5,6", "\"S4\"", "Amalgamation") + ",\"checkAlignnum\":5}}");
  }
  test::TemporaryFolder folder_;
};

TEST_F(AlignedSketch, PairsWhatStandsForWhat) {
  const Sketch sketch =
      readSketch(folder_.path() / "a.jpg.geojson", folder_.path() / "base.geojson");
  const std::vector<SketchPair> pairs = pairsOf(sketch);
  ASSERT_EQ(pairs.size(), 6U);
  EXPECT_EQ(pairs[0].drawn, Vec2(2.5, 2.5));
  EXPECT_EQ(pairs[0].drawn_outline.size(), 4U);
  EXPECT_EQ(pairs[2].drawn, Vec2(3, 52));
  EXPECT_TRUE(pairs[2].drawn_outline.empty());
  EXPECT_FALSE(pairs[3].drawn);
  EXPECT_EQ(extrasOf(sketch), std::vector<std::string>{"S9"});
  EXPECT_EQ(sketch.generalisation, (Generalisation{2, 0, 1}));

  const SketchFigures figures = figuresOf(sketch);
  EXPECT_EQ(figures.drawn, 3);
  EXPECT_DOUBLE_EQ(figures.completeness, 0.5);
  ASSERT_TRUE(figures.euclidean);
  EXPECT_NEAR(figures.euclidean->scaleX(), 0.5, 0.01);
}

TEST_F(AlignedSketch, SaysWhatIsWrong) {
  const auto message = [&] {
    try {
      readSketch(folder_.path() / "a.jpg.geojson", folder_.path() / "base.geojson");
    } catch (const Error& error) {
      return std::string(error.what()).substr(folder_.path().string().size() + 1);
    }
    return std::string();
  };
  write(folder_.path() / "alignment.json", "{\"b.jpg\":{}}");
  EXPECT_EQ(message(), "alignment.json: found \"b.jpg\", expected \"a.jpg\"");
  write(folder_.path() / "alignment.json", "{\"a.jpg\":{}}");
  EXPECT_EQ(message(), "a.jpg.geojson: found nothing that is in " +
                           (folder_.path() / "base.geojson").string() + ", expected the same ids");
}

}  // namespace
}  // namespace handmap
