// New, open, save, recent files and exports: what the File menu does.
#pragma once

#include <QList>
#include <QMap>
#include <QObject>
#include <QPixmap>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

#include "app/gui/shell/shell.h"
#include "core/map/map.h"
#include "widgets/background/background.h"

class QMenu;

namespace handmap {

class MapCanvas;
class MapDocument;

class FileActions : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(FileActions)
 public:
  /// What it is given must outlive it.
  FileActions(const Shell& shell, MapDocument& document, MapCanvas& canvas);
  ~FileActions() override;

  /// Asks when there are unsaved changes, or a run that would be lost. False: the user wants to
  /// stay.
  bool mayLeave();
  /// The same about the run alone.
  bool mayLeaveRun() { return may_leave_run_(is_coming_back_); }
  /// `coming_back`: the program starts again, with what may_come_back brings.
  void setMayLeaveRun(std::function<bool(bool coming_back)> may) {
    may_leave_run_ = std::move(may);
  }
  /// Opens after mayLeave(); errors go to the message bar. What is no drawing goes to who opens it.
  bool open(const QString& path);
  /// Opens what is none; false: it may be one. `filter` is for *Open*.
  void setOthers(const QString& filter, std::function<bool(const QString& path)> open) {
    other_filter_ = filter;
    open_other_ = std::move(open);
  }
  bool save();
  bool saveAs();
  /// The file as it is now on disk, whatever is unsaved.
  bool reload();
  /// Takes another map in place of the drawing, after mayLeave().
  bool replace(const Map& map);
  /// Called with the path before the drawing is saved there; an Error it throws is told, and
  /// nothing is saved.
  void setBeforeSave(std::function<void(const QString& path)> work) {
    before_save_ = std::move(work);
  }
  /// Opens another window of the program, with the drawing of that path where there is one.
  void setWindowOpener(std::function<void(const QStringList& arguments)> open) {
    open_window_ = std::move(open);
  }
  void openWindow(const QStringList& arguments = {}) const { open_window_(arguments); }
  /// Closes this window, which may ask, and opens another one with the same drawing and robot.
  void startAgain();
  /// What else the other window is to be told, e.g. the recording and that it is to run.
  void setComingBack(std::function<QStringList()> arguments) {
    coming_back_ = std::move(arguments);
  }
  /// What the drawing was corrected to, where there is such a map: exports offer it too.
  void setCorrected(std::function<std::optional<Map>()> corrected) {
    corrected_ = std::move(corrected);
  }

  /// Sample and name of what the canvas shows.
  void setLegend(std::function<QList<std::pair<QPixmap, QString>>()> legend) {
    legend_ = std::move(legend);
  }

  /// Where an export goes, and what it is called afterwards.
  struct Export {
    QString title;       ///< of the dialog
    QString suggestion;  ///< name of the file; its ending is exchanged
    QString filter;
    QString suffix;
    QString what;  ///< "The refined map"
  };
  /// Asks where, writes and tells; what `write` throws is told too.
  void exportAs(const Export& what, const std::function<void(const QString& path)>& write);
  /// The same in a thread of its own, for what takes long; `write` owns all that it uses, and is
  /// false where it was stopped.
  using LongWrite = std::function<bool(const QString& path, const std::stop_token& stop)>;
  void exportInBackground(const Export& what, LongWrite write);
  /// Asks while something is still written. False: the user wants to stay.
  bool mayClose();
  static QString mapFilter();
  QString openFilter() const;
  QMenu& recentMenu() { return *recent_; }

 Q_SIGNALS:
  /// Another drawing is open now: a run of the one before makes no sense any more.
  void drawingReplaced();
  void saved(const QString& path);
  /// Somebody wants to say where the drawing lies.
  void georeferenceWanted();

 private:
  void connectActions();
  void import(const QString& path);
  void tellImport(const QString& path);
  void remember(const QString& path);
  void fillRecentMenu();
  bool saveTo(const QString& path);
  QString askPath(const QString& title, const QString& suggestion, const QString& filter,
                  const QString& suffix);
  /// The drawing, or the corrected map where there is one and somebody chooses it; nullopt:
  /// neither.
  std::optional<Map> chosenMap(QString& what);
  void exportToOthers();
  void askWhereItLies(const QString& form);
  void exportPicture();
  void refuseWhatIsRead(const QString& path) const;
  void exportTo(const QString& path, const QString& what, const std::function<void()>& write);
  void tellExport(const QString& path, const QString& what);
  /// Runs `work`; what it throws goes to the message bar. True: it went well.
  template <typename Work>
  bool guarded(Work work);

  const Shell& shell_;
  MapDocument& document_;
  MapCanvas& canvas_;
  QMenu* recent_;
  std::function<QList<std::pair<QPixmap, QString>>()> legend_ = [] {
    return QList<std::pair<QPixmap, QString>>();
  };
  QString other_filter_;
  std::function<bool(const QString& path)> open_other_ = [](const QString&) { return false; };
  std::size_t left_out_ = 0;  ///< of what was imported last
  std::function<void(const QString& path)> before_save_ = [](const QString&) {};
  std::function<std::optional<Map>()> corrected_ = [] { return std::nullopt; };
  std::function<void(const QStringList& arguments)> open_window_ = [](const QStringList&) {};
  std::function<bool(bool coming_back)> may_leave_run_ = [](bool) { return true; };
  std::function<QStringList()> coming_back_ = [] { return QStringList(); };
  bool is_coming_back_ = false;
  QMap<QString, std::stop_source> written_;      ///< in the background, by path
  std::shared_ptr<Lifeline<FileActions>> self_;  ///< shared with the threads that export
};

}  // namespace handmap
