# Run by the Python of build/validators/usd, which has usd-core, MaterialX and numpy:
#   usd_check.py SCENE.usda SCENE.json     all rules of ComplianceChecker and UsdValidation, and every prim against the JSON
#   usd_check.py --plant SCENE.usda SCENE.json    whether these find faults that are planted in a copy
#   usd_check.py --define FOLDER           MaterialX's own definitions of shaders, for the registry of usd-core, which has none
# Prints what is wrong, a line each.
import json
import os
import sys

import numpy
from pxr import Gf, Usd, UsdGeom, UsdLux, UsdShade, UsdUtils, UsdValidation

DIELECTRIC = "ND_standard_surface_surfaceshader"
# How far from 1 : 1 a place in a texture may move when one walks over a facet, in the direction in which it is nearest to that. Walls
# of gaps lean and twist: their places are along the crack and up.
UV_TOLERANCE = 0.02
UV_TOLERANCE_OF_GAPS = 0.25

faults = []


def expect(condition, what):
    if not condition:
        faults.append(what)
    return condition


def near(a, b, tolerance):
    return numpy.allclose(a, b, rtol=0, atol=tolerance)


def define(folder):
    import MaterialX

    library = MaterialX.createDocument()
    MaterialX.loadLibraries(MaterialX.getDefaultDataLibraryFolders(), MaterialX.getDefaultDataSearchPath(), library)
    types = {"float": "float", "color3": "color3f", "vector3": "float3", "boolean": "bool"}
    lines = ["#usda 1.0", f'def Shader "{DIELECTRIC}"', "{"]
    lines += [f'    uniform token info:id = "{DIELECTRIC}"', '    uniform token info:implementationSource = "sourceAsset"']
    lines += [f"    uniform asset info:sourceAsset = @./{DIELECTRIC}.usda@"]
    for given in library.getNodeDef(DIELECTRIC).getActiveInputs():
        lines.append(f"    {types[given.getType()]} inputs:{given.getName()}")
    lines += ["    token outputs:out", "}", ""]
    with open(os.path.join(folder, DIELECTRIC + ".usda"), "w") as file:
        file.write("\n".join(lines))


def check_rules(path, stage):
    checker = UsdUtils.ComplianceChecker()
    checker.CheckCompliance(path)
    for told in checker.GetErrors() + checker.GetFailedChecks() + checker.GetWarnings():
        expect(False, told)
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    for error in UsdValidation.ValidationContext(validators).Validate(stage):
        expect(False, f"{error.GetName()}: {error.GetMessage()}")


class Element:
    """A pane's or pavement's child: its mesh, in metres of its own and in the world's."""

    def __init__(self, prim, cache):
        self.prim = prim
        self.name = prim.GetName()
        self.kind = prim.GetAttribute("userProperties:kind").Get()
        self.id = prim.GetAttribute("userProperties:id").Get()
        mesh = prim
        if not prim.IsA(UsdGeom.Mesh):
            mesh = prim.GetFilteredChildren(Usd.TraverseInstanceProxies())[0]
        self.mesh = UsdGeom.Mesh(mesh)
        self.own = numpy.array(self.mesh.GetPointsAttr().Get(), dtype=float)
        self.corners = numpy.array(self.mesh.GetFaceVertexIndicesAttr().Get()).reshape(-1, 3)
        matrix = numpy.array(cache.GetLocalToWorldTransform(mesh))
        self.turn = matrix[:3, :3].T
        self.shift = matrix[3, :3]
        self.points = self.own @ self.turn.T + self.shift

    def bounds(self):
        return self.points.min(axis=0), self.points.max(axis=0)

    def values(self, name):
        """Of the corners of each facet."""
        primvar = UsdGeom.PrimvarsAPI(self.mesh).GetPrimvar(name)
        if primvar.HasValue():
            values = numpy.array(primvar.ComputeFlattened(), dtype=float)
            interpolation = primvar.GetInterpolation()
        else:
            values = numpy.array(self.mesh.GetNormalsAttr().Get(), dtype=float)
            interpolation = self.mesh.GetNormalsInterpolation()
        if interpolation == "vertex":
            return values[self.corners]
        return values.reshape(len(self.corners), 3, -1)


