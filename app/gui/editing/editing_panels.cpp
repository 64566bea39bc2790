#include "app/gui/editing/editing_panels.h"

#include <QSplitter>
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

/// What there is, and what of it is selected: as high as the person draws them.
QWidget* listOver(QWidget* list, QWidget* details) {
  auto* both = new QSplitter(Qt::Vertical);
  both->setObjectName(QStringLiteral("objects_and_properties"));
  both->setChildrenCollapsible(false);
  both->addWidget(list);
  both->addWidget(details);
  both->setStretchFactor(0, 1);
  both->setStretchFactor(1, 1);
  return both;
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
  docks.add({"objects", tr("Objects"), Group::Drawing, When::Always, true},
            listOver(objects, properties));
  docks.add({"layers", tr("Layers"), Group::Drawing, When::Always},
            Docks::scrolled(stacked({new DrawingLayersPanel(document), run_layers})));
  QDockWidget& issues_dock =
      docks.add({"issues", tr("Issues"), Group::Drawing, When::Always}, issues);
  docks.add({"history", tr("History"), Group::Drawing, When::Asked}, historyOf(document));
  QObject::connect(issues, &IssuesPanel::found, &issues_dock, [issues, &issues_dock] {
    const auto count = issues->issues().size();
    issues_dock.setWindowTitle(count == 0 ? tr("Issues") : tr("Issues (%1)").arg(count));
  });
  return {*objects, *properties, *issues};
}

}  // namespace handmap
