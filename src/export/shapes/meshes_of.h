// For targets that write every body with its meshes: those that bodies share are kept.
#pragma once

#include <unordered_map>
#include <vector>

#include "export/shapes/body.h"

namespace shatterpave::exporting::shapes {

class SharedPieces {
 public:
  // The pieces of the body; valid until the next call.
  const std::vector<Piece>& of(const Body& body) {
    if (!body.shared) return body.pieces;
    const auto [found, is_new] = kept_.try_emplace(*body.shared, body.pieces);
    return found->second;
  }
  // Numbers of shared meshes are those of one thing.
  void begin_thing() { kept_.clear(); }

 private:
  std::unordered_map<std::size_t, std::vector<Piece>> kept_;
};

}  // namespace shatterpave::exporting::shapes
