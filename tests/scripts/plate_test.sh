#!/usr/bin/env bash
# The plate of the twelve presets: whole, the same each time, and refused where a caption is not what the pane is. The sheets of bonds,
# of knobs and of both laws of growth are those that are in the pages.
#   plate_test.sh BUILD
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"
plate=$root/docs/plate.sh
command=$build/shatterpave

[[ $("$plate" --command "$command" --seed 3 "$scratch/a.svg") == "$scratch/a.svg" ]] || fail "does not say what it wrote"
"$plate" --command "$command" --seed 3 "$scratch/b.svg" >"$scratch/said"
cmp "$scratch/a.svg" "$scratch/b.svg" || fail "two runs differ"
"$plate" --command "$command" --seed 4 "$scratch/b.svg" >"$scratch/said"
if cmp -s "$scratch/a.svg" "$scratch/b.svg"; then fail "the seed does not show"; fi

python3 - "$scratch/a.svg" <<'CHECK'
import re, sys, xml.etree.ElementTree as tree
ns = "{http://www.w3.org/2000/svg}"
panes = tree.parse(sys.argv[1]).getroot().findall(ns + "g")
assert len(panes) == 12, len(panes)
for pane in panes:
    caption = "".join(text.text for text in pane.findall(ns + "text"))
    m, r, n = (int(re.search(letter + r" (\d+)", caption).group(1)) for letter in "MRN")
    kinds = {path.get("class"): path.get("d").count("M") for path in pane.iter(ns + "path")}
    # Cracks without room for a second point are left out, so a ring or a radial may be missing, but no large crack.
    assert kinds["large"] == n, caption
    assert m - n - 2 <= kinds["radial"] <= m - n, caption
    assert 2 * r - 2 <= kinds["circular"] <= 2 * r, caption
    # Relative steps that end in the pane.
    for path in pane.iter(ns + "path"):
        for crack in path.get("d").split("M")[1:]:
            numbers = [int(x) for x in re.findall(r"-?\d+", crack)]
            assert len(numbers) % 2 == 0 and 0 <= sum(numbers[::2]) <= 3000 and -3000 <= sum(numbers[1::2]) <= 0, caption
CHECK

ends 2 "$plate" --wrong
# A copy with a wrong caption, beside what it sources.
mkdir "$scratch/docs"
ln -s "$root/.ci" "$scratch/.ci"
cp "$root/docs/sheet.sh" "$scratch/docs/"
sed "s/^14 b 104 /14 b 105 /" "$plate" >"$scratch/docs/plate.sh"
if bash "$scratch/docs/plate.sh" --command "$command" "$scratch/c.svg" 2>"$scratch/said"; then fail "a wrong caption is not noticed"; fi
grep -q "other counts than their captions" "$scratch/said" || fail "a wrong caption is refused for another reason: $(<"$scratch/said")"
[[ ! -e $scratch/c.svg ]] || fail "a plate with a wrong caption is left"

"$root/docs/bonds.sh" --command "$command" "$scratch/bonds.svg" >"$scratch/said"
cmp "$scratch/bonds.svg" "$root/docs/pictures/bonds.svg" || fail "docs/pictures/bonds.svg shows other stones: docs/bonds.sh draws it"
for what in glass paving; do
  "$root/docs/knobs.sh" "$what" --command "$command" "$scratch/knobs.svg" >"$scratch/said"
  cmp "$scratch/knobs.svg" "$root/docs/pictures/knobs_$what.svg" || fail "docs/pictures/knobs_$what.svg shows others: docs/knobs.sh draws it"
done
ends 2 "$root/docs/knobs.sh" wood
"$root/docs/laws.sh" --command "$command" "$scratch/laws.svg" >"$scratch/said"
cmp "$scratch/laws.svg" "$root/docs/pictures/growth_laws.svg" || fail "docs/pictures/growth_laws.svg shows other cracks: docs/laws.sh draws it"
