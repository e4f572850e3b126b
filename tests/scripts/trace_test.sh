#!/usr/bin/env bash
# `trace`, `measure` of lines, `cracks_file` and `fit`: a pane of our own is photographed by POV-Ray, traced, and found again; what
# holds no cracks is refused, and nothing is left.
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"
tests=$(cd -- "$here/../trace" && pwd)
cd "$scratch"

# What is refused.
for kind in blank noise bricks pixel huge broken; do
  /usr/bin/python3 "$tests/pictures.py" $kind $kind.png
  status=0
  shatterpave trace $kind.png -o refused >told 2>message || status=$?
  # libpng tells of a broken file by itself.
  [[ $status == 2 && ! -s told && $(grep -v '^libpng' message) == $kind.png:* && $(grep -vc '^libpng' message) == 1 ]] ||
    fault "trace $kind.png: exit status $status, expected 2 and one line; got $(<message)"
  [[ -z $(find refused -type f 2>/dev/null) ]] || fault "trace $kind.png left files"
done
grep -q megapixels <(shatterpave trace huge.png -o refused 2>&1 || true) || fault "a picture of 100 megapixels is refused as something else"
grep -q "one place" <(shatterpave trace bricks.png -o refused 2>&1 || true) || fault "a brick wall is refused as something else"

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
shatterpave export scene.toml -o . --target povray --target json >/dev/null
povray +I"$tests/photograph.pov" +L. +W640 +H640 +A0.3 +R2 +FP +Ophoto.ppm -D Declare=Ground=1 >povray.log 2>&1 ||
  fault "POV-Ray: $(tail -n 5 povray.log)"
shatterpave trace photo.ppm -o traced --pane-mm 300,300 >told
[[ $(<told) == "$(printf 'traced/photo.json\ntraced/photo-traced.png\ntraced/photo.csv\ntraced/photo-trace.html')" ]] || fault "trace told $(<told)"
judged=$(/usr/bin/python3 "$tests/judge_trace.py" scene.json traced/photo.json 640 640 photo.ppm)
# M N found M, low, high, N | impact | ring | found | false
awk '{ exit !($7 == "|" && $8 <= 3 && $6 >= $2 - 1 && $6 <= $2 + 1 && $4 <= $1 && $1 <= $5 && $12 >= 80 && $14 <= 12) }' <<<"$judged" ||
  fault "traced: $judged"
shatterpave trace photo.ppm -o again --pane-mm 300,300 --threads 1 >/dev/null
cmp -s traced/photo.json again/photo.json || fault "another number of threads gives another file"

# Photographs that were cut off are refused, though their readers make up the rest; what is drawn out, or beyond the picture, is told.
povray +I"$tests/photograph.pov" +L. +W320 +H320 +FJ +Owhole.jpg -D Declare=Ground=1 >povray.log 2>&1 || { tail -5 povray.log; exit 1; }
shatterpave trace whole.jpg -o whole --pane-mm 300,300 >/dev/null 2>message || fault "whole.jpg: $(<message)"
[[ ! -s message ]] || fault "whole.jpg: $(<message)"
head -c "$(($(stat -c %s whole.jpg) / 2))" whole.jpg >cut.jpg
status=0
shatterpave trace cut.jpg -o cut --pane-mm 300,300 >/dev/null 2>message || status=$?
[[ $status == 2 && $(<message) == "cut.jpg: expected a photograph that can be read to its end, got JPEG error: Premature end"* ]] ||
  fault "cut.jpg: $status $(<message)"
shatterpave trace whole.jpg -o drawn_out --pane-mm 400,300 >/dev/null 2>message || fault "drawn out: $(<message)"
grep -q '^note: whole.jpg: 320 x 320 px are taken for a pane of 400 x 300 mm, drawn out by 1.33 to 1' message || fault "drawn out: $(<message)"
shatterpave trace whole.jpg -o beyond --pane-mm 300,300 --corners 0,0 330,0 320,320 0,320 >/dev/null 2>message || fault "beyond: $(<message)"
grep -q '^note: whole.jpg: the corner 330,0 lies outside of the picture of 320 x 320 px' message || fault "beyond: $(<message)"

# Lines as our own: the same pane by its geometry and by its drawing.
shatterpave measure scene.json -o of_json >/dev/null
shatterpave export scene.toml -o . --target svg >/dev/null
shatterpave measure scene-window.svg -o of_svg >/dev/null
for quantity in reaching_count ring_count; do
  one=$(grep ",$quantity," of_json/scene-figures.csv | cut -d, -f3)
  two=$(grep ",$quantity," of_svg/scene-window-figures.csv | cut -d, -f3)
  [[ -n $one && $one == "$two" ]] || fault "$quantity: $one by its geometry, $two by its drawing"
done
# Seeds do not make more panes of one.
shatterpave measure scene.json -o of_seeds --seeds 5 --radials 24..90 >/dev/null 2>message || fault "seeds beside lines: $(<message)"
[[ $(<message) == "note: scene.json: --seeds and --radials have no effect on lines from a file" ]] || fault "seeds beside lines: $(<message)"
cmp -s of_json/scene-measures.csv of_seeds/scene-measures.csv || fault "seeds beside lines change what is measured"
[[ $(wc -l <of_json/paper-table1.csv) == 20 ]] || fault "paper-table1.csv has not nineteen panes"

# Cracks of a file, by targets.
printf 'seed = 1\n[[pane]]\nname = "window"\ncracks_file = "traced/photo.json"\n[pane.shards]\n' >from_photo.toml
for target in json svg obj ply; do
  shatterpave export from_photo.toml -o exported --target $target >/dev/null || fault "a traced pane is not exported as $target"
done
printf '{"format": "shatterpave-geometry", "version": 1, "panes": [{"outline_mm": [[0, 0], [9, 0], [9, 9]], "cracks": 7}]}' >wrong.json
status=0
shatterpave measure wrong.json -o wrong >/dev/null 2>message || status=$?
[[ $status == 2 && $(<message) == "wrong.json: panes[0].cracks: expected a list"* ]] || fault "wrong.json: $status $(<message)"

# A scene of it.
shatterpave fit traced/photo.json -o fitted.toml >told
[[ $(<told) == fitted.toml ]] || fault "fit told $(<told)"
shatterpave check fitted.toml >/dev/null || fault "the fitted scene is refused"

