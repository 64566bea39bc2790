// A toggle is a change of the map that is its own inverse: called twice, nothing has happened. It
// holds what the map does not hold at the moment, so commands stay as small as what they change.
#pragma once

#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/map/map.h"
#include "widgets/document/touched.h"

namespace handmap {

struct Toggle {
  std::function<void(Map&)> flip;
  Touched touched;
};

/// By a member of the map as a whole.
template <typename Value>
Touched touchedBy() {
  if constexpr (std::is_same_v<Value, std::vector<Building>>) return {.listed = true};
  if constexpr (std::is_same_v<Value, std::vector<Landmark>>) return {.landmarks = true};
  if constexpr (std::is_same_v<Value, std::vector<Underlay>>) return {.underlays = true};
  if constexpr (std::is_same_v<Value, std::vector<Vec2>>) return {.route = true};
  if constexpr (std::is_same_v<Value, LayerStates>) return {.layers = true};
  if constexpr (std::is_same_v<Value, std::optional<Pose2>> ||
                std::is_same_v<Value, std::optional<StartUncertainty>>)
    return {.start = true};
  return {.rest = true};
}

/// Items with their places in the list, in rising order.
template <typename Item>
using Placed = std::vector<std::pair<std::size_t, Item>>;

template <typename Value>
Toggle swapMember(Value Map::*member, Value value) {
  return {[member, value = std::move(value)](Map& map) mutable { std::swap(map.*member, value); },
          touchedBy<Value>()};
}

template <typename Item>
Toggle swapItems(std::vector<Item> Map::*list, Placed<Item> items) {
  Touched touched;
  if constexpr (std::is_same_v<Item, Building>) {
    for (const auto& [place, building] : items) touched.buildings.push_back(place);
  } else {
    touched = touchedBy<std::vector<Item>>();
  }
  return {[list, items = std::move(items)](Map& map) mutable {
            for (auto& [place, item] : items) std::swap((map.*list)[place], item);
          },
          std::move(touched)};
}

/// Takes the items at the places out of the list (`present`) or puts them there.
template <typename Item>
Toggle toggleItems(std::vector<Item> Map::*list, Placed<Item> items, bool present) {
  auto flip = [list, items = std::move(items), present](Map& map) mutable {
    std::vector<Item> before = std::move(map.*list);
    std::vector<Item>& after = map.*list = {};
    after.reserve(before.size() + items.size());
    auto next = items.begin();
    if (present) {
      for (std::size_t i = 0; i < before.size(); ++i) {
        if (next != items.end() && next->first == i)
          (next++)->second = std::move(before[i]);
        else
          after.push_back(std::move(before[i]));
      }
    } else {
      for (auto old = before.begin(); old != before.end() || next != items.end();) {
        if (next != items.end() && next->first == after.size())
          after.push_back(std::move((next++)->second));
        else
          after.push_back(std::move(*old++));
      }
    }
    present = !present;
  };
  return {std::move(flip), touchedBy<std::vector<Item>>()};
}

}  // namespace handmap
