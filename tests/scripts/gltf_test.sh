#!/usr/bin/env bash
# Scenes as glTF: the validator of Khronos finds no error and no warning, and a fault that is planted is found. Blender's importer
# reads them: metres, glass that is no metal, names.
#   gltf_test.sh BUILD   the build folder, in which the validator is installed
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
root=$(cd -- "$here/../.." && pwd)
build=$(cd -- "$1" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

validator=$build/validators/node_modules/gltf-validator
if [[ ! -d $validator ]]; then
  npm install --silent --no-audit --no-fund --prefix "$build/validators" gltf-validator@2.0.0-dev.3.10 >"$scratch/npm" 2>&1 ||
    { cat "$scratch/npm"; exit 1; }
fi

cat >"$scratch/herringbone.toml" <<'TOML'
[[pavement]]
name = "plaza"
size_mm = [3000, 2000]
stone_mm = [200, 100]
bond = "herringbone"
border_course = "soldier"
wetness = 0.9
[pavement.surface]
finish = "bush_hammered"
[pavement.ground]
fall_percent = 2
settlement_mm = 10
kerb_width_mm = 120
kerb_height_mm = 60
TOML
cat >"$scratch/tempered.toml" <<'TOML'
[[pane]]
name = "door"
size_mm = [200, 300]
thickness_mm = 6
glass = "tempered"
impact = [{at_mm = [90, 120]}]
[pane.shards]
TOML
scenes=("$scratch/herringbone.toml" "$scratch/tempered.toml")
for name in shattered_window broken_window stone_path terrace_steps kinds_of_glass courtyard; do
  scenes+=("$root/scenes/$name.toml")
done
for scene in "${scenes[@]}"; do "$build/shatterpave" export "$scene" -o "$scratch/out" --target gltf >/dev/null; done
node "$here/gltf_check.js" "$validator" "$scratch"/out/*.glb

# The twin: a bound that is wrong by a little.
node "$here/gltf_check.js" --plant "$validator" "$scratch/out/tempered.glb" "$scratch/planted.glb"
if node "$here/gltf_check.js" "$validator" "$scratch/planted.glb" >/dev/null; then echo "a planted fault passes"; exit 1; fi

in_blender() {
  blender -b --factory-startup -P "$here/blender_gltf.py" -- "$1" >"$scratch/log" 2>&1 && grep -q '^gltf: ok' "$scratch/log"
}
in_blender "$scratch/out/tempered.glb" || { grep '^gltf:' "$scratch/log" || tail -n 30 "$scratch/log"; exit 1; }
in_blender "$scratch/out/herringbone.glb" || { grep '^gltf:' "$scratch/log" || tail -n 30 "$scratch/log"; exit 1; }
# The twin: glass of metal.
node "$here/gltf_check.js" --metal "$validator" "$scratch/out/tempered.glb" "$scratch/metal.glb"
if in_blender "$scratch/metal.glb"; then echo "glass of metal passes"; exit 1; fi
