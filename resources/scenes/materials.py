"""Procedural materials for the example scenes: wood, book cloth, paper, plaster, clay, leaf, plain.

No picture files: everything is made of Blender's noise.  Texture coordinates are object metres; the
sizes given to these functions are millimetres.
"""

import bpy
from common import metres

#: How Blender calls some sockets from 4.0 on.
RENAMED = {
    "Specular": "Specular IOR Level",
    "Clearcoat": "Coat Weight",
    "Sheen": "Sheen Weight",
    "Transmission": "Transmission Weight",
}


class Nodes:
    """A short way to write a material's node tree."""

    def __init__(self, name):
        self.material = bpy.data.materials.new(name)
        self.material.use_nodes = True
        self.tree = self.material.node_tree
        self.surface = self.tree.nodes["Principled BSDF"]
        axes = self.add(
            "ShaderNodeSeparateXYZ", Vector=self.add("ShaderNodeTexCoord").outputs["Object"]
        )
        self.x, self.y, self.z = axes.outputs

    def add(self, kind, settings=None, **inputs):
        """A node; inputs by name (or in0, in1 ... by place) are values or other nodes' sockets."""
        node = self.tree.nodes.new(kind)
        for name, value in (settings or {}).items():
            setattr(node, name, value)
        for name, value in inputs.items():
            key = (
                int(name[2:]) if name[:2] == "in" and name[2:].isdigit() else name.replace("_", " ")
            )
            self.feed(node.inputs[key], value)
        return node

    def feed(self, socket, value):
        if isinstance(value, bpy.types.NodeSocket):
            self.tree.links.new(value, socket)
        elif isinstance(value, tuple) and len(value) == 3 and len(socket.default_value) == 4:
            socket.default_value = (*value, 1)
        else:
            socket.default_value = value

    def math(self, operation, a, b=0.0):
        return self.add("ShaderNodeMath", {"operation": operation}, in0=a, in1=b).outputs[0]

    def vector(self, x, y, z=0.0):
        return self.add("ShaderNodeCombineXYZ", X=x, Y=y, Z=z).outputs[0]

    def noise(self, vector, scale=1.0, detail=2.0, distortion=0.0):
        wanted = {"Vector": vector, "Scale": scale, "Detail": detail, "Distortion": distortion}
        return self.add("ShaderNodeTexNoise", **wanted).outputs["Fac"]

    def steps(self, value, low, high, to_low=0.0, to_high=1.0):
        """value from low..high stretched smoothly to to_low..to_high, clamped."""
        settings = {"interpolation_type": "SMOOTHSTEP"}
        wanted = {
            "Value": value,
            "From_Min": low,
            "From_Max": high,
            "To_Min": to_low,
            "To_Max": to_high,
        }
        return self.add("ShaderNodeMapRange", settings, **wanted).outputs["Result"]

    def mix(self, share, a, b, blend="MIX"):
        settings = {"blend_type": blend}
        return self.add("ShaderNodeMixRGB", settings, Fac=share, Color1=a, Color2=b).outputs[
            "Color"
        ]

    def bump(self, height, depth):
        """Roughen the surface by `depth` mm times height (0..1)."""
        node = self.add("ShaderNodeBump", Height=height, Strength=1.0, Distance=metres(depth))
        self.feed(self.surface.inputs["Normal"], node.outputs["Normal"])

    def finish(self, **surface):
        for name, value in surface.items():
            socket = name.replace("_", " ")
            if socket not in self.surface.inputs:
                socket = RENAMED[socket]
            self.feed(self.surface.inputs[socket], value)
        return self.material


def plain(name, colour, roughness=0.5, **surface):
    """One colour all over."""
    return Nodes(name).finish(Base_Color=colour, Roughness=roughness, **surface)


