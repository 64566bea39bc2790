#include "app/gui/editing/editing_panels.h"

#include <QUndoView>
#include <QVBoxLayout>

#include "app/gui/shell/docks.h"
#include "widgets/document/map_document.h"
#include "widgets/panels/drawing_layers_panel.h"
#include "widgets/panels/issues_panel.h"
#include "widgets/panels/objects_panel.h"
#include "widgets/panels/property_panel.h"

namespace handmap {

namespace {

/// One below the other.
QWidget* stacked(std::initializer_list<QWidget*> panels) {
  auto* stack = new QWidget;
  auto* layout = new QVBoxLayout(stack);
  layout->setContentsMargins({});
  layout->setSpacing(0);
  for (QWidget* panel : panels) layout->addWidget(panel);
  layout->addStretch();
  return stack;
}

/// Every step since the drawing was opened; a click goes back or forth to it.
QWidget* historyOf(MapDocument& document) {
  auto* view = new QUndoView(&document.undoStack());
  view->setAccessibleName(EditingPanels::tr("Steps of editing"));
  view->setEmptyLabel(EditingPanels::tr("As it was opened"));
  view->setFrameShape(QFrame::NoFrame);
  return view;
}

}  // namespace

EditingPanels EditingPanels::make(MapDocument& document, QWidget* run_layers, Docks& docks) {
  using Group = Docks::Group;
  using When = Docks::When;
  auto* objects = new ObjectsPanel(document);
  auto* properties = new PropertyPanel(document);
  auto* issues = new IssuesPanel(document);
  docks.add({"objects", tr("Objects"), Group::Drawing, When::Always}, objects);
  docks.add({"properties", tr("Properties"), Group::Details, When::Always, true}, properties);
  docks.add({"layers", tr("Layers"), Group::Drawing, When::Always, true},
            Docks::scrolled(stacked({new DrawingLayersPanel(document), run_layers})));
  QDockWidget& issues_dock =
      docks.add({"issues", tr("Issues"), Group::Details, When::Always}, issues);
  docks.add({"history", tr("History"), Group::Details, When::Asked}, historyOf(document));
  QObject::connect(issues, &IssuesPanel::found, &issues_dock, [issues, &issues_dock] {
    const auto count = issues->issues().size();
    issues_dock.setWindowTitle(count == 0 ? tr("Issues") : tr("Issues (%1)").arg(count));
  });
  return {*objects, *properties, *issues};
}

}  // namespace handmap
