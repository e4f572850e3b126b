// Values of a TOML text, changed where they stand: comments, spaces, line ends and the order of everything else stay as they
// are.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/override.h"

namespace shatterpave::scene {

// The text with the values of all changes, in their order (scene/override.h). A value that is there is replaced by the new one
// as it is given; one that is not is added at the end of its table, as the lines above it are indented and aligned, and a table
// that is not there after the table that it belongs to. Parsed, the result is what `apply` (apply_override.h) makes of the
// parsed text.
//   file  the name of the text in messages
// Throws InputError where the text is no TOML, or where a key leads nowhere or to a whole table.
std::string edited_text(std::string_view text, const std::string& file, const std::vector<Override>& changes);

// The value of a key as it is written in the text; nothing where it is not there. Throws InputError where the text is no TOML.
std::optional<std::string> written_value(std::string_view text, const std::string& file, const Override& asked);

}  // namespace shatterpave::scene
