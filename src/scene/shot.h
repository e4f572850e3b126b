// A scene over its frames.
#pragma once

#include <memory>

#include "scene/draft.h"
#include "scene/scene.h"

namespace shatterpave::scene {

class Shot {
 public:
  // Of a draft. Throws InputError where its scene is wrong, as Draft::scene does.
  explicit Shot(const Draft& draft);
  ~Shot();
  Shot(const Shot&) = delete;
  Shot& operator=(const Shot&) = delete;

  // The scene as it stands but for its keys: what is shown where no frame is asked for.
  const Scene& still() const { return still_; }
  // The scene at a frame, with all keys set; without notes. `fingerprint` says what is shown at that frame, and is that of any
  // scene without frames that says the same: frames that look alike have the same. Throws InputError, at the key that sets it,
  // where a value is not such as the scene takes.
  Scene at(int frame);

  // Whether a key is of a pane, a pavement or the plans, so that these may differ from frame to frame.
  bool changes_things() const { return !keeps_things_; }

  // Throws InputError at the first frame of the range that is wrong.
  void require_all();

 private:
  Draft draft_;
  std::unique_ptr<Draft::Table> table_;  // with the keys of the frame that was asked for last
  Scene still_;
  bool keeps_things_;  // no key is of a pane, a pavement or the plans
};

// The shot of a file (scene/read_scene.h).
std::unique_ptr<Shot> shot_of_file(const std::filesystem::path& file, const std::vector<Override>& overrides = {});

}  // namespace shatterpave::scene
