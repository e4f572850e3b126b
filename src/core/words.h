// Words for messages: the name that was probably meant, and lists of names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace shatterpave {

// The candidate most like `word`: the one that is fewest edits away, where a swap of neighbours is one edit, or else the only
// one that starts with it (three letters or more); "" if none is near.
std::string_view nearest(std::string_view word, const std::vector<std::string_view>& candidates);

// "a, b or c", with `last` before the last one.
std::string listed(const std::vector<std::string_view>& names, std::string_view last);

// A hint for someone who wrote `word` for one of `names`: "did you mean x?", or, if none is near, "there are a, b and c".
std::string hint(std::string_view word, const std::vector<std::string_view>& names);

}  // namespace shatterpave
