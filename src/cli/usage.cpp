#include "cli/usage.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>

#include "core/error.h"
#include "core/words.h"

namespace shatterpave::cli {

namespace {

constexpr std::string_view program = "shatterpave";

std::vector<std::string_view> views(const Texts& texts) { return {texts.begin(), texts.end()}; }

// "--target", "-o".
Texts option_names(const CLI::App& command) {
  Texts names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

const CLI::Option* option_of(const CLI::App& command, const std::string& name) { return command.get_option_no_throw(name); }

bool is_option(const CLI::App& command, const std::string& word) {
  const Texts names = option_names(command);
  return std::ranges::find(names, word) != names.end();
}

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& names) {
  const std::string_view meant = nearest(word, names);
  return meant.empty() ? std::string() : fmt::format("; did you mean {}?", meant);
}

[[noreturn]] void refuse_command(const CLI::App& app, const std::string& word) {
  Texts names;
  for (const CLI::App* command : commands(app)) names.push_back(command->get_name());
  const std::string expected = "a command, " + listed(views(names), "or");
  if (word.empty()) throw InputError(fmt::format("{}: expected {}, got none (see {} --help)", program, expected, program));
  throw InputError(
      fmt::format("{}: expected {}, got {}{}", program, expected, in_quotes(word), did_you_mean(word, views(names))));
}

[[noreturn]] void refuse_option(const CLI::App& app, const CLI::App& command, const std::string& word) {
  const Texts names = option_names(command);
  std::string hint = did_you_mean(word, views(names));
  for (const CLI::App* other : commands(app)) {
    if (is_option(*other, word)) hint = fmt::format(", an option of {}", other->get_name());
  }
  refuse_usage(command.get_name(), "an option of " + listed(views(names), "or"), in_quotes(word) + hint);
}

// The option that a word begins: `--target`, `--target=json`, `-o`, `-oDIR`. The rest of the word is its value.
struct OptionWord {
  std::string name;
  std::optional<std::string> value;
};

OptionWord option_word(const std::string& word) {
  if (!word.starts_with("--")) {
    return {word.substr(0, 2), word.size() > 2 ? std::optional(word.substr(2)) : std::nullopt};
  }
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos) return {word, std::nullopt};
  return {word.substr(0, equals), word.substr(equals + 1)};
}

void require_value(const CLI::App& command, const CLI::Option& option, const OptionWord& given,
                   const std::optional<std::string>& next) {
  const std::string expected = fmt::format("{} after it", option.get_type_name());
  const std::optional<std::string>& value = given.value ? given.value : next;
  if (!value) refuse_usage(given.name, expected, "nothing");
  // CLI11 takes {} for nothing, and what follows for the value of an option with nothing after its '='.
  if (*value == "{}" || (given.value && value->empty())) refuse_usage(given.name, expected, in_quotes(*value));
  if (!given.value && is_option(command, *value)) refuse_usage(given.name, expected, "the option " + *value);
}

}  // namespace

std::vector<const CLI::App*> commands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

void refuse_usage(std::string_view what, std::string_view expected, std::string_view got) {
  throw InputError(fmt::format("{}: {}: expected {}, got {}", program, what, expected, got));
}

std::optional<std::string> the_only(const Texts& given, std::string_view option) {
  if (given.empty()) return std::nullopt;
  if (given.size() > 1) {
    refuse_usage(option, "it once",
                 fmt::format("it {} times, with {} and {}", given.size(), in_quotes(given[0]), in_quotes(given[1])));
  }
  return given.front();
}

std::optional<std::int64_t> whole_number(std::string_view text, const WholeRange& range) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < range.low || value > range.high) return std::nullopt;
  return value;
}

std::int64_t whole_number_of(std::string_view text, std::string_view option, const WholeRange& range) {
  const auto value = whole_number(text, range);
  if (!value) refuse_usage(option, fmt::format("a whole number from {} to {}", range.low, range.high), in_quotes(text));
  return *value;
}

std::optional<double> real_number(std::string_view text, double low, double high) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !(value >= low && value <= high)) return std::nullopt;
  return value;
}

std::size_t choice_of(std::string_view text, std::string_view option, std::span<const std::string_view> names) {
  const auto at = std::ranges::find(names, text);
  if (at != names.end()) return static_cast<std::size_t>(at - names.begin());
  const std::vector<std::string_view> all(names.begin(), names.end());
  refuse_usage(option, listed(all, "or"), in_quotes(text) + did_you_mean(text, all));
}

namespace {

const CLI::App& command_named(const CLI::App& app, const std::string& name) {
  for (const CLI::App* known : commands(app)) {
    if (known->get_name() == name) return *known;
  }
  refuse_command(app, name);
}

// How many words the option at `i` takes, with its value.
std::size_t words_of_option(const CLI::App& app, const CLI::App& command, const Texts& words, std::size_t i) {
  const OptionWord given = option_word(words[i]);
  if (!is_option(command, given.name)) refuse_option(app, command, given.name);
  const CLI::Option& option = *option_of(command, given.name);
  if (option.get_items_expected_min() == 0) return 1;
  require_value(command, option, given, i + 1 < words.size() ? std::optional(words[i + 1]) : std::nullopt);
  return static_cast<std::size_t>(option.get_items_expected_min()) + (given.value ? 0 : 1);
}

// Whether the command takes several files.
bool takes_files(const CLI::App& command) {
  const std::vector<const CLI::Option*> options = command.get_options();
  return std::ranges::any_of(
      options, [](const CLI::Option* option) { return option->get_positional() && option->get_items_expected_max() > 1; });
}

}  // namespace

void require_known_words(const CLI::App& app, const Texts& words) {
  if (words.empty()) refuse_command(app, "");
  if (is_option(app, words.front())) return;
  const CLI::App& command = command_named(app, words.front());
  Texts scenes;
  bool only_scenes = false;
  for (std::size_t i = 1; i < words.size();) {
    const bool option = !only_scenes && words[i].size() > 1 && words[i].front() == '-';
    if (option && words[i] != "--") {
      i += words_of_option(app, command, words, i);
      continue;
    }
    if (option) {
      only_scenes = true;
    } else {
      scenes.push_back(words[i]);
    }
    ++i;
  }
  if (scenes.size() < 2 || takes_files(command)) return;
  refuse_usage(command.get_name(), "one scene file",
               fmt::format("{}: {} and {}", scenes.size(), in_quotes(scenes[0]), in_quotes(scenes[1])));
}

void refuse_parsed(const CLI::ParseError& error) {
  std::string text = error.what();
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::ranges::replace(text, '\n', ' ');
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    text = fmt::format("expected no more words, got {}", in_quotes(text.substr(std::min(text.size(), text.find(": ") + 2))));
  }
  throw InputError(fmt::format("{}: {} (see {} --help)", program, text, program));
}

}  // namespace shatterpave::cli
