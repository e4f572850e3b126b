#!/usr/bin/env bash
# The command starts without OpenImageIO and PROJ, whose libraries take longer to load than most jobs to do, and finds the program
# that has the former wherever it is called from.
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"

ldd "$build/shatterpave" >"$scratch/loaded"
! grep OpenImageIO "$scratch/loaded" || fail "shatterpave loads OpenImageIO"
! grep libproj "$scratch/loaded" || fail "shatterpave loads PROJ"
# So do the tests that read no pictures: hundreds of processes.
ldd "$build/tests/shatterpave_tests" >"$scratch/loaded"
! grep OpenImageIO "$scratch/loaded" || fail "shatterpave_tests loads OpenImageIO"
ldd "$build/shatterpave-rasters" >"$scratch/loaded"
grep -q OpenImageIO "$scratch/loaded" || fail "shatterpave-rasters does not load OpenImageIO: it cannot write rasters"

cat >"$scratch/s.toml" <<'TOML'
[[pavement]]
name = "p"
outline_mm = [[0, 0], [400, 0], [400, 300]]
TOML
ln -s "$build/shatterpave" "$scratch/linked"
(cd "$scratch" && ./linked export s.toml -o out --target povray >list) || fail "through a link: exit status $?"
grep -q '\.png$' "$scratch/list" || fail "no raster was written: $(<"$scratch/list")"

# Where that program is missing the message says so.
cp "$build/shatterpave" "$scratch/alone"
ends 1 "$scratch/alone" export "$scratch/s.toml" -o "$scratch/out2"
grep -q "$scratch/shatterpave-rasters" "$scratch/message" || fail "alone: $(<"$scratch/message")"
[[ ! -e $scratch/out2 ]] || fail "alone: something was written"
