#!/usr/bin/env bash
# What the tutorials show runs as it stands there: a block after "Save as `FILE`:" is that file, every other block is typed.
#   tutorials_test.sh BUILD [TUTORIAL.md …]   the build folder; the tutorials, else all
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"
shift
export PATH=$build:$PATH

(($# > 0)) || set -- "$root"/docs/tutorials/*.md
for tutorial in "$@"; do
  name=$(basename "$tutorial" .md)
  mkdir "$scratch/$name"
  start=$SECONDS
  python3 - "$tutorial" >"$scratch/$name.sh" <<'PYTHON'
import re, shlex, sys
print("set -euo pipefail")
# A block may be two: a file ends at a line that a shell would be given.
blocks = re.finditer(r"(?m)^(?P<before>(?! ).*)\n\n?(?P<block>(?:    .*\n|\n(?=    ))+)", open(sys.argv[1], encoding="utf-8").read())
for found in blocks:
    text = "\n".join(line[4:] for line in found["block"].split("\n")).strip("\n") + "\n"
    file = re.search(r"ave as `([^`]+)`:$", found["before"])
    if file:
        end = re.search(r"(?m)^(shatterpave|blender) ", text)
        content, text = (text[:end.start()], text[end.start():]) if end else (text, "")
        print(f"mkdir -p $(dirname {shlex.quote(file[1])})\ncat >{shlex.quote(file[1])} <<'END OF FILE'\n{content}END OF FILE")
    # Each block is typed in the folder where the first one was.
    if text:
        print(f"(\n{text})")
PYTHON
  grep -q shatterpave "$scratch/$name.sh" || fail "$name: no commands"
  if ! (cd "$scratch/$name" && bash "$scratch/$name.sh") >"$scratch/$name.log" 2>&1; then
    fail "$name: what the tutorial shows fails: $(<"$scratch/$name.log")"
  fi
  # What it says that one finds.
  # shellcheck disable=SC2016  # Backquotes of the page.
  while read -r file; do
    [[ -s $scratch/$name/$file ]] || fail "$name: $file is not there"
  done < <(grep -o '`[a-z]*/[A-Za-z_.-]*\.[a-z]*`' "$tutorial" | tr -d '`')
  echo "$name: $((SECONDS - start)) s"
done
