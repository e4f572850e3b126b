# shellcheck shell=bash
# What the scripts share that set drawings of many things on one page. Sourced, never run.
# shellcheck source=../.ci/setup.sh
source "$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.ci" && pwd)/setup.sh"

# start_sheet PICTURE [--seed N] [--command SHATTERPAVE] [FILE.svg]: sets `seed`, `command`, which it builds unless one is given,
# `target`, which is docs/pictures/PICTURE unless a file is given, and `scratch`, a folder that is removed at the end.
# shellcheck disable=SC2034  # What it sets is for who sources this.
start_sheet() {
  seed=1 command='' target=$root/docs/pictures/$1
  shift
  while (($#)); do
    case $1 in
      --seed | --command)
        (($# > 1)) || { say "${0##*/}: $1: a value is missing"; exit 2; }
        if [[ $1 == --seed ]]; then seed=$2; else command=$2; fi
        shift ;;
      -*) say "${0##*/}: unknown option $1"; exit 2 ;;
      *) target=$1 ;;
    esac
    shift
  done
  if [[ -z $command ]]; then
    install_packages build || exit 1
    build_release shatterpave_command || exit 1
    command=$root/build/shatterpave
  fi
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
}

# end_sheet COMMAND…: what it prints becomes the target, whole or not at all.
end_sheet() {
  "$@" >"$scratch/page.svg"
  mv "$scratch/page.svg" "$target"
  printf '%s\n' "$target"
}

# crack_paths DRAWING: its cracks, as one path a kind: relative, in tenths of a millimetre, which halves the size of the plate and is
# less than a pixel of it. Those of a far sheet are of the class `far`, too, and come first.
crack_paths() {
  awk -F'"' '
    /<g id="far-cracks">/ { far = "far " }
    /<\/g>/ { far = "" }
    /<polyline class="crack/ {
      split($2, kind, " ")
      n = split($6, points, " ")
      px = py = 0
      d = ""
      for (i = 1; i <= n; ++i) {
        split(points[i], p, ",")
        x = sprintf("%.0f", 10 * p[1]); y = sprintf("%.0f", 10 * p[2])
        if (i > 1 && x == px && y == py) continue
        if (i == 1) d = "M" x " " y "l"
        else d = d (x - px < 0 || substr(d, length(d)) == "l" ? "" : " ") (x - px) (y - py < 0 ? "" : " ") (y - py)
        px = x; py = y
      }
      # Shorter than a step: a path that draws nothing would end all after it.
      if (d ~ /l$/) next
      all[far kind[2]] = all[far kind[2]] d
    }
    function put(kind) { printf "<path class=\"%s\" d=\"%s\"/>\n", kind, all[kind] }
    END {
      count = split("radial large circular branch dice rung chip", kinds, " ")
      for (i = 1; i <= count; ++i) if ("far " kinds[i] in all) put("far " kinds[i])
      # The first three are on each page, also where a pane has none.
      for (i = 1; i <= count; ++i) if (i <= 3 || kinds[i] in all) put(kinds[i])
    }' "$1"
}

# stone_paths DRAWING: its outline, and its stones as one path of each kind, in whole millimetres: less than a pixel of a sheet.
stone_paths() {
  awk -F'"' '
    /<path class="outline"/ { printf "<path class=\"outline\" d=\"%s\"/>\n", $6 }
    # One polygon after another, relative to its first corner; its classes are "stone", its part and its kind.
    /<polygon class="stone/ {
      split($2, kind, " ")
      n = split($6, points, " ")
      d = ""
      for (i = 1; i <= n; ++i) {
        split(points[i], p, ",")
        x = sprintf("%.0f", p[1]); y = sprintf("%.0f", p[2])
        if (i == 1) d = "M" x " " y "l"
        else d = d (x - px < 0 || i == 2 ? "" : " ") (x - px) (y - py < 0 ? "" : " ") (y - py)
        px = x; py = y
      }
      all[kind[3]] = all[kind[3]] d "z"
    }
    END {
      split("whole cut", kinds, " ")
      for (i = 1; i in kinds; ++i) printf "<path class=\"%s\" d=\"%s\"/>\n", kinds[i], all[kinds[i]]
    }' "$1"
}

# sheet_head TITLE HEIGHT: how a page begins of panes, four in a row, and what their cracks look like.
sheet_head() {
  cat <<HEAD
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 13200 $2">
<title>$1</title>
<style>
rect{fill:#fff;stroke:#000;stroke-width:6}
path{fill:none;stroke:#222;stroke-width:5;stroke-linejoin:round;stroke-linecap:round}
.large{stroke:#000;stroke-width:8}
text{font:105px sans-serif;text-anchor:middle}
</style>
<rect x="-9" y="-9" width="13218" height="$(($2 + 18))" style="stroke:none"/>
HEAD
}
