#!/usr/bin/env bash
# `trace`, `measure` of lines, `cracks_file` and `fit`: a pane of our own is photographed by POV-Ray, traced, and found again; what
# holds no cracks is refused, and nothing is left.
set -euo pipefail
build=$1
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
tests=$(cd -- "$here/../trace" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
failures=0
fail() {
  echo "$1"
  failures=$((failures + 1))
}
run() { "$build/shatterpave" "$@"; }

# What is refused.
for kind in blank noise bricks pixel huge broken; do
  /usr/bin/python3 "$tests/pictures.py" $kind $kind.png
  status=0
  run trace $kind.png -o refused >told 2>message || status=$?
  # libpng tells of a broken file by itself.
  [[ $status == 2 && ! -s told && $(grep -v '^libpng' message) == $kind.png:* && $(grep -vc '^libpng' message) == 1 ]] ||
    fail "trace $kind.png: exit status $status, expected 2 and one line; got $(<message)"
  [[ -z $(find refused -type f 2>/dev/null) ]] || fail "trace $kind.png left files"
done
grep -q megapixels <(run trace huge.png -o refused 2>&1 || true) || fail "a picture of 100 megapixels is refused as something else"
grep -q "one place" <(run trace bricks.png -o refused 2>&1 || true) || fail "a brick wall is refused as something else"

# A pane that is known.
cat >scene.toml <<'EOF'
seed = 5
[[pane]]
name = "window"
size_mm = [300, 300]
[[pane.impact]]
at_mm = [140, 160]
radial_count = 40
EOF
run export scene.toml -o . --target povray --target json >/dev/null
povray +I"$tests/photograph.pov" +L. +W640 +H640 +A0.3 +R2 +FP +Ophoto.ppm -D Declare=Ground=1 >povray.log 2>&1 ||
  { tail -5 povray.log; exit 1; }
run trace photo.ppm -o traced --pane-mm 300,300 >told
[[ $(<told) == "$(printf 'traced/photo.json\ntraced/photo-traced.png\ntraced/photo.csv\ntraced/photo-trace.html')" ]] || fail "trace told $(<told)"
judged=$(/usr/bin/python3 "$tests/judge_trace.py" scene.json traced/photo.json 640 640 photo.ppm)
# M N found M, low, high, N | impact | ring | found | false
awk '{ exit !($7 == "|" && $8 <= 3 && $6 >= $2 - 1 && $6 <= $2 + 1 && $4 <= $1 && $1 <= $5 && $12 >= 80 && $14 <= 12) }' <<<"$judged" ||
  fail "traced: $judged"
run trace photo.ppm -o again --pane-mm 300,300 --threads 1 >/dev/null
cmp -s traced/photo.json again/photo.json || fail "another number of threads gives another file"

# Photographs that were cut off are refused, though their readers make up the rest; what is drawn out, or beyond the picture, is told.
povray +I"$tests/photograph.pov" +L. +W320 +H320 +FJ +Owhole.jpg -D Declare=Ground=1 >povray.log 2>&1 || { tail -5 povray.log; exit 1; }
run trace whole.jpg -o whole --pane-mm 300,300 >/dev/null 2>message || fail "whole.jpg: $(<message)"
[[ ! -s message ]] || fail "whole.jpg: $(<message)"
head -c "$(($(stat -c %s whole.jpg) / 2))" whole.jpg >cut.jpg
status=0
run trace cut.jpg -o cut --pane-mm 300,300 >/dev/null 2>message || status=$?
[[ $status == 2 && $(<message) == "cut.jpg: expected a photograph that can be read to its end, got JPEG error: Premature end"* ]] ||
  fail "cut.jpg: $status $(<message)"
run trace whole.jpg -o drawn_out --pane-mm 400,300 >/dev/null 2>message || fail "drawn out: $(<message)"
grep -q '^note: whole.jpg: 320 x 320 px are taken for a pane of 400 x 300 mm, drawn out by 1.33 to 1' message || fail "drawn out: $(<message)"
run trace whole.jpg -o beyond --pane-mm 300,300 --corners 0,0 330,0 320,320 0,320 >/dev/null 2>message || fail "beyond: $(<message)"
grep -q '^note: whole.jpg: the corner 330,0 lies outside of the picture of 320 x 320 px' message || fail "beyond: $(<message)"

# Lines as our own: the same pane by its geometry and by its drawing.
run measure scene.json -o of_json >/dev/null
run export scene.toml -o . --target svg >/dev/null
run measure scene-window.svg -o of_svg >/dev/null
for quantity in reaching_count ring_count; do
  one=$(grep ",$quantity," of_json/scene-figures.csv | cut -d, -f3)
  two=$(grep ",$quantity," of_svg/scene-window-figures.csv | cut -d, -f3)
  [[ -n $one && $one == "$two" ]] || fail "$quantity: $one by its geometry, $two by its drawing"
done
# Seeds do not make more panes of one.
run measure scene.json -o of_seeds --seeds 5 --radials 24..90 >/dev/null 2>message || fail "seeds beside lines: $(<message)"
[[ $(<message) == "note: scene.json: --seeds and --radials have no effect on lines from a file" ]] || fail "seeds beside lines: $(<message)"
cmp -s of_json/scene-measures.csv of_seeds/scene-measures.csv || fail "seeds beside lines change what is measured"
[[ $(wc -l <of_json/paper-table1.csv) == 20 ]] || fail "paper-table1.csv has not nineteen panes"

# Cracks of a file, by targets.
printf 'seed = 1\n[[pane]]\nname = "window"\ncracks_file = "traced/photo.json"\n[pane.shards]\n' >from_photo.toml
for target in json svg obj ply; do
  run export from_photo.toml -o exported --target $target >/dev/null || fail "a traced pane is not exported as $target"
done
printf '{"format": "shatterpave-geometry", "version": 1, "panes": [{"outline_mm": [[0, 0], [9, 0], [9, 9]], "cracks": 7}]}' >wrong.json
status=0
run measure wrong.json -o wrong >/dev/null 2>message || status=$?
[[ $status == 2 && $(<message) == "wrong.json: panes[0].cracks: expected a list"* ]] || fail "wrong.json: $status $(<message)"

# A scene of it.
run fit traced/photo.json -o fitted.toml >told
[[ $(<told) == fitted.toml ]] || fail "fit told $(<told)"
run check fitted.toml >/dev/null || fail "the fitted scene is refused"

if ((failures > 0)); then exit 1; fi
