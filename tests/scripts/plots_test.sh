#!/usr/bin/env bash
# The report's plotting library: where npm cannot fetch it, a build goes on without the report unless it is required, and a package
# that is not the right one is refused.
#   plots_test.sh BUILD   the build folder, which holds the packages
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"

# configured PLOTS [-DOPTION…]: whether CMake configures, with an npm that always fails.
configured() {
  rm -rf "$scratch/build"
  cmake -S "$root" -B "$scratch/build" -DSHATTERPAVE_TESTS=OFF -DSHATTERPAVE_NPM=/bin/false -DSHATTERPAVE_PLOTS="$1" "${@:2}" \
    >"$scratch/log" 2>&1
}

configured AUTO || fail "AUTO does not go on without the library"
grep -q 'measure will leave out its report: npm could not fetch vega 6' "$scratch/log" || fail "AUTO does not say what is missing"
configured OFF || fail "OFF does not configure"
if configured REQUIRED; then fail "REQUIRED goes on without the library"; fi
grep -q 'plotting library of the report is missing' "$scratch/log" || fail "REQUIRED does not say what is missing"

mkdir "$scratch/packages"
cp "$build"/plots/{vega,three}-*.tgz "$scratch/packages/"
configured REQUIRED -DSHATTERPAVE_PLOTS_FOLDER="$scratch/packages" || fail "packages in a folder are not taken"
for package in "$scratch"/packages/vega-lite-*.tgz; do printf 'x' >>"$package"; done
if configured AUTO -DSHATTERPAVE_PLOTS_FOLDER="$scratch/packages"; then fail "a changed package is taken"; fi
grep -q 'expected SHA-512' "$scratch/log" || fail "a changed package is refused for another reason"
