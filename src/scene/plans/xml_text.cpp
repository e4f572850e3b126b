#include "scene/plans/xml_text.h"

#include <fmt/format.h>
#include <iconv.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>

#include "core/error.h"
#include "scene/input_file.h"
#include "scene/plans/svg_css.h"

namespace shatterpave::scene {

namespace {

using namespace std::string_view_literals;

struct Beginning {
  std::string_view bytes;
  const char* encoding;
  bool is_mark;  // which is no text
};
// Longer ones first, where one is the start of another (XML 1.0, appendix F).
constexpr std::array<Beginning, 9> beginnings = {{{"\xFF\xFE\0\0"sv, "UTF-32LE", true},
                                                  {"\0\0\xFE\xFF"sv, "UTF-32BE", true},
                                                  {"<\0\0\0"sv, "UTF-32LE", false},
                                                  {"\0\0\0<"sv, "UTF-32BE", false},
                                                  {"\xFF\xFE"sv, "UTF-16LE", true},
                                                  {"\xFE\xFF"sv, "UTF-16BE", true},
                                                  {"<\0"sv, "UTF-16LE", false},
                                                  {"\0<"sv, "UTF-16BE", false},
                                                  {"\xEF\xBB\xBF"sv, "UTF-8", true}}};

// The encoding that the declaration names; "UTF-8" without one.
std::string declared_encoding(std::string_view text) {
  constexpr std::string_view otherwise = "UTF-8";
  if (!text.starts_with("<?xml")) return std::string(otherwise);
  const std::string_view declaration = text.substr(0, text.find("?>"));
  const std::size_t word = declaration.find("encoding");
  const std::size_t quote = word == std::string_view::npos ? word : declaration.find_first_of("\"'", word);
  if (quote == std::string_view::npos) return std::string(otherwise);
  const std::size_t end = declaration.find(declaration[quote], quote + 1);
  if (end == std::string_view::npos) return std::string(otherwise);
  std::string name(trimmed(declaration.substr(quote + 1, end - quote - 1)));
  // It was read so far byte by byte, so it is none of these: a file that was saved anew without a look at its first line.
  const std::string low = lower_case(name);
  if (low.starts_with("utf-16") || low.starts_with("utf-32") || low.starts_with("ucs-2") || low.starts_with("iso-10646"))
    return std::string(otherwise);
  return name;
}

class Converter {
 public:
  Converter(const std::string& encoding, const std::string& file)
      : file_(file), handle_(::iconv_open("UTF-8", encoding.c_str())) {
    if (reinterpret_cast<std::intptr_t>(handle_) != -1) return;
    throw InputError(
        Place{file, 1, 1, ""},
        fmt::format("expected an encoding that is known, such as UTF-8 or ISO-8859-1, got {}", in_quotes(encoding)));
  }
  ~Converter() { ::iconv_close(handle_); }
  Converter(const Converter&) = delete;
  Converter& operator=(const Converter&) = delete;

  std::string utf8(std::string_view bytes, const std::string& encoding) {
    std::string result;
    std::string input(bytes);
    char* in = input.data();
    std::size_t in_left = input.size();
    std::array<char, 65536> buffer{};
    while (in_left > 0) {
      char* out = buffer.data();
      std::size_t out_left = buffer.size();
      const std::size_t status = ::iconv(handle_, &in, &in_left, &out, &out_left);
      result.append(buffer.data(), buffer.size() - out_left);
      if (status != static_cast<std::size_t>(-1) || errno == E2BIG) continue;
      const TextPosition position = text_position(result, result.size());
      throw InputError(Place{file_, position.line, position.column, ""},
                       fmt::format("expected text in {}, got bytes that are none", encoding));
    }
    return result;
  }

 private:
  const std::string& file_;
  iconv_t handle_;
};

}  // namespace

std::string utf8_text(std::string_view bytes, const std::string& file) {
  const auto begins = std::ranges::find_if(beginnings, [&](const Beginning& b) { return bytes.starts_with(b.bytes); });
  std::string encoding = begins != beginnings.end() ? begins->encoding : declared_encoding(bytes);
  if (begins != beginnings.end() && begins->is_mark) bytes.remove_prefix(begins->bytes.size());
  const std::string low = lower_case(encoding);
  if (low == "utf-8" || low == "utf8" || low == "us-ascii" || low == "ascii") {
    require_utf8(bytes, file);
    return std::string(bytes);
  }
  return Converter(encoding, file).utf8(bytes, encoding);
}

}  // namespace shatterpave::scene
