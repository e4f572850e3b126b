/// \file
/// A model: what was made of a scene.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <shatterpave/error.h>
#include <shatterpave/pane.h>
#include <shatterpave/pavement.h>

namespace shatterpave {

/// What was made of a scene: broken panes and laid pavements. Made by generate; never changes. Copies share what they hold, so
/// they are cheap.
///
/// Threads: all functions may be called by several threads at once.
class Model {
 public:
  Model(const Model& other);                 ///< Shares what is held.
  Model& operator=(const Model& other);      ///< Shares what is held.
  Model(Model&& other) noexcept;             ///< What was moved from may only be assigned to or destroyed.
  Model& operator=(Model&& other) noexcept;  ///< What was moved from may only be assigned to or destroyed.
  ~Model();

  /// That of the scene: names the files that are made of the model.
  const std::string& name() const;
  /// That of the scene.
  std::uint64_t seed() const;

  /// The panes, in the order of the scene. They are made when they are first asked for, and live as long as a copy of the
  /// model.
  const std::vector<Pane>& panes() const&;
  /// Deleted, since the panes would not outlive a model that is about to go.
  const std::vector<Pane>& panes() const&& = delete;

  /// The pavements, in the order of the scene, the kerb of one after it. They are made when they are first asked for, and live
  /// as long as a copy of the model.
  const std::vector<Pavement>& pavements() const&;
  /// Deleted, since the pavements would not outlive a model that is about to go.
  const std::vector<Pavement>& pavements() const&& = delete;

  /// Notes on what was made: a pavement of which no stone is laid, a pane of which nothing is left. Those of the
  /// scene itself are Scene::notes.
  std::vector<Note> notes() const;

  /// The solid of panes()[pane].shards[shard]. Throws std::out_of_range where there is none such.
  ShardMesh shard_mesh(std::size_t pane, std::size_t shard) const;

  /// The surface of pavements()[pavement].stones[stone], the same at every call. Throws std::out_of_range where there is none
  /// such, and InputError for options out of their range.
  StoneMesh stone_mesh(std::size_t pavement, std::size_t stone, const StoneMeshOptions& options = {}) const;

 private:
  friend class ModelAccess;
  struct Inside;
  explicit Model(std::shared_ptr<const Inside> inside);
  std::shared_ptr<const Inside> inside_;
};

}  // namespace shatterpave
