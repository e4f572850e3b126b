#!/usr/bin/env bash
# Draws docs/pictures/bonds.svg: bonds on one bent plan, the pavements of scenes/bonds.toml side by side.
#   docs/bonds.sh [--seed N] [--command SHATTERPAVE] [FILE.svg]
# Exports them as SVG by the command, which it builds unless one is given, and sets them on one page.
set -euo pipefail
# shellcheck source=sheet.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/sheet.sh"

start_sheet bonds.svg "$@"
"$command" export "$root/scenes/bonds.toml" -o "$scratch" --seed "$seed" --target svg >/dev/null
names=$(sed -n 's/^name *= *"\(.*\)"$/\1/p' "$root/scenes/bonds.toml")

# Rows of four plans; each plan takes 6,650 × 4,500 mm, with its name below.
page() {
  cat <<'HEAD'
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 28400 16200">
<title>Bonds of shatterpave on one bent plan</title>
<style>
.page{fill:#fff}
.outline{fill:#4a463f;fill-rule:evenodd;stroke:#222;stroke-width:14}
.whole{fill:#b9b4a8}
.cut{fill:#d9d2c0}
text{font:300px sans-serif;text-anchor:middle}
</style>
<rect class="page" width="28400" height="16200"/>
HEAD
  local name place=0 box column row x y
  while read -r name; do
    # The corner of its own view box goes to its place on the page.
    box=$(awk -F'viewBox="' 'NF > 1 { split($2, at, " "); printf "%.0f %.0f", -at[1], -at[2]; exit }' "$scratch/bonds-$name.svg")
    ((column = place % 4, row = place / 4, x = 400 + column * 7000, y = 300 + row * 5300)) || true
    printf '<g transform="translate(%d %d) translate(%s)">\n' "$x" "$y" "$box"
    stone_paths "$scratch/bonds-$name.svg"
    printf '</g>\n<text x="%d" y="%d">%s</text>\n' "$((x + 3300))" "$((y + 4850))" "${name//_/ }"
    ((++place))
  done <<<"$names"
  printf '</svg>\n'
}

end_sheet page
