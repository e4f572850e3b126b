#!/usr/bin/python3
"""Judges layouts with shapely (GEOS), which the product has nothing in common with.

   judge_layouts.py < LINES                                  lines as random_layouts writes them
   judge_layouts.py --run PROGRAM --first N --count M [--processes P] [--rare|--sized] [FILE.geojson ...]     runs random_layouts itself
   judge_layouts.py --self-test < LINES                      sound layouts are spoilt: each must be found out

Prints how many layouts there were of each bond and field and what is wrong with them, the worst of each fault with the scenes that make
them, and the largest stones of the bonds whose stones differ by design. Exit status 1 where anything is wrong.

Faults, each exact in micrometres or with the tolerance that stands below:
   failed     the program ended otherwise than by laying or by refusing
   invalid    an outline that is not simple or not counter-clockwise
   overlap    stones have inner points in common; its measure is their area in mm2
   touching   stones have points in common, but no inner ones
   outside    a stone leaves the area or enters a hole; mm2
   bare       the widest disc in what is left bare when stones are grown by half a joint and the border's half joint is taken off, over a
              tenth of the stone's longer side and a joint; its measure is the diameter over the longer side. Where the bed is narrower
              than a joint no stone can lie, so discs of a tenth alone are told apart: how many layouts have a wider one, of joints
              up to a tenth of the longer side (at most 1 %), and of wider joints (at most 12 % of those), where
              there are enough layouts to tell. Of stones laid by hand, whose joints are wedges, discs may be wider by what two corners
              that face each other may draw back and lose (hand_room)
   large      a stone fits no stone of its stock at any rotation, or has a larger area; its measure is how many times as large that would
              have to be each way
   measured   where lines hold what the scorer measured: its widest bare spot is another one; mm
"""
import argparse, collections, json, math, multiprocessing, re, subprocess, sys, time
import numpy
from shapely.geometry import Point, Polygon
from shapely.ops import unary_union
from shapely.prepared import prep

UM = 1000.0                  # micrometres in a millimetre: all geometry below is in micrometres, where coordinates are whole numbers
BARE_SHARE = 0.1             # of the stone's longer side
# Of the layouts with such joints: no promise, but what numbers 1 to 2,000 and 5,001 to 7,500 measured (1 of 1,464; 135 of 1,217), so that it
# grows no worse. The aim is none.
MOST_OVER_A_TENTH = {"narrow": 0.01, "wide": 0.12}
LEAST_LAYOUTS = 500          # what a share of this size can be told by; of fewer it is printed, and not judged
GROWTH = 1.02                # joints on bent fields are a little wider than asked for; design: 10 % at the 95th percentile
GROWTH_MM = 0.01             # and stones draw back by a hairline where there is no joint
MITRE = 5.0
FIT_MM = 0.05                # how much larger than its stock a stone may be
MEASURED_MM = 0.1            # how far the scorer's bare spot may be off
KINDS = ("failed", "invalid", "overlap", "touching", "outside", "bare", "large", "measured")


def hexagon_face(pitch, joint):
    half, side = pitch[0] / 2, pitch[1] / math.sqrt(3)
    tile = Polygon([(0, -side), (half, -side / 2), (half, side / 2), (0, side), (-half, side / 2), (-half, -side / 2)])
    return tile.buffer(-joint / 2, join_style=2)


# Of stones laid by hand (docs/scene-file.md, "Laid by hand"). A line moves by at most so much of the stones beside it, so that they are
# so much larger; the end of a side lies at most four half joints from the middle of its joint, so it draws back by three; a corner
# goes with the two sides that meet there, of a right angle by the square root of two as far, and not farther than an eighth of the
# shorter side at it, or its half joint.
MOST_ASIDE = 0.22
MOST_BACK = 1.5 * math.sqrt(2.0)
MOST_INWARDS = 0.12
USUAL_ROUNDED, USUAL_NIBBLED, NIBBLE, MOST_CUT = 0.1, 0.25, 2.2, 0.45


def hand_growth(layout):
    return 1.0 + 2.0 * layout.get("by_hand", 0.0) * MOST_ASIDE


