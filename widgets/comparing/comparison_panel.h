// The figures of sketch-map research of a drawing against the truth, each explained, and of the map
// that a run made of it.
#pragma once

#include <QWidget>
#include <vector>

#include "core/sketch_study/figures.h"

class QLabel;
class QTreeWidget;

namespace handmap {

class ComparisonPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ComparisonPanel(QWidget* parent = nullptr);

  /// One column each: of the drawing, and, where there is one, of the corrected map.
  void setFigures(const QString& truth, const std::vector<SketchFigures>& columns);
  /// As the command line writes it.
  std::string table() const { return figureTable(columns_); }

 Q_SIGNALS:
  void saveRequested();
  void otherTruthRequested();

 private:
  void fill();

  std::vector<SketchFigures> columns_;
  QLabel* words_;
  QTreeWidget* tree_;
};

}  // namespace handmap
