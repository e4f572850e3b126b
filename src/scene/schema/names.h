// The names of the things of a scene.
#pragma once

#include <map>
#include <string>

#include "core/error.h"

namespace shatterpave::scene {

// The names of a scene are unique, even where '-' and '_' are taken for the same, and capital and small letters, since they
// become names of files and of identifiers.
class Names {
 public:
  // `owner` says whose it is, for a message about another one of that name.
  void add(std::string name, const std::string& owner, const Place& place);

 private:
  std::map<std::string, std::string> owners_;
};

}  // namespace shatterpave::scene