def hand_room(layout):
    """How much wider a bare disc may be than between stones laid by the line, mm."""
    amount, joint = layout.get("by_hand", 0.0), layout["joint_mm"]
    if amount == 0.0:
        return 0.0
    stones = [layout["stone_mm"]] + ([layout["border_stone_mm"]] if layout["border"] != "none" else [])
    side = hand_growth(layout) * (max(min(s) for s in stones) + joint)
    back = min(MOST_BACK * joint, max(MOST_INWARDS * side, joint / 2))
    # A corner is cut off by at most `cut` along both of its sides, a nibbled one by more along one of them; the parabola in its place
    # is a quarter of the diagonal away from it.
    cut = 1.5 * layout.get("rounded", USUAL_ROUNDED * amount)
    longer = NIBBLE * max(cut, 0.5 * USUAL_ROUNDED) if layout.get("nibbled", USUAL_NIBBLED * amount) > 0.0 else cut
    shorter = max(cut, 0.4 * longer)
    return 2.0 * (back + 0.25 * math.hypot(min(longer, MOST_CUT), min(shorter, MOST_CUT)) * side)


class Stock:
    """The rectangles, mm, that a stone must fit one of, and the largest area, mm2."""

    def __init__(self, rectangles, area=None):
        self.rectangles = rectangles
        self.area = area or max(a * b for a, b in rectangles)


# Of bonds whose stones differ by design: how many times as long or wide, and as large, as stone_mm a stone may be (docs/bonds.md;
# of arcs, whose stones at the ends are larger, by what the whole ones of many are, and some room).
DIFFERING = {"packed": (1.5, 2.25), "crazy": (2.0, 2.0), "segmental_arc": (1.6, 1.5)}


def fan_faces(pitch, joint, span):
    """(face, direction along its ring) of each stone of a fan, by what docs/bonds.md tells: rings about its foot, at (0, 0), which end on
    the backs of the two fans before it, arcs of the fan's own radius. Lines have corners where perpends end on them, no others."""
    radius = span / math.sqrt(3)
    rings = max(1, math.floor(radius / pitch[1] + 0.5))
    radii = [radius * k / rings for k in range(rings + 1)]

    def polar(r, angle):
        return numpy.array([r * math.sin(angle), r * math.cos(angle)])

    def perpends(k):
        middle = (radii[k] + radii[k + 1]) / 2
        half = math.acos(-middle / radius / 2) - math.pi / 3
        wanted = 2 * half * middle / pitch[0]
        like = 2 * math.floor((wanted - 1 - k % 2) / 2 + 0.5) + 1 + k % 2
        count = max(1, like if like and abs(wanted / like - 1) <= 0.18 else math.floor(wanted + 0.5))
        return [half * (2 * i / count - 1) for i in range(1, count)]

    at = [perpends(k) for k in range(rings)]
    # Of each ring's lower line, where it ends on the back of the fan to its right: as an angle about the foot of that one.
    landings = [math.pi / 3 - 2 * (math.pi / 2 - math.acos(r / radius / 2)) for r in radii]
    stops = [sorted(at[k] + (at[k - 1] if k else [])) for k in range(rings)]
    stops.append(sorted(at[-1] + [x for k in range(1, rings) for x in (landings[k], -landings[k])] + [0.0]))

    def on_side(angle, sign):
        x, y = numpy.array([span / 2, -radius / 2]) + polar(radius, -angle)
        return numpy.array([sign * x, y])

    for k in range(rings):
        for i in range(len(at[k]) + 1):
            left, right = i == 0, i == len(at[k])
            low, high = -math.pi if left else at[k][i - 1], math.pi if right else at[k][i]
            points = [on_side(landings[k], -1) if left else polar(radii[k], low)]
            points += [polar(radii[k], x) for x in stops[k] if low < x < high]
            points.append(on_side(landings[k], 1) if right else polar(radii[k], high))
            back = [x for x in stops[-1] if min(landings[k:k + 2]) < x < max(landings[k:k + 2])]
            if right:
                points += [on_side(x, 1) for x in sorted(back, reverse=landings[k] > landings[k + 1])]
            points.append(on_side(landings[k + 1], 1) if right else polar(radii[k + 1], high))
            points += [polar(radii[k + 1], x) for x in reversed(stops[k + 1]) if low < x < high]
            points.append(on_side(landings[k + 1], -1) if left else polar(radii[k + 1], low))
            if left:
                points += [on_side(x, -1) for x in sorted(back, reverse=landings[k] < landings[k + 1])]
            tile = Polygon(points).buffer(0)
            x, y = tile.centroid.x, tile.centroid.y
            face = tile.buffer(-joint / 2, join_style=2, mitre_limit=MITRE)
            for part in getattr(face, "geoms", [face]):
                if not part.is_empty:
                    yield part, math.atan2(-x, y)


