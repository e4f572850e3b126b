#!/usr/bin/env bash
# The set-up: reads the sections of packages.txt, finds what is missing, and never installs what is there.
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"
# shellcheck source=../../.ci/setup.sh
source "$root/.ci/setup.sh"

# Each line of packages.txt is a comment, a section or one name, and no package stands twice.
bad=$(grep -nvE '^(#.*|\[[a-z]+\]|[a-z0-9][a-z0-9.+-]*)?$' "$root/packages.txt" || true)
[[ -z $bad ]] || fail "packages.txt: $bad"
twice=$(grep -E '^[a-z0-9]' "$root/packages.txt" | sort | uniq -d)
[[ -z $twice ]] || fail "packages.txt: twice: $twice"

[[ $(packages_of render) == *povray* ]] || fail "section [render] does not hold povray"
[[ $(packages_of build) != *povray* ]] || fail "section [build] holds povray"
if packages_of attic 2>/dev/null; then fail "an unknown section is no error"; fi
[[ $(missing_of bash no-such-package coreutils) == no-such-package ]] || fail "missing_of finds the wrong ones"

# With a false apt-get and dpkg-query before the true ones: what would be run?
# shellcheck disable=SC2016  # Expanded when they run.
printf '#!/bin/sh\necho "$@" >>"%s/calls"\n[ ! -e "%s/fail" ] || { rm "%s/fail"; exit 100; }\n' \
  "$scratch" "$scratch" "$scratch" >"$scratch/apt-get"
# shellcheck disable=SC2016
printf '#!/bin/sh\n[ "$4" = povray ] || printf installed\n' >"$scratch/dpkg-query"
printf '#!/bin/sh\nexec "$@"\n' >"$scratch/sudo"
chmod +x "$scratch/apt-get" "$scratch/dpkg-query" "$scratch/sudo"
PATH=$scratch:$PATH

install_packages build 2>/dev/null
[[ ! -e $scratch/calls ]] || fail "apt-get was called though nothing is missing"
install_packages build render 2>/dev/null
[[ $(<"$scratch/calls") == "install -q -y --no-install-recommends povray" ]] || fail "called: $(<"$scratch/calls")"
# The lists of packages are fetched where the first try fails, and only then.
: >"$scratch/calls"
touch "$scratch/fail"
install_packages render 2>/dev/null
[[ $(cut -d' ' -f1 "$scratch/calls" | paste -sd' ') == "install update install" ]] || fail "called: $(<"$scratch/calls")"
