// A run without anybody watching: ends the program, and says what came out of it.
#pragma once

#include <QObject>

#include "app/gui/window/command_line.h"
#include "widgets/run/worker/run_worker.h"

namespace handmap {

class MainWindow;

class Batch : public QObject {
  Q_OBJECT
 public:
  /// Listens to the run of `window`, which must outlive it, and leaves the application with the
  /// exit status when the run has ended: 0 done, 2 bad input, 3 failed.
  Batch(MainWindow& window, const CommandLine& line);

 private:
  void onFinished();
  void onFailed(const Failure& failure);
  void writeReport(const QString& folder);

  MainWindow& window_;
  CommandLine line_;
};

}  // namespace handmap
