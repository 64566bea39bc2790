// The docks of the window: objects, properties and layers always; what belongs to a run while a run
// exists.
#pragma once

#include <QObject>
#include <QSet>

class QDockWidget;
class QMainWindow;
class QMenu;

namespace handmap {

class BuildingsPanel;
class CameraPanel;
class ChartsPanel;
class IssuesPanel;
class KeysPanel;
class LayersPanel;
class LivePanel;
class LogPanel;
class MapDocument;
class ObjectsPanel;
class PropertyPanel;
class RunSetupPanel;
class TeachPanel;
class WhyPanel;

class Docks : public QObject {
  Q_OBJECT
 public:
  Docks(QMainWindow& window, MapDocument& document);

  ObjectsPanel& objects() { return *objects_; }
  PropertyPanel& properties() { return *properties_; }
  IssuesPanel& issues() { return *issues_; }
  LayersPanel& layers() { return *layers_; }
  RunSetupPanel& setup() { return *setup_; }
  ChartsPanel& charts() { return *charts_; }
  CameraPanel& camera() { return *camera_; }
  BuildingsPanel& buildings() { return *buildings_; }
  LogPanel& log() { return *log_; }
  WhyPanel& why() { return *why_; }
  TeachPanel& teach() { return *teach_; }
  LivePanel& live() { return *live_; }

  /// Those of a run come and go with it; what the user has closed stays closed.
  void showRunDocks(bool run_exists, bool has_camera);
  /// That of the devices, while there is a live robot.
  void showLiveDock(bool is_live);
  void showProperties();
  void showSetup();
  void showTeach();
  void showWhy();
  bool isWhyShown() const;
  /// The sheet of all keys.
  void setKeys(KeysPanel* keys);
  void showKeys();
  void addSwitches(QMenu& menu) const;
  /// As they are at the first start in a window of that size: side by side, or one over another
  /// where there is little room.
  void arrange(QSize window);

 Q_SIGNALS:
  void whyShown(bool shown);

 private:
  void resize();
  QDockWidget* add(const QString& name, const QString& title, QWidget* panel);

  QMainWindow& window_;
  ObjectsPanel* objects_;
  PropertyPanel* properties_;
  LayersPanel* layers_;
  IssuesPanel* issues_;
  RunSetupPanel* setup_;
  ChartsPanel* charts_;
  CameraPanel* camera_;
  BuildingsPanel* buildings_;
  LogPanel* log_;
  WhyPanel* why_;
  TeachPanel* teach_;
  LivePanel* live_;
  QDockWidget* objects_dock_;
  QDockWidget* properties_dock_;
  QDockWidget* layers_dock_;
  QDockWidget* issues_dock_;
  QDockWidget* history_dock_;
  QDockWidget* setup_dock_;
  QDockWidget* charts_dock_;
  QDockWidget* camera_dock_;
  QDockWidget* buildings_dock_;
  QDockWidget* log_dock_;
  QDockWidget* why_dock_;
  QDockWidget* teach_dock_;
  QDockWidget* live_dock_;
  QDockWidget* keys_dock_;
  QSet<QDockWidget*> closed_by_user_;
  bool live_shown_ = false;
  bool compact_ = false;
};

}  // namespace handmap