def wood(name, light, dark, plank=110.0, gloss=0.42):
    """Planks along x, `plank` mm wide, each with its own rings, tone and fibres; lightly oiled."""
    n = Nodes(name)
    across = n.math("DIVIDE", n.y, metres(plank))
    row = n.math("FLOOR", across)
    chance = n.add("ShaderNodeTexWhiteNoise", {"noise_dimensions": "1D"}, W=row).outputs["Value"]
    x = n.math("ADD", n.x, n.math("MULTIPLY", chance, 31.0))
    y = n.math("ADD", n.y, n.math("MULTIPLY", chance, 7.0))

    field = n.noise(n.vector(n.math("MULTIPLY", x, 0.9), n.math("MULTIPLY", y, 7.0)), 1.0, 2.0, 0.2)
    rings = n.math("SINE", n.math("MULTIPLY", field, 95.0))
    rings = n.steps(rings, -1.0, 1.0)
    fibres = n.noise(n.vector(n.math("MULTIPLY", x, 9.0), n.math("MULTIPLY", y, 420.0)), 1.0, 4.0)
    pores = n.noise(n.vector(n.math("MULTIPLY", x, 40.0), n.math("MULTIPLY", y, 1100.0)), 1.0, 1.0)
    clouds = n.noise(n.vector(n.math("MULTIPLY", x, 2.0), n.math("MULTIPLY", y, 9.0)), 1.0, 3.0)

    colour = n.mix(n.math("MULTIPLY", rings, 0.42), light, dark)
    colour = n.mix(n.steps(fibres, 0.35, 0.75, 0.0, 0.45), colour, dark)
    colour = n.mix(n.steps(pores, 0.60, 0.75, 0.0, 0.55), colour, tuple(c * 0.45 for c in dark))
    tone = n.math("ADD", n.math("MULTIPLY", chance, 0.30), n.steps(clouds, 0.3, 0.7, 0.68, 0.92))
    colour = n.mix(1.0, colour, tone, "MULTIPLY")

    to_seam = n.math("ABSOLUTE", n.math("SUBTRACT", n.math("FRACT", across), 0.5))
    seam = n.steps(to_seam, 0.5 - 1.0 / plank, 0.5 - 0.3 / plank)
    colour = n.mix(n.math("MULTIPLY", seam, 0.75), colour, tuple(c * 0.2 for c in dark))
    height = n.math(
        "SUBTRACT", n.math("MULTIPLY", fibres, 0.12), n.steps(pores, 0.60, 0.75, 0.0, 0.08)
    )
    n.bump(n.math("SUBTRACT", height, seam), 0.45)
    rough = n.steps(fibres, 0.3, 0.8, gloss - 0.06, gloss + 0.12)
    return n.finish(Base_Color=colour, Roughness=rough, Specular=0.4)


def cloth(name, colour, thread=1.1):
    """Book cloth woven of threads `thread` mm apart, a little faded in places."""
    n = Nodes(name)
    along = n.math("ADD", n.x, n.y)
    wobble = n.math("MULTIPLY", n.noise(n.vector(along, n.z), 900.0), 3.0)
    turns = 6.2832 / metres(thread)
    weft = n.math("SINE", n.math("ADD", n.math("MULTIPLY", along, turns), wobble))
    warp = n.math("SINE", n.math("ADD", n.math("MULTIPLY", n.z, turns), wobble))
    weave = n.steps(n.math("MULTIPLY", weft, warp), -1.0, 1.0)
    faded = n.noise(n.vector(n.x, n.y, n.z), 22.0, 6.0)
    shade = n.math(
        "MULTIPLY", n.steps(weave, 0.0, 1.0, 0.86, 1.1), n.steps(faded, 0.3, 0.7, 0.88, 1.12)
    )
    n.bump(weave, 0.12)
    dyed = n.mix(1.0, colour, shade, "MULTIPLY")
    return n.finish(Base_Color=dyed, Roughness=0.78, Specular=0.25, Sheen=0.3)


def pages(name, colour, sheet=0.55):
    """The cut edges of a block of pages lying side by side in x."""
    n = Nodes(name)
    along = n.math("MULTIPLY", n.y, 6.0)
    fine = n.noise(n.vector(n.math("DIVIDE", n.x, metres(sheet)), along), 1.0, 3.0)
    broad = n.noise(n.vector(n.math("DIVIDE", n.x, metres(sheet * 6)), along), 1.0, 2.0)
    shade = n.math(
        "MULTIPLY", n.steps(fine, 0.3, 0.7, 0.74, 1.0), n.steps(broad, 0.3, 0.7, 0.86, 1.0)
    )
    n.bump(fine, 0.25)
    return n.finish(Base_Color=n.mix(1.0, colour, shade, "MULTIPLY"), Roughness=0.9, Specular=0.15)


