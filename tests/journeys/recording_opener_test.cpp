#include "app/gui/run/recording_opener.h"

#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

#include "core/simulation/simulated_source.h"
#include "widgets/background/background.h"

namespace handmap {
namespace {

class RecordingOpenerTest : public testing::Test {
 protected:
  RecordingOpenerTest() {
    for (const char* name : {"one", "two"}) {
      auto source = simulate(twoRowWorld(2), {}, 2);
      RecordingWriter writer(path(name).toStdString(), source->info());
      writer.add(source->next().value());
    }
    QObject::connect(&opener_, &RecordingOpener::opened, &opener_, [this](const auto& recording) {
      heard_ << QString::fromStdString(recording->folder.filename().string());
    });
    QObject::connect(&opener_, &RecordingOpener::failed, &opener_,
                     [this](const Failure& failure) { heard_ << failure.message; });
    QObject::connect(&opener_, &RecordingOpener::simulated, &opener_,
                     [this](const Robot& robot) { heard_ << robot.name; });
  }
  QString path(const QString& name) const { return folder_.filePath(name); }
  /// All that comes of what was asked for.
  QStringList heard() {
    EXPECT_TRUE(waitForBackground(std::chrono::seconds(30)));
    QTest::qWait(5);
    return heard_;
  }

  QTemporaryDir folder_;
  RecordingOpener opener_;
  QStringList heard_;
};

TEST_F(RecordingOpenerTest, OpensARecording) {
  opener_.open(path("one"));
  EXPECT_EQ(heard(), QStringList{"one"});
}

TEST_F(RecordingOpenerTest, DoubtsPointsInMillimetresAndReadsThemAgain) {
  auto source = simulate(twoRowWorld(2), {}, 2);
  RecordingWriter writer(path("far").toStdString(), source->info());
  while (auto observation = source->next()) {
    for (View& view : observation->views) {
      for (RangePoint& p : *view.points) p = {1000 * p.x, 1000 * p.y, 1000 * p.z, p.w};
    }
    writer.add(*observation);
  }
  std::vector<Doubts> doubts;
  std::shared_ptr<const Recording> recording;
  QObject::connect(&opener_, &RecordingOpener::opened, &opener_,
                   [&](const auto& opened, const auto&, const Doubts& told) {
                     recording = opened;
                     doubts.push_back(told);
                   });
  opener_.open(path("far"));
  EXPECT_EQ(heard().size(), 1);
  ASSERT_EQ(doubts.size(), 1U);
  ASSERT_EQ(doubts[0].size(), 1U);
  EXPECT_EQ(doubts[0][0].remedy->name, "Read the points as millimetres");
  opener_.readAgain(recording, *doubts[0][0].remedy, {});
  heard();
  ASSERT_EQ(doubts.size(), 2U);
  EXPECT_TRUE(doubts[1].empty());
}

TEST_F(RecordingOpenerTest, TellsWhatAnImportTookForGranted) {
  auto log = std::make_shared<Log>();
  for (int i = 0; i < 3; ++i) log->scans.push_back({0.1 * i, {{5.0F, 1.0F, 0.0F, 1.0F}}});
  std::vector<std::string> told;
  QObject::connect(&opener_, &RecordingOpener::opened, &opener_,
                   [&](const auto&, const auto&, const auto&, const auto& notes) { told = notes; });
  opener_.import(log, path("imported"));
  EXPECT_EQ(heard(), QStringList{"imported"});
  EXPECT_EQ(told, std::vector<std::string>{"no poses: the scans are to tell the motion"});
}

TEST_F(RecordingOpenerTest, TellsWhatIsWrongWithAFolder) {
  opener_.open(path("nowhere"));
  ASSERT_EQ(heard().size(), 1);
  EXPECT_TRUE(heard_[0].contains("nowhere")) << heard_[0].toStdString();
}

TEST_F(RecordingOpenerTest, TheLatestWinsAndWhatIsForgottenIsNotHeard) {
  opener_.open(path("nowhere"));
  opener_.open(path("one"));
  opener_.open(path("two"));
  EXPECT_EQ(heard(), QStringList{"two"});
  opener_.open(path("one"));
  opener_.forget();
  EXPECT_EQ(heard(), QStringList{"two"});
}

TEST_F(RecordingOpenerTest, AWorldOfADrawingIsForgottenWithTheDrawing) {
  opener_.simulate(twoRowWorld(2).map, 2);
  EXPECT_EQ(heard(), QStringList{"Simulator: this drawing"});
  opener_.simulate(twoRowWorld(2).map, 2);
  opener_.forgetSimulation();
  EXPECT_EQ(heard(), QStringList{"Simulator: this drawing"});
  opener_.open(path("one"));
  opener_.forgetSimulation();
  EXPECT_EQ(heard_, QStringList{"Simulator: this drawing"}) << "it comes later";
  EXPECT_EQ(heard(), (QStringList{"Simulator: this drawing", "one"}));
}

TEST_F(RecordingOpenerTest, TellsWhyADrawingMakesNoWorld) {
  opener_.simulate({}, 2);
  ASSERT_EQ(heard().size(), 1);
  EXPECT_TRUE(heard_[0].contains("start")) << heard_[0].toStdString();
}

}  // namespace
}  // namespace handmap
