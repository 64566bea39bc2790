// Where a drive of a real robot begins, when it is not the first of the window: the robot stands
// where it stopped, the drawing still says where it began.
#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <optional>

#include "app/gui/shell/shell.h"
#include "core/geometry/pose2.h"
#include "core/method/snapshot.h"

namespace handmap {

class LiveLink;
class MapDocument;
struct Robot;

class DriveStart : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive it.
  DriveStart(const Shell& shell, MapDocument& document);

  /// A drive has ended there; one that was lost by then tells nothing.
  void ended(const std::shared_ptr<LiveLink>& link, const Snapshot& newest);
  /// Whether a person is asked where the robot begins; `begin` comes with the answer.
  bool ask(const Robot& robot, std::function<void()> begin);

 private:
  struct End {
    std::weak_ptr<LiveLink> robot;
    Pose2 pose;
    std::optional<Pose2> start;  ///< of the drawing, then
  };
  void answer(const std::function<void()>& begin);

  const Shell& shell_;
  MapDocument& document_;
  std::optional<End> end_;
};

}  // namespace handmap
