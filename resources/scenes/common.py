"""Shared by the example scenes: command line, meshes, lights, camera, JPEG writing, ground truth.

Runs inside Blender 3.4 to 4.2 (`blender -b -noaudio --python SCENE.py -- OUT.jpg`) or with the
`bpy` package (`python SCENE.py -- OUT.jpg`), never inside FreeCAD.  All lengths given to these
functions are millimetres, z up; they become Blender's metres in one place only, `metres`.
"""

import argparse
import json
import math
import struct
import sys
from dataclasses import dataclass
from pathlib import Path

import bpy  # first: as a package it brings the other two

# isort: split
import bmesh
from mathutils import Matrix, Vector

MM = 0.001  # one millimetre in Blender units


def metres(point):
    """A point, vector or length in mm, in Blender's metres."""
    if isinstance(point, (int, float)):
        return point * MM
    return Vector([c * MM for c in point])


def parse_arguments(about):
    """The words after `--`: where to write the photo, and how fine."""
    words = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
    parser = argparse.ArgumentParser(description=about)
    parser.add_argument("out", type=Path, help="JPEG to write")
    parser.add_argument("--samples", type=int, default=150, help="most samples a pixel gets")
    parser.add_argument("--width", type=int, default=1600, help="pixels of the longer side")
    parser.add_argument("--truth", type=Path, help="also write the true camera here (JSON)")
    return parser.parse_args(words)


def empty_scene():
    """Forget Blender's default cube, light and camera; return the scene to fill."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.unit_settings.system = "METRIC"
    return scene


# Meshes ------------------------------------------------------------------------------------------


def add_mesh(name, vertices, faces, material, bevel=0.0, smooth_degrees=40):
    """An object from vertices (mm) and faces (index lists), its edges rounded by `bevel` mm."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([metres(v) for v in vertices], [], faces)
    tidy = bmesh.new()
    tidy.from_mesh(mesh)
    bmesh.ops.recalc_face_normals(tidy, faces=tidy.faces)
    tidy.to_mesh(mesh)
    tidy.free()
    mesh.materials.append(material)
    mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
    if hasattr(mesh, "use_auto_smooth"):
        mesh.use_auto_smooth = True
        mesh.auto_smooth_angle = math.radians(smooth_degrees)
    else:  # from Blender 4.1 on
        mesh.set_sharp_from_angle(angle=math.radians(smooth_degrees))
    thing = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(thing)
    if bevel:
        rounding = thing.modifiers.new("rounded edges", "BEVEL")
        rounding.width = metres(bevel)
        rounding.segments = 3
        rounding.limit_method = "ANGLE"
        rounding.angle_limit = math.radians(40)
    return thing


def add_prism(name, outline, z_from, z_to, material, bevel=0.0):
    """A closed outline [(x, y)] in mm pulled up from z_from to z_to."""
    count = len(outline)
    vertices = [(x, y, z) for z in (z_from, z_to) for x, y in outline]
    sides = [(i, (i + 1) % count, count + (i + 1) % count, count + i) for i in range(count)]
    caps = [tuple(range(count)), tuple(range(count, 2 * count))]
    return add_mesh(name, vertices, sides + caps, material, bevel)


def add_box(name, low, high, material, bevel=0.0):
    """A box between two opposite corners (mm)."""
    outline = [(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])]
    return add_prism(name, outline, low[2], high[2], material, bevel)


def add_lathe(name, profile, material, segments=96):
    """A profile [(radius, z)] in mm turned about the z axis."""
    vertices, faces = [], []
    for radius, z in profile:
        for step in range(segments):
            angle = 2 * math.pi * step / segments
            vertices.append((radius * math.cos(angle), radius * math.sin(angle), z))
    for ring in range(len(profile) - 1):
        for step in range(segments):
            a, b = ring * segments + step, ring * segments + (step + 1) % segments
            faces.append((a, b, b + segments, a + segments))
    return add_mesh(name, vertices, faces, material)


def add_tube(name, path, radius, material, taper=None, closed=False):
    """A round tube (mm) along a smooth curve; `taper` is its radius at each point, in parts."""
    curve = bpy.data.curves.new(name, "CURVE")
    curve.dimensions = "3D"
    curve.bevel_depth = metres(radius)
    curve.bevel_resolution = 6
    curve.resolution_u = 16
    curve.use_fill_caps = True
    spline = curve.splines.new("BEZIER")
    spline.bezier_points.add(len(path) - 1)
    spline.use_cyclic_u = closed
    for knot, point, share in zip(
        spline.bezier_points, path, taper or [1] * len(path), strict=True
    ):
        knot.co, knot.radius = metres(point), share
        knot.handle_left_type = knot.handle_right_type = "AUTO"
    curve.materials.append(material)
    thing = bpy.data.objects.new(name, curve)
    bpy.context.scene.collection.objects.link(thing)
    return thing


