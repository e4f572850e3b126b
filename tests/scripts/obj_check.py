# Run by the Python of build/validators/trimesh, which has trimesh, shapely and numpy:
#   obj_check.py SCENE.obj SCENE.ply SCENE.json GAP_MM BEVELLED
# The shards of a pane as trimesh reads them: each is closed, no facet is without area, and they have the volumes that the JSON and the
# gaps between them ask for. GAP_MM is that of the scene; BEVELLED is 1 where their edges are broken, else 0. Prints what is wrong.
import json
import re
import sys

import numpy
import shapely
import trimesh

faults = []
# Cracks end within 1 µm of what they end on: this much is laid about them to close that.
SLIT_MM = 0.005


def expect(condition, what):
    if not condition:
        faults.append(what)


def shards_of_obj(path):
    scene = trimesh.load(path, split_objects=True, group_material=False, process=False)
    return dict(scene.geometry)


def shards_of_ply(path):
    with open(path, "rb") as file:
        header = file.read().split(b"end_header\n")[0].decode()
    names = {int(number): name for number, name in re.findall(r"^comment body (\d+) (\S+)", header, re.M)}
    mesh = trimesh.load(path, process=False)
    bodies = mesh.metadata["_ply_raw"]["face"]["data"]["body"].reshape(-1)
    return {names[number]: trimesh.Trimesh(mesh.vertices, mesh.faces[bodies == number], process=False) for number in names}


def joined(mesh):
    """Its points that are at one place as one."""
    points, numbers = numpy.unique(mesh.vertices[mesh.faces].reshape(-1, 3), axis=0, return_inverse=True)
    return trimesh.Trimesh(points, numbers.reshape(-1, 3), process=False)


def faces_of(pane):
    """What cracks cut the pane into, and the area of these pieces less half a gap along their cracks."""
    outline = shapely.Polygon(pane["outline_mm"])
    cracks = [shapely.LineString(crack["points_mm"]) for crack in pane["cracks"]]
    slits = shapely.union_all([crack.buffer(SLIT_MM, join_style="mitre") for crack in cracks])
    parts = shapely.get_parts(outline.difference(slits))
    # Slits of cracks that end inside a piece are closed again.
    closed = [part.buffer(2 * SLIT_MM, join_style="mitre").buffer(-2 * SLIT_MM, join_style="mitre") for part in parts]
    return outline, [part.intersection(outline) for part in closed]


def area_without_gaps(pane, gap_mm):
    outline, faces = faces_of(pane)
    frame = outline.exterior.buffer(0.8 * SLIT_MM, join_style="mitre")
    half = [face.boundary.difference(frame).buffer(gap_mm / 2 - SLIT_MM, join_style="mitre") for face in faces]
    return outline.area, sum(face.difference(gap).area for face, gap in zip(faces, half))


def check_volumes(pane, shards, kind, bevelled):
    thickness = pane["thickness_mm"]
    name = pane["name"]
    there = [shard for shard in pane["shards"] if shard["state"] != "missing"]
    expect({f"{name}.{shard['id']}" for shard in there} == shards.keys(), f"{kind}: the shards of the JSON")
    total = 0
    for shard in there:
        mesh = joined(shards[f"{name}.{shard['id']}"])
        expect(mesh.is_watertight and mesh.is_winding_consistent, f"{kind}: shard {shard['id']} closed")
        face = shapely.Polygon(shard["outline_mm"], shard["holes_mm"])
        volume = 1e9 * mesh.volume / thickness
        total += volume
        # Without bevels a shard is its face, all through the pane; a µm on its border is what rounding may do.
        slack = 1e-3 * face.length
        expect(volume < face.area + slack, f"{kind}: shard {shard['id']} no larger than its face, got {volume} of {face.area}")
        expect(volume > (0.5 if bevelled else 1) * face.area - slack, f"{kind}: shard {shard['id']} as large as its face")
    return total


obj, ply, geometry = sys.argv[1:4]
gap, bevelled = float(sys.argv[4]), sys.argv[5] == "1"
with open(geometry) as file:
    pane = json.load(file)["panes"][0]
for kind, shards in (("obj", shards_of_obj(obj)), ("ply", shards_of_ply(ply))):
    total = check_volumes(pane, shards, kind, bevelled)
    areas = numpy.concatenate([mesh.area_faces for mesh in shards.values()])
    # What a µm is wide may be flat in the PLY's numbers of 24 bits.
    flat = (areas <= 0).sum()
    expect(flat == 0 if kind == "obj" else flat < 1e-3 * len(areas), f"{kind}: no facet without area, got {flat} of {len(areas)}")
    if not bevelled and all(shard["state"] == "standing" for shard in pane["shards"]):
        whole, left = area_without_gaps(pane, gap)
        expect(abs(total - left) < 0.005 * (whole - left),
               f"{kind}: volumes of {left:.3f} mm² times the thickness ({whole:.3f} less the gaps), got {total:.3f}")
for told in faults[:20]:
    print(f"shards: expected {told}")
if faults:
    sys.exit(f"shards: {len(faults)} faults")
