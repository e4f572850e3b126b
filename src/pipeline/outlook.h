// What can be said of a scene before anything is made of it, and which of its things came to nothing.
#pragma once

#include <string>
#include <vector>

#include "core/notes.h"
#include "export/model.h"
#include "export/target.h"
#include "scene/scene.h"

namespace shatterpave::pipeline {

// What a scene holds, in a line: "1 pane (window, 300 × 300 mm, 1 impact), 1 pavement (path, 4.8 m², about 410 stones)". The
// number of stones is an estimate, from the area, within some 15 %.
std::string summary(const scene::Scene& scene);

// A note for each thing of which nothing will be laid or left, as far as that follows from the scene alone.
std::vector<Note> emptiness(const scene::Scene& scene);

// The same for what was made of the scene.
std::vector<Note> emptiness(const scene::Scene& scene, const exporting::Model& model);

// A note for each pane whose dirt some of the targets do not show.
std::vector<Note> unseen(const scene::Scene& scene, const std::vector<const exporting::Target*>& targets);

}  // namespace shatterpave::pipeline
