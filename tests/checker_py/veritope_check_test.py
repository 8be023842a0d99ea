#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Unit tests of verify/checker/veritope_check.py: every quirk of the reading rule, every condition id."""
import hashlib
import math
import os
import pathlib
import random
import struct
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "mutation"))
import attacks                                            # noqa: E402
import forge                                              # noqa: E402
import solids                                             # noqa: E402

PROGRAM = os.environ.get("VERITOPE_CHECK_PY") or str(attacks.CHECKER_PY)    # a mutant sets it
vc = attacks.load_checker(PROGRAM)
from veritope_checker.common.errors import Refused, Reject                   # noqa: E402
from veritope_checker.mesh import mesh_model, mesh_reader as reader, mesh_valid  # noqa: E402
TET_POINTS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
TET = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
T3 = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)]
INF = float("inf")


def read(text, fmt, as_indexed=False):
    return reader.read_model(text if isinstance(text, bytes) else text.encode("latin-1"), fmt, as_indexed)


class ReadingTest(unittest.TestCase):
    def yields(self, text, fmt, points, tris, as_indexed=False):
        found_points, found_tris = read(text, fmt, as_indexed)
        self.assertEqual((found_points, found_tris), (points, tris), text)
        self.assertEqual([repr(c) for p in found_points for c in p], [repr(c) for p in points for c in p], text)

    def refused(self, fmt, *texts):
        for text in texts:
            with self.assertRaises(Refused, msg=repr(text[:80])):
                read(text, fmt)


