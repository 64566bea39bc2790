// Writes unsaved work beside its project, never into it, and finds it again after a crash.
#pragma once

#include <QObject>
#include <QStringList>
#include <QTimer>

class QSettings;

namespace handmap {

class MapDocument;

class Recovery : public QObject {
  Q_OBJECT
 public:
  /// `settings` keeps the list of recovery files; both must outlive this object.
  Recovery(MapDocument& document, QSettings& settings, QObject* parent = nullptr);

  /// Of a project, or of a drawing that was never saved (empty path).
  static QString fileFor(const QString& project);

  /// Left behind by an earlier session; the newest first.
  QStringList leftBehind() const;
  /// Puts the unsaved work into the document, as modified. Throws Error.
  void recover(const QString& file);
  void forget(const QString& file);
  /// The work was saved, or given up.
  void clear();

  /// Writes if there is something new; called by a timer. False: it could not be written.
  bool write();

 private:
  void remember(const QString& file);

  MapDocument& document_;
  QSettings& settings_;
  QTimer timer_;
  QString written_;  ///< the file of this session, empty: none
  bool dirty_ = false;
};

}  // namespace handmap
