#!/usr/bin/env bash
# Draws docs/pictures/growth_laws.svg: one pane by both laws of growth, and by the printed one with a rule changed at a time.
#   docs/laws.sh [--seed N] [--command SHATTERPAVE] [FILE.svg]
# Exports the panes as SVG by the command, which it builds unless one is given, and sets them on one page.
set -euo pipefail
# shellcheck source=sheet.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/sheet.sh"

# Keys of [pane.growth], R, and what the caption says.
panes='law = "fitted"|5|fitted
law = "printed"|5|printed
law = "printed"; region = "rectangle"|5|printed, rectangle
law = "printed"; region = "circle"|5|printed, circle
law = "printed"; time_step = 0.25|5|printed, dt = 0.25
law = "printed"; crack_gain_px2 = 1|5|printed, a sixtieth of F2
law = "printed"|0|printed, no rings
law = "printed"; crack_gain_px2 = 1|0|printed, a sixtieth of F2, no rings'

start_sheet growth_laws.svg "$@"

# Each in a scene of its own, so that all have one name, and the same draws.
number=0
while IFS='|' read -r keys rings _; do
  {
    printf '[[pane]]\nname = "pane"\nsize_mm = [300, 300]\n'
    printf '[[pane.impact]]\nat_mm = [150, 150]\nradial_count = 105\nlarge_count = 10\ncircular_count = %s\n' "$rings"
    printf '[pane.growth]\n%s\n' "${keys//; /$'\n'}"
  } >"$scratch/law$number.toml"
  "$command" export "$scratch/law$number.toml" -o "$scratch" --seed "$seed" --target svg >/dev/null
  ((++number))
done <<<"$panes"

# Two rows of four panes; each takes 300 mm and 30 mm to the next, and a caption below.
page() {
  sheet_head 'One pane by both laws of growth' 6900
  local place=0 column row words
  while IFS='|' read -r _ _ words; do
    ((column = place % 4, row = place / 4)) || true
    printf '<g transform="translate(%d %d)">\n<rect width="3000" height="3000"/>\n' "$((150 + column * 3300))" "$((150 + row * 3400))"
    printf '<g transform="translate(0 3000)">\n'
    crack_paths "$scratch/law$place-pane.svg"
    printf '</g>\n<text x="1500" y="3150">%s</text>\n</g>\n' "$words"
    ((++place))
  done <<<"$panes"
  printf '</svg>\n'
}

end_sheet page