def largest_of(faces):
    sides, area = numpy.zeros(2), 0.0
    for face, angle in faces:
        u, v = extents(numpy.array(face.exterior.coords), numpy.array([angle]))
        sides, area = numpy.maximum(sides, [u[0], v[0]]), max(area, face.area)
    return Stock([tuple(sides)], area)


# Of whose bonds each stone is stone_mm; of packed ones in one direction.
PLAIN = ("packed", "running", "stack", "herringbone", "course")


def field_stock(layout):
    """What stone_mm means to each bond (docs/bonds.md), and whether all its stones are of it."""
    (a, b), joint, bond = layout["stone_mm"], layout["joint_mm"], layout["bond"]
    pitch = (a + joint, b + joint)
    if bond == "basket_weave":
        return Stock([(a, pitch[0] / max(1, math.floor(pitch[0] / pitch[1] + 0.5)) - joint)]), True
    if bond == "hexagon":
        face = hexagon_face(pitch, joint)
        low_x, low_y, high_x, high_y = face.bounds
        return Stock([(high_x - low_x, high_y - low_y)], face.area), True
    if bond == "ashlar":
        return Stock([(k * pitch[0] - joint, l * pitch[1] - joint) for k, l in ((3, 2), (2, 3))]), True
    if bond == "chevron":
        return Stock([(a + b, b)], a * b), True
    if bond == "fan":
        given = re.search(r"^bond_span_mm = ([0-9.]+)", layout["toml"], re.M)
        return largest_of(fan_faces(pitch, joint, float(given[1]) if given else 12 * pitch[0])), False
    if bond in DIFFERING and (bond != "packed" or layout["field"] != "constant"):
        sides, areas = DIFFERING[bond]
        return Stock([(sides * a, sides * b)], areas * a * b), False
    if bond in PLAIN:
        return Stock([(a, b)]), True
    sys.exit(f"judge_layouts.py: the stock of bond {bond} is not told")


def hand_stock(stock, layout):
    """What stones laid by hand are cut from, where others are cut from `stock`."""
    if layout.get("by_hand", 0.0) == 0.0:
        return stock
    growth, joint = hand_growth(layout), layout["joint_mm"]
    return Stock([(growth * (a + joint), growth * (b + joint)) for a, b in stock.rectangles])


def extents(points, angles):
    """Lengths along and across each of the angles."""
    along = numpy.stack([numpy.cos(angles), numpy.sin(angles)])
    across = numpy.stack([-along[1], along[0]])
    u, v = points @ along, points @ across
    return u.max(0) - u.min(0), v.max(0) - v.min(0)


def excess(points, rectangles):
    """How many times larger than one of the rectangles (um) it would have to be at the best rotation; <= 1 fits."""
    edges = numpy.roll(points, -1, 0) - points
    hull = numpy.array(Polygon(points).convex_hull.exterior.coords)
    edges = numpy.concatenate([edges, numpy.diff(hull, axis=0)])
    angles = numpy.concatenate([numpy.arctan2(edges[:, 1], edges[:, 0]), numpy.linspace(0, math.pi, 361)])
    angles = numpy.concatenate([angles, angles + math.pi / 2])
    best = math.inf
    for a, b in rectangles:
        u, v = extents(points, angles)
        ratio = numpy.maximum(u / a, v / b)
        near = angles[ratio.argmin()] + numpy.linspace(-0.01, 0.01, 201)  # between two of the scan
        u, v = extents(points, near)
        best = min(best, ratio.min(), numpy.maximum(u / a, v / b).min())
    return best


def near_pairs(boxes):
    """Pairs of boxes with a point in common."""
    order = numpy.argsort(boxes[:, 0], kind="stable")
    left, low, right, high = boxes[order].T
    ends = numpy.searchsorted(left, right, side="right")  # of each, those after it that begin before it ends
    for i in range(len(order)):
        others = slice(i + 1, ends[i])
        for k in numpy.flatnonzero((low[others] <= high[i]) & (high[others] >= low[i])):
            yield order[i], order[i + 1 + k]


