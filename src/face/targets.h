// The targets that the face offers, from what `export` makes of them.
#pragma once

#include <string_view>
#include <vector>

#include "export/model.h"

namespace shatterpave::face {

struct TargetRow {
  std::string_view name;
  std::string_view sentence;
  void (*append)(const exporting::Model& model, exporting::Outputs& outputs);  // adds its files; the model must outlive them
};

const std::vector<TargetRow>& target_rows();

// Throws InputError where there is no target of that name.
const TargetRow& target_row(std::string_view name);

}  // namespace shatterpave::face
