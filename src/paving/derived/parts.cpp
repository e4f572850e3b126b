#include "paving/derived/parts.h"

#include <fmt/format.h>

#include <utility>

#include "core/error.h"
#include "paving/derived/kerb.h"
#include "paving/derived/steps.h"

namespace shatterpave::paving {

std::string part_name(const std::string& name, std::size_t number) {
  return number == 1 ? name : fmt::format("{}_{}", name, number);
}

std::vector<Part> parts(const Pavement& pavement, std::size_t first_number) {
  std::vector<Part> result;
  if (pavement.flight) {
    ENSURE(pavement.kerb.width_mm == 0.0);
    for (Pavement& step : steps(pavement)) {
      step.name = part_name(pavement.name, first_number + result.size());
      result.push_back({std::move(step), StonePart::step});
    }
    return result;
  }
  result.push_back({pavement, StonePart::field});
  result.front().pavement.name = part_name(pavement.name, first_number);
  if (pavement.kerb.width_mm > 0.0) result.push_back({kerb(result.front().pavement), StonePart::kerb});
  return result;
}

}  // namespace shatterpave::paving
