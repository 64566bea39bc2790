// Draw around a building in one stroke. The stroke is added as it is; what it may have been meant
// to be is shown over it, and taken as a second step, so that one undo gives the stroke back.
#pragma once

#include "core/sketching/stroke_recognition.h"
#include "widgets/canvas/tool.h"

namespace handmap {

class FreehandTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  ToolId id() const override { return ToolId::Freehand; }
  QString hint() const override;
  bool cancel() override;
  void interrupt() override;
  void press(const ToolEvent& event) override;
  void move(const ToolEvent& event) override;
  void release(const ToolEvent& event) override;
  bool key(const ToolKey& key) override;
  bool isBusy() const override { return !stroke_.empty() || isGuessing(); }
  bool canFinish() const override { return isGuessing(); }
  bool canTakeBack() const override { return isGuessing(); }
  void finish() override;    ///< takes the guess that is shown
  void takeBack() override;  ///< the stroke goes as well
  void paint(ToolPaint& canvas) const override;

  /// Off: a stroke stays as it is drawn.
  void setRecognizing(bool on) { recognizing_ = on; }
  /// What is shown over the stroke; nullptr: nothing.
  const ShapeGuess* guess() const;
  void showNextGuess(int by = 1);

 private:
  bool isGuessing() const { return guess() != nullptr; }
  void addStroke(double resolution);

  bool recognizing_ = true;
  bool too_small_ = false;
  Polygon stroke_;
  double resolution_ = 0.1;
  QString of_;  ///< the building that the guesses are of
  std::vector<ShapeGuess> guesses_;
  std::size_t shown_ = 0;
};

}  // namespace handmap
