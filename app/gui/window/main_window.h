// The window: one canvas for drawing and for watching, tools on the left, docks on the right, the
// transport below. It only puts the parts together.
#pragma once

#include <QMainWindow>
#include <memory>

#include "app/gui/editing/editing_panels.h"
#include "app/gui/run/run_controller.h"
#include "app/gui/run/run_panels.h"
#include "app/gui/shell/docks.h"
#include "app/gui/shell/shell.h"
#include "core/map/issues.h"
#include "widgets/actions/action_set.h"
#include "widgets/document/map_document.h"
#include "widgets/messages/dialogs.h"
#include "widgets/run/overlays/layers.h"

class QLabel;
class QSettings;
class QToolBar;

namespace handmap {

class Comfort;
class FileActions;
class MapCanvas;
class MapModel;
class MessageBar;
class PictureActions;
class Recovery;
class RecoveryOffer;
class ResultActions;
class RevisionActions;
class LiveWatch;
class RigActions;
class RunOverlays;
class RunViews;
class SourceActions;
class TeachPanel;
class TemplateMenu;
class Toolbox;
class TransportActions;
class TransportBar;
class WelcomeStrip;

class MainWindow : public QMainWindow {
  Q_OBJECT
  Q_DISABLE_COPY(MainWindow)
 public:
  /// Both must outlive the window. Without dialogs: the system's.
  MainWindow(MapDocument& document, QSettings& settings,
             std::unique_ptr<Dialogs> dialogs = nullptr);
  ~MainWindow() override;

  MapDocument& document() { return document_; }
  MapCanvas& canvas() { return *canvas_; }
  Toolbox& tools() { return *tools_; }
  RunController& run() { return run_; }
  FileActions& files() { return *files_; }
  SourceActions& sources() { return *sources_; }
  TransportActions& runs() { return *runs_; }
  ResultActions& results() { return *results_; }
  RigActions& rigs() { return *rigs_; }
  const RunPanels& runPanels() { return run_panels_; }
  TeachPanel& teach() { return *teach_; }
  Docks& docks() { return docks_; }
  PropertyPanel& properties() { return editing_panels_.properties; }
  TransportBar& transport() { return *transport_; }
  MessageBar& messages() { return *messages_; }

  /// Says so if earlier sessions have left unsaved work behind.
  void offerRecovery();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  /// What is no drawing; a picture lies there then. False: it is one, or nothing that is known.
  bool openOther(const QString& path, const QPoint& on_canvas);
  QWidget* makeCentre();
  void makeRun();
  void makeBars();
  QToolBar* makeTransport();
  void makeStatusBar();
  void connectEditing();
  void connectTools();
  void connectView();
  void connectRecovery();
  void showIssue(const Issue& issue);
  void setLayer(Layer layer, bool on);
  void updateTitle();
  void restoreState();
  void saveState();

  MapDocument& document_;
  QSettings& settings_;
  std::unique_ptr<Dialogs> dialogs_;
  ActionSet actions_{this};
  RunController run_;
  MapCanvas* canvas_;
  Toolbox* tools_;
  MessageBar* messages_;
  WelcomeStrip* welcome_;
  [[maybe_unused]] QWidget* centre_;  ///< before all docks, so that the canvas has the focus first
  Docks docks_{*this};
  TransportBar* transport_;
  TeachPanel* teach_;
  RunPanels run_panels_;
  EditingPanels editing_panels_;
  Shell shell_;
  QLabel* hint_;
  QLabel* cursor_;
  QLabel* scale_;
  QLabel* run_state_;
  std::unique_ptr<RunOverlays> overlays_;  ///< before the scene of the canvas goes
  std::unique_ptr<RevisionActions> revisions_;
  FileActions* files_;
  SourceActions* sources_;
  RunViews* views_;
  TransportActions* runs_;
  ResultActions* results_;
  LiveWatch* live_watch_;
  RigActions* rigs_;
  PictureActions* pictures_;
  TemplateMenu* templates_;
  Comfort* comfort_;
  MapModel* model_;
  Recovery* recovery_;
  RecoveryOffer* recovery_offer_;
};

}  // namespace handmap
