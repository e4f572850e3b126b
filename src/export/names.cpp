#include "export/names.h"

#include "core/error.h"

namespace shatterpave::exporting {

std::string_view name_of(glass::CrackKind kind) {
  switch (kind) {
    case glass::CrackKind::large:
      return "large";
    case glass::CrackKind::radial:
      return "radial";
    case glass::CrackKind::circular:
      return "circular";
    case glass::CrackKind::branch:
      return "branch";
    case glass::CrackKind::dice:
      return "dice";
    case glass::CrackKind::rung:
      return "rung";
    case glass::CrackKind::chip:
      return "chip";
  }
  throw_broken_invariant("known CrackKind", __FILE_NAME__, __LINE__);
}

std::string_view name_of(glass::CrackEnd::At at) {
  switch (at) {
    case glass::CrackEnd::At::impact:
      return "impact";
    case glass::CrackEnd::At::ring:
      return "ring";
    case glass::CrackEnd::At::origin:
      return "origin";
    case glass::CrackEnd::At::edge:
      return "edge";
    case glass::CrackEnd::At::crack:
      return "crack";
    case glass::CrackEnd::At::enclosed:
      return "enclosed";
    case glass::CrackEnd::At::open:
      return "open";
  }
  throw_broken_invariant("known CrackEnd::At", __FILE_NAME__, __LINE__);
}

std::string_view name_of(glass::ShardState state) {
  switch (state) {
    case glass::ShardState::standing:
      return "standing";
    case glass::ShardState::fallen:
      return "fallen";
    case glass::ShardState::missing:
      return "missing";
  }
  throw_broken_invariant("a state of a shard", __FILE_NAME__, __LINE__);
}

std::string_view name_of(paving::StoneKind kind) {
  switch (kind) {
    case paving::StoneKind::whole:
      return "whole";
    case paving::StoneKind::cut:
      return "cut";
  }
  throw_broken_invariant("known StoneKind", __FILE_NAME__, __LINE__);
}

std::string_view name_of(paving::StonePart part) {
  switch (part) {
    case paving::StonePart::field:
      return "field";
    case paving::StonePart::border:
      return "border";
    case paving::StonePart::kerb:
      return "kerb";
    case paving::StonePart::step:
      return "step";
  }
  throw_broken_invariant("known StonePart", __FILE_NAME__, __LINE__);
}

}  // namespace shatterpave::exporting
