#include "drivers/rosbridge/bounded_message.h"

#include <QCborArray>
#include <QCborValue>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/random.h"
#include "drivers/rosbridge/fragments.h"
#include "drivers/rosbridge/ros_value.h"

namespace handmap {
namespace {

MessageLimits small() {
  MessageLimits limits;
  limits.bytes = 1000;
  limits.depth = 5;
  limits.values = 50;
  return limits;
}

QByteArray nestedJson(int depth) {
  return "{\"a\":" + QByteArray(depth - 1, '[') + QByteArray(depth - 1, ']') + "}";
}

QByteArray nestedCbor(int depth) {
  return QByteArray::fromHex("a16161") + QByteArray(depth - 2, '\x81') + QByteArray(1, '\x80');
}

TEST(BoundedMessage, WhatIsWithinTheLimitsIsRead) {
  EXPECT_EQ(parseJsonMessage(R"({"op":"a\"[[[[[[[[","x":[1,2.5,null]})", small()).size(), 2);
  EXPECT_TRUE(parseJsonMessage(nestedJson(5), small()).contains(QLatin1String("a")));
  EXPECT_TRUE(parseCborMessage(nestedCbor(5), small()).contains(QLatin1String("a")));
}

TEST(BoundedMessage, DepthSizeAndCountAreBounded) {
  EXPECT_THROW(parseJsonMessage(nestedJson(6), small()), Error);
  EXPECT_THROW(parseCborMessage(nestedCbor(6), small()), Error);
  EXPECT_THROW(parseJsonMessage(nestedJson(1'000'000)), Error);
  EXPECT_THROW(parseCborMessage(nestedCbor(1'000'000)), Error);
  EXPECT_THROW(parseJsonMessage("{\"a\":\"" + QByteArray(1000, 'x') + "\"}", small()), Error);
  EXPECT_THROW(
      parseJsonMessage("{\"a\":[" + QByteArray(60, '1').replace("1", "1,") + "1]}", small()),
      Error);
  EXPECT_THROW(parseCborMessage(QByteArray::fromHex("a16161983c") + QByteArray(60, '\1'), small()),
               Error);
  EXPECT_THROW(parseCborMessage(QByteArray(10'000'000, '\xc1')), Error);  // tags of tags
}

TEST(BoundedMessage, OtherThingsAreRefusedWithAWord) {
  for (const char* text : {"", "[]", "{", "nonsense", "1", "{\"a\":}", "{\"a\":NaN}"}) {
    try {
      parseJsonMessage(text);
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("expected a JSON object"), std::string::npos);
    }
  }
  // Nothing, a list, a map that is cut off, lengths that no memory has.
  for (const char* hex : {"", "80", "a161", "bbffffffffffffffff", "a1617a5bffffffffffffffff",
                          "a161617affffffff", "ff", "bf6161"}) {
    EXPECT_THROW(parseCborMessage(QByteArray::fromHex(hex)), Error) << hex;
  }
}

TEST(BoundedMessage, NoiseIsRefusedOrRead) {
  RandomStream random(11);
  for (int i = 0; i < 20'000; ++i) {
    QByteArray bytes = QByteArray::fromHex("a2626f70677075626c697368636d7367");
    for (int k = random.index(40); k > 0; --k) bytes += static_cast<char>(random());
    try {
      parseCborMessage(bytes);
    } catch (const Error&) {
    }
  }
}

TEST(RosValue, PathsAreNamed) {
  const QCborMap map = parseJsonMessage(R"({"pose":{"x":[1,"two"]}})");
  try {
    RosValue(map, "/odom").at("pose").at("x").items(10)[1].number(0, 1);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "/odom: pose.x[1]: found \"two\", expected a number");
  }
}

TEST(RosValue, TypedArraysOfEveryKindAreRead) {
  const auto numbers = [](int tag, const char* hex) {
    return RosValue(QCborValue(static_cast<QCborTag>(tag), QByteArray::fromHex(hex)), "t")
        .numbers(8);
  };
  EXPECT_EQ(numbers(64, "01ff"), (std::vector<double>{1, 255}));           // uint8
  EXPECT_EQ(numbers(69, "0100ffff"), (std::vector<double>{1, 65535}));     // uint16, little-endian
  EXPECT_EQ(numbers(65, "0001"), (std::vector<double>{1}));                // uint16, big-endian
  EXPECT_EQ(numbers(72, "ff"), (std::vector<double>{-1}));                 // int8
  EXPECT_EQ(numbers(78, "feffffff"), (std::vector<double>{-2}));           // int32, little-endian
  EXPECT_EQ(numbers(85, "0000803f"), (std::vector<double>{1.0}));          // float, little-endian
  EXPECT_EQ(numbers(81, "3f800000"), (std::vector<double>{1.0}));          // float, big-endian
  EXPECT_EQ(numbers(86, "000000000000f03f"), (std::vector<double>{1.0}));  // double
  EXPECT_THROW(numbers(85, "000080"), Error);
  EXPECT_THROW(numbers(80, "0000"), Error);  // half precision
  EXPECT_THROW(numbers(63, "00"), Error);
  EXPECT_THROW(numbers(64, "000102030405060708"), Error);  // one more than asked for
}

QCborMap fragment(const char* id, int number, int total, const char* data) {
  return {{QLatin1String("id"), QLatin1String(id)},
          {QLatin1String("num"), number},
          {QLatin1String("total"), total},
          {QLatin1String("data"), QLatin1String(data)}};
}

TEST(Fragments, PiecesOfSeveralMessagesInAnyOrder) {
  Fragments fragments;
  const auto add = [&](const char* id, int number, int total, const char* data) {
    return fragments.add(RosValue(fragment(id, number, total, data), "fragment"));
  };
  EXPECT_FALSE(add("a", 2, 3, "c"));
  EXPECT_FALSE(add("b", 1, 2, "y"));
  EXPECT_FALSE(add("a", 0, 3, "a"));
  EXPECT_FALSE(add("a", 0, 3, "a"));  // twice
  EXPECT_EQ(add("a", 1, 3, "b"), QByteArray("abc"));
  EXPECT_EQ(add("b", 0, 2, "x"), QByteArray("xy"));
  EXPECT_EQ(fragments.abandoned(), 0);
  EXPECT_THROW(add("c", 3, 3, ""), Error);
  EXPECT_THROW(add("c", 0, 2'000'000, ""), Error);
}

TEST(Fragments, MemoryIsBounded) {
  Fragments fragments(100);
  for (int i = 0; i < 50; ++i) {
    EXPECT_FALSE(
        fragments.add(RosValue(fragment(std::to_string(i).c_str(), 0, 2, "x"), "fragment")));
  }
  EXPECT_EQ(fragments.abandoned(), 42);
  EXPECT_THROW(fragments.add(RosValue(fragment("z", 0, 2, std::string(98, 'x').c_str()), "f")),
               Error);
  EXPECT_EQ(fragments.add(RosValue(fragment("w", 0, 1, "whole"), "f")), QByteArray("whole"));
}

}  // namespace
}  // namespace handmap
