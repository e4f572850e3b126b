// [frames] of a scene file: a shot, and the keys of its numbers.
#pragma once

#include <optional>
#include <string_view>

#include "scene/frames.h"
#include "scene/schema/row.h"
#include "scene/schema/scene_facts.h"

namespace shatterpave::scene {

inline constexpr std::size_t most_frame_keys = 1000;

extern const Section<Frames, SceneFacts> frames_keys;
extern const Section<FrameKey, SceneFacts> frame_key_keys;

// [frames] of a scene, from its root table; nothing where there is none. Throws InputError for what is wrong with the table by
// itself: also where a key's path is that of no number. Whether each frame's values are such as the scene takes is asked frame
// by frame (scene/shot.h).
std::optional<Frames> frames_of(const TomlTable& root);

}  // namespace shatterpave::scene
