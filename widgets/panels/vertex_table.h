// The corners of a polygon as numbers.
#pragma once

#include <QTableWidget>
#include <QWidget>

#include "core/geometry/polygon.h"

class QPushButton;

namespace handmap {

class VertexTable : public QWidget {
  Q_OBJECT
 public:
  explicit VertexTable(QWidget* parent = nullptr);

  void showPolygon(const Polygon& polygon);

 Q_SIGNALS:
  void edited(const handmap::Polygon& polygon);  ///< simple, counter-clockwise
  void refused(const QString& why);

 private:
  void fill();
  void take(const QTableWidgetItem* item);
  void addCorner();
  void removeCorner();
  void propose(Polygon polygon);

  Polygon polygon_;
  QTableWidget* table_;
  QPushButton* add_;
  QPushButton* remove_;
  bool filling_ = false;
};

}  // namespace handmap
