#!/usr/bin/env bash
# Random layouts before the judge: none may be wrong, and each that is spoilt must be found out. A few of those that .ci/long/layouts
# lays, without the real places beside the repository; .ci/run has the first thousand judged.
#   layouts_test.sh BUILD   the build folder
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"
program=$1/tests/layouts/random_layouts
judge=$here/../layouts/judge_layouts.py

# A line is a function of its number alone.
"$program" --first 30 --count 100 >"$scratch/lines"
"$program" --first 129 --count 1 | cmp - <(tail -n 1 "$scratch/lines")
head -n 50 "$scratch/lines" | /usr/bin/python3 "$judge" --self-test
# The scorer finds the same bare spots.
"$program" --measured --first 941 --count 30 >"$scratch/measured"
/usr/bin/python3 "$judge" --worst 3 <"$scratch/measured"
/usr/bin/python3 "$judge" --run "$program" --first 1001 --count 50 --worst 3
/usr/bin/python3 "$judge" --run "$program" --first 101 --count 20 --sized --worst 3