def check_mesh(element):
    path = element.mesh.GetPath()
    mesh = element.mesh
    expect(mesh.GetSubdivisionSchemeAttr().Get() == "none", f"{path}: subdivisionScheme none")
    expect(mesh.GetOrientationAttr().Get() == "rightHanded", f"{path}: a right-handed orientation")
    expect((numpy.array(mesh.GetFaceVertexCountsAttr().Get()) == 3).all(), f"{path}: triangles")
    extent = numpy.array(mesh.GetExtentAttr().Get(), dtype=float)
    expect(near(extent, [element.own.min(axis=0), element.own.max(axis=0)], 1e-6), f"{path}: extent of its points")
    expect(len(numpy.unique(element.own, axis=0)) == len(element.own), f"{path}: points at places of their own")
    a, b, c = (element.own[element.corners[:, k]] for k in range(3))
    across = numpy.cross(b - a, c - a)
    size = numpy.linalg.norm(across, axis=1)
    # Stones' corners run out in points, where a patch has a side without length.
    expect((size > 0).all(), f"{path}: no facet without area")
    normals = element.values("normals")
    expect(near(numpy.linalg.norm(normals, axis=2), 1, 1e-3), f"{path}: normals of unit length")
    facing = numpy.einsum("ij,ikj->ik", across / numpy.maximum(size, 1e-30)[:, None], normals)
    # Patches of cut stones fold over a little in their sharpest corners.
    expect(size[facing.mean(axis=1) <= 0].sum() < 0.01 * size.sum(), f"{path}: facets counter-clockwise about their normals")
    check_places(element, across, size)
    subsets = [UsdGeom.Subset(child) for child in element.mesh.GetPrim().GetChildren() if child.IsA(UsdGeom.Subset)]
    if subsets:
        found = numpy.concatenate([numpy.array(subset.GetIndicesAttr().Get()) for subset in subsets])
        expect(sorted(found) == list(range(len(element.corners))), f"{path}: each facet in one GeomSubset")


def check_places(element, across, size):
    corners = element.own[element.corners]
    places = element.values("st")
    first = corners[:, 1] - corners[:, 0]
    second = corners[:, 2] - corners[:, 0]
    large = size > 1e-9
    along = first[large] / numpy.linalg.norm(first[large], axis=1)[:, None]
    normal = across[large] / size[large][:, None]
    aside = numpy.cross(normal, along)
    dot = lambda p, q: numpy.einsum("ij,ij->i", p, q)
    plane = numpy.stack([[dot(first[large], along), dot(second[large], along)],
                         [dot(first[large], aside), dot(second[large], aside)]]).transpose(2, 0, 1)
    texture = numpy.stack([places[large, 1] - places[large, 0], places[large, 2] - places[large, 0]], axis=2)
    if not len(plane):
        return
    stretch = numpy.linalg.svd(texture @ numpy.linalg.inv(plane), compute_uv=False)
    nearest = numpy.take_along_axis(stretch, numpy.abs(stretch - 1).argmin(axis=1)[:, None], axis=1)
    middle = numpy.median(nearest)
    tolerance = UV_TOLERANCE_OF_GAPS if element.kind.startswith("crack") else UV_TOLERANCE
    expect(abs(middle - 1) <= tolerance, f"{element.mesh.GetPath()}: places in textures in metres, got {middle:.4f} a metre")


def check_materials(element):
    bound = [element.mesh.GetPrim()] + [p for p in element.mesh.GetPrim().GetChildren() if p.IsA(UsdGeom.Subset)]
    for prim in bound:
        material = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()[0]
        if not expect(material, f"{prim.GetPath()}: a material"):
            continue
        glass = element.kind.split()[0] in ("pane", "shard", "crack", "crushed", "hole")
        expect(glass == material.GetPrim().GetName().startswith("glass"), f"{prim.GetPath()}: glass only on glass")


def value(shader, name):
    given = shader.GetInput(name)
    return given.Get() if given else None


