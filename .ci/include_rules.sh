#!/usr/bin/env bash
# Fails where a source file includes what its room may not, by the table in docs/architecture.md, or where it names what
# one file of the project alone may name. Each finding is one line, file:line: what is wrong.
#   include_rules.sh [ROOT]   ROOT: of the project, default this one
set -euo pipefail
root=${1:-$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)}
cd "$root"

# The table's rows as "room allowed allowed …".
rules=$(awk -F'|' '
  /^## / { inside = /who may include whom/ }
  inside && $2 ~ /^ `[a-z\/]+(\/[*])?` $/ { gsub(/[`–]/, ""); print $2, $4 }' docs/architecture.md)
[[ -n $rules ]] || { echo "docs/architecture.md: no table of rooms found" >&2; exit 1; }

# shellcheck disable=SC2016  # A backquote of the table, no expansion.
find include src tests -name '*.h' -o -name '*.cpp' | LC_ALL=C sort | xargs awk -v rules="$rules" '
  BEGIN {
    count = split(rules, line, "\n")
    for (i = 1; i <= count; ++i) {
      n = split(line[i], word, " ")
      known[word[1]] = 1
      for (j = 2; j <= n; ++j) allowed[word[1], word[j]] = 1
    }
  }
  # The row of a folder: its own, or that of all folders beside it, such as export/*.
  function row_of(folder,   beside) {
    if (folder in known) return folder
    beside = folder
    sub(/[^\/]*$/, "*", beside)
    return beside in known ? beside : ""
  }
  # The deepest folder of a path that the table names.
  function room_of(path) {
    while (sub(/\/[^\/]*$/, "", path)) if (row_of(path) != "") return path
    return ""
  }
  # Whether the table lets files of `room` include `header`: by its own room, by its name, or by a folder that holds it.
  function may_include(room, header,   folder, row) {
    if (room_of(header) == room) return 1
    row = row_of(room)
    if ((row, header) in allowed || (row, row_of(room_of(header))) in allowed) return 1
    folder = header
    while (sub(/\/[^\/]*$/, "", folder)) if ((row, folder) in allowed) return 1
    return 0
  }
  function wrong(what) { printf "%s:%d: %s\n", FILENAME, FNR, what; ++failures }

  FNR == 1 {
    split(FILENAME, path, "/")
    product = path[1] == "src"
    big_room = path[2]
    room = product ? room_of(substr(FILENAME, 5)) : ""
    if (product && room == "") wrong("the room " big_room " is not in docs/architecture.md")
    # A big room that is divided has no other folders.
    else if (product && room == big_room && path[4] != "") wrong("the folder " path[2] "/" path[3] " is not in docs/architecture.md")
  }
  { code = $0; sub(/\/\/.*/, "", code) }

  product && match(code, /^[ \t]*#[ \t]*include[ \t]*"[^"]+[.]h"/) {
    split(code, quoted, "\"")
    if (room_of(quoted[2]) == "") wrong("\"" quoted[2] "\" is in no room")
    else if (!may_include(room, quoted[2])) wrong(room " may not include " quoted[2])
  }
  # Public headers use the standard library, whose headers have neither a folder nor an ending, and one another.
  path[1] == "include" && code ~ /^[ \t]*#[ \t]*include/ && code !~ /include[ \t]*<([a-z_0-9]+|shatterpave\/[a-z_]+[.]h)>/ {
    wrong("public headers include nothing but the standard library and one another")
  }
  # Rooms are not made of the face: they share its words for errors, and the version.
  product && code ~ /^[ \t]*#[ \t]*include[ \t]*[<"]shatterpave\// && big_room != "face" &&
      code !~ /<shatterpave\/(error|version)[.]h>/ {
    wrong("of the public headers rooms include shatterpave/error.h and shatterpave/version.h alone")
  }
  /^[ \t]*#[ \t]*include[ \t]*[<"]glm\// && FILENAME != "src/core/vec.h" { wrong("GLM is included in core/vec.h alone") }
  product && FILENAME != "src/core/parallel.cpp" &&
      (code ~ /std::(async|j?thread)([^:a-z_]|$)/ || code ~ /^[ \t]*#[ \t]*include[ \t]*<(oneapi\/)?tbb/) {
    wrong("threads are started in core/parallel.cpp alone")
  }
  /^[ \t]*#[ \t]*include[ \t]*<(bt[A-Z]|BulletCollision|BulletDynamics|LinearMath)/ && FILENAME != "src/glass/shards/rigid_scene.h" {
    wrong("Bullet is included in glass/shards/rigid_scene.h alone")
  }
  /^[ \t]*#[ \t]*include[ \t]*<OpenEXR\// && !(FILENAME ~ /scene\/field_picture/) {
    wrong("OpenEXR is included in scene/field_picture alone")
  }
  /^[ \t]*#[ \t]*include[ \t]*<png\.h>/ && !(FILENAME ~ /scene\/grey_map_file/) {
    wrong("libpng is included in scene/grey_map_file alone")
  }
  /^[ \t]*#[ \t]*include[ \t]*<proj/ && FILENAME != "src/scene/plans/proj_library.h" {
    wrong("PROJ is included in scene/plans/proj_library.h alone, which opens it")
  }
  /^[ \t]*#[ \t]*include[ \t]*<(gdal|ogr_|cpl_)/ && FILENAME != "src/scene/plans/gdal_library.h" {
    wrong("GDAL is included in scene/plans/gdal_library.h alone, which opens it")
  }
  /^[ \t]*#[ \t]*include[ \t]*<OpenImageIO\// && big_room != "relief" && !(FILENAME ~ /^tests\/(render|relief)\//) {
    wrong("OpenImageIO is included in relief alone")
  }
  product && code ~ /(^|[^_a-zA-Z0-9:.>])(std::|glm::|::)?(sinh?|cosh?|tanh?|asinh?|acosh?|atanh?|atan2|exp2?|expm1|log(2|10|1p)?|pow|cbrt|hypot|tgamma|lgamma|erfc?)[ \t]*\(/ {
    wrong("the C library'"'"'s functions differ between processors; use core/functions.h")
  }
  product && code ~ /std::[a-z_]+_distribution|std::random_device|std::(default_random_engine|mt19937)/ {
    wrong("draws are made by address, with core/random.h")
  }
  product && big_room != "cli" && code ~ /std::(cout|cerr|clog)|(^|[^a-zA-Z_:])(fmt::print|f?printf|puts)[ \t]*\(/ {
    wrong("only cli prints")
  }
  END { exit failures > 0 }'
