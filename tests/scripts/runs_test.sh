#!/usr/bin/env bash
# The short form of .ci/long/runs: many runs into one folder, killed, stopped, on a full disk.
#   runs_test.sh BUILD
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
# How quickly a run ends is measured by the long form, on a quiet machine.
"$here/../../.ci/long/runs" --build "$1" --rounds 3 --kills 20 --terms 1 --slowness 0.03 --patience 4
