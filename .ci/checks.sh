# shellcheck shell=bash
# The dear checks of source and tests, which .ci/run does in short and .ci/long/checks whole. Sourced after setup.sh, never run.

if command -v ccache >/dev/null; then
  export CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_SLOPPINESS=pch_defines,time_macros
fi

# Units of many sources each: the headers of libraries, most of what there is to compile and to check, are gone through once a unit.
units=(-DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=12 -DSHATTERPAVE_TESTS=ON -DSHATTERPAVE_PLOTS=REQUIRED
  -DSHATTERPAVE_PLOTS_FOLDER="$root/build/plots")

configure_tidy() {
  quietly cmake -S "$root" -B "$root/build-tidy" -DSHATTERPAVE_BENCHMARKS=ON -DCMAKE_EXPORT_COMPILE_COMMANDS=ON "${units[@]}" &&
    cp "$root/build/src/embedded_files.cpp" "$root/build-tidy/src/"
}

# checked_units RULES WHICH…: the units of build-tidy whose path grep picks by WHICH, by that file of rules, since their place is not that
# of their sources.
checked_units() {
  local rules=$1
  shift
  sed -n 's/^ *"file": "\(.*\)",\{0,1\}$/\1/p' "$root/build-tidy/compile_commands.json" | grep "$@" |
    xargs -P "$(nproc)" -n 1 clang-tidy --quiet -p "$root/build-tidy" --config-file="$root/$rules" --checks=-bugprone-suspicious-include
}

# build_sanitized DIR SANITIZERS FLAGS [-DOPTION… | TARGET…]: builds with the given sanitizers and the compiler's FLAGS: -O0 is built in half of
# the time of -O1, and runs several times as long.
build_sanitized() {
  local folder=$root/$1 sanitizers=$2 flags=$3 options=() targets=() word
  shift 3
  for word in "$@"; do
    if [[ $word == -D* ]]; then options+=("$word"); else targets+=("$word"); fi
  done
  cmake -S "$root" -B "$folder" -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="$flags" -DSHATTERPAVE_SANITIZE="$sanitizers" \
    "${units[@]}" -DSHATTERPAVE_PRECOMPILE=ON "${options[@]}" &&
    cmake --build "$folder" --target "${targets[@]}" --parallel "$(nproc)"
}

# build_readers DIR FLAGS [-DOPTION… | TARGET…]: what meets users' files, and what it is made of, under the sanitizers of addresses and
# undefined behaviour.
build_readers() {
  build_sanitized "$1" address,undefined "$2" '-DSHATTERPAVE_ROOMS=core;studio;geometry;glass;paving;scene' \
    '-DSHATTERPAVE_TEST_ROOMS=support;core;geometry;scene' "${@:3}"
}

# tests_of DIR LABEL…: the names of the tests of GoogleTest in that build that have one of the labels, as a filter.
tests_of() {
  local folder=$root/$1 labels
  shift
  labels=$(IFS='|' && echo "$*")
  ctest --test-dir "$folder" -N -L "^($labels)\$" | sed -n 's/^ *Test *#[0-9]*: \([^ ]*\).*/\1/p' | grep -v '^scripts\.' | paste -sd:
}

# run_in_shards PROGRAM FILTER: tests of GoogleTest by its filter, shared out over the processors. One process each, since to
# start one under sanitizers takes about a second, for hundreds of tests more than the tests themselves.
run_in_shards() {
  local shard failed=0 jobs=() folder
  folder=$(mktemp -d)
  printf '%s\n' "--gtest_brief=1" "--gtest_filter=$2" >"$folder/flags"
  for ((shard = 0; shard < $(nproc); ++shard)); do
    GTEST_TOTAL_SHARDS=$(nproc) GTEST_SHARD_INDEX=$shard timeout 3000 "$1" --gtest_flagfile="$folder/flags" >"$folder/$shard" 2>&1 &
    jobs+=($!)
  done
  for ((shard = 0; shard < ${#jobs[@]}; ++shard)); do
    wait "${jobs[shard]}" || failed=1
    cat "$folder/$shard"
    # A filter that lets no test pass is no success.
    grep -q 'PASSED.* [1-9][0-9]* test' "$folder/$shard" || failed=1
  done
  rm -rf "$folder"
  return "$failed"
}
