# Drawings as architects send them, made by ezdxf, which also tells what each shows: FOLDER/NAME.dxf, FOLDER/NAME.toml, and
# FOLDER/expected.json with the areas in m² and a point of the outline in mm for each.
#   dxf_files.py FOLDER
import json
import math
import sys

import ezdxf
from ezdxf import path
from ezdxf.enums import InsertUnits

folder = sys.argv[1]
expected = {}


def area_of(points):
    return abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(points, points[1:] + points[:1]))) / 2


def flat(entity, sagitta):
    return [(p.x, p.y) for p in path.make_path(entity).flattening(sagitta)]


def drawing(version="R2010", units=InsertUnits.Meters):
    document = ezdxf.new(version, setup=True)
    if units is not None:
        document.units = units
    return document, document.modelspace()


def save(name, document, scene, areas_m2, unit_mm=1000.0, text=None):
    if text is None:
        document.saveas(f"{folder}/{name}.dxf")
    else:
        with open(f"{folder}/{name}.dxf", "wb") as file:
            file.write(text)
    with open(f"{folder}/{name}.toml", "w", encoding="utf-8") as file:
        file.write(f'[[pavement]]\nname = "yard"\noutline_file = "{name}.dxf"\n{scene}\nstone_mm = [400, 400]\n')
    expected[name] = areas_m2


# 1: a closed polyline with bulges in a layer, others beside it, words on it, paper space, a layer that is frozen.
document, model = drawing()
for layer in ("PAVING", "TREES", "HIDDEN"):
    document.layers.add(layer)
document.layers.get("HIDDEN").freeze()
outline = model.add_lwpolyline([(0, 0, 0), (6, 0, 0.5), (6, 4, 0), (0, 4, -0.3)], format="xyb", close=True, dxfattribs={"layer": "PAVING"})
tree = model.add_circle((3, 2), 0.5, dxfattribs={"layer": "TREES"})
model.add_text("yard", dxfattribs={"layer": "PAVING"}).set_placement((1, 1))
model.add_lwpolyline([(0, 0), (50, 0), (50, 50)], close=True, dxfattribs={"layer": "HIDDEN"})
document.layout("Layout1").add_lwpolyline([(0, 0), (90, 0), (90, 50)], close=True, dxfattribs={"layer": "PAVING"})
save("bulges", document, 'outline_class = "PAVING"\nholes_class = "TREES"', [area_of(flat(outline, 1e-5)) - math.pi * 0.25])

# 2: the same shape by its layer as an id, in millimetres.
document, model = drawing(units=InsertUnits.Millimeters)
document.layers.add("A-PAVE Fläche")
model.add_lwpolyline([(0, 0), (5000, 0), (5000, 3000), (0, 2500)], close=True, dxfattribs={"layer": "A-PAVE Fläche"})
save("millimetres", document, 'outline_feature = "A-PAVE Fläche"', [13.75], 1.0)

# 3: lines and arcs of one layer, in any order and direction, that meet end to end.
document, model = drawing()
model.add_line((4, 3), (4, 0))
model.add_arc((2, 3), 2, 0, 180)
model.add_line((0, 0), (4, 0))
model.add_line((0, 0), (0, 3))
save("pieces", document, "", [12 + 2 * math.pi])

# 4: blocks, nested, mirrored, turned and scaled.
document, model = drawing(units=InsertUnits.Centimeters)
inner = document.blocks.new("SLAB")
inner.add_lwpolyline([(0, 0), (200, 0), (200, 100), (0, 150)], close=True, dxfattribs={"layer": "SLABS"})
outer = document.blocks.new("PAIR")
outer.add_blockref("SLAB", (0, 0))
outer.add_blockref("SLAB", (-300, 0), dxfattribs={"xscale": -1})
document.layers.add("SLABS")
model.add_blockref("PAIR", (1000, 500), dxfattribs={"rotation": 30, "xscale": 2, "yscale": 2})
save("blocks", document, 'outline_class = "SLABS"', [10.0, 10.0], 10.0)

