#include "app/gui/window/welcome.h"

#include <QSettings>

#include "app/gui/files/file_actions.h"
#include "app/gui/rig/rig_actions.h"
#include "app/gui/run/source_actions.h"
#include "app/gui/run/transport_actions.h"
#include "app/gui/shell/welcome_strip.h"
#include "app/gui/window/comfort.h"
#include "widgets/actions/action_set.h"
#include "widgets/canvas/map_canvas.h"

namespace handmap {

namespace {

constexpr auto kClosedKey = "welcome/closed";

bool isNothing(const Map& map) {
  return map.buildings.empty() && map.landmarks.empty() && map.route.empty() && !map.start &&
         map.underlays.empty();
}

}  // namespace

Welcome::Welcome(const Shell& shell, WelcomeStrip& strip, const Ways& ways, QObject* parent)
    : QObject(parent), shell_(shell), strip_(strip), ways_(ways) {
  connectWays();
  connect(&strip_, &WelcomeStrip::closed, this,
          [this] { shell_.settings.setValue(kClosedKey, true); });
  connect(&ways_.document, &MapDocument::mapChanged, this, &Welcome::show);
  connect(&ways_.document, &MapDocument::fileChanged, this, &Welcome::show);
  connect(&ways_.sources, &SourceActions::robotChanged, this, &Welcome::show);
  connect(&ways_.canvas, &MapCanvas::toolChanged, this, &Welcome::show);
  show();
}

void Welcome::connectWays() {
  connect(&strip_, &WelcomeStrip::demonstrationRequested, this, [this] {
    if (ways_.sources.openDemonstration()) ways_.runs.runOrResume();
  });
  connect(&strip_, &WelcomeStrip::drawRequested, this, [this] {
    if (ways_.files.replace({})) shell_.actions["draw.rectangle"].trigger();
  });
  connect(&strip_, &WelcomeStrip::recordingRequested, &ways_.sources,
          &SourceActions::askForRecording);
  connect(&strip_, &WelcomeStrip::simulatorRequested, &ways_.sources,
          &SourceActions::openSimulator);
  connect(&strip_, &WelcomeStrip::robotRequested, &ways_.rigs, &RigActions::showDialog);
  connect(&strip_, &WelcomeStrip::tourRequested, &ways_.comfort, &Comfort::beginTour);
}

/// While nothing is open and nobody draws; it does not shift what is being drawn.
void Welcome::show() {
  const bool begun = !isNothing(ways_.document.map()) || !ways_.document.filePath().isEmpty() ||
                     ways_.sources.robot().has_value() || ways_.canvas.tool() != ToolId::Select;
  strip_.setVisible(!begun && !shell_.settings.value(kClosedKey).toBool());
}

}  // namespace handmap
