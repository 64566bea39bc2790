#include "app/gui/window/comfort.h"

#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QShortcut>

#include "app/gui/files/file_actions.h"
#include "app/gui/shell/docks.h"
#include "app/gui/shell/language.h"
#include "app/gui/shell/theme.h"
#include "app/gui/shell/tour.h"
#include "widgets/actions/action_set.h"
#include "widgets/actions/command_palette.h"
#include "widgets/actions/keys_panel.h"
#include "widgets/guide/guide_window.h"

namespace handmap {

namespace {

std::vector<Tour::Step> stepsOf(const Comfort::Sights& sights) {
  return {
      {&sights.tool_bar, Comfort::tr("Draw"),
       Comfort::tr("Take the rectangle (R) and drag from corner to corner where you remember a "
                   "building. It need not be right: some metres off is fine.")},
      {&sights.canvas, Comfort::tr("Say where the robot starts"),
       Comfort::tr("With the start tool (T), press where the robot will stand and drag to where it "
                   "will look. The wheel zooms, the middle button moves the view.")},
      {&sights.issues, Comfort::tr("See what is missing"),
       Comfort::tr(
           "Issues lists what in the drawing is likely to be a slip; a click shows where.")},
      {&sights.transport, Comfort::tr("Let a robot drive"),
       Comfort::tr("Open a recording, connect a robot or take the simulator, then press Run: "
                   "the blue map is the drawing as the robot corrects it.")},
      {&sights.transport, Comfort::tr("Take the correction over"),
       Comfort::tr("Accept Correction takes the blue map into the drawing; one Undo takes it back. "
                   "Then save or export it.")},
  };
}

QMenu* gather(QMenu& menu, const QString& title, const ActionSet& actions,
              std::initializer_list<const char*> ids) {
  auto* inner = new QMenu(title, &menu);
  menu.insertMenu(&actions[*ids.begin()], inner);
  for (const char* id : ids) {
    menu.removeAction(&actions[id]);
    inner->addAction(&actions[id]);
  }
  return inner;
}

}  // namespace

Comfort::Comfort(const Shell& shell, FileActions& files, const Sights& sights, QObject* parent)
    : QObject(parent),
      window_(shell.window),
      palette_(new CommandPalette(shell.actions, shell.window)),
      tour_(new Tour(stepsOf(sights), shell.window)) {
  shell.actions.restoreKeys(shell.settings);
  new Theme(shell.actions, shell.settings, this);
  new Language(
      shell, [&files] { files.startAgain(); }, this);
  auto* keys = new KeysPanel(shell.actions);
  constexpr QSize kKeysSize(640, 520);
  QDockWidget& sheet = shell.docks.add({"keys", tr("Keyboard shortcuts"), Docks::Group::Floating,
                                        Docks::When::Asked, false, false, kKeysSize},
                                       keys);
  auto* escape = new QShortcut(Qt::Key_Escape, &sheet);
  escape->setContext(Qt::WidgetWithChildrenShortcut);
  connect(escape, &QShortcut::activated, &sheet, &QDockWidget::close);
  connect(keys, &KeysPanel::keysChanged, this,
          [&shell] { shell.actions.saveKeys(shell.settings); });
  shell.actions.on("help.guide", this, [this] { openGuide(); });
  shell.actions.on("help.commands", this, [this] { palette_->open(); });
  shell.actions.on("help.shortcuts", this, [&shell, keys] { shell.docks.show(*keys); });
  shell.actions.on("help.tour", this, [this] { beginTour(); });
}

void Comfort::tidy(const QMenuBar& menu_bar, const ActionSet& actions) {
  for (QAction* top : menu_bar.actions()) {
    QMenu& menu = *top->menu();
    if (!menu.actions().contains(&actions["view.theme_system"])) continue;
    gather(menu, tr("&Appearance"), actions,
           {"view.theme_system", "view.theme_light", "view.theme_dark"});
    gather(menu, tr("&Language"), actions,
           {"view.language_system", "view.language_en", "view.language_ja"});
  }
}

void Comfort::beginTour() { tour_->begin(); }

/// Where it was left, if it is open.
void Comfort::openGuide() {
  if (!guide_) {
    guide_ = new GuideWindow(&window_);
    guide_->setAttribute(Qt::WA_DeleteOnClose);
    guide_->open();
  }
  guide_->show();
  guide_->raise();
  guide_->activateWindow();
}

}  // namespace handmap
