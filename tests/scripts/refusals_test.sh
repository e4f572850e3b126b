#!/usr/bin/env bash
# `check` and `export` refuse the same scenes with the same message at the place of the key, and write nothing.
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"
cd "$scratch"

# refuse MESSAGE SCENE: of a scene whose last lines are SCENE
refuse() {
  printf '%s\n' "$2" >s.toml
  for arguments in "check s.toml" "export s.toml -o out --target json"; do
    status=0
    # shellcheck disable=SC2086  # Two words and more.
    "$build/shatterpave" $arguments >told 2>message || status=$?
    if [[ $status != 2 || $(<message) != "$1" || -s told || -e out ]]; then
      fault "$(printf '%s: exit status %s, expected 2\n  expected %s\n  got      %s' "$arguments" "$status" "$1" "$(<message)")"
    fi
    rm -rf out
  done
}
pavement='[[pavement]]
name = "p"'
pane='[[pane]]
name = "w"'

# Limits of paving (src/paving/limits.h).
refuse 's.toml:4:12: pavement[0].stone_mm: expected at most 2000000 stones, got an area for about 1000004000000' "$pavement
size_mm = [1e6, 1e6]
stone_mm = [1, 1]
joint_mm = 0"
refuse 's.toml:4:12: pavement[0].stone_mm: expected at most 2000000 stones, got an area for about 3008000' "$pavement
size_mm = [30000, 10000]
stone_mm = [10, 10]
joint_mm = 0
bond = \"stack\"
direction.angle_deg = 30"
refuse 's.toml:4:12: pavement[0].stone_mm: expected stones at least as long as wide for this bond, got [50, 100]' "$pavement
size_mm = [900, 900]
stone_mm = [50, 100]
bond = \"herringbone\""
refuse 's.toml:4:12: pavement[0].stone_mm: expected stones at most twice as long as wide for this bond, got [210, 100]' "$pavement
size_mm = [900, 900]
stone_mm = [210, 100]
bond = \"segmental_arc\""
refuse 's.toml:5:16: pavement[0].bond_span_mm: expected 0, or at least 540 (five stones), got 539' "$pavement
size_mm = [900, 900]
bond = \"fan\"
bond_span_mm = 539"
refuse 's.toml:4:21: pavement[0].textures.seamless: expected no border_course, since a tile has no border' "$pavement
size_mm = [900, 900]
textures.seamless = true
border_course = \"soldier\""
refuse 's.toml:7:20: pavement[0].textures.tile_mm: expected a tile of at most 1000000 stones, got 4000000' "$pavement
size_mm = [900, 900]
stone_mm = [1, 1]
joint_mm = 0
textures.seamless = true
textures.tile_mm = [2000, 2000]
bond = \"stack\""
refuse 's.toml:6:24: pavement[0].ground.kerb_width_mm: kerb: expected at most 2000000 stones, got an area for about 6000012' "$pavement
size_mm = [1e6, 1e6]
stone_mm = [10000, 10000]
ground.kerb_length_mm = 1
ground.kerb_width_mm = 2"
# The first of two that are wrong is told, whichever is found first.
refuse 's.toml:5:12: pavement[0].stone_mm: expected stones at least as long as wide for this bond, got [50, 100]' "$pavement
size_mm = [9000, 9000]
bond = \"basket_weave\"
stone_mm = [50, 100]
[[pavement]]
name = \"q\"
size_mm = [900, 900]
bond = \"fan\"
bond_span_mm = 1"
# Limits of glass.
refuse 's.toml:5:1: pane[0].growth: expected cracks that cross the pane in at most 1,000,000 steps: the step is too short for its size' "$pane
size_mm = [1e6, 1e6]
impact = [{at_mm = [9, 9], radial_count = 9}]
growth.step_length_px = 0.1"
# Environments: looked at by the reader, and, where they are pictures, by the program that reads those.
printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 40 +X 60\n' >square.hdr
printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 5000 +X 10000\n' >large.hdr
printf 'a picture' >text.exr
refuse 's.toml:5:15: light.environment: expected a file, got none of that name: none.exr' "$pavement
size_mm = [900, 900]
[light]
environment = \"none.exr\""
refuse 's.toml:5:15: light.environment: expected an EXR, HDR or PNG picture, got another file: text.exr' "$pavement
size_mm = [900, 900]
[light]
environment = \"text.exr\""
refuse 's.toml:5:15: light.environment: square.hdr: expected a lat-long picture, twice as wide as high, got 60 × 40 px' "$pavement
size_mm = [900, 900]
[light]
environment = \"square.hdr\""
refuse 's.toml:5:22: light.environment: large.hdr: expected a picture of at most 8192 × 4096 px, got 10000 × 5000 px' "$pavement
size_mm = [900, 900]
[light]
\"env\\u0069ronment\" = \"large.hdr\""
refuse 's.toml:6:9: camera.at_mm: expected a camera outside the glass, got one within that of w' "$pane
size_mm = [300, 300]
impact = [{ at_mm = [150, 150] }]
[camera]
at_mm = [9, 0, 9]"
# What the reader refuses.
refuse 's.toml:4:12: pavement[0].joint_mm: expected a number from 0 to 1000, got 1001' "$pavement
size_mm = [900, 900]
joint_mm = 1001"
refuse 's.toml:4:1: pavement[0].jiont_mm: unknown key; did you mean joint_mm?' "$pavement
size_mm = [900, 900]
jiont_mm = 10"

# What the command is told.
refuses '^shatterpave: expected no more words, got "pane" ' shatterpave keys pane
printf '%s\n' "$pane" 'size_mm = [300, 300]' 'impact = [{ at_mm = [150, 150], radial_count = 30 }]' >w.toml
shatterpave export w.toml --target json -o panes >/dev/null
refuses '^none/x.toml: expected a file in a folder that is there, got none of the name "none"$' shatterpave fit panes/w.json -o none/x.toml