def check_textures(surface):
    """What is connected is a picture that is there, read as what it is."""
    for given in surface.GetInputs():
        sources, broken = given.GetConnectedSources()
        expect(not broken, f"{given.GetAttr().GetPath()}: connections to what is there, got {broken}")
        for source in sources:
            picture = UsdShade.Shader(source.source.GetPrim())
            path = picture.GetPath()
            expect(picture.GetShaderId() == "UsdUVTexture", f"{path}: a texture")
            expect(picture.GetOutput(source.sourceName), f"{path}: an output {source.sourceName}")
            expect(os.path.isfile(value(picture, "file").resolvedPath), f"{path}: its picture beside the layer")
            space = "sRGB" if given.GetBaseName() == "diffuseColor" else "raw"
            expect(value(picture, "sourceColorSpace") == space, f"{path}: {space}")
            if given.GetBaseName() == "normal":
                expect(value(picture, "scale") == (2, 2, 2, 1) and value(picture, "bias") == (-1, -1, -1, 0), f"{path}: -1 to 1")


def check_material(prim):
    material = UsdShade.Material(prim)
    path = prim.GetPath()
    surface = material.ComputeSurfaceSource()[0]
    if not expect(surface and surface.GetShaderId() == "UsdPreviewSurface", f"{path}: a UsdPreviewSurface"):
        return
    expect(value(surface, "metallic") == 0, f"{path}: no metal")
    check_textures(surface)
    clear = prim.GetName().startswith("glass") or prim.GetName().endswith("_water")
    ior = 1.52 if prim.GetName().startswith("glass") else 1.333
    if not clear:
        expect(value(surface, "opacity") in (None, 1), f"{path}: opaque stone")
        return
    expect(abs(value(surface, "ior") - ior) < 1e-6, f"{path}: ior {ior}")
    expect(0 < value(surface, "opacity") <= 0.5, f"{path}: light that goes through")
    expect(value(surface, "opacityThreshold") in (None, 0), f"{path}: nothing cut out")
    dielectric = material.ComputeSurfaceSource("mtlx")[0]
    if expect(dielectric and dielectric.GetShaderId() == DIELECTRIC, f"{path}: a standard_surface"):
        expect(value(dielectric, "transmission") == 1, f"{path}: transmission 1")
        expect(value(dielectric, "base") == 0, f"{path}: base 0")
        expect(value(dielectric, "metalness") == 0, f"{path}: metalness 0")
        expect(abs(value(dielectric, "specular_IOR") - ior) < 1e-6, f"{path}: specular_IOR {ior}")


def volume(element):
    a, b, c = (element.own[element.corners[:, k]] for k in range(3))
    return numpy.einsum("ij,ij->", a, numpy.cross(b, c)) / 6


def upward_area(element):
    """What a surface covers, seen from above; 0 of a closed one."""
    a, b, c = (element.points[element.corners[:, k]] for k in range(3))
    return numpy.cross(b - a, c - a)[:, 1].sum() / 2


# The world of the JSON (mm, z up) in metres, y up.
def upright(points_mm):
    points = numpy.array(points_mm, dtype=float) / 1000
    return numpy.stack([points[:, 0], points[:, 2], -points[:, 1]], axis=1)


def placement(thing):
    at = upright([thing.get("place_mm", [0, 0, 0])])[0]
    turn = numpy.radians(thing.get("place_turn_deg", 0))
    c, s = numpy.cos(turn), numpy.sin(turn)
    return numpy.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]), at


def is_seen(element):
    """Where no frame is asked for."""
    return UsdGeom.Imageable(element.prim).ComputeVisibility() != UsdGeom.Tokens.invisible


