// The table of actions, the icons and the colours.
#include <QActionGroup>
#include <QDockWidget>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMainWindow>
#include <QMenuBar>
#include <QPalette>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QToolBar>
#include <QTreeWidget>
#include <set>

#include "widgets/actions/action_set.h"
#include "widgets/actions/command_palette.h"
#include "widgets/actions/fuzzy.h"
#include "widgets/actions/keys_panel.h"
#include "widgets/style/colours.h"
#include "widgets/style/icons.h"

namespace handmap {

class ActionsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyActionIsDeclaredOnceAndWhole() {
    std::set<std::string> ids;
    for (const ActionSpec& spec : actionTable()) {
      QVERIFY2(ids.insert(spec.id).second, spec.id);
      QVERIFY2(*spec.text && *spec.hint, spec.id);
      QVERIFY2(!*spec.icon || !icon(QLatin1String(spec.icon)).isNull(), spec.icon);
      QVERIFY2(spec.tool_bar == ToolBar::None || *spec.icon, spec.id);
    }
  }

  void noKeyDoesTwoThings() {
    QHash<QKeySequence, const char*> owners;
    for (const ActionSpec& spec : actionTable()) {
      if (!*spec.keys) continue;
      for (const QKeySequence& keys : QKeySequence::listFromString(QLatin1String(spec.keys))) {
        QVERIFY2(!keys.isEmpty(), spec.id);
        QVERIFY2(!owners.contains(keys), spec.id);
        owners.insert(keys, spec.id);
      }
    }
    QVERIFY(owners.contains(QKeySequence(QKeySequence::fromString("Ctrl+S"))));
  }

  void menusAndToolBarsComeFromTheTable() {
    const ActionSet actions;
    QMenuBar menus;
    actions.fillMenuBar(menus);
    QStringList titles;
    qsizetype entries = 0;
    for (const QAction* menu : menus.actions()) {
      titles << menu->text();
      for (const QAction* action : menu->menu()->actions()) entries += !action->isSeparator();
    }
    QCOMPARE(titles,
             (QStringList{"&File", "&Edit", "&Arrange", "&View", "&Draw", "&Run", "&Help"}));
    QCOMPARE(entries, qsizetype(actionTable().size()));
    QToolBar tools;
    actions.fillToolBar(tools, ToolBar::Tools);
    QCOMPARE(tools.actions().size(), 11);
  }

  void actionsCallTheirHandlersAndToolsExclude() {
    const ActionSet actions;
    int saved = 0;
    actions.on("file.save", this, [&] { ++saved; });
    actions["file.save"].trigger();
    QCOMPARE(saved, 1);
    actions["draw.select"].trigger();
    actions["draw.polygon"].trigger();
    QVERIFY(actions["draw.polygon"].isChecked() && !actions["draw.select"].isChecked());
    actions.setEnabled({"run.pause", "run.stop"}, false);
    QVERIFY(!actions["run.stop"].isEnabled() && actions["run.run"].isEnabled());
  }

  void aDisabledActionSaysWhy() {
    const ActionSet actions;
    actions.setEnabled({"edit.undo"}, false, "nothing has been changed");
    QVERIFY(actions["edit.undo"].toolTip().contains("nothing has been changed"));
    QCOMPARE(actions.whyNot("edit.undo"), QString("nothing has been changed"));
    actions.setEnabled({"edit.undo"}, true, "nothing has been changed");
    QVERIFY(!actions["edit.undo"].toolTip().contains("nothing"));
    QVERIFY(actions.whyNot("edit.undo").isEmpty());
  }

  void lettersInOrderFindACommand() {
    QVERIFY(fuzzyScore("zf", "Zoom to Fit") > fuzzyScore("zf", "Organize files"));
    QVERIFY(fuzzyScore("rect", "Rectangle") > fuzzyScore("rect", "Read text"));
    QVERIFY(fuzzyScore("ZOOM IN", "Zoom In").has_value());
    QVERIFY(!fuzzyScore("xq", "Zoom In"));
    QVERIFY(!fuzzyScore("ni z", "Zoom In"));  // out of order
    QVERIFY(!fuzzyScore("a", ""));
    QCOMPARE(fuzzyScore("", "Zoom In"), std::optional(0));
    QVERIFY(fuzzyScore("開", "ファイルを開く"));
  }

