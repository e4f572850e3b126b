#include <fmt/format.h>
#include <shatterpave/scene.h>

#include <mutex>
#include <utility>

#include "face/scene_access.h"
#include "pipeline/environment.h"
#include "pipeline/generate.h"
#include "pipeline/outlook.h"
#include "pipeline/parts.h"
#include "scene/draft.h"
#include "scene/input_file.h"

namespace shatterpave {

struct Scene::Inside {
  explicit Inside(scene::Draft made) : draft(std::move(made)), name(draft.name()) {}

  scene::Draft draft;
  std::string name;
  std::mutex reading;
  std::shared_ptr<const scene::Scene> read;  // of the draft as it is; null where it was changed
};

namespace {

// As Place::file names what a call gave: set("pane.window.thickness_mm").
std::string call(std::string_view function, std::string_view argument) {
  return fmt::format("{}({})", function, scene::in_quotes(argument));
}

scene::Draft draft_of_name(std::string_view name) {
  if (name.empty() || name.find('/') != std::string_view::npos) {
    throw InputError(Place{call("Scene", name), 0, 0, ""}, "expected a name without '/', which files can be named by");
  }
  return {"", std::string(name) + ".toml"};
}

}  // namespace

std::shared_ptr<const scene::Scene> SceneAccess::read(const Scene& scene) {
  Scene::Inside& inside = *scene.inside_;
  const std::scoped_lock lock(inside.reading);
  if (!inside.read) inside.read = std::make_shared<const scene::Scene>(inside.draft.scene());
  return inside.read;
}

Scene::Scene(std::string_view name) : inside_(std::make_unique<Inside>(draft_of_name(name))) {}

Scene Scene::from_file(const std::filesystem::path& file) {
  return from_text(scene::input_text(file, scene::largest_scene_bytes, Place{file.string(), 0, 0, ""}), file);
}

Scene Scene::from_text(std::string_view toml, const std::filesystem::path& file) {
  Scene scene;
  scene.inside_ = std::make_unique<Inside>(scene::Draft(toml, file));
  return scene;
}

Scene::Scene(const Scene& other) : inside_(std::make_unique<Inside>(other.inside_->draft)) {
  const std::scoped_lock lock(other.inside_->reading);
  inside_->read = other.inside_->read;
}
Scene& Scene::operator=(const Scene& other) { return *this = Scene(other); }
Scene::Scene(Scene&& other) noexcept = default;
Scene& Scene::operator=(Scene&& other) noexcept = default;
Scene::~Scene() = default;

Scene& Scene::set(std::string_view key, const Value& value) {
  inside_->draft.set({call("set", key), std::string(key), value.toml()});
  inside_->read = nullptr;
  return *this;
}

std::string Scene::append(std::string origin, std::string list, std::string table) {
  std::string path = inside_->draft.append({std::move(origin), std::move(list), std::move(table)});
  inside_->read = nullptr;
  return path;
}

std::string Scene::add(std::string_view list) { return append(call("add", list), std::string(list), "{}"); }

std::string Scene::add_pane(std::string_view name) {
  return append(call("add_pane", name), "pane", fmt::format("{{name = {}}}", Value(name).toml()));
}

std::string Scene::add_pane(std::string_view name, const Polygon& outline) {
  return append(call("add_pane", name), "pane",
                fmt::format("{{name = {}, outline_mm = {}}}", Value(name).toml(), Value(outline).toml()));
}

std::string Scene::add_impact(std::string_view pane, Point at) {
  return append(call("add_impact", pane), fmt::format("pane.{}.impact", pane), fmt::format("{{at_mm = {}}}", Value(at).toml()));
}

std::string Scene::add_pavement(std::string_view name) {
  return append(call("add_pavement", name), "pavement", fmt::format("{{name = {}}}", Value(name).toml()));
}

std::string Scene::add_pavement(std::string_view name, const Polygon& outline, const std::vector<Polygon>& holes) {
  const std::string more = holes.empty() ? std::string() : ", holes_mm = " + Value(holes).toml();
  return append(call("add_pavement", name), "pavement",
                fmt::format("{{name = {}, outline_mm = {}{}}}", Value(name).toml(), Value(outline).toml(), more));
}

void Scene::check() const {
  const std::shared_ptr<const scene::Scene> read = SceneAccess::read(*this);
  pipeline::require_possible(*read);
  pipeline::require_environment(*read);
}

const std::string& Scene::name() const { return inside_->name; }

std::uint64_t Scene::seed() const { return SceneAccess::read(*this)->seed; }

std::vector<Note> Scene::notes() const {
  const std::shared_ptr<const scene::Scene> read = SceneAccess::read(*this);
  std::vector<Note> notes = read->notes;
  for (const Note& note : pipeline::emptiness(*read)) notes.push_back(note);
  return notes;
}

std::vector<std::string> Scene::pane_names() const {
  std::vector<std::string> names;
  for (const glass::Pane& pane : SceneAccess::read(*this)->panes) names.push_back(pane.name);
  return names;
}

std::vector<std::string> Scene::pavement_names() const {
  std::vector<std::string> names;
  for (const pipeline::PavementPart& part : pipeline::pavement_parts(*SceneAccess::read(*this))) {
    if (!part.is_kerb()) names.push_back(part.pavement.name);
  }
  return names;
}

}  // namespace shatterpave
