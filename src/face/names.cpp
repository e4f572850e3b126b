// The words of the public enumerators are those of the files, so that they cannot differ.
#include "export/names.h"

#include <shatterpave/pane.h>
#include <shatterpave/pavement.h>

#include "core/error.h"
#include "face/plain_pane.h"
#include "face/plain_pavement.h"

namespace shatterpave {

namespace {

// The inner one of `all` that becomes `kind` in the face.
template <typename Inner, typename Plain, std::size_t Count>
Inner inner_of(Plain kind, const std::array<Inner, Count>& all) {
  for (const Inner inner : all) {
    if (face::plain(inner) == kind) return inner;
  }
  throw_broken_invariant("a kind of the face", __FILE_NAME__, __LINE__);
}

}  // namespace

std::string_view name_of(CrackKind kind) {
  using glass::CrackKind;
  return exporting::name_of(inner_of(kind, std::array{CrackKind::large, CrackKind::radial, CrackKind::circular,
                                                      CrackKind::branch, CrackKind::dice, CrackKind::rung, CrackKind::chip}));
}

std::string_view name_of(CrackEnd::At at) {
  using At = glass::CrackEnd::At;
  return exporting::name_of(
      inner_of(at, std::array{At::impact, At::ring, At::origin, At::edge, At::crack, At::enclosed, At::open}));
}

std::string_view name_of(ShardState state) {
  using glass::ShardState;
  return exporting::name_of(inner_of(state, std::array{ShardState::standing, ShardState::fallen, ShardState::missing}));
}

std::string_view name_of(StoneKind kind) {
  return exporting::name_of(inner_of(kind, std::array{paving::StoneKind::whole, paving::StoneKind::cut}));
}

std::string_view name_of(StonePart part) {
  using paving::StonePart;
  return exporting::name_of(inner_of(part, std::array{StonePart::field, StonePart::border, StonePart::kerb, StonePart::step}));
}

}  // namespace shatterpave
