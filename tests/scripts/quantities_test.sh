#!/usr/bin/env bash
# Quantities: the tables of the target csv, counted again from the JSON in another language; faults that are planted are found.
#   quantities_test.sh BUILD   the build folder
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"

cat >"$scratch/yard.toml" <<'TOML'
seed = 5
[[pavement]]
name = "terrace"
outline_mm = [[0, 0], [4100, 0], [4300, 2600], [1500, 3300], [0, 2500]]
holes_mm = [[[1000, 900], [1400, 900], [1400, 1350], [1000, 1350]]]
stone_mm = [200, 100]
joint_mm = 6
bond = "running"
border_course = "stretcher"
direction = {kind = "constant", angle_deg = 17}
[pavement.ground]
kerb_width_mm = 120
[[pavement]]
name = "stairs"
outline_mm = [[6000, 0], [8000, 0], [8000, 1400], [6000, 1400]]
stone_mm = [400, 350]
[pavement.steps]
riser_mm = 150
tread_mm = 350
[[pane]]
name = "window"
size_mm = [300, 300]
impact = [{at_mm = [140, 160], radial_count = 40}]
TOML
exported() { "$build/shatterpave" export "$1" -o "$scratch/out" --target csv --target json >/dev/null; }
check() { /usr/bin/python3 "$here/quantities_check.py" "$scratch/out" "$@"; }
exported "$scratch/yard.toml"
check yard terrace:field:200:100 terrace:border:200:100
for part in field border kerb step; do
  grep -q "\"part\":\"$part\"" "$scratch/out/yard.json" || fail "JSON has no stone of the part $part"
done
for name in stone_path courtyard terrace_steps kinds_of_glass; do
  exported "$root/scenes/$name.toml"
  check "$name"
done

# The sheet: on paper of one scale each stone lies where the JSON has it.
cat >>"$scratch/yard.toml" <<'TOML'
[[pavement]]
name = "corner"
size_mm = [900, 700]
place_mm = [-1500, 400, 0]
place_turn_deg = 30
TOML
sheet() { "$build/shatterpave" export "$scratch/yard.toml" -o "$scratch/sheet" --target svg --target json --scale "$1" >/dev/null; }
sheet 1:50
check_sheet() { /usr/bin/python3 "$here/quantities_check.py" --sheet "$scratch/sheet" yard "$1"; }
check_sheet 50
if check_sheet 49.9 >/dev/null 2>&1; then fail "a sheet of another scale passes"; fi
rsvg-convert --width 1200 "$scratch/sheet/yard-sheet.svg" --output "$scratch/sheet.png"
refused() {
  refuses '--scale: expected' shatterpave export "$@" -o "$scratch/none"
  [[ ! -e $scratch/none ]] || fail "refused, but there is $(find "$scratch/none")"
}
refused "$scratch/yard.toml" --target svg --scale 1:2
refused "$scratch/yard.toml" --target svg --scale 50
refused "$scratch/yard.toml" --target svg --scale 1:0
refused "$scratch/yard.toml" --target json --scale 1:50
refused "$root/scenes/shattered_window.toml" --target svg --scale 1:50

# The twins: a stone more than there is, another area, one part named as another, two whole stones of one stock stone.
cp "$scratch"/out/yard-*.csv "$scratch"
faulty() {
  cp "$scratch"/yard-*.csv "$scratch/out"
  sed -i "$2" "$scratch/out/yard-$1.csv"
  if cmp -s "$scratch/out/yard-$1.csv" "$scratch/yard-$1.csv"; then fail "nothing was planted: $2"; fi
  if check yard terrace:field:200:100 >/dev/null 2>&1; then fail "a planted fault passes: $2"; fi
}
faulty quantities 's/^terrace,field_whole,\([0-9]*\)/terrace,field_whole,1\1/'
faulty quantities 's/^\(terrace,joints,,\)[^,]*/\10.5/'
faulty stones '0,/,border,/s//,field,/'
faulty stones '/^terrace,.*,field,whole,/s/[0-9]*$/0/'
faulty cracks '3s/,[^,]*$/,0.5/'
