// The settings of a run. Plain fields; what is entered counts for the next run.
#pragma once

#include <QWidget>

#include "core/recording/recording.h"
#include "core/session/run_session.h"

class QCheckBox;
class QComboBox;
class QSettings;
class QSpinBox;

namespace handmap {

struct RunSetup {
  RunSettings settings;
  ReplayOptions replay;  ///< of a recording
};

class RunSetupPanel : public QWidget {
  Q_OBJECT
 public:
  explicit RunSetupPanel(QWidget* parent = nullptr);

  /// What tells buildings from the rest in images, beside the classifier of the program; chosen at
  /// once. nullptr: there is none any more.
  void setTaughtClassifier(std::shared_ptr<const WindowClassifier> classifier);

  RunSetup setup() const;
  void setSetup(const RunSetup& setup);
  ReplayOptions replay() const { return setup().replay; }
  /// Those of another recording: nobody is told.
  void setReplay(const ReplayOptions& replay);

  void save(QSettings& settings) const;
  void restore(const QSettings& settings);

 Q_SIGNALS:
  /// Somebody asks for another part of the recording.
  void replayChanged();

 private:
  void showOfMethod();
  QSpinBox* addNumber(const QString& label, int low, int high, const QString& hint);

  QComboBox* method_;
  QCheckBox* free_scale_;
  QCheckBox* free_turn_;
  QSpinBox* slam_particles_;
  QSpinBox* pso_particles_;
  QSpinBox* pso_iterations_;
  QSpinBox* seed_;
  QSpinBox* threads_;
  QComboBox* buildings_;
  QComboBox* source_;
  QSpinBox* from_;
  QSpinBox* to_;
  QSpinBox* every_;
  std::shared_ptr<const WindowClassifier> taught_;
};

}  // namespace handmap
