#include "widgets/actions/fuzzy.h"

#include <algorithm>
#include <vector>

namespace handmap {

namespace {

constexpr int kLetter = 1;
constexpr int kAtWord = 8;
constexpr int kBesideLast = 5;
constexpr int kImpossible = -1'000'000;

bool beginsWord(const QString& text, qsizetype at) {
  return at == 0 || !text[at - 1].isLetterOrNumber();
}

}  // namespace

std::optional<int> fuzzyScore(const QString& pattern, const QString& text) {
  const QString wanted = pattern.toCaseFolded().remove(u' ');
  const QString given = text.toCaseFolded();
  const auto length = static_cast<std::size_t>(given.size());
  // best[i]: the best score with the letters so far, the last of them at i.
  std::vector<int> best(length, kImpossible);
  bool is_first = true;
  for (const QChar letter : wanted) {
    std::vector<int> next(length, kImpossible);
    int before = is_first ? 0 : kImpossible;  // the best that ends left of i
    for (std::size_t i = 0; i < length; ++i) {
      const auto at = static_cast<qsizetype>(i);
      if (given[at] == letter) {
        int score = before;
        if (i > 0) score = std::max(score, best[i - 1] + kBesideLast);
        next[i] = score + kLetter + (beginsWord(given, at) ? kAtWord : 0);
      }
      if (!is_first) before = std::max(before, best[i]);
    }
    best = std::move(next);
    is_first = false;
  }
  if (is_first) return 0;
  const int score = best.empty() ? kImpossible : *std::ranges::max_element(best);
  return score > 0 ? std::optional(score) : std::nullopt;
}

}  // namespace handmap
