#include "pipeline/placed.h"

#include "core/error.h"

namespace shatterpave::pipeline {

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
