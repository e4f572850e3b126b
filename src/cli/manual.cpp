#include "cli/manual.h"

#include <fmt/format.h>
#include <shatterpave/version.h>

#include <string_view>
#include <vector>

#include "cli/usage.h"
#include "export/targets.h"

namespace shatterpave::cli {

namespace {

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

// ---- man

// Text as it stands: a backslash, and a dot or an apostrophe at the start of a line, mean something to roff; a hyphen is no
// dash.
std::string roff(std::string text) {
  text = replaced(std::move(text), "\\", "\\e");
  text = replaced(std::move(text), "…", "...");
  text = replaced(std::move(text), "-", "\\-");
  text = replaced(std::move(text), "\n.", "\n\\&.");
  text = replaced(std::move(text), "\n'", "\n\\&'");
  if (text.starts_with('.') || text.starts_with('\'')) text.insert(0, "\\&");
  return text;
}

// "-o DIR", "--seed N", "-h, --help"; of what is no option its name.
std::string usage_of(const CLI::Option& option) {
  std::string names;
  for (const std::string& name : option.get_snames()) names += (names.empty() ? "-" : ", -") + name;
  for (const std::string& name : option.get_lnames()) names += (names.empty() ? "--" : ", --") + name;
  if (names.empty()) return option.get_name();
  if (option.get_items_expected_min() > 0) names += " " + option.get_type_name();
  return names;
}

bool is_positional(const CLI::Option& option) { return option.get_snames().empty() && option.get_lnames().empty(); }

void append_options(std::string& page, const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    page += fmt::format(".TP\n.B {}\n{}\n", roff(usage_of(*option)), roff(option->get_description()));
  }
}

std::string synopsis_of(const CLI::App& command) {
  std::string line = fmt::format(".B shatterpave {}\n", command.get_name());
  for (const CLI::Option* option : command.get_options()) {
    if (is_positional(*option)) line += fmt::format(".I {}\n", roff(option->get_name()));
  }
  return line + "[options]\n";
}

// ---- shells

std::string option_words(const CLI::App& command) {
  std::string words;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_snames()) words += (words.empty() ? "-" : " -") + name;
    for (const std::string& name : option->get_lnames()) words += (words.empty() ? "--" : " --") + name;
  }
  return words;
}

std::string target_words() {
  std::string words;
  for (const exporting::Target* target : exporting::targets())
    words += fmt::format("{}{}", words.empty() ? "" : " ", target->name);
  return words;
}

// What zsh offers for the value of an option, or for a positional.
std::string zsh_action(const CLI::Option& option) {
  const std::string value = is_positional(option) ? option.get_name() : option.get_type_name();
  if (value == "DIR") return "_files -/";
  if (value == "TARGET") return fmt::format("({})", target_words());
  if (value == "QUALITY") return "(draft final)";
  if (value == "FORM") return "(man bash zsh)";
  if (value.ends_with(".toml")) return "_files -g \"*.toml\"";
  return is_positional(option) ? "_files" : " ";
}

// Within single quotes, brackets and colons.
std::string zsh_text(std::string text) {
  text = replaced(std::move(text), "'", "'\\''");
  text = replaced(std::move(text), "[", "\\[");
  text = replaced(std::move(text), "]", "\\]");
  return replaced(std::move(text), ":", "\\:");
}

std::string zsh_option(const CLI::Option& option) {
  const std::string sentence = zsh_text(option.get_description());
  if (is_positional(option)) return fmt::format(" '*:{}:{}'", zsh_text(option.get_name()), zsh_action(option));
  std::string words;
  const bool has_value = option.get_items_expected_min() > 0;
  const std::string value = has_value ? fmt::format(":{}:{}", zsh_text(option.get_type_name()), zsh_action(option)) : "";
  for (const std::string& name : option.get_snames()) words += fmt::format(" '*-{}[{}]{}'", name, sentence, value);
  for (const std::string& name : option.get_lnames()) words += fmt::format(" '*--{}[{}]{}'", name, sentence, value);
  return words;
}

}  // namespace

