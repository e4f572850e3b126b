// Input files as bytes, with limits.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace shatterpave::scene {

// Limits of input files, so that no file can take all memory: a value of a parsed file takes some 100 bytes.
inline constexpr std::size_t largest_scene_bytes = std::size_t{16} << 20;
inline constexpr std::size_t largest_outline_bytes = std::size_t{32} << 20;

// Whether a file has no name of its own: "-", which is the standard input, and what a shell opens for a command (/dev/fd/63,
// /dev/stdin). Its contents tell what it is, and what it names is sought from the current folder.
bool is_nameless(const std::filesystem::path& file);

// The content of a regular file, of a pipe to its end, or of the standard input for "-". Throws InputError, at `place`, where
// it is missing, not a file, unreadable or larger than `limit`.
std::string input_text(const std::filesystem::path& file, std::size_t limit, const Place& place);

// Throws InputError at the first byte that is not UTF-8. `file` is the name for the message.
void require_utf8(std::string_view text, const std::string& file);

// Of the Latin alphabet, whatever the locale.
inline bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// Line and column of a byte of a text, from 1; the column counts characters (UTF-8).
struct TextPosition {
  int line = 1;
  int column = 1;
};
TextPosition text_position(std::string_view text, std::size_t byte);

// The same for many bytes of one text, which must outlive this: each answer reads a small part of it.
class TextIndex {
 public:
  explicit TextIndex(std::string_view text);
  TextPosition position(std::size_t byte) const;

 private:
  std::string_view text_;
  std::vector<TextPosition> at_steps_;
};

// The words of a text, which spaces, tabs and line breaks part.
std::vector<std::string> words_of(std::string_view text);

// `text` for a message: in quotes, at most 40 characters, without control characters.
std::string in_quotes(std::string_view text);

}  // namespace shatterpave::scene
