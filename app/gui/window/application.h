// The application with one guard for everything that an event may call: no exception ends the
// program.
#pragma once

#include <QApplication>
#include <QElapsedTimer>

namespace handmap {

class Application : public QApplication {
  Q_OBJECT
 public:
  Application(int& argc, char** argv) : QApplication(argc, argv) {}

  /// The one of this process.
  static Application& instance();

  bool notify(QObject* receiver, QEvent* event) override;

 Q_SIGNALS:
  /// Something was thrown that nobody expected; what was being done is left undone. Queued: nothing
  /// of what threw is still at work. In the thread of this object.
  void failed(const QString& message, const QString& hint);

 private:
  void tell(const QString& message, const QString& hint) noexcept;

  QString told_;  ///< what was told last, and when: a widget that throws is painted ever again
  QElapsedTimer since_;
};

}  // namespace handmap
