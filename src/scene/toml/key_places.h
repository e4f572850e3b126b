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

  // The place of a member such as `textures.tile_mm` or `impact[1].at_mm`, or for "" of the thing itself. If the file does not
  // give the member: the place of the table that it would stand in.
  Place place(std::string_view member) const;

  // All are equal, since the place of a value is not part of the value.
  bool operator==(const KeyPlaces& /*other*/) const { return true; }

 private:
  std::string path_;
  std::map<std::string, Place, std::less<>> places_;  // by member
};

}  // namespace shatterpave::scene