def place(things, at, turn_degrees=0.0, tip=None):
    """Move things to `at` (mm) from the origin, first tipped (a matrix), then turned about z."""
    where = Matrix.Translation(metres(at)) @ Matrix.Rotation(math.radians(turn_degrees), 4, "Z")
    if tip is not None:
        where = where @ tip
    for thing in things:
        thing.matrix_world = where @ thing.matrix_world
    return things


def bounds(things):
    """Smallest box (low, high) in mm round things as they are rendered."""
    bpy.context.view_layer.update()
    graph = bpy.context.evaluated_depsgraph_get()
    points = []
    for thing in things:
        final = thing.evaluated_get(graph)
        points += [final.matrix_world @ v.co for v in final.data.vertices]
    low = [min(p[axis] for p in points) / MM for axis in range(3)]
    high = [max(p[axis] for p in points) / MM for axis in range(3)]
    return low, high


# Light -------------------------------------------------------------------------------------------


def add_window_light(at, towards, size, watts, glazing_bar, panes=(2, 3), bar=45):
    """Daylight through a window `size` (mm) of panes parted by bars: soft light."""
    back = (metres(at) - metres(towards)).normalized()
    frame = back.to_track_quat("Z", "Y").to_matrix().to_4x4()
    frame.translation = metres(at)
    daylight = bpy.data.lights.new("window", "AREA")
    daylight.shape = "RECTANGLE"
    daylight.size, daylight.size_y = metres(size[0]), metres(size[1])
    daylight.energy = watts
    daylight.color = (1.0, 0.98, 0.95)
    window = bpy.data.objects.new("window", daylight)
    bpy.context.scene.collection.objects.link(window)
    window.matrix_world = frame
    wide, high, half = size[0] / 2, size[1] / 2, bar / 2
    for axis, (count, length) in enumerate(zip(panes, size, strict=True)):
        for index in range(1, count):
            middle = length * (index / count - 0.5)
            low, high_end = [-wide, -high, -40], [wide, high, -20]
            low[axis], high_end[axis] = middle - half, middle + half
            add_box("glazing bar", low, high_end, glazing_bar).matrix_world = frame


def set_room_fill(colour, strength):
    """Even light from everywhere: what the rest of the room throws back."""
    world = bpy.data.worlds.new("room")
    world.use_nodes = True
    background = world.node_tree.nodes["Background"]
    background.inputs["Color"].default_value = (*colour, 1)
    background.inputs["Strength"].default_value = strength
    bpy.context.scene.world = world


# Camera ------------------------------------------------------------------------------------------


@dataclass
class Camera:
    """A pinhole camera looking at `target` (mm) from `distance` mm away.

    `turn` is how far it stands to the right of straight in front (looking to +y), `elevation` how
    far above, both in degrees; `view` is the horizontal field of view of the upright photo in
    degrees.  `shift` moves the principal point from the photo's middle, px (a cropped photo).
    """

    target: tuple
    distance: float
    turn: float
    elevation: float
    view: float
    size_px: tuple = (1600, 1200)
    shift: tuple = (0.0, 0.0)

    def position(self):
        turn, up = math.radians(self.turn), math.radians(self.elevation)
        back = Vector((math.sin(turn) * math.cos(up), -math.cos(turn) * math.cos(up), math.sin(up)))
        return Vector(self.target) + back * self.distance

    def rotation(self):
        """Rows: the camera's x (right), y (down) and z (forward) axes in the world."""
        forward = (Vector(self.target) - self.position()).normalized()
        right = forward.cross(Vector((0, 0, 1))).normalized()
        return Matrix((right, forward.cross(right), forward))

    def add_to_scene(self):
        """A camera held upright, or turned on its side for a portrait (see `render_jpeg`)."""
        portrait = self.size_px[1] > self.size_px[0]
        lens = bpy.data.cameras.new("camera")
        wide = max(self.size_px)
        lens.sensor_fit = "HORIZONTAL"
        lens.angle = 2 * math.atan(wide / 2 / self.focal_px())
        lens.clip_start, lens.clip_end = 0.01, 100
        lens.shift_x, lens.shift_y = -self.shift[0] / wide, self.shift[1] / wide
        thing = bpy.data.objects.new("camera", lens)
        right, down, forward = self.rotation()
        if portrait:  # the camera's top points to the left
            right, down = down, -right
        axes = Matrix((right, -down, -forward)).transposed().to_4x4()
        thing.matrix_world = Matrix.Translation(metres(self.position())) @ axes
        bpy.context.scene.collection.objects.link(thing)
        bpy.context.scene.camera = thing

    def focal_px(self):
        return self.size_px[0] / 2 / math.tan(math.radians(self.view) / 2)

    def truth(self):
        """x_cam = R @ x_world + t in mm, u = focal * x / z + cx; (0, 0) is the top-left corner."""
        rotation, (width, height) = self.rotation(), self.size_px
        return {
            "image_size_px": [width, height],
            "focal_px": self.focal_px(),
            "principal_point_px": [width / 2 + self.shift[0], height / 2 + self.shift[1]],
            "rotation_cam_from_world": [list(row) for row in rotation],
            "translation_cam_from_world_mm": list(-(rotation @ self.position())),
        }


