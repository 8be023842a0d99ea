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

The numbers in EXPECT.tsv come from a second opinion: fractions, all pairs, no filters (mesh_oracle.py). The rule counts
of the mN models are also written down here by hand, and compared.
"""
import collections
import math
import pathlib
import sys

from mesh_oracle import Oracle
from mesh_writers import row, off, obj, stl_ascii, stl_binary, ply_ascii, ply_binary

ROOT = pathlib.Path(__file__).resolve().parent.parent
TINY = 5e-324  # the least positive double


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
