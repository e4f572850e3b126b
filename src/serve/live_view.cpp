#include "serve/live_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <exception>
#include <limits>
#include <new>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "core/cancel.h"
#include "core/notes.h"
#include "export/gltf/scene_gltf.h"
#include "pipeline/generate.h"
#include "pipeline/outlook.h"
#include "scene/draft.h"
#include "scene/draft_values.h"

namespace shatterpave::serve {

namespace {

using std::chrono::milliseconds;
using Json = nlohmann::ordered_json;

constexpr milliseconds look_interval{50};
constexpr int most_looks_failed = 5;  // an editor that replaces a file leaves none for a moment
constexpr std::size_t most_notes = 20;
constexpr std::uint16_t swatch_px = 512;  // by eye: what a screen shows of a stone

Shared shared(std::string text) { return std::make_shared<const std::string>(std::move(text)); }

Json json_of(const Place& place, const std::string& message) {
  return {{"message", message}, {"file", place.file}, {"line", place.line}, {"column", place.column}, {"key", place.key}};
}

void require_few_stones(const exporting::Model& model) {
  std::size_t count = 0;
  for (const exporting::PavedArea& paved : model.pavements) count += paved.layout.stones.size();
  if (count <= most_stones_shown) return;
  throw InputError(fmt::format("expected at most {} stones, which a browser can show, got {}", most_stones_shown, count));
}

}  // namespace

LiveView::LiveView(const std::filesystem::path& file, std::filesystem::path program)
    : file_(file), program_(std::move(program)), name_(file.filename().string()) {
  maker_.emplace([this](const std::stop_token& stopped) { make_versions(stopped); });
  renderer_.emplace([this](const std::stop_token& stopped) { render_drafts(stopped); });
  watcher_.emplace(look_interval, [this] { watch(); });
}

LiveView::~LiveView() { stop(); }

void LiveView::stop() {
  const std::scoped_lock lock(mutex_);
  is_stopped_ = true;
  changed();
}

void LiveView::changed() const {
  ++revision_;
  changed_.notify_all();
}

void LiveView::want() {
  ++wanted_;
  changed();
}

void LiveView::set(const Values& values) {
  const std::scoped_lock lock(mutex_);
  SceneFile trial = file_;
  for (const auto& [key, value] : values) trial.set(key, value);
  file_ = std::move(trial);
  want();
}

void LiveView::step_seed(std::int64_t by) {
  const std::scoped_lock lock(mutex_);
  constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  const std::uint64_t step = by < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(by) : static_cast<std::uint64_t>(by);
  const std::uint64_t seed = by < 0 ? seed_ - std::min(seed_, step) : seed_ + std::min(most - seed_, step);
  file_.set("seed", fmt::format("{}", seed));
  seed_ = seed;
  want();
}

void LiveView::revert() {
  const std::scoped_lock lock(mutex_);
  file_.revert();
  want();
}

void LiveView::save() {
  const std::scoped_lock lock(mutex_);
  if (version_ != wanted_) {
    throw InputError(fault_ ? fault_->place : Place{},
                     fault_ ? "not saved: " + fault_->message : "not saved: what was changed is still being made");
  }
  file_.save();
  changed();
}

std::string LiveView::text() const {
  const std::scoped_lock lock(mutex_);
  return file_.edited();
}

std::string LiveView::state() const {
  const std::scoped_lock lock(mutex_);
  Json keys = Json::array();
  for (const scene::Override& change : file_.changes()) keys.push_back(change.key);
  const std::optional<Fault>& fault = file_fault_ ? file_fault_ : fault_;
  Json render{
      {"state", is_rendering_ || job_ ? "running" : (render_message_.empty() ? (picture_ ? "done" : "none") : "failed")},
      {"part", part_},
      {"picture", picture_number_},
      {"message", render_message_}};
  const Json state{
      {"revision", revision_}, {"wanted", wanted_},   {"tried", made_},
      {"version", version_},   {"scene", values_of_}, {"details", details_of_},
      {"changed", keys},       {"seed", seed_},       {"error", fault ? json_of(fault->place, fault->message) : Json(nullptr)},
      {"notes", notes_},       {"render", render},    {"name", name_}};
  return state.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::uint64_t LiveView::wait_for_other(std::uint64_t revision, milliseconds longest) const {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, longest, [&] { return revision_ != revision || is_stopped_; });
  return revision_;
}

Shared LiveView::bodies() const {
  const std::scoped_lock lock(mutex_);
  return bodies_;
}
Shared LiveView::values() const {
  const std::scoped_lock lock(mutex_);
  return values_;
}
Shared LiveView::statistics() const {
  const std::scoped_lock lock(mutex_);
  return statistics_;
}
Shared LiveView::drawing(std::size_t thing) const {
  const std::scoped_lock lock(mutex_);
  return thing < drawings_.size() ? drawings_[thing] : nullptr;
}
Shared LiveView::picture() const {
  const std::scoped_lock lock(mutex_);
  return picture_;
}

// --- Versions -----------------------------------------------------------------------------------------------------------

bool LiveView::is_outdated(std::uint64_t number) const {
  const std::scoped_lock lock(mutex_);
  return is_stopped_ || wanted_ != number;
}

void LiveView::fail(std::uint64_t number, Fault fault) {
  const std::scoped_lock lock(mutex_);
  if (wanted_ != number) return;
  made_ = number;
  fault_ = std::move(fault);
  changed();
}

void LiveView::make_versions(const std::stop_token& stopped) {
  while (!stopped.stop_requested()) {
    Wanted wanted;
    {
      std::unique_lock lock(mutex_);
      const bool is_there = changed_.wait(lock, stopped, [&] { return made_ != wanted_ || is_stopped_; });
      if (!is_there || is_stopped_) return;
      wanted = {wanted_, file_.text(), file_.changes()};
    }
    try {
      const CancelScope scope([this, number = wanted.number] { return is_outdated(number); });
      make(wanted);
    } catch (const Interrupted&) {
      // A newer state is wanted.
    } catch (const InputError& error) {
      fail(wanted.number, {error.message(), error.place()});
    } catch (const std::bad_alloc&) {
      fail(wanted.number, {"out of memory", {}});
    } catch (const std::exception& error) {
      fail(wanted.number, {error.what(), {}});
    }
  }
}

void LiveView::make(const Wanted& wanted) {
  scene::Draft draft(wanted.text, file_.path());
  for (const scene::Override& change : wanted.changes) draft.set(change);
  scene::Scene scene = draft.scene();
  const Shared values = shared(scene::draft_values(draft, scene));
  {
    const std::scoped_lock lock(mutex_);
    if (wanted_ != wanted.number) throw Interrupted();
    seed_ = scene.seed;
    values_ = values;
    values_of_ = wanted.number;
    changed();
  }
  pipeline::require_possible(scene);
  pipeline::require_possible_for(exporting::gltf::target, scene);
  for (paving::Pavement& pavement : scene.pavements) {
    pavement.textures.swatch_px = std::min(pavement.textures.swatch_px, swatch_px);
  }
  const exporting::Model model = pipeline::generated(scene);
  require_few_stones(model);
  std::vector<Note> notes = scene.notes;
  for (Note& note : pipeline::emptiness(scene, model)) add_note(std::move(note), notes);
  show_bodies(wanted, model);
  std::vector<std::string> told;
  for (std::size_t i = 0; i < std::min(notes.size(), most_notes); ++i) told.push_back(located(notes[i]));
  Details made = details(model);
  std::vector<Shared> drawings;
  for (exporting::OutputFile& file : made.drawings) drawings.push_back(shared(std::move(file.content)));
  const std::scoped_lock lock(mutex_);
  statistics_ = shared(std::move(made.statistics));
  drawings_ = std::move(drawings);
  notes_ = std::move(told);
  details_of_ = wanted.number;
  made_ = wanted.number;
  changed();
}

void LiveView::show_bodies(const Wanted& wanted, const exporting::Model& model) {
  const auto pictures = [this](const exporting::shapes::Swatch& swatch, std::uint64_t seed) {
    return swatches_.files(swatch, seed);
  };
  stop_if_cancelled();
  Shared bodies = shared(exporting::gltf::gltf_file(model, pictures).content);
  const std::scoped_lock lock(mutex_);
  if (wanted_ != wanted.number) throw Interrupted();
  bodies_ = std::move(bodies);
  version_ = wanted.number;
  fault_.reset();
  changed();
}

// --- The file -----------------------------------------------------------------------------------------------------------

void LiveView::watch() {
  const std::scoped_lock lock(mutex_);
  try {
    const bool is_other = file_.reload();
    looks_failed_ = 0;
    if (std::exchange(file_fault_, std::nullopt) || is_other) want();
  } catch (const InputError& error) {
    if (++looks_failed_ < most_looks_failed) return;
    Fault fault{error.message(), error.place()};
    if (file_fault_ == fault) return;
    file_fault_ = std::move(fault);
    changed();
  } catch (const std::exception&) {
    // Looked at again in a moment.
  }
}

// --- Drafts -------------------------------------------------------------------------------------------------------------

void LiveView::render(int width, int height) {
  const std::scoped_lock lock(mutex_);
  if (fault_ || version_ == 0) throw InputError("expected a scene that can be shown, got none");
  ++job_number_;
  job_ = DraftJob{program_, file_.path(), file_.changes(), width, height};
  part_ = 0.0;
  render_message_.clear();
  changed();
}

void LiveView::stop_render() {
  const std::scoped_lock lock(mutex_);
  ++job_number_;
  job_.reset();
  changed();
}

bool LiveView::wait_for_draft(milliseconds longest) const {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, longest, [&] { return !is_rendering_; });
}

