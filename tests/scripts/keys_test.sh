#!/usr/bin/env bash
# The tables of keys in docs/scene-file.md are those that `shatterpave keys --markdown` prints.
#   keys_test.sh BUILD           fails where they differ
#   keys_test.sh BUILD --renew   writes them into the page
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"
page=$root/docs/scene-file.md

"$build/shatterpave" keys --markdown >"$scratch/tables" || fail "keys --markdown: exit status $?"
# The page with each table, from its first line to its last, as the command prints it.
awk -v page="$page" '
  function path_of(line) { sub(/^<!-- keys /, "", line); sub(/ -->$/, "", line); return line }
  FNR == NR {
    if (/^<!-- keys .* -->$/) path = path_of($0)
    if (path != "") tables[path] = tables[path] $0 "\n"
    if (/^<!-- end of keys -->$/) path = ""
    next
  }
  /^<!-- keys .* -->$/ {
    path = path_of($0)
    if (!(path in tables)) { print page ":" FNR ": the command has no table " path > "/dev/stderr"; wrong = 1 }
    printf "%s", tables[path]
    shown[path] = 1
    inside = 1
  }
  !inside
  /^<!-- end of keys -->$/ { inside = 0 }
  END {
    for (path in tables) if (!(path in shown)) { print page ": there is no table " path > "/dev/stderr"; wrong = 1 }
    exit wrong
  }' "$scratch/tables" "$page" >"$scratch/page" || fail "$page: tables are missing, see above"

if [[ ${2:-} == --renew ]]; then
  cp "$scratch/page" "$page"
elif ! diff -u "$page" "$scratch/page"; then
  fail "$page: keys have changed; renew its tables by: ${BASH_SOURCE[0]} $build --renew"
fi

# Every setting is told.
for still in "$root"/templates/stills/*_still.pov; do
  name=$(basename "$still" .pov)
  grep -q "^| \`$name\` | " "$page" || fail "$page: the setting $name is missing"
done
