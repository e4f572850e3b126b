// Pieces of the report of `measure`.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "measure/distribution.h"
#include "measure/finding.h"
#include "report/json_values.h"

namespace shatterpave::reporting {

using Buffer = fmt::memory_buffer;

template <typename... Arguments>
void put_html(Buffer& out, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Arguments>(arguments)...);
}

// As text of an element.
std::string escaped(std::string_view text);

// A script element ends at the first "</script", even within a string of the script. Only in strings and patterns can a script
// have these characters, and there a backslash changes nothing else. (Not so "</" alone: /</g is a pattern.)
std::string as_script(std::string_view text);

// Rounded to what a plot can show, so that files stay small.
double rounded(double value);

// Cells that hold something, as [from, to, percentage].
Json histogram_data(const measure::Histogram& histogram);

// Rows of the table of findings. Their ids are those of the findings after `prefix`. Where there are findings `beside` them, a
// last column has the figure of that with the same id.
std::string findings_rows(std::span<const measure::Finding> findings, std::string_view prefix = "",
                          std::span<const measure::Finding> beside = {});

// "11 of 12 hold, 1 fail".
std::string verdict_words(std::span<const measure::Finding> findings);

// "12.3 ± 0.4"; "–" without values.
std::string mean_and_deviation(const measure::Distribution& distribution, int decimals);

// Replaces the mark `<!--@mark-->` of the page, which must have it.
void fill(std::string& page, std::string_view mark, std::string_view text);

}  // namespace shatterpave::reporting
