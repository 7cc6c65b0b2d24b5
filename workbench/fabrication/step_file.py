"""Plates as a STEP file, each a part of its own name in an assembly (ISO 10303-21, AP 214).

Plates are straight prisms: points, lines and planes say them exactly, and no kernel need be loaded
for it, nor asked for names, which FreeCAD's has for whole objects only.

Terms
-----
entity
    One numbered line of the file; others point to it by its number.
representation
    The entity that gathers a shape's geometry; the assembly's places each plate's in its own.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from ...solver.values import Array
from .plates import Plate

_HEAD = """\
ISO-10303-21;
HEADER;
FILE_DESCRIPTION(('Plates put together'),'2;1');
FILE_NAME({name},'2000-01-01T00:00:00',(''),(''),'Modeling in Context','Modeling in Context','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));
ENDSEC;
DATA;
"""
_FOOT = "ENDSEC;\nEND-ISO-10303-21;\n"
_PLAIN = frozenset(map(chr, range(32, 127))) - {"'", "\\"}


class _Entities:
    """The data section as it grows."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    def add(self, text: str) -> str:
        """One more entity; gives its number as others write it."""
        self.lines.append(f"#{len(self.lines) + 1}={text};\n")
        return f"#{len(self.lines)}"

    def point(self, place: Sequence[float]) -> str:
        return self.add(f"CARTESIAN_POINT('',({_numbers(place)}))")

    def direction(self, way: Sequence[float]) -> str:
        return self.add(f"DIRECTION('',({_numbers(way)}))")

    def frame(self, origin: Sequence[float], z: Sequence[float], x: Sequence[float]) -> str:
        """A right-handed frame."""
        parts = self.point(origin), self.direction(z), self.direction(x)
        return self.add(f"AXIS2_PLACEMENT_3D('',{','.join(parts)})")


def plates_step_bytes(plates: Sequence[Plate], name: str = "plates") -> bytes:
    """The plates put together as STEP, mm, each with its id as its name.

    Parameters
    ----------
    plates : sequence of Plate
    name : str
        Of the whole.

    Returns
    -------
    bytes
        The same for the same plates.
    """
    entities = _Entities()
    context, product_context, design = _contexts(entities)
    origin = ((0.0, 0.0, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0))
    places = [entities.frame(*_frame_of(plate.world_from_plate)) for plate in plates]
    items = ",".join((entities.frame(*origin), *places))
    whole = entities.add(f"SHAPE_REPRESENTATION('',({items}),{context})")
    whole_definition = _product(entities, name, whole, product_context, design)
    for count, (plate, place) in enumerate(zip(plates, places, strict=True), start=1):
        own = entities.frame(*origin)
        solid = _prism(entities, plate)
        words = f"ADVANCED_BREP_SHAPE_REPRESENTATION('',({own},{solid}),{context})"
        shape = entities.add(words)
        definition = _product(entities, plate.id, shape, product_context, design)
        usage = entities.add(
            f"NEXT_ASSEMBLY_USAGE_OCCURRENCE('{count}',{_text(plate.id)},'',"
            f"{whole_definition},{definition},$)"
        )
        _put(entities, (shape, own), (whole, place), usage)
    return (_HEAD.format(name=_text(name)) + "".join(entities.lines) + _FOOT).encode("ascii")


def _contexts(entities: _Entities) -> tuple[str, str, str]:
    """Units and accuracy; and what products and their definitions belong to."""
    add = entities.add
    application = add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')")
    words = "'international standard','automotive_design',2000"
    add(f"APPLICATION_PROTOCOL_DEFINITION({words},{application})")
    length = add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))")
    angle = add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")
    solid_angle = add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())")
    accuracy = add(
        f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),{length},"
        "'distance_accuracy_value','confusion accuracy')"
    )
    context = add(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(3)"
        f"GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({accuracy}))"
        f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle},{solid_angle}))"
        "REPRESENTATION_CONTEXT('Context #1','3D Context with UNIT and UNCERTAINTY'))"
    )
    product_context = add(f"PRODUCT_CONTEXT('',{application},'mechanical')")
    design = add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{application},'design')")
    return context, product_context, design


def _product(entities: _Entities, name: str, shape: str, product_context: str, design: str) -> str:
    """A part by its name with its shape; gives its definition."""
    said = _text(name)
    product = entities.add(f"PRODUCT({said},{said},'',({product_context}))")
    entities.add(f"PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,({product}))")
    formation = entities.add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
    definition = entities.add(f"PRODUCT_DEFINITION('design','',{formation},{design})")
    has_shape = entities.add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
    entities.add(f"SHAPE_DEFINITION_REPRESENTATION({has_shape},{shape})")
    return definition


def _put(entities: _Entities, part: tuple[str, str], whole: tuple[str, str], usage: str) -> None:
    """Place a part's representation and frame in a frame of the whole's."""
    add = entities.add
    has_place = add(f"PRODUCT_DEFINITION_SHAPE('Placement','Placement of an item',{usage})")
    move = add(f"ITEM_DEFINED_TRANSFORMATION('','',{part[1]},{whole[1]})")
    relation = add(
        f"(REPRESENTATION_RELATIONSHIP('','',{part[0]},{whole[0]})"
        f"REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION({move})"
        "SHAPE_REPRESENTATION_RELATIONSHIP())"
    )
    add(f"CONTEXT_DEPENDENT_SHAPE_REPRESENTATION({relation},{has_place})")


