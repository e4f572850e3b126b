#!/usr/bin/env bash
# A module through the command: scenes/versailles.toml is checked, laid, counted and written by targets of every kind, and what is
# no drawing of stones is refused at its place.
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"
cp "$root/scenes/versailles.toml" "$root/scenes/versailles.svg" "$scratch"
cd "$scratch"

ends 0 shatterpave check versailles.toml
[[ ! -s message ]] || fail "a note about versailles.toml: $(<message)"
for target in json svg csv gltf; do
  quietly "--target $target" shatterpave export versailles.toml -o out --target "$target"
done
python3 - <<'PYTHON'
import collections
import csv
import json

with open("out/versailles.json", encoding="utf-8") as file:
    (pavement,) = json.load(file)["pavements"]

def size(stone):
    xs, ys = zip(*stone["outline_mm"])
    return tuple(sorted(round(max(v) - min(v)) for v in (xs, ys)))

# The drawing's sizes less the joint; each as often as it is drawn, on an area that is not much larger than a few repeats.
whole = collections.Counter(size(s) for s in pavement["stones"] if s["kind"] == "whole" and s["part"] == "field")
drawn = {(392, 592): 1, (392, 392): 2, (192, 392): 1, (192, 192): 2}
assert set(whole) == set(drawn), whole
for one, share in drawn.items():
    assert abs(whole[one] / sum(whole.values()) - share / 6) < 0.08, whole
# bond_start_mm is the lower left corner of the largest stone, with half a joint about it.
corners = {tuple(p) for s in pavement["stones"] for p in s["outline_mm"] if size(s) == (392, 592)}
assert any(abs(x - 812) < 0.002 and abs(y - 812) < 0.002 for x, y in corners), "no stone begins at bond_start_mm"
with open("out/versailles-stones.csv", encoding="utf-8") as file:
    assert sum(1 for _ in csv.reader(file)) == 1 + len(pavement["stones"])
PYTHON

# The pattern repeats, also in a texture.
sed -e '/border/d' -e 's/^size_mm/textures = {seamless = true, tile_mm = [3600, 3600], size_px = 256}\n&/' versailles.toml >tile.toml
quietly "--target textures" shatterpave export tile.toml -o out --target textures
[[ -s out/terrace_BaseColor.png ]] || fail "no texture: $(ls out)"

refuses 'module_mm: expected two vectors' \
  shatterpave check versailles.toml --set 'pavement[0].module_mm=[[1200, 0], [600, 0]]'
refuses 'versailles.svg:[0-9]*:2: rect: expected shapes that do not overlap, got one that lies over' \
  shatterpave check versailles.toml --set 'pavement[0].module_mm=[[1190, 0], [200, 600]]'
refuses 'module_file: expected shapes that touch.*got a bare place' \
  shatterpave check versailles.toml --set 'pavement[0].module_class=square'