def plaster(name, colour):
    """A painted wall: roller texture and a hardly visible unevenness."""
    n = Nodes(name)
    where = n.vector(n.x, n.y, n.z)
    patches = n.steps(n.noise(where, 2.2, 3.0), 0.3, 0.7, 0.95, 1.02)
    n.bump(n.noise(where, 260.0, 3.0), 0.5)
    return n.finish(
        Base_Color=n.mix(1.0, colour, patches, "MULTIPLY"), Roughness=0.85, Specular=0.2
    )


def leaf(name, dark, light, band=26.0):
    """Green with paler cross bands, waxy."""
    n = Nodes(name)
    wave = n.noise(
        n.vector(n.math("MULTIPLY", n.x, 60.0), n.math("MULTIPLY", n.y, 60.0), n.z), 1.0, 2.0
    )
    turns = n.math(
        "ADD", n.math("MULTIPLY", n.z, 6.2832 / metres(band)), n.math("MULTIPLY", wave, 9.0)
    )
    return n.finish(
        Base_Color=n.mix(n.steps(n.math("SINE", turns), -0.2, 0.9), dark, light), Roughness=0.38
    )


def clay(name, colour):
    """Fired clay, a little chalky."""
    n = Nodes(name)
    chalk = n.noise(n.vector(n.x, n.y, n.z), 40.0, 5.0)
    n.bump(n.noise(n.vector(n.x, n.y, n.z), 500.0, 3.0), 0.3)
    shade = n.mix(n.steps(chalk, 0.45, 0.75, 0.0, 0.4), colour, (0.62, 0.50, 0.42))
    return n.finish(Base_Color=shade, Roughness=0.88, Specular=0.2)


def tiles(name, glaze, grout, pitch=150.0, joint=3.0):
    """Square tiles along x and y, laid from the origin; each of a slightly different tone."""
    n = Nodes(name)
    across, along = (n.math("DIVIDE", axis, metres(pitch)) for axis in (n.x, n.y))
    cell = n.vector(n.math("FLOOR", across), n.math("FLOOR", along))
    chance = n.add("ShaderNodeTexWhiteNoise", {"noise_dimensions": "2D"}, Vector=cell)
    edges = [
        n.math("ABSOLUTE", n.math("SUBTRACT", n.math("FRACT", share), 0.5))
        for share in (across, along)
    ]
    half = 0.5 - joint / 2 / pitch
    seam = n.steps(n.math("MAXIMUM", *edges), half - 0.004, half + 0.004)
    tone = n.steps(chance.outputs["Value"], 0.0, 1.0, 0.90, 1.04)
    cloud = n.steps(n.noise(n.vector(n.x, n.y, n.z), 14.0, 4.0), 0.3, 0.7, 0.95, 1.03)
    colour = n.mix(1.0, glaze, n.math("MULTIPLY", tone, cloud), "MULTIPLY")
    n.bump(n.math("SUBTRACT", 1.0, seam), 0.8)
    rough = n.steps(seam, 0.0, 1.0, 0.24, 0.85)
    return n.finish(Base_Color=n.mix(seam, colour, grout), Roughness=rough, Specular=0.45)


def fabric(name, colour, stripe, pitch=34.0):
    """Woven linen with stripes along x."""
    n = Nodes(name)
    share = n.math("FRACT", n.math("DIVIDE", n.y, metres(pitch)))
    line = n.math("ABSOLUTE", n.math("SUBTRACT", share, 0.5))
    stripes = n.steps(line, 0.40, 0.43)
    turns = 6.2832 / metres(1.3)
    weave = n.math(
        "MULTIPLY",
        n.math("SINE", n.math("MULTIPLY", n.x, turns)),
        n.math("SINE", n.math("MULTIPLY", n.y, turns)),
    )
    shade = n.steps(weave, -1.0, 1.0, 0.86, 1.06)
    n.bump(weave, 0.2)
    dyed = n.mix(1.0, n.mix(stripes, colour, stripe), shade, "MULTIPLY")
    return n.finish(Base_Color=dyed, Roughness=0.9, Specular=0.15, Sheen=0.3)


def steel(name, colour=(0.62, 0.63, 0.65), roughness=0.28):
    """Brushed steel."""
    n = Nodes(name)
    lines = n.noise(n.vector(n.math("MULTIPLY", n.x, 20.0), n.math("MULTIPLY", n.y, 900.0)), 1.0)
    rough = n.steps(lines, 0.3, 0.7, roughness - 0.05, roughness + 0.1)
    return n.finish(Base_Color=colour, Roughness=rough, Metallic=1.0)
