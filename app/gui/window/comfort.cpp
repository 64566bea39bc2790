#include "app/gui/window/comfort.h"

#include <QMenu>
#include <QMenuBar>
#include <QSettings>

#include "app/gui/files/file_actions.h"
#include "app/gui/shell/docks.h"
#include "app/gui/shell/language.h"
#include "app/gui/shell/message_bar.h"
#include "app/gui/shell/theme.h"
#include "app/gui/shell/tour.h"
#include "widgets/actions/action_set.h"
#include "widgets/actions/command_palette.h"
#include "widgets/actions/keys_panel.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/panels/issues_panel.h"

namespace handmap {

namespace {

std::vector<Tour::Step> stepsOf(const Comfort::Parts& parts) {
  return {
      {&parts.tool_bar, Comfort::tr("Draw"),
       Comfort::tr("Take the rectangle (R) and drag from corner to corner where you remember a "
                   "building. It need not be right: some metres off is fine.")},
      {&parts.canvas, Comfort::tr("Say where the robot starts"),
       Comfort::tr("With the start tool (T), press where the robot will stand and drag to where it "
                   "will look. The wheel zooms, the middle button moves the view.")},
      {&parts.docks.issues(), Comfort::tr("See what is missing"),
       Comfort::tr(
           "Issues tells what in the drawing is likely to be a slip; a click shows where.")},
      {&parts.transport, Comfort::tr("Let a robot drive"),
       Comfort::tr("Open a recording, connect a robot or take the simulator, then press Run: "
                   "the blue map is the drawing as the robot corrects it.")},
      {&parts.transport, Comfort::tr("Take the correction over"),
       Comfort::tr("Accept Refinement takes the blue map into the drawing; one Undo takes it back. "
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

Comfort::Comfort(const Parts& parts, QObject* parent)
    : QObject(parent),
      parts_(parts),
      palette_(new CommandPalette(parts.actions, parts.window)),
      tour_(new Tour(stepsOf(parts), parts.window)) {
  parts_.actions.restoreKeys(parts_.settings);
  new Theme(parts_.actions, parts_.settings, this);
  new Language({parts_.actions, parts_.messages, parts_.settings,
                [files = &parts_.files] { files->startAgain(); }},
               this);
  auto* keys = new KeysPanel(parts_.actions);
  parts_.docks.setKeys(keys);
  connect(keys, &KeysPanel::keysChanged, this,
          [this] { parts_.actions.saveKeys(parts_.settings); });
  parts_.actions.on("help.commands", this, [this] { palette_->open(); });
  parts_.actions.on("help.shortcuts", this, [this] { parts_.docks.showKeys(); });
  parts_.actions.on("help.tour", this, [this] { beginTour(); });
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

}  // namespace handmap