  /// A run that ends brings its panel while a command is being typed.
  void thePaletteStaysOnTopOfAWindowThatIsLaidOutAnew() {
    QMainWindow window;
    auto* middle = new QWidget;
    window.setCentralWidget(middle);
    auto* one = new QDockWidget(&window);
    auto* other = new QDockWidget(&window);
    window.addDockWidget(Qt::RightDockWidgetArea, one);
    window.addDockWidget(Qt::RightDockWidgetArea, other);
    window.tabifyDockWidget(one, other);
    other->hide();
    const ActionSet actions;
    CommandPalette palette(actions, window);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    palette.open();
    other->show();
    other->raise();
    middle->raise();  // as its layout does where there is room to be animated
    const auto is_on_top = [&] {
      return window.children().indexOf(&palette) > window.children().indexOf(middle);
    };
    QTRY_VERIFY(is_on_top());
  }

  void thePaletteRunsWhatIsTyped() {
    QWidget window;
    window.resize(700, 500);
    const ActionSet actions;
    CommandPalette palette(actions, window);
    window.show();
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    int fitted = 0;
    actions.on("view.zoom_fit", this, [&] { ++fitted; });
    palette.open();
    for (const auto* list = palette.findChild<QListWidget*>(); int row : {0, 1, 2, 3, 4, 5, 6, 7})
      QVERIFY2(!list->item(row)->icon().isNull(), "all texts begin alike");
    auto* typed = window.findChild<QLineEdit*>("command");
    QTRY_VERIFY(typed->hasFocus());
    QTest::keyClicks(typed, "zofit");
    QTest::keyClick(typed, Qt::Key_Return);
    QTRY_COMPARE(fitted, 1);
    QVERIFY(!palette.isVisible());
    actions.setEnabled({"view.zoom_fit"}, false, "there is nothing");
    palette.open();
    QTest::keyClicks(typed, "zofit");
    auto* list = window.findChild<QListWidget*>();
    QVERIFY(list->item(0)->text().contains("there is nothing"));
    typed->clear();
    QTest::keyClicks(typed, "qqqqzz");
    QCOMPARE(list->count(), 1);
    QVERIFY(list->item(0)->text().contains("qqqqzz"));
    QTest::keyClick(typed, Qt::Key_Escape);
    QVERIFY(!palette.isVisible());
    QCOMPARE(fitted, 1);
  }

  void whatCannotBeDoneIsNotTakenForSomethingElse() {
    QWidget window;
    window.resize(700, 500);
    const ActionSet actions;
    CommandPalette palette(actions, window);
    window.show();
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    int accepted = 0;
    actions.on("run.accept", this, [&] { ++accepted; });
    actions.setEnabled({"file.export_report"}, false, "no run has ended");
    palette.open();
    auto* typed = window.findChild<QLineEdit*>("command");
    QTRY_VERIFY(typed->hasFocus());
    QTest::keyClicks(typed, "report");  // in this order also letters of "Run: Accept Correction"
    const auto* list = window.findChild<QListWidget*>();
    QVERIFY2(list->item(0)->text().contains("no run has ended"), qPrintable(list->item(0)->text()));
    QTest::keyClick(typed, Qt::Key_Return);
    QTest::qWait(20);
    QCOMPARE(accepted, 0);
    QVERIFY(palette.isVisible());
  }

