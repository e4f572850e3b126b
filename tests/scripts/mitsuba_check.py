# Checks of a scene that was exported for Mitsuba 3, run by its own Python (mitsuba_test.sh):
#   picture SCENE.exr                     a picture that is neither black nor empty
#   light pane SCENE.xml                  what a bare pane lets through, in Mitsuba
#   light pane SCENE.pov-folder THING     the same in POV-Ray
#   masks SCENE.toml FOLDER [SHARE]       POV-Ray and Mitsuba show the same things in the same places, on 0.98 of the pixels
#   plant FAULT FROM.xml TO.xml           a copy of a scene with a fault: winding, unit, ior
# FOLDER holds what was exported for Mitsuba, POV-Ray and as JSON. Prints what it measured; exits with 1 where something is wrong.
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tomllib
import xml.etree.ElementTree as xml

import mitsuba
import numpy

mitsuba.set_variant("scalar_rgb")

IOR = 1.52
# Of Shatterpave_Glass: what a millimetre takes of red, green and blue, as its negative logarithm.
ABSORPTION = numpy.array([0.25, 0.08, 0.16]) / 60.0


def expect(condition, what):
    if not condition:
        print("mitsuba: expected", what)
        sys.exit(1)


def pixels(path):
    picture = mitsuba.Bitmap(path).convert(mitsuba.Bitmap.PixelFormat.RGB, mitsuba.Struct.Type.Float32, False)
    return numpy.array(picture)


# ---- light


def let_through(degrees, thickness_mm):
    """(1 - R) / (1 + R) of unpolarised light, times what the glass takes of it on its way from face to face."""
    cosine = math.cos(math.radians(degrees))
    inside = math.sqrt(1 - (1 - cosine**2) / IOR**2)
    across = (cosine - IOR * inside) / (cosine + IOR * inside)
    along = (IOR * cosine - inside) / (IOR * cosine + inside)
    reflected = (across**2 + along**2) / 2
    return (1 - reflected) / (1 + reflected) * numpy.exp(-ABSORPTION * thickness_mm / inside)


def bright_behind(path):
    """A lat-long picture that is white where z < 0 and black elsewhere; Mitsuba begins it at -z."""
    place = (numpy.arange(512) + 0.5) / 512
    picture = numpy.zeros((256, 512, 3), numpy.float32)
    picture[:, (place < 0.25) | (place > 0.75)] = 1
    mitsuba.Bitmap(picture).write(path)


def seen_in_mitsuba(scene, at_mm, degrees, samples):
    tree = xml.parse(scene)
    root = tree.getroot()
    for element in list(root):
        if element.tag in ("sensor", "emitter") or element.get("type") == "disk":
            root.remove(element)
    folder = os.path.dirname(scene)
    bright_behind(os.path.join(folder, "behind.exr"))
    angle = math.radians(degrees)
    x, y = at_mm[0] / 1000, at_mm[1] / 1000
    origin = f"{x - 0.3 * math.sin(angle)}, {y}, {0.3 * math.cos(angle)}"
    root.append(
        xml.fromstring('<emitter type="envmap"><string name="filename" value="behind.exr"/></emitter>')
    )
    root.append(
        xml.fromstring(
            '<sensor type="orthographic"><transform name="to_world"><scale value="0.001"/>'
            f'<lookat origin="{origin}" target="{x}, {y}, 0" up="0, 1, 0"/></transform>'
            '<film type="hdrfilm"><integer name="width" value="16"/><integer name="height" value="16"/>'
            '<rfilter type="box"/><string name="component_format" value="float32"/></film>'
            f'<sampler type="independent"><integer name="sample_count" value="{samples}"/></sampler></sensor>'
        )
    )
    changed = os.path.join(folder, "bare-light.xml")
    tree.write(changed)
    return numpy.array(mitsuba.render(mitsuba.load_file(changed)))[..., :3].mean((0, 1))


def rendered_by_povray(folder, text, width, height, options=()):
    with open(os.path.join(folder, "check.pov"), "w", encoding="utf-8") as file:
        file.write(text)
    command = ["povray", "-D", "+Icheck.pov", f"+W{width}", f"+H{height}", "-GA", "-A", *options]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    expect(done.returncode == 0, "POV-Ray to render:\n" + done.stderr[-2000:])


