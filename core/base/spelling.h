// What somebody is likely to have meant.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handmap {

/// Letters to insert, leave out, change or swap with their neighbour until one is the other; case
/// and the difference of '-' and '_' do not count.
std::size_t editDistance(std::string_view a, std::string_view b);

/// The nearest of the known words; nullopt where none is near: a third of its letters, or one is
/// how the other begins ("range_limit" for "range_limit_m").
std::optional<std::string> likelyMeant(std::string_view word,
                                       const std::vector<std::string_view>& known);

}  // namespace handmap
