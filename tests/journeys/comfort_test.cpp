// What makes the window easy to learn: tour, commands, keys, light and dark, names for everybody.
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSlider>

#include <gtest/gtest.h>

#include "app/gui/files/file_actions.h"
#include "app/gui/files/template_menu.h"
#include "core/map/map_io.h"
#include "tests/journeys/scripted_dialogs.h"
#include "tests/journeys/window_test.h"
#include "widgets/actions/action_set.h"
#include "widgets/style/colours.h"

namespace handmap {
namespace {

class Comfortable : public WindowTest {
 protected:
  void SetUp() override {
    ASSERT_TRUE(TemplateMenu::folder().contains("qttest"));  // not that of a person
    QDir(TemplateMenu::folder()).removeRecursively();
    auto dialogs = std::make_unique<ScriptedDialogs>();
    dialogs_ = dialogs.get();
    window_ = std::make_unique<MainWindow>(document_, settings_, std::move(dialogs));
    window_->show();
  }
  void TearDown() override {
    QApplication::setPalette(QPalette());
    document_.undoStack().setClean();
  }
  void trigger(const QString& id) { window_->findChild<QAction*>(id)->trigger(); }
  QString newest() const {
    const auto messages = window_->messages().messages();
    return messages.isEmpty() ? QString() : messages.front()->text();
  }
  bool press(const QString& text) {
    for (const Message* message : window_->messages().messages())
      for (auto* button : message->findChildren<QPushButton*>())
        if (button->text() == text) return button->click(), true;
    return false;
  }
  void write(const QString& name, const Map& map) const { writeMap(map, path(name).toStdString()); }
  static Map mapNamed(const char* name) {
    Map map;
    map.name = name;
    return map;
  }