def edges_cross(a, b):
    """Whether a side of one crosses a side of the other within both: exact, in whole numbers."""
    def side(p, q, r):
        d = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
        return (d > 0) - (d < 0)
    for p, q in zip(a, a[1:] + a[:1]):
        for r, s in zip(b, b[1:] + b[:1]):
            if side(p, q, r) * side(p, q, s) < 0 and side(r, s, p) * side(r, s, q) < 0:
                return True
    return False


def twice_area(ring):
    (x0, y0) = ring[0]
    return sum((p[0] - x0) * (q[1] - y0) - (q[0] - x0) * (p[1] - y0) for p, q in zip(ring, ring[1:] + ring[:1]))


def climbed(part, middle, least_step):
    """The diameter of the disc about a place near `middle` that no place about it beats, and that place."""
    border = part.boundary
    reach, step = border.distance(middle), border.distance(middle)
    while step > least_step:
        around = [Point(middle.x + step * x, middle.y + step * y) for x in (-1, 0, 1) for y in (-1, 0, 1)]
        best = max((p for p in around if part.contains(p)), key=border.distance)  # the middle itself is one of them
        if border.distance(best) > reach:
            reach, middle = border.distance(best), best
        else:
            step /= 2
    return 2 * reach, middle


def widest_disc(shape, corners=4):
    """Its diameter and its middle; `corners` to a quarter of a circle."""
    parts = [p for p in getattr(shape, "geoms", [shape]) if p.area > 0]
    best, middle = 0.0, None
    for part in sorted(parts, key=lambda p: -p.area):
        high = min(part.bounds[2] - part.bounds[0], part.bounds[3] - part.bounds[1])
        if high <= best or part.buffer(-best / 2, 2).is_empty:
            continue
        low = best
        for _ in range(16):
            half = (low + high) / 2
            left = part.buffer(-half / 2, corners)
            if left.is_empty:
                high = half
            else:
                low, middle = half, left.representative_point()
        best = low
        # Buffers of slim parts end too early: what is left at the last is a place to climb from.
        if middle is not None and part.contains(middle):
            best, middle = max((best, middle), climbed(part, middle, 5.0), key=lambda disc: disc[0])
    return best, middle


def bare(area, stones, layout, growth):
    joint = layout["joint_mm"] * UM
    inner = area.buffer(-joint / 2, join_style=2, mitre_limit=MITRE) if joint > 0 else area
    grown = unary_union([s.buffer(joint / 2 * growth + GROWTH_MM * UM, join_style=2, mitre_limit=MITRE) for s in stones])
    return inner.difference(grown)


def bare_spot(area, stones, layout, least):
    """Diameter of the widest bare disc, um, if it is over `least`, else 0; and its place, mm."""
    left = bare(area, stones, layout, GROWTH)
    if left.is_empty or left.buffer(-least / 2, 4).is_empty:
        return 0.0, None
    diameter, middle = widest_disc(left)
    return diameter, middle and (middle.x / UM, middle.y / UM)


def faults_of_pairs(stones, rings):
    overlap, touching, pairs = 0.0, 0, 0
    for i, j in near_pairs(numpy.array([s.bounds for s in stones])):
        if not stones[i].intersects(stones[j]):
            continue
        if stones[i].touches(stones[j]) and not edges_cross(rings[i], rings[j]):
            touching += 1
        else:
            overlap += max(stones[i].intersection(stones[j]).area / UM**2, 1e-9)
            pairs += 1
    return overlap, pairs, touching


def sizes(area, stones, layout):
    """The largest excess of stones over their stock; and the largest of those that differ by design, over stone_mm."""
    stock, alike = field_stock(layout)
    alike = alike or layout.get("by_hand", 0.0) > 0.0  # how far those of bonds may differ is told of stones laid by the line
    stock, plain = hand_stock(stock, layout), Stock([layout["stone_mm"]])
    border = hand_stock(Stock([layout["border_stone_mm"]]), layout)
    worst, longest, heaviest, oversized = 0.0, 0.0, 0.0, 0
    for stone, given in zip(stones, layout["stones"]):
        bounded = given["part"] == "border"
        its = border if bounded else stock
        points = numpy.array(given["outline_um"], float)
        allowed = [((a + FIT_MM) * UM, (b + FIT_MM) * UM) for a, b in its.rectangles]
        angle = math.radians(given["angle_deg"])
        u, v = extents(points, numpy.array([angle, angle + math.pi / 2]))
        fits = any((u[k] <= a and v[k] <= b) for a, b in allowed for k in (0, 1))
        over = 0.0 if fits else excess(points, allowed)
        area_over = stone.area / UM**2 / its.area
        # Tolerances are of lengths; over an area they come to as much along both sides.
        if over > 1.0 or area_over > max((1 + FIT_MM / a) * (1 + FIT_MM / b) for a, b in its.rectangles):
            worst = max(worst, over, math.sqrt(area_over))
            oversized += 1
        if not (bounded or alike):
            longest = max(longest, excess(points, [(a * UM, b * UM) for a, b in plain.rectangles]))
            heaviest = max(heaviest, stone.area / UM**2 / plain.area)
    return worst, oversized, longest, heaviest


