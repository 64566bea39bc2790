// What a person has said on the run that there is: where the robot was, which building is right or
// not there. Each is a step of the drawing's undo stack, and can be taken back by itself.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <vector>

#include "core/map/map.h"
#include "core/recording/trajectory.h"
#include "core/session/acts.h"

namespace handmap {

class MapDocument;

/// With the building that it is about as it was drawn before.
struct Said {
  Act act;
  std::optional<Building> before = {};
};

class SaidActs : public QObject {
  Q_OBJECT
 public:
  /// The document must outlive it.
  explicit SaidActs(MapDocument& document, QObject* parent = nullptr);

  /// Another run, that goes through these poses: what was said before is no longer to be undone.
  void begin(const std::vector<StampedPose>& given = {});
  const std::vector<Said>& all() const { return now_.said; }
  /// Where the robot was, by all that was said.
  std::vector<StampedPose> poses() const;

  /// As one undo step, with what `change` does to the drawing.
  void say(const std::vector<Said>& said, const QString& text,
           const std::function<void()>& change = {});
  /// The poses that the run goes through, in place of those that were given.
  void givePoses(const std::vector<StampedPose>& poses, const QString& text);
  /// One of all(): the drawing and the run are to be as if it had not been said. An undo step too.
  void takeBack(std::size_t index);

 Q_SIGNALS:
  void changed();
  /// Something was undone, done again or taken back: the run is to be done again.
  void wanted();

 private:
  class Command;
  struct State {
    std::vector<StampedPose> given;
    std::vector<Said> said;
  };
  void push(const State& state, const QString& text, const std::function<void()>& change);
  void restore(int run, const State& state);
  void want();

  MapDocument& document_;
  State now_;
  int run_ = 0;  ///< counts begin()
  bool wanted_ = false;
};

}  // namespace handmap
