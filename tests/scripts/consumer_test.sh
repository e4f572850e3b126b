#!/usr/bin/env bash
# Installs what is built, looks at what is there, builds a project of somebody else's with it, and looks at what that writes; then
# runs the installed command from a folder that knows nothing of this one.
#   consumer_test.sh BUILD   the build folder
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"

quietly "installation failed" cmake --install "$build" --prefix "$scratch/installed"

# Of the headers those of include/ alone, and in them nothing but the standard library.
expected=$(cd "$root/include" && find . -name '*.h' | LC_ALL=C sort)
found=$(cd "$scratch/installed/include" && find . -type f | LC_ALL=C sort)
[[ $found == "$expected" ]] || fail "installed headers: $found"
foreign=$(grep -rnE '^[[:space:]]*#[[:space:]]*include' "$scratch/installed/include" |
  grep -vE '<(shatterpave/[a-z]+\.h|[a-z_0-9]+)>' || true)
[[ -z $foreign ]] || fail "a public header includes: $foreign"
# Each stands by itself.
for header in "$scratch"/installed/include/shatterpave/*.h; do
  printf '#include <shatterpave/%s>\n' "${header##*/}" >"$scratch/alone.cpp"
  quietly "$header does not stand by itself" \
    "${CXX:-c++}" -std=c++20 -Wall -Wextra -Wpedantic -Werror -fsyntax-only -I "$scratch/installed/include" "$scratch/alone.cpp"
done
# Nor is a library asked for of which the binary holds all.
for name in glm Boost nlohmann CLI11 shatterpave_rooms; do
  if grep -rq "$name" "$scratch"/installed/lib*/cmake/shatterpave "$scratch"/installed/lib/*/cmake/shatterpave 2>/dev/null; then
    fail "the installed configuration asks for $name"
  fi
done

quietly "the consumer is not configured" cmake -S "$root/tests/consumer" -B "$scratch/build" -DCMAKE_BUILD_TYPE=Debug \
  -DCMAKE_PREFIX_PATH="$scratch/installed"
quietly "the consumer does not build" cmake --build "$scratch/build"
# As part of the consumer's own project it finds the right headers as well; to build the whole library once more takes too long.
quietly "the consumer is not configured with the sources" cmake -S "$root/tests/consumer" -B "$scratch/whole" -G "Unix Makefiles" \
  -DCONSUMER_SUBDIRECTORY="$root" -DSHATTERPAVE_PLOTS=OFF
quietly "the consumer does not compile beside the sources" make -C "$scratch/whole" main.o
if grep -q GTest "$scratch/whole/CMakeCache.txt"; then fail "tests are built though nobody asks for them"; fi

"$scratch/build/consumer" >"$scratch/consumer.json"
python3 - "$scratch/consumer.json" <<'PYTHON' || fail "the consumer writes something else"
import json, sys
model = json.load(open(sys.argv[1]))
assert model["format"] == "shatterpave-geometry" and model["version"] == 1
pane = model["panes"][0]
assert pane["impacts"][0]["radial_count"] == 24
kinds = [crack["kind"] for crack in pane["cracks"]]
assert kinds.count("large") + kinds.count("radial") == 24, kinds
PYTHON

cat >"$scratch/scene.toml" <<'TOML'
seed = 3
[[pane]]
name = "window"
size_mm = [300, 300]
[[pane.impact]]
at_mm = [150, 150]
radial_count = 24
TOML
cd /
"$scratch/installed/bin/shatterpave" export "$scratch/scene.toml" -o "$scratch/out" --target json --target povray >/dev/null
cmp "$scratch/consumer.json" "$scratch/out/scene.json" || fail "the installed command and the library differ"
