// Entities that a document of XML declares for itself: older drawing programs write their styles so (style="&st1;").
#pragma once

#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace shatterpave::scene {

// Puts the texts of entities in the place of references to them, in attributes and in the texts of elements.
//   document  parsed of `text` with pugi::parse_doctype; the declaration of its type is taken away
//   file      for messages
// What is put in holds no references of its own, so a text grows no more than by its own references; it is refused beyond 32
// MiB in all. An entity of another file is never loaded. References in attributes to those, and to entities that hold elements
// or further references, are refused with their place; so are, in texts, references to what holds elements.
void expand_entities(pugi::xml_document& document, std::string_view text, const std::string& file);

}  // namespace shatterpave::scene
