// Messages about the command line: each names the word, what was expected, the names there are, and the one that was probably
// meant.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/input_file.h"

namespace shatterpave::cli {

using Texts = std::vector<std::string>;

// In the order in which they were added.
std::vector<const CLI::App*> commands(const CLI::App& app);

// Throws InputError: "shatterpave: WHAT: expected …, got …".
[[noreturn]] void refuse_usage(std::string_view what, std::string_view expected, std::string_view got);

using scene::in_quotes;

// What the option was given; nothing where it is not there. Refuses it twice.
std::optional<std::string> the_only(const Texts& given, std::string_view option);

struct WholeRange {
  std::int64_t low = 0;
  std::int64_t high = 0;
};

// Digits alone, with a sign; nothing where `text` is something else or out of range.
std::optional<std::int64_t> whole_number(std::string_view text, const WholeRange& range);
// The same of an option, which refuses what is none.
std::int64_t whole_number_of(std::string_view text, std::string_view option, const WholeRange& range);

// A number written in digits, with a sign, point and exponent; nothing where `text` is something else or out of range.
std::optional<double> real_number(std::string_view text, double low, double high);

// The index of `text` among `names`.
std::size_t choice_of(std::string_view text, std::string_view option, std::span<const std::string_view> names);

// Refuses `words` that begin with no command of `app`, or that hold an option that the command has not, or has not got a value
// for.
void require_known_words(const CLI::App& app, const Texts& words);

// What is left for CLI11 to refuse.
[[noreturn]] void refuse_parsed(const CLI::ParseError& error);

}  // namespace shatterpave::cli
