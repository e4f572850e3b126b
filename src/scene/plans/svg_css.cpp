#include "scene/plans/svg_css.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "scene/input_file.h"
#include "scene/plans/svg_path.h"

namespace shatterpave::scene {

namespace {

constexpr std::string_view spaces = " \t\n\r\f";

// Properties that hide, clip or move shapes, or say what of them is filled.
constexpr std::array<std::string_view, 26> followed_properties = {
    "display",   "visibility", "fill",     "fill-rule", "clip-rule", "clip-path",        "mask",
    "filter",    "opacity",    "overflow", "transform", "rotate",    "transform-origin", "transform-box",
    "translate", "scale",      "x",        "y",         "width",     "height",           "cx",
    "cy",        "r",          "rx",       "ry",        "d"};

bool is_valid(std::string_view property, std::string_view value) {
  if (value.empty()) return false;
  if (value == "inherit" || value == "initial" || value == "unset") return true;
  const auto is_one_of = [&](std::initializer_list<std::string_view> values) {
    return std::ranges::find(values, value) != values.end();
  };
  if (property == "fill-rule" || property == "clip-rule") return is_one_of({"nonzero", "evenodd"});
  if (property == "visibility") return is_one_of({"visible", "hidden", "collapse"});
  if (property == "overflow") return is_one_of({"visible", "hidden", "scroll", "auto"});
  return true;
}

bool is_css_name_character(char c) {
  return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-' || static_cast<unsigned char>(c) >= 0x80 || c == '\\';
}

int hexadecimal(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

void append_utf8(unsigned code, std::string& text) {
  const auto add = [&](unsigned byte) { text += static_cast<char>(byte); };
  if (code < 0x80) return add(code);
  if (code < 0x800) {
    add(0xC0 | (code >> 6));
  } else {
    if (code < 0x10000) {
      add(0xE0 | (code >> 12));
    } else {
      add(0xF0 | ((code >> 18) & 0x07));
      add(0x80 | ((code >> 12) & 0x3F));
    }
    add(0x80 | ((code >> 6) & 0x3F));
  }
  add(0x80 | (code & 0x3F));
}

// Reads one selector from the left.
class SelectorReader {
 public:
  explicit SelectorReader(std::string_view text) : text_(text) {}

  std::optional<std::vector<CssCompound>> read() {
    std::vector<CssCompound> selector;
    char combinator = '\0';
    while (true) {
      auto compound = this->compound();
      if (!compound || compound->empty()) return std::nullopt;
      selector.push_back({std::move(*compound), combinator});
      const bool spaced = skip_spaces();
      if (at_ == text_.size()) return selector;
      combinator = ' ';
      if (std::string_view(">+~").find(text_[at_]) != std::string_view::npos) {
        combinator = text_[at_++];
        skip_spaces();
      } else if (!spaced) {
        return std::nullopt;
      }
    }
  }

 private:
  using Kind = CssCondition::Kind;

  bool skip_spaces() {
    const std::size_t start = at_;
    while (at_ < text_.size() && spaces.find(text_[at_]) != std::string_view::npos) ++at_;
    return at_ > start;
  }
  char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  std::string name() {
    std::string result;
    while (at_ < text_.size() && is_css_name_character(text_[at_])) {
      if (text_[at_] != '\\') {
        result += text_[at_++];
        continue;
      }
      ++at_;
      unsigned code = 0;
      int digits = 0;
      for (; digits < 6 && hexadecimal(next()) >= 0; ++digits, ++at_)
        code = 16 * code + static_cast<unsigned>(hexadecimal(next()));
      if (digits == 0 && at_ < text_.size()) {
        result += text_[at_++];
      } else if (digits > 0) {
        append_utf8(code, result);
        if (spaces.find(next()) != std::string_view::npos && next() != '\0') ++at_;
      }
    }
    return result;
  }

  // Nothing where it is malformed.
  std::optional<std::vector<CssCondition>> compound() {
    std::vector<CssCondition> conditions;
    if (next() == '*') {
      ++at_;
      conditions.push_back({Kind::element, "*", "", '\0', false});
    } else if (is_css_name_character(next())) {
      conditions.push_back({Kind::element, name(), "", '\0', false});
    }
    if (next() == '|') {  // the namespace is not looked at
      ++at_;
      const std::string element = next() == '*' ? (++at_, std::string("*")) : name();
      if (element.empty()) return std::nullopt;
      conditions.assign(1, {Kind::element, element, "", '\0', false});
    }
    while (at_ < text_.size() && std::string_view(".#[:").find(text_[at_]) != std::string_view::npos) {
      auto condition = simple();
      if (!condition) return std::nullopt;
      conditions.push_back(std::move(*condition));
    }
    return conditions;
  }

  std::optional<CssCondition> simple() {
    const char mark = text_[at_++];
    if (mark == '[') return attribute();
    if (mark == ':') return pseudo();
    std::string value = name();
    if (value.empty()) return std::nullopt;
    if (mark == '#') return CssCondition{Kind::id, "id", std::move(value), '=', false};
    return CssCondition{Kind::attribute, "class", std::move(value), '~', false};
  }

  std::optional<CssCondition> attribute() {
    CssCondition condition{Kind::attribute, "", "", '\0', false};
    skip_spaces();
    condition.name = name();
    if (next() == '|' && at_ + 1 < text_.size() && text_[at_ + 1] != '=') {
      ++at_;
      condition.name += ':';
      condition.name += name();
    }
    skip_spaces();
    if (condition.name.empty()) return std::nullopt;
    if (next() != ']') {
      condition.comparison = text_[at_++];
      if (condition.comparison != '=' && next() != '=') return std::nullopt;
      if (condition.comparison != '=') ++at_;
      skip_spaces();
      const char quote = next();
      if (quote == '"' || quote == '\'') {
        const std::size_t end = text_.find(quote, at_ + 1);
        if (end == std::string_view::npos) return std::nullopt;
        condition.value = std::string(text_.substr(at_ + 1, end - at_ - 1));
        at_ = end + 1;
      } else {
        condition.value = name();
      }
      skip_spaces();
    }
    if (next() != ']') return std::nullopt;
    ++at_;
    return condition;
  }

  std::optional<CssCondition> pseudo() {
    if (next() == ':') {  // a part of an element, which is no element
      ++at_;
      name();
      return CssCondition{};
    }
    const std::string word = lower_case(name());
    std::string_view argument;
    if (next() == '(') {
      const std::size_t end = css_end(text_, at_ + 1, ")");
      argument = text_.substr(at_ + 1, end - at_ - 1);
      at_ = std::min(end + 1, text_.size());
    }
    if (word == "root") return CssCondition{Kind::root, "", "", '\0', false};
    if (word == "first-child") return CssCondition{Kind::first_child, "", "", '\0', false};
    if (word == "last-child") return CssCondition{Kind::last_child, "", "", '\0', false};
    constexpr std::array<std::string_view, 8> never = {"hover",  "active",  "focus",        "visited",
                                                       "target", "checked", "focus-within", "focus-visible"};
    if (std::ranges::find(never, word) != never.end()) return CssCondition{};
    if (word == "not") {
      SelectorReader inner(trimmed(argument));
      auto conditions = inner.compound();
      if (conditions && conditions->size() == 1 && inner.at_ == inner.text_.size()) {
        conditions->front().negated = true;
        return conditions->front();
      }
    }
    constexpr std::array<std::string_view, 14> unfollowed = {"not",
                                                             "nth-child",
                                                             "nth-last-child",
                                                             "nth-of-type",
                                                             "nth-last-of-type",
                                                             "first-of-type",
                                                             "last-of-type",
                                                             "only-of-type",
                                                             "only-child",
                                                             "empty",
                                                             "is",
                                                             "where",
                                                             "has",
                                                             "lang"};
    if (std::ranges::find(unfollowed, word) != unfollowed.end()) {
      throw SvgError(fmt::format("a style sheet without the selector :{}, got {}", word, in_quotes(trimmed(text_))));
    }
    return std::nullopt;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::string_view trimmed(std::string_view text) {
  const std::size_t first = std::min(text.find_first_not_of(spaces), text.size());
  return text.substr(first, text.find_last_not_of(spaces) + 1 - first);
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return result;
}

std::string without_css_comments(std::string_view css) {
  std::string result;
  char quote = '\0';
  for (std::size_t i = 0; i < css.size(); ++i) {
    const char c = css[i];
    if (quote != '\0') {
      if (c == quote || c == '\n') quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '/' && i + 1 < css.size() && css[i + 1] == '*') {
      i = std::min(css.find("*/", i + 2), css.size() - 1) + 1;
      continue;
    }
    result += c;
    if (c == '\\' && i + 1 < css.size()) result += css[++i];
  }
  return result;
}

std::size_t css_end(std::string_view css, std::size_t at, std::string_view ends) {
  int open = 0;
  char quote = '\0';
  for (; at < css.size(); ++at) {
    const char c = css[at];
    if (c == '\\') {
      ++at;
    } else if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (open == 0 && ends.find(c) != std::string_view::npos) {
      return at;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '(' || c == '[' || c == '{') {
      ++open;
    } else if (c == ')' || c == ']' || c == '}') {
      open = std::max(0, open - 1);
    }
  }
  return css.size();
}

std::vector<std::string_view> css_parts(std::string_view css, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t at = 0; at <= css.size();) {
    const std::size_t end = css_end(css, at, std::string_view(&separator, 1));
    parts.push_back(trimmed(css.substr(at, end - at)));
    at = end + 1;
  }
  return parts;
}

std::vector<CssDeclaration> css_declarations(std::string_view body) {
  std::vector<CssDeclaration> declarations;
  for (const std::string_view part : css_parts(body, ';')) {
    const std::size_t colon = part.find(':');
    if (colon == std::string_view::npos) continue;
    CssDeclaration declaration{lower_case(trimmed(part.substr(0, colon))), std::string(trimmed(part.substr(colon + 1))), false};
    const std::size_t mark = declaration.value.rfind('!');
    if (mark != std::string::npos && lower_case(trimmed(std::string_view(declaration.value).substr(mark + 1))) == "important") {
      declaration.important = true;
      declaration.value = std::string(trimmed(std::string_view(declaration.value).substr(0, mark)));
    }
    const bool followed = std::ranges::find(followed_properties, declaration.property) != followed_properties.end();
    if (followed && is_valid(declaration.property, declaration.value)) declarations.push_back(std::move(declaration));
  }
  return declarations;
}

std::optional<std::vector<CssCompound>> css_selector(std::string_view text) { return SelectorReader(trimmed(text)).read(); }

int specificity_of(const std::vector<CssCompound>& selector) {
  constexpr int most = 999;
  int ids = 0;
  int classes = 0;
  int elements = 0;
  for (const CssCompound& compound : selector) {
    for (const CssCondition& condition : compound.conditions) {
      if (condition.kind == CssCondition::Kind::id) {
        ++ids;
      } else if (condition.kind != CssCondition::Kind::element) {
        ++classes;
      } else if (condition.name != "*") {
        ++elements;
      }
    }
  }
  return (std::min(ids, most) * 1000 + std::min(classes, most)) * 1000 + std::min(elements, most);
}

std::optional<bool> css_media_apply(std::string_view media) {
  if (trimmed(media).empty()) return true;
  bool depends = false;
  for (const std::string_view part : css_parts(media, ',')) {
    std::vector<std::string> words = words_of(lower_case(part));
    const bool negated = !words.empty() && words.front() == "not";
    if (!words.empty() && (negated || words.front() == "only")) words.erase(words.begin());
    const bool known = words.size() == 1 && words.front().find('(') == std::string::npos;
    if (!known) {
      // Paper stays paper whatever else is asked.
      depends = depends || words.empty() || negated || words.front() != "print";
      continue;
    }
    const bool screen = words.front() == "all" || words.front() == "screen";
    if (screen != negated) return true;
  }
  return depends ? std::nullopt : std::optional(false);
}

}  // namespace shatterpave::scene
