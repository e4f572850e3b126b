#!/usr/bin/env bash
# Makes the API page of the public headers by Doxygen: DIR/html/index.html. Fails where Doxygen warns.
#   docs/api.sh [DIR]   DIR: default build/api
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
output=$(mkdir -p "${1:-$root/build/api}" && cd "${1:-$root/build/api}" && pwd)
command -v doxygen >/dev/null || { echo "doxygen was not found (Debian package doxygen)" >&2; exit 1; }
cd "$root"
version=$(sed -n 's/^#define SHATTERPAVE_VERSION "\(.*\)"$/\1/p' include/shatterpave/version.h)
{ cat docs/Doxyfile; printf 'OUTPUT_DIRECTORY = "%s"\nPROJECT_NUMBER = %s\n' "$output" "$version"; } | doxygen -
printf '%s\n' "$output/html/index.html"