std::string manual(const CLI::App& app, std::size_t form) {
  switch (form) {
    case 1:
      return bash_completion(app);
    case 2:
      return zsh_completion(app);
    default:
      return manual_page(app);
  }
}

std::string manual_page(const CLI::App& app) {
  std::string page = fmt::format(".TH SHATTERPAVE 1 \"\" \"shatterpave {}\" \"User Commands\"\n", SHATTERPAVE_VERSION);
  page +=
      fmt::format(".SH NAME\nshatterpave \\- shattered window glass and stone paving for offline renderers\n.SH SYNOPSIS\n");
  std::string_view between;
  for (const CLI::App* command : commands(app)) {
    page += between;
    page += synopsis_of(*command);
    between = ".br\n";
  }
  page += fmt::format(
      ".SH DESCRIPTION\n{}\nA scene file (TOML) tells what is broken and what is paved; "
      ".B shatterpave keys\nlists all that it may hold.\n",
      roff(app.get_description()));
  page = replaced(std::move(page), "paved; .B", "paved;\n.B");
  page += ".SH OPTIONS\n";
  append_options(page, app);
  page += ".SH COMMANDS\n";
  for (const CLI::App* command : commands(app)) {
    page += fmt::format(".SS shatterpave {}\n{}\n", command->get_name(), roff(command->get_description()));
    append_options(page, *command);
  }
  page += ".SH TARGETS\n";
  for (const exporting::Target* target : exporting::targets()) {
    page += fmt::format(".TP\n.B {}\n{}\n", target->name, roff(std::string(target->sentence)));
  }
  page +=
      ".SH EXIT STATUS\n.TP\n.B 0\nAll is done.\n.TP\n.B 1\nThe program itself failed.\n.TP\n.B 2\nThe input or the usage is "
      "wrong; one "
      "message tells where.\n.TP\n.B 3\nThe renderer failed.\n.SH SEE ALSO\n.BR povray (1)\n";
  return page;
}

std::string bash_completion(const CLI::App& app) {
  std::string names;
  std::string cases;
  for (const CLI::App* command : commands(app)) {
    names += (names.empty() ? "" : " ") + command->get_name();
    cases += fmt::format("    {}) options='{}' ;;\n", command->get_name(), option_words(*command));
  }
  return fmt::format(R"(# bash completion for shatterpave
_shatterpave() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} options
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W '{} {}' -- "$word")
    return
  fi
  case $before in
    -o) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -d -- "$word"); return ;;
    --target) mapfile -t COMPREPLY < <(compgen -W '{}' -- "$word"); return ;;
    --quality) mapfile -t COMPREPLY < <(compgen -W 'draft final' -- "$word"); return ;;
  esac
  case ${{COMP_WORDS[1]}} in
{}  esac
  if [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
  else
    compopt -o filenames
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  fi
}}
complete -F _shatterpave shatterpave
)",
                     names, option_words(app), target_words(), cases);
}

std::string zsh_completion(const CLI::App& app) {
  std::string names;
  std::string cases;
  for (const CLI::App* command : commands(app)) {
    names += fmt::format("    '{}:{}'\n", command->get_name(), zsh_text(command->get_description()));
    cases += fmt::format("    {}) _arguments", command->get_name());
    for (const CLI::Option* option : command->get_options()) cases += zsh_option(*option);
    cases += " ;;\n";
  }
  return fmt::format(R"(#compdef shatterpave
_shatterpave() {{
  local -a commands
  commands=(
{}  )
  if ((CURRENT == 2)); then
    _describe command commands
    return
  fi
  local command=$words[2]
  shift words
  ((CURRENT--))
  case $command in
{}  esac
}}
_shatterpave "$@"
)",
                     names, cases);
}

}  // namespace shatterpave::cli
