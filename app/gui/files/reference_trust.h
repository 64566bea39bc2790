// A drawing may name files beyond its own folder. They are read when somebody has said yes, once
// for each drawing.
#pragma once

#include <QObject>

#include "widgets/document/map_document.h"

class QSettings;

namespace handmap {

class FileActions;
class MessageBar;

class ReferenceTrust : public QObject {
  Q_OBJECT
 public:
  /// All of it must outlive this object. `settings` remembers the answers.
  struct Parts {
    MapDocument& document;
    FileActions& files;
    MessageBar& messages;
    QSettings& settings;
  };
  ReferenceTrust(const Parts& parts, QObject* parent);

  /// Whether all that the drawing names is shown: it lies inside, or is trusted.
  bool allows() const { return parts_.document.trustsReferences() || outside().isEmpty(); }

 Q_SIGNALS:
  void granted();

 private:
  QStringList outside() const;
  void onReplaced();
  void onSaved(const QString& path);
  void grant(const QString& path);
  void remember(const QString& path);

  Parts parts_;
};

}  // namespace handmap
