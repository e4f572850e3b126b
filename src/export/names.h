// The names that files use for kinds of things. They are promised to users: none may change.
#pragma once

#include <string_view>

#include "glass/network.h"
#include "glass/shards/shards.h"
#include "paving/stones.h"

namespace shatterpave::exporting {

std::string_view name_of(glass::CrackKind kind);
std::string_view name_of(glass::CrackEnd::At at);
std::string_view name_of(glass::ShardState state);
std::string_view name_of(paving::StoneKind kind);
std::string_view name_of(paving::StonePart part);

}  // namespace shatterpave::exporting
