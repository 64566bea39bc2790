// Lay a picture under the drawing: move, turn and scale it by handles, scale it by the length of
// something in it, or pin points of it to points of the map.
#pragma once

#include <functional>
#include <vector>

#include "core/map/underlay_fit.h"
#include "widgets/canvas/tool.h"

class QSize;

namespace handmap {

class PictureTool : public Tool {
  Q_OBJECT
 public:
  enum class Mode { Place, Scale, Fit };
  /// Pixels of the picture at that place of the document's list.
  using SizeOf = std::function<QSize(std::size_t place)>;

  PictureTool(MapDocument& document, SizeOf size_of);

  ToolId id() const override { return ToolId::Picture; }
  QString hint() const override;
  Qt::CursorShape cursor() const override { return cursor_; }
  void activate() override;
  bool cancel() override;
  void interrupt() override;
  void press(const ToolEvent& event) override;
  void move(const ToolEvent& event) override;
  void release(const ToolEvent& event) override;
  bool key(const ToolKey& key) override;
  bool isBusy() const override { return grip_.has_value() || !points_.empty(); }
  bool canFinish() const override;
  bool canTakeBack() const override { return !points_.empty(); }
  void finish() override;
  void takeBack() override;
  bool wants(QChar character) const override;
  std::optional<SnapContext> snapContext() const override;
  const MapChange* preview() const override { return preview_ ? &*preview_ : nullptr; }
  void paint(ToolPaint& canvas) const override;

  Mode mode() const { return mode_; }
  void setMode(Mode mode);  ///< drops points that were set
  /// The picture at work: the selected one, or the topmost; nullopt: none, or it is locked.
  std::optional<std::size_t> current() const;

  // --- Scaling: two points of the picture, then how far apart they are
  std::optional<double> measured() const;  ///< metres now; nullopt: fewer than two points
  bool setLength(double length_m);         ///< false, and nothing is changed: it cannot be so

  // --- Pinning: pairs of a point of the picture and where it belongs
  std::size_t pairs() const { return points_.size() / 2; }
  bool fit();  ///< false, and nothing is changed: fewer than two pairs, or all at one place

 private:
  struct Grip {
    std::function<Underlay(const ToolEvent&)> change;
    QString text;  ///< of the undo step
  };

  Rectangle boxOf(std::size_t place) const;
  std::optional<Grip> gripAt(const ToolEvent& event) const;
  void change(std::size_t place, const Underlay& underlay, const QString& text, bool mergeable);
  bool nudge(const ToolKey& key);
  bool typeLength(const ToolKey& key);
  std::optional<double> typedLength() const;
  void addPoint(const ToolEvent& event);
  void paintPoints(ToolPaint& canvas) const;

  SizeOf size_of_;
  Mode mode_ = Mode::Place;
  bool pressed_ = false;  ///< where a point will be, once it is released
  std::optional<Grip> grip_;
  std::optional<MapChange> preview_;
  std::vector<Vec2> points_;  ///< Scale: on the map. Fit: pixel and point by turns
  Vec2 pointer_ = Vec2::Zero();
  QString typed_;  ///< of a length
  Qt::CursorShape cursor_ = Qt::ArrowCursor;
};

}  // namespace handmap