  ScriptedDialogs* dialogs_ = nullptr;
  std::unique_ptr<MainWindow> window_;
};

bool isForPeople(const QWidget& widget) {
  const bool is_input =
      qobject_cast<const QAbstractButton*>(&widget) || qobject_cast<const QLineEdit*>(&widget) ||
      qobject_cast<const QComboBox*>(&widget) || qobject_cast<const QAbstractSpinBox*>(&widget) ||
      qobject_cast<const QSlider*>(&widget) || qobject_cast<const QAbstractItemView*>(&widget);
  // Parts of another input, and what the window system's own widgets bring along.
  const QWidget* parent = widget.parentWidget();
  const bool is_part =
      widget.objectName().startsWith("qt_") || qobject_cast<const QAbstractSpinBox*>(parent) ||
      qobject_cast<const QComboBox*>(parent) || qobject_cast<const QLineEdit*>(parent) ||
      widget.inherits("QComboBoxListView") || widget.inherits("QHeaderView") ||
      widget.inherits("QTableCornerButton") || (parent && parent->inherits("QKeySequenceEdit"));
  return is_input && !is_part;
}

TEST_F(Comfortable, EverythingHasANameForThoseWhoDoNotSee) {
  int looked_at = 0;
  for (QWidget* widget : window_->findChildren<QWidget*>()) {
    if (!isForPeople(*widget)) continue;
    ++looked_at;
    QAccessibleInterface* face = QAccessible::queryAccessibleInterface(widget);
    ASSERT_NE(face, nullptr);
    QString where;
    for (const QWidget* at = widget; at; at = at->parentWidget())
      where += QString("/%1[%2]").arg(at->metaObject()->className(), at->objectName());
    EXPECT_FALSE(face->text(QAccessible::Name).isEmpty()) << where.toStdString();
  }
  EXPECT_GT(looked_at, 60);
}

TEST_F(Comfortable, TheTourHasFiveStepsAndEnds) {
  trigger("help.tour");
  auto* tour = window_->findChild<QWidget*>("tour");
  auto* next = window_->findChild<QPushButton*>("tour_next");
  QStringList titles;
  while (tour->isVisible() && titles.size() < 9) {
    titles << tour->findChild<QLabel*>()->text();
    EXPECT_TRUE(window_->rect().contains(tour->geometry())) << titles.last().toStdString();
    next->click();
  }
  EXPECT_EQ(titles.size(), 5);
  EXPECT_EQ(QSet<QString>(titles.begin(), titles.end()).size(), 5);
  trigger("help.tour");
  QTest::keyClick(tour, Qt::Key_Escape);
  EXPECT_FALSE(tour->isVisible());
}

TEST_F(Comfortable, LightAndDarkAreChosenAndKept) {
  const auto shows = [this](const Colours& colours) {
    return QTest::qWaitFor([&] { return &Colours::of(window_->palette()) == &colours; }, 2000);
  };
  trigger("view.theme_dark");
  EXPECT_TRUE(shows(Colours::dark()));
  window_ = std::make_unique<MainWindow>(document_, settings_);
  EXPECT_TRUE(window_->findChild<QAction*>("view.theme_dark")->isChecked());
  EXPECT_TRUE(shows(Colours::dark()));
  trigger("view.theme_light");
  EXPECT_TRUE(shows(Colours::light()));
  trigger("view.theme_system");
  EXPECT_EQ(QApplication::palette().resolveMask(), QPalette().resolveMask());
}

TEST_F(Comfortable, AnotherLanguageStartsAgainWithTheSameDrawing) {
  QStringList opened;
  window_->files().setWindowOpener([&](const QStringList& arguments) {
    opened << (arguments.isEmpty() ? QStringList{QString()} : arguments);
  });
  write("m.handmap", mapNamed("first"));
  ASSERT_TRUE(window_->files().open(path("m.handmap")));
  document_.setName("mine");
  trigger("view.language_ja");
  EXPECT_EQ(settings_.value("view/language").toString(), "ja");
  EXPECT_TRUE(press("Start again"));
  EXPECT_TRUE(window_->isVisible()) << "the question was cancelled";
  EXPECT_TRUE(opened.isEmpty());
  EXPECT_TRUE(document_.isModified());

  trigger("view.language_system");
  EXPECT_EQ(settings_.value("view/language").toString(), "system");
  dialogs_->choices = {0};  // save
  EXPECT_TRUE(press("Start again"));
  EXPECT_FALSE(window_->isVisible());
  EXPECT_EQ(opened, QStringList{path("m.handmap")});
  EXPECT_EQ(readMap(path("m.handmap").toStdString()).name, "mine");
}

TEST_F(Comfortable, StartingAgainEndsARunAndForgetsWhatWasNeverSaved) {
  QStringList opened;
  window_->files().setWindowOpener([&](const QStringList& arguments) {
    opened << (arguments.isEmpty() ? QStringList{QString()} : arguments);
  });
  runSimulator(*window_);
  EXPECT_TRUE(waitFor(*window_, RunState::Running));
  document_.setName("never saved");
  trigger("view.language_ja");
  dialogs_->choices = {1};  // discard
  EXPECT_TRUE(press("Start again"));
  EXPECT_FALSE(window_->isVisible());
  EXPECT_EQ(window_->run().state(), RunState::Idle);
  EXPECT_EQ(opened, QStringList{QString()});
}

TEST_F(Comfortable, AnotherWindowIsOpenedByWhoeverKnowsHow) {
  QStringList opened;
  window_->files().setWindowOpener([&](const QStringList& arguments) {
    opened << (arguments.isEmpty() ? QStringList{QString()} : arguments);
  });
  trigger("file.new_window");
  EXPECT_EQ(opened, QStringList{QString()});
}

TEST_F(Comfortable, ADrawingBeginsWithATemplateAndCanBecomeOne) {
  const auto entries = [&] {
    for (QMenu* menu : window_->findChildren<QMenu*>()) {
      if (menu->title() != "New fro&m Template") continue;
      Q_EMIT menu->aboutToShow();
      return menu->actions();
    }
    return QList<QAction*>();
  };
  ASSERT_EQ(entries().size(), 3);
  for (int i = 0; i < 3; ++i) {
    entries()[i]->trigger();
    EXPECT_GE(document_.map().buildings.size(), 5u);
    EXPECT_TRUE(document_.map().start.has_value());
    EXPECT_TRUE(document_.filePath().isEmpty());
    EXPECT_FALSE(document_.isModified());
  }
  const Map campus = document_.map();
  dialogs_->paths = {TemplateMenu::folder() + "/Mine.handmap"};
  trigger("file.keep_template");
  ASSERT_EQ(entries().size(), 5) << "with a separator";
  trigger("file.new");
  entries().last()->trigger();
  EXPECT_EQ(document_.map(), campus);
}

TEST_F(Comfortable, AFileThatAnotherProgramChangesIsNoticed) {
  write("m.handmap", mapNamed("first"));
  ASSERT_TRUE(window_->files().open(path("m.handmap")));
  document_.setName("mine");
  ASSERT_TRUE(window_->files().save());
  QTest::qWait(500);
  EXPECT_TRUE(newest().isEmpty()) << "own work is no news: " << newest().toStdString();

  write("m.handmap", mapNamed("theirs"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return newest().contains("Another program"); }, 5000));
  EXPECT_EQ(document_.map().name, "mine");
  ASSERT_TRUE(press("Keep mine"));
  EXPECT_TRUE(document_.isModified());

  write("m.handmap", mapNamed("theirs again"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return newest().contains("unsaved changes here"); }, 5000));
  ASSERT_TRUE(press("Reload"));
  EXPECT_EQ(document_.map().name, "theirs again");
  EXPECT_FALSE(document_.isModified());

  QFile::remove(path("m.handmap"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return newest().contains("is gone"); }, 5000));
}

}  // namespace
}  // namespace handmap
