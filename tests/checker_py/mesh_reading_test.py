#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Tests of docs/certificates/reading-rule-1.md: what a file means is what a certificate about it has to say, and what the rule refuses
ends with exit 4. Here the Python checker answers; tests/checker/mesh_reading_test.py asks both."""
import math
import os
import pathlib
import random
import struct
import sys
import unittest
import unittest.mock
from fractions import Fraction

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "mutation"))
import attacks                                            # noqa: E402

vc = attacks.load_checker(os.environ.get("VERITOPE_CHECK_PY") or attacks.CHECKER_PY)    # a mutant sets it
import forge                                              # noqa: E402
import mesh_models as models                              # noqa: E402
from veritope_checker.common.errors import Refused        # noqa: E402
from veritope_checker.mesh import mesh_reader as reader   # noqa: E402

T3 = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)]
INF = float("inf")
FACES = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"            # of a tetrahedron in an OBJ file


def binary(text):
    return text if isinstance(text, bytes) else text.encode("latin-1")


def read(text, fmt, as_indexed=False):
    return reader.read_model(binary(text), fmt, as_indexed)


def boundary(data, fmt, as_indexed, points, tris):
    """A certificate that holds if the file has these triangles: a witness of each rule that they break, and of each edge that is open."""
    mesh = forge.Mesh(points, tris)
    witnesses = [w for w in forge.true_witnesses(forge.Truth(mesh), random.Random(1)).values() if w[0] < 8]
    witnesses += [(3, *edge) for edge, faces in forge.edge_uses(mesh).items() if len(faces) == 1 and edge[::-1] not in forge.edge_uses(mesh)]
    return forge.invalid_certificate(data, models.File(data, fmt, as_indexed), mesh, sorted(witnesses, key=lambda w: w[0]))


def any_certificate(data, fmt):
    return boundary(data, fmt, False, T3, [(0, 1, 2)])


class Reading(unittest.TestCase):
    def yields(self, text, fmt, points, tris, as_indexed=False):
        found_points, found_tris = read(text, fmt, as_indexed)
        self.assertEqual((found_points, found_tris), (points, tris), text)
        self.assertEqual([repr(c) for p in found_points for c in p], [repr(c) for p in points for c in p], text)
        self.assertEqual(vc.check(binary(text), boundary(binary(text), fmt, as_indexed, points, tris)), (0, "ACCEPT mesh-invalid-1"), text)

    def refused(self, fmt, *texts):
        for text in map(binary, texts):
            code, line = vc.check(text, any_certificate(text, fmt))
            self.assertEqual(code, 4, (text[:200], line))

    def bends(self, fmt, text, *changes):
        """The text is refused after each of the changes (old, new) of one place."""
        for old, new in changes:
            self.assertIn(old, text)
            self.refused(fmt, text.replace(old, new, 1))

    def solid(self, text, fmt, volume="1/6"):
        """The file is a solid of this volume."""
        model = models.File(binary(text), fmt)
        plan = forge.Plan(forge.mesh_of(model), random.Random(3), 1)
        self.assertEqual(plan.quantities()["volume"], volume, text)
        self.assertEqual(vc.check(model.data, plan.certificate(model.data, model)), (0, "ACCEPT mesh-valid-1"), text)


class Common(Reading):
    def width(self, token, value):
        """A tetrahedron as wide as the number, so that its volume is a sixth of it."""
        v = "v 0 0 0\nv %s 0 0\nv 0 1 0\nv 0 0 1\n" if value else "v %s 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
        volume = Fraction(value or 1) / 6
        self.solid(v % token + FACES, "obj", "%d/%d" % (volume.numerator, volume.denominator))

    def test_decimals_follow_the_grammar_and_round_to_nearest(self):
        for token, value in (("1", 1.0), ("+1", 1.0), (".5", .5), ("+.5e+1", 5.0), ("5.E0", 5.0), ("1e3", 1000.0), ("1E+3", 1000.0),
                             ("1.5e-3", .0015), ("0", 0.0), ("-0", 0.0), ("1e-400", 0.0), ("4.9e-324", 5e-324), ("1e-326", 0.0),
                             ("-2e-324", 0.0), ("1e-99999", 0.0), ("0e99999", 0.0), ("8.5e-324", 1e-323), ("3e-324", 5e-324),
                             ("2.4703282292062327e-324", 0.0), ("2.4703282292062328e-324", 5e-324), ("1.5e-323", 1.5e-323),
                             ("1.7976931348623157e308", 1.7976931348623157e308), ("9007199254740993", 9007199254740992.0),
                             ("179769313486231570e291", 1.7976931348623157e308), ("0." + "0" * 5000 + "1e5001", 1.0),
                             ("1" + "0" * 300, 1e300), ("1" + "0" * 400 + "e-400", 1.0), ("0" * 400 + "3", 3.0),
                             ("0e99999999999999999999", 0.0), ("9007199254740992." + "0" * 5000 + "1", 9007199254740992.0),
                             ("9007199254740993." + "0" * 5000 + "1", 9007199254740994.0), ("9007199254740995", 9007199254740996.0),
                             ("1." + "0" * 900 + "1", 1.0), ("1." + "3" * 900, 4 / 3), ("0.1", 0.1), ("1e23", 1e23),
                             ("2.2250738585072011e-308", 2.225073858507201e-308), ("2.2250738585072012e-308", 2.2250738585072014e-308),
                             ("0.5000000000000000277555756156289135105907917022705078125", .5),
                             ("0.500000000000000083266726846886740531772375106811523437499", .5 + 2 ** -53),
                             ("1234567890123456789012345", 1.2345678901234568e24)):
            self.width(token, value)
        self.assertEqual(read("v -1. 0 0\nv 1 0 7\nv 0 1 7\nf 1 2 3", "obj", True)[0][0][0], -1.0)
        for token in ("", ".", "+", "1e", "1e+", "e5", "nan", "inf", "Infinity", "0x10", "1,5", "1_0", "1e400", "-1e400", "1e309",
                      "1.7976931348623159e308", "1d5", "--1", "1.2.3", "\xb2", "1f", "1e5.0", "0x1", "x", "0\x001",
                      "1e5x", "1e5/", "1e-5.", "1e:", "1e-/"):
            self.refused("off", "OFF 3 1 0\n%s 0 0\n1 0 0\n0 1 0\n3 0 1 2" % (token or "# "))
            self.refused("obj", "v 0 0 %s\nv 1 0 0\nv 0 1 0\nv 2 2 2\nf 2 3 4" % token)

    def test_random_decimals_round_to_nearest(self):
        rng = random.Random(7)
        for _ in range(40):
            digits = str(rng.getrandbits(rng.randrange(1, 200)))
            token = "%s.%se%d" % (digits, rng.getrandbits(60) or 1, rng.randrange(-340, 200))
            if 0 < float(token) < INF:
                self.width(token, float(token))

    def test_integers_follow_the_grammar(self):
        self.assertEqual(len(read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf +1 02 %s3" % ("0" * 5000), "obj")[1]), 1)
        self.refused("obj", *["v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 %s" % i for i in
                              ("3.0", "0x3", "3e0", "4", "-4", "0", "-0", "1" * 5000, "-" + "1" * 5000, "+", "/3", "3_0", "3x", "-", "#3",
                               "4294967299", "-4294967293", "18446744073709551619", "77", "9" * 23)])

    def test_equal_positions_are_one_vertex_unless_as_indexed(self):
        text = "OFF 5 1 0\n0 0 0\n0 -0 0\n1 0 0\n-0 -0.0 0\n0 1 0\n3 3 2 4"
        self.yields(text, "off", [T3[0], T3[1], T3[2]], [(0, 1, 2)])
        self.yields(text, "off", [T3[0], T3[0], T3[1], T3[0], T3[2]], [(3, 2, 4)], True)

    def test_polygons_are_fans_and_unreferenced_vertices_keep_their_ids(self):
        self.yields("OFF 6 1\n9 9 9\n0 0 0\n1 0 0\n1 1 0\n0 2 0\n-1 1 0\n5 1 2 3 4 5", "off",
                    [(9.0, 9.0, 9.0), T3[0], T3[1], (1.0, 1.0, 0.0), (0.0, 2.0, 0.0), (-1.0, 1.0, 0.0)],
                    [(1, 2, 3), (1, 3, 4), (1, 4, 5)])

    def test_refused_whatever_the_format(self):
        foreign = [b"\xff\xfe", b"\xfe\xff", b"\0\0\xfe\xff", b"\xff\xfe\0\0", b"\x1f\x8b\x08", b"PK\x03\x04", b"PK\x05\x06", b"BZh9",
                   b"\xfd7zXZ\0", b"\x28\xb5\x2f\xfd", b"version https://git-lfs.github.com/spec/v1\n"]
        for fmt in forge.FORMATS:
            self.refused(fmt, b"", b"\xef\xbb\xbf", b"\xff\xfeO\0F\0", *foreign)
        for fmt, write in models.WRITERS.values():
            self.refused(fmt, *[start + write(models.TET) for start in foreign])

    def test_truncated_files(self):
        for name, (fmt, write) in models.WRITERS.items():
            good = write(models.TET)
            if name in ("stl binary, more", "stl binary, solid"):
                continue
            binary_file = "binary" in name or "little" in name or "big" in name
            # The last token of a text may lose characters and still be one; an OBJ file does not say how long it is.
            last = len(good.rstrip()) - (1 if binary_file else 4) if fmt != "obj" else good.index(b"f 1")
            self.refused(fmt, *[good[:n] for n in range(0, last, 3 if binary_file else 7)])

    def test_every_spelling_of_a_solid(self):
        v, off_v, off_f = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n", "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"
        head = ("ply\nformat ascii 1.0\nobj_info x\nelement junk 2\nproperty list char float a\nproperty int b\nelement vertex 4\n"
                "property uchar q\nproperty short z\nproperty int8 x\nproperty double y\nproperty list uchar float w\n")
        body = "2 nan x 5\n0 ?\n\n9 0 0 0 0 # 0 1 0 1 nan\n1 0 0 1 2 3\t3\n0 1\n0 0 0\n"
        for fmt, text in (
                ("obj", v + "f -4 -2 -3\nf 1 2 4\nfo 1 4 3\nf 2 3 4\n"), ("obj", "f 1/1 3//2 2/1/1\nf 1 2 4 # 3\nf 1 4 3\nf 2 3 4\n" + v),
                ("obj", "\xef\xbb\xbf" + v + "vn 1\nf 1 3\\\n 2\nf 1 2 \\\r\n4\n#\\\nf 1 2 3\nf 1 4 3\nf 2 3 4"),
                ("obj", v.replace(" ", "\t \v\f").replace("0 1\n", "0 1 7 7 7\n") + "g x\ns f\nl 1 2\n" + FACES),
                ("obj", "v 0 0 0\nv -0 0 -0.0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 2 4 3\nf 1 3 5\nf 2 5 4\nf 3 4 5\n"),
                ("off", "# c\nSTCNOFF# x\n\n4 4# 6\n#\n0 0 0 9 9\n\n1 0 0 # c\n0 1 0\r0 0 1\n3 0 2 1 255 0 0\n3 0 1 3\n3 0 3 2\n3 1 2 3\ntrailing"),
                ("off", "OFF 4 4 6 0 0 0\n" + off_v + off_f.replace("1 2 3", "+1 2 3")), ("off", "COFF\n4\n4\n" + off_v + off_f),
                ("off", "NOFF 4\n4 x\n" + off_v + off_f), ("off", "\xef\xbb\xbfSTOFF 4\r\n4 x\n" + off_v + off_f),
                ("ply", head + "element face 4\nproperty list char int vertex_index\nproperty float r\nend_header\n" + body +
                 "3 0 2 1 x\n3 0 1 3 0\n3 0 3 2 0\n3 1 2 3 0 junk"),
                ("ply", head + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" + body + "14 0 0 1 2 -1 0 1 3 2 -1 0 0 2 3\n"),
                ("stl", "\n solid\n" + models.stl_text(models.TET).decode().split("\n", 1)[1].upper()),
                ("stl", "\xef\xbb\xbf" + models.stl_text(models.TET).decode().replace("normal 0 0 0", "FACET\n1 \r"))):
            with self.subTest(text=text):
                self.solid(text, fmt)
        blocks = models.stl_text(models.TET) + b"\n\n" + models.stl_text(models.move(models.TET, (5, 5, 5)), name="solid facet 2")
        self.solid(blocks, "stl", "1/3")

    def test_every_line_end_and_blank_and_a_byte_order_mark(self):
        for end in ("\n", "\r", "\r\n"):
            for blank in (" ", "\t", "\x0b", "\x0c", " \t "):
                self.yields("\xef\xbb\xbf" + end.join(["OFF", "3 1 0", "0 0 0", "", "1 0 0", "0 1 0", "3 0 1 2"]).replace(" ", blank),
                            "off", T3, [(0, 1, 2)])


class Stl(Reading):
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

    def test_what_no_stl_is(self):
        good = models.stl_text(models.TET)
        self.bends("stl", good, (b"endloop", b""), (b"endloop", b"vertex 1 1 1 endloop"), (b"loop", b"lop"), (b"endfacet", b"endfacets"),
                   (b"outer", b"outer outer"), (b"vertex", b"vertx"), (b"endsolid", b""), (b"endsolid", b"endsolid\nstray"),
                   (b"facet", b"facette"), (b"endsolid", b"endsolid\nendsolid"), (b"0.0 1.0", b"0.0 nan"), (b"0.0 1.0", b"0.0"),
                   (b"0.0 1.0", b"0.0 inf"), (b"solid", b"solids"))
        self.refused("stl", "solid x\nendsolid x\n", "solid x")
        data = models.stl_binary(models.TET)
        self.refused("stl", *[data[:80] + struct.pack("<I", n) + data[84:] for n in (0, 5, 2 ** 31, 2 ** 32 - 1)])
        self.refused("stl", *[data[:96] + struct.pack("<I", n) + data[100:] for n in (0x7f800000, 0xff800000, 0x7fc00000, 0x7f800001)])

    def test_ascii_refusals(self):
        good = "solid x\n" + self.FACET_TEXT + "endsolid x\n"
        self.refused("stl", "solid\nendsolid", "solid x", "solid", good[:-12], good + "facet", good + "x", good + "endsolid",
                     good.replace("endloop ", ""), good.replace("endfacet", "vertex"), good.replace("loop", "lop", 1),
                     good.replace("vertex 0 1 0", ""), good.replace("0 1 0", "0 1 0 vertex 0 0 5"), good.replace("0 1 0", "0 1"),
                     good.replace("0 1 0", "0 1 nan"), good.replace("outer", "inner"), good.replace("outer loop", "outer outer loop"),
                     "solid x " + self.FACET_TEXT + "endsolid", good.replace("endsolid x", ""), "facet" + good,
                     good.replace("0 1 0", "0 1 0 0"))


class Obj(Reading):
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
                     self.V + "f 1 2 x", self.V + "f 1 2 3\\", self.V + "f 1 2 #3", self.V + "f 1,2 2 3",
                     "v 0 0\nf 1 1 1", self.V + "f 1 2\n3", "#" + self.V.replace("\n", "\\\n"), "f -1 -2 -3\n" + self.V)


class Off(Reading):
    BODY = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2"

    def test_headers(self):
        for word in ("OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCOFF", "STNOFF", "STCNOFF"):
            self.yields("%s\n3 1 0\n%s" % (word, self.BODY), "off", T3, [(0, 1, 2)])
        for head in ("OFF 3 1 0", "OFF\n\n3\n1", "#c\nOFF#c\n 3 #c\n#\n1 0 0 junk", "OFF 3 1 x y z # z", "OFF +3 01"):
            self.yields(head + "\n" + self.BODY, "off", T3, [(0, 1, 2)])
        self.refused("off", *[h + "\n" + self.BODY for h in
                              ("", "off 3 1 0", "4OFF 3 1 0", "nOFF 3 3 1 0", "OFF BINARY 3 1 0", "NCOFF 3 1 0", "CSTOFF 3 1", "OFF 3",
                               "OFF 3.0 1", "OFF -3 1", "OOFF 3 1", "OFFX 3 1", "OFF\n3 1 0 0 0 0\n1 0 0\n0 1 0", "OFF 3 -1", "OFF 4 1", "OFF 3 2", "OFF 3 0", "OFF 99999999999999999999 1", "OFF 4000000000 1", "OFF 3 4000000000", "3 1 0")])

    def test_a_header_alone_is_refused(self):
        self.refused("off", "OFF", "OFF 3", "OFF 3 1", "OFF 0 0", "OFF 3 1\n0 0 0\n1 0 0")

    def test_rows(self):
        self.yields("OFF 3 1 0\n0 0 0 9 x # z\n\n # only a comment\n1 0 0\n 0 1 0\n3 0 1 2 255 x\nanything", "off", T3, [(0, 1, 2)])
        for old, new in (("3 0 1 2", "3 0 1"), ("3 0 1 2", "3 0 1 3"), ("3 0 1 2", "3 0 1 -1"), ("3 0 1 2", "2 0 1"), ("3 0 1 2", "x 0 1 2"),
                         ("3 0 1 2", "3 0 1 2.0"), ("3 0 1 2", "4 0 1 2"), ("0 1 0", "0 1"), ("0 1 0", "0 1 #0"), ("3 0 1 2", "3 0 1\n2"),
                         ("3 0 1 2", "1" * 5000 + " 0 1 2"), ("0 1 0", "0 1 nan"), ("3 0 1 2", "0"), ("3 0 1 2", "-3 0 1 2"), ("3 0 1 2", "-2 0 1 2 0"),
                         ("1 0 0", "1 0"), ("3 0 1 2", "4000000000 0 1 2")):
            self.refused("off", ("OFF 3 1 0\n" + self.BODY).replace(old, new))


class Ply(Reading):
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
        self.refused("ply", *[head + body + s for s in ("2 0 1", "0", "3 -1 -1 -1", "3 0 1 4", "3 0 1 -2", "3 0 0 9", "4 0 1 2 9", "3 0 1", "3 0 1 2.0", "3 0 1 -1", "3 0 0 1", "4 0 1 2 4", "4 0 1 2 -2", "2 0 9",
                                                            "-1", "7 0 1 -1 1 2 -1 3")])
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

    def test_what_no_ply_is(self):
        huge = b"element face 4000000000\n"
        self.bends("ply", models.ply(models.TET), (b"ply", b"PLY"), (b"ply", b" ply"), (b"ply", b"ply "), (b"ply", b"\nply"),
                   (b"format ascii 1.0", b"format ASCII 1.0"), (b"format ascii 1.0", b"version ascii 1.0"), (b"1.0\n", b"1.0\r\n"),
                   (b"1.0\n", b"1.0\nformat ascii 1.0\n"), (b"element vertex 4", b"element vertex 4 4"), (b"element vertex 4", b"element point 4"), (b"element vertex 4", b"element vertex 5"),
                   (b"element face 4\n", huge), (b"element face 4\n", b"element face 999999999999999999999999\n"),
                   (b"element face", b"element faces"), (b"property float x", b"property float"),
                   (b"property float x", b"property float x\nproperty float x"), (b"list uchar int", b"list uchar long"),
                   (b"vertex_indices", b"vertex_indices x"), (b"end_header", b"end_headers"),
                   (b"vertex_indices\n", b"vertex_indices\nproperty list uchar int vertex_index\n"),
                   (b"end_header", b"element face 0\nproperty list uchar int vertex_index\nend_header"),
                   (b"end_header", b"element vertex 0\nend_header"), (b"comment x", b"property int q"), (b"3 1 2 3", b"3 1 2 -1"),
                   (b"3 1 2 3", b"2 1 2"), (b"3 1 2 3", b"3.0 1 2 3"), (b"3 1 2 3", b"3 1 2 3.0"), (b"3 1 2 3", b"-3 1 2 3"),
                   (b"3 1 2 3", b"4000000000 1 2 3"), (b"3 1 2 3", b"3 1 2 4"), (b"0.0 1.0", b"0.0 nan"), (b"0.0 1.0", b"0.0 1e999"),
                   (b"comment x", b"element list of four words"), (b"comment x", b"property set of four words"),
                   (b"comment x", b"scalar float q"), (b"float x", b"list uchar char q"), (b"end_header", b"element tristrips 0\nend_header"),
                   (b"end_header", b"element tristrips 0\nproperty int q\nend_header"),
                   (b"end_header", b"element tristrips 0\nproperty list int int vertex_indices\nproperty list int int vertex_index\nend_header"),
                   (b"comment x", b"comment x\r"), (b"comment x", b"comment\rx"))
        self.refused("ply", b"ply\nformat ascii 1.0\nelement nothing 1000000000000\nend_header\n")

    def test_binary_values_that_are_refused(self):
        for kind, real in (("little", 4), ("big", 8)):
            data = models.WRITERS["ply " + kind][1](models.TET)
            at = data.index(b"end_header\n") + 11
            for bits in (b"\xff" * real, b"\x00\x00\xc0\x7f" if real == 4 else b"\x7f\xf0" + b"\0" * 6):
                self.refused("ply", data[:at] + bits + data[at + real:])
            face = at + 12 * real
            self.refused("ply", data[:face] + b"\x02" + data[face + 1:], data[:face] + b"\xff" + data[face + 1:])
        data = models.WRITERS["ply little"][1](models.TET)
        self.refused("ply", data.replace(b"list uchar", b"list char").replace(b"\x03\0\0\0\0", b"\xfd\0\0\0\0"))
        self.refused("ply", *[data[:-4] + struct.pack("<i", index) for index in (4, -1, -2, 2 ** 31 - 1)])
        self.solid(data.replace(b"element face", b"element nothing 1000000000000000000\nelement face"), "ply")    # no properties, so no bytes

    def test_integer_coordinates(self):
        for kind in ("binary_little_endian", "binary_big_endian"):
            for real in ("int", "short", "char", "uint", "ushort", "uchar"):
                self.solid(models.ply(models.TET, kind, real=real), "ply")


class Limits(unittest.TestCase):
    """What the page limits, far below its limits: only a program that runs in this process can be asked."""

    def test_limits_of_the_page(self):
        self.assertEqual((reader.MAX_TRIANGLES, reader.MAX_VERTICES), (2 ** 30, 2 ** 32 - 1))
        for name, least in (("MAX_TRIANGLES", 1), ("MAX_VERTICES", 4)):
            with unittest.mock.patch.object(reader, name, least):
                read("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2", "off")
            with unittest.mock.patch.object(reader, name, least - 1):
                with self.assertRaises(Refused):
                    read("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2", "off")


if __name__ == "__main__":
    unittest.main()
