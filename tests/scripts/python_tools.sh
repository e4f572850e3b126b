# shellcheck shell=bash
# Sourced by tests that need programs of PyPI: python_tools BUILD NAME PACKAGE==VERSION … makes a virtual environment
# BUILD/validators/NAME with these, once, and prints its Python. Packages of Debian are not seen in it.
python_tools() {
  local folder=$1/validators/$2
  shift 2
  if [[ ! -f $folder/installed || $(<"$folder/installed") != "$*" ]]; then
    rm -rf "$folder"
    mkdir -p "$folder"
    { python3 -m venv "$folder" && "$folder/bin/pip" install --quiet --disable-pip-version-check "$@"; } >"$folder/log" 2>&1 ||
      { cat "$folder/log" >&2; return 1; }
    echo "$*" >"$folder/installed"
  fi
  echo "$folder/bin/python"
}
