#!/usr/bin/env bash
# A texture set in Blender, without a hand on it: its own add-on finds the maps by their names, and a picture is rendered.
#   blender_test.sh BUILD   the build folder
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
build=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

fail() { printf '%s\n' "$*"; tail -n 30 "$scratch/log"; exit 1; }

cat >"$scratch/s.toml" <<'TOML'
seed = 7
[[pavement]]
name = "plaza"
size_mm = [1600, 1600]
[pavement.direction]
kind = "radial"
centre_mm = [-800, -600]
[pavement.textures]
size_px = 512
TOML
"$build/shatterpave" export "$scratch/s.toml" -o "$scratch/set" --target textures >/dev/null

# in_blender: whether all is as it should be.
in_blender() {
  blender -b --factory-startup -P "$here/blender_textures.py" -- "$scratch/set" plaza "$scratch/picture.png" >"$scratch/log" 2>&1 &&
    grep -q '^textures: ok' "$scratch/log"
}
in_blender || fail "the texture set is not as Blender wants it: $(grep '^textures:' "$scratch/log")"

# The twin: heights for normals.
cp "$scratch/set/plaza_Height.png" "$scratch/set/plaza_Normal.png"
if in_blender; then fail "a set without normals passes"; fi
