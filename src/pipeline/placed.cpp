#include "pipeline/placed.h"

#include <fmt/format.h>

#include "core/error.h"

namespace shatterpave::pipeline {

const scene::KeyPlaces& places_at(const std::vector<scene::KeyPlaces>& places, std::size_t i) {
  static const scene::KeyPlaces none;
  return i < places.size() ? places[i] : none;
}

Place known_place(const scene::KeyPlaces& places, const std::string& name, std::string_view member) {
  const bool is_known = !places.place("").key.empty();
  if (is_known) return places.place(member);
  return {"", 0, 0, member.empty() ? name : fmt::format("{}.{}", name, member)};
}

void with_places(const std::string& name, const scene::KeyPlaces& places, const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    const Place& place = error.place();
    const std::string head = name + ".";
    const Place known = places.place(place.key.starts_with(head) ? place.key.substr(head.size()) : std::string());
    if (!place.file.empty() || known.file.empty()) throw;
    throw InputError(known, error.message());
  }
}

}  // namespace shatterpave::pipeline
