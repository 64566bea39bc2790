// Says on stderr what happens in the window, one line an event: for --verbose and for scripts that
// drive the program from outside.
#pragma once

#include <QHash>
#include <QObject>

namespace handmap {

class MainWindow;

class Narrator : public QObject {
  Q_OBJECT
 public:
  explicit Narrator(MainWindow& window);

 private:
  /// Only when it is not what was said of `subject` last.
  void sayChange(const QString& subject, const QString& state);

  QHash<QString, QString> said_;
};

}  // namespace handmap
