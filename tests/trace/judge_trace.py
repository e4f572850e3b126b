#!/usr/bin/env python3
"""Sets a traced pane beside the pane that was photographed, and prints one line:

    judge_trace.py TRUTH.json TRACE.json WIDTH HEIGHT [VISIBLE.ppm]

name M N found M low high N | impact off px | ring radius off % | traced of what shows % | false of what was traced %

The photograph shows the whole pane straight, WIDTH x HEIGHT px. What shows: where VISIBLE, a picture without noise, has 8 levels of
contrast or more within 5 px. A traced line is true within 2 px of a crack, or within the ribbon that shows. Within the circle on
which the truth's radials lie nearer to one another than 6 px, nothing is judged.
"""
import json
import math
import sys

import numpy


def polylines(pane, scale, height):
    for crack in pane["cracks"]:
        yield crack["kind"], [(x * scale, height - y * scale) for x, y in crack["points_mm"]]


def samples(line, step=0.5):
    result = []
    for (ax, ay), (bx, by) in zip(line, line[1:]):
        count = max(int(math.hypot(bx - ax, by - ay) / step), 1)
        t = (numpy.arange(count) + 0.5) / count
        result.append(numpy.stack([ax + t * (bx - ax), ay + t * (by - ay)], 1))
    return numpy.concatenate(result) if result else numpy.zeros((0, 2))


def near(mask, reach):
    grown = mask.copy()
    for dy in range(-reach, reach + 1):
        for dx in range(-reach, reach + 1):
            if dx * dx + dy * dy <= reach * reach + 0.5:
                grown |= numpy.roll(numpy.roll(mask, dy, 0), dx, 1)
    return grown


def drawn(points, shape):
    mask = numpy.zeros(shape, bool)
    at = numpy.floor(points).astype(int)
    good = (at >= 0).all(1) & (at[:, 0] < shape[1]) & (at[:, 1] < shape[0])
    mask[at[good, 1], at[good, 0]] = True
    return mask


def share(points, mask):
    at = numpy.floor(points).astype(int)
    at[:, 0] = at[:, 0].clip(0, mask.shape[1] - 1)
    at[:, 1] = at[:, 1].clip(0, mask.shape[0] - 1)
    return mask[at[:, 1], at[:, 0]]


def contrast(name):
    from pictures import read_ppm
    levels = read_ppm(name).astype(float) @ [0.299, 0.587, 0.114]
    low, high = levels.copy(), levels.copy()
    for axis in (0, 1):
        base_low, base_high = low.copy(), high.copy()
        for shift in range(-5, 6):
            low = numpy.minimum(low, numpy.roll(base_low, shift, axis))
            high = numpy.maximum(high, numpy.roll(base_high, shift, axis))
    return levels, high - low


def main():
    truth = json.load(open(sys.argv[1]))["panes"][0]
    trace = json.load(open(sys.argv[2]))["panes"][0]
    width, height = int(sys.argv[3]), int(sys.argv[4])
    scale = width / max(x for x, _ in truth["outline_mm"])
    impact = truth["impacts"][0]
    centre = numpy.array([impact["at_mm"][0] * scale, height - impact["at_mm"][1] * scale])
    found = trace["impacts"][0]
    low, high = trace["photograph"]["radial_interval"]
    off = math.dist(trace["photograph"]["impact_px"], centre)
    reaching = sum(c["kind"] in ("large", "radial") and c["end"]["at"] == "edge" for c in truth["cracks"])

    radials = impact["radial_count"]
    dense = max(6.0 * radials / (2 * math.pi), 30.0)
    scale_trace = width / max(x for x, _ in trace["outline_mm"])
    real = numpy.concatenate([samples(line) for _, line in polylines(truth, scale, height)])
    lines = numpy.concatenate([samples(line) for _, line in polylines(trace, scale_trace, height)])
    real = real[numpy.hypot(*(real - centre).T) > dense]
    lines = lines[numpy.hypot(*(lines - centre).T) > dense]
    true_ground = near(drawn(real, (height, width)), 2)
    if len(sys.argv) > 5:
        levels, shown = contrast(sys.argv[5])
        real = real[share(real, shown >= 8.0)]
        # The ribbon that shows beside a crack: what differs from the ground by 8 levels and more, within 12 px of it.
        ground = numpy.median(levels)
        true_ground |= near(drawn(samples_near(real), (height, width)), 12) & (abs(levels - ground) >= 8.0)
    traced = 100.0 * share(real, near(drawn(lines, (height, width)), 2)).mean() if len(real) else 0.0
    false = 100.0 * (1.0 - share(lines, true_ground).mean()) if len(lines) else 0.0

    def ring_mean(pane, k):
        points = [samples(line) for kind, line in polylines(pane, k, height) if kind == "circular"]
        return numpy.hypot(*(numpy.concatenate(points) - centre).T).mean() if points else None

    rings = ring_mean(truth, scale), ring_mean(trace, scale_trace)
    ring = 100.0 * (rings[1] / rings[0] - 1.0) if all(rings) else float("nan")
    print(f"{radials} {reaching} {found['radial_count']} {low} {high} {found['large_count']} | {off:.1f} | {ring:.1f} | "
          f"{traced:.1f} | {false:.1f}")


def samples_near(points):
    return points


if __name__ == "__main__":
    main()
