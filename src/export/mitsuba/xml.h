// XML as Mitsuba reads it: text that is built up line by line.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/vec.h"
#include "export/shapes/palette.h"

namespace shatterpave::exporting::mitsuba {

// The shortest number that a float reads back as.
std::string number(double value);
std::string numbers(vec3 v);
std::string numbers(const shapes::Colour& colour);

class Xml {
 public:
  using Attributes = std::initializer_list<std::pair<std::string_view, std::string_view>>;

  //   depth  of the tags around what is written
  explicit Xml(std::size_t depth = 0) : depth_(depth) {}

  // What stands between its tags is indented. Values of attributes may hold any characters.
  void open(std::string_view tag, Attributes attributes = {});
  void close();
  void leaf(std::string_view tag, Attributes attributes = {});
  // A property, such as <float name="int_ior" value="1.52"/>.
  void value(std::string_view type, std::string_view name, std::string_view value);
  void comment(std::string_view text);  // without "--"
  void append(const Xml& more) { text_ += more.text_; }

  const std::string& text() const { return text_; }

 private:
  void begin(std::string_view tag, Attributes attributes);

  std::string text_;
  std::vector<std::string> open_;  // tags that are open
  std::size_t depth_;
};

}  // namespace shatterpave::exporting::mitsuba
