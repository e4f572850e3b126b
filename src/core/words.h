// Words for messages: the name that was probably meant, and the names there are.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace shatterpave {

// The one of `candidates` that is most like `word`: by edits, two neighbours that changed places being one, or else the only
// one that starts with it (three letters or more); "" if none is near.
std::string_view nearest(std::string_view word, const std::vector<std::string_view>& candidates);

// "a, b or c", with `last` before the last one.
std::string listed(const std::vector<std::string_view>& names, std::string_view last);

// What helps someone who wrote `word` for one of `names`: "did you mean x?", or, where none is near, "there are a, b and c".
std::string hint(std::string_view word, const std::vector<std::string_view>& names);

}  // namespace shatterpave
