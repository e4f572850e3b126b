#!/usr/bin/env bash
# From scene files to pictures: sets up, builds, exports and renders. See `./render.sh --help`.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=.ci/setup.sh
source "$here/.ci/setup.sh"

usage() {
  cat <<'HELP'
Usage: render.sh [OPTION…] [SCENE.toml …]

Installs the Debian packages that are missing, builds shatterpave once, and renders each scene to OUTPUT/SCENE/ as a
linear EXR and a PNG. Without a scene: the two of the gallery, a shattered window and a stone path.

  --quality draft|final  draft, which is quick and small, if not given
  --size WxH             size of the picture in pixels
  --seed N               seed in place of the scene's
  --output DIR           where the pictures go (default: out/ beside this script)
  --help                 shows this

Exit status: 0 done; 1 set-up, build or the program failed; 2 the scene or the usage is wrong; 3 the renderer failed.
HELP
}

wrong_usage() {
  say "render.sh: $1 (see render.sh --help)"
  exit 2
}

# meant WORD NAME…: "; did you mean NAME?" for the one name that begins as the word does, but for its last two letters or more.
meant() {
  local word=$1 name found='' least=0
  shift
  [[ $word != --* ]] || least=3
  while ((${#word} > least)); do
    for name in "$@"; do
      [[ $name == "$word"* ]] || continue
      [[ -z $found ]] || return 0
      found=$name
    done
    [[ -z $found ]] || { printf '; did you mean %s?' "$found"; return 0; }
    word=${word%?}
  done
}

known=(--quality --size --seed --output --help)

# What is wrong is told before anything is installed or built. The command checks the rest.
require_value() {
  case $1 in
    --quality) [[ $2 == draft || $2 == final ]] || wrong_usage "--quality: expected draft or final, got \"$2\"$(meant "$2" draft final)" ;;
    --size) [[ $2 =~ ^[1-9][0-9]*x[1-9][0-9]*$ ]] || wrong_usage "--size: expected WIDTHxHEIGHT in pixels, such as 640x480, got \"$2\"" ;;
    --seed) [[ $2 =~ ^[0-9]+$ ]] || wrong_usage "--seed: expected a whole number from 0, got \"$2\"" ;;
    --output) [[ -n $2 ]] || wrong_usage "--output: expected a folder, got an empty name" ;;
  esac
}

scenes=() options=() output=$root/out
declare -A given
while (($#)); do
  case $1 in
    --help) usage; exit 0 ;;
    --quality | --size | --seed | --output)
      (($# > 1)) || wrong_usage "$1: expected a value after it, got nothing"
      [[ -z ${given[$1]:-} ]] || wrong_usage "$1: expected it once, got it twice"
      given[$1]=1
      require_value "$1" "$2"
      if [[ $1 == --output ]]; then output=$2; else options+=("$1" "$2"); fi
      shift ;;
    --) shift; scenes+=("$@"); break ;;
    -*) wrong_usage "expected an option of ${known[*]}, got \"$1\"$(meant "$1" "${known[@]}")" ;;
    *) scenes+=("$1") ;;
  esac
  shift
done
((${#scenes[@]})) || scenes=("$root/scenes/shattered_window.toml" "$root/scenes/stone_path.toml")
for scene in "${scenes[@]}"; do
  [[ -e $scene && ! -d $scene ]] || wrong_usage "$scene: expected a scene file, got $([[ -d $scene ]] && echo "a folder" || echo "none of that name")"
done

declare -A folder_of
for scene in "${scenes[@]}"; do
  name=$(basename -- "$scene" .toml)
  [[ -z ${folder_of[$name]:-} ]] || wrong_usage "two scenes are named $name; their pictures would go to one folder"
  folder_of[$name]=$output/$name
done

# The command tidies up after itself when it is interrupted; here it is only left to end first.
trap 'exit 130' INT
trap 'exit 143' TERM
install_packages build render || exit 1
build_release shatterpave_command || exit 1
for scene in "${scenes[@]}"; do
  "$root/build/shatterpave" render "$scene" -o "${folder_of[$(basename -- "$scene" .toml)]}" "${options[@]}"
done
