#!/usr/bin/env bash
# Breaks the product on purpose, in a copy, one way after another, and shows which test notices. A break that no test notices
# makes this fail. Too slow for every landing: some minutes for each break.
#   .ci/mutations.sh [NAME …]    those breaks only
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=setup.sh
source "$here/setup.sh"
install_packages build render test || exit 1

# name | file | sed expression | what tests may notice it (a filter of GoogleTest)
breaks="
glass_of_air        | templates/includes/shatterpave_glass.inc | s/ior 1\.52/ior 1.0/                               | *RenderGolden*pane*
one_radial_fewer    | src/glass/growth/counts.cpp            | s/counts\.radial_count = m;/counts.radial_count = m - 1;/ | Counts*:Growth.*:*RenderGolden*pane*
joints_5_per_cent   | src/paving/tiles/cutting.cpp          | s/std::max(0\.5 \* joint_mm/std::max(0.525 * joint_mm/ | Laying*:*RenderGolden*path*
relief_left_out     | src/export/povray/stones.cpp    | s/pavement\.relief\.rms_mm == 0\.0/true/            | *Render*path*
mirrored_side       | src/geometry/predicates.cpp     | s/return left > right/return left < right/         | -*Render*
biased_draws        | src/core/random.cpp             | s/0x1p-53/0x1.fp-54/                               | -*Render*
poisson_one_more    | src/core/random.cpp             | s/^  return k;/  return k + 1;/                    | -*Render*
lattice_of_10_um    | src/geometry/lattice.h          | s/lattice_per_mm = 1000\.0/lattice_per_mm = 100.0/ | -*Render*
warning_in_the_glass| templates/includes/shatterpave_glass.inc | s/diffuse 0\.6\$/diffuse 0.6, 0.6/                 | *Render*pane*
joints_unchecked    | src/glass/map/crack_map.cpp         | s/can_join(from, joint, hit\.segment)) return/true) return/ | Crack*:ClosedRegion*:Topology*:Growth.*
vertices_of_others  | src/glass/map/crack_map.cpp         | s/is_taken(joint, met)) return false/false) return false/ | Crack*:ClosedRegion*:Topology*:Growth.*
edge_met_unchecked  | src/glass/map/crack_map.cpp         | s/return within(from, joint, segment) \&\& /return / | Crack*:ClosedRegion*:Topology*:Growth.*
off_the_edge        | src/glass/map/crack_map.cpp         | s/is_beside(joint, segment) \&\& //                | Crack*:ClosedRegion*:Topology*:Growth.*
vertex_a_place_off  | src/glass/map/crack_map.cpp         | s/points\.begin() + place + 1/points.begin() + place/ | Crack*:ClosedRegion*:Topology*:Growth.*
regions_unseen      | src/glass/map/crack_map.cpp         | s/closed_region(crack, touched)}/{}}/       | Crack*:ClosedRegion*:Topology*:Growth.*
"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
git -C "$root" archive HEAD | tar -x -C "$scratch"
launcher=()
if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
quietly cmake -S "$scratch" -B "$scratch/build" -DCMAKE_BUILD_TYPE=Release -DSHATTERPAVE_TESTS=ON "${launcher[@]}"

trim() { sed 's/^ *//; s/ *$//' <<<"$1"; }

unnoticed=0
while IFS='|' read -r name file change filter; do
  name=$(trim "$name") file=$scratch/$(trim "$file") change=$(trim "$change") filter=$(trim "$filter")
  if [[ -z $name ]] || { (($#)) && [[ " $* " != *" $name "* ]]; }; then continue; fi
  cp "$file" "$scratch/kept"
  sed -i "$change" "$file"
  if cmp -s "$file" "$scratch/kept"; then
    printf '%-22s changes nothing any more\n' "$name"
    ((++unnoticed))
    continue
  fi
  if ! cmake --build "$scratch/build" --target shatterpave_tests shatterpave_image_tests --parallel "$(nproc)" >"$scratch/log" 2>&1; then
    found="does not build"
  elif "$scratch/build/tests/shatterpave_tests" --gtest_brief=1 --gtest_filter="$filter" >"$scratch/log" 2>&1 &&
    "$scratch/build/tests/shatterpave_image_tests" --gtest_brief=1 --gtest_filter="$filter" >>"$scratch/log" 2>&1; then
    found="NOT NOTICED"
    ((++unnoticed))
  else
    found=$(sed -n 's/^\[  FAILED  \] \([^ ,]*\).*(.*/\1/p' "$scratch/log" | sort -u | paste -sd' ')
  fi
  cp "$scratch/kept" "$file"
  printf '%-22s %s\n' "$name" "${found:-the tests crash: $(tail -n 1 "$scratch/log")}"
done <<<"$breaks"
exit "$((unnoticed > 0))"