  void keysAreChangedKeptAndNeverShared() {
    const ActionSet actions;
    KeysPanel panel(actions);
    panel.show();
    auto* tree = panel.findChild<QTreeWidget*>("keys");
    auto* edit = panel.findChild<QKeySequenceEdit*>("edit_keys");
    auto* take = panel.findChild<QPushButton*>("take_keys");
    const auto choose = [&](const QString& id) {
      for (QTreeWidgetItemIterator it(tree); *it; ++it)
        if ((*it)->data(0, Qt::UserRole).toString() == id) tree->setCurrentItem(*it);
    };
    const QKeySequence free("Ctrl+Alt+J");
    choose("file.save");
    edit->setKeySequence(free);
    Q_EMIT edit->editingFinished();
    QCOMPARE(actions["file.save"].shortcut(), free);
    QVERIFY(actions["file.save"].toolTip().contains("Ctrl+Alt+J"));
    choose("file.open");
    edit->setKeySequence(free);
    Q_EMIT edit->editingFinished();
    QCOMPARE(actions["file.open"].shortcut(), QKeySequence("Ctrl+O"));  // said, not done
    QVERIFY(panel.findChild<QLabel*>("clash")->text().contains("Save"));
    take->click();
    QCOMPARE(actions["file.open"].shortcut(), free);
    QVERIFY(actions["file.save"].shortcut().isEmpty());

    QTemporaryDir folder;
    QSettings settings(folder.filePath("keys.ini"), QSettings::IniFormat);
    actions.saveKeys(settings);
    const ActionSet next;
    next.restoreKeys(settings);
    QCOMPARE(next["file.open"].shortcut(), free);
    QVERIFY(next["file.save"].shortcut().isEmpty());
    QCOMPARE(next["file.new"].shortcut(), QKeySequence("Ctrl+N"));
    panel.findChild<QPushButton*>("all_usual_keys")->click();
    for (const ActionSpec& spec : actionTable())
      QCOMPARE(actions.keys(QLatin1String(spec.id)), ActionSet::usualKeys(spec));
  }

  void iconsTakeTheColourOfThePalette() {
    const QIcon run = icon("run");
    const QPalette old = QGuiApplication::palette();
    for (const QColor colour : {QColor(Qt::red), QColor(Qt::white)}) {
      QPalette palette = old;
      palette.setColor(QPalette::ButtonText, colour);
      QGuiApplication::setPalette(palette);
      const QImage image = run.pixmap(24, 24).toImage();
      QCOMPARE(image.pixelColor(11, 12), colour);
      QCOMPARE(image.pixelColor(1, 1).alpha(), 0);
    }
    QGuiApplication::setPalette(old);
    QVERIFY(icon("no-such-icon").isNull());
  }

  void colourIsNeverAlone() {
    for (const Colours* colours : {&Colours::light(), &Colours::dark()}) {
      // What may lie on one another differs in line style or is filled, besides the colour.
      const std::vector<Role> lines = {Role::Drawing,  Role::Corrected, Role::Truth,
                                       Role::Odometry, Role::Route,     Role::Doubtful};
      std::set<std::tuple<int, int, double>> styles;
      for (const Role role : lines) {
        const QPen pen = colours->pen(role);
        QVERIFY(pen.isCosmetic());
        const auto fill = static_cast<int>(colours->brush(role).style());
        QVERIFY(styles.emplace(static_cast<int>(pen.style()), fill, pen.widthF()).second);
      }
      QVERIFY(colours->brush(Role::CorrectedBand).color().alpha() < 128);
      QVERIFY(colours->particle(0.0).alpha() > 0);
      QVERIFY(colours->particle(1.0).alpha() > colours->particle(0.1).alpha());
    }
  }

  void inkIsReadableInLightAndDark() {
    for (const Colours* colours : {&Colours::light(), &Colours::dark()}) {
      const int ground = (*colours)[Role::Background].lightness();
      for (const Role role : {Role::Text, Role::Drawing, Role::Selection, Role::Corrected,
                              Role::Truth, Role::Particle, Role::Odometry, Role::Problem})
        QVERIFY2(std::abs((*colours)[role].lightness() - ground) > 60,
                 qPrintable(QString::number(static_cast<int>(role))));
    }
    QPalette palette;
    palette.setColor(QPalette::Window, Qt::black);
    QCOMPARE(&Colours::of(palette), &Colours::dark());
    palette.setColor(QPalette::Window, Qt::white);
    QCOMPARE(&Colours::of(palette), &Colours::light());
  }
};

}  // namespace handmap

QTEST_MAIN(handmap::ActionsTest)
#include "actions_test.moc"
