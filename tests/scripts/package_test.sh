#!/usr/bin/env bash
# The packages: what is in them, that it runs from where it lies, that the manual page has no fault, and that bash and zsh complete
# commands, options, targets and folders. (.ci/long/package installs them on a bare system.)
#   package_test.sh BUILD
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"

version=$("$build/shatterpave" --version | sed -n '1s/^shatterpave //p')
for kind in DEB TGZ; do
  quietly "no $kind" cpack --config "$build/CPackConfig.cmake" -G "$kind" -B "$scratch"
done
command=$scratch/shatterpave_${version}_$(dpkg --print-architecture).deb
development=$scratch/libshatterpave-dev_${version}_$(dpkg --print-architecture).deb

# Names of files in a package, without folders.
files_of() { dpkg-deb --contents "$1" | awk '$1 !~ /^d/ { print $6 }'; }
for file in bin/shatterpave bin/shatterpave-rasters share/man/man1/shatterpave.1 share/bash-completion/completions/shatterpave \
  share/zsh/vendor-completions/_shatterpave share/shatterpave/scenes/stone_path.toml share/doc/shatterpave/copyright; do
  files_of "$command" | grep -qx "./usr/$file" || fail "no $file in $command"
done
for file in include/shatterpave/shatterpave.h lib/libshatterpave.a lib/cmake/shatterpave/shatterpaveConfig.cmake; do
  files_of "$development" | grep -qx "./usr/$file" || fail "no $file in $development"
done
twice=$( (files_of "$command"; files_of "$development") | sort | uniq -d)
[[ -z $twice ]] || fail "in both packages: $twice"
for name in povray libopenimageio2.4 libfmt9; do
  dpkg-deb --field "$command" Depends | grep -q "$name" || fail "the package does not depend on $name"
done

# From anywhere.
mkdir "$scratch/some where"
tar -xzf "$scratch"/shatterpave-*.tar.gz -C "$scratch/some where" --strip-components=1
moved=$scratch/some\ where
(cd / && "$moved/bin/shatterpave" export "$moved/share/shatterpave/scenes/stone_path.toml" -o "$scratch/out" --target json --target textures >/dev/null)
[[ -s $scratch/out/stone_path.json ]] || fail "the unpacked command wrote no JSON"

# The manual page: every command and option of --help, and nothing that man finds fault with.
MANWIDTH=200 LC_ALL=C man --warnings -l "$moved/share/man/man1/shatterpave.1" >"$scratch/page" 2>"$scratch/faults"
[[ ! -s $scratch/faults ]] || fail "man: $(<"$scratch/faults")"
col -b <"$scratch/page" >"$scratch/text"
mapfile -t commands < <("$build/shatterpave" --help | sed -n '/^Subcommands:/,$s/^  \([a-z]*\)  .*/\1/p')
((${#commands[@]} >= 5)) || fail "found no commands in --help"
for name in "${commands[@]}"; do
  grep -q "shatterpave $name" "$scratch/text" || fail "the manual page does not tell of $name"
  while read -r option; do
    grep -q -- "$option" "$scratch/text" || fail "the manual page does not tell of $name $option"
  done < <("$build/shatterpave" "$name" --help | grep -oE '^  --[a-z-]+' || true)
done

# bash: what is offered for the last of the words.
cat >"$scratch/complete.bash" <<'BASH'
source "$1"
shift
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
compopt() { :; }
_shatterpave
printf '%s\n' "${COMPREPLY[@]}"
BASH
offered() { bash "$scratch/complete.bash" "$moved/share/bash-completion/completions/shatterpave" "$@"; }
mkdir "$scratch/folder"
cd "$scratch"
[[ $(offered shatterpave exp) == export ]] || fail "bash: exp"
[[ $(offered shatterpave export --tar) == --target ]] || fail "bash: --tar"
[[ $(offered shatterpave export --target mits) == mitsuba ]] || fail "bash: mits"
[[ $(offered shatterpave export -o fold) == folder ]] || fail "bash: -o"
[[ $(offered shatterpave export some) == "some where" ]] || fail "bash: a file"
[[ -z $(offered shatterpave check --size) ]] || fail "bash: an option of another command"
zsh -n "$moved/share/zsh/vendor-completions/_shatterpave" || fail "zsh: syntax"
# zsh, as typed on a terminal.
typed() { /usr/bin/python3 "$here/zsh_typed.py" "$moved/share/zsh/vendor-completions" "$1"; }
[[ $(typed "shatterpave exp") == *"shatterpave export"* ]] || fail "zsh: $(typed "shatterpave exp")"
[[ $(typed "shatterpave render --qual") == *"--quality"* ]] || fail "zsh: $(typed "shatterpave render --qual")"
