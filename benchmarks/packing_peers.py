#!/usr/bin/env python3
"""Square packing beside gmsh 4.8.4, as whole processes with one thread each, in one run.

The plan is the quarter annulus of radii 4 m and 10 m with rows along circles, at about 1,000, 7,000 and 75,000 stones. Both
write their result to a file. The peer is run as a user would, `gmsh -2 -algo pack` with everything recombined, by its simple
recombination (Blossom) and by Mesh.RecombinationAlgorithm=3 (Blossom, full quad).

   benchmarks/packing_peers.py [--runs N] [--cells N …] [--million] [--command build/shatterpave]

Seconds are those of the processor, user and system, of the fastest of N runs; wall is the shortest from start to end. On a
busy machine only the former can be compared. Misalignment is that of the sides of whole stones, or of quadrilaterals, against
the field at the middle of the side, weighted by length: the same measure for both.
"""
import argparse
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time

INNER_MM, OUTER_MM = 4000.0, 10000.0
JOINT_MM = 2.0
AREA_MM2 = math.pi / 4 * (OUTER_MM**2 - INNER_MM**2)
CELLS = (1000, 7000, 75000)


def scene(cells):
    """The annulus with a pitch for about so many stones."""
    steps = 200
    at = [i / steps * math.pi / 2 for i in range(steps + 1)]
    outline = [(OUTER_MM * math.cos(a), OUTER_MM * math.sin(a)) for a in at]
    outline += [(INNER_MM * math.cos(a), INNER_MM * math.sin(a)) for a in reversed(at)]
    joint = min(JOINT_MM, 0.1 * math.sqrt(AREA_MM2 / cells))
    stone = math.sqrt(AREA_MM2 / cells) - joint
    points = ", ".join(f"[{x:.3f}, {y:.3f}]" for x, y in outline)
    return (
        f'seed = 7\n[[pavement]]\nname = "annulus"\noutline_mm = [{points}]\nstone_mm = [{stone:.4f}, {stone:.4f}]\n'
        f'joint_mm = {joint:.4f}\n[pavement.direction]\nkind = "radial"\ncentre_mm = [0, 0]\n'
    )


def geometry(cells):
    """The same for gmsh, with the same spacing."""
    h = math.sqrt(AREA_MM2 / cells)
    corners = ((0, 0), (INNER_MM, 0), (OUTER_MM, 0), (0, OUTER_MM), (0, INNER_MM))
    points = "".join(f"Point({i + 1}) = {{{x}, {y}, 0, {h:.4f}}};\n" for i, (x, y) in enumerate(corners))
    return points + (
        "Line(1) = {2, 3}; Circle(2) = {3, 1, 4}; Line(3) = {4, 5}; Circle(4) = {5, 1, 2};\n"
        "Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};\nMesh.RecombineAll = 1;\n"
    )


def fastest(command, runs):
    """Processor and wall seconds, each the least of the runs, and the most memory (MB)."""
    cpu = wall = math.inf
    memory = 0
    for _ in range(runs):
        start = time.monotonic()
        with tempfile.TemporaryFile() as messages:  # a pipe that nobody reads could fill
            process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=messages)
            _, status, usage = os.wait4(process.pid, 0)
            wall = min(wall, time.monotonic() - start)
            process.returncode = os.waitstatus_to_exitcode(status)
            if process.returncode != 0:
                messages.seek(0)
                sys.exit(f"{' '.join(command)}: exit status {process.returncode}\n{messages.read().decode()}")
        cpu = min(cpu, usage.ru_utime + usage.ru_stime)
        memory = max(memory, usage.ru_maxrss / 1000)
    return cpu, wall, memory


def stones(path):
    """Outlines of whole stones, and how many stones there are."""
    layout = json.loads(path.read_text())["pavements"][0]["stones"]
    return [s["outline_mm"] for s in layout if s["kind"] == "whole"], len(layout)


