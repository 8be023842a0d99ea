#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Writes tests/models/: small models with a known verdict, and EXPECT.tsv, which says it.

usage: make_models.py [FOLDER]      (default: tests/models/ of this tree)

mN_smallest.*       the smallest model that breaks rule MN (and, where that is possible, no other rule)
mN_nearest_valid.*  the nearest model that breaks none
mN_<other>.*        other ways to break it; <other>_nearest_valid: a vertex moved by as little as a double allows
valid_*             sound models in odd formats, sizes and shapes
unreadable_*        files that no reader may accept, each for one reason
EXPECT.tsv          file, options, verdict, exit, rule counts, numbers; "-" = unknown or not decided

The numbers in EXPECT.tsv come from a second opinion: fractions, all pairs, no filters (class Oracle). The rule counts
of the mN models are also written down here by hand, and compared.
"""
import collections
import math
import pathlib
import struct
import sys
from fractions import Fraction

ROOT = pathlib.Path(__file__).resolve().parent.parent
TINY = 5e-324  # the least positive double


# ---- the second opinion ---------------------------------------------------------------------------------------------

def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def clip(polygon, normal, origin):
    """The part of a convex polygon (a list of its corners, perhaps one or two) with normal.(x - origin) >= 0."""
    height = [dot(normal, sub(p, origin)) for p in polygon]
    kept = []
    for i, p in enumerate(polygon):
        q, hp, hq = polygon[i - 1], height[i], height[i - 1]
        if hp * hq < 0:
            t = hq / (hq - hp)
            kept.append(tuple(b + t * (a - b) for a, b in zip(p, q)))
        if hp >= 0:
            kept.append(p)
    return kept


def common_points(t, u):
    """Corners of the intersection of two triangles."""
    normal = cross(sub(u[1], u[0]), sub(u[2], u[0]))
    polygon = clip(clip(list(t), normal, u[0]), tuple(-c for c in normal), u[0])
    for i in range(3):
        if polygon:
            polygon = clip(polygon, cross(normal, sub(u[(i + 1) % 3], u[i])), u[i])
    return polygon


def in_simplex(p, corners):
    """Whether p lies on the point or segment with these corners."""
    if len(corners) < 2:
        return p in corners
    a, b = corners
    return cross(sub(p, a), sub(b, a)) == (0, 0, 0) and 0 <= dot(sub(p, a), sub(b, a)) <= dot(sub(b, a), sub(b, a))


class Oracle:
    """Rule counts and quantities of a triangle mesh, by definition and slowly."""

    def __init__(self, vertices, faces):
        self.points = [tuple(Fraction(c) for c in v) for v in vertices]
        self.faces = faces
        self.solid = [f for f in faces if len(set(f)) == 3]  # faces with a repeated id take part in nothing else
        self.proper = [i for i, f in enumerate(faces) if len(set(f)) == 3 and self.normal(f) != (0, 0, 0)]
        self.directed = collections.Counter((f[k], f[(k + 1) % 3]) for f in self.solid for k in range(3))
        self.edges = {frozenset(e) for e in self.directed}
        self.rules = {f"M{i}": 0 for i in range(1, 10)}
        self.rules["M1"] = len(faces) - len(self.proper)
        self.rules["M2"] = len(self.solid) - len({frozenset(f) for f in self.solid})
        self.count_edges()
        self.rules["M6"] = sum(self.fans(v) > 1 for v in {v for f in self.solid for v in f})
        self.rules["M7"] = sum(self.improper(f, g) for k, f in enumerate(self.proper) for g in self.proper[:k])
        self.shells = self.find_shells()
        is_cycle = all(self.directed[a, b] == self.directed[b, a] for a, b in self.directed)
        self.volumes = [sum(self.det(f) for f in shell) / 6 for shell in self.shells] if is_cycle else None
        self.bodies = self.genus = None
        if all(self.rules[f"M{i}"] == 0 for i in range(1, 7)):
            self.genus = sum((2 - self.euler(shell)) // 2 for shell in self.shells)
            if self.rules["M7"] == 0:
                self.nest()
        if self.bodies is None:
            self.rules["M8"] = self.rules["M9"] = None

    def corners(self, face):
        return [self.points[v] for v in face]

    def normal(self, face):
        a, b, c = self.corners(face)
        return cross(sub(b, a), sub(c, a))

    def det(self, face):
        a, b, c = self.corners(face)
        return dot(a, cross(b, c))

    def count_edges(self):
        for a, b in map(sorted, self.edges):
            there, back = self.directed[a, b], self.directed[b, a]
            self.rules["M3"] += there + back == 1
            self.rules["M4"] += there + back > 2
            self.rules["M5"] += (there, back) in ((2, 0), (0, 2))

    def classes(self, faces, is_link):
        """Classes of faces that are connected through edges for which is_link holds."""
        rest, found = list(faces), []
        while rest:
            group, todo = [], [rest.pop(0)]
            while todo:
                face = todo.pop()
                group.append(face)
                near = [g for g in rest if any(is_link(e) and e <= set(g) for e in self.edges_of(face))]
                rest = [g for g in rest if g not in near]
                todo += near
            found.append(group)
        return found

    @staticmethod
    def edges_of(face):
        return [frozenset((face[k], face[(k + 1) % 3])) for k in range(3)]

    def fans(self, vertex):
        return len(self.classes([f for f in self.solid if vertex in f], lambda edge: vertex in edge))

    def find_shells(self):
        return self.classes(self.solid, lambda edge: True)

    def euler(self, faces):
        return (len({v for f in faces for v in f}) - len({e for f in faces for e in self.edges_of(f)}) + len(faces))

    def improper(self, i, j):
        f, g = self.faces[i], self.faces[j]
        common = set(f) & set(g)
        if len(common) == 3:
            return True
        simplex = [self.points[v] for v in common]
        return any(not in_simplex(p, simplex) for p in common_points(self.corners(f), self.corners(g)))

    def nest(self):
        depths = [sum(self.is_inside(s[0], other) for other in self.shells if other is not s) for s in self.shells]
        self.bodies = sum(d % 2 == 0 for d in depths)
        for depth, volume in zip(depths, self.volumes):
            if (volume > 0) != (depth % 2 == 0):
                self.rules["M8" if depth == 0 else "M9"] += 1

    def is_inside(self, face, shell):
        """Parity of the crossings of a ray from a point of the face; start and direction such that it meets no edge."""
        for k in range(100):
            weights = Fraction(97, 145 + k), Fraction(31, 145 + k), Fraction(17 + k, 145 + k)
            p = tuple(dot(weights, coordinates) for coordinates in zip(*self.corners(face)))
            direction = (Fraction(1), Fraction(k * k + 3, 7919), Fraction(5 * k + 1, 104729))
            hits = [self.crosses(p, direction, self.corners(f)) for f in shell]
            if None not in hits:
                return sum(hits) % 2 == 1
        raise ValueError("no direction in general position")

    @staticmethod
    def crosses(p, direction, triangle):
        """Whether the ray goes through the inside of the triangle; None if it meets an edge or lies in the plane."""
        a, b, c = (sub(corner, p) for corner in triangle)
        signs = [dot(direction, cross(u, v)) for u, v in ((a, b), (b, c), (c, a))]
        total = sum(signs)
        if 0 in signs or total == 0:
            return None if min(signs) <= 0 <= max(signs) or total == 0 else False
        if min(signs) < 0 < max(signs):
            return False
        return dot(a, cross(b, c)) / total > 0

    def is_valid(self):
        return not any(self.rules.values()) and self.bodies is not None


# ---- shapes ---------------------------------------------------------------------------------------------------------

Mesh = collections.namedtuple("Mesh", "vertices faces")
TET = Mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])


def moved(mesh, scale=(1, 1, 1), shift=(0, 0, 0)):
    faces = mesh.faces if sum(s < 0 for s in scale) % 2 == 0 else [f[::-1] for f in mesh.faces]
    return Mesh([tuple(c * s + t for c, s, t in zip(v, scale, shift)) for v in mesh.vertices], faces)


def reversed_faces(mesh):
    return Mesh(mesh.vertices, [f[::-1] for f in mesh.faces])


def union(*meshes):
    """Meshes side by side; equal vertices become one."""
    ids, faces = {}, []
    for mesh in meshes:
        faces += [tuple(ids.setdefault(mesh.vertices[v], len(ids)) for v in f) for f in mesh.faces]
    return Mesh(list(ids), faces)


def bipyramid(p, q):
    vertices = [(0, 0, 0), (4, 0, 0), (0, 4, 0), p, q]
    return Mesh(vertices, [(0, 1, 3), (1, 2, 3), (2, 0, 3), (1, 0, 4), (2, 1, 4), (0, 2, 4)])


def split_edge(m):
    """A tetrahedron whose edge along x is split at m on one side; the face between the two sides fills the crack."""
    return Mesh([(0, 0, 0), (2, 0, 0), (0, 2, 0), (0, 0, 2), m],
                [(0, 2, 4), (4, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3), (0, 4, 1)])


def frame():
    """A square ring with square section: genus 1, 16 quadrilaterals."""
    vertices, polygons = [], []
    for x, y in ((0, 0), (3, 0), (3, 3), (0, 3)):
        inner = tuple(1 if c == 0 else 2 for c in (x, y))
        vertices += [(x, y, 0), (x, y, 1), (*inner, 1), (*inner, 0)]
    for i in range(4):
        for k in range(4):
            a, b = 4 * i, 4 * ((i + 1) % 4)
            polygons.append((a + k, b + k, b + (k + 1) % 4, a + (k + 1) % 4))
    return Mesh(vertices, polygons)


def cube(size=1):
    vertices = [(x * size, y * size, z * size) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    return Mesh(vertices, [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)])


# The torus with the fewest vertices (Csaszar's polyhedron).
TORUS = Mesh([(3, -3, 0), (3, 3, 1), (1, 2, 3), (-1, -2, 3), (-3, -3, 1), (-3, 3, 0), (0, 0, 15)],
             [(i, (i + a) % 7, (i + b) % 7) for a, b in ((1, 3), (3, 2)) for i in range(7)])


# ---- writers --------------------------------------------------------------------------------------------------------

def number(value):
    return str(int(value)) if value == int(value) and abs(value) < 1e15 else repr(float(value))


def row(values):
    return " ".join(map(number, values))


def off(mesh, head="OFF"):
    lines = [head, f"{len(mesh.vertices)} {len(mesh.faces)} 0", *map(row, mesh.vertices)]
    return "\n".join(lines + [f"{len(f)} {row(f)}" for f in mesh.faces] + [""]).encode()


def obj(mesh):
    lines = ["v " + row(v) for v in mesh.vertices] + ["f " + row(i + 1 for i in f) for f in mesh.faces]
    return "\n".join(lines + [""]).encode()


def stl_ascii(mesh, name="model", word=str):
    lines = [word("solid ") + name]
    for f in mesh.faces:
        lines += [word("facet normal 0 0 0"),
                  word(" outer loop"), *(word("  vertex ") + row(mesh.vertices[v]) for v in f)]
        lines += [word(" endloop"), word("endfacet")]
    return "\n".join(lines + [word("endsolid ") + name, ""]).encode()


def stl_binary(mesh, header=b"veritope", announced=None):
    data = header.ljust(80, b"\0") + struct.pack("<I", len(mesh.faces) if announced is None else announced)
    for f in mesh.faces:
        data += struct.pack("<12fH", 0, 0, 0, *(c for v in f for c in mesh.vertices[v]), 7)
    return data


def ply_header(form, real, mesh, face_element="face"):
    lines = ["ply", f"format {form} 1.0", "comment made by tools/make_models.py",
             f"element vertex {len(mesh.vertices)}",
             *(f"property {real} {axis}" for axis in "xyz"), f"element {face_element} {len(mesh.faces)}",
             "property list uchar int vertex_indices", "end_header", ""]
    return "\n".join(lines).encode()


def ply_ascii(mesh, **how):
    lines = [*map(row, mesh.vertices), *(f"{len(f)} {row(f)}" for f in mesh.faces), ""]
    return ply_header("ascii", "double", mesh, **how) + "\n".join(lines).encode()


def ply_binary(mesh, order, real):
    data = ply_header("binary_big_endian" if order == ">" else "binary_little_endian", real, mesh)
    for v in mesh.vertices:
        data += struct.pack(order + 3 * real[0], *v)
    for f in mesh.faces:
        data += struct.pack(f"{order}B{len(f)}i", len(f), *f)
    return data


# ---- the models -----------------------------------------------------------------------------------------------------

class Models:
    """Files and the rows of EXPECT.tsv."""

    def __init__(self):
        self.files, self.rows = {}, []

    def add(self, name, mesh, data=None, breaks=None, options="", stated=None):
        """`mesh`: what the file means (polygons are cut into fans); `breaks`: {"M1": 1} by hand; `stated`: vertices in
        the file."""
        triangles = [(f[0], f[i], f[i + 1]) for f in mesh.faces for i in range(1, len(f) - 1)]
        oracle = Oracle(mesh.vertices, triangles)
        found = {rule: count for rule, count in oracle.rules.items() if count}
        if breaks is not None and found != breaks:
            raise AssertionError(f"{name}: by hand {breaks}, by the oracle {found}")
        if oracle.is_valid() != ("valid" in name.split(".")[0].split("_")) and breaks != {} and not options:
            raise AssertionError(f"{name}: the oracle finds {found}")
        writers = {"off": off, "obj": obj, "stl": stl_ascii, "ply": ply_ascii}
        self.files[name] = writers[name.split(".")[1]](mesh) if data is None else data
        valid = oracle.is_valid()
        volume = sum(oracle.volumes) if oracle.volumes is not None else None
        counts = [stated or len(mesh.vertices), len(triangles), len(oracle.edges), *oracle.rules.values(),
                  len(oracle.shells),
                  oracle.bodies, oracle.genus, None if volume is None else f"{volume.numerator}/{volume.denominator}"]
        shown = ["-" if count is None else str(count) for count in counts]
        self.rows.append([name, options or "-", "VALID" if valid else "INVALID", "0" if valid else "1", *shown])

    def refuse(self, name, data, code, options=""):
        self.files[name] = data
        self.rows.append([name, options or "-", "UNREADABLE", "4", *["-"] * 16, code])

    def write(self, folder):
        folder.mkdir(parents=True, exist_ok=True)
        for name, data in self.files.items():
            (folder / name).write_bytes(data)
        head = ["file", "options", "verdict", "exit", "vertices", "faces",
                "edges", *(f"M{i}" for i in range(1, 10)), "shells",
                "bodies", "genus", "volume", "error"]
        rows = [r if len(r) == len(head) else [*r, "-"] for r in self.rows]
        text = "".join("\t".join(r) + "\n" for r in [head, *rows])
        (folder / "EXPECT.tsv").write_text(text)


def add_rules_1_to_5(m):
    m.add("m1_smallest.off", Mesh(TET.vertices, TET.faces + [(0, 0, 1)]), breaks={"M1": 1})
    m.add("m1_nearest_valid.off", TET, breaks={})
    m.add("m1_collinear.off", split_edge((1, 0, 0)), breaks={"M1": 1, "M7": 2})
    m.add("m1_collinear_nearest_valid.off", split_edge((1, TINY, 0)), breaks={})

    m.add("m2_smallest.off", Mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 1)]), breaks={"M2": 1, "M7": 1})
    m.add("m2_nearest_valid.off",
          Mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0.25, 0.25, TINY)],
               [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]), breaks={})
    m.add("m2_copied_face.off", Mesh(TET.vertices, TET.faces + [(2, 3, 1)]), breaks={"M2": 1, "M4": 3, "M7": 1})

    m.add("m3_smallest.off", Mesh(TET.vertices[:3], [(0, 1, 2)]), breaks={"M3": 3})
    m.add("m3_missing_face.off", Mesh(TET.vertices, TET.faces[:3]), breaks={"M3": 3})
    m.add("m3_nearest_valid.off", TET, breaks={})
    cracked = Mesh(TET.vertices + [(1 + 2**-52, 0, 0)], TET.faces[:3] + [(4, 2, 3)])
    m.add("m3_crack.stl", cracked, breaks={"M3": 4})

    wall = bipyramid((1, 1, 4), (1, 1, -4))
    m.add("m4_smallest.off", Mesh(wall.vertices, wall.faces + [(0, 1, 2)]), breaks={"M4": 3})
    m.add("m4_nearest_valid.off", wall, breaks={})
    m.add("m4_touching_edge.off", union(TET, moved(TET, (-1, -1, 1))), breaks={"M4": 1})
    m.add("m4_touching_edge_nearest_valid.off", union(TET, moved(TET, (-1, -1, 1), (-TINY, -TINY, 0))), breaks={})

    m.add("m5_smallest.off", Mesh(TET.vertices, TET.faces[:3] + [(3, 2, 1)]), breaks={"M5": 3})
    m.add("m5_nearest_valid.off", TET, breaks={})
    # A Moebius strip: no orientation of its five faces is consistent.
    ring = [(math.floor(8 * math.cos(a)), math.floor(8 * math.sin(a)), z)
            for a, z in zip((0, 1.3, 2.5, 3.8, 5), (0, 3, -4, 5, -3))]
    m.add("m5_one_sided.off", Mesh(ring, [(i, (i + 1) % 5, (i + 2) % 5) for i in range(5)]))


def add_rules_6_to_9(m):
    m.add("m6_smallest.off", union(TET, moved(TET, (-1, -1, -1))), breaks={"M6": 1})
    m.add("m6_nearest_valid.off", union(TET, moved(TET, (-1, -1, -1), (-TINY, -TINY, -TINY))), breaks={})

    m.add("m7_smallest.off", bipyramid((1, 1, 4), (4, 4, 1)), breaks={"M7": 2})
    m.add("m7_nearest_valid.off", bipyramid((1, 1, 4), (1, 1, 1)), breaks={})
    needle = Mesh([(1, 1, 0), (1, 1, 2), (2, 1, 2), (1, 2, 2)], [(0, 1, 3), (0, 2, 1), (0, 3, 2), (1, 2, 3)])
    plate = moved(TET, (4, 4, -4))
    m.add("m7_touching_point.off", union(plate, needle), breaks={"M7": 3})
    m.add("m7_touching_point_nearest_valid.off", union(moved(plate, (1, 1, 1), (0, 0, -TINY)), needle), breaks={})
    m.add("m7_crossing_bodies.off", union(moved(TET, (4, 4, 4)), moved(TET, (4, 4, 4), (1, 1, 0.5))))
    m.add("m7_common_wall.off", union(moved(TET, (4, 4, 4)), moved(TET, (2, 2, -2), (1, 1, 0))))
    flat = Mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0.25, 0.25, 0)], [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])
    m.add("m7_flat.off", flat, breaks={"M7": 3})

    m.add("m8_smallest.off", reversed_faces(TET), breaks={"M8": 1})
    m.add("m8_nearest_valid.off", TET, breaks={})
    m.add("m8_one_of_two.stl", union(TET, reversed_faces(moved(TET, (1, 1, 1), (3, 0, 0)))), breaks={"M8": 1})

    outer, inner = moved(TET, (8, 8, 8)), moved(TET, (1, 1, 1), (1, 1, 1))
    m.add("m9_smallest.off", union(outer, inner), breaks={"M9": 1})
    m.add("m9_nearest_valid.off", union(outer, reversed_faces(inner)), breaks={})
    m.add("m9_inside_out.off", union(reversed_faces(outer), inner), breaks={"M8": 1, "M9": 1})


def add_valid_shapes(m):
    m.add("valid_torus.off", TORUS)
    m.add("valid_frame.off", frame())
    shells = [moved(TET, (s, s, s), (t, t, t)) for s, t in ((64, 0), (32, 4), (8, 6))]
    m.add("valid_nested_three.off", union(shells[0], reversed_faces(shells[1]), shells[2]))
    m.add("valid_two_bodies.obj", union(TET, moved(TET, (1, 1, 1), (2, 0, 0))))
    for name, size in (("huge", 2.0**1000), ("tiny", TINY), ("large", 2.0**1023)):
        m.add(f"valid_{name}.off", moved(TET, (size, size, size)))
    m.add("valid_mixed_scales.ply", moved(TET, (1e300, 1, TINY)))
    m.add("valid_far_away.off", moved(TET, (1, 1, 1), (2.0**52, -(2.0**52), 2.0**52)))
    # Corners of the kernel's grid: the same tetrahedron with vertices at opposite ends of the range.
    far = sys.float_info.max
    m.add("valid_whole_range.off",
          Mesh([(-far, -far, -far), (far, -far, -far), (-far, far, -far), (-far, -far, far)], TET.faces))


def add_valid_formats(m):
    box = cube()
    m.add("valid_quads.off", box, off(box, "OFF # a comment"))
    m.add("valid_coff.off", TET, b"COFF\n4 4 6\n" + b"".join(f"{row(v)} 255 0 0 255\n".encode() for v in TET.vertices) +
          b"".join(f"3 {row(f)} 0.5 0.5 0.5\n".encode() for f in TET.faces))
    text = "# a cube\r\nmtllib none.mtl\r\no part\r\n"
    text += "".join(f"v {row(v)}\r\n" for v in box.vertices) + "vn 0 0 1\r\nvt 0 0\r\n"
    text += "".join("f " + " ".join(f"{i - 8}/1/1" for i in f[:2]) + " \\\r\n "
                    + " ".join(f"{i + 1}//1" for i in f[2:]) + "\r\n"
                    for f in box.faces)
    m.add("valid_quads_crlf.obj", box, text.encode())
    text = obj(TET).decode().replace("v 0 1 0", "v -0.0 +1.e0 -0").replace("v 1 0 0", "v 10e-1 .0 0")
    m.add("valid_odd_decimals.obj", TET, text.encode())
    m.add("valid_byte_order_mark.obj", TET, b"\xef\xbb\xbf" + obj(TET))
    m.add("valid_unreferenced.obj", TET, obj(Mesh(TET.vertices + [(9, 9, 9)], TET.faces)), stated=5)
    soup = Mesh([TET.vertices[v] for f in TET.faces for v in f], [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(4)])
    m.add("valid_own_corners.off", TET, off(soup), stated=12)
    m.add("valid_own_corners.off", soup, off(soup), breaks={"M3": 12, "M7": 6}, options="--as-indexed")
    m.add("valid_solid_header.stl", TET, stl_binary(TET, b"solid but binary"))
    m.add("valid_capitals.stl", TET, stl_ascii(TET, word=str.upper))
    halves = stl_ascii(Mesh(TET.vertices, TET.faces[:2]),
                       "first") + stl_ascii(Mesh(TET.vertices, TET.faces[2:]), "second")
    m.add("valid_two_blocks.stl", TET, halves)
    m.add("valid_trailing_bytes.stl", TET, stl_binary(TET) + b"trailing")
    m.add("valid_ascii.ply", box, ply_ascii(box))
    m.add("valid_big_endian.ply", box, ply_binary(box, ">", "double"))
    m.add("valid_little_endian_float.ply", box, ply_binary(box, "<", "float"))
    strip = Mesh(TET.vertices, [(0, 2, 1, 3, 0, 2, -1)])
    m.add("valid_strip.ply", Mesh(TET.vertices, [(0, 2, 1), (1, 2, 3), (1, 3, 0), (0, 3, 2)]),
          ply_ascii(strip, face_element="tristrips"))


def add_unreadable(m):
    tet_off, tet_obj, tet_ply = off(TET), obj(TET), ply_ascii(TET)
    m.refuse("unreadable_empty.off", b"", "empty")
    m.refuse("unreadable_no_face.obj", tet_obj.split(b"f ")[0], "empty")
    m.refuse("unreadable_gzip.obj", b"\x1f\x8b\x08\0\0\0\0\0\0\3" + tet_obj, "foreign-format")
    m.refuse("unreadable_utf16.off", tet_off.decode().encode("utf-16"), "foreign-format")
    pointer = b"version https://git-lfs.github.com/spec/v1\noid sha256:" + b"0" * 64 + b"\nsize 9\n"
    m.refuse("unreadable_lfs_pointer.ply", pointer, "foreign-format")
    m.refuse("unreadable_unknown.dat", b"neither of the four\n", "unknown-format")
    m.refuse("unreadable_comma.off", tet_off.replace(b"1 0 0", b"1,5 0 0", 1), "syntax")
    m.refuse("unreadable_hex_float.off", tet_off.replace(b"\n1 0 0", b"\n0x1p0 0 0", 1), "syntax")
    m.refuse("unreadable_two_corners.obj", tet_obj + b"f 1 2\n", "syntax")
    m.refuse("unreadable_binary.off", tet_off.replace(b"OFF", b"OFF BINARY"), "foreign-format")
    m.refuse("unreadable_nan.stl", stl_binary(Mesh([(math.nan, 0, 0), *TET.vertices[1:]], TET.faces)), "not-finite")
    m.refuse("unreadable_infinite.off", tet_off.replace(b"\n1 0 0", b"\n1e400 0 0", 1), "not-finite")
    m.refuse("unreadable_nan_word.obj", tet_obj.replace(b"v 1 0 0", b"v nan 0 0"), "not-finite")
    m.refuse("unreadable_index.off", tet_off.replace(b"3 1 2 3", b"3 1 2 4"), "index-out-of-range")
    m.refuse("unreadable_index_0.obj", tet_obj + b"f 0 1 2\n", "index-out-of-range")
    m.refuse("unreadable_relative_index.obj", tet_obj + b"f -5 1 2\n", "index-out-of-range")
    m.refuse("unreadable_truncated.stl", stl_binary(TET)[:-1], "truncated")
    m.refuse("unreadable_announced.stl", stl_binary(TET, announced=4_000_000_000), "truncated")
    m.refuse("unreadable_cut.stl", stl_ascii(TET)[:-40], "truncated")
    m.refuse("unreadable_truncated.ply", tet_ply[:-6], "truncated")
    m.refuse("unreadable_announced.off", tet_off.replace(b"4 4 0", b"4000000000 4 0"), "truncated")
    m.refuse("unreadable_long_number.off",
             tet_off.replace(b"\n1 0 0", b"\n1." + b"0" * 1000 + b" 0 0", 1), "over-limit")
    m.refuse("unreadable_exponent.off", tet_off.replace(b"\n1 0 0", b"\n1e-4097 0 0", 1), "over-limit")


def main(arguments):
    if len(arguments) > 1 or arguments[:1] in (["-h"], ["--help"]):
        print(__doc__)
        return 2
    models = Models()
    for add in (add_rules_1_to_5, add_rules_6_to_9, add_valid_shapes, add_valid_formats, add_unreadable):
        add(models)
    models.write(pathlib.Path(arguments[0]) if arguments else ROOT / "tests" / "models")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
