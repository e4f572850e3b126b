#!/usr/bin/env bash
# Draws docs/pictures/knobs_glass.svg and knobs_paving.svg: what keys do, each at three values.
#   docs/knobs.sh glass|paving [--seed N] [--command SHATTERPAVE] [FILE.svg]
# Exports small scenes as SVG by the command, which it builds unless one is given, and sets them on one page.
set -euo pipefail
# shellcheck source=sheet.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/sheet.sh"

# What is turned | the lines of the scene after those of all, with @ for the value; `;` parts lines | three values.
knobs_glass='radial_count|@|15 40 120
large_count|radial_count = 60; large_count = @|3 12 40
circular_count|radial_count = 40; circular_count = @|0 4 16
growth.wander_deg|radial_count = 30; [pane.growth]; wander_deg = @|4 14 28
growth.branch_rate_per_m|radial_count = 20; large_count = 12; [pane.growth]; branch_rate_per_m = @|0 8 25
growth.radial_onset|radial_count = 60; [pane.growth]; radial_onset = @|0 4 12
growth.edge_gain_px2|radial_count = 24; large_count = 24; [pane.growth]; edge_gain_px2 = @|0 500 8000
growth.ring_pull|radial_count = 30; circular_count = 8; [pane.growth]; ring_pull = @|0.1 0.6 3
rings.count|REAL; [pane.rings]; ratio = 1.4; count = @|2 5 12
rings.ratio|REAL; [pane.rings]; ratio = @|1.3 2 3.5
rings.interruption|REAL; [pane.rings]; interruption = @|0 0.25 0.7
rings.bow|REAL; [pane.rings]; bow = @|0 0.3 1
laminate.far_cracks|REAL; [pane.laminate]; far_cracks = @|0 0.3 1
tempering.count_per_square|TEMPERED; count_per_square = @|6 20 60
tempering.splinter_ratio|TEMPERED; count_per_square = 20; splinter_ratio = @|1 4 15
time_us|TIME; radial_count = 40; circular_count = 6|20 60 110'
knobs_paving='stone_mm|stone_mm = @|[100,100] [200,100] [300,60]
joint_mm|joint_mm = @|2 8 25
bond_offset|bond = "running"; stone_mm = [200, 100]; bond_offset = @|0.1 0.33 0.5
bond_turn_deg|bond = "herringbone"; stone_mm = [200, 100]; bond_turn_deg = @|0 20 45
bond_span_mm|bond = "segmental_arc"; bond_span_mm = @|700 1000 1600
border_course|bond = "running"; stone_mm = [200, 100]; border_course = "@"|none stretcher soldier
laid_by_hand|bond = "running"; laid_by_hand = @|0 0.4 1
hand.nibbled|bond = "running"; laid_by_hand = 0.3; hand = {nibbled = @}|0 0.3 1
hand.rounded|bond = "running"; laid_by_hand = 0.3; hand = {rounded = @}|0 0.1 0.3
direction.kind|bond = "packed"; DIRECTION|constant boundary radial
size.near|bond = "packed"; size = {near = @, far = 1, distance_mm = 600}|0.5 1 1.6
variation.size|bond = "packed"; variation = {size = @}|0 0.1 0.3'

what=${1:-}
case $what in
  glass | paving) shift ;;
  *) say "knobs.sh: expected glass or paving"; exit 2 ;;
esac
start_sheet "knobs_$what.svg" "$@"
knobs=$knobs_glass
[[ $what == glass ]] || knobs=$knobs_paving