def as_judged(layout):
    """Where sizes follow a field, stones differ by design, and are held to the largest that is asked for."""
    if "sizes" not in layout:
        return layout
    return dict(layout, field="sized", stone_mm=[layout["sizes"][1] * side for side in layout["stone_mm"]])


def judged(layout):
    """{fault: measure}, and what else is of interest."""
    faults, notes = {}, {"stones": 0, "longest": 0.0, "heaviest": 0.0}
    if "failed" in layout:
        return {"failed": 1.0}, notes
    if "refused" in layout:
        return faults, notes
    area = Polygon(layout["outline_um"], layout["holes_um"])
    rings = [[tuple(p) for p in s["outline_um"]] for s in layout["stones"]]
    stones = [Polygon(ring) for ring in rings]
    notes["stones"] = len(stones)
    bad = [k for k, s in enumerate(stones) if not s.is_valid or twice_area(rings[k]) <= 0]
    if bad:
        faults["invalid"] = float(len(bad))
        notes["invalid"] = bad[:3]
        stones = [s if s.is_valid else s.buffer(0) for s in stones]
    if stones:
        overlap, notes["pairs"], touching = faults_of_pairs(stones, rings)
        if overlap > 0:
            faults["overlap"] = overlap
        if touching:
            faults["touching"] = float(touching)
        prepared = prep(area)
        outside = sum(max(s.difference(area).area / UM**2, 1e-9) for s in stones if not prepared.covers(s))
        if outside > 0:
            faults["outside"] = outside
        worst, notes["oversized"], notes["longest"], notes["heaviest"] = sizes(area, stones, layout)
        if worst > 0:
            faults["large"] = worst
    longer = max(layout["stone_mm"] + (layout["border_stone_mm"] if layout["border"] != "none" else [])) * UM
    if not layout.get("missing"):
        diameter, notes["at_mm"] = bare_spot(area, stones, layout, BARE_SHARE * longer)
        joint = layout["joint_mm"] * UM
        room = hand_room(layout) * UM
        if room == 0.0:
            notes["joints"] = "narrow" if joint <= BARE_SHARE * longer else "wide"
            notes["over_a_tenth"] = diameter > BARE_SHARE * longer
        if diameter > BARE_SHARE * longer + joint + room:
            faults["bare"] = diameter / longer
    if "measured_bare_mm" in layout:
        diameter, _ = widest_disc(bare(area, stones, layout, 1.0), 16)
        off = abs(diameter / UM - layout["measured_bare_mm"])
        if off > MEASURED_MM + 0.002 * diameter / UM:  # a quarter of a circle as 16 sides
            faults["measured"] = off
    return faults, notes


