// The parser tells where each value begins and ends. What it does not tell is how a table was written: by a header of its own,
// by the header of a table in it, by a dotted key, or in braces. That is read off the text where the table begins.
#include "scene/toml/edited_text.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "core/error.h"
#include "scene/toml/apply_override.h"
#include "scene/toml/toml_table.h"

namespace shatterpave::scene {

namespace {

constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";

toml::table parsed_text(std::string_view text, const std::string& file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    const auto& begin = error.source().begin;
    throw InputError(Place{file, static_cast<int>(begin.line), static_cast<int>(begin.column), ""},
                     fmt::format("expected TOML, got an error: {}", error.description()));
  }
}

// A text by the positions of the parser: lines from 1, columns from 1 in characters.
class PlacedText {
 public:
  explicit PlacedText(std::string_view text) : text_(text) {
    const std::size_t begin = text.starts_with(utf8_mark) ? utf8_mark.size() : 0;
    lines_.push_back(begin);
    for (std::size_t i = begin; i < text.size(); ++i) {
      if (text[i] == '\n') lines_.push_back(i + 1);
    }
  }

  std::size_t offset(const toml::source_position& position) const {
    const std::size_t line = std::min<std::size_t>(position.line, lines_.size()) - 1;
    std::size_t at = lines_[line];
    for (std::size_t column = 1; column < position.column && at < text_.size(); ++column) {
      ++at;
      while (at < text_.size() && (static_cast<unsigned char>(text_[at]) & 0xC0U) == 0x80U) ++at;
    }
    return at;
  }
  std::size_t line_begin(std::size_t at) const { return *std::prev(std::ranges::upper_bound(lines_, at)); }
  // Behind the line break, or the end of the text.
  std::size_t line_end(std::size_t at) const {
    const std::size_t end = text_.find('\n', at);
    return end == std::string_view::npos ? text_.size() : end + 1;
  }
  std::string_view newline() const {
    const std::size_t end = text_.find('\n');
    return end != std::string_view::npos && end > 0 && text_[end - 1] == '\r' ? "\r\n" : "\n";
  }
  std::size_t begin() const { return lines_.front(); }
  std::string_view text() const { return text_; }

