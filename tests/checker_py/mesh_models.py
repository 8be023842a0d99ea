# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Meshes for tests of the mesh claims, as (points, polygons), and writers of every format and spelling that the reading rule allows."""
import pathlib
import struct
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "mutation"))
import forge                                              # noqa: E402
import solids                                             # noqa: E402
from veritope_checker.mesh import mesh_reader             # noqa: E402

join, move = solids.join, solids.move
PLY_TYPES = {"char": "b", "uchar": "B", "uint8": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d"}


def turned(mesh):
    """The mesh inside out."""
    return mesh[0], [f[::-1] for f in mesh[1]]


def triangles(mesh):
    return mesh[0], [(f[0], f[i], f[i + 1]) for f in mesh[1] for i in range(1, len(f) - 1)]


TET = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
REGULAR = [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)]
OCTAHEDRON = ([(2, 0, 0), (-2, 0, 0), (0, 2, 0), (0, -2, 0), (0, 0, 2), (0, 0, -2)],
              [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)])
CUBE = solids.voxel_surface({(0, 0, 0)})
RING = solids.voxel_surface({(x, y, 0) for x in range(3) for y in range(3)} - {(1, 1, 0)})
ELL = solids.voxel_surface({(0, 0, 0), (1, 0, 0), (0, 1, 0)})
SHELL = join(move(CUBE, (-1, -1, -1), 3), turned(CUBE))
ONION = join(SHELL, move(CUBE, (0.25, 0.25, 0.25), 0.5))
TWO = join(TET, move(TET, (3, 0.25, 0.5)))
# Long thin facets whose boxes overlap: leaf pairs that need codes.
TWIST = ([(0, 0, 0), (8, 0, 0), (0, 8, 0), (9, 9, 40), (1, 9, 41), (9, 1, 42)],
         [(0, 2, 1), (3, 4, 5), (0, 1, 5), (1, 3, 5), (1, 2, 3), (2, 4, 3), (2, 0, 4), (0, 5, 4)])


def prism(n):
    ring = [(0, 0), (4, 0), (6, 2), (6, 5), (3, 7), (1, 6), (0, 5), (-1, 3), (-1, 1)][:n]
    sides = [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    return [(x, y, z) for z in (0, 2) for x, y in ring], [tuple(range(n))[::-1], tuple(range(n, 2 * n))] + sides


SOLIDS = {  # name: mesh, shells, bodies, genus, volume
    "tetrahedron": (TET, 1, 1, 0, "1/6"), "cube": (CUBE, 1, 1, 0, "1/1"), "torus": (RING, 1, 1, 1, "8/1"), "ell": (ELL, 1, 1, 0, "3/1"),
    "nested": (SHELL, 2, 1, 0, "26/1"), "onion": (ONION, 3, 2, 0, "209/8"), "two bodies": (TWO, 2, 2, 0, "1/3"),
    "5 corners": (prism(5), 1, 1, 0, "53/1"), "9 corners": (prism(9), 1, 1, 0, "76/1")}

OPEN = TET[0], TET[1][:3]
BOOK = TET[0] + [(5, 5, 5)], TET[1] + [(0, 1, 4)]
CROSSED = join(move(CUBE, (0, 0, 0), 4), move(TET, (3, 1, 1), 2))
BROKEN = {  # by rule
    1: (TET[0], TET[1] + [(0, 0, 1)]), 2: (TET[0], TET[1] + [(2, 1, 0)]), 3: OPEN, 4: BOOK, 5: (TET[0], TET[1][:3] + [TET[1][3][::-1]]),
    6: join(TET, move(TET, (1, 0, 0))), 7: CROSSED, 8: turned(TET), 9: join(move(CUBE, (-1, -1, -1), 3), CUBE)}


class File:
    """The bytes of a file in the place of forge.Model. The Python checker's reader reads it: that it reads what the page says is what
    mesh_reading_test.py shows."""

    def __init__(self, data, fmt, as_indexed=False):
        self.data, self.fmt, self.as_indexed = data, fmt, as_indexed

    def encode(self):
        return self.data

    def reading(self):
        return mesh_reader.read_model(self.data, self.fmt, self.as_indexed)


def row(numbers):
    return " ".join(repr(float(c)) for c in numbers)


def joined(lines, end):
    return (end.join(lines) + end).encode()


def rows_of(mesh):
    return [row(p) for p in mesh[0]] + [" ".join(map(str, (len(f),) + tuple(f))) for f in mesh[1]]


def off(mesh, end="\n"):
    return joined(["OFF", "%d %d 0" % (len(mesh[0]), len(mesh[1]))] + rows_of(mesh), end)


def obj(mesh, end="\n", corner="%d"):
    lines = ["# comment"] + ["v " + row(p) for p in mesh[0]]
    return joined(lines + ["f " + " ".join(corner % (v + 1) for v in f) for f in mesh[1]], end)


def ply(mesh, kind="ascii", end="\n", real="float", index="int"):
    head = ["ply", "format %s 1.0" % kind, "comment x", "element vertex %d" % len(mesh[0])] + ["property %s %s" % (real, c) for c in "xyz"]
    head += ["element face %d" % len(mesh[1]), "property list uchar %s vertex_indices" % index, "end_header"]
    if kind == "ascii":
        return joined(head, end) + joined(rows_of(mesh), end)
    order = "<" if "little" in kind else ">"
    rows = [struct.pack(order + "3" + PLY_TYPES[real], *p) for p in mesh[0]]
    return joined(head, end) + b"".join(rows + [struct.pack("%sB%d%s" % (order, len(f), PLY_TYPES[index]), len(f), *f) for f in mesh[1]])


def stl_binary(mesh, header=b"header", tail=b""):
    points, faces = triangles(mesh)
    facets = [struct.pack("<12fH", 0, 0, 0, *(c for v in f for c in points[v]), 7) for f in faces]
    return header.ljust(80) + struct.pack("<I", len(faces)) + b"".join(facets) + tail


def stl_text(mesh, end="\n", name="solid one"):
    points, faces = triangles(mesh)
    lines = [name]
    for f in faces:
        lines += ["facet normal 0 0 0", " outer loop", *("  vertex " + row(points[v]) for v in f), " endloop", "endfacet"]
    return joined(lines + ["endsolid"], end)


WRITERS = {
    "off": ("off", off), "off CR LF": ("off", lambda m: off(m, "\r\n")), "off CR": ("off", lambda m: off(m, "\r")),
    "obj": ("obj", obj), "obj CR LF": ("obj", lambda m: obj(m, "\r\n")), "obj corners": ("obj", lambda m: obj(m, corner="%d/5/-7")),
    "ply": ("ply", ply), "ply CR LF": ("ply", lambda m: ply(m, end="\r\n")), "ply CR": ("ply", lambda m: ply(m, end="\r")),
    "ply little": ("ply", lambda m: ply(m, "binary_little_endian")),
    "ply big": ("ply", lambda m: ply(m, "binary_big_endian", real="double", index="ushort")),
    "ply little, CR LF": ("ply", lambda m: ply(m, "binary_little_endian", "\r\n", index="uint8")),
    "stl": ("stl", stl_text), "stl CR LF": ("stl", lambda m: stl_text(m, "\r\n", "SOLID")), "stl binary": ("stl", stl_binary),
    "stl binary, solid": ("stl", lambda m: stl_binary(m, b"solid of the binary kind")),
    "stl binary, more": ("stl", lambda m: stl_binary(m, b"x", b"more"))}
