// Which of several places of each building go together.
#pragma once

#include <vector>

namespace handmap {

/// A place of one building and one of another that cannot both be worth what they are alone.
struct ModeConflict {
  std::size_t building, mode;
  std::size_t other, other_mode;
  double cost;  ///< nats
};

/// `worth`: by building, of each of its modes (nats); none is worth 0. Returns the mode of each
/// building, or kNoMode, so that what all are worth together is as great as changing the modes of
/// two buildings in conflict can make it, begun with the best of each that is left.
std::vector<int> chooseModes(const std::vector<std::vector<double>>& worth,
                             const std::vector<ModeConflict>& conflicts);

}  // namespace handmap
