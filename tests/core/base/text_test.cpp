#include "core/base/text.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/core/base/comma_locale.h"
#include "tests/core/base/expect_error.h"
#include "tests/core/base/temporary_folder.h"

namespace handmap {
namespace {

using test::expectBadInput;
using test::TemporaryFolder;

TEST(Text, ParsesFiniteNumbersThatFillTheText) {
  EXPECT_EQ(parseFinite("1.5"), 1.5);
  EXPECT_EQ(parseFinite(" -2e3\t"), -2000.0);
  EXPECT_EQ(parseFinite("+0.25"), 0.25);
  for (const char* bad : {"", " ", "1.5x", "1,5", "nan", "inf", "-inf", "1e999", "0x10", "--1",
                          "+-1", "1 2", "++1"}) {
    EXPECT_FALSE(parseFinite(bad)) << bad;
  }
}

TEST(Text, ParsesIntegers) {
  EXPECT_EQ(parseInteger("42"), 42);
  EXPECT_EQ(parseInteger("-7"), -7);
  for (const char* bad : {"", "1.0", "1e3", "9223372036854775808", "a", "+-3"}) {
    EXPECT_FALSE(parseInteger(bad)) << bad;
  }
}

TEST(Text, FormattedNumbersReadBackAsTheSame) {
  const double values[] = {0.1,   1.0 / 3.0,           -1e-300,
                           1e300, 123456789.123456789, std::numeric_limits<double>::denorm_min()};
  for (std::size_t i = 0; i + 1 < std::size(values); ++i) {
    EXPECT_EQ(parseFinite(formatNumber(values[i])), values[i]);
  }
  EXPECT_EQ(formatNumber(0.1), "0.1");
  EXPECT_EQ(formatNumber(40.0), "40");
}

TEST(Text, NumbersDoNotFollowTheLocale) {
  const test::CommaLocale comma;
  EXPECT_EQ(parseFinite("1.5"), 1.5);
  EXPECT_FALSE(parseFinite("1,5"));
  EXPECT_EQ(formatNumber(1.5), "1.5");
  EXPECT_EQ(formatNumber(1234567.0), "1234567");
}

TEST(Text, SplitsFieldsAndWords) {
  EXPECT_EQ(splitFields(" a,, b ", ','), (std::vector<std::string_view>{"a", "", "b"}));
  EXPECT_EQ(splitFields("", ','), std::vector<std::string_view>{""});
  EXPECT_EQ(splitFields("a,", ','), (std::vector<std::string_view>{"a", ""}));
  EXPECT_EQ(splitWords("  1 2\t 3 \r"), (std::vector<std::string_view>{"1", "2", "3"}));
  EXPECT_TRUE(splitWords(" \t").empty());
}

TEST(Text, ContentLinesSkipCommentsAndKeepNumbers) {
  ContentLines lines("\xef\xbb\xbf# head\r\nfirst\r\n\n  # more\n last ");
  const auto first = lines.next();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->number, 2);
  EXPECT_EQ(first->text, "first");
  const auto last = lines.next();
  ASSERT_TRUE(last);
  EXPECT_EQ(last->number, 5);
  EXPECT_EQ(last->text, "last");
  EXPECT_FALSE(lines.next());
  EXPECT_FALSE(ContentLines("").next());
}

TEST(Text, ReadsWholeFilesWithinTheLimit) {
  const TemporaryFolder folder;
  const std::string content("a\0b\n", 4);
  const auto path = folder.write("file", content);
  EXPECT_EQ(readFile(path, 4), content);
  expectBadInput([&] { readFile(path, 3); }, {path.string(), "4 bytes", "at most 3"});
  expectBadInput([&] { readFile(folder.path() / "none", 9); }, {"none", "no such file"});
  expectBadInput([&] { readFile(folder.path(), 9); }, {folder.path().string(), "no regular file"});
}

TEST(Text, KnowsWhichPathsStayInside) {
  EXPECT_TRUE(staysInside("image_0/000001.png"));
  EXPECT_TRUE(staysInside("a..b/c"));
  EXPECT_FALSE(staysInside("/etc/passwd"));
  EXPECT_FALSE(staysInside("../x"));
  EXPECT_FALSE(staysInside("a/../../x"));
}

TEST(Error, NamesFilePlaceFoundAndExpected) {
  expectBadInput([] { throwBadInput("f", "line 3", "x", "y"); },
                 {"f: line 3: found x, expected y"});
  expectBadInput([] { throwBadInput("f", "", "x", "y"); }, {"f: found x, expected y"});
}

}  // namespace
}  // namespace handmap
