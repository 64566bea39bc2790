#include <QComboBox>
#include <QLineEdit>
#include <QTableView>

#include <gtest/gtest.h>

#include "widgets/run/panels/log_panel.h"

namespace handmap {
namespace {

class LogTest : public testing::Test {
 protected:
  LogTest() {
    panel_.model().add({{}, LogKind::Note, "The run begins", {}});
    panel_.model().add({1.5, LogKind::Warning, "Frame 15 was skipped: dark", {}});
    panel_.model().add({2.5, LogKind::Warning, "L3 is doubtful", "L3"});
    panel_.model().add({3.5, LogKind::Problem, "The disk is full", {}});
  }
  int shown() { return table().model()->rowCount(); }
  QTableView& table() { return *panel_.findChild<QTableView*>(); }

  LogPanel panel_;
};

TEST_F(LogTest, IsFilteredByWordsAndByHowBadItIs) {
  EXPECT_EQ(shown(), 4);
  panel_.findChild<QComboBox*>()->setCurrentIndex(1);
  EXPECT_EQ(shown(), 3);
  panel_.findChild<QLineEdit*>()->setText("DOUBT");
  EXPECT_EQ(shown(), 1);
  panel_.findChild<QLineEdit*>()->clear();
  panel_.findChild<QComboBox*>()->setCurrentIndex(2);
  EXPECT_EQ(shown(), 1);
}

TEST_F(LogTest, IsCopiedAsText) {
  EXPECT_EQ(panel_.text().split('\n')[1], "1.5\tWarning\tFrame 15 was skipped: dark");
  table().selectRow(3);
  EXPECT_EQ(panel_.text(), "3.5\tProblem\tThe disk is full\n");
}

TEST_F(LogTest, ARowLeadsToItsTimeAndItsBuilding) {
  double time_s = 0.0;
  QString building;
  QObject::connect(&panel_, &LogPanel::timeChosen, &panel_, [&](double at) { time_s = at; });
  QObject::connect(&panel_, &LogPanel::showRequested, &panel_,
                   [&](const QString& id) { building = id; });
  Q_EMIT table().activated(table().model()->index(0, 0));
  EXPECT_EQ(time_s, 0.0) << "it has none";
  Q_EMIT table().activated(table().model()->index(2, 0));
  EXPECT_EQ(time_s, 2.5);
  EXPECT_EQ(building, "L3");
}

TEST_F(LogTest, IsBounded) {
  for (std::size_t i = 0; i < LogModel::kMostEntries; ++i) {
    panel_.model().add({0.1 * static_cast<double>(i), LogKind::Note, "more", {}});
  }
  EXPECT_EQ(panel_.model().rowCount(), static_cast<int>(LogModel::kMostEntries));
  EXPECT_EQ(panel_.model().dropped(), 4);
  EXPECT_EQ(shown(), static_cast<int>(LogModel::kMostEntries));
  EXPECT_EQ(panel_.model().entry(0).text, "more");
}

}  // namespace
}  // namespace handmap