def seen_in_povray(folder, thing, at_mm, degrees):
    angle = math.radians(degrees)
    rendered_by_povray(
        folder,
        f"""#version 3.7;
global_settings {{ assumed_gamma 1 max_trace_level 32 adc_bailout 1e-6 }}
#include "{thing}.inc"
sky_sphere {{ pigment {{ gradient z color_map {{ [0.5 rgb 0] [0.5 rgb 1] }} scale 2 translate -z }} }}
object {{ {thing}_Pane }}
camera {{
   orthographic location <{at_mm[0] - 300 * math.sin(angle)}, {at_mm[1]}, {-300 * math.cos(angle)}>
   look_at <{at_mm[0]}, {at_mm[1]}, 0> right x * 2 up y * 2
}}
""",
        8,
        8,
        ["+FE", "+Ocheck.exr"],
    )
    return pixels(os.path.join(folder, "check.exr")).mean((0, 1))


def check_light(folder, name, thing, thickness_mm, at_mm):
    """Bright behind, black before."""
    for degrees in (0, 45, 60, 75):
        right = let_through(degrees, thickness_mm)
        for renderer, seen in (
            ("Mitsuba", seen_in_mitsuba(os.path.join(folder, name + ".xml"), at_mm, degrees, 4096)),
            ("POV-Ray", seen_in_povray(folder, thing, at_mm, degrees)),
        ):
            off = numpy.abs(seen / right - 1).max()
            print(f"{renderer} at {degrees} degrees: {numpy.round(seen, 4)}, {100 * off:.2f} % off")
            expect(off <= 0.005, f"{numpy.round(right, 4)} within 0.5 %")


# ---- masks


def bodies_of(path):
    """Names of the bodies of a mesh by their number, and the number of each face."""
    with open(path, "rb") as file:
        content = file.read()
    end = content.index(b"end_header\n") + len(b"end_header\n")
    names = dict(re.findall(r"^comment body (\d+) (\S+)", content[:end].decode(), re.MULTILINE))
    vertices = int(re.search(rb"element vertex (\d+)", content).group(1))
    faces = int(re.search(rb"element face (\d+)", content).group(1))
    kind = numpy.dtype([("count", "u1"), ("corners", "<i4", 3), ("body", "<f4")])
    expect(len(content) == end + 32 * vertices + 17 * faces, path + " of that length")
    table = numpy.frombuffer(content, kind, faces, end + 32 * vertices)
    return {int(number): name for number, name in names.items()}, table["body"].astype(int)


def is_seen(element):
    return element.get("type") != "disk" and not element.get("id", "").endswith(".water")


def mitsuba_mask(scene, size, with_slabs):
    """Names of what is first met by rays through the middles of pixels; "" where nothing is. Faces look towards the ray."""
    tree = xml.parse(scene)
    root = tree.getroot()
    faces = {}
    glass = [e for e in root.iter("shape") if e.get("id", "").endswith((".glass_old", ".glass_crushed"))]
    for element in list(root):
        if element.tag == "shape" and (not is_seen(element) or (not with_slabs and element in glass)):
            root.remove(element)
    folder = os.path.dirname(scene)
    for element in root.iter("shape"):
        if element.get("type") == "ply":
            faces[element.get("id")] = bodies_of(os.path.join(folder, element.find("string").get("value")))
    changed = os.path.join(folder, "masks.xml")
    tree.write(changed)
    loaded = mitsuba.load_file(changed, optimize=False, width=size[0], height=size[1])
    sensor = loaded.sensors()[0]
    mask = numpy.full((size[1], size[0]), "", dtype=object)
    turned = 0
    for row in range(size[1]):
        for column in range(size[0]):
            place = [(column + 0.5) / size[0], (row + 0.5) / size[1]]
            ray, _ = sensor.sample_ray(0, 0.5, place, [0.5, 0.5])
            met = loaded.ray_intersect(ray)
            if not met.is_valid():
                continue
            if met.instance is not None:
                mask[row, column] = met.instance.id()
            else:
                names, numbers = faces[met.shape.id()]
                mask[row, column] = names[numbers[met.prim_index]]
            if not met.shape.id().endswith((".cracks", ".glass_crushed")):
                turned += float(numpy.dot(met.n, ray.d)) > 0
    seen = numpy.count_nonzero(mask != "")
    print(f"Mitsuba: {seen} px of {len(set(mask.flat)) - 1} bodies")
    expect(turned <= 0.001 * seen, f"faces that look towards the ray, not {turned} of {seen} that look away")
    return mask


def povray_camera(camera):
    def place(at):
        return f"<{at[0]}, {at[2]}, {at[1]}>"

    return (
        f"camera {{ perspective location {place(camera['at_mm'])} sky y right x * image_width / image_height up y\n"
        f"   angle {camera['field_of_view_deg']} look_at {place(camera['look_at_mm'])} }}\n"
    )


