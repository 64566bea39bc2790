// What all tools share that place points one after the other: by clicks, by a drag, by the arrow
// keys and Enter, or by typed numbers. A tool says what its points mean.
#pragma once

#include "widgets/canvas/tool.h"
#include "widgets/editing/typed_numbers.h"

namespace handmap {

class DrawingTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  void activate() override;
  bool cancel() override;
  void interrupt() override;
  void press(const ToolEvent& event) override;
  void move(const ToolEvent& event) override;
  void release(const ToolEvent& event) override;
  void doubleClick(const ToolEvent& event) override;
  bool key(const ToolKey& key) override;

  bool isBusy() const override { return !placed().empty() || !typed_.isEmpty(); }
  bool canTakeBack() const override { return !placed().empty(); }
  void takeBack() override;
  bool wants(QChar character) const override;
  std::optional<Vec2> keyboardCursor() const override;
  std::optional<SnapContext> snapContext() const override;
  void paint(ToolPaint& canvas) const override;

 protected:
  /// A number that may be typed for the next point, and its value as the pointer has it.
  struct Number {
    QString name;
    double value = 0.0;
    bool is_angle = false;  ///< degrees; metres otherwise
  };

  // --- What a tool says of its points
  /// After so many it is complete; 0: when the person says so.
  virtual std::size_t pointCount() const = 0;
  virtual std::vector<Number> numbers() const;
  /// The next point for a pointer there, with the numbers that are typed.
  virtual Vec2 constrained(const Vec2& pointer) const;
  virtual bool mayPlace(const Vec2&) const { return true; }
  virtual bool closesAt(const Vec2&) const { return false; }  ///< a point there finishes it
  virtual void complete() = 0;  ///< all points are placed: change the document
  /// Whether a click without a drag is all it takes.
  virtual bool isCompleteByClick() const { return false; }

  // --- Where the points are kept
  virtual const std::vector<Vec2>& placed() const { return placed_; }
  virtual void append(const Vec2& point) { placed_.push_back(point); }
  virtual void removeLast() { placed_.pop_back(); }

  const TypedNumbers& typed() const { return typed_; }
  Vec2 next() const { return constrained(pointer_); }
  const Vec2& pointer() const { return pointer_; }
  double metresPerPixel() const { return metres_per_pixel_; }
  Qt::KeyboardModifiers modifiers() const { return modifiers_; }
  double reach(double pixels) const { return pixels * pixel_reach_; }
  bool isRefused() const { return refused_; }
  void refuse() { refused_ = true; }
  bool isByKeys() const { return by_keys_; }
  bool isPointerKnown() const { return pointer_known_; }
  /// Points placed so far and the next one.
  std::vector<Vec2> withNext() const;

 private:
  void placeNext();
  void forgetTyping();
  void take(const ToolEvent& event);
  bool moveByKey(const ToolKey& key);
  bool enter();

  std::vector<Vec2> placed_;
  TypedNumbers typed_;
  Vec2 pointer_ = Vec2::Zero();
  bool pointer_known_ = false;
  bool by_keys_ = false;
  bool refused_ = false;  ///< the next point, or the last try, does not fit
  double metres_per_pixel_ = 0.1;
  double pixel_reach_ = 0.1;
  Qt::KeyboardModifiers modifiers_ = Qt::NoModifier;
  std::optional<Vec2> pressed_;  ///< where, not snapped
  bool began_by_press_ = false;  ///< the first point was placed by the press that is still held
};

}  // namespace handmap
