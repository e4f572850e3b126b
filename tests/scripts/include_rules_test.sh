#!/usr/bin/env bash
# The include rules must hold here, and must fail on each kind of file that breaks one.
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"
rules=$root/.ci/include_rules.sh

"$rules" "$root"

mkdir -p "$scratch"/docs "$scratch"/src/glass/{growth,dicing} "$scratch"/src/paving/{bonds,packing,attic} \
  "$scratch"/src/export/{obj,svg} "$scratch"/src/{core,face,cli} "$scratch"/include/shatterpave "$scratch"/tests
cp "$root/docs/architecture.md" "$scratch/docs/"

# expect STATUS FILE LINE: a project whose only file is FILE, holding LINE.
expect() {
  local status=0 found
  printf '%s\n' "$3" >"$scratch/$2"
  found=$("$rules" "$scratch" 2>&1) || status=1
  rm "$scratch/$2"
  if ((status != $1)); then
    fail "in $2, \"$3\": expected status $1, got $status: $found"
  fi
  if (($1 == 1)) && [[ $found != "$2:1: "* ]]; then
    fail "the finding does not start with its place: $found"
  fi
}

expect 0 src/glass/growth/growth.cpp '#include "glass/pane.h"'
expect 0 src/glass/growth/growth.cpp '#include "geometry/polygon.h"'
expect 0 src/export/model.h '#include "glass/pane.h"'
expect 0 src/glass/growth/growth.cpp '// sin(x) is a comment; asin_table(3) is another name'
expect 0 src/glass/growth/growth.cpp 'const double root = std::sqrt(2.0) + cosine(1.0) + table.log(3);'
expect 1 src/glass/growth/growth.cpp '#include "paving/pavement.h"'
expect 1 src/glass/growth/growth.cpp '  #  include "cli/messages.h"'
expect 1 src/glass/growth/growth.cpp '#include "nowhere/else.h"'
expect 1 src/export/model.h '#include "glass/growth/growth.h"'
expect 1 src/glass/growth/growth.cpp '#include <glm/vec2.hpp>'
expect 0 src/glass/growth/growth.cpp 'const unsigned processors = std::thread::hardware_concurrency();'
expect 1 src/glass/growth/growth.cpp 'std::thread worker(grow);'
expect 1 src/glass/growth/growth.cpp '#include <tbb/parallel_for.h>'
expect 1 src/glass/growth/growth.cpp '#include <OpenImageIO/imageio.h>'
expect 1 src/glass/growth/growth.cpp '#include <proj.h>'
expect 1 src/glass/growth/growth.cpp 'const double x = std::sin(angle);'
expect 1 src/glass/growth/growth.cpp 'return 2 * pow(a, b);'
expect 1 src/glass/growth/growth.cpp 'std::normal_distribution<double> law;'
expect 1 src/glass/growth/growth.cpp 'std::cerr << "no";'
# The public face.
expect 0 include/shatterpave/scene.h '#include <string_view>'
expect 0 include/shatterpave/scene.h '#include <shatterpave/geometry.h>'
expect 1 include/shatterpave/scene.h '#include "scene/scene.h"'
expect 1 include/shatterpave/scene.h '#include <fmt/format.h>'
expect 1 include/shatterpave/scene.h '#include <stdlib.h>'
expect 0 src/core/error.h '#include <shatterpave/error.h>'
expect 1 src/core/error.h '#include <shatterpave/scene.h>'
expect 1 src/cli/main.cpp '#include <shatterpave/generate.h>'
expect 0 src/face/scene.cpp '#include <shatterpave/scene.h>'
expect 0 src/face/scene.cpp '#include "scene/scene.h"'
expect 1 src/cli/main.cpp '#include "face/scene_access.h"'
# The deepest folder counts: two rooms of one big room know of each other what the table says.
expect 0 src/paving/bonds/fan.cpp '#include "paving/tiles/tiling.h"'
expect 0 src/paving/laying.cpp '#include "paving/bonds/bond.h"'
expect 1 src/paving/bonds/fan.cpp '#include "paving/laying.h"'
expect 1 src/paving/bonds/fan.cpp '#include "paving/packing/packing.h"'
expect 1 src/paving/packing/packing.cpp '#include "paving/bonds/bond.h"'
expect 1 src/glass/growth/growth.cpp '#include "glass/dicing/dice.h"'
expect 1 src/glass/dicing/dice.cpp '#include "glass/growth/growth.h"'
expect 1 src/export/obj/obj.cpp '#include "export/svg/drawing_svg.h"'
expect 1 src/paving/attic/thing.cpp 'int x = 0;'
mkdir "$scratch/src/attic"
expect 1 src/attic/thing.cpp 'int x = 0;'
