// How well a few typed letters match a text: letters in order, not all of them side by side.
#pragma once

#include <QString>
#include <optional>

namespace handmap {

/// Greater is better: letters at the beginnings of words and side by side count more. nullopt: not
/// all letters of `pattern` (blanks do not count) are in `text` in that order. Case is ignored.
std::optional<int> fuzzyScore(const QString& pattern, const QString& text);

}  // namespace handmap