def colour_of(number):
    return f"rgb <{number // 65536 % 256}, {number // 256 % 256}, {number % 256}> / 255"


def flat(number):
    return f"texture {{ pigment {{ {colour_of(number)} }} finish {{ ambient 0 diffuse 0 emission 1 }} }}"


def crack_objects(text, thing, names):
    """The cracks of an include in colours of their own: their declarations name each before its meshes."""
    objects = []
    for declaration in re.findall(rf"#declare {thing}_Cracks_\d+ =\n(.*?)\n\n", text, re.DOTALL):
        number = 0
        for line in declaration.split("\n"):
            found = re.search(r"// crack (\d+)", line)
            if found:
                names.append(f"{thing}.crack-{found.group(1)}")
                number = len(names)
            if line.strip() == "inside_vector z":
                line = flat(number)
            objects.append(line)
    return "\n".join(objects) + "\n"


def shard_objects(text, thing, names):
    objects = []
    for macro, number in re.findall(rf"^#macro ({thing}_Shard_\d+)\(Old, Broken\) // (\S+),", text, re.MULTILINE):
        names.append(f"{thing}.{number}")
        objects.append(f"object {{ {macro}({flat(len(names))}, {flat(len(names))}) }}\n")
    return "".join(objects)


def povray_glass_mask(folder, thing, camera, size):
    with open(os.path.join(folder, thing + ".inc"), encoding="utf-8") as file:
        text = file.read()
    names = []
    objects = shard_objects(text, thing, names) or crack_objects(text, thing, names)
    scene = f'#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\n#include "{thing}.inc"\n'
    # Written as they are: no curve between a number and its pixel.
    rendered_by_povray(
        folder, scene + povray_camera(camera) + objects, *size, ["+FN8", "+Ocheck.png", "File_Gamma=1.0"]
    )
    picture = numpy.array(mitsuba.Bitmap(os.path.join(folder, "check.png")))[..., :3].astype(int)
    numbers = picture[..., 0] * 65536 + picture[..., 1] * 256 + picture[..., 2]
    return numpy.array(["", *names], dtype=object)[numbers]


def povray_stone_mask(folder, pavement, camera, size):
    """By the place of what is seen, which is within the outline of a stone."""
    thing = pavement["name"]
    outline = numpy.array(pavement["outline_mm"])
    low, width = outline.min(0) - 1000, float((outline.max(0) - outline.min(0)).max() + 2000)
    texture = f"""
#macro {thing}_Stone_Texture(Tone)
   texture {{
      pigment {{ average pigment_map {{
         [1 gradient x color_map {{ [0 rgb 0] [1 rgb <2, 0, 0>] }} scale {width} translate {low[0]} * x]
         [1 gradient z color_map {{ [0 rgb 0] [1 rgb <0, 2, 0>] }} scale {width} translate {low[1]} * z] }} }}
      finish {{ ambient 0 diffuse 0 emission 1 }}
   }}
#end
#macro {thing}_Bed_Texture() texture {{ pigment {{ rgb <0, 0, 1> }} finish {{ ambient 0 diffuse 0 emission 1 }} }} #end
"""
    scene = f'#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\n{texture}#include "{thing}.inc"\n'
    rendered_by_povray(
        folder,
        scene + povray_camera(camera) + f"object {{ {thing}_Stones }}\nobject {{ {thing}_Bed }}\n",
        *size,
        ["+FN16", "+Ocheck.png", "File_Gamma=1.0"],
    )
    picture = numpy.array(mitsuba.Bitmap(os.path.join(folder, "check.png"))).astype(float) / 65535
    mask = numpy.full(picture.shape[:2], "", dtype=object)
    mask[picture[..., 2] > 0.5] = f"{thing}.joints"
    stones = (picture[..., 2] < 0.5) & (picture[..., 0] > 0)
    places = picture[..., :2][stones] * width + low
    found = numpy.full(len(places), "?", dtype=object)
    for stone in pavement["stones"]:
        corners = numpy.array(stone["outline_mm"])
        near = numpy.flatnonzero(((places > corners.min(0)) & (places < corners.max(0))).all(1))
        inside = numpy.zeros(len(near), bool)
        for a, b in zip(corners, numpy.roll(corners, -1, 0)):
            crosses = (a[1] > places[near, 1]) != (b[1] > places[near, 1])
            with numpy.errstate(divide="ignore", invalid="ignore"):
                x = a[0] + (places[near, 1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1])
            inside ^= crosses & (places[near, 0] < x)
        found[near[inside]] = f"{thing}.{stone['id']}"
    mask[stones] = found
    return mask


