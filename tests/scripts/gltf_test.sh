#!/usr/bin/env bash
# Scenes as glTF: the validator of Khronos finds no error and no warning, and a fault that is planted is found. three.js in a
# headless Chromium and Blender's importer read them: metres, glass that is no metal, textures, names.
#   gltf_test.sh BUILD   the build folder, in which validator and three.js are installed
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
root=$(cd -- "$here/../.." && pwd)
build=$(cd -- "$1" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

tools=(gltf-validator@2.0.0-dev.3.10 three@0.161.0)
modules=$build/validators/node_modules
if [[ ! -f $modules/installed || $(<"$modules/installed") != "${tools[*]}" ]]; then
  npm install --silent --no-audit --no-fund --prefix "$build/validators" "${tools[@]}" >"$scratch/npm" 2>&1 ||
    { cat "$scratch/npm"; exit 1; }
  echo "${tools[*]}" >"$modules/installed"
fi
validator=$modules/gltf-validator

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
cat >"$scratch/bricks.toml" <<'TOML'
[[pavement]]
name = "court"
size_mm = [2000, 1000]
stone_mm = [200, 100]
bond = "herringbone"
material = "brick"
[pavement.surface]
finish = "flat_sawn"
[pavement.textures]
swatch_px = 256
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
scenes=("$scratch/herringbone.toml" "$scratch/bricks.toml" "$scratch/tempered.toml")
for name in shattered_window broken_window stone_path terrace_steps kinds_of_glass courtyard; do
  scenes+=("$root/scenes/$name.toml")
done
for scene in "${scenes[@]}"; do "$build/shatterpave" export "$scene" -o "$scratch/out" --target gltf >/dev/null; done
node "$here/gltf_check.js" "$validator" "$scratch"/out/*.glb

# Twins with faults: a bound that is wrong by a little; metal; a mesh turned inside out; a texture that is larger on one of them;
# millimetres for metres.
plant() { node "$here/gltf_check.js" "--$1" "$scratch/out/$2.glb" "$scratch/$2-$1.glb"; }
plant plant tempered
if node "$here/gltf_check.js" "$validator" "$scratch/tempered-plant.glb" >/dev/null; then echo "a planted fault passes"; exit 1; fi
jobs=("$scratch/out/bricks.glb:2:1:stone" "$scratch/out/tempered.glb:0.2:0.3:shard")
for fault in metal wound uv unit; do
  plant "$fault" bricks
  jobs+=("!$scratch/bricks-$fault.glb:2:1:stone")
done
for fault in metal wound unit; do
  plant "$fault" tempered
  jobs+=("!$scratch/tempered-$fault.glb:0.2:0.3:shard")
done
node "$here/three_check.js" "$modules" "${jobs[@]}"

in_blender() {
  blender -b --factory-startup -P "$here/blender_gltf.py" -- "$1" >"$scratch/log" 2>&1 && grep -q '^gltf: ok' "$scratch/log"
}
in_blender "$scratch/out/tempered.glb" || { grep '^gltf:' "$scratch/log" || tail -n 30 "$scratch/log"; exit 1; }
in_blender "$scratch/out/herringbone.glb" || { grep '^gltf:' "$scratch/log" || tail -n 30 "$scratch/log"; exit 1; }
if in_blender "$scratch/tempered-metal.glb"; then echo "glass of metal passes"; exit 1; fi
