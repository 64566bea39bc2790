// What every room of the window may use.
#pragma once

class QMainWindow;
class QSettings;

namespace handmap {

class ActionSet;
class Dialogs;
class Docks;
class MessageBar;

/// All of it lives as long as the window.
struct Shell {
  QMainWindow& window;
  ActionSet& actions;
  MessageBar& messages;
  Dialogs& dialogs;
  Docks& docks;
  QSettings& settings;
};

}  // namespace handmap
