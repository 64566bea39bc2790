// Unsaved work outlives its session.
#include "widgets/recovery/recovery.h"

#include <QFile>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "app/gui/files/recovery_offer.h"
#include "core/base/error.h"
#include "core/recording/image_file.h"
#include "widgets/document/map_document.h"
#include "widgets/messages/message_bar.h"
#include "widgets/teach/teach_panel.h"

namespace handmap {
namespace {

constexpr int kRecoveryPatienceMs = 20'000;

Building house(double x) {
  Building building;
  building.shape = Rectangle{{x, 0.0}, 10.0, 5.0, 0.0};
  return building;
}

/// All that a session has; it crashes when it is destroyed.
struct Session {
  Session(const QString& settings_file, const QStringList& folders)
      : settings(settings_file, QSettings::IniFormat),
        recovery(document, teach, settings, {.delay_ms = 0, .folders = folders}) {}

  bool hasKept() {
    settings.sync();
    const auto is_there = [this](const QString& key) {
      return std::ranges::any_of(settings.value(key).toStringList(),
                                 [](const QString& file) { return QFile::exists(file); });
    };
    return QTest::qWaitFor(
        [&] {
          return std::ranges::any_of(settings.allKeys().filter("recovery_sessions"), is_there);
        },
        kRecoveryPatienceMs);
  }

  MapDocument document;
  TeachPanel teach;
  QSettings settings;
  Recovery recovery;
};

class RecoveryTest : public testing::Test {
 protected:
  QString path(const QString& name) const { return folder_.filePath(name); }
  std::unique_ptr<Session> session(const QStringList& folders) {
    return std::make_unique<Session>(path("settings.ini"), folders);
  }
  std::unique_ptr<Session> session() { return session({path("kept")}); }

  /// A session that draws `buildings`, and crashes.
  Map leaveBehind(const QString& project, int buildings) {
    const auto crashing = session();
    crashing->document.reset({}, project);
    const qsizetype before = crashing->settings.allKeys().size();
    for (int i = 0; i < buildings; ++i) crashing->document.addBuilding(house(20.0 * i));
    EXPECT_TRUE(QTest::qWaitFor([&] { return crashing->settings.allKeys().size() > before; },
                                kRecoveryPatienceMs));
    return crashing->document.map();
  }
  QStringList recoveryFiles(const QString& folder) const {
    return QDir(folder).entryList({"*.recovery"});
  }

  QTemporaryDir folder_;
};

TEST_F(RecoveryTest, AnUnsavedChangeOutlivesACrash) {
  const Map drawn = leaveBehind(path("street.handmap"), 2);
  EXPECT_FALSE(QFile::exists(path("street.handmap"))) << "never the file itself";
  EXPECT_EQ(recoveryFiles(folder_.path()).size(), 1);
  const auto next = session();
  const auto left = next->recovery.takeLeftBehind();
  ASSERT_EQ(left.size(), 1U);
  const UnsavedWork work = readWork(left.front().file);
  EXPECT_EQ(work.name(), "street.handmap");
  EXPECT_LT(std::abs(work.written.secsTo(QDateTime::currentDateTimeUtc())), 60);
  next->recovery.recover(left.front(), work);
  EXPECT_EQ(next->document.map(), drawn);
  EXPECT_EQ(next->document.filePath(), path("street.handmap"));
  EXPECT_TRUE(next->document.isModified());
  next->document.save(next->document.filePath());
  EXPECT_TRUE(QTest::qWaitFor([&] { return recoveryFiles(folder_.path()).isEmpty(); }));
  EXPECT_TRUE(session()->recovery.takeLeftBehind().empty());
}

TEST_F(RecoveryTest, ADrawingThatWasNeverSavedIsKeptToo) {
  const Map drawn = leaveBehind({}, 1);
  const auto next = session();
  const auto left = next->recovery.takeLeftBehind();
  ASSERT_EQ(left.size(), 1U);
  next->recovery.recover(left.front(), readWork(left.front().file));
  EXPECT_EQ(next->document.map(), drawn);
  EXPECT_TRUE(next->document.filePath().isEmpty());
  EXPECT_TRUE(next->document.isModified());
}

TEST_F(RecoveryTest, ALivingSessionIsNotOffered) {
  const auto living = session();
  living->document.addBuilding(house(0.0));
  ASSERT_TRUE(living->hasKept());
  const auto second = session();
  EXPECT_TRUE(second->recovery.takeLeftBehind().empty());
}

TEST_F(RecoveryTest, WhatOneWindowOffersNoOtherDoes) {
  leaveBehind({}, 1);
  const auto one = session();
  const auto other = session();
  auto offered = one->recovery.takeLeftBehind();
  EXPECT_EQ(offered.size(), 1U);
  EXPECT_TRUE(other->recovery.takeLeftBehind().empty());
  offered.clear();  // put off
  EXPECT_EQ(other->recovery.takeLeftBehind().size(), 1U);
}

TEST_F(RecoveryTest, WhatWasRecoveredOutlivesTheNextCrash) {
  const Map drawn = leaveBehind({}, 3);
  {
    const auto next = session();
    const auto left = next->recovery.takeLeftBehind();
    ASSERT_EQ(left.size(), 1U);
    next->recovery.recover(left.front(), readWork(left.front().file));
  }  // and crashes at once
  const auto third = session();
  const auto left = third->recovery.takeLeftBehind();
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(readWork(left.front().file).map, drawn);
}

TEST_F(RecoveryTest, NothingIsKeptOfWhatIsSavedOrTakenBack) {
  const auto here = session();
  here->document.addBuilding(house(0.0));
  ASSERT_TRUE(here->hasKept());
  here->document.undoStack().undo();
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return recoveryFiles(path("kept")).isEmpty(); }, kRecoveryPatienceMs));
}

