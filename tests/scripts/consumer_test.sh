#!/usr/bin/env bash
# Installs what is built, builds a project of somebody else's with it, and looks at what that writes; then runs the installed
# command from a folder that knows nothing of this one.
#   consumer_test.sh BUILD   the build folder
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
build=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

fail() { printf '%s\n' "$*"; exit 1; }

cmake --install "$build" --prefix "$scratch/installed" >"$scratch/log" || { cat "$scratch/log"; fail "installation failed"; }
{ cmake -S "$here/../consumer" -B "$scratch/build" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_PREFIX_PATH="$scratch/installed" &&
  cmake --build "$scratch/build"; } >"$scratch/log" 2>&1 || { cat "$scratch/log"; fail "the consumer does not build"; }

"$scratch/build/consumer" >"$scratch/consumer.json"
python3 - "$scratch/consumer.json" <<'PYTHON' || fail "the consumer writes something else"
import json, sys
model = json.load(open(sys.argv[1]))
assert model["format"] == "shatterpave-geometry" and model["version"] == 1
pane = model["panes"][0]
assert pane["impacts"][0]["radial_count"] == 24
kinds = [crack["kind"] for crack in pane["cracks"]]
assert kinds.count("large") + kinds.count("radial") == 24, kinds
PYTHON

cat >"$scratch/scene.toml" <<'TOML'
seed = 3
[[pane]]
name = "window"
size_mm = [300, 300]
[[pane.impact]]
at_mm = [150, 150]
radial_count = 24
TOML
cd /
"$scratch/installed/bin/shatterpave" export "$scratch/scene.toml" -o "$scratch/out" --target json --target povray >/dev/null
python3 -c 'import json, sys
a, b = (json.load(open(name))["panes"][0]["cracks"] for name in sys.argv[1:])
assert a == b, "library and command differ"' "$scratch/consumer.json" "$scratch/out/scene.json" ||
  fail "the installed command and the library differ"
