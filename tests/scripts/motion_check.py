"""Pieces that fall and a camera that moves, in one file for all frames: at every frame they are where the scene at that frame has them.

motion_check.py SCENE.glb SCENE.usda FRAMES WORLD   FRAMES: folder of SCENE.####.json; WORLD: x,y,z,degrees of the pane
"""
import json
import math
import pathlib
import struct
import sys

import numpy as np
from pxr import Usd, UsdGeom

FARTHEST_MM = 0.1


def placed(world):
    """The pane's place in the frame of mesh targets: y up, z towards the viewer (docs/meshes.md), as a matrix in mm."""
    x, y, z, degrees = world
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return np.array([[c, 0, s, x], [0, 1, 0, z], [-s, 0, c, -y], [0, 0, 0, 1]])


def motion(shard):
    matrix = np.eye(4)
    if "transform" in shard:
        matrix[:3, :] = np.array(shard["transform"]).reshape(3, 4)
    return matrix


def matrix_of(shift_m, q):
    x, y, z, w = q
    matrix = np.eye(4)
    matrix[:3, :3] = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                      [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                      [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    matrix[:3, 3] = np.array(shift_m) * 1000
    return matrix


def of_gltf(path):
    """For each piece that moves: its points in mm, and for each frame a matrix, or none where it is not seen; the camera's
    matrices; times in s."""
    data = pathlib.Path(path).read_bytes()
    (length,) = struct.unpack("<I", data[12:16])
    scene, binary = json.loads(data[20:20 + length]), data[28 + length:]

    def values(number):
        accessor = scene["accessors"][number]
        start = scene["bufferViews"][accessor["bufferView"]].get("byteOffset", 0)
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        flat = np.frombuffer(binary, "<f4", accessor["count"] * width, start)
        return flat.reshape(-1, width).astype(float)

    assert sorted(animation["name"] for animation in scene["animations"]) == ["camera", "fall"]
    channels = {}
    for animation in scene["animations"]:
        for channel in animation["channels"]:
            sampler = animation["samplers"][channel["sampler"]]
            channels.setdefault(channel["target"]["node"], {})[channel["target"]["path"]] = values(sampler["output"])
            times = values(sampler["input"])[:, 0]
    pieces, camera = {}, []
    for number, paths in channels.items():
        node = scene["nodes"][number]
        if "camera" in node:
            camera = [matrix_of(t, q) for t, q in zip(paths["translation"], paths["rotation"], strict=True)]
            continue
        points = np.vstack([values(p["attributes"]["POSITION"]) for p in scene["meshes"][node["mesh"]]["primitives"]]) * 1000
        sizes = paths.get("scale", np.ones((len(times), 3)))
        frames = [matrix_of(t, q) if s[0] == 1 else None
                  for t, q, s in zip(paths["translation"], paths["rotation"], sizes, strict=True)]
        pieces[node["name"].split(".", 1)[1]] = (points, frames)
    return pieces, camera, times


def of_usd(path, first, count):
    stage = Usd.Stage.Open(str(path))
    pieces = {}
    for prim in stage.Traverse():
        if not prim.IsA(UsdGeom.Mesh):
            continue
        vanishes = UsdGeom.Imageable(prim).GetVisibilityAttr().ValueMightBeTimeVarying()
        if not vanishes and not UsdGeom.Xformable(prim).TransformMightBeTimeVarying():
            continue
        points = np.array(UsdGeom.Mesh(prim).GetPointsAttr().Get(), float) * 1000
        frames = []
        for frame in range(first, first + count):
            if UsdGeom.Imageable(prim).ComputeVisibility(frame) == UsdGeom.Tokens.invisible:
                frames.append(None)
                continue
            # The place in the pane's prim, which stands where the stage begins.
            matrix = np.array(UsdGeom.XformCache(frame).GetLocalToWorldTransform(prim)).T
            matrix[:3, 3] *= 1000
            frames.append(matrix)
        pieces[prim.GetAttribute("userProperties:id").Get()] = (points, frames)
    assert stage.GetStartTimeCode() == first and stage.GetEndTimeCode() == first + count - 1
    seen_by = next(UsdGeom.Camera(prim) for prim in stage.Traverse() if prim.IsA(UsdGeom.Camera))
    camera = []
    for frame in range(first, first + count):
        lens = seen_by.GetCamera(frame)
        matrix = np.array(lens.transform).T
        matrix[:3, 3] *= 1000
        camera.append((matrix, lens.GetFieldOfView(lens.FOVHorizontal), lens.focusDistance * 1000, lens.fStop))
    return pieces, camera, stage.GetTimeCodesPerSecond()


def upright(place_mm):
    x, y, z = place_mm
    return np.array([x, z, -y])


def compare_camera(what, matrices, frames):
    """Place and view, at most a micrometre and a ten-thousandth of a degree from where the frame has them."""
    for matrix, frame in zip(matrices, frames, strict=True):
        camera = frame["camera"]
        at = upright(camera["at_mm"])
        view = upright(camera["look_at_mm"]) - at
        assert np.abs(matrix[:3, 3] - at).max() < 2e-3, f"{what}: the camera's place"
        assert np.abs(matrix[:3, 2] + view / np.linalg.norm(view)).max() < 2e-6, f"{what}: the camera's view"


def compare_lens(cameras, frames):
    for (_, field, focus, stop), frame in zip(cameras, frames, strict=True):
        camera = frame["camera"]
        assert abs(field - camera["field_of_view_deg"]) < 1e-3, "usd: field of view"
        assert abs(focus - camera["focus_mm"]) < 1e-3 and abs(stop - camera["f_number"]) < 1e-6, "usd: focus"


def passes(check, *arguments):
    try:
        check(*arguments)
    except AssertionError:
        return False
    return True


def compare(what, pieces, frames, pane):
    """The farthest that a point is from where it should be, in mm. At the first frame all are in the pane."""
    farthest, moved = 0.0, 0
    shards = [{s["id"]: s for s in frame["panes"][0]["shards"]} for frame in frames]
    leaving = {i for now in shards for i, s in now.items() if s["state"] != "standing"}
    assert set(pieces) == leaving, f"{what}: moves {sorted(set(pieces) ^ leaving)}"
    for name, (points, matrices) in pieces.items():
        assert len(matrices) == len(frames), what
        points = np.hstack([points, np.ones((len(points), 1))]).T
        in_pane = np.linalg.inv(pane) @ matrices[0] @ points
        for now, matrix in zip(shards, matrices, strict=True):
            shard = now[name]
            assert (matrix is None) == (shard["state"] == "missing"), f"{what}: {name} is seen or not"
            if matrix is None:
                continue
            wanted = pane @ motion(shard) @ in_pane
            farthest = max(farthest, float(np.abs(matrix @ points - wanted)[:3].max()))
            moved += shard["state"] == "fallen"
    assert moved > 0, what
    assert farthest <= FARTHEST_MM, f"{what}: {farthest} mm from where the frame has it"
    return farthest


def main():
    glb, usda, folder, world = sys.argv[1:]
    files = sorted(pathlib.Path(folder).glob("*.json"))
    frames = [json.loads(file.read_text()) for file in files]
    first = int(files[0].name.split(".")[-2])
    pane = placed([float(part) for part in world.split(",")])
    gltf, gltf_camera, times = of_gltf(glb)
    usd, usd_camera, per_second = of_usd(usda, first, len(files))
    compare_camera("gltf", gltf_camera, frames)
    compare_camera("usd", [matrix for matrix, *_ in usd_camera], frames)
    compare_lens(usd_camera, frames)
    for late in (passes(compare_camera, "late", gltf_camera[:1] + gltf_camera[:-1], frames),
                 passes(compare_lens, usd_camera[:1] + usd_camera[:-1], frames)):
        assert not late, "a camera that is a frame late passes"
    assert np.allclose(times * per_second, np.arange(len(files)), atol=1e-4), "times of the frames"
    told = [compare("gltf", gltf, frames, pane), compare("usd", usd, frames, pane)]
    # The twins: a straight way from the first place to the last, and frames one later.
    for twin in ("straight", "late"):
        changed = {}
        for name, (points, matrices) in gltf.items():
            if twin == "late":
                changed[name] = (points, matrices[:1] + matrices[:-1])
            else:
                there = [m for m in matrices if m is not None]
                parts = np.linspace(0, 1, len(matrices))
                changed[name] = (points, [None if m is None else (1 - p) * there[0] + p * there[-1]
                                          for m, p in zip(matrices, parts, strict=True)])
        assert not passes(compare, twin, changed, frames, pane), f"the twin '{twin}' passes"
    print(f"motion: {len(gltf)} pieces over {len(files)} frames, {max(told):.5f} mm off at most")


main()
