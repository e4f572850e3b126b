#!/usr/bin/env bash
# Every test: sets up, builds, runs unit, golden-image, script and consumer tests. The last line says how many ran.
# Arguments are handed to ctest: `tests/run.sh -R Predicates` runs some, `-E Render` leaves out those that render.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=../.ci/setup.sh
source "$here/../.ci/setup.sh"

trap 'exit 130' INT
trap 'exit 143' TERM
install_packages build render test || exit 1
install_npm || exit 1
build_release all -DSHATTERPAVE_TESTS=ON -DSHATTERPAVE_PLOTS=REQUIRED || exit 1

# One more at a time than there are processors: many wait for a browser, a server or a disk.
at_once=$(($(nproc) + 1))
results=$root/build/test-results.xml
rm -f "$results"
status=0
ctest --test-dir "$root/build" --parallel "$at_once" --output-on-failure --no-tests=error \
  --output-junit "$results" "$@" </dev/null || status=$?

count_of() { sed -n "s/^[[:space:]]*$1=\"\([0-9]*\)\".*/\1/p" "$results" | head -n 1; }
[[ -f $results ]] || { say "No test ran."; exit 1; }
total=$(count_of tests) failed=$(count_of failures) skipped=$(count_of skipped)
passed=$((total - failed - skipped))
((passed > 0 || failed > 0)) || { say "No test ran."; status=1; }
# The one reason to skip is that the data beside the repository is not there (tests/support/shared_data.h).
if ((skipped > 0)) && [[ -d $root/../shared/data ]]; then
  say "$skipped tests were skipped although ../shared/data is there."
  status=1
fi
((failed == 0)) || status=1

summary="$passed passed, $failed failed"
((skipped == 0)) || summary+=", $skipped skipped"
printf '%s\n' "$summary"
exit "$((status == 0 ? 0 : 1))"
