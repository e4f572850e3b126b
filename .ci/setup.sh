# shellcheck shell=bash
# What render.sh, tests/run.sh and .ci/run share: the packages of packages.txt, and the release build in build/.
# Sourced, never run. Everything that is said here goes to stderr: stdout belongs to the caller.

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)

# Ninja begins what it can, however the targets depend on one another; build folders that were made by others stay as they are.
export CMAKE_GENERATOR=${CMAKE_GENERATOR:-Ninja}

say() { printf '%s\n' "$*" >&2; }

# The packages in the given sections of packages.txt, one a line.
packages_of() {
  local section
  for section in "$@"; do
    awk -v wanted="[$section]" '
      /^[[:space:]]*(#|$)/ { next }
      /^\[/ { inside = ($1 == wanted); found = found || inside; next }
      inside { print $1 }
      END { if (!found) exit 1 }' "$root/packages.txt" || { say "packages.txt: no section [$section]"; return 1; }
  done
}

# Those of the given packages that are not installed.
missing_of() {
  local package
  for package in "$@"; do
    [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || printf '%s\n' "$package"
  done
}

# install_packages SECTION…: makes sure that all packages of these sections are there.
# As root by itself, else by sudo; where neither is to be had, one message that names them.
install_packages() {
  local wanted missing listed
  listed=$(packages_of "$@") || return 1
  mapfile -t wanted <<<"$listed"
  mapfile -t missing < <(missing_of "${wanted[@]}")
  ((${#missing[@]})) || return 0

  local as_root=(env DEBIAN_FRONTEND=noninteractive)
  if ((EUID != 0)); then
    command -v sudo >/dev/null || {
      say "These Debian packages are missing, and neither root nor sudo is to be had. As root, run:"
      say "  apt-get install --no-install-recommends ${missing[*]}"
      return 1
    }
    as_root=(sudo env DEBIAN_FRONTEND=noninteractive)
  fi
  local install=("${as_root[@]}" apt-get install -q -y --no-install-recommends "${missing[@]}")
  say "Installing ${missing[*]}"
  # The package lists may be absent or old: then, and only then, they are fetched.
  "${install[@]}" </dev/null >&2 || { "${as_root[@]}" apt-get update -q </dev/null >&2 && "${install[@]}" </dev/null >&2; } || {
    say "Could not install: ${missing[*]}"
    return 1
  }
}

# Makes sure that there is an npm. Many machines have one with a Node.js that is not Debian's, and beside it Debian's own cannot be
# installed.
install_npm() { command -v npm >/dev/null || install_packages plots; }

# build_release [TARGET] [-DOPTION…]: configures and builds build/; where nothing has changed it takes about a second.
build_release() {
  local target=$1
  shift
  local first=()
  [[ -f $root/build/CMakeCache.txt ]] || first=(-DCMAKE_BUILD_TYPE=Release -DSHATTERPAVE_TESTS=OFF -DSHATTERPAVE_PRECOMPILE=ON -DSHATTERPAVE_TEST_UNITS=12)
  quietly cmake -S "$root" -B "$root/build" "${first[@]}" "$@" &&
    quietly cmake --build "$root/build" --target "$target" --parallel "$(nproc)"
}

# Runs a command and shows what it said only where it failed; on a terminal one line says that it is running.
quietly() {
  local log status=0
  log=$(mktemp) || return 1
  [[ -t 2 ]] && say "$1 $2 …"
  "$@" </dev/null >"$log" 2>&1 || status=$?
  ((status == 0)) || cat "$log" >&2
  rm -f "$log"
  return "$status"
}
