// Look through what was read from a photo of a drawing: each building is taken or left before any
// of it is in the drawing.
#pragma once

#include <QImage>
#include <vector>

#include "widgets/canvas/tool.h"

namespace handmap {

struct PaperReview {
  struct Proposal {
    Building building;
    bool taken = true;
    QImage ink = {};        ///< what it was drawn with: black where there is some
    QPoint ink_at = {};     ///< of its top left corner, pixels of the page
    bool replaces = false;  ///< it is drawn over a building that the drawing has
    int number = 0;         ///< the same shape in a newer review has the same; 0: there are none
  };

  QImage page;
  Underlay place;  ///< where the page lies
  std::vector<Proposal> proposals;
};

class PaperTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  ToolId id() const override { return ToolId::Paper; }
  QString hint() const override;
  Qt::CursorShape cursor() const override { return Qt::PointingHandCursor; }
  bool cancel() override;
  void interrupt() override {}
  void press(const ToolEvent& event) override;
  void move(const ToolEvent& event) override;
  bool key(const ToolKey& key) override;
  bool removeChosen() override;
  bool isBusy() const override { return !review_.page.isNull(); }
  bool canFinish() const override { return takenCount() > 0; }
  void finish() override;
  void paint(ToolPaint& canvas) const override;

  void setReview(PaperReview review);
  /// What was ticked is in the drawing.
  void endReview();
  /// A newer one of the same page: what was ticked or not stays so.
  void renewReview(PaperReview review);
  const PaperReview& review() const { return review_; }
  int takenCount() const;

 Q_SIGNALS:
  /// Indices of the proposals that are ticked. Whoever could take them ends the review.
  void taken(const std::vector<std::size_t>& proposals);
  void abandoned();

 private:
  std::optional<std::size_t> at(const Vec2& position) const;
  void toggle(std::size_t index);
  void step(int by);
  void paintPage(ToolPaint& canvas) const;

  PaperReview review_;
  std::optional<std::size_t> current_;
};

}  // namespace handmap