def check_pane(pane, elements):
    name = pane["name"]
    turn, at = placement(pane)
    half = pane["thickness_mm"] / 2000
    outline = numpy.array(pane["outline_mm"]) / 1000
    local = lambda element: (element.points - at) @ turn
    if "shards" not in pane:
        slab = local(elements["slab"])
        for axis in (0, 1):
            expect(near([slab[:, axis].min(), slab[:, axis].max()], [outline[:, axis].min(), outline[:, axis].max()], 1e-6),
                   f"{name}: a slab of the outline's size")
        expect(near([slab[:, 2].min(), slab[:, 2].max()], [-half, half], 1e-6), f"{name}: a slab as thick as the pane")
        check_cracks(pane, elements, local)
        return
    there = {shard["id"]: shard for shard in pane["shards"] if shard["state"] != "missing"}
    found = {element.id: element for element in elements.values() if element.kind.startswith("shard") and is_seen(element)}
    expect(there.keys() == found.keys(), f"{name}: the shards of the JSON")
    for key in there.keys() & found.keys():
        shard, element = there[key], found[key]
        expect(element.kind == "shard " + shard["state"], f"{name}: shard {key} {shard['state']}")
        motion = numpy.array(shard["transform"]).reshape(3, 4)
        expect(near(element.turn, turn @ motion[:, :3], 1e-5), f"{name}: shard {key} turned as in the JSON")
        # Where it was in the pane: about its own middle, and that moved back.
        middle = motion[:, :3].T @ (turn.T @ (element.shift - at) - motion[:, 3] / 1000)
        was = element.own + middle
        face = numpy.array(shard["outline_mm"]) / 1000
        for axis in (0, 1):
            low, high = face[:, axis].min(), face[:, axis].max()
            expect(low - 2e-6 <= was[:, axis].min() and was[:, axis].max() <= high + 2e-6, f"{name}: shard {key} within its face")
            expect(was[:, axis].max() - was[:, axis].min() > 0.5 * (high - low), f"{name}: shard {key} as large as its face")
        expect(near([was[:, 2].min(), was[:, 2].max()], [-half, half], 2e-6), f"{name}: shard {key} as thick as the pane")


def check_cracks(pane, elements, local):
    cracks = {str(crack["id"]): crack for crack in [*pane["cracks"], *pane.get("far_cracks", [])]}
    found = {element.id: element for element in elements.values() if element.kind.startswith("crack")}
    # Short ones between others are left out where there is no room.
    large = {key for key, crack in cracks.items() if crack["kind"] == "large"}
    expect(len(large & found.keys()) >= 0.9 * len(large), f"{pane['name']}: its large cracks")
    # A slanted gap opens where the crack is, and on the other face beside it.
    margin = 0.003 + pane["thickness_mm"] / 1000
    for key, element in found.items():
        crack = cracks.get(key)
        if not expect(crack is not None and element.kind == "crack " + crack["kind"], f"{element.prim.GetPath()}: a crack"):
            continue
        # The two arms of a ring are one gap, which has the name of one of them.
        arms = [other for other in cracks.values() if other["kind"] == crack["kind"] == "circular"
                and other["points_mm"][0] == crack["points_mm"][0]] or [crack]
        points = numpy.concatenate([numpy.array(arm["points_mm"]) for arm in arms]) / 1000
        low, high = local(element).min(axis=0)[:2], local(element).max(axis=0)[:2]
        expect((low >= points.min(axis=0) - margin).all() and (high <= points.max(axis=0) + margin).all(),
               f"{element.prim.GetPath()}: along its crack")


def check_pavement(pavement, elements):
    name = pavement["name"]
    turn, at = placement(pavement)
    stones = {str(stone["id"]): stone for stone in pavement["stones"]}
    found = {element.id: element for element in elements.values() if element.kind.startswith("stone")}
    expect(stones.keys() == found.keys(), f"{name}: the stones of the JSON")
    expect("joints" in elements, f"{name}: joints")
    for key in stones.keys() & found.keys():
        stone, element = stones[key], found[key]
        expect(element.kind.split()[1] == stone["kind"], f"{name}: stone {key} {stone['kind']}")
        expect(upward_area(element) > 0, f"{name}: stone {key} with its face up")
        points = (element.points - at) @ turn
        outline = numpy.array(stone["outline_mm"]) / 1000
        low = numpy.array([points[:, 0].min(), -points[:, 2].max()])
        high = numpy.array([points[:, 0].max(), -points[:, 2].min()])
        # Of cut stones short sides and thin spikes are left out.
        least, most = outline.min(axis=0), outline.max(axis=0)
        off = 0.005 + (0.3 if stone["kind"] == "cut" else 0) * (most - least)
        inside = (low > least - 0.001).all() and (high < most + 0.001).all()
        expect(inside and (low < least + off).all() and (high > most - off).all(),
               f"{name}: stone {key} over its outline, got {low} {high}")


