#!/usr/bin/env bash
# Draws docs/pictures/agui1992_plate.svg: the twelve presets side by side, as Figs. 14 to 16 of Agui et al. 1992 show them.
#   docs/plate.sh [--seed N] [--command SHATTERPAVE] [FILE.svg]
# Exports the twelve panes as SVG and as JSON by the command, which it builds unless one is given, and sets them on one page.
set -euo pipefail
# shellcheck source=sheet.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/sheet.sh"

# Figure, letter and what §4.3 prints of it: M R N V1 V2 V3.
experiments="
14 a 113 6 11 30 5 10
14 b 104 5 10 40 5 10
14 c 113 6 11 50 5 10
14 d 95 5 10 60 5 10
15 a 114 6 11 40 10 10
15 b 98 5 10 40 10 10
15 c 105 5 10 40 10 10
15 d 92 5 9 40 10 10
16 a 104 5 10 40 10 10
16 b 89 4 8 40 10 10
16 c 108 5 9 40 10 10
16 d 96 5 10 40 10 10"

start_sheet agui1992_plate.svg "$@"

while read -r figure letter _; do
  printf '[[pane]]\nname = "fig%s%s"\npreset = "agui1992-fig%s%s"\n' "$figure" "$letter" "$figure" "$letter"
done <<<"${experiments#?}" >"$scratch/plate.toml"
"$command" export "$scratch/plate.toml" -o "$scratch" --seed "$seed" --target svg --target json >/dev/null

# What was exported is what the captions say.
counts=$(tr -d ' \n' <"$scratch/plate.json" |
  grep -o '"radial_count":[0-9]*,"large_count":[0-9]*,"circular_count":[0-9]*' | tr -dc '0-9,\n')
printed=$(awk 'NF { print $3 "," $5 "," $4 }' <<<"$experiments")
[[ $counts == "$printed" ]] || { say "plate.sh: the panes have other counts than their captions"; exit 1; }

# Three rows of four panes; each takes 300 mm and 24 mm to the next, and a caption below.
page() {
  sheet_head 'The twelve experiments of Agui et al. 1992, Figs. 14 to 16, by shatterpave' 10620
  local place=0 column row figure letter m r n v1 v2 v3 law
  while read -r figure letter m r n v1 v2 v3; do
    ((figure == 16)) && law=uniform || law=normal
    ((column = place % 4, row = place / 4)) || true
    printf '<g transform="translate(%d %d)">\n<rect width="3000" height="3000"/>\n' "$((150 + column * 3300))" "$((150 + row * 3500))"
    printf '<g transform="translate(0 3000)">\n'
    crack_paths "$scratch/plate-fig$figure$letter.svg"
    printf '</g>\n<text x="1500" y="3140">Fig. %s (%s), %s: M %s, R %s, N %s</text>\n' "$figure" "$letter" "$law" "$m" "$r" "$n"
    printf '<text x="1500" y="3265">V1 %s, V2 %s, V3 %s</text>\n</g>\n' "$v1" "$v2" "$v3"
    ((++place))
  done <<<"${experiments#?}"
  printf '</svg>\n'
}

end_sheet page
