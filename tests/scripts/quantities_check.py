# Counts again, from the JSON alone, what the tables of quantities say, and looks whether each cut stone fits its stock stone.
#   quantities_check.py FOLDER SCENE STOCK…        STOCK: PAVEMENT:PART:LENGTH:WIDTH, the stock stones of parts that are to be looked at
#   quantities_check.py --sheet FOLDER SCENE SCALE   each stone of SCENE-sheet.svg, measured on paper, is that of the JSON
import csv
import json
import math
import sys
from collections import Counter, defaultdict
from xml.etree import ElementTree

from shapely.geometry import Polygon


def expect(holds, what):
    if not holds:
        sys.exit(f"quantities: expected {what}")


def table(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def near(a, b, tolerance):
    return abs(a - b) <= tolerance


def extents(outline, angle_deg):
    c, s = math.cos(math.radians(angle_deg)), math.sin(math.radians(angle_deg))
    along = [x * c + y * s for x, y in outline]
    across = [y * c - x * s for x, y in outline]
    return max(along) - min(along), max(across) - min(across)


def check_stones(rows, geometry):
    stones = [(p["name"], stone) for p in geometry["pavements"] for stone in p["stones"]]
    expect(len(rows) == len(stones), f"{len(stones)} rows of stones, not {len(rows)}")
    for row, (pavement, stone) in zip(rows, stones):
        where = f"{pavement} {stone['id']}"
        expect((row["pavement"], int(row["id"]), row["part"], row["kind"])
               == (pavement, stone["id"], stone["part"], stone["kind"]), f"the names of {where}")
        shape = Polygon(stone["outline_mm"])
        length, width = extents(stone["outline_mm"], stone["angle_deg"])
        expect(near(float(row["length_mm"]), length, 0.002) and near(float(row["width_mm"]), width, 0.002), f"{where}: its size")
        expect(near(float(row["area_mm2"]), shape.area, 0.001), f"{where}: {shape.area} mm²")
        expect(near(float(row["x_mm"]), shape.centroid.x, 0.002) and near(float(row["y_mm"]), shape.centroid.y, 0.002),
               f"{where}: its middle")


def check_quantities(rows, geometry, stones):
    told = {(row["pavement"], row["item"]): row for row in rows}
    expect(len(told) == len(rows), "each item once")
    by_pavement = defaultdict(list)
    for row in stones:
        by_pavement[row["pavement"]].append(row)
    for pavement in geometry["pavements"]:
        name = pavement["name"]
        area = Polygon(pavement["outline_mm"], pavement["holes_mm"]).area
        expect(near(float(told[name, "paved"]["area_m2"]), area / 1e6, 1e-6), f"{name}: {area / 1e6} m² paved")
        counts = Counter((stone["part"], stone["kind"]) for stone in pavement["stones"])
        faces = 0.0
        for part in {part for part, _ in counts}:
            for kind in ("whole", "cut"):
                row = told[name, f"{part}_{kind}"]
                of_kind = [Polygon(s["outline_mm"]).area for s in pavement["stones"] if (s["part"], s["kind"]) == (part, kind)]
                expect(int(row["count"]) == counts[part, kind], f"{name}: {counts[part, kind]} {part} {kind}")
                expect(near(float(row["area_m2"]), sum(of_kind) / 1e6, 1e-6), f"{name}: area of {part} {kind}")
                faces += sum(of_kind)
            whole, cut = counts[part, "whole"], counts[part, "cut"]
            expect(int(told[name, f"{part}_to_order"]["count"]) == whole + cut, f"{name}: {whole + cut} {part} to order")
            stock = {row["stock"] for row in by_pavement[name] if row["part"] == part}
            expect(int(told[name, f"{part}_to_order_reusing_offcuts"]["count"]) == len(stock), f"{name}: {len(stock)} stock stones")
        joints = told[name, "joints"]
        expect(near(float(joints["area_m2"]), (area - faces) / 1e6, 2e-6), f"{name}: area of joints")
        if ("kerb", "whole") in counts:
            expect(float(told[name, "kerb"]["length_m"]) > 0, f"{name}: a length of its kerb")


def check_stock(stones, stock):
    name, part, length, width = stock.split(":")
    length, width = float(length), float(width)
    on_stock = defaultdict(list)
    for row in stones:
        if (row["pavement"], row["part"]) != (name, part):
            continue
        size = float(row["length_mm"]), float(row["width_mm"])
        expect(size[0] <= length + 0.01 and size[1] <= width + 0.01, f"{name} {row['id']} cut from {length} × {width}, not {size}")
        on_stock[row["stock"]].append(row)
    shared = 0
    for number, rows in on_stock.items():
        expect(len(rows) == 1 or all(row["kind"] == "cut" for row in rows), f"{name}: stock {number} for one whole stone alone")
        needed = sum(float(row["length_mm"]) * float(row["width_mm"]) for row in rows)
        expect(needed <= length * width + 0.01 * (length + width), f"{name}: what fits stock stone {number}, not {needed} mm²")
        shared += len(rows) > 1
    print(f"{name} {part}: {sum(map(len, on_stock.values()))} stones from {len(on_stock)}, {shared} of which serve twice or more")
    return shared


def check_sheet(folder, scene, scale):
    with open(f"{folder}/{scene}.json", encoding="utf-8") as file:
        geometry = json.load(file)
    svg = "{http://www.w3.org/2000/svg}"
    page = ElementTree.parse(f"{folder}/{scene}-sheet.svg").getroot()
    paper = [float(page.get(key).removesuffix("mm")) for key in ("width", "height")]
    expect(page.get("viewBox") == "0 0 {:g} {:g}".format(*paper), "one unit of the sheet to be a millimetre of paper")
    drawn = {shape.get("id"): shape for shape in page.iter(svg + "polygon")}
    # Paper has thousandths of a millimetre; what is turned is rounded at both ends.
    tolerance = 2 * 0.001 * scale
    origin = None
    for pavement in geometry["pavements"]:
        x0, y0, _ = pavement.get("place_mm", [0, 0, 0])
        turn = math.radians(pavement.get("place_turn_deg", 0))
        for stone in pavement["stones"]:
            shape = drawn.pop(f"{pavement['name']}-stone-{stone['id']}", None)
            expect(shape is not None, f"{pavement['name']} {stone['id']} on the sheet")
            names = shape.get("class").split()
            expect(names == ["stone", stone["part"], stone["kind"]], f"{shape.get('id')}: classes of its part and kind")
            points = [tuple(map(float, point.split(","))) for point in shape.get("points").split()]
            for (px, py), (x, y) in zip(points, stone["outline_mm"], strict=True):
                expect(0 < px < paper[0] and 0 < py < paper[1], f"{shape.get('id')} on the paper")
                x, y = x * math.cos(turn) - y * math.sin(turn) + x0, x * math.sin(turn) + y * math.cos(turn) + y0
                here = px * scale - x, -py * scale - y
                origin = origin or here
                expect(math.dist(here, origin) <= tolerance, f"{shape.get('id')} where it is laid, not {math.dist(here, origin)} mm off")
    expect(not drawn, f"no stone that is not laid: {list(drawn)[:3]}")
    print(f"{scene}: {paper[0]:g} × {paper[1]:g} mm of paper at 1:{scale:g}")


def main():
    if sys.argv[1] == "--sheet":
        check_sheet(sys.argv[2], sys.argv[3], float(sys.argv[4]))
        return
    folder, scene, *stocks = sys.argv[1:]
    with open(f"{folder}/{scene}.json", encoding="utf-8") as file:
        geometry = json.load(file)
    stones = table(f"{folder}/{scene}-stones.csv")
    check_stones(stones, geometry)
    check_quantities(table(f"{folder}/{scene}-quantities.csv"), geometry, stones)
    points = [(pane["name"], str(crack["id"]), crack["kind"], str(crack["impact"]), str(i), x, y)
              for pane in geometry["panes"] for crack in [*pane["cracks"], *pane.get("far_cracks", [])] for i, (x, y) in enumerate(crack["points_mm"])]
    rows = table(f"{folder}/{scene}-cracks.csv")
    expect(len(rows) == len(points), f"{len(points)} points of cracks, not {len(rows)}")
    for row, (*names, x, y) in zip(rows, points):
        expect([row[key] for key in ("pane", "crack", "kind", "impact", "index")] == names, f"the names of {names}")
        expect(near(float(row["x_mm"]), x, 0.0006) and near(float(row["y_mm"]), y, 0.0006), f"{names} at {x}, {y}")
    shared = [check_stock(stones, stock) for stock in stocks]
    expect(not stocks or any(shared), "an offcut that serves again")


main()
