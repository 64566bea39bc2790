// The ways in: what the strip of a first start leads to, and while it is shown.
#pragma once

#include <QObject>

#include "app/gui/shell/shell.h"

namespace handmap {

class Comfort;
class FileActions;
class MapCanvas;
class MapDocument;
class RigActions;
class SourceActions;
class TransportActions;
class WelcomeStrip;

class Welcome : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY(Welcome)
 public:
  /// What the ways lead to; all outlive it.
  struct Ways {
    MapDocument& document;
    MapCanvas& canvas;
    FileActions& files;
    SourceActions& sources;
    TransportActions& runs;
    RigActions& rigs;
    Comfort& comfort;
  };
  Welcome(const Shell& shell, WelcomeStrip& strip, const Ways& ways, QObject* parent);

 private:
  void connectWays();
  void show();

  Shell shell_;
  WelcomeStrip& strip_;
  Ways ways_;
};

}  // namespace handmap
