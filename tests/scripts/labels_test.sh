#!/usr/bin/env bash
# Every test has one label of tests/labels.cmake, each label has tests, and what is fast runs no other program.
#   labels_test.sh BUILD   the build folder
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"
ctest --test-dir "$build" --show-only=json-v1 | python3 -c '
import collections, json, sys
tests = json.load(sys.stdin)["tests"]
known = {"fast", "slow", "render", "readers", "statistics"}
count = collections.Counter()
for test in tests:
    properties = {p["name"]: p["value"] for p in test.get("properties", [])}
    labels = properties.get("LABELS", [])
    assert len(labels) == 1 and labels[0] in known, (test["name"], labels)
    count[labels[0]] += 1
    name = test["name"]
    if labels[0] == "fast":
        assert not any(word in name for word in ("Render", "scripts.", "Fuzz.", "Command.")), name
        assert "image_tests" not in test["command"][0], name
assert set(count) == known, count
assert count["fast"] > sum(count.values()) / 2, count
print(*(f"{label}: {number}" for label, number in sorted(count.items())), sep=", ")
'
