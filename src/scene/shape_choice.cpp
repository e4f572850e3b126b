#include "scene/shape_choice.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/input_file.h"

namespace shatterpave::scene {

namespace {

std::string listed(const std::vector<std::string>& ids) {
  constexpr std::size_t most_listed = 10;
  std::string list;
  for (std::size_t i = 0; i < std::min(ids.size(), most_listed); ++i) {
    list += fmt::format("{}{}", list.empty() ? "" : ", ", i);
    if (!ids[i].empty()) list += fmt::format(" (id {})", in_quotes(ids[i]));
  }
  return ids.size() > most_listed ? list + ", …" : list;
}

}  // namespace

std::size_t chosen_shape(const std::vector<std::string>& ids, std::string_view what, const OutlineChoice& choice,
                         const std::string& file) {
  if (ids.empty()) throw InputError(Place{file, 0, 0, ""}, fmt::format("expected a {}, got none", what));
  const std::string of_file = fmt::format("of the {} {}s of {}", ids.size(), what, in_quotes(file));
  if (choice.index) {
    if (*choice.index < ids.size()) return *choice.index;
    throw InputError(choice.choice_place,
                     fmt::format("expected an index below {}, the number {}; got {}", ids.size(), of_file, *choice.index));
  }
  if (choice.id) {
    const auto count = std::ranges::count(ids, *choice.id);
    if (count == 1) return static_cast<std::size_t>(std::ranges::find(ids, *choice.id) - ids.begin());
    throw InputError(choice.choice_place, fmt::format("expected the id or the index of one {}: {}; got {}, the id of {}",
                                                      of_file, listed(ids), in_quotes(*choice.id), count));
  }
  if (ids.size() == 1) return 0;
  throw InputError(choice.choice_place,
                   fmt::format("expected the id or the index of one {}: {}; got none", of_file, listed(ids)));
}

}  // namespace shatterpave::scene
