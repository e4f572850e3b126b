#!/usr/bin/env python3
"""A table of the lines that .ci/long/trace prints: how many panes of each condition hold what is promised."""
import sys
from collections import defaultdict
from statistics import mean

groups = defaultdict(list)
refused = defaultdict(int)
for line in open(sys.argv[1]):
    words = line.split()
    if "refused:" in words:
        refused[words[0]] += 1
        groups[words[0]]
        continue
    condition, _, m, n, found, low, high, reach = words[:8]
    off, ring, traced, false = (float(part) for part in " ".join(words[9:]).split("|"))
    groups[condition].append((int(m), int(n), int(found), int(low), int(high), int(reach), off, ring, traced, false))
print(f"{'condition':16} {'panes':>5} {'refused':>7} {'impact 3 px':>11} {'M 8 %':>6} {'M between':>9} {'N exact':>7} {'N ±1':>5} "
      f"{'ring 2 %':>8} {'found %':>8} {'false %':>8}")
for condition, rows in groups.items():
    total = len(rows) + refused[condition]
    ring = [abs(r[7]) <= 2 for r in rows if r[7] == r[7]]
    print(f"{condition:16} {total:5} {refused[condition]:7} {sum(r[6] <= 3 for r in rows):11} "
          f"{sum(abs(r[2] - r[0]) <= 0.08 * r[0] for r in rows):6} {sum(r[3] <= r[0] <= r[4] for r in rows):9} "
          f"{sum(r[1] == r[5] for r in rows):7} {sum(abs(r[1] - r[5]) <= 1 for r in rows):5} {sum(ring):4}/{len(ring):<3} "
          f"{mean(r[8] for r in rows) if rows else 0:8.1f} {mean(r[9] for r in rows) if rows else 0:8.1f}")
