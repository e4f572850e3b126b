#!/usr/bin/env bash
# A scene from a stranger (docs/security.md): texts of it reach no renderer's language, endless input ends, links and pipes are not written through.
# shellcheck disable=SC2016  # What must not be run stands in single quotes.
#   security_test.sh BUILD   the build folder
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"
cd "$scratch"

# refused WHAT COMMAND…: status 2 within ten seconds and in 1 GiB, one short message, nothing on stdout.
refused() {
  local what=$1 status=0
  shift
  (ulimit -v 4194304 && timeout 10 "$@" >"$scratch/said" 2>"$scratch/message") || status=$?
  ((status == 2)) || fail "$what: expected status 2, got $status: $(head -c 400 "$scratch/message")"
  [[ ! -s $scratch/said ]] || fail "$what: it wrote $(head -n 1 "$scratch/said")"
  (($(wc -c <"$scratch/message") < 2000)) || fail "$what: a message of $(wc -c <"$scratch/message") bytes"
}

cat >good.toml <<'TOML'
[[pane]]
name = "window"
outline_file = "plan.svg"
outline_class = "glass"
impact = [{at_mm = [50, 50], radial_count = 12}]
[[pavement]]
name = "path"
outline_file = "plan.svg"
outline_class = "stone"
textures.swatch_px = 0
TOML
cat >plan.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="400mm" height="100mm" viewBox="0 0 400 100">
<rect class="glass" x="0" y="0" width="100" height="100"/><rect class="stone" x="120" y="0" width="280" height="100"/></svg>
SVG
targets=(--target povray --target json --target svg --target gltf --target usd --target mitsuba --target obj --target ply --target csv)
"$build/shatterpave" export good.toml -o good "${targets[@]}" >files
(($(wc -l <files) > 12)) || fail "the scene itself: $(<files)"

# Every key that takes a text, and the names of files themselves, with what would run in one of the languages that are written. It is
# refused, or no file holds it.
payload='x"; } #fopen F "pwned" write #write(F, 1) <script>pwned()</script> ${pwned} `touch pwned`'
mapfile -t keys < <("$build/shatterpave" keys --json | python3 -c '
import json, sys
for key in json.load(sys.stdin)["keys"]:
    if key["type"] == "text":
        print(key["path"].replace("pane[]", "pane[0]").replace("pavement[]", "pavement[0]").replace("key[]", "key[0]"))')
((${#keys[@]} >= 12)) || fail "keys of texts: ${keys[*]}"
for key in "${keys[@]}"; do
  rm -rf out
  status=0
  "$build/shatterpave" export good.toml -o out "${targets[@]}" --set "$key=$payload" >said 2>message || status=$?
  case $status in
    0) ! grep -rlF pwned out || fail "$key: its text is in these files" ;;
    2) [[ ! -e out || -z $(ls -A out) ]] || fail "$key: refused, but $(ls out)" ;;
    *) fail "$key: status $status: $(<message)" ;;
  esac
done
for name in $'a\n#debug "pwned"\n' 'a"b' 'a\b' $'a\tb'; do
  cp good.toml "$name.toml"
  refused "a scene called $(printf %q "$name")" "$build/shatterpave" export "$name.toml" -o out
done
cp good.toml '$(touch pwned); <b> & é.toml'
"$build/shatterpave" export './$(touch pwned); <b> & é.toml' -o odd "${targets[@]}" >/dev/null || fail "a scene with an odd name is refused"
python3 - odd <<'PYTHON' || fail "a file of a scene with an odd name is not whole"
import json, pathlib, sys, xml.etree.ElementTree
for file in pathlib.Path(sys.argv[1]).iterdir():
    if file.suffix in (".svg", ".xml"):
        xml.etree.ElementTree.parse(file)
    elif file.suffix == ".json":
        json.loads(file.read_text(encoding="utf-8"))
PYTHON
"$build/shatterpave" farm './$(touch pwned); <b> & é.toml' -o jobs --system parallel --quality draft --size 16x12 >/dev/null 2>&1 || true
[[ ! -e pwned ]] || fail "a name was run as a command"

# Input without end, and folders and devices in place of files.
mkdir folder.toml
for file in /dev/zero folder.toml /dev/null; do
  refused "the scene $file" "$build/shatterpave" check "$file"
  refused "the plan $file" "$build/shatterpave" check good.toml --set "pane[0].outline_file=$file"
  refused "the cracks $file" "$build/shatterpave" check good.toml --set "pane[0].cracks_file=$file"
done
refused "the environment /dev/zero" "$build/shatterpave" check good.toml --set light.environment=/dev/zero
# Tables in one another, and numbers of things, without end.
python3 -c 'print("a = " + "[" * 200000)' >deep.toml
python3 -c 'print("[[pane]]\nname = \"a\"\n" * 200000)' >many.toml
python3 -c 'print("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1mm\" height=\"1mm\">" + "<g>" * 300000)' >plan.svg
refused "tables in one another" "$build/shatterpave" check deep.toml
refused "many panes" "$build/shatterpave" check many.toml
refused "groups in one another" "$build/shatterpave" check good.toml
cat >plan.svg <<'SVG'
<!DOCTYPE svg [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;"><!ENTITY c SYSTEM "file:///etc/passwd">]>
<svg xmlns="http://www.w3.org/2000/svg" width="400mm" height="100mm"><text>&b;&c;</text></svg>
SVG
refused "entities" "$build/shatterpave" check good.toml

# What lies in the folder may be a stranger's, too: nothing is written through a link.
printf 'mine\n' >elsewhere
mkdir links
ln -s ../elsewhere links/good.json
cat >plan.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="400mm" height="100mm" viewBox="0 0 400 100">
<rect class="glass" x="0" y="0" width="100" height="100"/><rect class="stone" x="120" y="0" width="280" height="100"/></svg>
SVG
"$build/shatterpave" export good.toml -o links --target json >/dev/null 2>&1 || true
[[ $(<elsewhere) == mine ]] || fail "a link in the folder was written through"