 private:
  std::string_view text_;
  std::vector<std::size_t> lines_;
};

enum class Written {
  root,
  header,    // [a.b] or [[a.b]], its own
  implied,   // by the header of a table in it
  dotted,    // by keys with dots in an outer table
  in_braces  // { … }
};

// How many keys a header has, "[a.b]" two.
std::size_t key_count(std::string_view header) {
  const toml::table parsed = toml::parse(header);
  std::size_t count = 0;
  const toml::table* table = &parsed;
  while (table != nullptr && !table->empty()) {
    ++count;
    const toml::node& inner = table->begin()->second;
    table = inner.is_array() ? (*inner.as_array())[0].as_table() : inner.as_table();
  }
  return count;
}

// `depth`: how many keys lead to it from the root.
Written written_as(const toml::table& table, std::size_t depth, const PlacedText& text) {
  if (depth == 0) return Written::root;
  if (table.is_inline()) return Written::in_braces;
  const std::size_t begin = text.offset(table.source().begin);
  if (begin >= text.text().size() || text.text()[begin] != '[') return Written::dotted;
  const std::size_t end = text.offset(table.source().end);
  return key_count(text.text().substr(begin, end - begin)) == depth ? Written::header : Written::implied;
}

bool is_of_headers(const toml::node& node) {
  const toml::array* array = node.as_array();
  return array != nullptr && array->is_array_of_tables() && !(*array)[0].as_table()->is_inline();
}

// The last value that stands in the table itself, not below the header of a table in it. Null where there is none.
const toml::node* last_value(const toml::table& table, std::size_t depth, const PlacedText& text) {
  const toml::node* last = nullptr;
  const auto take = [&](const toml::node* node) {
    if (node != nullptr && (last == nullptr || last->source().end < node->source().end)) last = node;
  };
  for (const auto& [key, value] : table) {
    const toml::table* inner = value.as_table();
    if (inner != nullptr && !inner->is_inline()) {
      if (written_as(*inner, depth + 1, text) == Written::dotted) take(last_value(*inner, depth + 1, text));
    } else if (!is_of_headers(value)) {
      take(&value);
    }
  }
  return last;
}

// Where the first header of the text begins: its line, or its end where it has none.
std::size_t first_header(const toml::table& root, const PlacedText& text) {
  std::size_t first = text.text().size();
  for (const auto& [key, value] : root) {
    const toml::table* table = value.as_table();
    const bool has_header =
        is_of_headers(value) || (table != nullptr && !table->is_inline() && written_as(*table, 1, text) != Written::dotted);
    if (has_header) first = std::min(first, text.line_begin(text.offset(value.source().begin)));
  }
  return first;
}

std::string dotted_key(const std::vector<std::string>& keys) {
  std::string path;
  for (const std::string& key : keys) {
    if (!path.empty()) path += '.';
    path += key;
  }
  return path;
}

std::vector<std::string> keys_of_both(const std::vector<std::string>& a, std::span<const std::string> b) {
  std::vector<std::string> keys = a;
  keys.insert(keys.end(), b.begin(), b.end());
  return keys;
}

// A line of its own between others. `at` is a beginning of a line, or the end of the text.
std::string with_lines(const PlacedText& text, std::size_t at, std::string_view lines) {
  const std::string_view all = text.text();
  const std::string_view newline = text.newline();
  if (at < all.size() || at <= text.begin() || all[at - 1] == '\n') {
    return fmt::format("{}{}{}", all.substr(0, at), lines, all.substr(at));
  }
  lines.remove_suffix(newline.size());  // as before, the last line has no end
  return fmt::format("{}{}{}", all, newline, lines);
}

// Whether the '=' of a line is set in a column: apart from its key, or below that of the line before.
bool is_column(const PlacedText& text, std::size_t line_begin, std::size_t equals) {
  if (equals == std::string_view::npos || equals < 2) return false;
  const std::string_view all = text.text();
  if (all[line_begin + equals - 1] == ' ' && all[line_begin + equals - 2] == ' ') return true;
  if (line_begin == text.begin()) return false;
  const std::size_t above = text.line_begin(line_begin - 1);
  return above + equals < line_begin && all[above + equals] == '=';
}

// "key = value" as the line of `like` is written: its spaces before, and its '=' where that is set apart.
std::string key_line(const PlacedText& text, const toml::node* like, const std::string& key, std::string_view literal) {
  std::string indent;
  std::string padding = " ";
  if (like != nullptr) {
    const std::size_t value = text.offset(like->source().begin);
    const std::size_t begin = text.line_begin(value);
    const std::string_view line = text.text().substr(begin, value - begin);
    const std::size_t first = std::min(line.find_first_not_of(" \t"), line.size());
    const std::size_t equals = line.rfind('=');
    indent.assign(line.substr(0, first));
    if (is_column(text, begin, equals) && first + key.size() < equals) padding.assign(equals - first - key.size(), ' ');
  }
  return fmt::format("{}{}{}= {}{}", indent, key, padding, literal, text.newline());
}

// A table of the text, on the way to a value.
struct Found {
  const toml::table* table = nullptr;
  std::vector<std::string> keys;  // from the root, without indices
};

class Insertion {
 public:
  Insertion(const PlacedText& text, std::string_view literal) : text_(text), literal_(literal) {}

