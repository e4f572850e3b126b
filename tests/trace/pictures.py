#!/usr/bin/env python3
"""Pictures for tests of tracing, written as PNG without any library for pictures.

    pictures.py KIND FILE     blank, noise, bricks, pixel, huge, broken
    pictures.py degrade IN.ppm OUT.png NOISE      adds noise of that many levels (SD)
"""
import struct
import sys
import zlib

import numpy


def write_png(name, pixels):
    height, width = pixels.shape[:2]
    colours = 2 if pixels.ndim == 3 else 0
    rows = numpy.hstack([numpy.zeros((height, 1), numpy.uint8), pixels.reshape(height, -1)])

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    with open(name, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, colours, 0, 0, 0)))
        file.write(chunk(b"IDAT", zlib.compress(rows.tobytes(), 1)) + chunk(b"IEND", b""))


def bricks(size=700):
    rng = numpy.random.default_rng(3)
    wall = numpy.full((size, size), 110.0)
    for row in range(size // 50 + 1):
        wall[row * 50:row * 50 + 5] += 70
        for column in range(size // 100 + 2):
            x = column * 100 - (50 if row % 2 else 0)
            if 0 <= x < size:
                wall[row * 50:row * 50 + 50, x:x + 5] = 180
    return wall + rng.normal(0, 8, wall.shape)


def read_ppm(name):
    with open(name, "rb") as file:
        data = file.read()
    lines = [line for line in data[:200].split(b"\n") if not line.startswith(b"#")]  # POV-Ray signs its pictures
    width, height = (int(word) for word in b" ".join(lines).split()[1:3])
    return numpy.frombuffer(data[-width * height * 3:], numpy.uint8).reshape(height, width, 3)


def main():
    kind, name = sys.argv[1:3]
    if kind == "degrade":
        rng = numpy.random.default_rng(5)
        picture = read_ppm(name).astype(float)
        write_png(sys.argv[3], numpy.clip(picture + rng.normal(0, float(sys.argv[4]), picture.shape), 0, 255).astype(numpy.uint8))
    elif kind == "blank":
        write_png(name, numpy.full((400, 400), 130, numpy.uint8))
    elif kind == "noise":
        rng = numpy.random.default_rng(1)
        write_png(name, numpy.clip(rng.normal(120, 25, (400, 400)), 0, 255).astype(numpy.uint8))
    elif kind == "bricks":
        write_png(name, numpy.clip(bricks(), 0, 255).astype(numpy.uint8))
    elif kind == "pixel":
        write_png(name, numpy.zeros((1, 1), numpy.uint8))
    elif kind == "huge":
        write_png(name, numpy.zeros((10000, 10000), numpy.uint8))
    elif kind == "broken":
        write_png(name, numpy.zeros((300, 300), numpy.uint8))
        with open(name, "r+b") as file:
            file.truncate(60)
    else:
        sys.exit(f"unknown kind {kind}")


if __name__ == "__main__":
    main()
