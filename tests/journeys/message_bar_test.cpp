#include "widgets/messages/message_bar.h"

#include <QLabel>
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

TEST_F(MessageBarTest, ShowsTheNewestAndListsTheOthersWhenAsked) {
  EXPECT_TRUE(bar_.isHidden());
  for (int i = 0; i < 12; ++i) bar_.show(Kind::Error, QString::number(i));
  ASSERT_EQ(texts().size(), 8);
  EXPECT_EQ(texts().first(), "11");
  const auto shown = [this] {
    int count = 0;
    for (const Message* message : bar_.messages()) count += message->isHidden() ? 0 : 1;
    return count;
  };
  EXPECT_EQ(shown(), 1);
  auto* more = bar_.findChild<QToolButton*>("more_messages");
  EXPECT_TRUE(more->text().contains("7")) << more->text().toStdString();
  more->click();
  EXPECT_EQ(shown(), 8);
  more->click();
  EXPECT_EQ(shown(), 1);
  for (Message* message : bar_.messages()) close(*message);
  EXPECT_TRUE(texts().isEmpty());
  EXPECT_TRUE(bar_.isHidden());
}

TEST_F(MessageBarTest, LiesOverTheMapWithoutMovingIt) {
  QWidget map;
  map.resize(500, 400);
  map.show();
  MessageBar over(&map);
  over.show(Kind::Error, QString("A long message that takes more than one line. ").repeated(6));
  EXPECT_EQ(map.size(), QSize(500, 400));
  EXPECT_TRUE(map.rect().contains(over.geometry())) << over.width() << " x " << over.height();
  map.resize(300, 400);
  EXPECT_TRUE(map.rect().contains(over.geometry())) << over.width() << " x " << over.height();
}

TEST_F(MessageBarTest, AButtonMayKeepItsMessage) {
  int looked = 0;
  bar_.show(Kind::Info, "One is doubtful")
      .addAction(
          "Show", [&] { ++looked; }, Message::Then::Stay);
  press(*bar_.messages().first(), "Show");
  press(*bar_.messages().first(), "Show");
  EXPECT_EQ(looked, 2);
  EXPECT_EQ(texts().size(), 1);
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
  EXPECT_FALSE(bar_.messages().last()->isHidden()) << "also behind others";
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

TEST_F(MessageBarTest, ManyButtonsLeaveTheTextItsRoom) {
  bar_.resize(760, 200);
  Message& message = bar_.show(Kind::Info, QString("what was found ").repeated(15));
  for (const char* name : {"B02", "B07", "Review…", "Accept correction"})
    message.addAction(name, [] {});
  QCoreApplication::processEvents();
  const auto* text = message.findChild<QLabel*>("message_text");
  ASSERT_TRUE(text);
  EXPECT_GT(text->width(), 600);
  for (const auto* button : message.findChildren<QPushButton*>())
    EXPECT_GE(button->y(), text->geometry().bottom());
}

}  // namespace
}  // namespace handmap
