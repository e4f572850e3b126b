#!/usr/bin/env bash
# Scenes as glTF: the validator of Khronos finds no error and no warning, and a fault that is planted is found. three.js in a
# headless Chromium and Blender's importer read them: metres, glass that is no metal, textures, names.
#   gltf_test.sh BUILD   the build folder, in which validator and three.js are installed
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"

modules=$(node_tools validators gltf-validator@2.0.0-dev.3.10 three@0.161.0)
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
size_mm = [140, 210]
thickness_mm = 6
glass = "tempered"
impact = [{at_mm = [63, 84]}]
[pane.shards]
TOML
cat >"$scratch/skin.toml" <<'TOML'
[[pavement]]
name = "skin"
size_mm = [120, 90]
stone_mm = [8, 8]
joint_mm = 0.2
cell = {form = "scale"}
[[pavement]]
name = "beach"
size_mm = [900, 700]
stone_mm = [70, 52]
cell = {form = "cobble"}
[pavement.size]
near = 0.5
far = 1.6
distance_mm = 300
TOML
scenes=("$scratch/skin.toml" "$scratch/herringbone.toml" "$scratch/bricks.toml" "$scratch/tempered.toml")
for name in shattered_window broken_window stone_path terrace_steps kinds_of_glass courtyard; do
  scenes+=("$root/scenes/$name.toml")
done
for scene in "${scenes[@]}"; do "$build/shatterpave" export "$scene" -o "$scratch/out" --target gltf >/dev/null; done
node "$here/gltf_check.js" "$validator" "$scratch"/out/*.glb

# Twins with faults: a bound that is wrong by a little; metal; a mesh turned inside out; a texture that is larger on one of them;
# millimetres for metres.
plant() { node "$here/gltf_check.js" "--$1" "$scratch/out/$2.glb" "$scratch/$2-$1.glb"; }
plant plant tempered
if node "$here/gltf_check.js" "$validator" "$scratch/tempered-plant.glb" >/dev/null; then fail "a planted fault passes"; fi
jobs=("$scratch/out/bricks.glb:2:1:stone" "$scratch/out/tempered.glb:0.14:0.21:shard")
for fault in metal wound uv unit; do
  plant "$fault" bricks
  jobs+=("!$scratch/bricks-$fault.glb:2:1:stone")
done
for fault in metal wound unit; do
  plant "$fault" tempered
  jobs+=("!$scratch/tempered-$fault.glb:0.14:0.21:shard")
done
node "$here/three_check.js" "$modules" "${jobs[@]}"

is_glass() { in_blender gltf blender_gltf.py "$1"; }
for name in tempered herringbone; do
  is_glass "$scratch/out/$name.glb" || fail "$name: $(grep '^gltf:' "$scratch/log")"
done
if is_glass "$scratch/bricks-metal.glb"; then fail "stones of metal pass"; fi