def quadrilaterals(path):
    """Faces of a mesh in MSH 2.2 text, and how many there are."""
    lines = iter(path.read_text().splitlines())
    nodes, faces = {}, []
    for line in lines:
        if line == "$Nodes":
            for _ in range(int(next(lines))):
                number, x, y, _ = next(lines).split()
                nodes[number] = (float(x), float(y))
        if line == "$Elements":
            for _ in range(int(next(lines))):
                _, kind, tags, *rest = next(lines).split()
                if kind in ("2", "3"):  # triangle, quadrilateral
                    faces.append([nodes[n] for n in rest[int(tags):]])
    return faces, len(faces)


def misalignment(outlines):
    """Mean and 95th percentile of the least angle between a side and the field, in degrees, weighted by length."""
    sides = []
    for outline in outlines:
        for (x0, y0), (x1, y1) in zip(outline, outline[1:] + outline[:1]):
            angle = math.degrees(math.atan2(y1 - y0, x1 - x0) - math.atan2(y0 + y1, x0 + x1)) % 90.0
            sides.append((min(angle, 90.0 - angle), math.hypot(x1 - x0, y1 - y0)))
    sides.sort()
    total = sum(weight for _, weight in sides)
    mean = sum(angle * weight for angle, weight in sides) / total
    passed = 0.0
    for angle, weight in sides:
        passed += weight
        if passed >= 0.95 * total:
            return mean, angle
    return mean, sides[-1][0]


def print_row(name, count, seconds, outlines, before):
    cpu, wall, memory = seconds
    mean, p95 = misalignment(outlines)
    four = sum(len(o) == 4 for o in outlines) / len(outlines)
    growth = f"{math.log(cpu / before[1]) / math.log(count / before[0]):.2f}" if before else ""
    times = f"{cpu:>8.3f} {wall:>8.3f} {count / cpu:>9.0f} {growth:>7}"
    print(f"{name:<24} {count:>8} {times} {mean:>6.2f} {p95:>6.2f} {100 * four:>6.1f}% {memory:>6.0f}", flush=True)
    return count, cpu


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--runs", type=int, default=5, help="of each; the fastest counts (5)")
    options.add_argument("--cells", type=int, nargs="+", default=CELLS, help="about how many, for each row of the table")
    options.add_argument("--million", action="store_true", help="also lay a million stones, on all processors")
    options.add_argument("--command", default=str(root / "build" / "shatterpave"))
    chosen = options.parse_args()
    print(f"{'':<24} {'cells':>8} {'seconds':>8} {'wall':>8} {'cells/s':>9} {'growth':>7} {'mean °':>6} {'p95 °':>6} {'4-sided':>7} {'MB':>6}")
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)

        def ours(cells, threads, runs, before):
            (work / "annulus.toml").write_text(scene(cells))
            command = [chosen.command, "export", str(work / "annulus.toml"), "-o", folder, "--target", "json", *threads]
            seconds = fastest(command, runs)
            outlines, count = stones(work / "annulus.json")
            return print_row("shatterpave", count, seconds, outlines, before)

        def peer(cells, algorithm, before):
            (work / "annulus.geo").write_text(geometry(cells))
            command = ["gmsh", "-2", "-algo", "pack", "-nt", "1", "-v", "1", "-format", "msh2", "-o", str(work / "annulus.msh")]
            command += ["-setnumber", "Mesh.RecombinationAlgorithm", str(algorithm), str(work / "annulus.geo")]
            seconds = fastest(command, chosen.runs)
            outlines, count = quadrilaterals(work / "annulus.msh")
            return print_row(f"gmsh, recombination {algorithm}", count, seconds, outlines, before)

        before = {}
        for cells in chosen.cells:
            before["ours"] = ours(cells, ["--threads", "1"], chosen.runs, before.get("ours"))
            for algorithm in (3, 1):
                before[algorithm] = peer(cells, algorithm, before.get(algorithm))
        if chosen.million:
            print(f"on {os.cpu_count()} processors:")
            ours(1_000_000, [], 1, None)


if __name__ == "__main__":
    main()