TEST_F(RecoveryTest, AnotherFolderIsTriedAndSaidOnce) {
  QFile in_the_way(path("no-folder"));
  ASSERT_TRUE(in_the_way.open(QIODevice::WriteOnly));
  const auto here = session({path("no-folder") + "/below", path("kept")});
  QSignalSpy told(&here->recovery, &Recovery::cannotKeep);
  for (int i = 0; i < 3; ++i) {
    here->document.addBuilding(house(20.0 * i));
    ASSERT_TRUE(here->hasKept());
    QTest::qWait(20);
  }
  ASSERT_EQ(told.size(), 1);
  EXPECT_TRUE(told[0][0].toString().contains("no-folder")) << told[0][0].toString().toStdString();
  EXPECT_TRUE(told[0][1].toString().startsWith(path("kept")));

  const auto nowhere = session({path("no-folder") + "/below"});
  QSignalSpy lost(&nowhere->recovery, &Recovery::cannotKeep);
  nowhere->document.addBuilding(house(0.0));
  ASSERT_TRUE(lost.wait(kRecoveryPatienceMs));
  EXPECT_TRUE(lost[0][1].toString().isEmpty());
}

TEST_F(RecoveryTest, IsInTheSettingsBeforeItsFileIsThere) {
  QFile in_the_way(path("no-folder"));
  ASSERT_TRUE(in_the_way.open(QIODevice::WriteOnly));
  const auto here = session({path("no-folder") + "/below"});
  QSignalSpy lost(&here->recovery, &Recovery::cannotKeep);
  here->document.addBuilding(house(0.0));
  ASSERT_TRUE(lost.wait(kRecoveryPatienceMs)) << "there is never a file";
  here->settings.sync();
  EXPECT_EQ(here->settings.allKeys().filter("recovery_sessions").size(), 1);
  EXPECT_TRUE(session()->recovery.takeLeftBehind().empty());
}

TEST_F(RecoveryTest, TheSettingsKnowAllPlacesOfAFileThatMoves) {
  writePng(cv::Mat(48, 64, CV_8UC3, cv::Scalar(9, 9, 9)), path("photo.png").toStdString());
  const auto here = session();
  here->teach.resize(900, 700);
  here->teach.openImages({path("photo.png")});
  const auto paint = [&](int row) {
    QTest::mouseClick(&here->teach.view(), Qt::LeftButton, {},
                      here->teach.view().centreOf(row, 1).toPoint());
  };
  paint(1);
  ASSERT_TRUE(here->hasKept());
  ASSERT_TRUE(QDir().mkdir(path("project")));
  here->document.reset({}, path("project/street.handmap"));  // what was painted is still to be kept
  paint(2);
  const auto places = [&] {
    here->settings.sync();
    const QStringList keys = here->settings.allKeys().filter("recovery_sessions");
    return keys.size() == 1 ? here->settings.value(keys.front()).toStringList() : QStringList();
  };
  ASSERT_TRUE(QTest::qWaitFor([&] { return places().size() == 3; }, kRecoveryPatienceMs));
  EXPECT_EQ(places().filter("untitled").size(), 1);
  EXPECT_EQ(places().filter("street").size(), 2) << "beside its project, else in the usual folder";
  here->recovery.clear();
  EXPECT_TRUE(places().isEmpty());
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return recoveryFiles(path("kept")).isEmpty(); }, kRecoveryPatienceMs));
}