def check_camera(stage, camera, things_at):
    prims = [prim for prim in stage.Traverse() if prim.IsA(UsdGeom.Camera)]
    if not expect(len(prims) == 1, "one camera"):
        return
    prim = UsdGeom.Camera(prims[0])
    matrix = numpy.array(UsdGeom.XformCache().GetLocalToWorldTransform(prims[0]))
    right, up, back, at = matrix[:3, :3][0], matrix[:3, :3][1], matrix[:3, :3][2], matrix[3, :3]
    lens = prim.GetFocalLengthAttr().Get()
    film = prim.GetHorizontalApertureAttr().Get(), prim.GetVerticalApertureAttr().Get()
    # Both in tenths of a metre.
    expect(abs(film[0] - 0.36) < 1e-6, "film of 36 mm")
    expect(abs(right[1]) < 1e-6 and up[1] > -1e-6, "an upright picture")
    if camera is None:
        # All that there is lies before it and in the picture.
        seen = (things_at - at) @ matrix[:3, :3].T
        expect((seen[:, 2] < 0).all(), "things before the camera")
        places = [seen[:, axis] / -seen[:, 2] * lens / film[axis] for axis in (0, 1)]
        expect(max(numpy.abs(place).max() for place in places) < 0.5, "things in the picture")
        expect(max(numpy.ptp(place) for place in places) > 0.5, "things that fill half of the picture")
        return
    place, target = upright([camera["at_mm"]])[0], upright([camera["look_at_mm"]])[0]
    expect(near(at, place, 1e-6), "the camera's place")
    expect(near(-back, (target - place) / numpy.linalg.norm(target - place), 1e-6), "the camera's view")
    field = numpy.degrees(2 * numpy.arctan(0.5 * film[0] / lens))
    expect(abs(field - camera["field_of_view_deg"]) < 1e-4, f"the camera's field of view, got {field}")
    stop = prim.GetFStopAttr().Get()
    expect(abs(stop - camera.get("f_number", 0)) < 1e-6, f"the camera's f-number, got {stop}")
    if "focus_mm" in camera:
        expect(abs(prim.GetFocusDistanceAttr().Get() - camera["focus_mm"] / 1000) < 1e-6, "the camera's focus")
    if "size_px" in camera:
        width, height = camera["size_px"]
        expect(abs(film[0] / film[1] - width / height) < 1e-4, "the picture's shape")
        settings = stage.GetPrimAtPath(stage.GetMetadata("renderSettingsPrimPath"))
        expect(tuple(settings.GetAttribute("resolution").Get()) == (width, height), "the picture's size")
        expect(settings.GetRelationship("camera").GetTargets() == [prims[0].GetPath()], "settings with the camera")


def compass(azimuth_deg, elevation_deg=0):
    """From +y of the world, clockwise, and up; y up."""
    azimuth, elevation = numpy.radians(azimuth_deg), numpy.radians(elevation_deg)
    level = numpy.cos(elevation)
    return numpy.array([level * numpy.sin(azimuth), numpy.sin(elevation), -level * numpy.cos(azimuth)])


