# Run by Blender (blender -b --factory-startup -P blender_glass.py -- SCENE.obj HEIGHT_M): imports the shards of a pane of that
# height, and checks that they arrive as glass, upright, in metres, with normals and a place in textures. Prints "glass: ok"
# where all holds; else "glass: ..." with what does not.
import os
import sys

import bpy

file, height_m = sys.argv[sys.argv.index("--") + 1:]


def expect(condition, what):
    if not condition:
        print("glass: expected", what)
        sys.stdout.flush()
        os._exit(1)


def check_material(name):
    material = bpy.data.materials.get(name)
    expect(material is not None, f"a material {name}")
    shader = material.node_tree.nodes["Principled BSDF"]
    value = {socket.name: socket.default_value for socket in shader.inputs if hasattr(socket, "default_value")}
    expect(value["Metallic"] == 0, f"{name} not to be metal, got {value['Metallic']}")
    expect(value["Alpha"] == 1 and material.blend_method == "OPAQUE", f"{name} to be all there, got alpha {value['Alpha']}")
    expect(value["Roughness"] < 0.1, f"{name} to be smooth, got a roughness of {value['Roughness']}")
    expect(abs(value["IOR"] - 1.52) < 1e-5, f"{name} to refract by 1.52, got {value['IOR']}")
    expect(value["Transmission"] == 1, f"{name} to let light through, got {value['Transmission']}")
    expect(min(value["Base Color"][:3]) > 0.9, f"{name} to be near white, got {list(value['Base Color'])}")


def check_meshes(things):
    expect(things, "shards")
    for thing in things:
        mesh = thing.data
        expect(all(polygon.area > 0 for polygon in mesh.polygons), f"triangles of {thing.name} to have an area")
        expect(mesh.uv_layers and mesh.has_custom_normals, f"{thing.name} to have vt and vn")
        expect({slot.name for slot in thing.material_slots} <= {"glass_old", "glass_broken"}, f"the materials of {thing.name}")
        edges = {}
        for polygon in mesh.polygons:
            for edge in polygon.edge_keys:
                edges[edge] = edges.get(edge, 0) + 1
        expect(set(edges.values()) == {2}, f"{thing.name} to be closed")
    # y of the file is up, which is Blender's z.
    tops = [(thing.matrix_world @ vertex.co).z for thing in things for vertex in thing.data.vertices]
    expect(abs(max(tops) - float(height_m)) < 1e-4, f"the top of the pane {height_m} m up, got {max(tops)}")


for old in list(bpy.data.objects):
    bpy.data.objects.remove(old)
bpy.ops.wm.obj_import(filepath=file)
check_material("glass_old")
check_material("glass_broken")
check_meshes([thing for thing in bpy.data.objects if thing.type == "MESH"])
print("glass: ok")