  // `way`: the tables that there are, from the root on; `missing`: keys that lead on from the last of them.
  std::string made(std::vector<Found> way, const std::vector<std::string>& missing) const {
    Written written = Written::root;
    std::vector<std::string> dotted;  // keys, the last first
    while ((written = written_as(*way.back().table, way.back().keys.size(), text_)) == Written::dotted) {
      dotted.push_back(way.back().keys.back());
      way.pop_back();
    }
    const std::vector<std::string> keys = keys_of_both({dotted.rbegin(), dotted.rend()}, missing);
    const Found& parent = way.back();
    if (written == Written::in_braces) return in_braces(*parent.table, keys);
    if (written == Written::implied) return before_header(parent, keys);
    if (keys.size() == 1 || !dotted.empty()) return as_line(parent, dotted_key(keys), written == Written::root);
    return as_table(parent, keys, written == Written::root);
  }

 private:
  std::string in_braces(const toml::table& table, const std::vector<std::string>& keys) const {
    const std::string_view all = text_.text();
    const std::size_t brace = text_.offset(table.source().end) - 1;
    const std::size_t last = all.find_last_not_of(" \t", brace - 1) + 1;
    return fmt::format("{}{}{} = {}{}", all.substr(0, last), table.empty() ? "" : ", ", dotted_key(keys), literal_,
                       all.substr(table.empty() ? brace : last));
  }

  // Comments right above the header stay with it.
  std::string before_header(const Found& parent, const std::vector<std::string>& keys) const {
    std::size_t at = text_.line_begin(text_.offset(parent.table->source().begin));
    while (at > text_.begin()) {
      const std::size_t above = text_.line_begin(at - 1);
      const std::size_t first = text_.text().find_first_not_of(" \t", above);
      if (first >= at || text_.text()[first] != '#') break;
      at = above;
    }
    const std::vector<std::string> table = keys_of_both(parent.keys, std::span(keys).first(keys.size() - 1));
    return with_lines(text_, at, fmt::format("{}{}", block(table, keys.back()), text_.newline()));
  }

  std::string block(const std::vector<std::string>& table, const std::string& key) const {
    return fmt::format("[{}]{}{}", dotted_key(table), text_.newline(), key_line(text_, nullptr, key, literal_));
  }

  // Behind the last value of the table, or its header.
  std::size_t body_end(const Found& parent, const toml::node* last) const {
    const toml::source_position end = last != nullptr ? last->source().end : parent.table->source().end;
    return text_.line_end(text_.offset(end));
  }

  std::string as_line(const Found& parent, const std::string& key, bool is_root) const {
    const toml::node* last = last_value(*parent.table, parent.keys.size(), text_);
    const std::string line = key_line(text_, last, key, literal_);
    if (last != nullptr || !is_root) return with_lines(text_, body_end(parent, last), line);
    const std::size_t at = first_header(*parent.table, text_);
    return with_lines(text_, at, fmt::format("{}{}", line, at < text_.text().size() ? text_.newline() : ""));
  }

  std::string as_table(const Found& parent, const std::vector<std::string>& keys, bool is_root) const {
    const std::string_view all = text_.text();
    const std::string_view newline = text_.newline();
    const std::vector<std::string> table = keys_of_both(parent.keys, std::span(keys).first(keys.size() - 1));
    const toml::node* last = last_value(*parent.table, parent.keys.size(), text_);
    const std::size_t at = is_root ? all.size() : body_end(parent, last);
    const bool is_close = at < all.size() && all[at] != '\n' && all[at] != '\r';
    return with_lines(
        text_, at,
        fmt::format("{}{}{}", at > text_.begin() ? newline : "", block(table, keys.back()), is_close ? newline : ""));
  }

