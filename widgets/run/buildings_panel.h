// The table of the refined buildings. A row that is chosen is asked to be shown.
#pragma once

#include <QWidget>

#include "widgets/run/buildings_model.h"

namespace handmap {

class BuildingsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit BuildingsPanel(QWidget* parent = nullptr);

  BuildingsModel& model() { return *model_; }

 Q_SIGNALS:
  void showRequested(const QString& id);

 private:
  BuildingsModel* model_;
};

}  // namespace handmap