# 5: a hatch alone, with an island.
document, model = drawing()
hatch = model.add_hatch()
hatch.paths.add_polyline_path([(0, 0), (5, 0), (5, 4), (0, 4)], is_closed=True, flags=1)
hatch.paths.add_polyline_path([(2, 1), (3, 1), (3, 2), (2, 2)], is_closed=True, flags=16)
save("hatch", document, "", [19.0])

# 6: no units: refused, and taken where the scene tells them.
document, model = drawing(units=InsertUnits.Unitless)
model.add_lwpolyline([(0, 0), (4000, 0), (4000, 3000), (0, 3000)], close=True)
save("no_units", document, 'outline_units = "millimetres"', [12.0], 1.0)

# 7: inches by mistake, where millimetres were drawn: the scene's word counts.
document, model = drawing(units=InsertUnits.Inches)
model.add_lwpolyline([(0, 0), (4000, 0), (4000, 3000), (0, 3000)], close=True)
save("inches", document, 'outline_units = "millimetres"', [12.0], 1.0)

# 8: coordinates of a national grid.
document, model = drawing()
x, y = 3_512_345.25, 5_923_456.5
model.add_lwpolyline([(x, y), (x + 6, y), (x + 6, y + 3), (x, y + 3)], close=True)
save("grid", document, "", [18.0])

# 9: R12, whose polylines are entities of their own, and a spline and an ellipse.
document, model = drawing("R12", units=None)
model.add_polyline2d([(0, 0), (12, 0), (12, 6), (0, 6)], close=True)
save("r12", document, 'outline_units = "feet"', [72 * 0.3048**2])

# 10: 2018, a closed spline and an ellipse.
document, model = drawing("R2018")
document.layers.add("POND")
spline = model.add_open_spline([(0, 0), (4, -1), (8, 1), (7, 5), (2, 4), (0, 0)])
ellipse = model.add_ellipse((4, 2), major_axis=(1, 0.3), ratio=0.6, dxfattribs={"layer": "POND"})
save("spline", document, 'outline_class = "0"\nholes_class = "POND"', [area_of(flat(spline, 1e-4)) - area_of(flat(ellipse, 1e-5))])

# 11: a spline by the points that it passes through alone, which GDAL does not read, beside what it does.
document, model = drawing()
model.add_spline([(0, 0), (4, -1), (8, 1)])
model.add_lwpolyline([(0, 0), (2, 0), (2, 2), (0, 2)], close=True)
save("fit_points", document, "", [4.0])

# Broken ones: cut off in the middle, binary, no drawing at all, no shape that closes.
with open(f"{folder}/bulges.dxf", "rb") as file:
    whole = file.read()
save("cut_off", None, "", None, text=whole[: len(whole) * 9 // 10].rsplit(b"LWPOLYLINE", 1)[0] + b"LWPOLYLINE\n  5\n")
save("binary", None, "", None, text=b"AutoCAD Binary DXF\r\n\x1a\x00" + bytes(range(256)))
save("words", None, "", None, text=b"0\nSECTION\nhello\nthis is none\n")
document, model = drawing()
model.add_line((0, 0), (5, 0))
save("open", document, "", None)

# Clockwise outlines that end in an arc, whose last point is rounded when it becomes lines: also far out.
for name, places in (("clockwise_arcs", [(0, 0), (20, 0)]), ("clockwise_arcs_far_out", [(380020.3, 5820000.7)])):
    document, model = drawing()
    areas = []
    for x, y in places:
        bulge = -math.tan(math.pi / 8)
        corners = [(x, y + 1, 0), (x, y + 3, bulge), (x + 1, y + 4, 0), (x + 5, y + 4, 0), (x + 5, y, 0), (x + 1, y, bulge)]
        model.add_lwpolyline(corners, format="xyb", close=True)
        areas.append(20 - 2 * (1 - math.pi / 4))
    save(name, document, 'outline_class = "0"', areas)
document, model = drawing()
model.add_lwpolyline([(0, 0, -1), (2, 0, -1)], format="xyb", close=True)
save("clockwise_circle", document, "", [math.pi])

with open(f"{folder}/expected.json", "w", encoding="utf-8") as file:
    json.dump(expected, file)