def check_lights(stage, light):
    given = light or {}
    cache = UsdGeom.XformCache()
    axis = lambda prim, k: numpy.array(cache.GetLocalToWorldTransform(prim))[k, :3]
    domes = [UsdLux.DomeLight(prim) for prim in stage.Traverse() if prim.IsA(UsdLux.DomeLight)]
    if expect(len(domes) == 1, "one dome"):
        dome = domes[0]
        expect(os.path.isfile(dome.GetTextureFileAttr().Get().resolvedPath), "the environment's picture beside the layer")
        expect(dome.GetTextureFormatAttr().Get() == "latlong", "a lat-long picture")
        expect(abs(dome.GetIntensityAttr().Get() - given.get("environment_gain", 1)) < 1e-6, "the environment's gain")
        expect(abs(dome.GetExposureAttr().Get() - given.get("exposure_ev", 0)) < 1e-6, "exposure")
        # The middle of its picture, which OpenUSD has at +z, is to the north.
        expect(near(axis(dome.GetPrim(), 2), compass(-given.get("environment_turn_deg", 0)), 1e-6), "the environment turned")
        expect(near(axis(dome.GetPrim(), 1), [0, 1, 0], 1e-6), "the environment upright")
    suns = [UsdLux.DistantLight(prim) for prim in stage.Traverse() if prim.IsA(UsdLux.DistantLight)]
    if light is None:
        expect(len(suns) == 1, "a sun")
        return
    expect(len(suns) == ("sun_azimuth_deg" in light), "a sun where there is one")
    for sun in suns:
        expect(abs(sun.GetAngleAttr().Get() - 0.53) < 1e-6, "a sun of 0.53 degrees")
        expect(sun.GetNormalizeAttr().Get(), "a sun as bright as it is said to be, whatever its size")
        # Three times what an environment of radiance 1 throws, at gain 1.
        expect(abs(sun.GetIntensityAttr().Get() - 3 * numpy.pi * light["sun_gain"]) < 1e-5, "the sun's gain")
        expect(abs(sun.GetExposureAttr().Get() - light["exposure_ev"]) < 1e-6, "exposure")
        towards = compass(light["sun_azimuth_deg"], light["sun_elevation_deg"])
        expect(near(axis(sun.GetPrim(), 2), towards, 1e-6), "the sun where it stands")


def check_stage(stage, geometry):
    root = stage.GetDefaultPrim()
    if not expect(root, "a default prim"):
        return
    expect(UsdGeom.GetStageMetersPerUnit(stage) == 1, "a unit of a metre")
    expect(UsdGeom.GetStageUpAxis(stage) == "Y", "y up")
    expect(Usd.ModelAPI(root).GetKind() == "assembly", "an assembly")
    expect(root.GetChild("geometry") and Usd.ModelAPI(root.GetChild("geometry")).GetKind() == "group", "a group")
    cache = UsdGeom.XformCache()
    things = {thing["name"]: thing for thing in geometry["panes"] + geometry["pavements"]}
    prims = {prim.GetMetadata("displayName") or prim.GetName(): prim for prim in root.GetChild("geometry").GetChildren()}
    expect(things.keys() == prims.keys(), f"a prim for each of {sorted(things)}, got {sorted(prims)}")
    every = []
    for name in things.keys() & prims.keys():
        prim = prims[name]
        expect(Usd.ModelAPI(prim).GetKind() == "component" and prim.IsModel(), f"{prim.GetPath()}: a component")
        children = [child for child in prim.GetChildren() if child.GetTypeName() in ("Mesh", "Xform")]
        elements = {child.GetName(): Element(child, cache) for child in children}
        for element in elements.values():
            expect(element.kind and Usd.ModelAPI(element.prim).GetKind() == "subcomponent", f"{element.name}: kinds")
            check_mesh(element)
            check_materials(element)
            if element.kind.startswith(("pane", "shard")):
                expect(volume(element) > 0, f"{element.prim.GetPath()}: a solid")
            if element.kind.startswith(("crack", "crushed", "hole")):
                expect(volume(element) < 0, f"{element.prim.GetPath()}: a cavity")
        every += [element.points for element in elements.values()]
        for material in prim.GetChild("materials").GetChildren():
            check_material(material)
        (check_pane if "thickness_mm" in things[name] else check_pavement)(things[name], elements)
    if every:
        check_camera(stage, geometry.get("camera"), numpy.concatenate(every))
    check_lights(stage, geometry.get("light"))


def first_mesh(stage):
    return next(UsdGeom.Mesh(prim) for prim in stage.Traverse() if prim.IsA(UsdGeom.Mesh))


