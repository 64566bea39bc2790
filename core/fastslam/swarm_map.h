// The refined buildings of a particle. A copy costs one pointer, and shares what neither changes.
#pragma once

#include <array>
#include <memory>

#include "core/fastslam/swarm.h"

namespace handmap {

/// A persistent array of swarms (Driscoll, Sarnak, Sleator, Tarjan, "Making data structures
/// persistent", 1989): a tree of eight branches a node, whose paths are copied when they change.
/// Buildings that were never seen take no memory.
class SwarmMap {
 public:
  explicit SwarmMap(std::size_t buildings = 1) {
    while (buildings > std::size_t{1} << (kBits * levels_)) ++levels_;
  }

  /// nullptr: never seen.
  const Swarm* find(std::size_t building) const {
    const void* slot = root_.get();
    for (unsigned level = levels_; slot != nullptr && level-- > 0;) {
      slot = (*static_cast<const Node*>(slot))[branch(building, level)].get();
    }
    return static_cast<const Swarm*>(slot);
  }

  void set(std::size_t building, std::shared_ptr<Swarm> swarm) {
    std::shared_ptr<void>* slot = &root_;
    for (unsigned level = levels_; level-- > 0;) {
      slot = &ownNode(*slot)[branch(building, level)];
    }
    *slot = std::move(swarm);
  }

 private:
  static constexpr unsigned kBits = 3;
  using Node = std::array<std::shared_ptr<void>, 1U << kBits>;  ///< of Node, in the end of Swarm

  static std::size_t branch(std::size_t building, unsigned level) {
    return (building >> (kBits * level)) % (1U << kBits);
  }
  static Node& ownNode(std::shared_ptr<void>& slot) {
    if (!slot) {
      slot = std::make_shared<Node>();
    } else if (slot.use_count() > 1) {
      slot = std::make_shared<Node>(*static_cast<const Node*>(slot.get()));
    }
    return *static_cast<Node*>(slot.get());
  }

  std::shared_ptr<void> root_;
  unsigned levels_ = 1;
};

}  // namespace handmap
