#include "scene/plans/xml_entities.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/error.h"
#include "scene/input_file.h"

namespace shatterpave::scene {

namespace {

constexpr std::string_view blanks = " \t\r\n";

struct Entity {
  std::string text;
  bool is_plain = false;  // a text without references and elements
  bool has_elements = false;
};
using Entities = std::map<std::string, Entity, std::less<>>;

// Takes the next word off `rest`.
std::string_view taken_word(std::string_view& rest) {
  rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
  const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r\n>"));
  rest.remove_prefix(word.size());
  return word;
}

// Takes what follows "<!ENTITY". The first declaration of a name counts (XML 1.0, 4.2).
void take_declaration(std::string_view& rest, Entities& entities) {
  const std::string_view name = taken_word(rest);
  if (name == "%") return;  // for use in the declaration of the type alone
  rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
  Entity entity;
  if (!rest.empty() && (rest.front() == '"' || rest.front() == '\'')) {
    const std::size_t end = rest.find(rest.front(), 1);
    if (end == std::string_view::npos) return;
    entity.text = rest.substr(1, end - 1);
    entity.has_elements = entity.text.find('<') != std::string::npos;
    entity.is_plain = entity.text.find_first_of("<&%") == std::string::npos;
    rest.remove_prefix(end + 1);
  }
  entities.emplace(name, std::move(entity));
}

Entities declared(std::string_view type) {
  Entities entities;
  constexpr std::string_view comment = "<!--";
  constexpr std::string_view entity = "<!ENTITY";
  for (std::size_t at = type.find('<'); at != std::string_view::npos; at = type.find('<')) {
    type.remove_prefix(at);
    if (type.starts_with(comment)) {
      type.remove_prefix(std::min(type.find("-->"), type.size()));
    } else if (type.starts_with(entity)) {
      type.remove_prefix(entity.size());
      take_declaration(type, entities);
    } else {
      type.remove_prefix(1);
    }
  }
  return entities;
}

class Expander {
 public:
  Expander(const Entities& entities, std::string_view text, const std::string& file)
      : entities_(entities), text_(text), file_(file) {}

  void expand(pugi::xml_node root) {
    std::vector<pugi::xml_node> left{root};
    while (!left.empty()) {
      const pugi::xml_node node = left.back();
      left.pop_back();
      for (pugi::xml_attribute attribute : node.attributes()) {
        if (const auto value = expanded(attribute.value(), node, true)) attribute.set_value(value->c_str());
      }
      for (pugi::xml_node child : node.children()) {
        if (child.type() == pugi::node_pcdata) {
          if (const auto value = expanded(child.value(), node, false)) child.set_value(value->c_str());
        } else if (child.type() == pugi::node_element) {
          left.push_back(child);
        }
      }
    }
  }

 private:
  // Nothing where it refers to none of the entities.
  std::optional<std::string> expanded(std::string_view value, pugi::xml_node node, bool is_attribute) {
    if (value.find('&') == std::string_view::npos) return std::nullopt;
    std::string result;
    bool any = false;
    for (std::size_t at = value.find('&'); at != std::string_view::npos; at = value.find('&')) {
      result += value.substr(0, at);
      value.remove_prefix(at);
      const std::size_t end = value.find(';');
      const auto found = end == std::string_view::npos ? entities_.end() : entities_.find(value.substr(1, end - 1));
      if (found == entities_.end()) {
        result += '&';
        value.remove_prefix(1);
        continue;
      }
      const Entity& entity = found->second;
      if (!entity.is_plain && (is_attribute || entity.has_elements)) {
        refuse(node, fmt::format("expected entities of plain text, got {}", in_quotes(value.substr(0, end + 1))));
      }
      result += entity.is_plain ? std::string_view(entity.text) : value.substr(0, end + 1);
      value.remove_prefix(end + 1);
      any = true;
      if (total_ + result.size() > largest_outline_bytes) {
        refuse(node, fmt::format("expected at most {} MiB of text of entities, got more", largest_outline_bytes >> 20U));
      }
    }
    if (!any) return std::nullopt;
    result += value;
    total_ += result.size();
    return result;
  }

  [[noreturn]] void refuse(pugi::xml_node node, const std::string& message) const {
    const TextPosition at = text_position(text_, static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0)));
    throw InputError(Place{file_, at.line, at.column, node.name()}, message);
  }

  const Entities& entities_;
  std::string_view text_;
  const std::string& file_;
  std::size_t total_ = 0;
};

}  // namespace

void expand_entities(pugi::xml_document& document, std::string_view text, const std::string& file) {
  Entities entities;
  for (pugi::xml_node child = document.first_child(); child;) {
    const pugi::xml_node next = child.next_sibling();
    if (child.type() == pugi::node_doctype) {
      entities.merge(declared(child.value()));
      document.remove_child(child);
    }
    child = next;
  }
  if (!entities.empty()) Expander(entities, text, file).expand(document.document_element());
}

}  // namespace shatterpave::scene
