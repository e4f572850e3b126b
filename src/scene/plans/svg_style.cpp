#include "scene/plans/svg_style.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "scene/input_file.h"
#include "scene/plans/svg_css.h"
#include "scene/plans/svg_path.h"
#include "scene/plans/svg_shapes.h"

namespace shatterpave::scene {

namespace {

constexpr std::size_t most_rules = 100'000;
// Of selectors against elements; some ten seconds.
constexpr std::size_t most_tests = 200'000'000;
constexpr int deepest_at_rules = 20;

pugi::xml_node element_before(pugi::xml_node node) {
  do node = node.previous_sibling();
  while (node && node.type() != pugi::node_element);
  return node;
}

pugi::xml_node element_after(pugi::xml_node node) {
  do node = node.next_sibling();
  while (node && node.type() != pugi::node_element);
  return node;
}

pugi::xml_node parent_element(const pugi::xml_node& node) {
  const pugi::xml_node parent = node.parent();
  return parent.type() == pugi::node_element ? parent : pugi::xml_node();
}

bool has_word(std::string_view text, std::string_view word) {
  const std::vector<std::string> words = words_of(text);
  return std::ranges::find(words, word) != words.end();
}

bool holds_attribute(const CssCondition& condition, const pugi::xml_node& node) {
  const pugi::xml_attribute attribute = node.attribute(condition.name.c_str());
  if (!attribute) return false;
  const std::string_view text = attribute.value();
  const std::string_view value = condition.value;
  switch (condition.comparison) {
    case '\0':
      return true;
    case '=':
      return text == value;
    case '~':
      return has_word(text, value);
    case '|':
      return text == value || (text.starts_with(value) && text.substr(value.size()).starts_with('-'));
    case '^':
      return !value.empty() && text.starts_with(value);
    case '$':
      return !value.empty() && text.ends_with(value);
    case '*':
      return !value.empty() && text.find(value) != std::string_view::npos;
    default:
      return false;
  }
}

bool holds(const CssCondition& condition, const pugi::xml_node& node) {
  using Kind = CssCondition::Kind;
  switch (condition.kind) {
    case Kind::element:
      return condition.name == "*" || condition.name == local_name(node);
    case Kind::id:
    case Kind::attribute:
      return holds_attribute(condition, node);
    case Kind::root:
      return !parent_element(node);
    case Kind::first_child:
      return !element_before(node);
    case Kind::last_child:
      return !element_after(node);
    case Kind::never:
      break;
  }
  return false;
}

// Whether the first `count` compounds end at the element.
bool matches(const std::vector<CssCompound>& selector, std::size_t count, const pugi::xml_node& node, std::size_t& tests) {
  if (++tests > most_tests) throw SvgError("style sheets with fewer or simpler selectors, got too many to be followed");
  const CssCompound& compound = selector[count - 1];
  for (const CssCondition& condition : compound.conditions) {
    if (holds(condition, node) == condition.negated) return false;
  }
  if (count == 1) return true;
  const bool among_siblings = compound.combinator == '+' || compound.combinator == '~';
  const bool next_only = compound.combinator == '+' || compound.combinator == '>';
  const auto before = [&](const pugi::xml_node& at) { return among_siblings ? element_before(at) : parent_element(at); };
  for (pugi::xml_node at = before(node); at; at = before(at)) {
    if (matches(selector, count - 1, at, tests)) return true;
    if (next_only) return false;
  }
  return false;
}

// At-rules that hold no style of an element.
bool is_passed_over(std::string_view name) {
  constexpr std::array<std::string_view, 10> names = {"charset",       "namespace", "font-face",         "page",
                                                      "counter-style", "keyframes", "-webkit-keyframes", "-moz-keyframes",
                                                      "property",      "viewport"};
  return std::ranges::find(names, name) != names.end();
}

}  // namespace

bool SvgStyles::add(std::string_view css) {
  imports_ = false;
  add_rules(without_css_comments(css));
  std::ranges::stable_sort(rules_, {}, &CssRule::specificity);
  return imports_;
}

void SvgStyles::add_rules(std::string_view css) {
  for (std::size_t at = 0; at < css.size();) {
    const std::size_t end = css_end(css, at, "{;");
    std::string_view prelude = trimmed(css.substr(at, end - at));
    for (const std::string_view mark : {"<!--", "-->"}) {
      if (prelude.starts_with(mark)) prelude = trimmed(prelude.substr(mark.size()));
    }
    const bool has_block = end < css.size() && css[end] == '{';
    const std::size_t close = has_block ? css_end(css, end + 1, "}") : end;
    const std::string_view body = has_block ? css.substr(end + 1, close - end - 1) : std::string_view();
    at = close + 1;
    if (prelude.starts_with('@')) {
      add_at_rule(prelude, body);
    } else if (has_block) {
      add_rule(prelude, body);
    }
  }
}

void SvgStyles::add_at_rule(std::string_view prelude, std::string_view body) {
  const std::size_t end = std::min(prelude.find_first_of(" \t\n\r\f(\""), prelude.size());
  const std::string name = lower_case(prelude.substr(1, end - 1));
  if (name == "import") imports_ = true;
  if (name == "import" || is_passed_over(name) || body.empty()) return;
  if (++depth_ > deepest_at_rules) throw SvgError(fmt::format("at most {} rules of CSS in rules, got more", deepest_at_rules));
  const auto applies = name == "media" ? css_media_apply(prelude.substr(end)) : std::nullopt;
  if (applies.value_or(false)) {
    add_rules(body);
  } else if (!applies) {
    SvgStyles within;
    within.depth_ = depth_;
    within.add_rules(body);
    const bool matters = std::ranges::any_of(within.rules_, [](const CssRule& rule) {
      return std::ranges::any_of(*rule.declarations, [](const CssDeclaration& d) { return d.property != "fill"; });
    });
    if (matters) throw SvgError(fmt::format("a style sheet that does not depend on the screen, got {}", in_quotes(prelude)));
  }
  --depth_;
}

void SvgStyles::add_rule(std::string_view selectors, std::string_view body) {
  const auto declarations = std::make_shared<const std::vector<CssDeclaration>>(css_declarations(body));
  if (declarations->empty()) return;
  std::vector<CssRule> rules;
  for (const std::string_view text : css_parts(selectors, ',')) {
    auto selector = css_selector(text);
    if (!selector) return;  // one that is malformed takes the whole rule with it
    const int specificity = specificity_of(*selector);
    rules.push_back({std::move(*selector), specificity, declarations});
  }
  if (rules_.size() + rules.size() > most_rules) throw SvgError(fmt::format("at most {} selectors, got more", most_rules));
  std::ranges::move(rules, std::back_inserter(rules_));
}

std::string_view SvgStyles::value(const pugi::xml_node& node, const char* property) const {
  const Declarations& declarations = declarations_of(node);
  const auto found = declarations.find(std::string_view(property));
  return found != declarations.end() ? std::string_view(found->second) : trimmed(node.attribute(property).value());
}

const SvgStyles::Declarations& SvgStyles::declarations_of(const pugi::xml_node& node) const {
  if (last_ == node) return last_declarations_;
  last_ = pugi::xml_node();
  last_declarations_.clear();
  // Sheets, then `style`, then what is important in either: the last one wins.
  std::vector<const CssRule*> matching;
  for (const CssRule& rule : rules_) {
    if (matches(rule.selector, rule.selector.size(), node, tests_)) matching.push_back(&rule);
  }
  const std::vector<CssDeclaration> own = css_declarations(without_css_comments(node.attribute("style").value()));
  for (const bool important : {false, true}) {
    const auto take = [&](const std::vector<CssDeclaration>& declarations) {
      for (const CssDeclaration& d : declarations) {
        if (d.important == important) last_declarations_[d.property] = d.value;
      }
    };
    for (const CssRule* rule : matching) take(*rule->declarations);
    take(own);
  }
  last_ = node;
  return last_declarations_;
}

}  // namespace shatterpave::scene
