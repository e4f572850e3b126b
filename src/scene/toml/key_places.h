// Where the keys of a thing stand in the scene file, for messages of rooms that know no file.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "core/error.h"

namespace shatterpave::scene {

class TomlTable;

class KeyPlaces {
 public:
  KeyPlaces() = default;
  explicit KeyPlaces(const TomlTable& table);

  // Of a member such as `textures.tile_mm` or `impact[1].at_mm`; "" is the thing itself. Where the file does not give it, the
  // place of the table that it would stand in.
  Place place(std::string_view member) const;

  // Where a value stands is no part of what it says.
  bool operator==(const KeyPlaces& /*other*/) const { return true; }

 private:
  std::string path_;
  std::map<std::string, Place, std::less<>> places_;  // by member
};

}  // namespace shatterpave::scene