TEST_F(RecoveryTest, AFolderThatIsGoneIsNotMadeAnew) {
  const auto here = session();
  here->document.reset({}, path("unplugged/street.handmap"));
  here->document.addBuilding(house(0.0));
  ASSERT_TRUE(here->hasKept());
  EXPECT_FALSE(QFile::exists(path("unplugged")));
  EXPECT_EQ(recoveryFiles(path("kept")).size(), 1);
}

TEST_F(RecoveryTest, PaintingIsKeptAndRecovered) {
  writePng(cv::Mat(48, 64, CV_8UC3, cv::Scalar(9, 9, 9)), path("photo.png").toStdString());
  Teaching painted;
  {
    const auto crashing = session();
    crashing->teach.resize(900, 700);
    crashing->teach.openImages({path("photo.png"), path("missing.png")});
    EXPECT_FALSE(crashing->teach.hasUnsavedWork()) << "nothing is painted";
    QTest::mouseClick(&crashing->teach.view(), Qt::LeftButton, {},
                      crashing->teach.view().centreOf(1, 1).toPoint());
    ASSERT_TRUE(crashing->hasKept());
    painted = crashing->teach.teaching();
    EXPECT_EQ(painted.images.at(0).labels.size(), 12U);
  }
  const auto next = session();
  const auto left = next->recovery.takeLeftBehind();
  ASSERT_EQ(left.size(), 1U);
  const UnsavedWork work = readWork(left.front().file);
  EXPECT_FALSE(work.modified);
  next->recovery.recover(left.front(), work);
  EXPECT_EQ(next->teach.teaching(), painted);
  EXPECT_EQ(next->teach.view().labels(), painted.images.at(0).labels);
  EXPECT_TRUE(next->teach.hasUnsavedWork());
  EXPECT_FALSE(next->document.isModified());
}

TEST_F(RecoveryTest, EverySessionIsOfferedOneAfterAnother) {
  leaveBehind(path("a.handmap"), 1);
  leaveBehind(path("b.handmap"), 2);
  const auto next = session();
  QWidget window;
  MessageBar messages;
  RecoveryOffer offer(window, messages, next->recovery, [] { return true; });
  const auto press = [&](const QString& text) {
    for (auto* button : messages.messages().first()->findChildren<QPushButton*>()) {
      if (button->text() == text) return button->click();
    }
    ADD_FAILURE() << "no " << text.toStdString();
  };
  offer.look();
  offer.look();
  ASSERT_EQ(messages.messages().size(), 1);
  const QString first = messages.messages().first()->text();
  EXPECT_TRUE(first.contains(".handmap")) << first.toStdString();
  EXPECT_TRUE(first.contains("building")) << first.toStdString();
  press("Disc&ard");
  ASSERT_EQ(messages.messages().size(), 1);
  EXPECT_NE(messages.messages().first()->text(), first);
  press("Re&cover");
  EXPECT_TRUE(messages.messages().isEmpty());
  EXPECT_TRUE(next->document.isModified());
  EXPECT_EQ(recoveryFiles(folder_.path()).size(), 1);
}

TEST_F(RecoveryTest, ATornFileIsToldAndStaysUntilSomebodyDeletesIt) {
  leaveBehind({}, 1);
  QFile file(path("kept/") + recoveryFiles(path("kept")).first());
  ASSERT_TRUE(file.resize(40));
  const auto next = session();
  QWidget window;
  MessageBar messages;
  RecoveryOffer offer(window, messages, next->recovery, [] { return true; });
  offer.look();
  ASSERT_EQ(messages.messages().size(), 1);
  EXPECT_TRUE(messages.messages().first()->text().contains("cannot be read"));
  EXPECT_TRUE(file.exists());
  messages.messages().first()->findChild<QPushButton*>()->click();
  EXPECT_FALSE(file.exists());
  EXPECT_TRUE(messages.messages().isEmpty());
}

TEST_F(RecoveryTest, ForeignFilesAreRefused) {
  for (const char* text :
       {"{}", R"({"format":"handmap","version":1})", R"({"format":"handmap-recovery","version":2})",
        R"({"format":"handmap-recovery","version":1,"modified":true,"teaching":[],"map":{}})",
        R"({"format":"handmap-recovery","version":1,"modified":true,
            "teaching":[{"path":"a","labels":"9999999999b"}],
            "map":{"format":"handmap","version":1,"buildings":[]}})",
        R"({"format":"handmap-recovery","version":1,"modified":true,
            "teaching":[{"path":"a","labels":"3x"}],
            "map":{"format":"handmap","version":1,"buildings":[]}})"}) {
    QFile file(path("foreign.recovery"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    file.close();
    EXPECT_THROW(readWork(file.fileName()), Error) << text;
  }
}

}  // namespace
}  // namespace handmap