# lines_of LINES VALUE: the lines of the scene; words in capitals stand for what several have in common.
lines_of() {
  local lines=$1 value=$2
  lines=${lines//REAL/radial_count = 30; GLASS pattern = \"real\"}
  lines=${lines//TEMPERED/GLASS glass = \"tempered\"; [pane.tempering]}
  lines=${lines//TIME/GLASS time_us = $value}
  case $value in
    constant) lines=${lines//DIRECTION/direction = {kind = \"constant\", angle_deg = 30\}} ;;
    boundary) lines=${lines//DIRECTION/direction = {kind = \"boundary\"\}} ;;
    radial) lines=${lines//DIRECTION/direction = {kind = \"radial\", centre_mm = [400, -300]\}} ;;
  esac
  printf '%s\n' "${lines//@/$value}" | sed 's/; /\n/g'
}

scene_of() {
  local name=$1 key=$2 lines=$3 value=$4 pane='' impact='' tables=''
  if [[ $what == paving ]]; then
    printf '[[pavement]]\nname = "%s"\nsize_mm = [1600, 1200]\n' "$name"
    [[ $key == stone_mm ]] || [[ $lines == *stone_mm* ]] || printf 'stone_mm = [100, 100]\n'
    lines_of "$lines" "$value"
    return
  fi
  [[ $lines != @ ]] || lines="$key = @"
  # Lines of the pane, of its impact, and of its tables, in their order.
  local line into=impact
  while read -r line; do
    [[ $line != \[* ]] || into=tables
    if [[ $line == GLASS\ * ]]; then
      pane+="${line#GLASS }"$'\n'
    elif [[ $into == impact ]]; then
      impact+="$line"$'\n'
    else
      tables+="$line"$'\n'
    fi
  done < <(lines_of "$lines" "$value")
  [[ $key != laminate.* ]] || pane=${pane/pattern = \"real\"/glass = \"laminated\"}
  printf '[[pane]]\nname = "%s"\nsize_mm = [300, 300]\nthickness_mm = 4\n%s[[pane.impact]]\nat_mm = [140, 160]\n%s%s' \
    "$name" "$pane" "$impact" "$tables"
}

# All exported before the page is drawn: what is wrong stops this.
number=0
while IFS='|' read -r key lines values; do
  for value in $values; do
    scene_of knob "$key" "$lines" "$value" >"$scratch/k$number.toml"
    "$command" export "$scratch/k$number.toml" -o "$scratch" --seed "$seed" --target svg >/dev/null
    ((++number))
  done
done <<<"$knobs"

# Two knobs a row, three values each. A pane takes 3,000 tenths of a millimetre, a pavement 1,600 mm.
page() {
  local count width=3000 step=3300 row_step=3700 height rows
  [[ $what == glass ]] || row_step=2950
  count=$(wc -l <<<"$knobs")
  ((rows = (count + 1) / 2)) || true
  ((height = rows * row_step + 150)) || true
  cat <<HEAD
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 20700 $height">
<title>What keys of ${what} do, each at three values</title>
<style>
rect{fill:#fff;stroke:#000;stroke-width:6}
path{fill:none;stroke:#222;stroke-width:7;stroke-linejoin:round;stroke-linecap:round}
.large{stroke:#000;stroke-width:12}
.circular,.rung{stroke:#b03a2e}
.far{opacity:0.45}
.outline{fill:#4a463f;stroke:none}
.whole,.cut{fill:#c9c3b4;stroke:none}
text{font:120px sans-serif;text-anchor:middle}
.key{font-weight:bold;text-anchor:start}
</style>
<rect x="-9" y="-9" width="20718" height="$((height + 18))" style="stroke:none"/>
HEAD
  local place=0 picture=0 row key values value x y
  while IFS='|' read -r key _ values; do
    ((row = place / 2, x = 300 + place % 2 * 10350, y = 330 + row * row_step)) || true
    printf '<text class="key" x="%d" y="%d">%s</text>\n' "$x" "$((y - 60))" "$key"
    for value in $values; do
      printf '<g transform="translate(%d %d)">\n' "$x" "$y"
      if [[ $what == glass ]]; then
        printf '<rect width="%d" height="%d"/>\n<g transform="translate(0 %d)">\n' "$width" "$width" "$width"
        crack_paths "$scratch/k$picture-knob.svg"
        printf '</g>\n'
      else
        printf '<g transform="scale(1.875) translate(0 1200)">\n'
        stone_paths "$scratch/k$picture-knob.svg"
        printf '</g>\n'
      fi
      printf '</g>\n<text x="%d" y="%d">%s</text>\n' "$((x + width / 2))" "$((y + (${#what} == 5 ? 3150 : 2400)))" "$value"
      ((x += step, ++picture)) || true
    done
    ((++place))
  done <<<"$knobs"
  printf '</svg>\n'
}

end_sheet page
