#!/usr/bin/env bash
# The short form of .ci/long/faults: a machine that fails.
#   faults_test.sh BUILD
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"
"$root/.ci/long/faults" --build "$build" --share 0.003 calls
"$root/.ci/long/faults" --build "$build" --share 0.02 surroundings memory kills
