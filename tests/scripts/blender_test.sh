#!/usr/bin/env bash
# A texture set in Blender, without a hand on it: its own add-on finds the maps by their names, and a picture is rendered.
#   blender_test.sh BUILD   the build folder
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"

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

is_set() { in_blender textures blender_textures.py "$scratch/set" plaza "$scratch/picture.png"; }
is_set || fail "the texture set is not as Blender wants it: $(grep '^textures:' "$scratch/log")"

# The twin: heights for normals.
cp "$scratch/set/plaza_Height.png" "$scratch/set/plaza_Normal.png"
if is_set; then fail "a set without normals passes"; fi
