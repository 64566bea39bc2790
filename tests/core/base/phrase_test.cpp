#include "core/base/phrase.h"

#include <map>

#include <gtest/gtest.h>

namespace handmap {
namespace {

std::string translated(const char* english) {
  static const std::map<std::string, std::string> kTranslations = {
      {"found {}, expected {}", "expected {1}, found {0}"},
      {"{} of {}", "{} {} {}"},
      {"{} metres", "{:q} m"},
  };
  const auto found = kTranslations.find(english);
  return found == kTranslations.end() ? english : found->second;
}

class Phrases : public testing::Test {
 protected:
  Phrases() { translatePhrases(translated); }
  ~Phrases() override { translatePhrases(nullptr); }
};

TEST(Phrase, IsEnglishWithoutATranslator) {
  EXPECT_EQ(phrase("found {}, expected {:.1f}", "a", 2.0), "found a, expected 2.0");
}

TEST_F(Phrases, ATranslationMayHaveAnotherOrder) {
  EXPECT_EQ(phrase("found {}, expected {}", 1, "2"), "expected 2, found 1");
  EXPECT_EQ(phrase("not translated: {}", 1), "not translated: 1");
}

TEST_F(Phrases, ATranslationThatDoesNotFitIsPassedOver) {
  EXPECT_EQ(phrase("{} of {}", 1, 2), "1 of 2");
  EXPECT_EQ(phrase("{} metres", 3), "3 metres");
}

}  // namespace
}  // namespace handmap
