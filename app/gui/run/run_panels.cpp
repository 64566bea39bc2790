#include "app/gui/run/run_panels.h"

#include "app/gui/shell/docks.h"
#include "widgets/run/panels/buildings_panel.h"
#include "widgets/run/panels/camera_panel.h"
#include "widgets/run/panels/charts_panel.h"
#include "widgets/run/panels/layers_panel.h"
#include "widgets/run/panels/log_panel.h"
#include "widgets/run/panels/run_setup_panel.h"
#include "widgets/run/panels/said_panel.h"
#include "widgets/run/panels/why_panel.h"

namespace handmap {

RunPanels RunPanels::make() {
  return {*new LayersPanel,    *new RunSetupPanel, *new ChartsPanel, *new CameraPanel,
          *new BuildingsPanel, *new LogPanel,      *new WhyPanel,    *new SaidPanel};
}

void RunPanels::addTo(Docks& docks) const {
  using Group = Docks::Group;
  using When = Docks::When;
  docks.add({"buildings", tr("Review"), Group::Run, When::Run}, &buildings);
  docks.add({"camera", tr("Camera"), Group::Run, When::Camera}, &camera);
  docks.add({"charts", tr("Charts"), Group::Run, When::Run}, &charts);
  docks.add({"log", tr("Log"), Group::Run, When::Run}, &log);
  docks.add({"why", tr("Why"), Group::Run, When::RunAsked}, &why);
  docks.add({"said", tr("What you said"), Group::Run, When::RunAsked}, &said);
  docks.add({"setup", tr("Run settings"), Group::Drawing, When::Asked}, Docks::scrolled(&setup));
}

}  // namespace handmap