class CommonTest(ReadingTest):
    def test_decimals_follow_the_grammar_and_round_to_nearest(self):
        for token, value in (("1", 1.0), ("+1", 1.0), ("-1.", -1.0), (".5", .5), ("1e3", 1000.0), ("1E+3", 1000.0),
                             ("1.5e-3", .0015), ("0x0"[:1], 0.0), ("-0", 0.0), ("1e-400", 0.0), ("4.9e-324", 5e-324),
                             ("2.4703282292062327e-324", 0.0), ("2.4703282292062328e-324", 5e-324),
                             ("1.7976931348623157e308", 1.7976931348623157e308), ("9007199254740993", 9007199254740992.0),
                             ("0." + "0" * 5000 + "1e5001", 1.0), ("1" + "0" * 300, 1e300), ("0e99999999999999999999", 0.0),
                             ("9007199254740992." + "0" * 5000 + "1", 9007199254740992.0),
                             ("9007199254740993." + "0" * 5000 + "1", 9007199254740994.0)):
            self.assertEqual(reader.read_model(("v %s 0 0\nv 1 0 7\nv 0 1 7\nf 1 2 3" % token).encode(), "obj", True)[0][0][0], value)
        for token in ("", ".", "+", "1e", "1e+", "e5", "nan", "inf", "Infinity", "0x10", "1,5", "1_0", "1e400", "-1e400",
                      "1.7976931348623159e308", "1d5", "--1", "1.2.3", "\xb2", "1f", "1e5.0"):
            self.refused("off", "OFF 3 1 0\n%s 0 0\n1 0 0\n0 1 0\n3 0 1 2" % (token or "# "))

    def test_integers_follow_the_grammar(self):
        self.assertEqual(len(read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf +1 02 %s3" % ("0" * 5000), "obj")[1]), 1)
        self.refused("obj", *["v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 %s" % i for i in
                              ("3.0", "0x3", "3e0", "4", "-4", "0", "-0", "1" * 5000, "-" + "1" * 5000, "+", "/3", "3_0")])

    def test_equal_positions_are_one_vertex_unless_as_indexed(self):
        text = "OFF 5 1 0\n0 0 0\n0 -0 0\n1 0 0\n-0 -0.0 0\n0 1 0\n3 3 2 4"
        self.yields(text, "off", [T3[0], T3[1], T3[2]], [(0, 1, 2)])
        self.yields(text, "off", [T3[0], T3[0], T3[1], T3[0], T3[2]], [(3, 2, 4)], True)

    def test_polygons_are_fans_and_unreferenced_vertices_keep_their_ids(self):
        self.yields("OFF 6 1\n9 9 9\n0 0 0\n1 0 0\n1 1 0\n0 2 0\n-1 1 0\n5 1 2 3 4 5", "off",
                    [(9.0, 9.0, 9.0), T3[0], T3[1], (1.0, 1.0, 0.0), (0.0, 2.0, 0.0), (-1.0, 1.0, 0.0)],
                    [(1, 2, 3), (1, 3, 4), (1, 4, 5)])

    def test_refused_whatever_the_format(self):
        for fmt in forge.FORMATS:
            self.refused(fmt, b"", b"\xef\xbb\xbf", b"\xff\xfeO\0F\0", b"\xfe\xff\0O", b"\0\0\xfe\xff", b"\x1f\x8b\x08",
                         b"PK\x03\x04", b"BZh9", b"\xfd7zXZ\0", b"\x28\xb5\x2f\xfd", b"version https://git-lfs.github.com")

    def test_limits_of_the_page(self):
        self.assertEqual((reader.MAX_TRIANGLES, reader.MAX_VERTICES), (2 ** 30, 2 ** 32 - 1))
        for name, least in (("MAX_TRIANGLES", 1), ("MAX_VERTICES", 4)):
            with unittest.mock.patch.object(reader, name, least):
                read("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2", "off")
            with unittest.mock.patch.object(reader, name, least - 1):
                self.refused("off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2")

    def test_every_line_end_and_blank_and_a_byte_order_mark(self):
        for end in ("\n", "\r", "\r\n"):
            for blank in (" ", "\t", "\x0b", "\x0c", " \t "):
                self.yields("\xef\xbb\xbf" + end.join(["OFF", "3 1 0", "0 0 0", "", "1 0 0", "0 1 0", "3 0 1 2"]).replace(" ", blank),
                            "off", T3, [(0, 1, 2)])


class StlTest(ReadingTest):
    HEAD = b"solid looks like text".ljust(80)
    FACET = struct.pack("<12fH", *[9] * 3, *[c for p in T3 for c in p], 5)
    FACET_TEXT = "facet normal nan nan nan outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet\n"

    def test_binary_is_told_by_its_size_first(self):
        self.yields(self.HEAD + struct.pack("<I", 1) + self.FACET, "stl", T3, [(0, 1, 2)])
        body = b"anything".ljust(80) + struct.pack("<I", 1) + self.FACET
        self.yields(body + b"trailing bytes", "stl", T3, [(0, 1, 2)])
        self.refused("stl", body[:-1], body[:84], body[:60], b"anything".ljust(80) + struct.pack("<I", 0),
                     self.HEAD + struct.pack("<I", 1) + self.FACET + b"x", b"solids".ljust(80) + struct.pack("<I", 2) + self.FACET)

    def test_binary_coordinates_must_be_finite(self):
        for bad in (INF, -INF, float("nan")):
            for k in range(3, 12):                        # 0 to 2 are the normal
                numbers = [0] * 12
                numbers[k] = bad
                self.refused("stl", b"h" * 80 + struct.pack("<I", 1) + struct.pack("<12fH", *numbers, 0))

    def test_stl_is_always_merged(self):
        self.yields(self.HEAD + struct.pack("<I", 2) + 2 * self.FACET, "stl", T3, [(0, 1, 2), (0, 1, 2)], True)

    def test_ascii_blocks_and_any_case(self):
        one = "solid my name solid facet\n" + self.FACET_TEXT + "endsolid my name solid"
        self.yields(one, "stl", T3, [(0, 1, 2)])
        self.yields("\xef\xbb\xbf \n\t" + one.upper().replace("NAN", "x") + "\r" + one + "\n\n", "stl", T3, [(0, 1, 2)] * 2)
        self.yields("solid\nendsolid\n" + one, "stl", T3, [(0, 1, 2)])
        self.yields("solid\nfacet outer loop vertex 0 0 0 vertex 1 0 0 vertex\n0 1\n0 endloop endfacet endsolid", "stl", T3, [(0, 1, 2)])
        self.refused("stl", b"solid\nfacet normal 0 0 1 9 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet endsolid")
        self.yields("solid\nfacet solid endsolid vertex facet outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop "
                    "endfacet endsolid endsolid", "stl", T3, [(0, 1, 2)])

    def test_ascii_refusals(self):
        good = "solid x\n" + self.FACET_TEXT + "endsolid x\n"
        self.refused("stl", "solid\nendsolid", "solid x", "solid", good[:-12], good + "facet", good + "x", good + "endsolid",
                     good.replace("endloop ", ""), good.replace("endfacet", "vertex"), good.replace("loop", "lop", 1),
                     good.replace("vertex 0 1 0", ""), good.replace("0 1 0", "0 1 0 vertex 0 0 5"), good.replace("0 1 0", "0 1"),
                     good.replace("0 1 0", "0 1 nan"), good.replace("outer", "inner"), good.replace("outer loop", "outer outer loop"),
                     "solid x " + self.FACET_TEXT + "endsolid", good.replace("endsolid x", ""), "facet" + good,
                     good.replace("0 1 0", "0 1 0 0"))


class ObjTest(ReadingTest):
    V = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"

    def test_faces_of_all_kinds(self):
        for face in ("f 1 2 3", "f 1/7/9 2//5 3/2", "fo 1 2 3", " f\t-3 -2 -1", "f 1 2 3 # 4", "f 1 2 3#4", "f 1/x 2/ 3/#/",
                     "f 1 2 \\\n3", "f 1 2 \\\r\n3", "f 1 \\\r2 3", "f 1 2 \\\r3", "f 1 \\\n2 \\\n3"):
            self.yields(self.V + face, "obj", T3, [(0, 1, 2)])
            self.yields(self.V + face + "\n", "obj", T3, [(0, 1, 2)])

    def test_a_later_vertex_may_be_used_but_negative_indices_look_back(self):
        self.yields("f 1 2 3\n" + self.V, "obj", T3, [(0, 1, 2)])
        self.refused("obj", "f -1 -2 -3\n" + self.V, "v 0 0 0\nv 1 0 0\nf -1 -2 -3\nv 0 1 0")
        self.yields("v 5 5 5\n" + self.V + "f -3 -2 -1\nv 7 7 7", "obj", [(5.0, 5.0, 5.0)] + T3 + [(7.0, 7.0, 7.0)], [(1, 2, 3)])

    def test_everything_else_is_ignored(self):
        self.yields("mtllib x\no y\nvn 1 x\nvt\nv 0 0 0 1 0.5 red\nv 1 0 0\ng\nv 0 1 0\ns off\nusemtl\nl 1 2\np 99\nF 0\nV x\nfoo 0\n"
                    "f 1 2 3", "obj", T3, [(0, 1, 2)])

    def test_a_comment_line_with_a_backslash_goes_on(self):
        self.yields("# two \\\nv 9 9 9\n" + self.V + "f 1 2 3", "obj", T3, [(0, 1, 2)])

    def test_refusals(self):
        self.refused("obj", self.V, self.V + "f 1 2", self.V + "f", self.V + "f 1 2 4", self.V + "f 1 2 0", self.V + "f 1 2 3 4/1",
                     "v 0 0\n" + self.V + "f 1 2 3", "v 0 0 x\n" + self.V + "f 1 2 3", "v\n" + self.V + "f 1 2 3",
                     self.V + "f 1 2 x", self.V + "f 1 2 3\\", self.V + "f 1 2 #3", self.V + "f 1,2 2 3")


class OffTest(ReadingTest):
    BODY = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2"

    def test_headers(self):
        for word in ("OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCOFF", "STNOFF", "STCNOFF"):
            self.yields("%s\n3 1 0\n%s" % (word, self.BODY), "off", T3, [(0, 1, 2)])
        for head in ("OFF 3 1 0", "OFF\n\n3\n1", "#c\nOFF#c\n 3 #c\n#\n1 0 0 junk", "OFF 3 1 x y z # z", "OFF +3 01"):
            self.yields(head + "\n" + self.BODY, "off", T3, [(0, 1, 2)])
        self.refused("off", *[h + "\n" + self.BODY for h in
                              ("", "off 3 1 0", "4OFF 3 1 0", "nOFF 3 3 1 0", "OFF BINARY 3 1 0", "NCOFF 3 1 0", "CSTOFF 3 1", "OFF 3",
                               "OFF 3.0 1", "OFF -3 1", "OFF 3 -1", "OFF 4 1", "OFF 3 2", "OFF 3 0", "OFF 99999999999999999999 1", "3 1 0")])

    def test_a_header_alone_is_refused(self):
        self.refused("off", "OFF", "OFF 3", "OFF 3 1", "OFF 0 0", "OFF 3 1\n0 0 0\n1 0 0")

    def test_rows(self):
        self.yields("OFF 3 1 0\n0 0 0 9 x # z\n\n # only a comment\n1 0 0\n 0 1 0\n3 0 1 2 255 x\nanything", "off", T3, [(0, 1, 2)])
        for old, new in (("3 0 1 2", "3 0 1"), ("3 0 1 2", "3 0 1 3"), ("3 0 1 2", "3 0 1 -1"), ("3 0 1 2", "2 0 1"), ("3 0 1 2", "x 0 1 2"),
                         ("3 0 1 2", "3 0 1 2.0"), ("3 0 1 2", "4 0 1 2"), ("0 1 0", "0 1"), ("0 1 0", "0 1 #0"), ("3 0 1 2", "3 0 1\n2"),
                         ("3 0 1 2", "1" * 5000 + " 0 1 2"), ("0 1 0", "0 1 nan"), ("3 0 1 2", "0")):
            self.refused("off", ("OFF 3 1 0\n" + self.BODY).replace(old, new))


class PlyTest(ReadingTest):
    HEAD = ("ply\nformat ascii 1.0\ncomment a\nobj_info b\nelement vertex 3\nproperty float x\nproperty double y\n"
            "property int z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n")
    BODY = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"

    def test_ascii(self):
        self.yields(self.HEAD + self.BODY, "ply", T3, [(0, 1, 2)])
        self.yields(self.HEAD + self.BODY.replace("\n", " ") + "bytes behind", "ply", T3, [(0, 1, 2)])
        self.yields(self.HEAD.replace("indices", "index") + self.BODY, "ply", T3, [(0, 1, 2)])
        self.yields(self.HEAD + self.BODY.replace("0 1 0", "0 1 .5"), "ply", T3[:2] + [(0.0, 1.0, .5)], [(0, 1, 2)])
        self.yields("\xef\xbb\xbf" + self.HEAD + self.BODY, "ply", T3, [(0, 1, 2)])

    def test_the_first_line_fixes_the_line_end_of_the_header(self):
        for end in ("\r", "\r\n"):
            self.yields(self.HEAD.replace("\n", end) + self.BODY, "ply", T3, [(0, 1, 2)])
        self.refused("ply", *[start + self.HEAD + self.BODY for start in ("\n", "\r\n \t\n", " ", "\xef\xbb\xbf\n")])
        self.refused("ply", "ply \n" + self.HEAD[4:] + self.BODY, self.HEAD.replace("comment a", "comment a\r") + self.BODY,
                     self.HEAD.replace("\n", "\r\n", 1) + self.BODY, self.HEAD.replace("\n", "\r", 1) + self.BODY)

    def test_binary_of_both_orders_and_all_types(self):
        for order, e in (("binary_little_endian", "<"), ("binary_big_endian", ">")):
            for types, kind in (("float float32", "f"), ("double float64", "d"), ("char int8", "b"), ("uchar uint8", "B"),
                                ("short int16", "h"), ("ushort uint16", "H"), ("int int32", "i"), ("uint uint32", "I")):
                for t in types.split():
                    head = self.HEAD.replace("ascii", order).replace("float x", t + " x").replace("double y", t + " y").replace("int z", t + " z")
                    head = head.replace("uchar int vertex", "%s ushort vertex" % (t if kind not in "fd" else "uint8"))
                    count = struct.pack(e + (kind if kind not in "fd" else "B"), 3)
                    body = struct.pack(e + "9" + kind, 0, 0, 0, 1, 0, 0, 0, 1, 0) + count + struct.pack(e + "3H", 0, 1, 2)
                    self.yields(head.encode() + body, "ply", T3, [(0, 1, 2)])
                    self.yields(head.encode() + body + b"\xff", "ply", T3, [(0, 1, 2)])
                    self.refused("ply", head.encode() + body[:-1], head.encode() + body[:5])

    def test_binary_floats_are_finite_and_other_values_are_not_looked_at(self):
        head = self.HEAD.replace("ascii", "binary_little_endian").replace("double y", "float y").replace(
            "int z", "float z\nproperty float nx").encode()
        rows = [struct.pack("<4f", *p, float("nan")) for p in T3]
        face = struct.pack("<B3i", 3, 0, 1, 2)
        self.yields(head + b"".join(rows) + face, "ply", T3, [(0, 1, 2)])
        for bad in (INF, -INF, float("nan")):
            self.refused("ply", head + rows[0] + rows[1] + struct.pack("<4f", 0, bad, 0, 0) + face)

    def test_other_elements_and_properties_are_read_over(self):
        head = ("ply\nformat ascii 1.0\nelement junk 2\nproperty list char float a\nproperty short b\nelement face 2\nproperty list int8 uint other\n"
                "property list uchar uint vertex_index\nproperty float quality\nelement vertex 3\nproperty uchar red\nproperty float z\nproperty float y\n"
                "property list uchar int more\nproperty float x\nelement empty 4000000000\nend_header\n")
        self.yields(head + "2 a b c  0 d\n 1 7 3 0 1 2 nan\n0 3 2 1 0 x\n r 0 0 0 0\nr 0 0 1 q 1\n0 0 1 0 0\n", "ply", T3, [(0, 1, 2), (2, 1, 0)])
        self.refused("ply", head + "-1 x 0 d 1 7 3 0 1 2 q 0 3 2 1 0 x r 0 0 0 0 r 0 0 1 q 1 0 0 1 0 0",
                     head + "1.0 a b 0 d 1 7 3 0 1 2 q 0 3 2 1 0 x r 0 0 0 0 r 0 0 1 q 1 0 0 1 0 0")

    def test_counts_and_names_that_are_refused_wherever_they_stand(self):
        one = "end_header"
        self.yields(self.HEAD.replace(one, "element o 0\nproperty int a\nend_header") + self.BODY, "ply", T3, [(0, 1, 2)])
        for more in ("element o -1\nproperty int a", "element o 0\nproperty list uchar foo a", "element o 0\nproperty foo a",
                     "element vertex 0\nproperty float x\nproperty float y\nproperty float z", "element o 0\nproperty list double int a",
                     "element face 0\nproperty list uchar int vertex_indices", "element o 1\nproperty int a",
                     "element tristrips 0\nproperty list uchar int vertex_indices\nelement tristrips 0\nproperty list uchar int vertex_indices",
                     "element tristrips 0\nproperty list uchar double vertex_indices"):
            self.refused("ply", self.HEAD.replace(one, more + "\nend_header") + self.BODY)
        head = self.HEAD.replace("element vertex", "element o 1\nproperty list char int a\nproperty int b\nelement vertex")
        self.yields(head + "0 7 " + self.BODY, "ply", T3, [(0, 1, 2)])
        self.refused("ply", head + "-1 " + self.BODY, head + "-1 7 " + self.BODY, head + "-1 -1 7" + self.BODY)

    def test_polygons_of_mixed_sizes(self):
        head = self.HEAD.replace("ascii", "binary_big_endian").replace("vertex 3", "vertex 4").replace("face 1", "face 2").replace(
            "float x", "double x").replace("int z", "double z").encode()
        points = T3 + [(1.0, 1.0, 0.0)]
        body = b"".join(struct.pack(">3d", *p) for p in points)
        self.yields(head + body + struct.pack(">B3iB4i", 3, 0, 1, 2, 4, 0, 1, 3, 2), "ply", points, [(0, 1, 2), (0, 1, 3), (0, 3, 2)])
        self.refused("ply", head + body + struct.pack(">B3iB2i", 3, 0, 1, 2, 2, 0, 1), head + body + struct.pack(">B3iB", 3, 0, 1, 2, 0),
                     head + body + struct.pack(">B3iB3i", 3, 0, 1, 2, 3, 0, 1, 4), head + body + struct.pack(">B3iB3i", 3, 0, 1, 2, 3, 0, 1, -1))

    def test_tristrips(self):
        head = self.HEAD.replace("face", "tristrips").replace("vertex 3", "vertex 4")
        body = "0 0 0 1 0 0 0 1 0 1 1 0 "
        points = T3 + [(1.0, 1.0, 0.0)]
        for strip, tris in (("3 0 1 2", [(0, 1, 2)]), ("4 0 1 2 3", [(0, 1, 2), (2, 1, 3)]), ("8 0 1 2 -1 1 3 2 -1", [(0, 1, 2), (1, 3, 2)]),
                            ("9 0 1 2 2 3 1 -1 0 1", [(0, 1, 2), (3, 2, 1)]), ("5 -1 -1 0 1 2", [(0, 1, 2)]),
                            ("6 0 0 1 2 3 3", [(1, 0, 2), (1, 2, 3)])):
            self.yields(head + body + strip, "ply", points, tris)
        self.refused("ply", *[head + body + s for s in ("2 0 1", "0", "3 -1 -1 -1", "3 0 1 4", "3 0 1 -2", "3 0 0 9", "4 0 1 2 9", "3 0 1", "3 0 1 2.0")])
        both = head.replace("end_header", "element face 1\nproperty list uchar int vertex_index\nend_header")
        self.yields(both + body + "3 0 1 2 3 3 2 1", "ply", points, [(0, 1, 2), (3, 2, 1)])
        unsigned = head.replace("ascii", "binary_little_endian").replace("uchar int v", "uchar uint v").replace("double y", "float y").replace("int z", "float z")
        self.refused("ply", unsigned.encode() + struct.pack("<12fB4I", *[c for p in points for c in p], 4, 0, 1, 2, 2 ** 32 - 1))

    def test_header_refusals(self):
        h, b = self.HEAD, self.BODY
        self.refused("ply", h + b[:-2], b, "plyx\n" + h[4:] + b, "PLY\n" + h[4:] + b, "ply", "ply\n", h.replace("end_header", "") + b)
        for old, new in (("1.0", "1.1"), ("ascii", "binary"), ("format", "comment\nformat"), ("format ascii 1.0\n", ""), ("float x", "float128 x"),
                         ("float x", "float u"), ("vertex 3", "vertices 3"), ("vertex 3", "vertex x"), ("vertex 3", "vertex -3"), ("vertex 3", "vertex"),
                         ("vertex 3", "vertex 2"), ("vertex 3", "vertex 4000000000"), ("face 1", "face -1"), ("face 1", "face 2"), ("face 1", "face 0"),
                         ("list uchar", "list float"), ("uchar int v", "uchar float v"), ("vertex_indices", "vertex_ids"), ("property list uchar int vertex_indices\n", ""),
                         ("uchar int v", "uchar int vertex_index\nproperty list uchar int v"), ("element face 1", "element face 1\nproperty int a b"),
                         ("comment a", "unknown a"), ("element vertex 3", "property float w\nelement vertex 3"), ("float x", "list uchar float x"),
                         ("element face 1", "element vertex 0\nproperty float x\nelement face 1"), ("list uchar int vertex_indices", "int vertex_indices"),
                         ("comment a", "format ascii 1.0"), ("end_header", "end_header x"), ("end_header", "end_header\x0c x")):
            self.refused("ply", h.replace(old, new, 1) + b)


# ---------------------------------------------------------------- certificates

class CertificateTest(unittest.TestCase):
    def setUp(self):
        self.rng = random.Random(7)
        self.use(forge.Model(TET_POINTS, TET))

    def use(self, model):
        self.model, self.bytes, self.mesh = model, model.encode(), forge.mesh_of(model)
        return self

    def plan(self, share=0, **changes):
        p = forge.Plan(self.mesh, random.Random(3), share)
        for key, value in changes.items():
            setattr(p, key, value)
        return p

    def cert(self, plan=None):
        return (plan or self.plan()).certificate(self.bytes, self.model)

    def says(self, expected, cert, model=None):
        code, message = vc.check(self.bytes if model is None else model, cert)
        self.assertEqual(attacks.condition_of(code, message), expected, message)

    def with_body(self, change, cert=None):
        """The certificate with a changed body and the right body hash."""
        line, _, body = (cert or self.cert()).partition(b"\n")
        new = change(body)
        return line.replace(hashlib.sha256(body).hexdigest().encode(), hashlib.sha256(new).hexdigest().encode()) + b"\n" + new

    def with_line(self, old, new):
        line, _, body = self.cert().partition(b"\n")
        self.assertIn(old, line)
        return line.replace(old, new, 1) + b"\n" + body


class StatementTest(CertificateTest):
    def test_honest(self):
        self.says("ACCEPT", self.cert())
        self.assertEqual(vc.check(self.bytes, self.cert()), (0, "ACCEPT mesh-valid-1"))

    def test_order_of_keys_is_free(self):
        self.says("ACCEPT", self.with_line(b'{"certificate":"veritope-certificate-1",', b"{").replace(
            b"}\n", b',"certificate":"veritope-certificate-1"}\n', 1))
        self.says("ACCEPT", self.with_line(b'"forge"', b'"' + b"x" * 200 + b'"'))
        self.says("ACCEPT", self.with_line(b'"forge"', b'""'))

    def test_s1(self):
        for old, new in ((b'"forge"', b'"' + b"x" * 201 + b'"'), (b'"forge"', b'"a\\nb"'), (b'"forge"', b'"\xc3\xa9"'), (b'"forge"', b'"a\tb"'), (b'"forge"', b'"\x1f"'), (b'"forge"', b'"\x7f"'),
                         (b'"forge"', b"7"), (b'"forge"', b"null"), (b'"forge"', b'{"a":1}'), (b'"forge"', b'["a"]'), (b'"tool"', b'"Tool"'),
                         (b'"tool":"forge",', b""), (b'"tool":"forge",', b'"tool":"forge","tool":"forge",'), (b'"tool"', b'"x":1,"tool"'),
                         (b'"tool":', b'"tool" :'), (b"{", b"{ "), (b"{", b""), (b"}", b""), (b"}", b"} "), (b"}", b",}"), (b"}", b"}}"),
                         (b"{", b"[{"), (b'{"cert', b'["cert'), (b'{"cert', b'"cert'), (b'"faces":4', b'"faces":00'), (b"veritope-certificate-1", b"veritope-certificate-2"), (b"mesh-valid-1", b"mesh-valid-2"),
                         (b'"off"', b'"OFF"'), (b'"off"', b'"3mf"'), (b'"as_indexed":false', b'"as_indexed":"false"'), (b'"as_indexed":false', b'"as_indexed":0'),
                         (b'"as_indexed":false', b'"as_indexed":False'), (b'"faces":4', b'"faces":"4"'), (b'"faces":4', b'"faces":04'),
                         (b'"faces":4', b'"faces":-4'), (b'"faces":4', b'"faces":4.0'), (b'"faces":4', b'"faces":4e0'), (b'"faces":4', b'"faces":true'),
                         (b'"faces":4', b'"faces":18446744073709551616'), (b'"faces":4', b'"faces":' + b"9" * 6000), (b'"1/6"', b'"1/0"'), (b'"1/6"', b'"01/6"'),
                         (b'"1/6"', b'"1"'), (b'"1/6"', b'"+1/6"'), (b'"1/6"', b'"1/-6"'), (b'"1/6"', b'"1 /6"'), (b'"1/6"', b'1'), (b'"1/6"', b'"-0/1"'), (b'"1/6"', b'"-1/6"'),
                         (b'"volume"', b'"rules":"M1","volume"'), (b'"faces":4,', b""), (b'"subject_sha256":"', b'"subject_sha256":"0')):
            self.says("S1", self.with_line(old, new))
        sha = hashlib.sha256(self.bytes).hexdigest().encode()
        self.says("S1", self.with_line(sha, sha.upper()))
        self.says("S1", b"")
        self.says("S1", self.cert().partition(b"\n")[0])
        self.says("S1", self.cert().replace(b"\n", b"\r\n", 1))
        self.says("S1", b"\n" + self.cert())
        self.says("S1", b" " * 65537 + b"\n")
        room = 65536 - len(self.cert().partition(b"\n")[0])
        self.says("V11", self.with_line(b'"1/6"', b'"1/6' + b"6" * room + b'"'))
        self.says("S1", self.with_line(b'"1/6"', b'"1/6' + b"6" * (room + 1) + b'"'))
        self.says("V11", self.with_line(b'"faces":4', b'"faces":18446744073709551615'))
        self.says("V11", self.with_line(b'"faces":4', b'"faces":0'))
        for volume in (b"1" * 60001 + b"/7", b"2/12", b"0/6", b"0/1"):
            self.says("V11", self.with_line(b'"1/6"', b'"' + volume + b'"'))

    def test_s1_of_invalid(self):
        flipped = self.use(forge.Model(TET_POINTS, [(0, 1, 2)] + TET[1:]))
        for rules in ("", "M5 M5", "M5 M3", "M10", "M0", "M5  M8", " M5", "M5 ", "5", "m5"):
            self.says("S1", forge.invalid_certificate(self.bytes, self.model, self.mesh, [(5, 0, 1)], [rules]))
        self.says("ACCEPT", forge.invalid_certificate(flipped.bytes, flipped.model, flipped.mesh, [(5, 0, 1)]))

    def test_s2_s3_s4(self):
        self.says("S2", self.with_line(b"Reading rule v1", b"Reading rule v2"))
        self.says("S3", self.cert(), self.bytes + b"\n")
        self.says("S3", self.cert(), self.bytes.replace(b"1", b"2", 1))
        self.says("S3", self.with_line(b'"subject_bytes":', b'"subject_bytes":1'))
        self.says("S4", self.cert() + b"\0")
        self.says("S4", self.cert()[:-1])

    def test_a_refused_model_is_exit_4(self):
        self.use(forge.Model(TET_POINTS, TET))
        data = b"OFF 1 0 0\n0 0 0"
        cert = self.model.copy()
        cert = self.plan().certificate(data, cert)
        self.assertEqual(vc.check(data, cert)[0], 4)

    def test_missing_memory_is_exit_3(self):
        with unittest.mock.patch.object(reader, "read_model", side_effect=MemoryError):
            self.assertEqual(vc.check(self.bytes, self.cert()), (3, "ERROR: out of memory"))

    def test_a_bug_is_exit_5(self):
        self.assertEqual(vc.check(self.bytes, None)[0], 5)


class BodyTest(CertificateTest):
    def test_b1_valid(self):
        self.says("ACCEPT", self.with_body(lambda b: b))
        for change in (lambda b: b"", lambda b: b[:3], lambda b: b"VTMI" + b[4:], lambda b: b[:-1], lambda b: b + b"\0", lambda b: b[:4] + b"\5" + b[5:],
                       lambda b: b[:8] + b"\5" + b[9:], lambda b: b[:28] + b"\x0f" + b[29:], lambda b: b[:28] + b"\x0e" + b[29:],
                       lambda b: b[:32] + b"\1\0\0\0" + bytes(12) + b[36:], lambda b: b[:32] + b"\xff" * 4 + b[36:], lambda b: b[:36] + b"\xff" * 4 + b[40:],
                       lambda b: b[:40] + b"\xff" * 4 + b[44:]):
            self.says("B1", self.with_body(change))

    def test_b1_varints(self):
        for sep, expected in ((b"\0\0\0\0", "V8"), (b"\x80\0\0\0\0", "B1"), (b"\0\x80\0\0\0", "B1"), (b"\0" + b"\xff" * 9 + b"\1\0\0", "B1"),
                              (b"\xff" * 9 + b"\1\0\0\0", "V8"), (b"\xff" * 9 + b"\2\0\0\0", "B1"), (b"\x80" * 9 + b"\2\0\0\0", "B1"), (b"\xff" * 9 + b"\x81\0\0\0\0", "B1"),
                              (b"\1\xfe\xff\xff\xff\x0f\0\0", "V8"), (b"\1\x80\x80\x80\x80\x10\0\0", "B1"), (b"\1\xfd\xff\xff\xff\x0f\0\0", "V8"),
                              (b"\1\xff\xff\xff\xff\x0f\0\0", "B1"), (b"\0\0\0", "B1")):
            self.says(expected, self.with_body(lambda b: b[:36] + b"\1\0\0\0" + sep + b[40:]))

    def test_b1_nesting_codes(self):
        self.use(forge.Model(*solids.join((TET_POINTS, TET), solids.move((TET_POINTS, TET), (9, 0, 0)))))
        self.says("ACCEPT", self.cert())
        self.says("B1", self.with_body(lambda b: b[:-1] + b"\6"))
        self.says("B1", self.with_body(lambda b: b[:-1]))
        self.says("B1", self.with_body(lambda b: b[:-2]))

    def walks(self, m, allowed, separator=None):
        """Triangles whose boxes all meet: m of them take all (m - 1)^2 calls of cross."""
        tris = [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(m)]
        points = [(x + i / 128, y + i / 64, z) for i in range(m) for x, y, z in ((0., 0., 0.), (99., 1., 0.), (1., 99., 1.))]

        class Body:
            order, stars, codes, work = list(range(m)), [0] * len(points), b"", allowed
            separators = [separator] if separator else []
        try:
            mesh_valid.Walk(Body, mesh_model.Mesh(points, tris), {"V8", "V9"}).run()
        except Reject as e:
            self.assertEqual(e.condition, "B1")
            return False
        return True

    def test_b1_too_much_work(self):
        for m in (2, 3, 8, 21):
            units = (m - 1) ** 2
            self.assertTrue(self.walks(m, units))
            self.assertFalse(self.walks(m, units - 1))
            last = units - 1, (1, 0, 0)                   # in the place of the last call of all, a leaf pair: 2 units more
            self.assertTrue(self.walks(m, units + 2, last))
            self.assertFalse(self.walks(m, units + 1, last))

    def test_b1_invalid(self):
        self.use(forge.Model(TET_POINTS, [(0, 1, 2)] + TET[1:]))
        good = forge.invalid_certificate(self.bytes, self.model, self.mesh, [(5, 0, 1)])
        self.says("ACCEPT", good)
        for change in (lambda b: b"VTMV" + b[4:], lambda b: b + b"\0", lambda b: b[:-1], lambda b: b[:12] + bytes(4), lambda b: b[:12] + b"\xff" * 4 + b[16:],
                       lambda b: b[:16] + b"\0" + b[17:], lambda b: b[:16] + b"\x0a" + b[17:], lambda b: b[:-4] + b"\4\0\0\0",
                       lambda b: b[:12] + b"\2\0\0\0" + b[16:] + struct.pack("<BII", 3, 0, 1), lambda b: b[:12] + b"\2" + b[13:]):
            self.says("B1", self.with_body(change, good))
        for w in ((1, 4), (2, 0, 4), (3, 0, 4), (6, 4), (8, 4, 0), (8, 0, 3)):
            self.says("B1", forge.invalid_certificate(self.bytes, self.model, self.mesh, [w]))
        natural = forge.natural
        try:
            forge.natural = lambda n: struct.pack("<I", 2) + bytes([n, 0])
            bad = forge.invalid_certificate(self.bytes, self.model, self.mesh, [(7, 0, 1, (1, 0, 0), (1, 0, 0))])
        finally:
            forge.natural = natural
        self.says("B1", bad)

    def test_b1_work_of_witnesses(self):
        p, fans = solids.copy_at_vertex(TET_POINTS, TET, self.rng)          # two cycles at vertex 1
        flipped = [(0, 1, 2)] + TET[1:]
        crossing = [(0, 0, 0), (4, 0, 0), (0, 4, 0), (1, 1, -1), (1, 1, 1), (9, 9, 1)]
        for points, tris, witness, units in (
                (p, fans, (6, 1), 6), (TET_POINTS, TET[1:], (3, 0, 1), 2), (TET_POINTS, TET + [(0, 1, 2)], (4, 0, 1), 4),
                (TET_POINTS, flipped, (5, 0, 1), 3), (TET_POINTS, solids.reverse(TET), (8, 0, 2), 4),
                (TET_POINTS, solids.reverse(TET), (9, 0, 2), 4), (TET_POINTS, TET + [(1, 2, 0)], (2, 4, 0), 0),
                (TET_POINTS, TET + [(0, 1, 1)], (1, 4), 0), (crossing, [(0, 1, 2), (3, 4, 5)], (7, 0, 1, (2, 1, 1), (1, 1, 0)), 0)):
            self.use(forge.Model(points, tris))
            cert = forge.invalid_certificate(self.bytes, self.model, self.mesh, [witness] * 3)
            with unittest.mock.patch.object(mesh_model.Body, "work", lambda *_: 3 * units):
                self.says("ACCEPT", cert)
            with unittest.mock.patch.object(mesh_model.Body, "work", lambda *_: 3 * units - 1):
                self.says("B1", cert)

    def test_b1_work_of_a_certificate_at_its_bound(self):
        """Two fans of 10,000 triangles whose tips are joined by an open edge: 10,000 units for its witness, 2 for one at the rim."""
        d = 10000
        rim = [(math.ldexp(i, -4), math.ldexp(i * i, -8), 1.) for i in range(d)]
        tris = [(0, 1, 2)] + [(0, 1 + i, 2 + i) for i in range(1, d)] + [(1, 1 + d + i, 2 + d + i) for i in range(1, d)]
        model = forge.Model([(0., 0., 0.), (1., 0., 0.)] + rim + [(x, y, 2.) for x, y, _ in rim], tris, "off", True)
        self.use(model)
        self.assertEqual(sum(0 in t for t in tris), d)
        self.assertEqual(sum(1 in t for t in tris), d)
        heavy, light, lightest = (3, 0, 1), (3, 4, 5), (3, 1 + d, 0)
        self.assertEqual([min(sum(v in t for t in tris) for v in w[1:]) for w in (heavy, light, lightest)], [d, 2, 1])
        for n in range(20000, 40000):                     # all of at least one unit
            heavies, lights = divmod(1000 * (len(tris) + 16 + 9 * n) - n, d - 1)
            if heavies + lights < n:
                break
        for lights, expected in ((lights, "ACCEPT"), (lights + 1, "B1")):
            witnesses = [heavy] * heavies + [light] * lights + [lightest] * (n - heavies - lights)
            self.says(expected, forge.invalid_certificate(self.bytes, self.model, self.mesh, witnesses))

    def test_b1_work_of_the_nesting(self):
        """One unit for each box that the rays look into, over all shells."""
        inner = solids.box_of(1)
        self.use(forge.Model(*solids.join(solids.box_of(3), (inner[0], solids.reverse(inner[1])))))
        cert, run = self.cert(), mesh_valid.Walk.run

        def boxes(order, f_boxes, ray):                   # of the subtree of an order, by its definition
            lo, hi = [[pick(f_boxes[f][side][k] for f in order) for k in range(3)] for side, pick in ((0, min), (1, max))]
            v, u, minus = ray
            p, q = (u + 1) % 3, (u + 2) % 3
            if not (lo[p] <= v[p] < hi[p] and lo[q] <= v[q] < hi[q] and (lo[u] <= v[u] if minus else hi[u] >= v[u])) or len(order) == 1:
                return 1
            half = len(order) // 2
            return 1 + boxes(order[:half], f_boxes, ray) + boxes(order[half:], f_boxes, ray)
        f_boxes = [tuple(zip(*box)) for box in self.mesh.box]
        plan = self.plan()
        units = 0
        for faces, code in zip(plan.shells, plan.nesting):
            u, minus = divmod(code, 2)
            vertices = [self.mesh.p[v] for f in faces for v in self.mesh.tris[f]]
            extreme = (min if minus else max)(p[u] for p in vertices)
            first = min(v for f in faces for v in self.mesh.tris[f] if self.mesh.p[v][u] == extreme)
            units += boxes(plan.order, f_boxes, (self.mesh.p[first], u, minus))
        for allowed, expected in ((units, "ACCEPT"), (units - 1, "B1")):
            def run_and_set(walk, allowed=allowed):
                run(walk)
                walk.cert.work = allowed
            with unittest.mock.patch.object(mesh_valid.Walk, "run", run_and_set):
                self.says(expected, cert)


class ValidTest(CertificateTest):
    def test_v1(self):
        for order in ([0, 1, 2, 2], [0, 1, 2, 4], [3, 2, 1, 2 ** 32 - 1]):
            self.says("V1", self.with_body(lambda b: b[:12] + struct.pack("<4I", *order) + b[28:]))

    def test_v2(self):
        p, t = solids.copy_at_vertex(TET_POINTS, TET, self.rng)
        self.says("V2", self.use(forge.Model(p, t, as_indexed=True)).cert())
        self.says("V6", self.use(forge.Model(p, t)).cert())
        self.says("ACCEPT", self.use(forge.Model(TET_POINTS + [(0, 0, 0)], TET, as_indexed=True)).cert())
        # Both vertices in one triangle only: V4 fails, too, but V2 comes first.
        once = [(0, 1, 2), (3, 4, 5)], TET_POINTS[:3] + [(0, 0, 5), (5, 0, 5)]
        for place in once[1]:
            self.says("V2", self.use(forge.Model(once[1] + [place], once[0], as_indexed=True)).cert())

    def test_v3(self):
        self.says("V3", self.use(forge.Model(TET_POINTS, TET + [(0, 0, 1)])).cert())
        self.says("V3", self.use(forge.Model(TET_POINTS + [(2, 0, 0)], TET + [(0, 1, 4)])).cert())

    def test_v4(self):
        self.says("V4", self.use(forge.Model(TET_POINTS, TET[:3])).cert())
        self.says("V4", self.use(forge.Model(TET_POINTS, [(0, 1, 2)] + TET[1:])).cert())
        self.says("V4", self.use(forge.Model(TET_POINTS, TET + TET[:1])).cert())

    def test_v5(self):
        p = TET_POINTS + [(9, 0, 0), (9, 1, 0), (9, 0, 1)]
        self.says("V5", self.use(forge.Model(p, TET + [(4, 5, 6), (4, 6, 5)])).cert())

    def test_v6(self):
        p, t = solids.copy_at_vertex(TET_POINTS, TET, self.rng)
        self.says("V6", self.use(forge.Model(p, t)).cert())

        self.says("V6", self.use(forge.Model([(9, 9, 9)] + p, [tuple(v + 1 for v in f) for f in t])).cert())

    def test_v7(self):
        for v in range(4):
            for code in range(1, 14):
                holds = forge.star_holds(self.mesh, v, forge.STAR_TABLE[code - 1])
                self.says("ACCEPT" if holds else "V7", self.cert(self.plan(stars={v: code})))
        self.says("V7", self.cert(self.plan(stars={0: (0, 0, 0)})))
        self.says("ACCEPT", self.cert(self.plan(stars={0: (5, 6, 7)})))
        self.says("ACCEPT", self.cert(self.plan(stars={0: (-5, -6, -7)})))
        self.use(forge.Model(TET_POINTS + [(5, 5, 5)], TET))
        self.says("V7", self.cert(self.plan(stars={4: 1})))

    def test_v7_a_vector_at_every_vertex(self):
        """Their bytes are the greater part of the body."""
        corners, tris = [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)]
        self.use(forge.Model(*solids.join(*(solids.move((corners, tris), (9 * i, 0, 0)) for i in range(8)))))
        corners *= 8
        cert = self.cert(self.plan(stars=dict(enumerate(corners))))
        self.assertLess(len(cert.partition(b"\n")[2]), 13 * len(corners) + 4 + 8 + 4 * len(self.mesh.tris) + len(corners) + 4)
        self.says("ACCEPT", cert)

    def test_v8(self):
        self.use(forge.Model(*solids.join((TET_POINTS, TET), solids.move((TET_POINTS, TET), (1, 1, -1)))))
        for order in (list(range(8)), [0, 4, 1, 5, 2, 6, 3, 7]):
            whole = self.plan(order=order)
            whole.cut = lambda a, b, k: (1, 1, -1) if max(a) < 4 <= min(b) else (-1, -1, 1) if max(b) < 4 <= min(a) else None
            self.says("ACCEPT", self.cert(whole))
            wrong = whole.copy()
            wrong.cut = lambda a, b, k: whole.cut(b, a, k)
            self.says("V8", self.cert(wrong))
        spare = whole.copy()
        spare.extra_separators = [(1000, (1, 0, 0))]
        self.says("V8", self.cert(spare))
        spare.extra_codes = b"\0"                         # V8 comes before V9
        self.says("V8", self.cert(spare))

    def test_v8_touching_sets_need_a_simplex(self):
        tip = [(0, 0, 0), (-1, 0, 0), (0, -1, 0), (0, 0, -1)]
        p, t = solids.join((TET_POINTS, TET), (tip, solids.reverse(TET)))
        self.use(forge.Model(p, t))
        self.says("V6", self.cert())
        points, tris = forge.mesh_of(self.model).floats, self.mesh.tris
        mesh = mesh_model.Mesh(points, tris)
        self.assertEqual(mesh_valid.compare((-1, -1, -1), [0, 1, 2, 3], [0, 4, 5, 6], mesh.points), 1)
        self.assertEqual(mesh_valid.compare((-1, 0, 0), [0, 1, 2, 3], [0, 4, 5, 6], mesh.points), ([0, 2, 3], [0, 5, 6]))
        self.assertEqual(mesh_valid.compare((1, 0, 0), [0, 1, 2, 3], [0, 4, 5, 6], mesh.points), 0)
        line = mesh_model.Mesh([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (2.0, 0.0, 0.0), (0.0, 1.0, 0.0)], [(0, 1, 3)])
        self.assertEqual(mesh_valid.compare((0, 1, 0), [0, 1], [1, 2], line.points), ([0, 1], [1, 2]))
        self.assertEqual(mesh_valid.compare((0, 0, 1), [0, 1], [1, 3], line.points), 1)
        self.assertEqual(mesh_valid.compare((0, 1, 0), [0, 2], [0, 2], line.points), 1)

    def test_v9(self):
        honest = self.plan()
        honest.walk()
        a, b = next(p for p, c in self.mesh.codes.items() if c)
        for code in range(256):
            codes = bytes([code])
            holds = [code] in ([c] for c in self.one_byte_codes(a, b))
            self.says("ACCEPT" if holds else "V9", self.cert(self.plan(forced={frozenset((a, b)): codes})))
        self.says("V9", self.cert(self.plan(extra_codes=b"\0")))
        self.says("V9", self.cert(self.plan(forced={frozenset((a, b)): b""})))
        self.use(forge.Model(*solids.voxel_surface({(0, 0, 0), (1, 0, 0), (0, 1, 0)})))
        self.says("ACCEPT", self.cert())
        pair = next(p for p, c in sorted(self.mesh.codes.items()) if c and 0 in self.one_byte_codes(*p))
        self.says("ACCEPT", self.cert(self.plan(forced={frozenset(pair): b"\0"})))
        self.says("V9", self.cert(self.plan(forced={frozenset(pair): b"\x80"})))

    def one_byte_codes(self, a, b):
        for c, d in enumerate(forge.axis_vectors(self.mesh, a, b)):
            for code, e in ((c, d), (c + 32, forge.neg(d))):
                gap, p, q = forge.apply_axis(self.mesh, e, self.mesh.tris[a], self.mesh.tris[b])
                if gap > 0 or gap == 0 and forge.closes(self.mesh, p, q):
                    yield code

    def test_v9_chains(self):
        self.use(forge.Model(*solids.voxel_surface({(0, 0, 0), (1, 0, 0)})))
        self.says("ACCEPT", self.cert())
        seen = set()
        for (a, b), chain in sorted(self.mesh.codes.items()):
            longer = chain and forge.detour(self.mesh, a, b, self.rng)
            if not longer:
                continue
            key, first = frozenset((a, b)), longer[0]
            stay = [c | 64 for c in chain_codes_that_stay(self.mesh, a, b)][:1]
            for codes, expected in ((longer, "ACCEPT"), (longer[:-1] + [longer[-1] | 64], "V9"), ([first & 63] + longer[1:], "V9"), ([first], "V9"),
                                    ([first | 128] + longer[1:], "V9"), (stay * 3 + chain, "ACCEPT"), (stay * 4 + chain, "V9" if stay else "ACCEPT"),
                                    (stay * 3 + [chain[0] | 64], "V9"), (stay * 4, "V9"), (stay * 3, "V9")):
                seen.add((len(codes), expected))
                self.says(expected, self.cert(self.plan(forced={key: bytes(codes)})))
        self.assertLessEqual({(2, "ACCEPT"), (4, "ACCEPT"), (5, "V9")}, seen)

    def test_v10(self):
        self.says("V10", self.use(forge.Model(TET_POINTS, solids.reverse(TET))).cert())
        outer, inner = solids.box_of(3), solids.box_of(1)
        for code in range(6):
            for a, b, expected in ((outer[1], inner[1], "V10"), (solids.reverse(outer[1]), inner[1], "V10"), (outer[1], solids.reverse(inner[1]), "ACCEPT"),
                                   (solids.reverse(outer[1]), solids.reverse(inner[1]), "V10")):
                for first in (True, False):
                    parts = [(outer[0], a), (inner[0], b)]
                    self.use(forge.Model(*solids.join(*(parts if first else parts[::-1]))))
                    plan = self.plan(nesting=[code, code])
                    plan.values = {"bodies": 1}
                    self.says(expected, self.cert(plan))
        flat = [(0, 0, 0), (2, 0, 0), (0, 2, 0), (2, 2, 0)]
        self.says("V10", self.use(forge.Model(flat, [(0, 1, 2), (1, 3, 2), (0, 2, 3), (0, 3, 1)])).cert_skipping({"V8", "V9"}))

    def cert_skipping(self, skip):
        """The certificate, judged with conditions disabled: returned only if V10 names itself."""
        cert = self.cert()
        code, message = vc._check(self.bytes, cert, frozenset(skip))
        self.assertEqual(attacks.condition_of(code, message), "V10")
        self.assertEqual(vc._check(self.bytes, cert, frozenset(skip | {"V10", "V11"}))[0], 0)
        inverted = self.use(forge.Model(TET_POINTS, solids.reverse(TET)))
        return inverted.cert()

    def test_v11(self):
        for key, lie in (("vertices", 5), ("edges", 5), ("faces", 5), ("shells", 2), ("bodies", 0), ("genus", 1), ("volume", "1/7"), ("volume", "0/1")):
            self.says("V11", self.cert(self.plan(values={key: lie})))

    def test_quantities_of_a_torus_in_a_box(self):
        torus = solids.torus(random.Random(1))
        p, t = solids.join(solids.move(solids.box_of(1000)), (torus[0], solids.reverse(torus[1])), solids.move(solids.box_of(5), (5000, 0, 0)))
        self.use(forge.Model([tuple(c / 1024 for c in q) for q in p], t))
        cert = self.cert(self.plan(1))
        self.assertIn(b'"shells":3,"bodies":2,"genus":1', cert)
        self.says("ACCEPT", cert)


def chain_codes_that_stay(mesh, a, b):
    """Axes along which both triangles lie in one plane: an open test that removes no vertex."""
    for c, d in enumerate(forge.axis_vectors(mesh, a, b)):
        gap, p, q = forge.apply_axis(mesh, d, mesh.tris[a], mesh.tris[b])
        if gap == 0 and len(p) == len(q) == 3 and not forge.closes(mesh, p, q):
            yield c


class InvalidTest(CertificateTest):
    def claim(self, expected, points, tris, *witnesses, rules=None, as_indexed=True):
        self.use(forge.Model(points, tris, as_indexed=as_indexed))
        self.says(expected, forge.invalid_certificate(self.bytes, self.model, self.mesh, list(witnesses), rules))

    def test_i1(self):
        p = TET_POINTS + [(2, 0, 0)]
        self.claim("ACCEPT", p, TET + [(0, 1, 4)], (1, 4))
        self.claim("ACCEPT", p, TET + [(0, 1, 1)], (1, 4))
        self.claim("I1", p, TET + [(0, 1, 4)], (1, 0))

        self.claim("ACCEPT", [(0, 0, 0)], [(0, 0, 0)], (1, 0))

    def test_i2(self):
        self.claim("ACCEPT", TET_POINTS, TET + [(1, 2, 0)], (2, 4, 0))
        self.claim("I2", TET_POINTS, TET + [(1, 2, 0)], (2, 4, 4))
        self.claim("I2", TET_POINTS, TET + [(1, 2, 0)], (2, 4, 1))

    def test_i3_i4_i5(self):
        for rule, tris in ((3, TET[1:]), (4, TET + [(0, 1, 2)]), (5, [(0, 1, 2)] + TET[1:])):
            for a, b in ((0, 1), (1, 0), (0, 3), (3, 0), (1, 1)):
                good = rule < 5 and {a, b} == {0, 1} or (a, b) == (0, 1)
                self.claim("ACCEPT" if good else "I%d" % rule, TET_POINTS, tris, (rule, a, b))
        self.claim("I3", TET_POINTS, TET + [(0, 3, 0)], (3, 0, 3))
        self.claim("I4", TET_POINTS, TET + [(0, 3, 0)], (4, 0, 3))  # fewer than three vertices: no edge
        self.claim("I5", TET_POINTS, [(0, 3, 0)], (5, 0, 3))

    def test_i6(self):
        p, t = solids.copy_at_vertex(TET_POINTS, TET, self.rng)
        self.claim("ACCEPT", p, t, (6, 1), as_indexed=False)
        self.claim("I6", p, t, (6, 0), as_indexed=False)
        self.claim("I6", p, t, (6, 1))
        self.claim("I6", TET_POINTS + [(7, 7, 7)], TET, (6, 4))
        p = TET_POINTS + [(0, 0, 2), (0, 0, 3), (0, 1, 3), (0, 5, 5)]
        fans = [(0, 1, 2), (0, 3, 4), (0, 5, 6)]
        self.claim("ACCEPT", p, fans + [(0, 2, 3)], (6, 0))
        self.claim("ACCEPT", p, fans + [(0, 4, 5)], (6, 0))
        self.claim("I6", p, fans + [(0, 2, 3), (0, 5, 1)], (6, 0))
        self.claim("I6", p, fans + [(0, 2, 6), (0, 4, 5)], (6, 0))
        self.claim("ACCEPT", p, fans + [(0, 2, 6), (0, 4, 7)], (6, 0))

    def test_i7(self):
        p = [(0, 0, 0), (4, 0, 0), (0, 4, 0), (1, 1, -1), (1, 1, 1), (9, 9, 1), (0, 0, 0)]
        t = [(0, 1, 2), (3, 4, 5), (0, 5, 4), (0, 1, 5), (6, 5, 4), (0, 0, 1)]
        self.claim("ACCEPT", p, t, (7, 0, 1, (2, 1, 1), (1, 1, 0)))
        self.claim("ACCEPT", p, t, (7, 1, 0, (1, 1, 0), (2, 1, 1)))
        self.claim("ACCEPT", p, t, (7, 1, 0, (2 ** 80, 2 ** 80, 0), (6, 3, 3)))
        self.claim("I7", p, t, (7, 0, 1, (2, 1, 1), (1, 1, 1)))
        self.claim("I7", p, t, (7, 0, 1, (0, 0, 0), (1, 1, 0)))
        self.claim("I7", p, t, (7, 0, 1, (2, 1, 1), (0, 0, 0)))
        self.claim("I7", p, t, (7, 0, 0, (2, 1, 1), (2, 1, 1)))
        self.claim("I7", p, t, (7, 0, 2, (1, 0, 0), (1, 0, 0)))
        self.claim("I7", p, t, (7, 0, 3, (1, 2, 0), (1, 2, 0)))
        self.claim("ACCEPT", p, t, (7, 0, 4, (1, 0, 0), (1, 0, 0)))     # the same position, another vertex
        self.claim("I7", p, t, (7, 0, 5, (1, 0, 0), (0, 1, 0)))
        self.claim("I7", p, t, (7, 5, 3, (1, 0, 0), (1, 0, 0)))
        self.claim("I7", p, t, (7, 5, 1, (1, 0, 0), (1, 0, 0)))
        great = 256 ** 4095                               # of 4096 bytes
        self.claim("ACCEPT", p, t, (7, 1, 0, (great, great, 0), (2 * great, great, great)))
        self.claim("B1", p, t, (7, 1, 0, (256 * great, 256 * great, 0), (2 * great, great, great)))
        p = [(0, 0, 0), (2, 0, 0), (4, 0, 0), (2, -1, -1), (2, 1, -1), (2, 0, 2)]
        t = [(0, 1, 2), (3, 4, 5)]                        # (0, 1, 2) has no area
        self.claim("I7", p, t, (7, 0, 1, (1, 0, 1), (1, 1, 1)))
        self.claim("I7", p, t, (7, 1, 0, (1, 1, 1), (1, 0, 1)))
        self.claim("ACCEPT", p[:2] + [(4, 0, 1)] + p[3:], t, (7, 0, 1, (0, 1, 0), (1, 1, 1)))

    def test_i8_i9(self):
        for rule in (8, 9):
            self.claim("I%d" % rule, TET_POINTS, TET, (rule, 2, 0))
            self.claim("I%d" % rule, TET_POINTS, TET, (rule, 0, 0))
            self.claim("ACCEPT", TET_POINTS, solids.reverse(TET), (rule, 0, 2))
            self.claim("ACCEPT", TET_POINTS, solids.reverse(TET), (rule, 2, 1))
            self.claim("I%d" % rule, TET_POINTS, solids.reverse(TET), (rule, 0, 1))
        outer, inner = solids.box_of(3), solids.box_of(1)
        for f in range(24):
            for u in range(3):
                p, t = solids.join(outer, inner)
                self.use(forge.Model(p, t))
                good = bool(forge.stab_sum(self.mesh, f, u))
                self.claim("ACCEPT" if good else "I8", p, t, (8, f, u))
                self.assertEqual(good, f >= 12 and self.mesh.n[f][u] != 0)

    def test_i8_a_triangle_through_the_point_proves_nothing(self):
        p = TET_POINTS + [(-1, -1, 1), (3, -1, -1), (-1, 3, -1)]            # through P of (0, 1, 2)
        a, b, c = (0, 0, 0), (4, 0, 0), (0, 4, 0)
        p = [a, b, c, (0, 1, 1), (2, 1, -1), (0, 3, -2)]
        self.use(forge.Model(p, [(0, 1, 2), (3, 4, 5)]))
        self.assertIsNone(forge.stab_sum(self.mesh, 0, 2))
        self.claim("I8", p, [(0, 1, 2), (3, 4, 5)], (8, 0, 2))
        p += [(0, 0, 5), (4, 0, 5), (0, 4, 5)]
        self.claim("I8", p, [(0, 1, 2), (3, 4, 5), (6, 7, 8)], (8, 0, 2))
        self.claim("ACCEPT", p, [(0, 1, 2), (6, 7, 8)], (8, 0, 2))
        self.claim("ACCEPT", p, [(0, 1, 2), (6, 8, 7)], (8, 0, 2))
        self.claim("I8", p, [(0, 1, 2), (6, 8, 7), (6, 7, 8)], (8, 0, 2))

    def test_a_line_stabs_a_triangle_of_the_least_area(self):
        for axis in range(3):
            def at(p, q):
                return tuple((0, p, q)[(k - axis) % 3] for k in range(3))
            square = [at(0, 0), at(1, 0), at(1, 1), at(0, 1)]
            for turn in range(3):
                for triangle, hit in (((0, 1, 2), True), ((0, 2, 3), False)):  # moved by (e, e^2) the corner (0, 0) is in the first
                    t = [square[triangle[(i + turn) % 3]] for i in range(3)]
                    self.assertEqual(mesh_model.line_stabs(t, at(0, 0), axis), hit)
                    self.assertEqual(mesh_model.line_stabs(t[::-1], at(0, 0), axis), hit)

    def test_i8_the_ray_is_moved_off_edges_and_vertices(self):
        base = [(0, 0, 0), (4, 0, 0), (0, 4, 0)]           # P = (1, 1, 0), moved by (e, e^2) in (x, y)
        for triangle, hit in ((((1, 0, 5), (9, 0, 5), (1, 9, 5)), True), (((1, 0, 5), (-9, 0, 5), (1, 9, 5)), False),
                              (((0, 1, 5), (9, 1, 5), (1, 9, 5)), True), (((0, 1, 5), (9, 1, 5), (1, -9, 5)), False),
                              (((1, 1, 5), (9, 0, 5), (9, 9, 5)), True), (((1, 1, 5), (9, 1, 5), (9, 9, 5)), True),
                              (((1, 1, 5), (9, 1, 5), (9, -9, 5)), False), (((1, 1, 5), (1, 9, 5), (9, 9, 5)), False),
                              (((1, 1, 5), (1, 9, 5), (9, 2, 5)), False), (((1, 1, 5), (0, 9, 5), (9, 1, 5)), True),
                              (((0, 0, 5), (2, 2, 5), (2, 0, 5)), True), (((0, 0, 5), (2, 2, 5), (0, 2, 5)), False),
                              (((0, 0, -5), (9, 0, -5), (0, 9, -5)), False), (((1, 0, 5), (1, 9, 5), (1, 0, 9)), False)):
            for turn in range(3):
                p = base + list(triangle[turn:] + triangle[:turn])
                p = [tuple(c[(k - turn) % 3] for k in range(3)) for c in p]        # axis z becomes axis (2 + turn)
                self.claim("ACCEPT" if hit else "I8", p, [(0, 1, 2), (3, 4, 5)], (8, 0, (2 + turn) % 3))
                self.claim("ACCEPT" if hit else "I8", p, [(0, 1, 2), (4, 3, 5)], (8, 0, (2 + turn) % 3))

    def test_i10(self):
        tris = [(0, 1, 2)] + TET[1:]
        for rules in (["M3"], ["M5", "M7"], ["M3", "M5"]):
            self.claim("I10", TET_POINTS, tris, (5, 0, 1), rules=rules)
        self.claim("I10", TET_POINTS, TET[1:], (3, 0, 1), (3, 1, 2), rules=["M3", "M7"])
        self.claim("ACCEPT", TET_POINTS, TET[1:], (3, 0, 1), (3, 1, 2), rules=["M3"])


class CommandLineTest(unittest.TestCase):
    def run_it(self, *args):
        r = subprocess.run([sys.executable, PROGRAM] + list(args), capture_output=True, text=True)
        return r.returncode, r.stdout.strip()

    def test_exit_codes(self):
        self.assertEqual(self.run_it()[0], 2)
        self.assertEqual(self.run_it("a")[0], 2)
        self.assertEqual(self.run_it("--skip", "V9")[0], 2)
        self.assertEqual(self.run_it("a", "b", "c")[0], 2)
        self.assertEqual(self.run_it("--help")[0], 0)
        self.assertEqual(self.run_it("--version"), (0, vc.VERSION))
        self.assertEqual(self.run_it("no-such-file", "no-such-file")[0], 4)
        with tempfile.NamedTemporaryFile() as hole:       # more than any memory
            hole.truncate(1 << 42)
            self.assertEqual(self.run_it(hole.name, hole.name)[0], 3)
        model = forge.Model(TET_POINTS, TET)
        data = model.encode()
        cert = forge.Plan(forge.mesh_of(model), random.Random(1)).certificate(data, model)
        with tempfile.TemporaryDirectory() as d:
            m, c = pathlib.Path(d) / "m.off", pathlib.Path(d) / "c"
            m.write_bytes(data)
            c.write_bytes(cert)
            self.assertEqual(self.run_it(str(m), str(c)), (0, "ACCEPT mesh-valid-1"))
            self.assertEqual(self.run_it(str(m), str(m))[0], 1)
            with open("/dev/full", "w", encoding="ascii") as full:            # an answer that is not printed is none
                r = subprocess.run([sys.executable, "-E", PROGRAM, str(m), str(c)], stdout=full, stderr=full)  # buffered: -E
                self.assertEqual(r.returncode, 4)
            c.write_bytes(cert + b"x")
            code, out = self.run_it(str(m), str(c))
            self.assertEqual((code, out[:10]), (1, "REJECT S4:"))


if __name__ == "__main__":
    unittest.main()
