"""The pictures of an example: photo, sketch, 3D, in its place, and what is cut or printed."""

from __future__ import annotations

import numpy as np
from PIL import Image, ImageDraw, ImageFilter

from ...solver.values import Array
from ..fabrication.meshes import Mesh
from ..fabrication.picture import sketch_panel
from ..fabrication.rendering import Scene, View, fitted_view, mesh_scene, plates_scene
from ..fabrication.sheets import Sheet
from ..photos import load_photo
from .lighting import lit
from .outcome import Outcome

HIGH_PX = 440
GAP_PX = 16
PAPER = (252, 252, 251)
#: Colours of materials, flat and cut; the words stand in `Example.material`.
COLOURS = {
    "plywood": ((233, 203, 158), (150, 106, 66)),
    "acrylic": ((112, 168, 186), (62, 112, 130)),
    "cardboard": ((201, 160, 112), (150, 112, 72)),
    "print": ((226, 221, 210), (226, 221, 210)),
}
#: Of one picture in the overview; and how much of the photo is seen around the object.
SMALL_PX, ROOM = (400, 300), 1.9
#: Left, top, width and height of a part of a photo, px.
Window = tuple[int, int, int, int]
#: What is no higher stands on the ground; and how far shadows reach there and on other things, in
#: parts of the object's size.
ON_GROUND_MM, FAR_SHADOW, NEAR_SHADOW = 10.0, 3.0, 0.5
#: Each pixel of a mask is drawn as so many by so many.
MASK_FINE = 4
_BESIDE = (-0.75, -0.85, -0.25)


def panels(made: Outcome) -> list[Image.Image]:
    """The five pictures, all as high as `HIGH_PX`.

    Parameters
    ----------
    made : Outcome

    Returns
    -------
    list of PIL.Image.Image
    """
    photo, _ = load_photo(made.graph, made.example.sketch_path)
    assert photo is not None
    scene = _scene(made)
    return [
        _high(photo),
        _high(sketch_panel(made.graph, photo)),
        _alone(scene),
        _in_place(made, scene, photo),
        _sheets(made) if made.sheets else _cut_open(made),
    ]


def strip(pictures: list[Image.Image]) -> Image.Image:
    """The pictures in one row."""
    width = sum(picture.width for picture in pictures) + GAP_PX * (len(pictures) - 1)
    page = Image.new("RGB", (width, HIGH_PX), "white")
    x = 0
    for picture in pictures:
        page.paste(picture, (x, 0))
        x += picture.width + GAP_PX
    return page


def _high(picture: Image.Image) -> Image.Image:
    width = round(picture.width * HIGH_PX / picture.height)
    return picture.resize((width, HIGH_PX), Image.Resampling.LANCZOS)


def _colours(made: Outcome) -> tuple[tuple[int, int, int], tuple[int, int, int]]:
    return next(c for word, c in COLOURS.items() if word in made.example.material)


def _scene(made: Outcome) -> Scene:
    flat, cut = _colours(made)
    if made.mesh is not None:
        return _mesh_scene(made.mesh, flat)
    assert made.joined is not None
    scene = plates_scene(made.joined.plates)
    # The scene's colours are those of wood: flat where light.
    light = scene.colours[:, 2] > 100
    return Scene(scene.triangles_mm, scene.faces, np.where(light[:, None], flat, cut))


def _mesh_scene(mesh: Mesh, colour: tuple[int, int, int]) -> Scene:
    scene = mesh_scene(mesh.vertices_mm, mesh.triangles)
    return Scene(
        scene.triangles_mm, scene.faces, np.tile(np.array(colour, float), (len(scene.faces), 1))
    )


def _alone(scene: Scene) -> Image.Image:
    size = (HIGH_PX, HIGH_PX)
    view = fitted_view(scene.triangles_mm.reshape(-1, 3), None, size)
    return lit(scene, view, Image.new("RGB", size, PAPER), _BESIDE)


def _in_place(
    made: Outcome, scene: Scene, photo: Image.Image, window: Window | None = None
) -> Image.Image:
    """The object in the photo, or a part of it; what stands before it stays before it."""
    camera = made.solution.camera
    assert camera is not None
    u0, v0, wide, high = window or (0, 0, photo.width, photo.height)
    share = HIGH_PX / high
    part = photo.crop((u0, v0, u0 + wide, v0 + high))
    small = part.resize((round(wide * share), HIGH_PX), Image.Resampling.LANCZOS)
    view = View(
        np.array(camera.position_mm),
        np.array(camera.rotation_cam_from_world),
        camera.focal_px * share,
        (np.array(camera.principal_point_px) - (u0, v0)) * share,
    )
    # What lies on another thing throws its shadow there, not far beyond.
    low = float(scene.triangles_mm[..., 2].min())
    shadow = FAR_SHADOW if low < ON_GROUND_MM else NEAR_SHADOW
    found = lit(scene, view, small, made.example.light_in_cam, shadow=shadow)
    if made.example.in_front:
        mask = Image.new("L", (small.width * MASK_FINE, small.height * MASK_FINE), 0)
        for ring in made.example.in_front:
            places = [((u - u0) * share * MASK_FINE, (v - v0) * share * MASK_FINE) for u, v in ring]
            ImageDraw.Draw(mask).polygon(places, fill=255)
        mask = mask.resize(small.size, Image.Resampling.BOX)
        found.paste(small, (0, 0), mask.filter(ImageFilter.GaussianBlur(0.5)))
    return found


