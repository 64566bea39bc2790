// Where a drive of a real robot begins, when it is not the first of the window: the robot stands
// where it stopped, the drawing still says where it began. Or somewhere else by now: what it sees
// first is held against what was seen there.
#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "app/gui/shell/shell.h"
#include "core/geometry/pose2.h"
#include "core/method/seen_place.h"
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

  /// A drive has ended there, of which this is known.
  void ended(const std::shared_ptr<LiveLink>& link, const Snapshot& newest,
             const std::shared_ptr<const Tape>& tape);
  /// Whether a person is asked where the robot begins; `begin` comes with the answer.
  bool ask(const Robot& robot, std::function<void()> begin);
  /// What was seen before where the drive begins that now does; nullptr where nobody knows.
  std::shared_ptr<const SeenPlace> takeSeen() { return std::exchange(seen_, nullptr); }

 private:
  struct End {
    std::weak_ptr<LiveLink> robot;
    std::optional<Pose2> pose;   ///< none: it was lost by then
    std::optional<Pose2> start;  ///< of the drawing, then
    SharedList<StampedPose> way;
    std::weak_ptr<const Tape> tape;
  };
  void answer(const std::function<void()>& begin);
  void look();

  const Shell& shell_;
  MapDocument& document_;
  std::optional<End> end_;
  std::shared_ptr<const SeenPlace> seen_;
};

}  // namespace handmap
