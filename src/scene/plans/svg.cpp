// SVG is read by pugixml, which loads no external entity; those that a document type declares are put in by xml_entities.h.
#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>

#include "scene/input_file.h"
#include "scene/plans/plan.h"
#include "scene/plans/svg_reader.h"
#include "scene/plans/xml_entities.h"
#include "scene/plans/xml_text.h"

namespace shatterpave::scene {

double join_tolerance_mm(double scale) { return std::max(svg_tolerance_mm, 0.02 * scale); }

Plan plan_of_svg(std::string_view bytes, const std::string& file, double scale) {
  const std::string text = utf8_text(bytes, file);
  pugi::xml_document document;
  const pugi::xml_parse_result result =
      document.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_doctype, pugi::encoding_utf8);
  if (!result) {
    const TextPosition position = text_position(text, static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)));
    throw InputError(Place{file, position.line, position.column, ""},
                     fmt::format("expected XML, got an error: {}", result.description()));
  }
  expand_entities(document, text, file);
  const pugi::xml_node svg = document.document_element();
  if (local_name(svg) != "svg")
    throw InputError(Place{file, 0, 0, ""}, fmt::format("expected an <svg>, got {}", in_quotes(local_name(svg))));
  Plan plan;
  plan.file = file;
  plan.svg = true;
  SvgReader(text, scale, plan).read(svg);
  return plan;
}

}  // namespace shatterpave::scene