void LiveView::render_drafts(const std::stop_token& stopped) {
  while (!stopped.stop_requested()) {
    DraftJob job;
    std::uint64_t number = 0;
    {
      std::unique_lock lock(mutex_);
      const bool is_there = changed_.wait(lock, stopped, [&] { return job_.has_value() || is_stopped_; });
      if (!is_there || is_stopped_) return;
      job = *std::exchange(job_, std::nullopt);
      number = job_number_;
      is_rendering_ = true;
    }
    render_draft(job, number);
    const std::scoped_lock lock(mutex_);
    is_rendering_ = false;
    changed();
  }
}

void LiveView::render_draft(const DraftJob& job, std::uint64_t number) {
  const auto cancelled = [this, number] {
    const std::scoped_lock lock(mutex_);
    return is_stopped_ || job_number_ != number;
  };
  const auto progress = [this](double part) {
    const std::scoped_lock lock(mutex_);
    part_ = std::clamp(part, 0.0, 1.0);
    changed();
  };
  std::string message;
  try {
    Shared picture = shared(draft_picture(job, progress, cancelled));
    const std::scoped_lock lock(mutex_);
    picture_ = std::move(picture);
    picture_number_ = number;
  } catch (const Interrupted&) {
    return;
  } catch (const std::exception& error) {
    message = error.what();
  }
  const std::scoped_lock lock(mutex_);
  if (job_number_ == number) render_message_ = message;
}

}  // namespace shatterpave::serve
