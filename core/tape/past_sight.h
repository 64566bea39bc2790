// What the sensors saw at one observation of a run: found where the run keeps it, when somebody
// asks.
#pragma once

#include <cstddef>
#include <memory>

#include "core/perception/local_map.h"

namespace handmap {

struct Perceived;
class Tape;

class PastSight {
 public:
  PastSight() = default;  ///< none
  PastSight(const std::shared_ptr<const Tape>& tape, std::size_t n) : tape_(tape), n_(n) {}
  /// For as long as somebody else holds it.
  explicit PastSight(const std::shared_ptr<const Perceived>& held) : held_(held) {}

  /// nullptr where the run no longer keeps it.
  std::shared_ptr<const Perceived> lock() const;
  /// The walls around the robot, from what is kept when it is read; none without a tape.
  LazyLocalMap localMap() const;

 private:
  std::weak_ptr<const Tape> tape_;
  std::size_t n_ = 0;
  std::weak_ptr<const Perceived> held_;
};

}  // namespace handmap
