#include "core/base/spelling.h"

#include <algorithm>
#include <cctype>

namespace handmap {

namespace {

constexpr std::size_t kMostLetters = 64;
constexpr std::size_t kLeastBeginning = 4;  // letters: shorter ones begin too many words

std::string folded(std::string_view word) {
  std::string text(word.substr(0, kMostLetters));
  std::ranges::transform(text, text.begin(), [](unsigned char c) {
    return c == '-' ? '_' : static_cast<char>(std::tolower(c));
  });
  return text;
}

bool oneBegins(const std::string& a, const std::string& b) {
  return std::min(a.size(), b.size()) >= kLeastBeginning && (a.starts_with(b) || b.starts_with(a));
}

}  // namespace

std::size_t editDistance(std::string_view first, std::string_view second) {
  const std::string a = folded(first);
  const std::string b = folded(second);
  std::vector<std::vector<std::size_t>> steps(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        steps[i][j] = i + j;
        continue;
      }
      steps[i][j] = std::min({steps[i - 1][j] + 1, steps[i][j - 1] + 1,
                              steps[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) steps[i][j] = std::min(steps[i][j], steps[i - 2][j - 2] + 1);
    }
  }
  return steps[a.size()][b.size()];
}

std::optional<std::string> likelyMeant(std::string_view word,
                                       const std::vector<std::string_view>& known) {
  std::optional<std::string> best;
  std::size_t least = kMostLetters;
  for (const std::string_view candidate : known) {
    const std::size_t distance =
        oneBegins(folded(word), folded(candidate)) ? 1 : editDistance(word, candidate);
    if (distance >= least || 3 * distance > std::max(candidate.size(), word.size())) continue;
    least = distance;
    best = std::string(candidate);
  }
  return best;
}

}  // namespace handmap
