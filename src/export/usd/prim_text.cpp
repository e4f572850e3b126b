#include "export/usd/prim_text.h"

#include <fmt/compile.h>

#include <cmath>

namespace shatterpave::exporting::usd {

std::int64_t in_parts(double value, double parts) { return std::llround(value * parts); }

void put_number(Buffer& out, double value) { fmt::format_to(std::back_inserter(out), FMT_COMPILE("{}"), value + 0.0); }

// One division, so that the shortest number that reads back is the one with as many digits as there are parts.
void put_in_parts(Buffer& out, std::int64_t value, double parts) { put_number(out, static_cast<double>(value) / parts); }

std::string vector_text(vec3 value, double parts) {
  Buffer out;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    fmt::format_to(std::back_inserter(out), "{}", axis == 0 ? "(" : ", ");
    put_in_parts(out, in_parts(value[axis], parts), parts);
  }
  out.push_back(')');
  return fmt::to_string(out);
}

std::string in_usd_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

std::string asset(std::string_view file) {
  if (file.find('@') == std::string_view::npos) return fmt::format("@./{}@", file);
  std::string escaped;
  for (std::size_t at = 0; at < file.size();) {
    const bool is_end = file.substr(at, 3) == "@@@";
    escaped += is_end ? "\\@@@" : std::string(1, file[at]);
    at += is_end ? 3 : 1;
  }
  return fmt::format("@@@./{}@@@", escaped);
}

std::string identifier(std::string_view name) {
  std::string result;
  for (const char c : name) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    const bool is_digit = c >= '0' && c <= '9';
    if (result.empty() && is_digit) result += '_';
    result += is_letter || is_digit ? c : '_';
  }
  return result.empty() ? "_" : result;
}

void PrimText::begin(std::string_view what, std::string_view name, const std::vector<std::string>& metadata) {
  line("{} \"{}\"{}", what, name, metadata.empty() ? "" : " (");
  if (!metadata.empty()) {
    ++depth_;
    for (const std::string& fact : metadata) line("{}", fact);
    --depth_;
    line(")");
  }
  line("{{");
  ++depth_;
}

void PrimText::end() {
  --depth_;
  line("}}");
}

void PrimText::list(std::string_view declaration, const std::vector<std::uint32_t>& numbers) {
  list(declaration, numbers.size(),
       [&](Buffer& out, std::size_t i) { fmt::format_to(std::back_inserter(out), FMT_COMPILE("{}"), numbers[i]); });
}

void PrimText::indent() {
  constexpr std::string_view step = "    ";
  for (std::size_t i = 0; i < depth_; ++i) out_.append(step.data(), step.data() + step.size());
}

void PrimText::separate() {
  constexpr std::string_view comma = ", ";
  out_.append(comma.data(), comma.data() + comma.size());
}

}  // namespace shatterpave::exporting::usd
