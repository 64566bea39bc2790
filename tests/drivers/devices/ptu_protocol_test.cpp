#include "drivers/pan_tilt/ptu_protocol.h"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/base/text.h"

namespace handmap {
namespace {

using State = PtuProtocol::State;

TEST(PtuReplies, AnswersRefusalsAndLimitsAreToldApart) {
  PtuReplies replies;
  const auto told = replies.feed(
      "PP * 12!P34\r\nTP9999 ! Maximum allowable Tilt position is 604\r\n"
      "\r\n!T*\r\n");
  ASSERT_EQ(told.size(), 5U);
  EXPECT_EQ(told[0].kind, PtuReply::Kind::PanLimit);
  EXPECT_EQ(told[1].number(), 1234.0);
  EXPECT_EQ(told[2].kind, PtuReply::Kind::Refused);
  EXPECT_EQ(told[2].text, "Maximum allowable Tilt position is 604");
  EXPECT_EQ(told[3].kind, PtuReply::Kind::TiltLimit);
  EXPECT_EQ(told[4].kind, PtuReply::Kind::Done);
  EXPECT_EQ(told[4].number(), std::nullopt);
}

TEST(PtuReplies, NumbersOfTheVerboseFormAreFound) {
  PtuReplies replies;
  const auto told = replies.feed(
      "* Current Pan position is -12\r\n* 92.5714 seconds arc per position"
      "\n* 1 2\n* v2.12 (C)2003\n");
  ASSERT_EQ(told.size(), 4U);
  EXPECT_EQ(told[0].number(), -12.0);
  EXPECT_EQ(told[1].number(), 92.5714);
  EXPECT_EQ(told[2].number(), std::nullopt);
  EXPECT_EQ(told[3].number(), std::nullopt);
}

TEST(PtuReplies, ALineWithoutEndTakesNoMemoryAndIsDropped) {
  PtuReplies replies;
  EXPECT_TRUE(replies.feed("* " + std::string(1'000'000, '7') + "\r\n").empty());
  EXPECT_EQ(replies.feed("* 7\r\n").size(), 1U);
}

/// A head in a few lines, so that the protocol is seen without ports and clocks.
class Head {
 public:
  std::map<std::string, std::string> answers = {
      {"V", "* v2 head"}, {"PR", "* 92.5714"}, {"TR", "* 46.2857"}, {"PN", "* -6000"},
      {"PX", "* 6000"},   {"TN", "* -1800"},   {"TX", "* 1200"},    {"PL", "* 57"},
      {"PU", "* 2902"},   {"TL", "* 57"},      {"TU", "* 2902"},    {"PP", "* 0"},
      {"TP", "* 0"}};
  std::vector<std::string> commands;

  /// Answers until neither has anything to say.
  void talk(PtuProtocol& protocol, double now_s = 0.0) {
    for (std::string out = protocol.takeOutput(); !out.empty(); out = protocol.takeOutput()) {
      for (const std::string_view word : splitWords(out))
        answer(protocol, std::string(word), now_s);
    }
  }

