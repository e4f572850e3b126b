#include "export/povray/sdl.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/error.h"

namespace shatterpave::exporting::povray {

namespace {

void append_triple(std::string& text, double x, double y, double z) {
  text += '<';
  append_number(text, x);
  text += ", ";
  append_number(text, y);
  text += ", ";
  append_number(text, z);
  text += '>';
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

// An identifier starts with a letter or an underscore.
std::string identifier(const std::string& name) {
  std::string result = name.empty() || is_digit(name.front()) ? "N" : "";
  for (const char c : name) result += is_letter(c) || is_digit(c) ? c : '_';
  return result;
}

void append_comment(std::string& text, std::string_view first, const std::vector<std::string>& lines, std::string_view others) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    text += fmt::format("// {}{}\n", i == 0 ? first : others, lines[i]);
  }
}

}  // namespace

void append_number(std::string& text, double value) {
  ENSURE(std::isfinite(value));
  fmt::format_to(std::back_inserter(text), "{}", value == 0.0 ? 0.0 : value);
}

std::string number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

void append_point(std::string& text, vec2 mm) {
  text += '<';
  append_number(text, mm.x);
  text += ", ";
  append_number(text, mm.y);
  text += '>';
}

void append_lying_point(std::string& text, vec3 mm) { append_triple(text, mm.x, mm.z, mm.y); }

std::string lying_point(vec3 mm) {
  std::string text;
  append_lying_point(text, mm);
  return text;
}

void append_standing_point(std::string& text, vec3 mm) { append_triple(text, mm.x, mm.y, -mm.z); }

std::string standing_point(vec3 mm) {
  std::string text;
  append_standing_point(text, mm);
  return text;
}

std::string include_text(const IncludeHeader& header, std::string_view body) {
  std::string text = fmt::format("// Persistence of Vision Ray Tracer Include File\n// File: {}\n// Vers: 3.7\n", header.file);
  append_comment(text, "Desc: ", header.description, "      ");
  text += "//\n";
  append_comment(text, "", header.declarations, "");
  text += fmt::format("\n#ifndef({0}_Inc_Temp)\n#declare {0}_Inc_Temp = version;\n#version 3.7;\n\n", header.prefix);
  text += body;
  text += fmt::format("\n#version {0}_Inc_Temp;\n#end\n", header.prefix);
  return text;
}

std::vector<std::string> identifiers(const std::vector<std::string>& names) {
  std::vector<std::string> result;
  for (const std::string& name : names) {
    std::string candidate = identifier(name);
    for (int copy = 2; std::ranges::find(result, candidate) != result.end(); ++copy) {
      candidate = fmt::format("{}_{}", identifier(name), copy);
    }
    result.push_back(candidate);
  }
  return result;
}

}  // namespace shatterpave::exporting::povray
