#include <fmt/format.h>
#include <shatterpave/scene.h>

#include <iterator>

namespace shatterpave {

namespace {

using Buffer = fmt::memory_buffer;

void put_text(Buffer& out, std::string_view text) {
  out.push_back('"');
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F) {
      fmt::format_to(std::back_inserter(out), "\\u{:04X}", byte);
      continue;
    }
    if (c == '"' || c == '\\') out.push_back('\\');
    out.push_back(c);
  }
  out.push_back('"');
}

void put_points(Buffer& out, const std::vector<Point>& points) {
  out.push_back('[');
  for (const Point& p : points) fmt::format_to(std::back_inserter(out), "[{}, {}], ", p.x, p.y);
  out.push_back(']');
}

}  // namespace

Value::Value(double number) : toml_(fmt::format("{}", number)) {}

Value::Value(std::string_view text) {
  Buffer out;
  put_text(out, text);
  toml_ = fmt::to_string(out);
}

Value::Value(Point point) : toml_(fmt::format("[{}, {}]", point.x, point.y)) {}

Value::Value(const std::vector<Point>& points) {
  Buffer out;
  put_points(out, points);
  toml_ = fmt::to_string(out);
}

Value::Value(const std::vector<Polygon>& polygons) {
  Buffer out;
  out.push_back('[');
  for (const Polygon& polygon : polygons) {
    put_points(out, polygon);
    out.push_back(',');
  }
  out.push_back(']');
  toml_ = fmt::to_string(out);
}

Value Value::parsed(std::string_view text) {
  Value value(false);
  value.toml_ = text;
  return value;
}

}  // namespace shatterpave
