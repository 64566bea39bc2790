// A picture under the drawing: where it lies, how strong it shows, and how to bring it there.
#pragma once

#include <QPointer>

#include "widgets/panels/property_page.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace handmap {

class PictureTool;

class PicturePage : public PropertyPage {
  Q_OBJECT
 public:
  explicit PicturePage(MapDocument& document);
  void refresh() override;
  /// The tool that the buttons hand their work to.
  void setTool(PictureTool& tool);

 Q_SIGNALS:
  void toolRequested();

 private:
  std::optional<std::size_t> place() const;
  template <typename Change>
  void edit(const QString& text, bool mergeable, Change change);
  QCheckBox* addFlag(const char* name, const QString& text, const QString& step, bool Flags::*flag);
  void addTool();
  void refreshTool();

  QPointer<PictureTool> tool_;
  QLabel* file_;
  NumberField* x_;
  NumberField* y_;
  NumberField* scale_;
  NumberField* heading_;
  NumberField* opacity_;
  QCheckBox* hidden_;
  QCheckBox* locked_;
  QPushButton* by_length_;
  NumberField* length_;
  std::optional<double> typed_length_;
  QPushButton* by_points_;
  QPushButton* fit_;
};

}  // namespace handmap
