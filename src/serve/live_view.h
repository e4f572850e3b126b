// The scene that is shown: what was made of it last, what is being made, and what went wrong. A thread of its own makes
// versions, another watches the file, a third renders drafts; requests only read, or say what they want.
//
// Of everything there is one: the newest state that is wanted, the version that is shown, the newest picture. A state that is
// wanted while another is being made ends that one's making. So nothing queues, however fast a knob is turned.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "core/background.h"
#include "core/error.h"
#include "core/parallel.h"
#include "serve/details.h"
#include "serve/draft_render.h"
#include "serve/scene_file.h"
#include "serve/swatch_store.h"

namespace shatterpave::serve {

using Shared = std::shared_ptr<const std::string>;

// Scenes of more stones are not shown: a browser would take gigabytes for them.
inline constexpr std::size_t most_stones_shown = 100'000;

class LiveView {
 public:
  // `program` renders drafts. Throws InputError where the file is missing or unreadable; one that is no scene is shown as an
  // error.
  LiveView(const std::filesystem::path& file, std::filesystem::path program);
  ~LiveView();
  LiveView(const LiveView&) = delete;
  LiveView& operator=(const LiveView&) = delete;

  // Each throws InputError with what is wrong, and then changes nothing.
  using Values = std::vector<std::pair<std::string, std::string>>;  // keys, and values in TOML
  void set(const Values& values);
  // From the seed that is wanted.
  void step_seed(std::int64_t by);
  void revert();
  void save();
  void render(int width, int height);
  void stop_render();

  // The scene's text with all changes.
  std::string text() const;
  // What is told of the state, as JSON in a line: {"revision", "wanted", "version", "scene", "details", "changed": [keys],
  // "seed", "error", "notes", "render": {"state", "part", "picture", "message"}, "name"}. `version`, `scene` and `details` are
  // numbers of the state of which the bodies, the values and the numbers are; `wanted` that of the newest.
  std::string state() const;
  // Waits for a revision other than that, or for the time; returns the revision that is.
  std::uint64_t wait_for_other(std::uint64_t revision, std::chrono::milliseconds longest) const;

  // Null where there is none yet.
  Shared bodies() const;      // the .glb of the version that is shown
  Shared values() const;      // scene::draft_values
  Shared statistics() const;  // Details::statistics
  Shared drawing(std::size_t thing) const;
  Shared picture() const;  // the newest draft, as PNG

  // Asks all that waits and works to end.
  void stop();
  // Waits until no draft is being rendered, for that long; whether none is.
  bool wait_for_draft(std::chrono::milliseconds longest) const;

 private:
  struct Wanted {
    std::uint64_t number = 0;
    std::string text;
    std::vector<scene::Override> changes;
  };
  struct Fault {
    std::string message;
    Place place;
    bool operator==(const Fault&) const = default;
  };

  void make_versions(const std::stop_token& stopped);
  void make(const Wanted& wanted);
  void show_bodies(const Wanted& wanted, const exporting::Model& model);
  void watch();
  void render_drafts(const std::stop_token& stopped);
  void render_draft(const DraftJob& job, std::uint64_t number);
  bool is_outdated(std::uint64_t number) const;
  // With the mutex held.
  void want();
  void changed() const;
  void fail(std::uint64_t number, Fault fault);

  mutable std::mutex mutex_;
  mutable std::condition_variable_any changed_;
  mutable std::uint64_t revision_ = 1;
  SceneFile file_;
  std::filesystem::path program_;
  std::string name_;
  bool is_stopped_ = false;

  std::uint64_t wanted_ = 1;
  std::uint64_t made_ = 0;  // the last that was tried
  std::uint64_t version_ = 0;
  std::uint64_t values_of_ = 0;
  std::uint64_t details_of_ = 0;
  Shared bodies_;
  Shared values_;
  Shared statistics_;
  std::vector<Shared> drawings_;
  std::vector<std::string> notes_;
  std::optional<Fault> fault_;       // of the state that was tried last
  std::optional<Fault> file_fault_;  // the file cannot be read
  int looks_failed_ = 0;
  std::uint64_t seed_ = 1;  // of the newest state that could be read

  std::optional<DraftJob> job_;
  std::uint64_t job_number_ = 0;  // of the newest draft that was asked for; 0: none
  bool is_rendering_ = false;
  double part_ = 0.0;
  std::string render_message_;
  Shared picture_;
  std::uint64_t picture_number_ = 0;

  SwatchStore swatches_;  // of the thread that makes versions

  // Declared last, so that they end before what they use.
  std::optional<Background> maker_;
  std::optional<Background> renderer_;
  std::optional<Heartbeat> watcher_;
};

}  // namespace shatterpave::serve
