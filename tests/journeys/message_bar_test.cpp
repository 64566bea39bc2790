#include "widgets/messages/message_bar.h"

#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include <gtest/gtest.h>

namespace handmap {
namespace {

using Kind = MessageBar::Kind;

class MessageBarTest : public testing::Test {
 protected:
  QStringList texts() const {
    QStringList texts;
    for (const Message* message : bar_.messages()) texts << message->text();
    return texts;
  }
  static void press(Message& message, const QString& text) {
    for (auto* button : message.findChildren<QPushButton*>()) {
      if (button->text() == text) button->click();
    }
  }
  static void close(Message& message) { message.findChild<QToolButton*>("close")->click(); }

  MessageBar bar_;
};

TEST_F(MessageBarTest, ShowsTheNewestOnTopAndNoMoreThanFit) {
  EXPECT_TRUE(bar_.isHidden());
  for (const char* text : {"a", "b", "c", "d", "e"}) bar_.show(Kind::Warning, text);
  EXPECT_EQ(texts(), (QStringList{"e", "d", "c", "b"}));
  EXPECT_FALSE(bar_.isHidden());
  for (Message* message : bar_.messages()) close(*message);
  EXPECT_TRUE(texts().isEmpty());
  EXPECT_TRUE(bar_.isHidden());
}

TEST_F(MessageBarTest, CountsWhatIsSaidAgain) {
  bar_.show(Kind::Error, "It failed.", "Try again.");
  bar_.show(Kind::Error, "It failed.", "Try again.");
  bar_.show(Kind::Error, "It failed.", "Try again.");
  EXPECT_EQ(texts(), QStringList{"It failed.\nTry again. (3 times)"});
  bar_.show(Kind::Warning, "1 frame was skipped", {}, "skipped");
  bar_.show(Kind::Warning, "2 frames were skipped", {}, "skipped");
  EXPECT_EQ(texts().size(), 2);
  EXPECT_EQ(texts().first(), "2 frames were skipped");
}

TEST_F(MessageBarTest, AQuestionStaysUntilItIsAnswered) {
  QString answer;
  bar_.ask("Recover?").addAction("Yes", [&] { answer = "yes"; });
  for (int i = 0; i < 9; ++i) bar_.show(Kind::Error, QString::number(i));
  bar_.clear();
  ASSERT_EQ(texts(), QStringList{"Recover?"});
  press(*bar_.messages().first(), "Yes");
  EXPECT_EQ(answer, "yes");
  EXPECT_TRUE(texts().isEmpty());
}

TEST_F(MessageBarTest, AQuestionIsPutOffByItsCrossAndMayBeAskedAnew) {
  int asked = 0;
  const std::function<void()> ask = [&] {
    ++asked;
    Message& message = bar_.ask("Recover?", {}, "recovery");
    if (asked == 1) QObject::connect(&message, &Message::putOff, &bar_, ask);
  };
  ask();
  close(*bar_.messages().first());
  EXPECT_EQ(asked, 2);
  EXPECT_EQ(texts(), QStringList{"Recover?"});
  bar_.withdraw("recovery");
  EXPECT_TRUE(texts().isEmpty());
}

TEST_F(MessageBarTest, ButtonsGoToTheLatestMessageAndCloseItFirst) {
  bool was_gone = false;
  bar_.show(Kind::Info, "first");
  bar_.show(Kind::Info, "second");
  bar_.addAction("Do", [&] { was_gone = texts() == QStringList{"first"}; });
  EXPECT_TRUE(bar_.messages().last()->findChildren<QPushButton*>().isEmpty());
  press(*bar_.messages().first(), "Do");
  EXPECT_TRUE(was_gone);
  bar_.clear();
  bar_.addAction("Too late", [] {});  // nobody is there to take it
  EXPECT_TRUE(texts().isEmpty());
}

TEST_F(MessageBarTest, WhatHasAButtonDoesNotGoByItself) {
  bar_.show(Kind::Info, "only told");
  EXPECT_TRUE(bar_.messages().first()->findChild<QTimer*>()->isActive());
  bar_.show(Kind::Info, "to be answered").addAction("Do", [] {});
  EXPECT_FALSE(bar_.messages().first()->findChild<QTimer*>()->isActive());
}

}  // namespace
}  // namespace handmap
