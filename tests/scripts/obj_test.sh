#!/usr/bin/env bash
# Shards as OBJ and PLY, read by trimesh: closed, no facet without area, with the volumes that the pane and the gaps leave, where they
# were and where they have fallen; and a pane of which nothing is left is refused in words. (blender_glass_test.sh has their materials.)
#   obj_test.sh BUILD   the build folder, in which the reader is installed
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
build=$(cd -- "$1" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
# shellcheck source=tests/scripts/python_tools.sh
source "$here/python_tools.sh"
python=$(python_tools "$build" trimesh trimesh==5.2.0 shapely==2.0.7 numpy==2.2.6)

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
grep -q '"state":"fallen"' "$scratch/out/fallen.json" || { echo "no shard has fallen"; exit 1; }
check place 0
check fallen 1

# The twins: a facet less, one turned round, and shards a hundredth too large.
cp "$scratch/out/place.obj" "$scratch/good.obj"
faulty() {
  awk "$1" "$scratch/good.obj" >"$scratch/out/place.obj"
  if check place 0 >/dev/null 2>&1; then echo "a planted fault passes: $1"; exit 1; fi
}
# shellcheck disable=SC2016  # awk's own.
faulty '$1 == "f" && !gone { gone = 1; next } { print }'
# shellcheck disable=SC2016
faulty '$1 == "f" && !turned { turned = 1; print $1, $2, $4, $3; next } { print }'
# shellcheck disable=SC2016
faulty '$1 == "v" { $2 *= 1.01; $3 *= 1.01; $4 *= 1.01 } { print }'

status=0
"$build/shatterpave" export "$scratch/gone.toml" -o "$scratch/none" --target obj 2>"$scratch/told" >/dev/null || status=$?
if [[ $status != 2 || -e $scratch/none ]] || ! grep -q 'target obj: expected a shard .* every piece of window is gone' "$scratch/told"; then
  echo "an empty OBJ: exit status $status"
  cat "$scratch/told"
  exit 1
fi
