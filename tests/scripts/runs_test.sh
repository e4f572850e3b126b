#!/usr/bin/env bash
# The short form of .ci/long/runs: many runs into one folder, killed, stopped, on a full disk.
#   runs_test.sh BUILD
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"
# How quickly a run ends is measured by the long form, on a quiet machine.
"$root/.ci/long/runs" --build "$build" --rounds 3 --kills 20 --terms 1 --slowness 0.03 --patience 4
