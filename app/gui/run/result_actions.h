// What a run has come to: its summary and warnings, and taking it over into the drawing.
#pragma once

#include <QObject>
#include <optional>

#include "app/gui/run/run_score.h"
#include "app/gui/shell/shell.h"

namespace handmap {

class BuildingsPanel;
class FileActions;
class MapDocument;
class RunController;
class SourceActions;

class ResultActions : public QObject {
  Q_OBJECT
 public:
  /// What it is given must outlive it. `buildings` shows the doubtful ones when they are clicked.
  ResultActions(const Shell& shell, MapDocument& document, FileActions& files,
                const SourceActions& sources, RunController& run, BuildingsPanel& buildings);

  /// The latest run against the truth. nullopt before its first step.
  std::optional<RunScore> score() const;
  /// Asks where something of the latest run would be lost: a live drive that was not recorded, or
  /// what a run came to and nobody has accepted. `coming_back`: a recording will be run again.
  /// False: the user wants to stay.
  bool mayLeave(bool coming_back);

 private:
  bool isSimulated() const;
  bool isUnrecorded() const;
  bool isDriving() const;
  bool isUnaccepted() const;
  void take(const QStringList& kept = {});
  /// Before somebody takes it over: what should be looked at first.
  void alarm();
  void forget();
  void onFinished(bool cancelled);
  void onFrameSkipped(int frame, const QString& reason);
  /// Of a run at its end; true: its outcome is hardly worth a summary.
  bool warn();
  void summarize(const RunScore& score);
  void accept();
  void updateActions();

  const Shell& shell_;
  MapDocument& document_;
  FileActions& files_;
  const SourceActions& sources_;
  RunController& run_;
  BuildingsPanel& buildings_;
  int skipped_ = 0;   ///< frames of the latest run
  int accepted_ = 0;  ///< number() of the run that was accepted last
  int left_ = 0;      ///< and of the one of which it was said that it may go
};

}  // namespace handmap
