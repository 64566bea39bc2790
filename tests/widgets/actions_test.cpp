// The table of actions, the icons and the colours.
#include <QActionGroup>
#include <QMenuBar>
#include <QPalette>
#include <QTest>
#include <QToolBar>
#include <set>

#include "widgets/actions/action_set.h"
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
    QCOMPARE(titles, (QStringList{"&File", "&Edit", "&View", "&Draw", "&Run", "&Help"}));
    QCOMPARE(entries, qsizetype(actionTable().size()));
    QToolBar tools;
    actions.fillToolBar(tools, ToolBar::Tools);
    QCOMPARE(tools.actions().size(), 6);
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
    QVERIFY(shortcutSheet().contains("Ctrl+S"));
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
