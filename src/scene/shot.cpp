#include "scene/shot.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "core/cancel.h"
#include "core/notes.h"
#include "scene/input_file.h"
#include "scene/schema/known_path.h"
#include "scene/table_scene.h"
#include "scene/toml/apply_override.h"

namespace shatterpave::scene {

namespace {

// As TOML writes it.
std::string value_text(const FrameKey& key, int frame) {
  std::string text;
  for (const double number : value_at(key, frame)) {
    text += text.empty() ? "" : ", ";
    if (key.is_whole) {
      text += fmt::format("{:.0f}", number);
    } else {
      // Digits alone are a whole number, which may be too large for one.
      const std::string digits = fmt::format("{}", number);
      text += digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
    }
  }
  return key.is_list ? fmt::format("[{}]", text) : text;
}

// Where the key stands, and the frame: what a message says of the value.
std::string origin_of(const FrameKey& key, int frame) { return located(key.place, fmt::format("frame {}", frame)); }

bool is_of_things(const FrameKey& key) {
  return std::ranges::any_of(std::initializer_list<std::string_view>{"pane", "pavement", "plan"}, [&](std::string_view table) {
    return key.set.starts_with(table) &&
           (key.set.size() == table.size() || key.set[table.size()] == '.' || key.set[table.size()] == '[');
  });
}

}  // namespace

Shot::Shot(const Draft& draft) : draft_(draft), table_(draft_.made()), still_(draft_.scene()), keeps_things_(true) {
  if (still_.frames) keeps_things_ = std::ranges::none_of(still_.frames->keys, is_of_things);
}

Shot::~Shot() = default;

Scene Shot::at(int frame) {
  if (still_.frames) {
    for (const FrameKey& key : still_.frames->keys) {
      const Override change{origin_of(key, frame), key.set, value_text(key, frame)};
      require_known(change, table_->root);
      apply(change, table_->root);
    }
  }
  Scene scene = scene_of_table(table_->root, draft_.file_, keeps_things_ ? &still_ : nullptr);
  scene.notes.clear();
  return scene;
}

void Shot::require_all() {
  if (!still_.frames) return;
  for (int frame = still_.frames->range.first; frame <= still_.frames->range.last; ++frame) {
    stop_if_cancelled();
    at(frame);
  }
}

std::unique_ptr<Shot> shot_of_file(const std::filesystem::path& file, const std::vector<Override>& overrides) {
  Draft draft(input_text(file, largest_scene_bytes, Place{file.string(), 0, 0, ""}), file);
  for (const Override& change : overrides) draft.set(change);
  return std::make_unique<Shot>(draft);
}

}  // namespace shatterpave::scene
