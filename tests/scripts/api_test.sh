#!/usr/bin/env bash
# The API page of the public headers is made without a warning, and holds what users look for; and it would not be made if a
# public function had no comment.
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"

quietly "the API page is not made" "$root/docs/api.sh" "$scratch/api"
[[ $(<"$scratch/log") == "$scratch/api/html/index.html" ]] || fail "more was said than where the page is"
[[ -s $scratch/api/html/index.html ]] || fail "there is no page"
for thing in Scene Model Pane Pavement InputError Value; do
  compgen -G "$scratch/api/html/*shatterpave_1_1$thing.html" >/dev/null || fail "there is no page of $thing"
done
for function in generate export_files write_targets write_files targets; do
  grep -q ">$function<" "$scratch/api/html/namespaceshatterpave.html" || fail "$function is not on the page of the namespace"
done

mkdir "$scratch/bare"
cp -r "$root/include" "$root/docs" "$root/examples" "$scratch/bare/"
sed -i 's|^double area(const Polygon|int unexplained(int number);\n\n/// Area.\n&|' "$scratch/bare/include/shatterpave/geometry.h"
grep -q unexplained "$scratch/bare/include/shatterpave/geometry.h" || fail "the twin is not made"
sed -i '/^\/\/\/ Signed area of a polygon/d' "$scratch/bare/include/shatterpave/geometry.h"
if "$scratch/bare/docs/api.sh" "$scratch/other" >"$scratch/log" 2>&1; then fail "a function without a comment is no error"; fi
grep -q 'unexplained.*not documented' "$scratch/log" || fail "another error was expected"
