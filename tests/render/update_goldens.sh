#!/usr/bin/env bash
# Renders the golden pictures anew: those of the cases named, or all. Nothing else writes them.
# Say in the commit why they change, and look at each of them first: tests/out/CASE/ holds the new one beside the old.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=../../.ci/setup.sh
source "$here/../../.ci/setup.sh"

install_packages build render test || exit 1
build_release update_goldens -DSHATTERPAVE_TESTS=ON || exit 1
exec "$root/build/tests/render/update_goldens" "$@"
