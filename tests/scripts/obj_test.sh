#!/usr/bin/env bash
# Shards as OBJ and PLY, read by trimesh: closed, no facet without area, with the volumes that the pane and the gaps leave, where they
# were and where they have fallen; and a pane of which nothing is left is refused in words. (blender_glass_test.sh has their materials.)
#   obj_test.sh BUILD   the build folder, in which the reader is installed
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"
python=$(python_tools trimesh trimesh==5.2.0 shapely==2.0.7 numpy==2.2.6)

pane='seed = 11
[[pane]]
name = "window"
outline_mm = [[0, 0], [200, 0], [230, 180], [-20, 160]]
thickness_mm = 4
impact = [{at_mm = [90, 90], radial_count = 60}]
[pane.shards]
gap_mm = 0.3'
printf '%s\nmissing = 0\nfallen = 0\nbevel_mm = 0\nsplinter_mm2 = 0.01\n' "$pane" >"$scratch/place.toml"
printf '%s\nfallen = 0.7\n' "$pane" >"$scratch/fallen.toml"
printf '%s\nmissing = 1\nmissing_mm = 100000\nheld = 1\nfallen = 0\n' "$pane" >"$scratch/gone.toml"

check() { "$python" "$here/obj_check.py" "$scratch/out/$1.obj" "$scratch/out/$1.ply" "$scratch/out/$1.json" 0.3 "$2"; }
for name in place fallen; do
  "$build/shatterpave" export "$scratch/$name.toml" -o "$scratch/out" --target obj --target ply --target json >/dev/null
done
grep -q '"state":"fallen"' "$scratch/out/fallen.json" || fail "no shard has fallen"
check place 0
check fallen 1

# The twins: a facet less, one turned round, and shards a hundredth too large.
cp "$scratch/out/place.obj" "$scratch/good.obj"
faulty() {
  awk "$1" "$scratch/good.obj" >"$scratch/out/place.obj"
  if check place 0 >/dev/null 2>&1; then fail "a planted fault passes: $1"; fi
}
# shellcheck disable=SC2016  # awk's own.
faulty '$1 == "f" && !gone { gone = 1; next } { print }'
# shellcheck disable=SC2016
faulty '$1 == "f" && !turned { turned = 1; print $1, $2, $4, $3; next } { print }'
# shellcheck disable=SC2016
faulty '$1 == "v" { $2 *= 1.01; $3 *= 1.01; $4 *= 1.01 } { print }'

refuses 'target obj: expected a shard .* every piece of window is gone' shatterpave export "$scratch/gone.toml" -o "$scratch/none" --target obj
[[ ! -e $scratch/none ]] || fail "an empty OBJ leaves $(find "$scratch/none")"
