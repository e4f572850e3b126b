// A model of the face as the rooms make it.
#pragma once

#include <shatterpave/model.h>

#include <string>
#include <vector>

#include "export/model.h"

namespace shatterpave {

class ModelAccess {
 public:
  static Model made(exporting::Model model, std::vector<Note> notes);
  static const exporting::Model& model(const Model& model);
};

}  // namespace shatterpave
