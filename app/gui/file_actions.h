// New, open, save, recent files and exports: what the File menu does.
#pragma once

#include <QObject>
#include <functional>

#include "app/gui/recovery.h"

class QMenu;
class QSettings;
class QWidget;

namespace handmap {

class ActionSet;
class MapCanvas;
class MapDocument;
class MessageBar;
class RunController;
struct Map;

class FileActions : public QObject {
  Q_OBJECT
 public:
  /// What the menu works on; all of it must outlive this object.
  struct Parts {
    QWidget& window;
    MapDocument& document;
    MapCanvas& canvas;
    RunController& run;
    ActionSet& actions;
    MessageBar& messages;
    QSettings& settings;
  };
  explicit FileActions(const Parts& parts);

  /// Asks when there are unsaved changes. False: the user wants to stay.
  bool mayLeave();
  /// Opens after mayLeave(); errors go to the message bar.
  bool open(const QString& path);
  bool save();
  bool saveAs();
  /// Takes another map in place of the drawing, after mayLeave().
  bool replace(const Map& map);
  /// Says so if an earlier session has left unsaved work behind.
  void offerRecovery();
  /// Called with the path before the drawing is saved there; an Error it throws is told, and
  /// nothing is saved.
  void setBeforeSave(std::function<void(const QString& path)> work) {
    before_save_ = std::move(work);
  }
  QMenu& recentMenu() { return *recent_; }
  /// The session ends as the user wants it.
  void sessionEnds() { recovery_.clear(); }

 Q_SIGNALS:
  /// Another drawing is open now: a run of the one before makes no sense any more.
  void drawingReplaced();

 private:
  void connectActions();
  void remember(const QString& path);
  void fillRecentMenu();
  bool saveTo(const QString& path);
  QString askPath(const QString& title, const QString& suggestion, const QString& filter,
                  const QString& suffix);
  void exportMap();
  void exportGeoJson();
  void exportPicture();
  void exportTrajectory();
  /// Runs `work`; an Error goes to the message bar. True: it went well.
  template <typename Work>
  bool guarded(Work work);

  Parts parts_;
  Recovery recovery_;
  QMenu* recent_;
  std::function<void(const QString& path)> before_save_ = [](const QString&) {};
};

}  // namespace handmap
