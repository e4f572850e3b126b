#!/usr/bin/env bash
# Shards in Blender, by the OBJ that is written: glass that is neither metal nor half there.
#   blender_glass_test.sh BUILD   the build folder
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
build=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

fail() { printf '%s\n' "$*"; tail -n 30 "$scratch/log"; exit 1; }

cat >"$scratch/s.toml" <<'TOML'
seed = 7
[[pane]]
name = "window"
size_mm = [300, 240]
thickness_mm = 3
[[pane.impact]]
at_mm = [140, 130]
radial_count = 60
[pane.shards]
missing_mm = 60
TOML
"$build/shatterpave" export "$scratch/s.toml" -o "$scratch" --target obj >/dev/null

# in_blender: whether all is as it should be.
in_blender() {
  blender -b --factory-startup -P "$here/blender_glass.py" -- "$scratch/s.obj" 0.24 >"$scratch/log" 2>&1 &&
    grep -q '^glass: ok' "$scratch/log"
}
in_blender || fail "the shards are not as Blender wants them: $(grep '^glass:' "$scratch/log")"

# The twins: refraction and a little of d, which is how other writers say glass, are a metal that is nearly gone; and so many
# millimetres are as many metres.
cp "$scratch/s.mtl" "$scratch/good.mtl"
sed -e '/^Ka/d' -e 's/^d 1$/d 0.1/' -e 's/^illum.*/illum 7/' "$scratch/good.mtl" >"$scratch/s.mtl"
if in_blender; then fail "glass of metal passes"; fi
cp "$scratch/good.mtl" "$scratch/s.mtl"
awk '$1 == "v" { $2 *= 1000; $3 *= 1000; $4 *= 1000 } { print }' "$scratch/s.obj" >"$scratch/large.obj"
mv "$scratch/large.obj" "$scratch/s.obj"
if in_blender; then fail "a pane of 240 m passes"; fi
