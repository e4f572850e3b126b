#!/usr/bin/env bash
# Runs `measure` and opens its report in Chromium, without network: every plot must be drawn, nothing may be fetched, and a page
# with a broken plot, without the library or with a foreign resource must be found out.
#   measure_test.sh BUILD   the build folder
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"

cat >"$scratch/panes.toml" <<'TOML'
seed = 3
[[pane]]
name = "window"
preset = "agui1992-fig15a"
[[pane]]
name = "drawn"
size_mm = [200, 150]
impact = [{at_mm = [90, 80], mean_radial_count = 60}]
[[pavement]]
name = "court"
outline_mm = [[0, 0], [3000, 0], [3000, 1900], [0, 2100]]
holes_mm = [[[900, 900], [900, 1300], [1300, 1100]]]
[pavement.direction]
kind = "radial"
centre_mm = [1000, -1500]
TOML
"$build/shatterpave" measure "$scratch/panes.toml" --seeds 6 -o "$scratch/out" >"$scratch/list" 2>"$scratch/messages"
[[ ! -s $scratch/messages ]] || fail "expected no message, got: $(<"$scratch/messages")"
[[ $(wc -l <"$scratch/list") == 5 ]] || fail "expected five files, got: $(<"$scratch/list")"
[[ $(wc -l <"$scratch/out/panes-measures-pavements.csv") == 7 ]] || fail "expected a row for each seed"
stones=$(($(wc -l <"$scratch/out/panes-measures-stones.csv") - 1))

# opened PAGE: the page as it is once its scripts have run, and what the browser says of it.
opened() {
  chromium --headless --no-sandbox --disable-gpu --no-first-run --disable-background-networking --disable-component-update \
    --disable-sync --disable-dev-shm-usage --host-resolver-rules='MAP * ~NOTFOUND' --user-data-dir="$scratch/browser" \
    --enable-logging=stderr --virtual-time-budget=10000 --dump-dom "file://$1" 2>"$scratch/console"
  # Errors of scripts, and what the page asked for in vain, are told with the word CONSOLE.
  grep CONSOLE "$scratch/console" || true
}

# The share of the map that is coloured, as an attribute: what is on a canvas does not show in the page itself.
probe='<script>
for (const canvas of document.querySelectorAll("canvas")) {
  const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
  let inked = 0;
  for (let i = 3; i < pixels.length; i += 4) inked += pixels[i] > 0;
  canvas.dataset.ink = inked * 4 / pixels.length;
}
</script>'

# sound PAGE: says what is wrong with a page, and fails; says nothing of a sound one.
sound() {
  sed "s|^</body>\$|$(tr '\n' ' ' <<<"$probe")</body>|" "$1" >"$scratch/probed.html"
  opened "$scratch/probed.html" >"$scratch/dom"
  python3 "$here/measure_page.py" "$scratch/dom" "$stones"
}

page=$scratch/out/panes-measures.html
sound "$page" || fail "the report is not sound"

# expect_unsound WHAT FAULT PATTERN REPLACEMENT: the page after one replacement must be found to have that fault.
expect_unsound() {
  python3 - "$page" "$scratch/twin.html" "$3" "$4" <<'PYTHON' || fail "the twin \"$1\" is like the page"
import sys
page, twin, what, by = sys.argv[1:]
text = open(page, encoding="utf-8").read()
assert what in text, what
open(twin, "w", encoding="utf-8").write(text.replace(what, by, 1))
PYTHON
  if sound "$scratch/twin.html" >"$scratch/faults"; then fail "not found out: $1"; fi
  grep -q "$2" "$scratch/faults" || fail "$1: expected \"$2\", found: $(<"$scratch/faults")"
}
expect_unsound "a plot with an unknown mark" 'the plot counts failed' 'type: "tick"' 'type: "stick"'
expect_unsound "a page without Vega-Lite" 'the plot large failed' 'var n="6.5.0";' 'throw 1;var n="6.5.0";'
expect_unsound "a plot without data" 'the plot turns: expected' '"turns":{"cells":[[' '"turns":{"cells":[],"none":[['
expect_unsound "a picture from elsewhere" '<img src=' '<footer>' '<footer><img src="https://example.org/a.png" alt="">'
expect_unsound "a style from elsewhere" 'the style loads something' '* { box-sizing' '@import "https://example.org/a.css"; * { box-sizing'
expect_unsound "a map whose stones are not drawn" 'the map: expected stones over half' 'context.fill(path);' ';context.clearRect(0, 0, 1e6, 1e6);'
expect_unsound "a map with data that cannot be read" 'the map-0 failed' '"rings":[[' '"rings":0,"none":[['