class Tally:
    def __init__(self):
        self.layouts, self.stones, self.wrong = 0, 0, 0
        self.table = collections.defaultdict(collections.Counter)
        self.worst = collections.defaultdict(list)
        self.refusals, self.largest = collections.Counter(), {}
        self.joints, self.over_a_tenth = collections.Counter(), collections.Counter()  # layouts with narrow and with wide joints

    def add(self, layout, faults, notes):
        key = (layout.get("bond", "?"), layout.get("field", "?"))
        row = self.table[key]
        self.layouts += 1
        self.stones += notes["stones"]
        self.wrong += bool(faults)
        row["layouts"] += 1
        if "joints" in notes:
            self.joints[notes["joints"]] += 1
            self.over_a_tenth[notes["joints"]] += notes["over_a_tenth"]
        if "refused" in layout:
            row["refused"] += 1
            self.refusals[re.sub(r"[0-9.]+", "#", layout["refused"])] += 1
        elif notes["stones"] == 0:
            row["empty"] += 1
        for kind, measure in faults.items():
            row[kind] += 1
            worst = self.worst[kind]
            worst.append((measure, str(layout["number"]), layout.get("shape"), layout.get("border"), key, notes.get("at_mm"),
                          layout.get("toml") or layout.get("failed", "")))
            worst.sort(key=lambda w: (-w[0], w[1]))
            del worst[20:]
        for what in ("longest", "heaviest"):
            if notes[what] > 0:
                self.largest[key, what] = max(self.largest.get((key, what), (0.0, "")), (notes[what], str(layout["number"])))

    def merge(self, other):
        self.layouts += other.layouts
        self.stones += other.stones
        self.wrong += other.wrong
        for key, row in other.table.items():
            self.table[key].update(row)
        for kind, worst in other.worst.items():
            self.worst[kind] = sorted(self.worst[kind] + worst, key=lambda w: (-w[0], w[1]))[:20]
        self.refusals.update(other.refusals)
        self.joints.update(other.joints)
        self.over_a_tenth.update(other.over_a_tenth)
        for key, value in other.largest.items():
            self.largest[key] = max(self.largest.get(key, (0.0, "")), value)

    def answers_shares(self):
        return self.layouts >= LEAST_LAYOUTS

    def is_sound(self):
        return self.wrong == 0 and not (self.answers_shares() and any(self.over_a_tenth[j] > most * self.joints[j] for j, most in MOST_OVER_A_TENTH.items()))

    def report(self, scenes):
        columns = ("layouts", "refused", "empty") + KINDS
        print(f"{'bond':15}{'field':10}" + "".join(f"{c:>10}" for c in columns))
        total = collections.Counter()
        for key in sorted(self.table):
            row = self.table[key]
            total.update(row)
            print(f"{key[0]:15}{key[1]:10}" + "".join(f"{row[c]:>10}" for c in columns))
        print(f"{'all':25}" + "".join(f"{total[c]:>10}" for c in columns))
        for text, count in self.refusals.most_common(10):
            print(f"refused {count} times: {text}")
        for key in sorted({k for k, _ in self.largest}):
            longest, heaviest = self.largest.get((key, "longest"), (0, "")), self.largest.get((key, "heaviest"), (0, ""))
            print(f"largest stone of {key[0]}, {key[1]}: {longest[0]:.3f} times as long or wide as stone_mm (number {longest[1]}), "
                  f"{heaviest[0]:.3f} times its area (number {heaviest[1]})")
        for kind in KINDS:
            for measure, number, shape, border, key, at, toml in self.worst[kind][:scenes]:
                place = f" at ({at[0]:.1f}, {at[1]:.1f})" if at and kind == "bare" else ""
                print(f"\n# {kind} {measure:.6g}{place}: number {number}, {key[0]}, {key[1]}, {shape}, border {border}\n{toml.strip()}")
        for joints, most in MOST_OVER_A_TENTH.items():
            print(f"\nbare discs over a tenth of the longer side in {self.over_a_tenth[joints]} of {self.joints[joints]} layouts with {joints} joints "
                  f"({f'at most {most:.0%}' if self.answers_shares() else 'too few layouts to judge'})", end="")
        print(f"\n{self.layouts} layouts of {self.stones} stones: " +
              ", ".join(f"{total[k]} {k}" for k in KINDS) + f"; {self.wrong} layouts wrong")


def lines_of(program, first, count, files):
    """The lines of a range; where the program dies, those before, and a line that says so in place of the one that it died of."""
    while count > 0:
        run = subprocess.run([program, "--first", str(first), "--count", str(count), *files], capture_output=True, text=True)
        lines = [line for line in run.stdout.splitlines(True) if line.endswith("\n")]
        yield from lines
        first, count = first + len(lines), count - len(lines)
        if run.returncode != 0 and count > 0:
            yield json.dumps({"number": first, "failed": f"status {run.returncode}: {run.stderr.strip()[-300:]}"})
            first, count = first + 1, count - 1


def tally_of(lines):
    tally = Tally()
    for line in lines:
        layout = as_judged(json.loads(line))
        tally.add(layout, *judged(layout))
    return tally


def tally_of_range(task):
    return tally_of(lines_of(*task))


