#include "widgets/background/background.h"

#include <QStringList>
#include <QTest>
#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include "widgets/background/time_left.h"

namespace handmap {
namespace {

class Ear : public QObject {
 public:
  Ear() : self_(std::make_shared<Lifeline<Ear>>(*this)) {}
  ~Ear() override { self_->cut(); }
  std::shared_ptr<Lifeline<Ear>> lifeline() const { return self_; }
  QStringList heard;

 private:
  std::shared_ptr<Lifeline<Ear>> self_;
};

TEST(Background, WhatIsPostedIsHeardInOrderInTheOwnersThread) {
  Ear ear;
  const auto here = std::this_thread::get_id();
  startInBackground([line = ear.lifeline(), here] {
    for (int i = 0; i < 3; ++i) {
      line->post([i, here](Ear& owner) {
        EXPECT_EQ(std::this_thread::get_id(), here);
        owner.heard << QString::number(i);
      });
    }
  });
  ASSERT_TRUE(QTest::qWaitFor([&] { return ear.heard.size() == 3; }));
  EXPECT_EQ(ear.heard, (QStringList{"0", "1", "2"}));
}

TEST(Background, NothingIsHeardOfWhoIsLetGo) {
  std::atomic<bool> go_on = false;
  std::atomic<int> posted = 0;
  auto ear = std::make_unique<Ear>();
  bool heard = false;
  startInBackground([line = ear->lifeline(), &go_on, &posted, &heard] {
    line->post([&heard](Ear&) { heard = true; });
    ++posted;
    while (!go_on) std::this_thread::yield();
    line->post([&heard](Ear&) { heard = true; });
    ++posted;
  });
  while (posted == 0) std::this_thread::yield();
  ear.reset();  // the first is queued, the second is not yet said
  EXPECT_FALSE(waitForBackground(std::chrono::milliseconds(1)));
  go_on = true;
  EXPECT_TRUE(waitForBackground(std::chrono::seconds(30)));
  EXPECT_EQ(posted, 2);
  QTest::qWait(10);
  EXPECT_FALSE(heard);
}

TEST(TimeLeft, IsToldOnceEnoughIsDone) {
  TimeLeft left;
  left.update(0.0, 100.0);
  EXPECT_FALSE(left.seconds());
  left.update(0.2, 100.5);
  EXPECT_FALSE(left.seconds());
  left.update(0.25, 105.0);
  ASSERT_TRUE(left.seconds());
  EXPECT_NEAR(*left.seconds(), 15.0, 1e-9);
  EXPECT_TRUE(left.inWords().contains("15")) << left.inWords().toStdString();
  left.update(0.5, 700.0);
  EXPECT_TRUE(left.inWords().contains("minute")) << left.inWords().toStdString();
  left.update(0.1, 701.0);  // other work
  EXPECT_FALSE(left.seconds());
  EXPECT_TRUE(left.inWords().isEmpty());
}

}  // namespace
}  // namespace handmap
