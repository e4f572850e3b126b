#!/usr/bin/env bash
# Random layouts before the judge: none may be wrong, and each that is spoilt must be found out. The first of those that .ci/long/layouts
# lays, without the real places beside the repository: about two minutes of two processors.
#   layouts_test.sh BUILD   the build folder
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"
program=$1/tests/layouts/random_layouts
judge=$here/../layouts/judge_layouts.py

# A line is a function of its number alone.
"$program" --first 30 --count 100 >"$scratch/lines"
"$program" --first 129 --count 1 | cmp - <(tail -n 1 "$scratch/lines")
/usr/bin/python3 "$judge" --self-test <"$scratch/lines"
# The scorer finds the same bare spots; the shares of layouts with wide ones are judged in the thousand below, of which these are some.
"$program" --measured --first 941 --count 60 >"$scratch/measured"
/usr/bin/python3 "$judge" --worst 3 <"$scratch/measured"
/usr/bin/python3 "$judge" --run "$program" --first 1 --count 1000 --worst 3
