#!/usr/bin/env bash
# Scenes as OpenUSD: by all rules of its own checkers nothing is wrong; prims, places, materials, camera and lights are those of the JSON;
# faults that are planted are found.
#   usd_test.sh BUILD [SCENE.toml …]   the build folder, in which the readers are installed; the scenes, else some small ones
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"
shift

# The last version of usd-core with both checkers. It knows no MaterialX: the definition of the shader is made from MaterialX's own.
python=$(python_tools usd usd-core==26.3 materialx==1.38.10 numpy==2.2.6)
mkdir "$scratch/definitions"
export PXR_SDR_FS_PLUGIN_SEARCH_PATHS=$scratch/definitions PXR_SDR_FS_PLUGIN_ALLOWED_EXTS=usda TF_ENV_SETTING_ALERTS_ENABLED=0
"$python" "$here/usd_check.py" --define "$scratch/definitions"

exported() { "$build/shatterpave" export "$1" -o "$scratch/out" --target usd --target json >/dev/null; }
check() {
  local name
  name=$(basename "$1" .toml)
  exported "$1" && "$python" "$here/usd_check.py" "$scratch/out/$name.usda" "$scratch/out/$name.json"
}

if (($# > 0)); then
  for scene in "$@"; do check "$scene"; done
  exit
fi

cat >"$scratch/some glass.toml" <<'TOML'
seed = 4
[[pane]]
name = "sheets"
size_mm = [160, 160]
thickness_mm = 3
pattern = "real"
crack_body = "sheet"
impact = [{at_mm = [70, 90], radial_count = 18}, {at_mm = [120, 40], radial_count = 9, hole_mm = 9}]
[[pane]]
name = "tubes"
size_mm = [160, 160]
impact = [{at_mm = [70, 90], radial_count = 30}]
[[pane]]
name = "in-shards"
outline_mm = [[0, 0], [200, 0], [220, 180], [-20, 160]]
thickness_mm = 4
impact = [{at_mm = [90, 90], radial_count = 24}]
[pane.shards]
fallen = 0.5
[[pane]]
name = "laminated"
size_mm = [160, 160]
thickness_mm = 6
glass = "laminated"
impact = [{at_mm = [90, 90]}]
[[pane]]
name = "tempered"
size_mm = [50, 50]
thickness_mm = 6
glass = "tempered"
impact = [{at_mm = [30, 20]}]
[pane.shards]
TOML
cat >"$scratch/stone.toml" <<'TOML'
[[pavement]]
name = "plaza"
size_mm = [1500, 1000]
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
[[pavement]]
name = "bricks"
outline_mm = [[3000, 0], [5000, 0], [5000, 1000], [3000, 1000]]
stone_mm = [200, 100]
bond = "running"
material = "brick"
[[pavement]]
name = "setts"
outline_mm = [[6000, 0], [7000, 0], [7000, 1000], [6000, 1000]]
[pavement.direction]
kind = "radial"
centre_mm = [6500, -2000]
[pavement.textures]
swatch_px = 64
[[pavement]]
name = "flight"
outline_mm = [[0, 3000], [1000, 3000], [1000, 4000], [0, 4000]]
stone_mm = [500, 330]
[pavement.steps]
riser_mm = 150
tread_mm = 330
TOML
# With a place for everything.
cat >"$scratch/lit.toml" <<'TOML'
seed = 4
[camera]
at_mm = [300, -1500, 700]
look_at_mm = [100, 0, 60]
field_of_view_deg = 35
focus_mm = 1400
f_number = 4
size_px = [320, 180]
[light]
sun_azimuth_deg = 220
sun_elevation_deg = 20
sun_gain = 0.5
environment_gain = 0.75
environment_turn_deg = 30
exposure_ev = -1
[[pane]]
name = "window"
size_mm = [100, 100]
place_mm = [50, 300, 20]
place_turn_deg = 25
impact = [{at_mm = [40, 50], radial_count = 6}]
[pane.shards]
[[pavement]]
name = "court"
outline_mm = [[0, 0], [1000, 0], [1000, 700], [0, 700]]
stone_mm = [200, 100]
bond = "running"
place_mm = [-200, 100, -5]
place_turn_deg = -10
textures.swatch_px = 64
TOML
check "$scratch/some glass.toml"
check "$scratch/stone.toml"
check "$scratch/lit.toml"

# Its twins, each with a fault.
cat >"$scratch/bricks.toml" <<'TOML'
[[pavement]]
name = "bricks"
size_mm = [500, 300]
stone_mm = [200, 100]
bond = "running"
wetness = 0.9
textures.swatch_px = 64
TOML
exported "$scratch/bricks.toml"
for name in lit bricks; do
  "$python" "$here/usd_check.py" --plant "$scratch/out/$name.usda" "$scratch/out/$name.json"
done

# Pieces that fall and a camera that moves are, at every frame, where the scene at that frame has them; in glTF as well.
cat >"$scratch/falling.toml" <<'TOML'
seed = 4
[[pane]]
name = "window"
size_mm = [300, 260]
thickness_mm = 3
preset = "stone-through-window"
place_mm = [100, 200, 50]
place_turn_deg = 30
impact = [{at_mm = [150, 150], mean_radial_count = 24}]
[pane.shards]
missing = 0.5
[camera]
at_mm = [200, -900, 300]
look_at_mm = [200, 200, 150]
field_of_view_deg = 40
focus_mm = 1000
f_number = 2.8
[still]
setting = "own"
[frames]
range = "3-14"
per_second = 12
[[frames.key]]
set = "pane[0].shards.time_s"
at = [[3, 0], [14, 1.5]]
[[frames.key]]
set = "camera.at_mm"
at = [[3, [200, -900, 300]], [14, [700, -600, 450]]]
[[frames.key]]
set = "camera.field_of_view_deg"
at = [[3, 40], [14, 25]]
[[frames.key]]
set = "camera.focus_mm"
at = [[3, 1000], [14, 800]]
TOML
exported "$scratch/falling.toml"
"$build/shatterpave" export "$scratch/falling.toml" -o "$scratch/motion" --target gltf >/dev/null
"$build/shatterpave" export "$scratch/falling.toml" -o "$scratch/frames" --target json --frames 3-14 >/dev/null
"$python" "$here/motion_check.py" "$scratch/motion/falling.glb" "$scratch/out/falling.usda" "$scratch/frames" 100,200,50,30
check "$scratch/falling.toml"
