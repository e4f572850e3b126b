// All tables of the scene file with their keys, and what is told of them: by `shatterpave keys`, and in docs/scene-file.md.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "scene/schema/key.h"

namespace shatterpave::scene {

// Outer tables come before the tables in them.
std::span<const KeyTable> key_tables();

// The key to which a path of values leads (scene/override.h): `pane.window.thickness_mm`, `pane[0].size_mm[1]`. Null where it
// leads to none.
const Key* key_of_path(std::string_view path);

// A line for each key: path, type and range, default, what it does.
std::string keys_text();

// {"format": "shatterpave-keys", "version": 1, "keys": […]}. Each key has `path`, `type` (a name of ValueType), `default` (null
// where it follows from other keys), `sentence`, and where it has them `unit`, `low` and `high` with `open_low` and
// `open_high`, `choices`, `written` (how the value is written) and `default_words`. For a point and for limits, bounds are
// those of each number. `default_words` alone are the default; beside a value they say what it means, or when it is another
// one.
std::string keys_json();

// The tables of docs/scene-file.md, each between lines `<!-- keys PATH -->` and `<!-- end of keys -->`. The keys that panes and
// pavements have in common are a table of their own, of the path `pane[], pavement[]`.
std::string keys_markdown();

}  // namespace shatterpave::scene
