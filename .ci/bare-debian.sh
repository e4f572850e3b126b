#!/usr/bin/env bash
# Tries the two commands of the README where nothing is installed: a Debian 12 made by debootstrap, and in it a fresh clone of
# what is committed here. Needs root and the package debootstrap; takes some 20 minutes.
#   .ci/bare-debian.sh [FOLDER]   the new system, default /tmp/bare; one that is there already is used as it is
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
root=$(cd -- "$here/.." && pwd)
target=${1:-/tmp/bare}
project=/src/shatterpave

((EUID == 0)) || { echo "bare-debian.sh: must be run as root" >&2; exit 1; }
command -v debootstrap >/dev/null || { echo "bare-debian.sh: install debootstrap first" >&2; exit 1; }

[[ -d $target/etc ]] || debootstrap --variant=minbase bookworm "$target" http://deb.debian.org/debian
# Name resolution and package sources as here; everything else is bare.
cp /etc/resolv.conf /etc/hosts "$target/etc/"
rm -f "$target/etc/apt/sources.list"
cp /etc/apt/sources.list.d/debian.sources "$target/etc/apt/sources.list.d/"

rm -rf "${target:?}$project"
git clone -q --no-hardlinks "$root" "$target$project"
rm -rf "$target$project/.git" # git is not installed there, and not needed
# The report's plotting library as it was fetched here, if it was: npm may need settings of the machine's to reach its registry.
if compgen -G "$root/build/plots/*.tgz" >/dev/null; then
  mkdir -p "$target$project/build/plots"
  cp "$root"/build/plots/*.tgz "$target$project/build/plots/"
fi

mountpoint -q "$target/proc" || mount -t proc proc "$target/proc"
trap 'umount "$target/proc"' EXIT
inside() { chroot "$target" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root "$@"; }

inside "$project/render.sh"
for ending in exr png; do
  found=$(find "$target$project/out" -name "*.$ending" | wc -l)
  ((found == 2)) || { echo "bare-debian.sh: expected two .$ending in out/, found $found" >&2; exit 1; }
done
inside "$project/tests/run.sh"
