// Where each object of a list is, by its id: for whoever looks up many of them.
#pragma once

#include <string_view>
#include <unordered_map>
#include <vector>

namespace handmap {

/// The ids live in the list: it must outlive the table, unchanged.
template <typename Item>
std::unordered_map<std::string_view, std::size_t> placesOf(const std::vector<Item>& items) {
  std::unordered_map<std::string_view, std::size_t> places;
  places.reserve(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) places.emplace(items[i].id, i);
  return places;
}

}  // namespace handmap
