# Run by Blender (blender -b --factory-startup -P blender_gltf.py -- SCENE.glb): imports a door of 140 x 210 mm in shards, or a
# plaza of 3 x 2 m with its kerb, and checks that they arrive in metres, as glass or stone, by their names. Prints "gltf: ok".
import os
import sys

import bpy
import numpy

# The importer of Debian's Blender 3.4 uses names that Debian's numpy has no more.
numpy.bool = bool

file = sys.argv[sys.argv.index("--") + 1]


def expect(condition, what):
    if not condition:
        print("gltf: expected", what)
        sys.stdout.flush()
        os._exit(1)


def extent(things):
    corners = [thing.matrix_world @ vertex.co for thing in things for vertex in thing.data.vertices]
    return [(min(c[axis] for c in corners), max(c[axis] for c in corners)) for axis in range(3)]


def near(a, b):
    return abs(a - b) < 1e-4


for old in list(bpy.data.objects):
    bpy.data.objects.remove(old)
bpy.ops.import_scene.gltf(filepath=file)
things = [thing for thing in bpy.data.objects if thing.type == "MESH"]
for material in bpy.data.materials:
    shader = material.node_tree.nodes.get("Principled BSDF") if material.use_nodes else None
    if shader is None:
        continue
    is_glass = material.name.startswith("glass")
    if "_stone_" in material.name:
        for name in ("Base Color", "Roughness", "Normal"):
            expect(shader.inputs[name].is_linked, f"{material.name} to have a texture for {name}")
    expect(shader.inputs["Metallic"].default_value == 0, f"{material.name} not to be metal")
    if is_glass:
        expect(shader.inputs["Transmission"].default_value == 1, f"{material.name} to let light through")
        expect(near(shader.inputs["IOR"].default_value, 1.52), f"{material.name} to refract by 1.52")
if "door" in bpy.data.objects:
    expect(len(things) > 100 and all(thing.name.startswith("door.") for thing in things), "shards by name")
    (x, y, z) = extent([thing for thing in things if thing.get("kind") == "shard standing"])
    expect(near(z[1], 0.21) and near(x[0], 0) and near(x[1], 0.14), f"a door of 0.14 x 0.21 m that stands, got {x} {z}")
    expect(near(y[0], -0.003) and near(y[1], 0.003), f"glass of 6 mm, got {y}")
else:
    stones = [thing for thing in things if thing.get("kind", "").startswith("stone") and thing.name.startswith("plaza.")]
    expect(len(stones) > 200, f"stones, got {len(stones)}")
    (x, y, z) = extent(stones)
    expect(x[0] > 0 and x[1] < 3 and x[1] > 2.98 and y[0] > 0 and y[1] < 2 and y[1] > 1.98, f"3 x 2 m, got {x} {y}")
    expect(any(thing.name.startswith("plaza_kerb.") for thing in things), "a kerb")
    expect(any(thing.name == "plaza.joints" for thing in things), "joints")
    expect(any(thing.name == "plaza.water" for thing in things), "water")
print("gltf: ok")