# Output ------------------------------------------------------------------------------------------


def box_corners(low, high):
    """The eight corners of a box, named such as front_left_bottom (front is -y, left is -x)."""
    return {
        f"{depth}_{side}_{level}": [x, y, z]
        for level, z in (("bottom", low[2]), ("top", high[2]))
        for depth, y in (("front", low[1]), ("back", high[1]))
        for side, x in (("left", low[0]), ("right", high[0]))
    }


def write_truth(path, about, camera, **things):
    """What the photo really shows, for checking a reconstruction and nothing else."""
    truth = {"about": about, "camera": camera.truth(), **things}
    path.write_text(json.dumps(truth, indent=1) + "\n", encoding="utf-8")


def finish(wanted, camera, about, exposure=0.0, look="None", exif=None, **things):
    """Render the scene as seen by the camera, and write the truth if that is wanted."""
    camera.add_to_scene()
    share = wanted.width / max(camera.size_px)
    size = [round(share * side) for side in camera.size_px]
    render_jpeg(wanted.out, size, wanted.samples, exposure, look)
    portrait = camera.size_px[1] > camera.size_px[0]
    if exif or portrait:
        jpeg = wanted.out.read_bytes()
        wanted.out.write_bytes(with_exif(jpeg, 6 if portrait else 1, exif or 0))
    if wanted.truth:
        write_truth(wanted.truth, about, camera, **things)


def render_jpeg(out, size_px, samples, exposure=0.0, look="None", quality=88):
    """Render with Cycles on the CPU and write a JPEG that carries no stamps.

    A portrait is written lying on its side, as cameras do.
    """
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples = samples
    scene.cycles.use_adaptive_sampling = True
    scene.cycles.adaptive_threshold = 0.012
    try:
        scene.cycles.denoiser = "OPENIMAGEDENOISE"
        scene.cycles.use_denoising = True
    except TypeError:  # Debian's Blender has no denoiser: take many samples instead
        scene.cycles.use_denoising = False
    scene.cycles.seed = 1
    scene.cycles.sample_clamp_indirect = 3
    scene.cycles.blur_glossy = 0.5
    scene.cycles.caustics_reflective = scene.cycles.caustics_refractive = False
    scene.cycles.max_bounces = 4
    scene.view_settings.view_transform = "Filmic"
    for name in (look, f"Filmic - {look}"):
        try:
            scene.view_settings.look = name
        except TypeError:
            continue
        break
    scene.view_settings.exposure = exposure
    render = scene.render
    render.resolution_x, render.resolution_y = max(size_px), min(size_px)
    render.resolution_percentage = 100
    for setting in dir(render):
        if setting.startswith("use_stamp"):
            setattr(render, setting, False)
    render.image_settings.file_format = "JPEG"
    render.image_settings.quality = quality
    render.filepath = str(out.resolve())
    bpy.ops.render.render(write_still=True)
    out.write_bytes(without_comments(out.read_bytes()))


def with_exif(jpeg, orientation, focal_35mm):
    """The same JPEG with what a camera notes: how it was held, its 35 mm equivalent (0: not)."""

    def entry(tag, kind, value):
        return struct.pack(">HHI", tag, kind, 1) + (
            struct.pack(">HH", value, 0) if kind == 3 else struct.pack(">I", value)
        )

    entries = [entry(0x0112, 3, orientation)]
    if focal_35mm:
        entries.append(entry(0x8769, 4, 8 + 2 + 2 * 12 + 4))
    tiff = b"MM\0*" + struct.pack(">I", 8)
    tiff += struct.pack(">H", len(entries)) + b"".join(entries) + struct.pack(">I", 0)
    if focal_35mm:
        tiff += struct.pack(">H", 1) + entry(0xA405, 3, focal_35mm) + struct.pack(">I", 0)
    body = b"Exif\0\0" + tiff
    return jpeg[:2] + b"\xff\xe1" + struct.pack(">H", len(body) + 2) + body + jpeg[2:]


def without_comments(jpeg):
    """The same JPEG without comment and EXIF segments: Blender notes its render times there."""
    kept, at = jpeg[:2], 2
    while jpeg[at + 1] != 0xDA:  # up to the start of the picture data
        end = at + 2 + int.from_bytes(jpeg[at + 2 : at + 4], "big")
        if jpeg[at + 1] not in (0xFE, 0xE1):
            kept += jpeg[at:end]
        at = end
    return kept + jpeg[at:]
