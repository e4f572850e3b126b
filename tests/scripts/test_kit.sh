# shellcheck shell=bash
# What the tests beside it have in common. Each begins with
#   source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"
# which stops it at the first command that fails, and sets
#   here      this folder
#   root      the project
#   build     the build folder: the test's first argument
#   scratch   a new folder, which is gone when the test ends
set -euo pipefail
# shellcheck disable=SC2034  # For the tests.
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
# shellcheck disable=SC2034
root=$(cd -- "$here/../.." && pwd)
build=$(cd -- "${1:?the build folder}" && pwd)
scratch=$(mktemp -d)
faults=0

# A test that must do more at its end than remove `scratch` defines it anew.
at_end() { :; }
finish() {
  local status=$?
  at_end || true
  rm -rf "$scratch"
  if ((faults > 0)); then
    echo "$faults faults"
    status=1
  fi
  exit "$status"
}
trap finish EXIT

# fault WHAT…: says what is wrong, and goes on; the test fails at its end.
fault() {
  printf '%s\n' "$*"
  faults=$((faults + 1))
}
# fail WHAT…: says what is wrong, and the end of $scratch/log where there is one, and ends the test.
fail() {
  printf '%s\n' "$*" >&2
  [[ ! -s $scratch/log ]] || tail -n 30 "$scratch/log" >&2
  exit 1
}
# quietly WHAT COMMAND…: fails with WHAT where the command fails. What it says is in $scratch/log.
quietly() { "${@:2}" >"$scratch/log" 2>&1 || fail "$1"; }

shatterpave() { "$build/shatterpave" "$@"; }
# ends STATUS COMMAND…: fails where it ends with another status. What it wrote is in $scratch/said, its messages in
# $scratch/message.
ends() {
  local wanted=$1 status=0
  shift
  "$@" >"$scratch/said" 2>"$scratch/message" || status=$?
  ((status == wanted)) || fail "expected status $wanted, got $status: $*: $(head -c 400 "$scratch/message")"
}
# refuses PATTERN COMMAND…: fails unless it ends with status 2, writes nothing to stdout, and has a line in its messages that
# matches the pattern, as grep has them.
refuses() {
  ends 2 "${@:2}"
  [[ ! -s $scratch/said ]] || fail "refused, but it wrote $(head -n 1 "$scratch/said"): ${*:2}"
  grep -q -- "$1" "$scratch/message" || fail "expected a message like \"$1\", got: $(head -c 400 "$scratch/message"): ${*:2}"
}

# in_blender WORD SCRIPT ARGUMENT…: whether the script of this folder, run by Blender, prints "WORD: ok". All that is said is in
# $scratch/log.
in_blender() {
  blender -b --factory-startup -P "$here/$2" -- "${@:3}" >"$scratch/log" 2>&1 && grep -q "^$1: ok" "$scratch/log"
}

# python_tools NAME PACKAGE==VERSION …: makes a virtual environment $build/validators/NAME with these packages of PyPI, once, and
# prints its Python. Packages of Debian are not seen in it.
python_tools() {
  local folder=$build/validators/$1
  shift
  if [[ ! -f $folder/installed || $(<"$folder/installed") != "$*" ]]; then
    rm -rf "$folder"
    mkdir -p "$folder"
    { python3 -m venv "$folder" && "$folder/bin/pip" install --quiet --disable-pip-version-check "$@"; } >"$folder/log" 2>&1 ||
      { cat "$folder/log" >&2; return 1; }
    echo "$*" >"$folder/installed"
  fi
  echo "$folder/bin/python"
}
# node_tools NAME PACKAGE@VERSION …: installs these packages of npm in $build/NAME, once, and prints the folder of their modules.
node_tools() {
  local folder=$build/$1
  shift
  if [[ ! -f $folder/node_modules/installed || $(<"$folder/node_modules/installed") != "$*" ]]; then
    npm install --silent --no-audit --no-fund --prefix "$folder" "$@" >"$scratch/npm" 2>&1 || { cat "$scratch/npm" >&2; return 1; }
    echo "$*" >"$folder/node_modules/installed"
  fi
  echo "$folder/node_modules"
}
