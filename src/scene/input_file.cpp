#include "scene/input_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iostream>
#include <optional>
#include <system_error>
#include <utility>

namespace shatterpave::scene {

namespace {

bool is_continuation(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

// Well-formed characters (Unicode 15, table 3-7): a range of first bytes, the range of the second byte that goes with it, and
// the length; bytes from the third on are continuations.
struct CharacterForm {
  unsigned first_low;
  unsigned first_high;
  unsigned second_low;
  unsigned second_high;
  std::size_t length;
};
constexpr std::array<CharacterForm, 8> character_forms = {{{0xC2, 0xDF, 0x80, 0xBF, 2},
                                                           {0xE0, 0xE0, 0xA0, 0xBF, 3},
                                                           {0xE1, 0xEC, 0x80, 0xBF, 3},
                                                           {0xED, 0xED, 0x80, 0x9F, 3},
                                                           {0xEE, 0xEF, 0x80, 0xBF, 3},
                                                           {0xF0, 0xF0, 0x90, 0xBF, 4},
                                                           {0xF1, 0xF3, 0x80, 0xBF, 4},
                                                           {0xF4, 0xF4, 0x80, 0x8F, 4}}};

// The length of the character that starts at text[at], or 0 if there is none.
std::size_t character_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  if (byte(at) < 0x80) return 1;
  for (const CharacterForm& form : character_forms) {
    if (byte(at) < form.first_low || byte(at) > form.first_high) continue;
    if (byte(at + 1) < form.second_low || byte(at + 1) > form.second_high) return 0;
    const std::string_view rest = at + 2 < text.size() ? text.substr(at + 2, form.length - 2) : std::string_view();
    return rest.size() == form.length - 2 && std::ranges::all_of(rest, is_continuation) ? form.length : 0;
  }
  return 0;
}

}  // namespace

bool is_nameless(const std::filesystem::path& file) {
  const std::string& name = file.native();
  return name == "-" || name.starts_with("/dev/") || (name.starts_with("/proc/") && name.find("/fd/") != std::string::npos);
}

namespace {

// All of a stream, but no more than a byte over the limit; nothing where it cannot be read.
std::optional<std::string> content_of(std::istream& stream, std::size_t limit, std::size_t likely_size) {
  std::string text;
  // Of a pipe no one knows the size before its end.
  std::size_t size = likely_size + 1;
  while (stream && text.size() <= limit) {
    const std::size_t had = text.size();
    text.resize(std::min(std::max(size, had + 1), limit + 1));
    stream.read(text.data() + had, static_cast<std::streamsize>(text.size() - had));
    text.resize(had + static_cast<std::size_t>(stream.gcount()));
    size = 2 * text.size();
  }
  return stream.bad() ? std::nullopt : std::optional(std::move(text));
}

// Of a file that was asked for at a place, which may be in another file; then the message names this one.
[[noreturn]] void refuse_file(const std::filesystem::path& file, const Place& place, std::string_view expected,
                              std::string_view got) {
  const std::string name = place.file == file.string() ? std::string() : ": " + file.string();
  throw InputError(place, fmt::format("expected {}, got {}{}", expected, got, name));
}

constexpr std::size_t size_of_a_pipe = std::size_t{1} << 16;

// As content_of, of a file by its name.
std::optional<std::string> content_of_file(const std::filesystem::path& file, std::size_t limit, const Place& place) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) {
    const bool missing = !error || error == std::errc::no_such_file_or_directory;
    refuse_file(file, place, "a file", missing ? "none of that name" : error.message());
  }
  if (std::filesystem::is_directory(status)) refuse_file(file, place, "a file", "a folder");
  const bool regular = std::filesystem::is_regular_file(status);
  if (!regular && !std::filesystem::is_fifo(status)) refuse_file(file, place, "a regular file", "something else");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse_file(file, place, "a file that can be read", "one that cannot be opened");
  return content_of(stream, limit, regular ? static_cast<std::size_t>(std::filesystem::file_size(file)) : size_of_a_pipe);
}

}  // namespace

std::string input_text(const std::filesystem::path& file, std::size_t limit, const Place& place) {
  std::optional<std::string> text =
      file == "-" ? content_of(std::cin, limit, size_of_a_pipe) : content_of_file(file, limit, place);
  if (!text) refuse_file(file, place, "a file that can be read", "an error while reading");
  if (text->size() > limit) refuse_file(file, place, fmt::format("a file of at most {} MiB", limit >> 20), "a larger one");
  return *std::move(text);
}

void require_utf8(std::string_view text, const std::string& file) {
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t length = character_length(text, at);
    if (length == 0) {
      const TextPosition position = text_position(text, at);
      throw InputError(Place{file, position.line, position.column, ""},
                       fmt::format("expected UTF-8 text, got the byte 0x{:02x}", static_cast<unsigned char>(text[at])));
    }
    at += length;
  }
}

TextPosition text_position(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  const std::size_t newline = before.rfind('\n');
  const std::string_view line = newline == std::string_view::npos ? before : before.substr(newline + 1);
  const auto characters = line.size() - static_cast<std::size_t>(std::ranges::count_if(line, is_continuation));
  return {static_cast<int>(std::ranges::count(before, '\n')) + 1, static_cast<int>(characters) + 1};
}

namespace {

constexpr std::size_t index_step = 1024;  // bytes between known positions

// The position of the byte at `to` from that of the byte at `from`.
TextPosition moved_on(TextPosition position, std::string_view text, std::size_t from, std::size_t to) {
  for (std::size_t i = from; i < to; ++i) {
    if (text[i] == '\n') {
      ++position.line;
      position.column = 1;
    } else if (!is_continuation(text[i])) {
      ++position.column;
    }
  }
  return position;
}

}  // namespace

TextIndex::TextIndex(std::string_view text) : text_(text), at_steps_{{}} {
  for (std::size_t at = index_step; at <= text.size(); at += index_step) {
    at_steps_.push_back(moved_on(at_steps_.back(), text, at - index_step, at));
  }
}

TextPosition TextIndex::position(std::size_t byte) const {
  const std::size_t at = std::min(byte, text_.size());
  return moved_on(at_steps_[at / index_step], text_, at / index_step * index_step, at);
}

std::vector<std::string> words_of(std::string_view text) {
  constexpr std::string_view spaces = " \t\n\r\f";
  std::vector<std::string> words;
  for (std::size_t at = text.find_first_not_of(spaces); at < text.size(); at = text.find_first_not_of(spaces, at)) {
    const std::size_t end = std::min(text.find_first_of(spaces, at), text.size());
    words.emplace_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  std::size_t at = 0;
  for (int shown = 0; at < text.size() && shown < 40; ++shown) {
    const std::size_t length = character_length(text, at);
    const auto byte = static_cast<unsigned char>(text[at]);
    const bool plain = length > 1 || (length == 1 && byte >= 0x20 && byte != 0x7F);
    result += plain ? std::string(text.substr(at, length)) : fmt::format("\\x{:02x}", byte);
    at += std::max<std::size_t>(length, 1);
  }
  return result + (at < text.size() ? "…\"" : "\"");
}

}  // namespace shatterpave::scene
