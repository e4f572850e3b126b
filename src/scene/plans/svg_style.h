// Style sheets of SVG: CSS as far as it can hide, clip or move shapes.
//
// Selectors (Selectors level 3): elements, *, classes, ids, attributes, the combinators, lists, :root, :first-child,
// :last-child and :not() of one simple selector; those that depend on a pointer or a link never match. Sheets for
// paper, @font-face and the like do not apply. Of the properties only those are kept that change what a plan is read as.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shatterpave::scene {

struct CssDeclaration {
  std::string property;
  std::string value;
  bool important = false;
};

// One condition of a compound selector.
struct CssCondition {
  enum class Kind { element, id, attribute, root, first_child, last_child, never };
  Kind kind = Kind::never;
  std::string name;        // of the element or attribute
  std::string value;       // the id, or what the attribute is compared with
  char comparison = '\0';  // of an attribute: '=', '~', '|', '^', '$', '*'; 0: it is there
  bool negated = false;
};

// Conditions that one element must meet, and how it stands to the one before.
struct CssCompound {
  std::vector<CssCondition> conditions;
  char combinator = '\0';  // ' ', '>', '+' or '~' before it; 0 at the first
};

struct CssRule {
  std::vector<CssCompound> selector;
  int specificity = 0;  // a number with the ids, classes and elements as digits
  std::shared_ptr<const std::vector<CssDeclaration>> declarations;
};

// All sheets of one file. Throws SvgError for what cannot be followed and would matter.
class SvgStyles {
 public:
  // Adds a sheet; those added later win. Returns whether it wants another file imported, which is not loaded.
  bool add(std::string_view css);

  // What an element itself gets for a property: from `style`, the sheets and the attribute of that name, as the cascade says
  // (CSS 2.1, 6.4); empty if nothing says anything. Valid until the next call.
  std::string_view value(const pugi::xml_node& node, const char* property) const;

 private:
  using Declarations = std::map<std::string, std::string, std::less<>>;
  void add_rules(std::string_view css);
  void add_rule(std::string_view selectors, std::string_view body);
  void add_at_rule(std::string_view prelude, std::string_view body);
  const Declarations& declarations_of(const pugi::xml_node& node) const;

  std::vector<CssRule> rules_;  // by rising specificity, then in their order
  mutable std::size_t tests_ = 0;
  mutable pugi::xml_node last_;
  mutable Declarations last_declarations_;
  bool imports_ = false;
  int depth_ = 0;  // of at-rules in at-rules
};

}  // namespace shatterpave::scene