  const PlacedText& text_;
  std::string_view literal_;
};

// The value as it was given, without what stands around it; a text that is no TOML in quotes.
std::string literal_of(const Override& change) {
  const toml::table parsed = parsed_value(change);
  const toml::node& value = *parsed.get("value");
  if (const auto* text = value.as_string(); text != nullptr && text->get() == change.value) {
    std::string quoted;
    for (const char c : change.value) {
      const bool is_control = static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
      if (c == '"' || c == '\\') quoted += '\\';
      if (is_control) {
        quoted += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
      } else {
        quoted += c;
      }
    }
    return fmt::format("\"{}\"", quoted);
  }
  const std::string line = fmt::format("value = {}", change.value);
  const PlacedText text(line);
  const std::size_t begin = text.offset(value.source().begin);
  return line.substr(begin, text.offset(value.source().end) - begin);
}

// `node` is the value that all steps lead to.
std::string replaced(const PlacedText& text, const toml::node& node, std::string_view literal, const Override& change) {
  const toml::table* table = node.as_table();
  if ((table != nullptr && !table->is_inline()) || is_of_headers(node)) {
    refuse(Place{change.origin, 0, 0, ""}, "a key that leads to a value", fmt::format("{}, which is a table", change.key));
  }
  const std::size_t begin = text.offset(node.source().begin);
  const std::size_t end = text.offset(node.source().end);
  return fmt::format("{}{}{}", text.text().substr(0, begin), literal, text.text().substr(end));
}

std::string edited_once(std::string_view given, toml::table& root, const Override& change) {
  const PlacedText text(given);
  const std::vector<KeyStep> steps = key_steps(change);
  const std::string literal = literal_of(change);
  toml::node* node = &root;
  std::vector<Found> way{{&root, {}}};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto* key = std::get_if<std::string>(&steps[i]);
    if (toml::array* array = node->as_array()) {
      node = &(*array)[element_index(*array, steps[i], change, path_of(steps, i))];
      if (node->is_table()) way.push_back({node->as_table(), way.back().keys});
    } else if (toml::table* table = node->as_table(); table != nullptr && key != nullptr && table->contains(*key)) {
      node = table->get(*key);
      std::vector<std::string> keys = keys_of_both(way.back().keys, std::span(key, 1));
      way.push_back({node->as_table() != nullptr ? node->as_table() : table, std::move(keys)});
    } else {
      std::vector<std::string> missing;
      for (std::size_t k = i; k < steps.size(); ++k) {
        const auto* name = std::get_if<std::string>(&steps[k]);
        if (table == nullptr || name == nullptr) {
          refuse(Place{change.origin, 0, 0, ""}, "a key that leads to a value", change.key);
        }
        missing.push_back(*name);
      }
      return Insertion(text, literal).made(std::move(way), missing);
    }
  }
  return replaced(text, *node, literal, change);
}

// The value at a path; null where there is none.
const toml::node* value_at(toml::table& root, const Override& asked) {
  const std::vector<KeyStep> steps = key_steps(asked);
  toml::node* node = &root;
  for (std::size_t i = 0; i < steps.size() && node != nullptr; ++i) {
    const auto* key = std::get_if<std::string>(&steps[i]);
    if (toml::array* array = node->as_array()) {
      try {
        node = &(*array)[element_index(*array, steps[i], asked, path_of(steps, i))];
      } catch (const InputError&) {
        return nullptr;
      }
    } else {
      toml::table* table = node->as_table();
      node = table != nullptr && key != nullptr ? table->get(*key) : nullptr;
    }
  }
  return node;
}

}  // namespace

std::optional<std::string> written_value(std::string_view text, const std::string& file, const Override& asked) {
  toml::table root = parsed_text(text, file);
  const toml::node* node = value_at(root, asked);
  if (node == nullptr) return std::nullopt;
  const PlacedText placed(text);
  const std::size_t begin = placed.offset(node->source().begin);
  return std::string(text.substr(begin, placed.offset(node->source().end) - begin));
}

std::string edited_text(std::string_view text, const std::string& file, const std::vector<Override>& changes) {
  std::string result(text);
  for (const Override& change : changes) {
    toml::table table = parsed_text(result, file);
    std::string edited = edited_once(result, table, change);
    apply(change, table);
    ENSURE(parsed_text(edited, file) == table);
    result = std::move(edited);
  }
  return result;
}

}  // namespace shatterpave::scene
