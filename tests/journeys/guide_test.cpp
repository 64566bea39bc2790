// The guide: every page in both languages, every link and picture there, and the window that shows
// it.
#include <QDir>
#include <QFile>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSet>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextDocument>

#include "app/gui/window/guide_pictures.h"
#include "tests/journeys/window_test.h"
#include "widgets/guide/guide_window.h"

namespace handmap {
namespace {

const QString kGuide = QStringLiteral(HANDMAP_SOURCES "/resources/guide");

QString textOf(const QString& path) {
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
  return QString::fromUtf8(file.readAll());
}

QStringList pagesIn(const QString& language) {
  return QDir(kGuide + '/' + language).entryList({"*.md"});
}

TEST(Guide, HasItsPagesInBothLanguages) {
  QStringList english = pagesIn("en");
  ASSERT_GT(english.size(), 5);
  english.removeAll("results.md");  // tables of figures
  EXPECT_EQ(pagesIn("ja"), english);
}

TEST(Guide, LeadsNowhereInVainAndShowsAllItsPictures) {
  static const QRegularExpression kLink(R"(\]\(([^)#]+)\))");
  QSet<QString> shown;
  QStringList pages{QStringLiteral(HANDMAP_SOURCES "/README.md")};
  for (const char* language : {"en", "ja"}) {
    for (const QString& page : pagesIn(language)) pages << kGuide + '/' + language + '/' + page;
  }
  for (const QString& page : pages) {
    const QDir folder = QFileInfo(page).dir();
    for (auto link = kLink.globalMatch(textOf(page)); link.hasNext();) {
      const QString target = link.next().captured(1);
      if (target.startsWith("http")) continue;
      const QFileInfo file(folder, target);
      EXPECT_TRUE(file.exists()) << page.toStdString() << " leads to " << target.toStdString();
      shown << file.canonicalFilePath();
    }
  }
  for (const char* pictures : {"/pictures", "/en/pictures", "/ja/pictures"}) {
    for (const QFileInfo& picture : QDir(kGuide + pictures).entryInfoList({"*.png"})) {
      EXPECT_TRUE(shown.contains(picture.canonicalFilePath())) << picture.filePath().toStdString();
      EXPECT_LT(picture.size(), 400'000) << picture.filePath().toStdString();
    }
  }
  for (const QString& name : GuidePictures::names()) {
    EXPECT_TRUE(QFile::exists(QStringLiteral("%1/en/pictures/%2.png").arg(kGuide, name)))
        << name.toStdString();
  }
}

/// Marks of Markdown that stand among the words; code may have them.
QStringList marksAmongWords(const QTextDocument& page) {
  QStringList all;
  for (QTextBlock block = page.begin(); block.isValid(); block = block.next()) {
    if (block.blockFormat().hasProperty(QTextFormat::BlockCodeFence)) continue;
    for (auto piece = block.begin(); !piece.atEnd(); ++piece) {
      const QTextFragment words = piece.fragment();
      if (!words.charFormat().fontFixedPitch() && words.text().contains('*')) all << words.text();
    }
  }
  return all;
}

TEST(Guide, NamesEveryKeyOfARecording) {
  for (const char* language : {"en", "ja"}) {
    const QString page = textOf(kGuide + '/' + language + "/own-data.md");
    for (const char* named : {"`format`",      "`version`",       "`name`",
                              "`licence`",     "`range_limit_m`", "`camera`",
                              "`calibration`", "`left`",          "`right`",
                              "`rectified`",   "`mount`",         "`x_m`",
                              "`y_m`",         "`z_m`",           "`pitch_deg`",
                              "`yaw_deg`",     "`frame`",         "`time_s`",
                              "`stop`",        "`pan_deg`",       "`right_time_s`",
                              "`points`",      "`x y z w`",       "`odometry.tum`",
                              "`truth.tum`",   "frames.svg",      "write_recording.py"}) {
      EXPECT_TRUE(page.contains(QLatin1String(named))) << language << ' ' << named;
    }
  }
}

TEST(Guide, ShowsNoMarksOfItsMarkdown) {
  for (const char* language : {"en", "ja"}) {
    for (const QString& name : pagesIn(language)) {
      QTextDocument page;
      page.setMarkdown(textOf(kGuide + '/' + language + '/' + name));
      EXPECT_EQ(marksAmongWords(page), QStringList()) << language << '/' << name.toStdString();
    }
  }
}

TEST(Guide, ReadmeIsReadInFiveMinutes) {
  static const QRegularExpression kBlank(R"(\s+)");
  const QString readme = textOf(QStringLiteral(HANDMAP_SOURCES "/README.md"));
  EXPECT_LE(readme.split(kBlank, Qt::SkipEmptyParts).size(), 1500);
}

class GuideWindowTest : public WindowTest {};

TEST_F(GuideWindowTest, OpensByItsKeyShowsPagesAndGoes) {
  const auto window = open();
  action(*window, "help.guide")->trigger();
  auto* guide = window->findChild<GuideWindow*>();
  ASSERT_TRUE(guide);
  EXPECT_TRUE(guide->isVisible());
  EXPECT_TRUE(guide->browser().toPlainText().contains("Draw the map you remember"));
  for (const QString& page : GuideWindow::pages()) {
    guide->open(page);
    EXPECT_GT(guide->browser().toPlainText().size(), 100) << page.toStdString();
  }
  action(*window, "help.guide")->trigger();
  EXPECT_EQ(window->findChildren<GuideWindow*>().size(), 1);
  QTest::keyClick(guide, Qt::Key_Escape);
  EXPECT_TRUE(QTest::qWaitFor([&] { return window->findChild<GuideWindow*>() == nullptr; }, 5000));
}

TEST_F(GuideWindowTest, FindsThroughAllPages) {
  GuideWindow guide;
  guide.show();
  guide.open("drawing");
  auto* search = guide.findChild<QLineEdit*>();
  search->setText("rosbridge");
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_TRUE(guide.browser().source().path().endsWith("own-robot.md"));
  EXPECT_EQ(guide.browser().textCursor().selectedText().toLower(), "rosbridge");
  guide.open("there is no such page");
  EXPECT_TRUE(guide.browser().source().path().endsWith("index.md"));
}

}  // namespace
}  // namespace handmap
