# Run by Blender (blender -b --factory-startup -P blender_textures.py -- FOLDER NAME PICTURE.png): loads the texture set of the
# pavement NAME from FOLDER by the names of its files alone, as Blender's own add-on Node Wrangler does it for an artist, renders
# it, and checks what comes out. Prints "textures: ok" where all holds; else "textures: ..." with what does not.
import json
import os
import sys

import bpy
import numpy

folder, name, picture = sys.argv[sys.argv.index("--") + 1:]
facts = json.load(open(os.path.join(folder, name + "_textures.json")))
width_m, height_m = (side / 1000 for side in facts["size_mm"])


def expect(condition, what):
    if not condition:
        print("textures: expected", what)
        sys.stdout.flush()
        os._exit(1)


def load_by_names(material):
    """Node Wrangler's "Principled Texture Setup" over all images of the folder."""
    bpy.ops.preferences.addon_enable(module="node_wrangler")
    material.use_nodes = True
    window = bpy.context.window_manager.windows[0]
    area = window.screen.areas[0]
    area.ui_type = "ShaderNodeTree"
    space = area.spaces.active
    space.pin = True
    space.node_tree = material.node_tree
    shader = material.node_tree.nodes["Principled BSDF"]
    for node in material.node_tree.nodes:
        node.select = node == shader
    material.node_tree.nodes.active = shader
    images = sorted(file for file in os.listdir(folder) if file.endswith((".png", ".exr")))
    region = next(region for region in area.regions if region.type == "WINDOW")
    with bpy.context.temp_override(window=window, area=area, region=region, space_data=space):
        done = bpy.ops.node.nw_add_textures_for_principled(
            directory=folder + os.sep, files=[{"name": file} for file in images], relative_path=False)
    expect(done == {"FINISHED"}, "Node Wrangler to finish")
    return shader


def image_behind(socket):
    """The image that feeds a socket, whatever stands between."""
    for link in socket.links:
        node = link.from_node
        if node.type == "TEX_IMAGE":
            return node.image
        for inner in node.inputs:
            image = image_behind(inner)
            if image:
                return image
    return None


def check_sockets(material, shader):
    output = next(node for node in material.node_tree.nodes if node.type == "OUTPUT_MATERIAL")
    for socket, which, data in [(shader.inputs["Base Color"], "BaseColor", False),
                                (shader.inputs["Roughness"], "Roughness", True),
                                (shader.inputs["Normal"], "Normal", True),
                                (output.inputs["Displacement"], "Height", True)]:
        image = image_behind(socket)
        expect(image and image.name.startswith(f"{name}_{which}."), f"{which} behind {socket.name}")
        expect(data == (image.colorspace_settings.name == "Non-Color"), f"the colour space of {which}")
    for node in material.node_tree.nodes:
        if node.type == "DISPLACEMENT":
            node.inputs["Scale"].default_value = facts["height_range_mm"] / 1000
            node.inputs["Midlevel"].default_value = 0


def scene_of(material):
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    bpy.ops.mesh.primitive_plane_add(size=1)
    ground = bpy.context.object
    ground.scale = (width_m, height_m, 1)
    ground.data.materials.append(material)
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.energy = 4
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene = bpy.context.scene
    for thing in (sun, camera):
        scene.collection.objects.link(thing)
    scene.camera = camera
    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.55, 0.7, 1, 1)
    scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = 0.25
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.use_denoising = False
    scene.cycles.seed = 1
    scene.view_settings.view_transform = "Standard"
    return scene, camera, sun


def rendered(scene, width, height, samples, file):
    scene.cycles.samples = samples
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = width, height, 100
    scene.render.filepath = file
    scene.render.image_settings.file_format = "PNG"
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(file, check_existing=False)
    image.colorspace_settings.name = "Non-Color"
    return numpy.array(image.pixels[:]).reshape(height, width, 4)[:, :, :3]


def slopes_to_north(size):
    """Green of the normal map, about 0, in `size` by `size` boxes, rows from below."""
    image = bpy.data.images.load(os.path.join(folder, facts["maps"]["Normal"]), check_existing=False)
    image.colorspace_settings.name = "Non-Color"
    green = numpy.array(image.pixels[:]).reshape(image.size[1], image.size[0], 4)[:, :, 1] - 0.5
    step = (image.size[1] // size, image.size[0] // size)
    return green[:size * step[0], :size * step[1]].reshape(size, step[0], size, step[1]).mean(axis=(1, 3))


def lit_from(scene, camera, sun, degrees_from_south):
    """How light of a low sun from the south (0) or north (180) goes with slopes to the north: a correlation."""
    size = 128
    camera.data.type, camera.data.ortho_scale = "ORTHO", max(width_m, height_m)
    camera.location, camera.rotation_euler = (0, 0, 2), (0, 0, 0)
    sun.rotation_euler = (numpy.radians(65), 0, numpy.radians(degrees_from_south))
    light = rendered(scene, size, size, 8, picture + ".top.png").mean(axis=2)
    os.remove(picture + ".top.png")
    return numpy.corrcoef(light.ravel(), slopes_to_north(size).ravel())[0, 1]


material = bpy.data.materials.new("paving")
principled = load_by_names(material)
check_sockets(material, principled)
the_scene, the_camera, the_sun = scene_of(material)
south = lit_from(the_scene, the_camera, the_sun, 0)
north = lit_from(the_scene, the_camera, the_sun, 180)
# With the green of DirectX these would have the other sign.
expect(south < -0.2 and north > 0.2, f"slopes to the north lit from the north alone, got {south:.2f} from the south, "
       f"{north:.2f} from the north")

the_camera.data.type, the_camera.data.lens = "PERSP", 35
the_camera.location = (0, -0.62 * height_m, 0.42 * height_m)
the_camera.rotation_euler = (numpy.radians(54), 0, 0)
the_sun.rotation_euler = (numpy.radians(62), 0, numpy.radians(125))
pixels = rendered(the_scene, 320, 240, 24, picture)
lower = pixels[:140].mean(axis=2)
expect(0.1 < lower.mean() < 0.7, f"a picture that is neither dark nor burnt out, got {lower.mean():.3f}")
expect(lower.std() > 0.04, f"stones and joints to be told apart, got a deviation of {lower.std():.3f}")
print(f"textures: ok (from the south {south:.2f}, from the north {north:.2f}, mean {lower.mean():.3f}, "
      f"deviation {lower.std():.3f})")
