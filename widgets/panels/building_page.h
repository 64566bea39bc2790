// One or more buildings: what they have in common, or one value for all of them.
#pragma once

#include <functional>

#include "widgets/panels/property_page.h"

class QCheckBox;
class QLabel;

namespace handmap {

class SureBox;
class VertexTable;

class BuildingPage : public PropertyPage {
  Q_OBJECT
 public:
  explicit BuildingPage(MapDocument& document);

  void refresh() override;

 private:
  void addVertices();
  void addUncertainty();
  std::vector<Building> buildings() const;
  /// Its own, or that of the map.
  Uncertainty statedOf(const Building& building) const;
  void edit(const QString& text, const std::function<void(Building&)>& change);
  void editBox(const QString& text, const std::function<void(Rectangle&)>& change);
  void refreshLock(const std::vector<Building>& shown);
  void refreshUncertainty(const std::vector<Building>& shown);
  void refreshWriting(const Building& shown);
  void refreshEstimate(const std::vector<Building>& shown);

  QLineEdit* name_;
  QLabel* writing_;
  NumberField* x_;
  NumberField* y_;
  NumberField* width_;
  NumberField* depth_;
  NumberField* heading_;
  QCheckBox* locked_;
  QCheckBox* fixed_;
  QCheckBox* may_not_exist_;
  QCheckBox* own_uncertainty_;
  SureBox* sure_;
  NumberField* position_sigma_;
  NumberField* size_sigma_;
  VertexTable* vertices_;
  QLabel* estimate_;
};

}  // namespace handmap
