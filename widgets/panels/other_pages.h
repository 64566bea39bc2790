// The pages for what is not a building: a landmark, the start, the route, and the map itself.
#pragma once

#include "widgets/panels/property_page.h"

class QCheckBox;
class QLabel;

namespace handmap {

class SureBox;

class LandmarkPage : public PropertyPage {
  Q_OBJECT
 public:
  explicit LandmarkPage(MapDocument& document);
  void refresh() override;

 private:
  Landmark landmark() const;
  void edit(const Landmark& landmark, const QString& text);

  QLineEdit* name_;
  NumberField* x_;
  NumberField* y_;
};

class StartPage : public PropertyPage {
  Q_OBJECT
 public:
  explicit StartPage(MapDocument& document);
  void refresh() override;

 private:
  void edit(double Pose2::*member, double value);
  void editUncertainty(double StartUncertainty::*member, double value);

  NumberField* x_;
  NumberField* y_;
  NumberField* heading_;
  NumberField* position_sigma_;
  NumberField* heading_sigma_;
};

class MapPage : public PropertyPage {
  Q_OBJECT
 public:
  explicit MapPage(MapDocument& document);
  void refresh() override;

 private:
  void addWholeUncertainty();
  void addGeoreference();
  void editGeoreference(double Georeference::*member, double value);

  QLineEdit* name_;
  SureBox* sure_;
  NumberField* position_sigma_;
  NumberField* size_sigma_;
  QCheckBox* whole_known_;
  NumberField* scale_sigma_;  ///< per cent
  NumberField* turn_sigma_;
  NumberField* shift_sigma_;
  QCheckBox* georeferenced_;
  NumberField* latitude_;
  NumberField* longitude_;
  NumberField* east_;
  QLabel* contents_;
};

/// Only words: the route, or objects of several kinds.
class SummaryPage : public PropertyPage {
  Q_OBJECT
 public:
  explicit SummaryPage(MapDocument& document);
  void refresh() override;

 private:
  QLabel* text_;
};

}  // namespace handmap
