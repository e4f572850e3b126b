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

scenes=() options=() output=$root/out
while (($#)); do
  case $1 in
    --help) usage; exit 0 ;;
    --quality | --size | --seed | --output)
      (($# > 1)) || wrong_usage "$1: a value is missing"
      if [[ $1 == --output ]]; then output=$2; else options+=("$1" "$2"); fi
      shift ;;
    --) shift; scenes+=("$@"); break ;;
    -*) wrong_usage "unknown option $1" ;;
    *) scenes+=("$1") ;;
  esac
  shift
done
((${#scenes[@]})) || scenes=("$root/scenes/shattered_window.toml" "$root/scenes/stone_path.toml")

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
