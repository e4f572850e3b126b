#!/usr/bin/env bash
# Shards in Blender, by the OBJ that is written: glass that is neither metal nor half there.
#   blender_glass_test.sh BUILD   the build folder
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"

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

is_glass() { in_blender glass blender_glass.py "$scratch/s.obj" 0.24; }
is_glass || fail "the shards are not as Blender wants them: $(grep '^glass:' "$scratch/log")"

# The twins: refraction and a little of d, which is how other writers say glass, are a metal that is nearly gone; and so many
# millimetres are as many metres.
cp "$scratch/s.mtl" "$scratch/good.mtl"
sed -e '/^Ka/d' -e 's/^d 1$/d 0.1/' -e 's/^illum.*/illum 7/' "$scratch/good.mtl" >"$scratch/s.mtl"
if is_glass; then fail "glass of metal passes"; fi
cp "$scratch/good.mtl" "$scratch/s.mtl"
awk '$1 == "v" { $2 *= 1000; $3 *= 1000; $4 *= 1000 } { print }' "$scratch/s.obj" >"$scratch/large.obj"
mv "$scratch/large.obj" "$scratch/s.obj"
if is_glass; then fail "a pane of 240 m passes"; fi
