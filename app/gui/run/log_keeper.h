// Writes down what happens during runs: begins and ends, skipped frames, guessed motion, where the
// robot was lost and found, warnings, and what has been changed in the end.
#pragma once

#include <QObject>
#include <optional>

#include "app/gui/run/run_controller.h"
#include "widgets/run/panels/log_model.h"
#include "widgets/run/words/words.h"

namespace handmap {

class LogKeeper : public QObject {
  Q_OBJECT
 public:
  LogKeeper(RunController& run, LogModel& log, QObject* parent = nullptr);

 private:
  void begin(const SourceInfo& source);
  void look(const FrameReport& report);
  void finish(bool cancelled);
  void add(LogKind kind, const QString& text, const QString& building = {});

  RunController& run_;
  LogModel& log_;
  std::optional<double> time_s_;
  std::optional<Certainty> certainty_;
  bool guessed_ = false;
  int loops_ = 0;
};

}  // namespace handmap
