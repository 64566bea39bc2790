#include "core/base/json.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/core/base/expect_error.h"

namespace handmap {
namespace {

using test::expectBadInput;

TEST(Json, SyntaxErrorsNameLineAndColumn) {
  expectBadInput([] { parseJson("{\n  \"a\": 1,\n  oops\n}", "f.json"); },
                 {"f.json: line 3, column 3", "no valid JSON"});
  expectBadInput([] { parseJson("", "f"); }, {"f: line 1, column 1"});
  expectBadInput([] { parseJson("[1, 2", "f"); }, {"f: line 1, column 6"});
  expectBadInput([] { parseJson("\"\xff\"", "f"); }, {"f: line 1"});
  expectBadInput([] { parseJson("[1e999]", "f"); }, {"f: line 1: [0]: found a number too large"});
  expectBadInput([] { parseJson("{\n\"a\": [0,\n-1e999\n]}", "f"); },
                 {"f: line 3: a[1]: found a number too large to represent"});
  expectBadInput([] { parseJson("\n\n1e999", "f"); }, {"f: line 3: found a number too large"});
  expectBadInput([] { parseJson("{} {}", "f"); }, {"f: line 1, column 4"});
}

TEST(Json, RefusesDoubledKeysNamingTheirPath) {
  expectBadInput([] { parseJson(R"({"a": [0, {"b": {"c": 1, "d": 2, "c": 3}}]})", "f"); },
                 {"f: a[1].b.c: ", "twice"});
  EXPECT_NO_THROW(parseJson(R"({"a": {"a": 1}, "b": [{"a": 1}, {"a": 1}]})", "f"));
}

TEST(Json, BoundsNestingAndCount) {
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + std::string(depth, ']');
  };
  EXPECT_NO_THROW(parseJson(nested(64), "f"));
  expectBadInput([&] { parseJson(nested(65), "f"); }, {"nesting"});
  expectBadInput([&] { parseJson(std::string(1'000'000, '['), "f"); }, {"nesting"});
  std::string many = "[0";
  for (int i = 0; i < 8'000'000; ++i) many += ",0";
  expectBadInput([&] { parseJson(many + "]", "f"); }, {"more than 8000000 values"});
}

class Values : public ::testing::Test {
 protected:
  const nlohmann::json json_ = parseJson(
      R"({"n": 2.5, "i": 3, "big": 18446744073709551615, "s": "text", "b": true,
          "list": [1, {"x": null}], "zero": 0})",
      "f");
  const JsonValue value_{json_, "f"};
};

TEST_F(Values, ReadsWhatIsAsked) {
  EXPECT_EQ(value_.at("n").number(0.0, 3.0), 2.5);
  EXPECT_EQ(value_.at("i").number(0.0, 3.0), 3.0);
  EXPECT_EQ(value_.at("i").positive(3.0), 3.0);
  EXPECT_EQ(value_.at("i").integer(1, 3), 3);
  EXPECT_EQ(value_.at("s").text(4), "text");
  EXPECT_TRUE(value_.at("b").flag());
  EXPECT_EQ(value_.at("list").items(2).size(), 2u);
  EXPECT_FALSE(value_.find("none"));
  EXPECT_EQ(value_.textOr("none", 9, "else"), "else");
}

TEST_F(Values, MessagesNamePathFoundAndExpected) {
  expectBadInput([&] { value_.at("none"); }, {"f: none: found nothing, expected this key"});
  expectBadInput([&] { value_.at("list").items(2)[1].at("x").number(0, 1); },
                 {"f: list[1].x: found null, expected a number from 0 to 1"});
  expectBadInput([&] { value_.at("s").positive(5); },
                 {"f: s: found \"text\" (string), expected a number > 0 and at most 5"});
  expectBadInput([&] { value_.at("zero").positive(5); }, {"found 0"});
  expectBadInput([&] { value_.at("n").number(3.0, 4.0); }, {"found 2.5"});
  expectBadInput([&] { value_.at("n").integer(0, 9); }, {"found 2.5", "whole number from 0 to 9"});
  expectBadInput([&] { value_.at("big").integer(0, INT64_MAX); }, {"18446744073709551615"});
  expectBadInput([&] { value_.at("s").text(3); }, {"a string of 4 bytes", "at most 3"});
  expectBadInput([&] { value_.at("n").flag(); }, {"true or false"});
  expectBadInput([&] { value_.at("n").items(9); }, {"an array"});
  expectBadInput([&] { value_.at("list").items(1); },
                 {"f: list: found an array of 2, expected at most 1"});
  expectBadInput([&] { value_.at("list").at("x"); }, {"found an array of 2, expected an object"});
}

TEST_F(Values, GivesTheMembersThatAreNotKnown) {
  const auto others = value_.others({"n", "i", "big", "s", "b"});
  EXPECT_EQ(others,
            (std::map<std::string, std::string>{{"list", R"([1,{"x":null}])"}, {"zero", "0"}}));
}

TEST(Json, QuotesAnyBytes) {
  EXPECT_EQ(quotedJson("a\"b\n"), R"("a\"b\n")");
  EXPECT_NO_THROW(parseJson(quotedJson("\xff\xfe"), "f"));
}

TEST(Json, HasOneZero) {
  const auto json = parseJson("[-0.0]", "f");
  EXPECT_FALSE(std::signbit(JsonValue(json, "f").items(1)[0].number(-1.0, 1.0)));
}

}  // namespace
}  // namespace handmap
