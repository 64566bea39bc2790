// The panels about the drawing.
#pragma once

#include <QCoreApplication>

class QWidget;

namespace handmap {

class Docks;
class IssuesPanel;
class MapDocument;
class ObjectsPanel;
class PropertyPanel;

struct EditingPanels {
  Q_DECLARE_TR_FUNCTIONS(handmap::EditingPanels)
 public:
  ObjectsPanel& objects;
  PropertyPanel& properties;
  IssuesPanel& issues;

  /// In docks of their own. `run_layers` comes below the layers of the drawing.
  static EditingPanels make(MapDocument& document, QWidget* run_layers, Docks& docks);
};

}  // namespace handmap
