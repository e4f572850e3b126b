#include <fmt/format.h>
#include <shatterpave/model.h>

#include <deque>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/error.h"
#include "face/model_access.h"
#include "face/plain_pane.h"
#include "face/plain_pavement.h"
#include "face/stone_maker.h"

namespace shatterpave {

namespace {

// A value that is made when it is first asked for.
template <typename Thing>
class Lazy {
 public:
  template <typename Make>
  const Thing& get(const Make& make) const {
    std::call_once(once_, [&] { thing_.emplace(make()); });
    return *thing_;
  }

 private:
  mutable std::once_flag once_;
  mutable std::optional<Thing> thing_;
};

template <typename Thing, typename Inner>
std::vector<Thing> plain_all(const std::vector<Inner>& inner) {
  std::vector<Thing> things;
  things.reserve(inner.size());
  for (const Inner& one : inner) things.push_back(face::plain(one));
  return things;
}

void require_index(std::size_t index, std::size_t count, const char* what) {
  if (index < count) return;
  throw std::out_of_range(fmt::format("{} {} of {}", what, index, count));
}

constexpr double least_step_mm = 0.1;
constexpr double greatest_step_mm = 1000.0;

}  // namespace

struct Model::Inside {
  Inside(exporting::Model made, std::vector<Note> told)
      : model(std::move(made)), notes(std::move(told)), stone_makers(model.pavements.size()) {}

  exporting::Model model;
  std::vector<Note> notes;
  Lazy<std::vector<Pane>> panes;
  Lazy<std::vector<Pavement>> pavements;
  std::deque<Lazy<face::StoneMaker>> stone_makers;  // one a pavement; they stay where they are
};

Model ModelAccess::made(exporting::Model model, std::vector<Note> notes) {
  return Model(std::make_shared<const Model::Inside>(std::move(model), std::move(notes)));
}

const exporting::Model& ModelAccess::model(const Model& model) { return model.inside_->model; }

Model::Model(std::shared_ptr<const Inside> inside) : inside_(std::move(inside)) {}
Model::Model(const Model& other) = default;
Model& Model::operator=(const Model& other) = default;
Model::Model(Model&& other) noexcept = default;
Model& Model::operator=(Model&& other) noexcept = default;
Model::~Model() = default;

const std::string& Model::name() const { return inside_->model.name; }

std::uint64_t Model::seed() const { return inside_->model.seed; }

const std::vector<Pane>& Model::panes() const& {
  return inside_->panes.get([&] { return plain_all<Pane>(inside_->model.panes); });
}

const std::vector<Pavement>& Model::pavements() const& {
  return inside_->pavements.get([&] { return plain_all<Pavement>(inside_->model.pavements); });
}

std::vector<Note> Model::notes() const { return inside_->notes; }

ShardMesh Model::shard_mesh(std::size_t pane, std::size_t shard) const {
  require_index(pane, inside_->model.panes.size(), "pane");
  const exporting::BrokenPane& broken = inside_->model.panes[pane];
  require_index(shard, broken.shards.size(), "shard");
  return face::plain_mesh(broken.shards[shard], broken.pane);
}

StoneMesh Model::stone_mesh(std::size_t pavement, std::size_t stone, const StoneMeshOptions& options) const {
  require_index(pavement, inside_->model.pavements.size(), "pavement");
  const exporting::PavedArea& paved = inside_->model.pavements[pavement];
  require_index(stone, paved.layout.stones.size(), "stone");
  if (!(options.step_mm >= least_step_mm && options.step_mm <= greatest_step_mm)) {
    throw InputError(Place{{}, 0, 0, "step_mm"},
                     fmt::format("expected a number from {} to {}, got {}", least_step_mm, greatest_step_mm, options.step_mm));
  }
  const face::StoneMaker& maker =
      inside_->stone_makers[pavement].get([&] { return face::StoneMaker(paved, inside_->model.seed); });
  return maker.mesh(stone, options);
}

}  // namespace shatterpave
