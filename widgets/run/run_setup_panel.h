// The settings of a run. Plain fields; what is entered counts for the next run.
#pragma once

#include <QWidget>

#include "core/recording/recording.h"
#include "core/session/run_session.h"

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

  RunSetup setup() const;
  void setSetup(const RunSetup& setup);

  void save(QSettings& settings) const;
  void restore(const QSettings& settings);

 private:
  QSpinBox* addNumber(const QString& label, int low, int high, const QString& hint);

  QComboBox* method_;
  QSpinBox* slam_particles_;
  QSpinBox* pso_particles_;
  QSpinBox* pso_iterations_;
  QSpinBox* seed_;
  QSpinBox* threads_;
  QComboBox* source_;
  QSpinBox* from_;
  QSpinBox* to_;
  QSpinBox* every_;
};

}  // namespace handmap