def turn_winding(stage):
    corners = first_mesh(stage).GetFaceVertexIndicesAttr()
    corners.Set(numpy.array(corners.Get()).reshape(-1, 3)[:, ::-1].reshape(-1).tolist())


def turn_shape(stage):
    """Turned inside out, normals and all: only the volume tells."""
    turn_winding(stage)
    mesh = first_mesh(stage)
    primvar = UsdGeom.PrimvarsAPI(mesh).GetPrimvar("normals")
    normals = primvar if primvar.HasValue() else mesh.GetNormalsAttr()
    normals.Set([-normal for normal in normals.Get()])


def scale_places(stage):
    places = UsdGeom.PrimvarsAPI(first_mesh(stage)).GetPrimvar("st")
    places.Set([Gf.Vec2f(1.05 * place) for place in places.Get()])


def scale_all(stage):
    UsdGeom.Xformable(stage.GetDefaultPrim()).AddScaleOp().Set(Gf.Vec3f(1000))


def make_metal(stage):
    shader = next(UsdShade.Shader(prim) for prim in stage.Traverse() if prim.GetName() == "preview")
    shader.GetInput("metallic").Set(1)


def make_opaque(stage):
    shader = next(UsdShade.Shader(prim) for prim in stage.Traverse() if prim.GetName() == "dielectric")
    shader.GetInput("transmission").Set(0)


def bind_nothing(stage):
    UsdShade.MaterialBindingAPI(first_mesh(stage).GetPrim()).GetDirectBindingRel().SetTargets(["/nothing"])


def turn_dome(stage):
    dome = next(prim for prim in stage.Traverse() if prim.IsA(UsdLux.DomeLight))
    dome.GetAttribute("xformOp:orient").Set(Gf.Quatf(1))


def move_camera(stage):
    camera = next(prim for prim in stage.Traverse() if prim.IsA(UsdGeom.Camera))
    camera.GetAttribute("xformOp:translate").Set(1000 * camera.GetAttribute("xformOp:translate").Get())


def lens_in_mm(stage):
    camera = next(UsdGeom.Camera(prim) for prim in stage.Traverse() if prim.IsA(UsdGeom.Camera))
    for attribute in (camera.GetFocalLengthAttr(), camera.GetHorizontalApertureAttr(), camera.GetVerticalApertureAttr()):
        attribute.Set(100 * attribute.Get())


def lose_element(stage):
    stage.RemovePrim(next(p for p in stage.Traverse() if p.GetAttribute("userProperties:id").IsValid()).GetPath())


def move_element(stage):
    moved = next(p for p in stage.Traverse() if p.GetAttribute("xformOp:translate").IsValid())
    place = moved.GetAttribute("xformOp:translate")
    place.Set(place.Get() + Gf.Vec3d(0.05, 0, 0))


def shrink_unit(stage):
    UsdGeom.SetStageMetersPerUnit(stage, 0.001)


FAULTS = [turn_winding, turn_shape, scale_places, scale_all, shrink_unit, make_metal, make_opaque, bind_nothing, lose_element,
          move_element, turn_dome, move_camera, lens_in_mm]


def plant(source, geometry):
    for fault in FAULTS:
        stage = Usd.Stage.Open(source)
        stage.GetRootLayer().Reload(True)  # without the fault before
        fault(stage)
        faults.clear()
        check_stage(stage, geometry)
        if not faults:
            sys.exit(f"usd: a planted fault passes: {fault.__name__}")


if sys.argv[1] == "--define":
    define(sys.argv[2])
    sys.exit()
with open(sys.argv[-1]) as file:
    geometry = json.load(file)
if sys.argv[1] == "--plant":
    plant(sys.argv[2], geometry)
    sys.exit()
opened = Usd.Stage.Open(sys.argv[1])
check_stage(opened, geometry)
check_rules(sys.argv[1], opened)
for told in faults[:20]:
    print(f"usd: expected {told}")
if faults:
    sys.exit(f"usd: {sys.argv[1]}: {len(faults)} faults")
