#!/usr/bin/env bash
# Scenes for Mitsuba 3: it renders them without a warning, shows what POV-Ray shows where POV-Ray shows it, and glass lets through what
# Fresnel's equations say in both; faults that are planted are found.
#   mitsuba_test.sh BUILD [SCENE.toml …]   the build folder, in which Mitsuba is installed; scenes that are rendered, else some small ones
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"
shift
python=$(python_tools mitsuba mitsuba==3.9.0 numpy==2.2.6)
out=$scratch/out

exported() { "$build/shatterpave" export "$1" -o "$out" --target mitsuba --target povray --target json >/dev/null; }
# As its users do. What it prints is shown where it fails or warns.
rendered() {
  if ! "${python%/*}/mitsuba" -m scalar_rgb -Dspp=8 -Dwidth=160 -Dheight=120 -o "$2" "$1" >"$scratch/log" 2>&1 || grep -q WARN "$scratch/log"; then
    fail "$1 is not rendered without a warning"
  fi
}
check() { "$python" "$here/mitsuba_check.py" "$@"; }
refused() {
  if check "$@" >"$scratch/log" 2>&1; then fail "a planted fault passes: $*"; fi
  grep -q '^mitsuba: expected' "$scratch/log" || fail "found for another reason: $*"
}
pictures=()
look_at() {
  local name
  name=$(basename "$1" .toml)
  exported "$1"
  rendered "$out/$name.xml" "$scratch/$name.exr"
  pictures+=("$scratch/$name.exr")
}

if (($# > 0)); then
  for scene in "$@"; do look_at "$scene"; done
  check picture "${pictures[@]}"
  exit
fi

camera() { printf '[camera]\nat_mm = %s\nlook_at_mm = %s\nfield_of_view_deg = %s\nsize_px = [%s]\n' "$@"; }
{
  echo 'seed = 4'
  camera '[120, -520, 190]' '[150, 0, 120]' 36 '400, 300'
  cat <<'TOML'
[[pane]]
name = "sheets"
size_mm = [300, 240]
thickness_mm = 6
pattern = "real"
crack_body = "sheet"
impact = [{at_mm = [140, 130], radial_count = 16}]
TOML
} >"$scratch/sheets.toml"
{
  echo 'seed = 7'
  camera '[60, -700, 260]' '[180, -40, 110]' 44 '300, 225'
  cat <<'TOML'
[[pane]]
name = "window"
size_mm = [360, 270]
thickness_mm = 4
impact = [{at_mm = [170, 150], radial_count = 40}]
[pane.shards]
missing_mm = 40
TOML
} >"$scratch/shards.toml"
{
  camera '[1500, -400, 1500]' '[1450, 700, 0]' 45 '240, 180'
  cat <<'TOML'
[[pavement]]
name = "plaza"
size_mm = [3000, 2000]
stone_mm = [200, 100]
bond = "herringbone"
border_course = "soldier"
[pavement.detail]
viewer_mm = [1500, 0]
close_mm = 4000
mesh_mm = 6
TOML
} >"$scratch/plaza.toml"
{
  camera '[150, -60, 300]' '[160, 120, 0]' 50 '240, 180'
  cat <<'TOML'
[[pavement]]
name = "bricks"
size_mm = [600, 600]
stone_mm = [30, 15]
joint_mm = 2
bond = "running"
material = "brick"
TOML
} >"$scratch/bricks.toml"
{
  camera '[600, -300, 900]' '[650, 500, 0]' 45 '240, 180'
  cat <<'TOML'
[[pavement]]
name = "setts"
size_mm = [1400, 1300]
wetness = 0.9
[pavement.direction]
kind = "radial"
centre_mm = [700, -2000]
TOML
} >"$scratch/setts.toml"
cat >"$scratch/other glass & more.toml" <<'TOML'
[[pane]]
name = "laminated"
size_mm = [200, 200]
thickness_mm = 6
glass = "laminated"
impact = [{at_mm = [90, 90]}]
[[pane]]
name = "tempered"
size_mm = [80, 80]
thickness_mm = 6
glass = "tempered"
crack_body = "sheet"
impact = [{at_mm = [30, 20]}]
place_mm = [220, 0, 0]
place_turn_deg = 20
[[pane]]
name = "tubes"
size_mm = [120, 120]
impact = [{at_mm = [70, 50], radial_count = 30}]
place_mm = [220, 0, 90]
[light]
exposure_ev = 0.5
[camera]
at_mm = [150, -700, 200]
look_at_mm = [150, 0, 110]
focus_mm = 700
f_number = 2.8
TOML
# One crack in a corner.
cat >"$scratch/bare.toml" <<'TOML'
[[pane]]
name = "bare"
size_mm = [400, 400]
thickness_mm = 4
crack_body = "sheet"
impact = [{at_mm = [20, 20], radial_count = 1, large_count = 0, circular_count = 0}]
TOML

for name in sheets shards plaza bricks setts "other glass & more"; do look_at "$scratch/$name.toml"; done
check picture "${pictures[@]}"
for name in sheets shards plaza; do check masks "$scratch/$name.toml" "$out"; done
# Where no detail is asked for, faces of stones are divided in five, and in POV-Ray they are patches: joints are a little wider.
for name in bricks setts; do check masks "$scratch/$name.toml" "$out" 0.95; done
exported "$scratch/bare.toml"
check light "$out" bare bare 4 200 200

# The twins, each with a fault.
for fault in winding unit; do
  check plant "$fault" "$out" shards "$scratch/$fault"
  refused masks "$scratch/shards.toml" "$scratch/$fault"
done
for fault in winding ior; do
  check plant "$fault" "$out" bare "$scratch/bare-$fault"
  refused light "$scratch/bare-$fault" bare bare 4 200 200
done