def check_masks(scene_file, folder, least_share="0.98"):
    name = os.path.splitext(os.path.basename(scene_file))[0]
    with open(scene_file, "rb") as file:
        scene = tomllib.load(file)
    with open(os.path.join(folder, name + ".json"), encoding="utf-8") as file:
        geometry = json.load(file)
    size = scene["camera"]["size_px"]
    camera = {"field_of_view_deg": 40, **scene["camera"]}
    if geometry["panes"]:
        pane = geometry["panes"][0]
        right = povray_glass_mask(folder, pane["name"], camera, size)
        seen = mitsuba_mask(os.path.join(folder, name + ".xml"), size, "shards" in scene["pane"][0])
        for mask in (right, seen):  # what only Mitsuba names
            mask[[[".crushed-" in one for one in row] for row in mask]] = ""
    else:
        right = povray_stone_mask(folder, geometry["pavements"][0], camera, size)
        seen = mitsuba_mask(os.path.join(folder, name + ".xml"), size, True)
    any_of_both = (right != "") | (seen != "")
    whole = numpy.count_nonzero(any_of_both & (right == seen)) / max(1, numpy.count_nonzero(any_of_both))
    covered = numpy.count_nonzero((right != "") & (seen != "")) / max(1, numpy.count_nonzero(any_of_both))
    shares = []
    for one in set(right[any_of_both]) | set(seen[any_of_both]):
        both = numpy.count_nonzero((right == one) & (seen == one))
        either = numpy.count_nonzero((right == one) | (seen == one))
        if one and max(numpy.count_nonzero(right == one), numpy.count_nonzero(seen == one)) > 50:
            shares.append(both / either)
    expect(len(shares) >= 5, f"five ids of more than 50 px at least, not {len(shares)}")
    least = float(numpy.percentile(shares, 5))
    print(
        f"{name}: over union {covered:.4f} of what is seen, {whole:.4f} with its ids; "
        f"{least:.3f} at the 5th percentile of {len(shares)} ids"
    )
    expect(covered >= 0.98 and whole >= float(least_share), f"{least_share} of all")
    expect(least >= 0.8, "0.8 at the 5th percentile")


# ---- faults


def changed_mesh(path, fault):
    with open(path, "rb") as file:
        content = bytearray(file.read())
    start = content.index(b"end_header\n") + len(b"end_header\n")
    vertices = int(re.search(rb"element vertex (\d+)", content).group(1))
    points = numpy.frombuffer(content, "<f4", 8 * vertices, start).reshape(-1, 8).copy()
    kind = numpy.dtype([("count", "u1"), ("corners", "<i4", 3), ("body", "<f4")])
    table = numpy.frombuffer(content, kind, -1, start + 32 * vertices).copy()
    if fault == "unit":
        points[:, :3] *= 1000
    else:
        table["corners"] = table["corners"][:, ::-1]
    with open(path, "wb") as file:
        file.write(content[:start] + points.tobytes() + table.tobytes())


def plant(fault, folder, name, to):
    shutil.copytree(folder, to)
    if fault == "ior":
        path = os.path.join(to, name + ".xml")
        with open(path, encoding="utf-8") as file:
            text = file.read()
        expect('name="int_ior" value="1.52"' in text, "glass of 1.52")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text.replace('name="int_ior" value="1.52"', 'name="int_ior" value="1"'))
        return
    for file in os.listdir(to):
        if file.startswith(name + "-") and file.endswith(".ply"):
            changed_mesh(os.path.join(to, file), fault)


def check_picture(path):
    picture = pixels(path)
    expect(numpy.isfinite(picture).all(), "numbers in " + path)
    mean = picture.mean()
    print(f"{os.path.basename(path)}: mean {mean:.3f}, deviation {picture.std():.3f}")
    expect(0.02 < mean < 20 and picture.std() > 0.02, "a picture that is neither black nor empty")


what, *arguments = sys.argv[1:]
if what == "picture":
    for path in arguments:
        check_picture(path)
elif what == "light":
    folder, name, thing, thickness, x, y = arguments
    check_light(folder, name, thing, float(thickness), (float(x), float(y)))
elif what == "masks":
    check_masks(*arguments)
elif what == "plant":
    plant(*arguments)
