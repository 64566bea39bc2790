// Keeps unsaved work in a file of this session, beside its project and never in it, and finds what
// sessions that are no more have left behind.
#pragma once

#include <QObject>
#include <QStringList>
#include <QThreadPool>
#include <QTimer>
#include <memory>
#include <vector>

#include "widgets/recovery/unsaved_work.h"

class QLockFile;
class QSettings;

namespace handmap {

class MapDocument;
class TeachPanel;

/// What another session has left. Nobody else is offered it as long as this is held.
struct LeftBehind {
  QString session;
  QString file;
  QStringList places;  ///< where it may have been written
  std::shared_ptr<QLockFile> lock;
};

struct RecoveryOptions {
  int delay_ms = 1'500;  ///< from a change to its being written
  /// Where to write when the folder of the project will not have it, in turn.
  QStringList folders = usualFolders();

  static QStringList usualFolders();
};

class Recovery : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(Recovery)
 public:
  /// What is watched must outlive this object. `settings` tells where the files of all sessions
  /// are.
  Recovery(MapDocument& document, TeachPanel& teach, QSettings& settings,
           RecoveryOptions options = {}, QObject* parent = nullptr);
  ~Recovery() override;

  /// Of sessions that live no more; unordered.
  std::vector<LeftBehind> takeLeftBehind();
  /// Takes the place of what is open, as unsaved, and of this session's file. Throws Error; nothing
  /// is changed then.
  void recover(const LeftBehind& left, const UnsavedWork& work);
  void forget(const LeftBehind& left);

  /// The session ends as somebody wants it: nothing is left behind.
  void clear();

 Q_SIGNALS:
  /// Once each: it is kept somewhere else (`instead`), or nowhere (empty).
  void cannotKeep(const QString& reason, const QString& instead);

 private:
  struct Place {  ///< of the file of this session; touched by the thread of pool_ alone
    QString file;
    std::shared_ptr<QLockFile> lock;
  };
  struct Outcome {
    QString file;  ///< empty: nowhere
    QString problem;
  };

  bool hasUnsavedWork() const;
  void onChange();
  void write();
  QStringList candidates() const;
  void tellSettings();
  Outcome writeTo(const QStringList& files, const UnsavedWork& work);
  void onWritten(const Outcome& outcome);

  MapDocument& document_;
  TeachPanel& teach_;
  QSettings& settings_;
  RecoveryOptions options_;
  QString session_;
  QTimer timer_;
  QStringList places_;  ///< in the settings: where a file of this session is or may soon be
  bool told_instead_ = false;
  bool told_nowhere_ = false;
  Place place_;
  QThreadPool pool_;  ///< of one thread; last: it ends before what it uses
};

}  // namespace handmap