def close_up(made: Outcome) -> Image.Image:
    """The object in its place, with some of what is around it."""
    photo, _ = load_photo(made.graph, made.example.sketch_path)
    assert photo is not None
    assert made.solution.camera is not None
    scene = _scene(made)
    seen = made.solution.camera.project(scene.triangles_mm.reshape(-1, 3))
    return _in_place(made, scene, photo, window_around(seen, photo.size))


def window_around(seen: Array, size: tuple[int, int]) -> Window:
    """A part of a photo, 4 by 3, around something in it: left, top, width, height."""
    low, high = seen.min(axis=0), seen.max(axis=0)
    across, down = (high - low).tolist()
    tall = int(min(ROOM * max(down, 0.75 * across), size[1], 0.75 * size[0]))
    wide = int(tall * 4 / 3)
    u, v = ((low + high) / 2).tolist()
    left = min(max(0, round(u - wide / 2)), size[0] - wide)
    top = min(max(0, round(v - tall / 2)), size[1] - tall)
    return left, top, wide, tall


def overview(pictures: list[Image.Image], columns: int = 3) -> Image.Image:
    """Pictures of one size in rows."""
    wide, high = SMALL_PX
    rows = -(-len(pictures) // columns)
    size = (columns * (wide + GAP_PX) - GAP_PX, rows * (high + GAP_PX) - GAP_PX)
    page = Image.new("RGB", size, "white")
    for k, picture in enumerate(pictures):
        small = picture.resize(SMALL_PX, Image.Resampling.LANCZOS)
        page.paste(small, (k % columns * (wide + GAP_PX), k // columns * (high + GAP_PX)))
    return page


def _sheets(made: Outcome) -> Image.Image:
    """The plates as they are cut, sheet above sheet."""
    flat, cut = _colours(made)
    sheets, fine = made.sheets, 3
    wide = max(sheet.width_mm for sheet in sheets)
    tall = sum(sheet.height_mm for sheet in sheets) + 20.0 * (len(sheets) - 1)
    scale = fine * HIGH_PX / tall
    page = Image.new("RGB", (round(wide * scale), HIGH_PX * fine), "white")
    draw, top = ImageDraw.Draw(page), 0.0
    for sheet in sheets:
        _sheet(draw, sheet, top, scale, (flat, cut))
        top += sheet.height_mm + 20.0
    return page.resize((page.width // fine, HIGH_PX), Image.Resampling.BOX)


def _sheet(
    draw: ImageDraw.ImageDraw,
    sheet: Sheet,
    top: float,
    scale: float,
    colours: tuple[tuple[int, int, int], tuple[int, int, int]],
) -> None:
    def placed(ring: Array) -> list[tuple[float, float]]:
        return [(x * scale, (top + sheet.height_mm - y) * scale) for x, y in ring.tolist()]

    flat, cut = colours
    low, high = (0, top * scale), (sheet.width_mm * scale - 1, (top + sheet.height_mm) * scale - 1)
    draw.rectangle([low, high], fill=(243, 242, 239), outline=(205, 203, 198), width=3)
    for part in sheet.parts:
        draw.polygon(placed(part.outer), fill=flat, outline=cut, width=4)
        for ring in part.inner:
            draw.polygon(placed(ring), fill=(243, 242, 239), outline=cut, width=4)


def _cut_open(made: Outcome) -> Image.Image:
    """The front half of the print taken away, so that its wall is seen."""
    import manifold3d

    assert made.mesh is not None
    body = manifold3d.Manifold(
        manifold3d.Mesh64(
            np.ascontiguousarray(made.mesh.vertices_mm), made.mesh.triangles.astype(np.uint64)
        )
    )
    middle = made.mesh.vertices_mm.mean(axis=0)
    if not made.graph.revolutions:
        # A long thing is cut across.
        way = np.ptp(made.mesh.vertices_mm, axis=0)
        normal = [-1.0, 0.0, 0.0] if way[0] > way[1] else [0.0, 1.0, 0.0]
    else:
        normal = [-0.45, 0.89, 0.0]
    half = body.trim_by_plane(normal, float(np.dot(normal, middle))).to_mesh64()
    mesh = Mesh(
        np.asarray(half.vert_properties)[:, :3], np.asarray(half.tri_verts).astype(np.int32)
    )
    scene = _mesh_scene(mesh, _colours(made)[0])
    return _alone(_reddened(scene, np.array(normal)))


def _reddened(scene: Scene, normal: Array) -> Scene:
    """The cut face in another colour."""
    from ..fabrication.rendering import triangle_normals

    on_cut = triangle_normals(scene.triangles_mm) @ normal < -0.99
    colours = np.where(on_cut[:, None], (214, 110, 84), scene.colours)
    return Scene(scene.triangles_mm, scene.faces, colours)