def _frame_of(world_from_plate: Array) -> tuple[list[float], list[float], list[float]]:
    matrix = world_from_plate[:3]
    return matrix[:, 3].tolist(), matrix[:, 2].tolist(), matrix[:, 0].tolist()


def _prism(entities: _Entities, plate: Plate) -> str:
    """A plate in its own frame: between z = 0 and its thickness."""
    height = float(plate.thickness_mm)
    lower, upper, faces = [], [], []
    for ring in (plate.outline, *plate.holes):
        bottom, top, sides = _walls(entities, ring.tolist(), height)
        lower.append(",".join(_turned(entities, edge, ".F.") for edge in reversed(bottom)))
        upper.append(",".join(_turned(entities, edge, ".T.") for edge in top))
        faces += sides
    faces.append(_face(entities, lower, ((0.0, 0.0, 0.0), (0.0, 0.0, -1.0), (1.0, 0.0, 0.0))))
    faces.append(_face(entities, upper, ((0.0, 0.0, height), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0))))
    shell = entities.add(f"CLOSED_SHELL('',({','.join(faces)}))")
    return entities.add(f"MANIFOLD_SOLID_BREP({_text(plate.id)},{shell})")


def _walls(
    entities: _Entities, ring: list[list[float]], height: float
) -> tuple[list[str], list[str], list[str]]:
    """What stands on a ring that has the plate at its left: edges below and above, side faces."""
    places = [[(x, y, z) for x, y in ring] for z in (0.0, height)]
    points = [[entities.point(place) for place in level] for level in places]
    ends = [[entities.add(f"VERTEX_POINT('',{one})") for one in level] for level in points]
    ways = [_unit(a, b) for a, b in pairwise([*ring, ring[0]])]
    edges = [
        [
            _edge(entities, level[k], (vertices[k], vertices[(k + 1) % len(ring)]), (*way, 0.0))
            for k, way in enumerate(ways)
        ]
        for level, vertices in zip(points, ends, strict=True)
    ]
    upright = [
        _edge(entities, point, pair, (0.0, 0.0, 1.0))
        for point, *pair in zip(points[0], *ends, strict=True)
    ]
    faces = []
    for k, (x, y) in enumerate(ways):
        loop = [
            _turned(entities, edges[0][k], ".T."),
            _turned(entities, upright[(k + 1) % len(ring)], ".T."),
            _turned(entities, edges[1][k], ".F."),
            _turned(entities, upright[k], ".F."),
        ]
        frame = (places[0][k], (y, -x, 0.0), (x, y, 0.0))
        faces.append(_face(entities, [",".join(loop)], frame))
    return edges[0], edges[1], faces


def _edge(
    entities: _Entities, point: str, ends: Sequence[str], way: tuple[float, float, float]
) -> str:
    vector = entities.add(f"VECTOR('',{entities.direction(way)},1.)")
    line = entities.add(f"LINE('',{point},{vector})")
    return entities.add(f"EDGE_CURVE('',{','.join(ends)},{line},.T.)")


def _turned(entities: _Entities, edge: str, sense: str) -> str:
    return entities.add(f"ORIENTED_EDGE('',*,*,{edge},{sense})")


def _face(entities: _Entities, loops: list[str], frame: tuple[Sequence[float], ...]) -> str:
    """A plane face; its outer loop first, counter-clockwise as seen from outside."""
    bounds = []
    for k, loop in enumerate(loops):
        kind = "FACE_BOUND" if k else "FACE_OUTER_BOUND"
        closed = entities.add(f"EDGE_LOOP('',({loop}))")
        bounds.append(entities.add(f"{kind}('',{closed},.T.)"))
    plane = entities.add(f"PLANE('',{entities.frame(*frame)})")
    return entities.add(f"ADVANCED_FACE('',({','.join(bounds)}),{plane},.T.)")


def _unit(a: list[float], b: list[float]) -> tuple[float, float]:
    x, y = b[0] - a[0], b[1] - a[1]
    length = (x * x + y * y) ** 0.5
    return x / length, y / length


def _numbers(values: Sequence[float]) -> str:
    return ",".join(_number(value) for value in values)


def _number(value: float) -> str:
    """A number with its decimal point, which STEP asks for."""
    mantissa, e, exponent = repr(float(value) + 0.0).partition("e")
    return (mantissa if "." in mantissa else mantissa + ".") + e.upper() + exponent


def _text(words: str) -> str:
    """A text in quotation marks: what is not plain ASCII by its number."""
    return "'" + "".join(c if c in _PLAIN else _escaped(c) for c in words) + "'"


def _escaped(character: str) -> str:
    if character in "'\\":
        return 2 * character
    code = ord(character)
    return f"\\X2\\{code:04X}\\X0\\" if code < 0x10000 else f"\\X4\\{code:08X}\\X0\\"
