#include "core/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace shatterpave {

namespace {

constexpr std::size_t longest_word = 64;

// The number of edits from one word to the other: letters inserted, left out, replaced, or swapped with a neighbour (the
// distance of optimal string alignment).
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1), last[j] + 1, row[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    std::swap(before_last, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

std::string_view started(std::string_view word, const std::vector<std::string_view>& candidates) {
  constexpr std::size_t least = 3;
  std::string_view found;
  if (word.size() < least) return found;
  for (const std::string_view candidate : candidates) {
    if (!candidate.starts_with(word)) continue;
    if (!found.empty()) return {};
    found = candidate;
  }
  return found;
}

}  // namespace

std::string_view nearest(std::string_view word, const std::vector<std::string_view>& candidates) {
  std::string_view best;
  if (word.size() > longest_word) return best;
  // More than a third of the letters wrong is another word, not a slip.
  std::size_t fewest = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string_view candidate : candidates) {
    const std::size_t count = edits(word, candidate);
    // If every letter differs, the words have nothing in common.
    if (count >= fewest || count >= std::max(word.size(), candidate.size())) continue;
    fewest = count;
    best = candidate;
  }
  return best.empty() ? started(word, candidates) : best;
}

std::string listed(const std::vector<std::string_view>& names, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 < names.size() ? std::string(", ") : fmt::format(" {} ", last);
    text += names[i];
  }
  return text;
}

std::string hint(std::string_view word, const std::vector<std::string_view>& names) {
  const std::string_view meant = nearest(word, names);
  if (!meant.empty()) return fmt::format("did you mean {}?", meant);
  return fmt::format("there {} {}", names.size() == 1 ? "is" : "are", names.empty() ? "none" : listed(names, "and"));
}

}  // namespace shatterpave
