#include "paving/bonds/table.h"

#include <array>

#include "core/error.h"

namespace shatterpave::paving {

// Each in the file of its name.
extern const BondType packed_bond;
extern const BondType running_bond;
extern const BondType stack_bond;
extern const BondType herringbone_bond;
extern const BondType basket_weave_bond;
extern const BondType hexagon_bond;
extern const BondType segmental_arc_bond;
extern const BondType fan_bond;
extern const BondType ashlar_bond;
extern const BondType crazy_bond;
extern const BondType chevron_bond;
extern const BondType module_bond;
extern const BondType course_bond;

namespace {

constexpr std::array types = {&packed_bond,  &running_bond,       &stack_bond, &herringbone_bond, &basket_weave_bond,
                              &hexagon_bond, &segmental_arc_bond, &fan_bond,   &ashlar_bond,      &crazy_bond,
                              &chevron_bond, &module_bond,        &course_bond};
static_assert(types.size() == static_cast<std::size_t>(Bond::course) + 1,
              "one row for each value of Bond, whose last is course");

}  // namespace

std::span<const BondType* const> bond_types() { return types; }

const BondType& type_of(Bond bond) {
  const auto at = static_cast<std::size_t>(bond);
  ENSURE(at < types.size());
  const BondType& type = *types[at];
  ENSURE(type.id == bond);
  return type;
}

std::vector<std::string_view> names_of_bonds(bool (*is_so)(const BondType&)) {
  std::vector<std::string_view> names;
  for (const BondType* type : types) {
    if (type->is_for_scenes && is_so(*type)) names.push_back(type->name);
  }
  return names;
}

}  // namespace shatterpave::paving
