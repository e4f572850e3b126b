#!/usr/bin/env python3
"""Corners of the pane in a photograph of photograph.pov, a word each: upper left, upper right, lower right, lower left.

    corners.py TILT SIZE      degrees, as Declare=Tilt; px of the square picture
"""
import math
import sys

tilt, size = float(sys.argv[1]), float(sys.argv[2])
side = 300.0
away, half = 4 * side, (side if tilt == 0 else 1.16 * side) / 2


def turn(point, about_x, about_y):
    """POV-Ray's rotate: left-handed, about x first."""
    x, y, z = point
    c, s = math.cos(math.radians(about_x)), math.sin(math.radians(about_x))
    y, z = y * c - z * s, y * s + z * c
    c, s = math.cos(math.radians(about_y)), math.sin(math.radians(about_y))
    return x * c + z * s, y, z * c - x * s


eye = turn((0, 0, -away), tilt / 2, tilt)
forward = [-e / away for e in eye]
right = [forward[2], 0, -forward[0]]  # up × forward, in left-handed space
length = math.hypot(right[0], right[2])
right = [r / length for r in right]
up = [forward[1] * right[2] - forward[2] * right[1], forward[2] * right[0] - forward[0] * right[2],
      forward[0] * right[1] - forward[1] * right[0]]
for x, y in ((-1, 1), (1, 1), (1, -1), (-1, -1)):
    # The face towards the viewer.
    p = [x * side / 2 - eye[0], y * side / 2 - eye[1], -1 - eye[2]]
    depth = sum(a * b for a, b in zip(p, forward))
    u = sum(a * b for a, b in zip(p, right)) / depth * away / half
    v = sum(a * b for a, b in zip(p, up)) / depth * away / half
    print(f"{size * (1 + u) / 2:.2f},{size * (1 - v) / 2:.2f}")
