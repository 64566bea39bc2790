// A drawing may name files beyond its own folder. They are read when somebody has said yes, once
// for each drawing.
#pragma once

#include <QObject>

#include "app/gui/shell/shell.h"
#include "widgets/document/map_document.h"

class QSettings;

namespace handmap {

class FileActions;

class ReferenceTrust : public QObject {
  Q_OBJECT
 public:
  /// What it is given must outlive it.
  ReferenceTrust(const Shell& shell, MapDocument& document, FileActions& files, QObject* parent);

  /// Whether all that the drawing names is shown: it lies inside, or is trusted.
  bool allows() const { return document_.trustsReferences() || outside().isEmpty(); }

 Q_SIGNALS:
  void granted();

 private:
  QStringList outside() const;
  void onReplaced();
  void onSaved(const QString& path);
  void grant(const QString& path);
  void remember(const QString& path);

  const Shell& shell_;
  MapDocument& document_;
  FileActions& files_;
};

}  // namespace handmap
