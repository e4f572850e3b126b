#!/usr/bin/env bash
# Builds the examples with the installed library, runs them, and holds what they print and write against what must come out.
#   examples_test.sh BUILD   the build folder
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"

quietly "installation failed" cmake --install "$build" --prefix "$scratch/installed"
quietly "examples are not configured" cmake -S "$root/examples" -B "$scratch/build" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_PREFIX_PATH="$scratch/installed" \
  -DCMAKE_CXX_FLAGS='-Wall -Wextra -Wpedantic -Werror'
quietly "examples are not built" cmake --build "$scratch/build"
cd "$scratch"

# A pane: thirty radial cracks about each impact, eight of them large; the drawing has a line for each crack.
build/pane out >pane.txt
python3 - pane.txt out/shop-window.svg <<'PYTHON' || fail "pane prints or writes something else"
import re, sys, xml.etree.ElementTree
lines = open(sys.argv[1]).read().splitlines()
head = re.fullmatch(r"window: 2 impacts, (\d+) cracks", lines[0])
counts = {m[1]: int(m[2]) for m in (re.fullmatch(r"  (\w+): (\d+)", line) for line in lines[1:-1])}
assert counts["large"] == 16 and counts["radial"] == 44, counts
assert sum(counts.values()) == int(head[1]), (counts, head[1])
assert lines[-1] == sys.argv[2], lines[-1]
xml.etree.ElementTree.parse(sys.argv[2])
PYTHON
# A folder in the way of a file is the input's fault: status 2, and the reason.
mkdir -p blocked/shop-window.svg
ends 2 build/pane blocked
grep -q 'shop-window.svg' "$scratch/message" || fail "a folder in the way: $(<"$scratch/message")"

# A court of 4 × 1.5 and 1.5 × 1.5 m without a pit of 0.5 × 0.5 m: 8 m². A whole stone has 0.2 × 0.1 m. Joints of 5 mm take some 7 %.
build/pavement >pavement.txt
python3 - pavement.txt <<'PYTHON' || fail "pavement prints something else: $(<pavement.txt)"
import re, sys
lines = open(sys.argv[1]).read().splitlines()
assert lines[0] == "yard: 8 m2", lines[0]
def of(line, kind):
    m = re.fullmatch(rf"  {kind}: (\d+) stones, ([0-9.]+) m2", line)
    return int(m[1]), float(m[2])
whole, cut = of(lines[1], "whole"), of(lines[2], "cut")
assert whole[0] > 250 and cut[0] > 20, (whole, cut)
assert abs(whole[1] - whole[0] * 0.02) < 1e-4 * whole[1], whole
assert 0 < cut[1] < cut[0] * 0.02 * 1.5, cut
assert 0.90 * 8 < whole[1] + cut[1] < 0.95 * 8, (whole, cut)
PYTHON

# An exporter: a closed polyline for each stone and ring that the command's JSON has, to the last digit.
cat >yard.toml <<'TOML'
seed = 5
[[pavement]]
name = "yard"
size_mm = [3000, 2000]
holes_mm = [[[500, 500], [900, 500], [900, 900]]]
stone_mm = [100, 100]
joint_mm = 8
[pavement.direction]
kind = "radial"
centre_mm = [1500, -500]
TOML
[[ $(build/own_exporter yard.toml out) == out/yard.dxf ]] || fail "own_exporter does not tell what it wrote"
"$scratch/installed/bin/shatterpave" export yard.toml -o out --target json >/dev/null
python3 - out/yard.dxf out/yard.json <<'PYTHON' || fail "own_exporter writes something else"
import json, sys
text = open(sys.argv[1]).read().split("\n")
pairs = [(int(a), b) for a, b in zip(text[0::2], text[1::2])]
polylines = []
for code, value in pairs:
    if (code, value) == (0, "POLYLINE"): polylines.append([None, []])
    elif code == 8 and polylines[-1][0] is None: polylines[-1][0] = value
    elif code == 10: polylines[-1][1].append([float(value)])
    elif code == 20: polylines[-1][1][-1].append(float(value))
assert pairs[-1] == (0, "EOF")
pavement = json.load(open(sys.argv[2]))["pavements"][0]
expected = [["yard-area", pavement["outline_mm"]]] + [["yard-area", hole] for hole in pavement["holes_mm"]]
expected += [["yard-" + stone["kind"], stone["outline_mm"]] for stone in pavement["stones"]]
assert polylines == expected, (len(polylines), len(expected))
assert {name for name, _ in polylines} == {"yard-area", "yard-whole", "yard-cut"}
PYTHON
# Another state of the scene: what the exporter made of the earlier one is replaced, and of a wrong one nothing is written.
before=$(sha256sum <out/yard.dxf)
sed -i 's/joint_mm = 8/joint_mm = 80000/' yard.toml
refuses '^yard.toml:7:12: pavement\[0\].joint_mm: expected' build/own_exporter yard.toml out
[[ $(sha256sum <out/yard.dxf) == "$before" ]] || fail "a wrong scene changed the file"
