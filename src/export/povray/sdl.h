// POV-Ray's scene description language, as text: numbers, points, and what every include file has about its declarations.
//
// Numbers are the shortest that read back exactly. Here, and for stones in stone_text.h, our right-handed coordinates become
// POV-Ray's left-handed ones.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/vec.h"

namespace shatterpave::exporting::povray {

// `value` must be finite. Zero has no sign.
void append_number(std::string& text, double value);
std::string number(double value);

// <x, y> without change, for a prism's outline.
void append_point(std::string& text, vec2 mm);

// Things that lie, such as a pavement: our z, which is up, becomes POV-Ray's y.
void append_lying_point(std::string& text, vec3 mm);
std::string lying_point(vec3 mm);

// Things that stand, such as a pane: our plane is seen by a viewer who looks along POV-Ray's +z; our z, which points towards
// that viewer, becomes -z.
void append_standing_point(std::string& text, vec3 mm);
std::string standing_point(vec3 mm);

// The words of the header of an include file, as in POV-Ray's standard includes.
struct IncludeHeader {
  std::string file;                       // name of the file
  std::vector<std::string> description;   // lines
  std::vector<std::string> declarations;  // lines: what it declares and what it reads
  std::string prefix;                     // of its identifiers; PREFIX_Inc_Temp is its guard
};

// The whole file: header, guard, `#version` saved and restored, and between them `body`, which ends with a new line.
std::string include_text(const IncludeHeader& header, std::string_view body);

// An identifier for each of `names` (letters, digits, '_' and '-'), in their order: to be followed by an underscore and a word,
// so that it is never one of POV-Ray's keywords. No two are the same, even where the names differ only in '-' and '_'.
std::vector<std::string> identifiers(const std::vector<std::string>& names);

}  // namespace shatterpave::exporting::povray