 private:
  void answer(PtuProtocol& protocol, const std::string& word, double now_s) {
    commands.push_back(word);
    const bool position = word.starts_with("PP") || word.starts_with("TP");
    if (position && word.size() > 2) answers[word.substr(0, 2)] = "* " + word.substr(2);
    protocol.feed((answers.contains(word) ? answers[word] : "*") + "\r\n", now_s);
  }
};

void makeReady(PtuProtocol& protocol, Head& head) {
  protocol.start(0.0);
  head.talk(protocol);
}

TEST(PtuProtocol, AsksTheHeadBeforeItIsReady) {
  Head head;
  PtuProtocol protocol;
  makeReady(protocol, head);
  EXPECT_EQ(protocol.state(), State::Ready) << protocol.detail();
  EXPECT_EQ(protocol.pan().resolution_arcsec, 92.5714);
  EXPECT_EQ(protocol.tilt().least, -1800.0);
  const std::vector<std::string> first(head.commands.begin(), head.commands.begin() + 3);
  EXPECT_EQ(first, (std::vector<std::string>{"ED", "FT", "V"}));
  EXPECT_EQ(std::count(head.commands.begin(), head.commands.end(), "DS"), 0);
}

TEST(PtuProtocol, SpeedsStayWithinWhatTheHeadAllows) {
  for (const auto& [speed, expected] : {std::pair(1e9, "PS2902"), std::pair(1e-9, "PS57")}) {
    Head head;
    PtuOptions options;
    options.speed = speed;
    PtuProtocol protocol(options);
    makeReady(protocol, head);
    EXPECT_EQ(std::count(head.commands.begin(), head.commands.end(), expected), 1) << expected;
  }
}

TEST(PtuProtocol, MovesByTheResolutionThatTheHeadToldAndConfirms) {
  Head head;
  PtuProtocol protocol;
  makeReady(protocol, head);
  head.commands.clear();
  protocol.lookAt({toRadians(60.0), toRadians(-10.0)}, 1.0);
  EXPECT_EQ(protocol.state(), State::Moving);
  head.talk(protocol, 1.0);
  const std::vector<std::string> expected = {"PP2333", "TP-778", "A", "PP", "PP", "TP", "TP"};
  EXPECT_EQ(head.commands, expected);
  const auto arrival = protocol.takeArrival();
  ASSERT_TRUE(arrival);
  EXPECT_NEAR(arrival->pan, toRadians(60.0), toRadians(0.03));
  EXPECT_NEAR(arrival->tilt, toRadians(-10.0), toRadians(0.03));
  EXPECT_EQ(protocol.state(), State::Ready);
}

TEST(PtuProtocol, BeyondTheLimitsIsAsFarAsTheyAllow) {
  Head head;
  PtuProtocol protocol;
  makeReady(protocol, head);
  protocol.lookAt({toRadians(170.0), toRadians(80.0)}, 1.0);
  head.talk(protocol, 1.0);
  const auto arrival = protocol.takeArrival();
  ASSERT_TRUE(arrival);
  EXPECT_NEAR(arrival->pan, protocol.pan().angleOf(6000), 1e-9);
  EXPECT_NEAR(arrival->tilt, protocol.tilt().angleOf(1200), 1e-9);
}

TEST(PtuProtocol, WhatIsNoAngleMovesNothing) {
  Head head;
  PtuProtocol protocol;
  makeReady(protocol, head);
  protocol.lookAt({std::nan(""), 0.0}, 1.0);
  EXPECT_EQ(protocol.state(), State::Ready);
  EXPECT_EQ(protocol.takeOutput(), "");
}

TEST(PtuProtocol, HeadsThatCannotBeAreRefused) {
  for (const auto& [command, answer] :
       {std::pair("PR", "* 0"), std::pair("TX", "* -5000"), std::pair("PN", "* -1e300"),
        std::pair("TU", "* -3"), std::pair("PX", "* nan")}) {
    Head head;
    head.answers[command] = answer;
    PtuProtocol protocol;
    makeReady(protocol, head);
    for (double now = 0.1; now < 300.0 && protocol.state() != State::Failed; now += 0.1) {
      protocol.tick(now);
      head.talk(protocol, now);
    }
    EXPECT_EQ(protocol.state(), State::Failed) << command;
    EXPECT_FALSE(protocol.detail().empty());
  }
}

TEST(PtuProtocol, AHeadThatSaysNothingFails) {
  PtuProtocol protocol;
  protocol.start(0.0);
  for (double now = 0.0; now < 120.0; now += 0.1) protocol.tick(now);
  EXPECT_EQ(protocol.state(), State::Failed);
}

// Whatever comes over the wire: no command but the known ones goes out, and no position beyond the
// limits.
TEST(PtuProtocol, NoiseMakesItSendNothingUnknown) {
  RandomStream random(7);
  const std::string_view alphabet = "*!PT 0123456789.-\r\nE";
  for (int round = 0; round < 200; ++round) {
    PtuProtocol protocol;
    protocol.start(0.0);
    std::string sent;
    for (double now = 0.0; now < 40.0; now += 0.25) {
      std::string noise;
      for (int i = 0; i < 30; ++i) noise += alphabet[static_cast<std::size_t>(random.index(20))];
      if (random.uniform() < 0.2) protocol.lookAt({random.normal(), random.normal()}, now);
      if (random.uniform() < 0.1) protocol.halt(now);
      protocol.feed(noise, now);
      protocol.tick(now);
      sent += protocol.takeOutput();
    }
    for (const std::string_view word : splitWords(sent)) {
      const std::string_view known =
          "ED FT V PR TR PN PX TN TX PL PU TL TU CI LE I PS TS PP TP A H R";
      const std::string_view name = word.substr(0, word.find_first_of("-0123456789"));
      EXPECT_NE(known.find(name), std::string_view::npos) << word;
      EXPECT_TRUE(name == word || parseInteger(word.substr(name.size()))) << word;
    }
  }
}

}  // namespace
}  // namespace handmap
