// The panels about runs.
#pragma once

#include <QCoreApplication>

namespace handmap {

class BuildingsPanel;
class CameraPanel;
class ChartsPanel;
class Docks;
class LayersPanel;
class LogPanel;
class RunSetupPanel;
class SaidPanel;
class WhyPanel;

struct RunPanels {
  Q_DECLARE_TR_FUNCTIONS(handmap::RunPanels)
 public:
  LayersPanel& layers;  ///< shown below those of the drawing
  RunSetupPanel& setup;
  ChartsPanel& charts;
  CameraPanel& camera;
  BuildingsPanel& buildings;
  LogPanel& log;
  WhyPanel& why;
  SaidPanel& said;

  static RunPanels make();
  /// All but the layers, in docks of their own.
  void addTo(Docks& docks) const;
};

}  // namespace handmap
