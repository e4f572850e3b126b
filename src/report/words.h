// How the files of `measure` put a finding into words.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "measure/summary.h"

namespace shatterpave::reporting {

// "holds", "fails", "open". Promised to users.
std::string_view word_of(measure::Verdict verdict);

// "68,191".
std::string grouped(std::size_t count);

// The range in which a figure is wanted: "0.0615 ± 0.006", "≥ 99 %", "0".
std::string target_of(const measure::Finding& finding);

// The figure with its unit, to as many places as the range asks for, and its standard error where it has one: "0.0608 ±
// 0.0004"; "–" where nothing was measured.
std::string figure_of(const measure::Finding& finding);

}  // namespace shatterpave::reporting
