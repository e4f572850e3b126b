/// \file
/// From a scene to a model.
#pragma once

#include <functional>
#include <string_view>

#include <shatterpave/model.h>
#include <shatterpave/scene.h>

namespace shatterpave {

/// How the work is done. The result does not depend on it.
struct WorkOptions {
  int threads =
      0;  ///< Threads that work at once, 0 … 1024; 0: as many as there are processors. More than those are not started.
  /// Called with the name of the work in progress and the fraction done, from 0 to 1. May be empty. Any thread calls it, one at
  /// a time. If it throws, work stops, and its exception leaves the function that works.
  std::function<void(std::string_view what, double done)> progress{};
  /// Asked from time to time whether work shall stop; then Interrupted is thrown. May be empty. Called on any thread, by
  /// several at once: a std::atomic<bool> will do. Once it says yes it must go on saying so.
  std::function<bool()> cancelled{};
};

/// Breaks the panes of the scene and lays its pavements.
///
/// The same scene, seed and version give the same model, bit by bit: with any number of threads, in any locale, on any x86-64
/// processor. No file is written; those that the scene names are read, unless they have been (see Scene).
///
/// Throws InputError where the scene is wrong or asks for what cannot be made, and Interrupted.
///
/// Threads: may be called by several at once, also on one scene; each call has its own options.
///
///     std::atomic<bool> stop = false;
///     const shatterpave::Model model = shatterpave::generate(scene, {.cancelled = [&] { return stop.load(); }});
///     for (const shatterpave::Pane& pane : model.panes()) std::cout << pane.name << ": " << pane.cracks.size() << " cracks\n";
Model generate(const Scene& scene, const WorkOptions& options = {});

}  // namespace shatterpave
