// The manual page and completions for shells, made of what `--help` is made of.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace shatterpave::cli {

// In the order of `manual`.
inline constexpr std::array<std::string_view, 3> manual_forms = {"man", "bash", "zsh"};

// The form of that number.
std::string manual(const CLI::App& app, std::size_t form);

// In the language of man (roff), section 1: all commands on one page.
std::string manual_page(const CLI::App& app);

// Completion for bash: commands, their options, and files where a file is wanted.
std::string bash_completion(const CLI::App& app);

// The same for zsh, with the sentences of the options.
std::string zsh_completion(const CLI::App& app);

}  // namespace shatterpave::cli
