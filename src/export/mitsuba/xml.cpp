#include "export/mitsuba/xml.h"

#include <fmt/format.h>

#include <iterator>

#include "core/error.h"

namespace shatterpave::exporting::mitsuba {

namespace {

void append_escaped(std::string& text, std::string_view value) {
  for (const char c : value) {
    switch (c) {
      case '&':
        text += "&amp;";
        break;
      case '<':
        text += "&lt;";
        break;
      case '>':
        text += "&gt;";
        break;
      case '"':
        text += "&quot;";
        break;
      default:
        text += c;
    }
  }
}

}  // namespace

std::string number(double value) { return fmt::format("{}", static_cast<float>(value) + 0.0F); }

std::string numbers(vec3 v) { return number(v.x) + ", " + number(v.y) + ", " + number(v.z); }

std::string numbers(const shapes::Colour& colour) { return fmt::format("{}, {}, {}", colour.red, colour.green, colour.blue); }

void Xml::begin(std::string_view tag, Attributes attributes) {
  text_.append(2 * (depth_ + open_.size()), ' ');
  text_ += '<';
  text_ += tag;
  for (const auto& [name, value] : attributes) {
    text_ += ' ';
    text_ += name;
    text_ += "=\"";
    append_escaped(text_, value);
    text_ += '"';
  }
}

void Xml::open(std::string_view tag, Attributes attributes) {
  begin(tag, attributes);
  text_ += ">\n";
  open_.emplace_back(tag);
}

void Xml::close() {
  ENSURE(!open_.empty());
  const std::string tag = std::move(open_.back());
  open_.pop_back();
  text_.append(2 * (depth_ + open_.size()), ' ');
  fmt::format_to(std::back_inserter(text_), "</{}>\n", tag);
}

void Xml::leaf(std::string_view tag, Attributes attributes) {
  begin(tag, attributes);
  text_ += "/>\n";
}

void Xml::value(std::string_view type, std::string_view name, std::string_view value) {
  leaf(type, {{"name", name}, {"value", value}});
}

void Xml::comment(std::string_view text) {
  text_.append(2 * (depth_ + open_.size()), ' ');
  fmt::format_to(std::back_inserter(text_), "<!-- {} -->\n", text);
}

}  // namespace shatterpave::exporting::mitsuba
