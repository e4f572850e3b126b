// XML as text in UTF-8, whatever encoding the file is in.
#pragma once

#include <string>
#include <string_view>

namespace shatterpave::scene {

// The text of a file of XML in UTF-8: by its byte order mark, or by how it begins (UTF-8, UTF-16 and UTF-32 of either order),
// or by the encoding that its declaration names (any that the C library converts, such as ISO-8859-1 or windows-1252); else it
// is UTF-8. Throws InputError for bytes that are not of that encoding, and for an encoding that nobody knows. `file` is the
// name for the message.
std::string utf8_text(std::string_view bytes, const std::string& file);

}  // namespace shatterpave::scene
