// What decides whether the keys of a pavement have an effect.
#pragma once

#include <string_view>
#include <variant>

#include "paving/bonds/table.h"
#include "paving/pavement.h"
#include "scene/toml/toml_table.h"

namespace shatterpave::scene {

struct PavementFacts {
  static constexpr std::string_view path = "pavement[]";
  const TomlTable& table;
  const paving::Pavement& pavement;

  bool is_flight() const { return pavement.flight.has_value(); }
  bool has(std::string_view key) const { return table.place_of_given(key).has_value(); }
  // What is laid: a flight is of rows, running ones unless told.
  const paving::BondType& bond() const {
    const paving::BondType& type = paving::type_of(pavement);
    return is_flight() && type.bending != paving::Bending::rows ? paving::type_of(paving::Bond::running) : type;
  }
  template <typename Kind>
  bool runs() const {
    return std::holds_alternative<Kind>(pavement.direction);
  }
  bool is_straight() const { return runs<paving::ConstantDirection>(); }
  bool is_rows() const { return bond().bending == paving::Bending::rows; }
  bool is_packed() const { return bond().bending == paving::Bending::packed; }
  bool bends() const { return bond().bending != paving::Bending::straight; }
  bool has_body() const { return pavement.body.finish != paving::Finish::none; }
};

inline constexpr std::string_view beside_steps = "beside [pavement.steps]";

inline bool in_a_flight(const PavementFacts& f) { return f.is_flight(); }

}  // namespace shatterpave::scene