def spoilt(layout):
    """Twins of a sound layout with one fault each, as (the fault that must be found, layout)."""
    stones = layout["stones"]
    shapes = [Polygon(s["outline_um"]) for s in stones]
    a, b = layout["stone_mm"]
    # The most central whole stone, and its nearest neighbour.
    middle = Polygon(layout["outline_um"]).centroid
    order = sorted(range(len(stones)), key=lambda k: shapes[k].centroid.distance(middle))
    k = next((k for k in order if stones[k]["kind"] == "whole" and shapes[k].area > 0.8 * a * b * UM**2), None)
    if k is None or len(stones) < 9:
        return
    n = min((m for m in range(len(stones)) if m != k), key=lambda m: shapes[k].distance(shapes[m]))

    def twin(index, outline):
        changed = dict(layout, stones=list(stones))
        changed["stones"][index] = dict(stones[index], outline_um=outline)
        return changed
    # Where a hand laid narrow stones with wide joints, a disc as wide as one of them may be bare.
    if max(a, b) * BARE_SHARE + layout["joint_mm"] + hand_room(layout) < 0.9 * min(a, b) / hand_growth(layout):
        yield "bare", dict(layout, stones=stones[:k] + stones[k + 1:])
    from shapely.ops import nearest_points
    p, q = nearest_points(shapes[k], shapes[n])
    gap = p.distance(q)
    over = gap + 10.0 + 2.0  # a hundredth of a millimetre, and rounding
    step = ((q.x - p.x) / gap * over, (q.y - p.y) / gap * over)
    yield "overlap", twin(k, [[round(x + step[0]), round(y + step[1])] for x, y in stones[k]["outline_um"]])
    yield "overlap", dict(layout, stones=stones + [stones[k]])
    yield "invalid", twin(k, stones[k]["outline_um"][::-1])
    far = Polygon(layout["outline_um"]).bounds[2] - shapes[k].bounds[0] - 50.0
    yield "outside", twin(k, [[round(x + far), y] for x, y in stones[k]["outline_um"]])
    if field_stock(layout)[1] and layout["bond"] != "ashlar":  # two of those that differ may be no larger than one
        hull = shapes[k].union(shapes[n]).convex_hull.exterior.coords[:-1]
        hull = [[round(x), round(y)] for x, y in hull]
        if twice_area(hull) < 0:
            hull.reverse()
        kept = [s for m, s in enumerate(stones) if m not in (k, n)]
        yield "large", dict(layout, stones=kept + [dict(stones[k], outline_um=hull)])


def self_test(lines):
    """Spoils layouts without a fault by it; returns what was not found out."""
    tried, missed = collections.Counter(), []
    for line in lines:
        layout = json.loads(line)
        if "stones" not in layout:
            continue
        before = judged(layout)[0]
        for kind, twin in spoilt(layout):
            if kind in before:
                continue
            tried[kind] += 1
            if kind not in judged(twin)[0]:
                missed.append(f"number {layout['number']}: {kind} was not found out\n{layout['toml']}")
    print("spoilt and found out: " + ", ".join(f"{kind} {count}" for kind, count in sorted(tried.items())))
    return missed + [f"no layout was spoilt by {kind}" for kind in KINDS if kind not in ("failed", "touching", "measured") and tried[kind] < 3]


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--run")
    arguments.add_argument("--first", type=int, default=1)
    arguments.add_argument("--count", type=int, default=0)
    arguments.add_argument("--processes", type=int, default=2)
    arguments.add_argument("--worst", type=int, default=20)
    arguments.add_argument("--rare", action="store_true")
    arguments.add_argument("--sized", action="store_true")
    arguments.add_argument("--self-test", action="store_true")
    arguments.add_argument("files", nargs="*")
    options = arguments.parse_args()
    if options.self_test:
        missed = self_test(sys.stdin)
        print("\n".join(missed))
        return 1 if missed else 0
    begin = time.time()
    if options.run:
        step = 25
        more = ["--rare"] * options.rare + ["--sized"] * options.sized + options.files
        tasks = [(options.run, first, min(step, options.first + options.count - first), more)
                 for first in range(options.first, options.first + options.count, step)]
        tally = Tally()
        with multiprocessing.Pool(options.processes) as pool:
            for done in pool.imap(tally_of_range, tasks):
                tally.merge(done)
    else:
        tally = tally_of(sys.stdin)
    tally.report(options.worst)
    print(f"{time.time() - begin:.0f} s")
    return 0 if tally.is_sound() else 1


if __name__ == "__main__":
    sys.exit(main())
