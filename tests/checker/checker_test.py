#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Tests of veritope-check: it accepts true certificates and rejects each kind of lie by name.

VERITOPE_CHECK names the program; without it, the program is built by g++ -std=c++11 in a folder
that holds only its own files. VERITOPE_DATA, or ../shared/data beside the checkout, may hold real
models (mesh/MANIFEST.tsv).
"""
import glob
import json
import os
import random
import resource
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path.insert(0, HERE)
import reference_prover as rp  # noqa: E402

DATA = os.environ.get("VERITOPE_DATA", os.path.join(os.path.dirname(ROOT), "shared", "data"))
FOLDER = tempfile.TemporaryDirectory()
CHECK = os.environ.get("VERITOPE_CHECK")


def setUpModule():
    global CHECK
    if CHECK:
        return
    alone = os.path.join(FOLDER.name, "alone")
    shutil.copytree(os.path.join(ROOT, "verify", "checker"), alone)
    sources = glob.glob(os.path.join(alone, "**", "*.cc"), recursive=True)
    subprocess.run(["g++", "-std=c++11", "-O2", "-o", "veritope-check"] + sources, cwd=alone,
                   check=True)
    CHECK = os.path.join(alone, "veritope-check")


def tearDownModule():
    FOLDER.cleanup()
    most = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    assert most < 700 * 1024, "a run took %d KiB: a count that lies was believed" % most


def check_files(*args):
    r = subprocess.run([CHECK] + list(args), capture_output=True, timeout=120, check=False)
    return r.returncode, r.stdout.decode(), r.stderr.decode()


def check(model, certificate):
    """Runs the checker on bytes."""
    m, c = (os.path.join(FOLDER.name, n) for n in ("model", "certificate"))
    for path, data in ((m, model), (c, certificate)):
        with open(path, "wb") as file:
            file.write(data)
    return check_files(m, c)


# ---- Shapes ----------------------------------------------------------------------------------

TET = ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)],
       [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])


def voxels(cells):
    """The boundary of a set of unit cubes as quadrilaterals."""
    ids, polygons = {}, []
    for c in sorted(cells):
        for k in range(3):
            for side in (0, 1):
                n = list(c)
                n[k] += 2 * side - 1
                if tuple(n) in cells:
                    continue
                quad = []
                for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    p = list(c)
                    p[k] += side
                    p[(k + 1) % 3] += a
                    p[(k + 2) % 3] += b
                    quad.append(ids.setdefault(tuple(p), len(ids)))
                polygons.append(tuple(quad if side else quad[::-1]))
    return list(ids), polygons


def triangles(mesh):
    return mesh[0], [t for f in mesh[1] for t in rp.fan(f)]


def moved(mesh, by, scale=1):
    return [tuple(scale * c + d for c, d in zip(p, by)) for p in mesh[0]], mesh[1]


def turned(mesh):
    """Inside out."""
    return mesh[0], [f[::-1] for f in mesh[1]]


def joined(*meshes):
    points, faces = [], []
    for p, f in meshes:
        faces += [tuple(len(points) + v for v in t) for t in f]
        points += p
    return points, faces


CUBE = voxels({(0, 0, 0)})
RING = voxels({(x, y, 0) for x in range(3) for y in range(3)} - {(1, 1, 0)})
ELL = voxels({(0, 0, 0), (1, 0, 0), (0, 1, 0)})
SHELL = joined(moved(CUBE, (-1, -1, -1), 3), turned(CUBE))
ONION = joined(SHELL, moved(CUBE, (0.25, 0.25, 0.25), 0.5))
TWO = joined(TET, moved(TET, (3, 0.25, 0.5)))
# Long thin facets whose boxes overlap: leaf pairs that need codes.
STAR = triangles(joined(moved(CUBE, (0, 0, 0), 1)))
TWIST = ([(0, 0, 0), (8, 0, 0), (0, 8, 0), (9, 9, 40), (1, 9, 41), (9, 1, 42)],
         [(0, 2, 1), (3, 4, 5), (0, 1, 5), (1, 3, 5), (1, 2, 3), (2, 4, 3), (2, 0, 4), (0, 5, 4)])
SOLIDS = {  # name: mesh, shells, bodies, genus, volume
    "tetrahedron": (TET, 1, 1, 0, "1/6"), "cube": (CUBE, 1, 1, 0, "1/1"),
    "torus": (RING, 1, 1, 1, "8/1"), "ell": (ELL, 1, 1, 0, "3/1"),
    "nested": (SHELL, 2, 1, 0, "26/1"), "onion": (ONION, 3, 2, 0, "209/8"),
    "two bodies": (TWO, 2, 2, 0, "1/3")}


def number(c):
    return repr(float(c))


def off(mesh, end="\n"):
    lines = ["OFF", "%d %d 0" % (len(mesh[0]), len(mesh[1]))]
    lines += [" ".join(map(number, p)) for p in mesh[0]]
    lines += [" ".join(map(str, (len(f),) + tuple(f))) for f in mesh[1]]
    return (end.join(lines) + end).encode()


def obj(mesh, end="\n", corner="%d"):
    lines = ["# comment"] + ["v " + " ".join(map(number, p)) for p in mesh[0]]
    lines += ["f " + " ".join(corner % (v + 1) for v in f) for f in mesh[1]]
    return (end.join(lines) + end).encode()


def ply(mesh, kind="ascii", end="\n", real="float", index="int"):
    head = ["ply", "format %s 1.0" % kind, "comment x", "element vertex %d" % len(mesh[0])]
    head += ["property %s %s" % (real, c) for c in "xyz"]
    head += ["element face %d" % len(mesh[1]), "property list uchar %s vertex_indices" % index]
    data = (end.join(head + ["end_header"]) + end).encode()
    if kind == "ascii":
        lines = [" ".join(map(number, p)) for p in mesh[0]]
        lines += [" ".join(map(str, (len(f),) + tuple(f))) for f in mesh[1]]
        return data + (end.join(lines) + end).encode()
    order = "<" if "little" in kind else ">"
    for p in mesh[0]:
        data += struct.pack(order + "3" + rp.PLY_TYPES[real], *p)
    for f in mesh[1]:
        data += struct.pack("%sB%d%s" % (order, len(f), rp.PLY_TYPES[index]), len(f), *f)
    return data


def stl_binary(mesh, header=b"header"):
    points, faces = triangles(mesh)
    data = header.ljust(80) + struct.pack("<I", len(faces))
    for f in faces:
        data += struct.pack("<12fH", 0, 0, 0, *(c for v in f for c in points[v]), 7)
    return data


def stl_text(mesh, end="\n", name="solid one"):
    points, faces = triangles(mesh)
    lines = [name]
    for f in faces:
        lines += ["facet normal 0 0 0", " outer loop"]
        lines += ["  vertex " + " ".join(map(number, points[v])) for v in f]
        lines += [" endloop", "endfacet"]
    return (end.join(lines + ["endsolid"]) + end).encode()


WRITERS = {
    "off": ("off", off), "off CR LF": ("off", lambda m: off(m, "\r\n")),
    "off CR": ("off", lambda m: off(m, "\r")), "obj": ("obj", obj),
    "obj CR LF": ("obj", lambda m: obj(m, "\r\n")),
    "obj corners": ("obj", lambda m: obj(m, corner="%d/5/-7")),
    "ply": ("ply", ply), "ply CR LF": ("ply", lambda m: ply(m, end="\r\n")),
    "ply CR": ("ply", lambda m: ply(m, end="\r")),
    "ply little": ("ply", lambda m: ply(m, "binary_little_endian")),
    "ply big": ("ply", lambda m: ply(m, "binary_big_endian", real="double", index="ushort")),
    "ply little, CR LF": ("ply", lambda m: ply(m, "binary_little_endian", "\r\n", index="uint8")),
    "stl": ("stl", stl_text), "stl CR LF": ("stl", lambda m: stl_text(m, "\r\n", "SOLID")),
    "stl binary": ("stl", stl_binary),
    "stl binary, solid": ("stl", lambda m: stl_binary(m, b"solid of the binary kind")),
    "stl binary, more": ("stl", lambda m: stl_binary(m, b"x") + b"more")}


def model_of(mesh, as_indexed=False):
    return rp.Model(off(mesh), "off", as_indexed)


class Case(unittest.TestCase):
    def accepts(self, model, certificate, *words):
        code, out, err = check(model.data, certificate)
        self.assertEqual((code, err), (0, ""), out + err)
        self.assertTrue(out.startswith("ACCEPT mesh-"), out)
        for w in words:
            self.assertIn(w, out)

    def rejects(self, condition, model, certificate):
        code, out, err = check(model.data, certificate)
        self.assertEqual((code, err), (1, ""), "expected %s, got %s%s" % (condition, out, err))
        self.assertTrue(out.startswith("REJECT %s: " % condition), condition + " expected: " + out)
        self.assertEqual(out.count("\n"), 1)

    def refuses(self, fmt, data, word=""):
        """The reading rule refuses the file."""
        model = rp.Model(off(TET), "off")
        model.data, model.format = data, fmt
        code, out, err = check(data, rp.Invalid(model, [(1, rp.u32(0))]).encode())
        self.assertEqual((code, out), (4, ""), "%r: %s%s" % (data[:200], out, err))
        self.assertRegex(err, "(byte|line) [0-9]+: .*" + word)


# ---- Acceptance ------------------------------------------------------------------------------

REGULAR = ([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)],
           [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)])


class Accepts(Case):
    def test_solids_in_every_format(self):
        for name, (mesh, shells, bodies, genus, volume) in SOLIDS.items():
            for writer, (fmt, write) in WRITERS.items():
                with self.subTest(solid=name, writer=writer):
                    model = rp.Model(write(mesh), fmt)
                    cert = rp.prove_valid(model)
                    self.assertEqual(cert.quantities["volume"], volume)
                    self.accepts(model, cert.encode(), "mesh-valid-1: ", "%d shells" % shells,
                                 "%d bodies" % bodies, "%d genus" % genus, "volume " + volume)

    def test_solids_in_any_order_with_and_without_separators(self):
        rng = random.Random(1)
        for name, (mesh, *_) in dict(SOLIDS, twist=(TWIST,)).items():
            model = model_of(mesh)
            for morton, separators in ((True, False), (False, True), (False, False)):
                with self.subTest(solid=name, morton=morton, separators=separators):
                    self.accepts(model, rp.prove_valid(model, morton, separators).encode())
            for _ in range(3):
                points, faces = triangles(mesh)
                rng.shuffle(faces)
                again = model_of((points, faces))
                self.accepts(again, rp.prove_valid(again, False).encode())

    def test_certificates_without_star_codes(self):
        for mesh in (TET, CUBE, RING, TWIST):
            model = model_of(mesh)
            found, rp.find_star = rp.find_star, lambda *_: (0, None)
            try:
                cert = rp.prove_valid(model, separators=False)
            finally:
                rp.find_star = found
            self.assertGreater(len(cert.codes), 0)
            self.accepts(model, cert.encode())

    def test_star_vectors(self):
        model = model_of(CUBE)
        cert = rp.prove_valid(model)
        cert.vectors = [rp.STAR_TABLE[c - 1] for c in cert.stars if c]
        cert.vectors = [tuple(7 * c for c in d) for d in cert.vectors]
        cert.stars = [14 if c else 0 for c in cert.stars]
        self.accepts(model, cert.encode())

    def test_as_indexed_with_and_without_equal_positions(self):
        model = model_of(TWO, as_indexed=True)
        self.accepts(model, rp.prove_valid(model).encode())
        model = rp.Model(stl_binary(TET), "stl", as_indexed=True)  # STL is merged all the same
        self.accepts(model, rp.prove_valid(model).encode())

    def test_unreferenced_vertices_do_not_count(self):
        points, faces = TET
        model = model_of(([(9, 9, 1e300)] + points, [tuple(v + 1 for v in f) for f in faces]))
        self.accepts(model, rp.prove_valid(model).encode(), "4 vertices")

    def test_coordinates_of_every_width(self):
        """One model for each number of limbs, from integers to all of binary64."""
        for tiny in ("1", "-0x1p-1074", "0x1p-30", "0x1p-90", "0x1p-200", "0x1p-500", "0x1p-1074"):
            for huge in ("1", "0x1.fffffffffffffp+1023"):
                e, h = float.fromhex(tiny), float.fromhex(huge)
                model = model_of(([(0, 0, e), (h, 0, 0), (0, h, 0), (e, e, h)], TET[1]))
                self.accepts(model, rp.prove_valid(model).encode(),
                             "volume " + rp.prove_valid(model).quantities["volume"])

    def test_decimals_round_to_nearest_even(self):
        hard = ["0.1", "1e23", "9007199254740993", "9007199254740993.0000000000000000000000000001",
                "2.2250738585072011e-308", "2.2250738585072012e-308", "4.9e-324", "1.5e-323",
                "8.5e-324", "3e-324", "2.4703282292062328e-324", "179769313486231570e291",
                "1." + "0" * 900 + "1", "0.5000000000000000277555756156289135105907917022705078125",
                "0.500000000000000083266726846886740531772375106811523437499", "+.5e+1", "5.E0",
                "9007199254740995", "1234567890123456789012345", "1." + "3" * 900, "0" * 400 + "3", "1" + "0" * 400 + "e-400", "0." + "0" * 400 + "1e401"]
        for d in hard:
            x = float(d)
            data = ("v 0 0 0\nv %s 0 0\nv 0 1 0\nv 0 0 1\n" % d +
                    "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n").encode()
            model = rp.Model(data, "obj")
            cert = rp.prove_valid(model)
            self.assertEqual(Fraction(cert.quantities["volume"]), Fraction(x) / 6)
            self.accepts(model, cert.encode())
        rng = random.Random(7)
        for _ in range(40):
            digits = str(rng.getrandbits(rng.randrange(1, 200)))
            d = "%s.%se%d" % (digits, rng.getrandbits(60) or 1, rng.randrange(-340, 200))
            if not 0 < float(d) < float("inf"):
                continue
            data = ("v 0 0 0\nv %s 0 0\nv 0 1 0\nv 0 0 1\n" % d +
                    "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n").encode()
            model = rp.Model(data, "obj")
            self.accepts(model, rp.prove_valid(model).encode())

    def test_decimals_that_round_to_zero(self):
        for d in ("1e-326", "-2e-324", "1e-99999", "2.4703282292062327e-324", "0e99999"):
            data = ("v %s 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n" % d).encode()
            model = rp.Model(data, "obj")
            self.accepts(model, rp.prove_valid(model).encode(), "volume 1/6")

    def test_integer_coordinates(self):
        for kind in ("binary_little_endian", "binary_big_endian"):
            for real in ("int", "short", "char", "uint", "ushort", "uchar"):
                model = rp.Model(ply(TET, kind, real=real), "ply")
                self.accepts(model, rp.prove_valid(model).encode(), "volume 1/6")

    def test_help_and_version(self):
        for words in (["--help"], ["-h"], ["--version"]):
            code, out, err = check_files(*words)
            self.assertEqual((code, err), (0, ""))
            self.assertIn("veritope-check", out)
        for words in ([], ["a"], ["a", "b", "c"], ["--what"], ["--help", "x"]):
            self.assertEqual(check_files(*words)[:2], (2, ""))

    def test_names_are_printed_without_control_characters(self):
        code, out, err = check_files(CHECK, "no\x7f\x1b[31m")
        self.assertEqual((code, out, err), (4, "", "no??[31m: cannot be opened\n"))

    @unittest.skipIf(os.environ.get("VERITOPE_SANITIZE"), "sanitizers need more address space")
    def test_out_of_memory_is_exit_3(self):
        model = os.path.join(FOLDER.name, "large.stl")
        with open(model, "wb") as file:
            file.truncate(1 << 28)
        cert = os.path.join(FOLDER.name, "any.cert")
        with open(cert, "wb") as file:
            file.write(rp.prove_valid(model_of(TET)).encode())
        limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (1 << 27, 1 << 27))
        r = subprocess.run([CHECK, model, cert], capture_output=True, preexec_fn=limit, check=False)
        self.assertEqual((r.returncode, r.stdout, r.stderr), (3, b"", b"veritope-check stops: out of memory\n"))

    def test_other_ways_to_write_a_tetrahedron(self):
        v = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
        off_v = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
        off_f = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"
        head = ("ply\nformat ascii 1.0\nobj_info x\nelement junk 2\nproperty list char float a\n"
                "property int b\nelement vertex 4\nproperty uchar q\nproperty short z\n"
                "property int8 x\nproperty double y\nproperty list uchar float w\n")
        body = "2 nan x 5\n0 ?\n\n9 0 0 0 0 # 0 1 0 1 nan\n1 0 0 1 2 3\t3\n0 1\n0 0 0\n"
        for fmt, text in (
                ("obj", v + "f -4 -2 -3\nf 1 2 4\nfo 1 4 3\nf 2 3 4\n"),
                ("obj", "f 1/1 3//2 2/1/1\nf 1 2 4 # 3\nf 1 4 3\nf 2 3 4\n" + v),
                ("obj", "\ufeff" + v + "vn 1\nf 1 3\\\n 2\nf 1 2 \\\r\n4\n#\\\nf 1 2 3\n"
                        "f 1 4 3\nf 2 3 4"),
                ("obj", v.replace(" ", "\t \v\f").replace("0 1\n", "0 1 7 7 7\n") +
                 "g x\ns f\nl 1 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"),
                ("obj", "v 0 0 0\nv -0 0 -0.0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                        "f 2 4 3\nf 1 3 5\nf 2 5 4\nf 3 4 5\n"),
                ("off", "# c\nSTCNOFF# x\n\n4 4# 6\n#\n0 0 0 9 9\n\n1 0 0 # c\n0 1 0\r0 0 1\n"
                        "3 0 2 1 255 0 0\n3 0 1 3\n3 0 3 2\n3 1 2 3\ntrailing junk"),
                ("off", "OFF 4 4 6 0 0 0\n" + off_v + off_f.replace("1 2 3", "+1 2 3")),
                ("off", "COFF\n4\n4\n" + off_v + off_f), ("off", "NOFF 4\n4 x\n" + off_v + off_f),
                ("off", "\ufeffSTOFF 4\r\n4 x\n" + off_v + off_f),
                ("ply", head + "element face 4\nproperty list char int vertex_index\n"
                               "property float r\nend_header\n" + body +
                 "3 0 2 1 x\n3 0 1 3 0\n3 0 3 2 0\n3 1 2 3 0 junk"),
                ("ply", head + "element tristrips 1\nproperty list int int vertex_indices\n"
                               "end_header\n" + body + "14 0 0 1 2 -1 0 1 3 2 -1 0 0 2 3\n")):
            with self.subTest(text=text):
                model = model_of(TET)
                model.data, model.format = text.encode(), fmt
                if "tristrips" in text:
                    model.faces = [(1, 0, 2), (0, 1, 3), (3, 1, 2), (2, 0, 3)]
                self.accepts(model, rp.prove_valid(model).encode(), "volume 1/6")
        for text in ("\n solid\n" + stl_text(TET).decode().split("\n", 1)[1].upper(),
                     "\ufeff" + stl_text(TET).decode().replace("normal 0 0 0", "FACET\n1 \r")):
            model = rp.Model(text.encode(), "stl")
            self.accepts(model, rp.prove_valid(model).encode(), "volume 1/6")

    def test_polygons_become_fans(self):
        for n in (5, 9):
            ring = [(0, 0), (4, 0), (6, 2), (6, 5), (3, 7), (1, 6), (0, 5), (-1, 3), (-1, 1)][:n]
            points = [(x, y, 0) for x, y in ring] + [(x, y, 2) for x, y in ring]
            faces = [tuple(range(n))[::-1], tuple(range(n, 2 * n))]
            faces += [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
            for fmt, write in (WRITERS["ply little"], WRITERS["obj"], WRITERS["off"]):
                model = rp.Model(write((points, faces)), fmt)
                self.assertEqual(len(model.faces), 4 * n - 4)
                self.accepts(model, rp.prove_valid(model).encode())

    def test_several_blocks_of_an_ascii_stl(self):
        data = stl_text(TET) + b"\n\n" + stl_text(moved(TET, (5, 5, 5)), name="solid facet 2")
        model = rp.Model(data, "stl")
        self.accepts(model, rp.prove_valid(model).encode(), "2 shells")

    def test_the_order_of_keys_is_free(self):
        model = model_of(TET)
        cert = rp.prove_valid(model)
        line, body = cert.encode().split(b"\n", 1)
        keys = list(json.loads(line).items())
        random.Random(3).shuffle(keys)
        self.accepts(model, rp.file_of(dict(keys), body))

    def test_a_work_bound_that_only_a_bad_order_meets(self):
        """Tetrahedra along a diagonal. Pairs from opposite ends make all boxes overlap."""
        n = 4096
        model = model_of(joined(*(moved(REGULAR, (4 * i, 4 * i, 4 * i)) for i in range(n))))
        cert = rp.Valid(model)
        cert.stars = rp.prove_valid(model_of(REGULAR)).stars * n
        self.assertNotIn(0, cert.stars)
        cert.nesting = [0] * n
        cert.quantities = rp.quantities(model, n, n)
        self.accepts(model, cert.encode(), "%d bodies" % n)
        cert.order = [f for i in range(2 * n) for f in (i, 4 * n - 1 - i)]
        self.rejects("B1", model, cert.encode())

    def test_the_work_bound_of_the_walk_is_exact(self):
        """Tetrahedra whose boxes all meet, so F triangles take all (F - 1)^2 calls of cross; no code is right."""
        for last, answer in ((969, "V9"), (1, "B1")):     # the greatest and the least last digits of a square
            n = next(n for n in range(2500, 9999) if (4 * n - 1) ** 2 % 1000 == last)
            work = (4 * n - 1) ** 2
            model = model_of(joined(*(moved(REGULAR, (i / 4096, i / 4096, i / 4096)) for i in range(n))))
            cert = rp.Valid(model)
            cert.nesting = [0] * n
            cert.quantities = rp.quantities(model, n, n)
            cert.codes = [17] * ((work + 31) // 1000 - 4 * n - len(cert.body()))
            self.rejects(answer, model, cert.encode())


# ---- Statement -------------------------------------------------------------------------------

class Statements(Case):
    def setUp(self):
        self.model = model_of(TET)
        self.cert = rp.prove_valid(self.model)
        self.line, self.body = self.cert.encode().split(b"\n", 1)

    def with_line(self, old, new):
        self.assertIn(old, self.line)
        return self.line.replace(old, new, 1) + b"\n" + self.body

    def test_S1_form(self):
        d = json.loads(self.line)
        less = {k: v for k, v in d.items() if k != "genus"}
        for old, new in ((b",", b", "), (b'{"', b'{ "'), (b"}", b"} "), (b"}", b"}}"), (b"}", b",}"),
                         (b'"faces":4', b'"faces":04'), (b'"faces":4', b'"faces":+4'),
                         (b'"faces":4', b'"faces":-4'), (b'"faces":4', b'"faces":4.0'),
                         (b'"faces":4', b'"faces":18446744073709551616'),
                         (b'"faces":4', b'"faces":99999999999999999999999'),
                         (b'"faces":4', b'"faces":"4"'), (b'"faces":4', b'"faces":true'),
                         (b'"faces":4', b'"faces":'), (b'"faces":4', b'"faces":null'),
                         (b'"faces":4', b'"faces":[4]'), (b'"faces":4', b'"faces":4,"faces":4'),
                         (b'"faces":4', b'"faces":4,"x":4'), (b'"faces":4', b'"faces":4,"rules":"M1"'),
                         (b'"faces":4', b'"faces":4,"tool":4'), (b'"faces":4', b'"Faces":4'),
                         (b'"volume":"1/6"', b'"volume":"1"'), (b'"volume":"1/6"', b'"volume":"1/0"'),
                         (b'"volume":"1/6"', b'"volume":"01/6"'), (b'"volume":"1/6"', b'"volume":"/6"'),
                         (b'"volume":"1/6"', b'"volume":"1/06"'), (b'"volume":"1/6"', b'"volume":"1/6/1"'),
                         (b'"volume":"1/6"', b'"volume":"-1/6"'), (b'"volume":"1/6"', b'"volume":""'),
                         (b'"volume":"1/6"', b'"volume":7'), (b"false", b"0"), (b"false", b'"false"'),
                         (b"false", b"False"), (b"false", b"falsey"), (b"certificate-1", b"certificate-2"),
                         (b"mesh-valid-1", b"mesh-valid-2"), (b"mesh-valid-1", b"mesh-invalid-1"),
                         (b"prover", b"pro\\\\ver"), (b"prover", b'pro\\"ver'), (b"prover", b"pr\tover"),
                         (b"prover", "pr\u00f6ver".encode()), (b"prover", b"x" * 201),
                         (b"prover", b"pr\x7fover"), (b"prover", b"pr\0over"), (b"prover", b"pr\nover"),
                         (b'"off"', b'"OFF"'), (b'"off"', b'"of"'), (b'"off"', b'" ob"'),
                         (b'"off"', b'"3mf"'), (b":", b""), (b'"', b""), (b"{", b"")):
            with self.subTest(old=old, new=new):
                self.rejects("S1", self.model, self.with_line(old, new))
        self.rejects("S1", self.model, rp.file_of(less, self.body))
        self.rejects("S1", self.model, b"")
        self.rejects("S1", self.model, b"\n")
        self.rejects("S1", self.model, b"{}\n")
        self.rejects("S1", self.model, self.line)
        self.rejects("S1", self.model, self.line + b"\r\n" + self.body)
        self.rejects("S1", self.model, b"\xef\xbb\xbf" + self.line + b"\n" + self.body)
        self.rejects("S1", self.model, self.line[:-1] + b" " * 70000 + b"}\n" + self.body)
        for key in ("subject_sha256", "body_sha256"):
            for h in (d[key].upper(), d[key][:-1], d[key] + "0", "g" + d[key][1:]):
                self.rejects("S1", self.model, rp.file_of(dict(d, **{key: h}), self.body))

    def test_S1_values_and_flags(self):
        self.rejects("S1", self.model, self.with_line(b'"faces":4', b'"faces":4\n'))
        self.rejects("S1", self.model, self.with_line(b'"as_indexed"', b'"as_index"'))
        self.rejects("S1", self.model, self.with_line(b'"as_indexed":false,', b""))

    def test_S1_rules(self):
        model = model_of((TET[0], TET[1][:3]))
        cert = rp.Invalid(model, [(3, rp.u32(1, 2))])
        self.accepts(model, cert.encode(), "rules M3")
        for rules in ("", " ", "M0", "M10", "M3 ", " M3", "M3  M4", "M4 M3", "M3 M3", "M3,M4", "m3", "3", 3):
            self.rejects("S1", model, cert.encode(rules=rules))

    def test_S1_size_of_the_line(self):
        room = 65536 - len(self.line)
        keys = json.loads(self.line)
        exact = rp.file_of(dict(keys, volume="1" * (room + 3)), self.body)
        self.assertEqual(exact.index(b"\n"), 65536)
        self.rejects("S1", self.model, exact)  # no q
        longest = rp.file_of(dict(keys, volume="1" * room + "1/6"), self.body)
        self.assertEqual(longest.index(b"\n"), 65536)
        self.rejects("V11", self.model, longest)
        self.rejects("S1", self.model, longest.replace(b"1/6", b"11/6"))

    def test_S2_another_reading_rule(self):
        self.rejects("S2", self.model, self.with_line(b"ties to even", b"ties to odd"))
        self.rejects("S2", self.model, self.with_line(b"in range.", b"in range"))

    def test_S3_another_model(self):
        self.rejects("S3", model_of(TWIST), self.cert.encode())
        self.rejects("S3", self.model, self.cert.encode(subject_bytes=len(self.model.data) + 1))
        self.rejects("S3", self.model, self.cert.encode(subject_sha256="0" * 64))
        self.rejects("S3", self.model, self.cert.encode(subject_bytes=2 ** 64 - 1))

    def test_S4_another_body(self):
        self.rejects("S4", self.model, self.line + b"\n" + self.body + b"\0")
        self.rejects("S4", self.model, self.line + b"\n" + self.body[:-1])
        self.rejects("S4", self.model, self.cert.encode(body_sha256="0" * 64))

    def test_every_truncation(self):
        data = self.cert.encode()
        for n in range(len(data)):
            self.rejects("S1" if n <= len(self.line) else "S4", self.model, data[:n])

    def test_claims_the_wrong_format(self):
        model = self.model
        for fmt in ("obj", "ply", "stl"):
            code, out, err = check(model.data, self.cert.encode(subject_format=fmt))
            self.assertEqual((code, out), (4, ""), err)

    def test_usage(self):
        self.assertEqual(check_files("--help")[0], 0)
        self.assertIn("MODEL CERT", check_files("--help")[1])
        self.assertRegex(check_files("--version")[1], r"^veritope-check .*\d")
        for args in ([], ["x"], ["x", "y", "z"], ["--help", "x"], ["--what", "x"], ["--what"]):
            code, out, err = check_files(*args)
            self.assertEqual((code, out), (2, ""))
            self.assertIn("usage", err)

    def test_files_that_cannot_be_read(self):
        check(self.model.data, self.cert.encode())
        m, c = (os.path.join(FOLDER.name, n) for n in ("model", "certificate"))
        for args in ((m, FOLDER.name), (FOLDER.name, c), (m, m + "none"), (m + "none", c)):
            code, out, err = check_files(*args)
            self.assertEqual((code, out), (4, ""))
            self.assertRegex(err, "cannot be|is not a regular file")


# ---- Valid -----------------------------------------------------------------------------------

class Valid(Case):
    def prove(self, mesh, **options):
        as_indexed = options.pop("as_indexed", False)
        model = model_of(mesh, as_indexed)
        return model, rp.prove_valid(model, **options)

    def bent(self, condition, mesh, bend, **options):
        """The certificate is accepted, and rejected by `condition` after bend(certificate)."""
        model, cert = self.prove(mesh, **options)
        self.accepts(model, cert.encode())
        bend(cert)
        self.rejects(condition, model, cert.encode())

    def test_B1_numbers_of_the_body(self):
        model, cert = self.prove(SHELL)
        body = cert.body()
        f, v = len(model.faces), len(model.points)
        at_stars = 12 + 4 * f
        at_counts = at_stars + v
        bends = [b"VTMX" + body[4:], b"VTMI" + body[4:], body + b"\0", body[:-1], b""]
        for at in (4, 8, at_counts, at_counts + 4 + 12 * len(cert.vectors)):
            for change in (1, -1, 2 ** 31, None):
                n = struct.unpack_from("<I", body, at)[0]
                n = 2 ** 32 - 1 if change is None else (n + change) % 2 ** 32
                bends.append(body[:at] + rp.u32(n) + body[at + 4:])
        bends.append(body[:at_stars] + b"\x0f" + body[at_stars + 1:])
        bends.append(body[:at_stars] + b"\xff" + body[at_stars + 1:])
        bends.append(body[:at_stars] + b"\x0e" + body[at_stars + 1:])  # and no vector
        bends.append(body[:-1] + b"\x06")
        for b in bends:
            self.rejects("B1", model, cert.encode(b))
        for n in range(len(body)):
            self.rejects("B1", model, cert.encode(body[:n]))

    def test_B1_nesting_bytes(self):
        for mesh, bytes_ in ((TET, [0]), (SHELL, []), (SHELL, [0]), (SHELL, [0, 0, 0])):
            model, cert = self.prove(mesh)
            cert.nesting = bytes_
            self.rejects("B1", model, cert.encode())

    def test_B1_varints(self):
        model, cert = self.prove(CUBE)
        cert.separators = []
        empty = rp.u32(0) + rp.u32(len(cert.codes)) + bytes(cert.codes)
        body = cert.body()
        self.assertTrue(body.endswith(empty))
        start = body[:-len(empty)]
        good = b"\0" * 4
        self.rejects("V8", model, cert.encode(start + rp.u32(1) + good + empty[4:]))
        top = b"\xff" * 9 + b"\x01"  # 2^64 - 1
        self.rejects("V8", model, cert.encode(start + rp.u32(1) + top + b"\0" * 3 + empty[4:]))
        for bad in (b"\x80\x00" + b"\0" * 3, b"\xff" * 9 + b"\x02" + b"\0" * 3,
                    b"\xff" * 10 + b"\x01" + b"\0" * 3, b"\0\x81\x00\0\0",
                    b"\0" + rp.varint(2 ** 32 - 1) + b"\0\0", b"\0" + rp.varint(2 ** 32) + b"\0\0",
                    b"\0\0\0" + rp.zigzag(-2 ** 31), b"\0\0\0" + rp.zigzag(2 ** 31)):
            self.rejects("B1", model, cert.encode(start + rp.u32(1) + bad + empty[4:]))
        for most in (2 ** 31 - 1, 1 - 2 ** 31):
            d = b"\0" + rp.zigzag(most) + b"\0\0"
            self.rejects("V8", model, cert.encode(start + rp.u32(1) + d + empty[4:]))

    def test_V1_order(self):
        def twice(cert):
            cert.order[3] = cert.order[0]

        def beyond(cert):
            cert.order[0] = len(cert.order)

        def far(cert):
            cert.order[-1] = 2 ** 32 - 1
        for bend in (twice, beyond, far):
            self.bent("V1", CUBE, bend)

    def test_V2_equal_positions(self):
        touching = joined(TET, moved(TET, (1, 0, 0)))  # (1, 0, 0) twice
        model, cert = self.prove(touching, as_indexed=True)
        self.rejects("V2", model, cert.encode())
        touching[0][4] = (1, -0.0, 0)
        model, cert = self.prove(touching, as_indexed=True)
        self.rejects("V2", model, cert.encode())

    def test_V3_degenerate_triangles(self):
        flat = (TET[0] + [(0.5, 0, 0)],
                [(0, 2, 4), (4, 2, 1), (0, 4, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])
        model, cert = self.prove(flat)
        self.assertEqual(rp.edge_uses(model), {e: u for e, u in rp.edge_uses(model).items()
                                               if len(u) == 2 and u[0] == u[1][::-1]})
        self.rejects("V3", model, cert.encode())
        model, cert = self.prove((TET[0], TET[1] + [(1, 1, 2)]))
        self.rejects("V3", model, cert.encode())
        for collapsed in ((3, 3, 3), (0, 0, 1), (0, 1, 1), (0, 1, 0)):
            model, cert = self.prove((TET[0], [(0, 2, 1), (0, 1, 3), collapsed, (0, 3, 2), (1, 2, 3)]))
            self.rejects("V3", model, cert.encode())

    def test_V4_edges(self):
        turned_face = (TET[0], TET[1][:3] + [TET[1][3][::-1]])
        three = (TET[0] + [(5, 5, 5)], TET[1] + [(0, 1, 4), (1, 0, 4)])
        for mesh in ((TET[0], TET[1][:3]), turned_face, (TET[0], TET[1] + [TET[1][0]]), three,
                     (TET[0], TET[1][:1])):
            model, cert = self.prove(mesh)
            self.rejects("V4", model, cert.encode())

    def test_V5_triangles_with_the_same_corners(self):
        model, cert = self.prove((TET[0][:3], [(0, 1, 2), (0, 2, 1)]))
        self.rejects("V5", model, cert.encode())
        model, cert = self.prove(joined(TET, (TET[0][:3], [(0, 1, 2), (2, 1, 0)])), as_indexed=True)
        cert.model.points[4:] = [(9, 9, 9), (8, 9, 9), (9, 8, 9)]
        mesh = (cert.model.points, cert.model.faces)
        model, cert = self.prove(mesh)
        self.rejects("V5", model, cert.encode())

    def test_V6_vertices_with_two_cycles(self):
        model, cert = self.prove(joined(TET, moved(TET, (1, 0, 0))))
        self.assertEqual(len(model.points), 7)
        self.rejects("V6", model, cert.encode())

    def test_V7_star_codes(self):
        def code(new):
            def bend(cert):
                cert.stars[0] = new
            return bend

        def vector(d):
            def bend(cert):
                self.assertNotEqual(cert.stars[0], 0)
                cert.stars[0] = 14
                cert.vectors = [d] + cert.vectors
            return bend
        # The corner (0, 0, 0) of the cube is seen properly along d if d x > 0, d y > 0, d z > 0.
        for i, d in enumerate(rp.STAR_TABLE):
            if d != (1, 1, 1):
                self.bent("V7", CUBE, code(i + 1))
        for d in ((0, 0, 0), (1, 1, 0), (-1, 1, 1), (1, -2 ** 31, 1), (0, 0, 1)):
            self.bent("V7", CUBE, vector(d))
        for d in ((1, 2, 3), (-5, -1, -1), (2 ** 31 - 1, 1, 1), (-2 ** 31, -2 ** 31, -2 ** 31)):
            model, cert = self.prove(CUBE)
            vector(d)(cert)
            self.accepts(model, cert.encode())
        # A saddle vertex: all normals on one side of d, but more than one turn.
        model, cert = self.prove((TET[0] + [(7, 7, 7)], TET[1]))
        cert.stars[4] = 1
        self.rejects("V7", model, cert.encode())
        cert.stars[4], cert.vectors = 14, cert.vectors + [(1, 1, 1)]
        self.rejects("V7", model, cert.encode())

    def test_V7_two_turns(self):
        """A vertex that its triangles go around twice, each seen from the front."""
        ring = [(2, 0), (0, 2), (-2, -1), (3, -1), (1, 3), (-3, -2)]
        points = [(x, y, z) for z, (x, y) in zip((0, 1, 2, 3, 4, 5), ring)]
        mesh = (points + [(0, 0, 10), (0, 0, -10)],
                [(i, (i + 1) % 6, 6) for i in range(6)] + [((i + 1) % 6, i, 7) for i in range(6)])
        model, cert = self.prove(mesh)
        normals = [model.normal(f)[2] for f in range(6)]
        self.assertTrue(all(n > 0 for n in normals))
        self.assertEqual(cert.stars[6], 0)
        cert.stars[6] = 3
        self.rejects("V7", model, cert.encode())

    def test_V7_agrees_with_the_page_on_many_directions(self):
        """Directions that are wrong in one way only: a triangle seen from behind, or edge-on."""
        for mesh in (CUBE, RING, TWIST):
            model, cert = self.prove(mesh, separators=False)
            at = [[f for f, t in enumerate(model.faces) if v in t] for v in range(len(model.points))]
            kinds = {}
            for v, faces in enumerate(at):
                for d in ((x, y, z) for x in range(-2, 3) for y in range(-2, 3) for z in range(-2, 3)):
                    signs = sorted(rp.sign(rp.dot(model.normal(f), d)) for f in faces)
                    if len(set(signs)) > 1 and len(kinds.setdefault(tuple(signs), [])) < 4:
                        kinds[tuple(signs)].append((v, d))
            for v, d in (c for cases in kinds.values() for c in cases):
                self.assertFalse(rp.star_holds(model, v, at[v], d))
                cert.stars, cert.vectors = [0] * len(at), [d]
                cert.stars[v] = 14
                self.rejects("V7", model, cert.encode())

    def test_V8_separators(self):
        def reverse(cert):
            self.assertTrue(cert.separators)
            gap, d = cert.separators[0]
            cert.separators[0] = gap, tuple(-c for c in d)

        def zero(cert):
            cert.separators[0] = cert.separators[0][0], (0, 0, 0)

        def unused(cert):
            cert.separators.append((0, (1, 0, 0)))
            cert.separators[-1] = 10 ** 6, (1, 0, 0)

        def never(cert):
            cert.separators.append((2 ** 64 - 1, (1, 0, 0)))

        def late(cert):
            cert.separators[0] = 10 ** 9, cert.separators[0][1]

        def slanted(cert):
            gap, d = cert.separators[0]
            cert.separators[0] = gap, tuple(1000 * c + s for c, s in zip(d, (1, -1, 1)))
        for bend in (reverse, zero, unused, never, late, slanted):
            self.bent("V8", ELL, bend, morton=False)

    def test_V8_open_is_not_enough(self):
        """Two triangles in the separating plane that share only an edge leave the test open."""
        plate = triangles(voxels({(0, 0, 0), (1, 0, 0)}))
        model, cert = self.prove(plate, separators=False, morton=False)
        cert.separators = [(0, (0, 0, 1))]
        self.rejects("V8", model, cert.encode())

    def test_V9_codes(self):
        def last(cert):
            cert.codes.pop()

        def more(cert):
            cert.codes.append(0)

        def none(cert):
            cert.codes = []

        def flag(bit):
            def bend(cert):
                cert.codes[0] ^= bit
            return bend

        def axis(n):
            def bend(cert):
                cert.codes[0] = n
            return bend
        found, rp.find_star = rp.find_star, lambda *_: (0, None)
        try:
            for bend in (last, more, none, flag(32), flag(64), flag(128), axis(17), axis(31)):
                self.bent("V9", TWIST, bend, separators=False)
        finally:
            rp.find_star = found

    def test_V9_sequences(self):
        """Coplanar neighbours with a common vertex: one axis leaves them open, a second decides."""
        points = [(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0), (2, 2, 0), (2, 2, -3)]
        mesh = (points, [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4),
                         (1, 0, 5), (2, 1, 5), (3, 2, 5), (0, 3, 5)])
        model, cert = self.prove(mesh, morton=False, separators=False)
        cert.stars, cert.vectors, cert.codes = [0] * 6, [], []
        seen = []

        def leaf(f, g):
            first = rp.find_codes(model, f, g)
            for c in range(34):
                code = c // 2 | (32 if c % 2 else 0)
                d = tuple((-1 if code & 32 else 1) * x for x in rp.axes(model, f, g)[code & 31])
                answer, p, q = rp.test(model, d, list(model.faces[f]), list(model.faces[g]))
                if answer is None and (p, q) == (list(model.faces[f]), list(model.faces[g])):
                    seen.append((len(cert.codes), code))
                    first = [code | 64, code | 64, code | 64] + first
                    break
            cert.codes.extend(first)

        rp.Tree(model, cert.order, cert.stars).walk(lambda a, b: False, leaf)
        self.assertTrue(seen)
        self.accepts(model, cert.encode())
        at, code = seen[0]
        four = list(cert.codes)
        cert.codes[at:at + 3] = [code]  # open, and no byte follows
        self.rejects("V9", model, cert.encode())
        cert.codes = four[:at] + [code | 64] + four[at:]  # five bytes
        self.rejects("V9", model, cert.encode())

    def test_V9_a_crossing(self):
        """Every code is tried on a pair of triangles that cross; none is accepted."""
        pierced = triangles(joined(moved(CUBE, (0, 0, 0), 4), moved(TET, (3, 1, 1), 2)))
        model, cert = self.prove(pierced, morton=False, separators=False)
        self.rejects("V9", model, cert.encode())
        bad = [(f, g) for f in range(12) for g in range(12, 16)
               if rp.meeting_point(model, f, g) and not rp.find_codes(model, f, g)]
        self.assertTrue(bad)

    def test_V9_shells_that_touch(self):
        """Certificates by a prover with a weaker rule: what touches is never accepted."""
        octahedron = ([(2, 0, 0), (-2, 0, 0), (0, 2, 0), (0, -2, 0), (0, 0, 2), (0, 0, -2)],
                      [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)])
        touching = (  # a vertex on an edge, a vertex in a face, edges that cross, faces on faces
            joined(octahedron, moved(octahedron, (3, 1, 0))),
            joined(moved(CUBE, (0, 0, 0), 4), moved(octahedron, (2, 2, 6))),
            joined(moved(CUBE, (0, 0, 0), 4), moved(CUBE, (4, 1, 1), 2)),
            joined(moved(CUBE, (-1, -1, -5), 2), moved(RING, (0.5, 0.5, -3))),
            joined(([(-2, 0, 0), (2, 0, 0), (0, -3, -3), (0, 3, -3)], TET[1]),
                   ([(0, -2, 0), (0, 2, 0), (-3, 0, 3), (3, 0, 3)], TET[1])))
        exact = rp.test

        def collinear(model, d, p, q):
            answer, p2, q2 = exact(model, d, p, q)
            return answer is None and len(set(p2) | set(q2)) == 3 or answer, p2, q2

        def closed(model, d, p, q):
            answer, p2, q2 = exact(model, d, p, q)
            return answer is None or answer, p2, q2
        for mesh in touching:
            for rule in (exact, collinear, closed):
                rp.test = rule
                try:
                    model, cert = self.prove(triangles(mesh), separators=False)
                finally:
                    rp.test = exact
                self.rejects("V9", model, cert.encode())

    def test_V8_is_named_before_V9(self):
        model, cert = self.prove(ELL, morton=False)
        cert.codes = [31] * (len(cert.codes) + 1)
        self.rejects("V9", model, cert.encode())
        cert.separators.append((10 ** 6, (1, 0, 0)))
        self.rejects("V8", model, cert.encode())

    def test_V10_orientation_and_nesting(self):
        for mesh in (turned(TET), joined(moved(CUBE, (-1, -1, -1), 3), CUBE), turned(SHELL),
                     joined(TWO, moved(turned(TET), (-4, 0, 0))),
                     joined(moved(turned(CUBE), (-1, -1, -1), 3), CUBE)):
            model, cert = self.prove(mesh)
            for key, value in (("bodies", 1), ("volume", "1/1")):
                cert.quantities[key] = value
            self.rejects("V10", model, cert.encode())

    def test_V10_every_axis_of_a_true_nesting(self):
        model, cert = self.prove(ONION)
        for code in range(6):
            cert.nesting = [code] * 3
            self.accepts(model, cert.encode())

    def test_V10_rays_through_edges_and_vertices(self):
        """Shells on a grid: rays run along edges and through vertices of the others."""
        inner = voxels({(1, 1, 1)})
        outer = voxels({(x, y, z) for x in range(3) for y in range(3) for z in range(3)} - {(1, 1, 1)})
        column = joined(*(moved(CUBE, (0, 0, 2 * i)) for i in range(4)), moved(TET, (0, 0, -4)))
        # Rays through the vertices in the middle of the faces.
        block = voxels({(x, y, z) for x in range(2) for y in range(2) for z in range(2)})
        octahedron = ([(1.25, 1, 1), (0.75, 1, 1), (1, 1.25, 1), (1, 0.75, 1), (1, 1, 1.25), (1, 1, 0.75)],
                      [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)])
        pit = joined(block, turned(octahedron))
        # A ray at the height of the middle corner of a triangle that it stabs.
        ring = [(3, 1, 0), (-1, 3, 0), (-3, -1, 0), (1, -3, 0)]
        tops = ring + [(0, 0, 8), (0, 0, -8)], [(i, (i + 1) % 4, 4) for i in range(4)] + [
            ((i + 1) % 4, i, 5) for i in range(4)]
        level = joined(tops, turned(moved(octahedron, (-0.25, 0.5, -0.5), 0.5)))
        spikes = joined(moved(TET, (0, 0, 0)), moved(TET, (1, 0, 3)), moved(TET, (0, 1, 6)))
        for mesh in (joined(outer, moved(inner, (0.75, 0.75, 0.75), 0.5)), column, spikes, pit, level):
            model, cert = self.prove(mesh)
            for code in range(6):
                shell, shells = model.shells()
                depths = [rp.nesting_depth(model, shell, s, code) for s in range(shells)]
                self.assertEqual([d % 2 for d in depths],
                                 [int(n) for n in self.true_depths(model, shell, shells)])
                cert.nesting = [code] * shells
                self.accepts(model, cert.encode())

    @staticmethod
    def true_depths(model, shell, shells):
        out = []
        for s in range(shells):
            vol = sum(rp.dot(rp.cross(model.ints[t[0]], model.ints[t[1]]), model.ints[t[2]])
                      for f, t in enumerate(model.faces) if shell[f] == s)
            out.append(vol < 0)
        return out

    def test_V11_quantities(self):
        for mesh in (TET, RING, ONION):
            model, cert = self.prove(mesh)
            for key, value in cert.quantities.items():
                for wrong in ([value + 1, 2 ** 64 - 1] if isinstance(value, int) else
                              ["0/1", "2/12", "1/1", "9" * 9000 + "/7"]):
                    if wrong != value:
                        self.rejects("V11", model, cert.encode(**{key: wrong}))

    def test_random_changes_never_crash_and_never_make_a_lie(self):
        """Byte changes of true certificates: rejected, or accepted for a model that is a solid
        anyway. On models that are not, nothing is accepted."""
        rng = random.Random(11)
        for mesh in (ELL, SHELL, TWIST, joined(TET, moved(TET, (0.25, 0.25, 0.25), 0.25))):
            model, cert = self.prove(mesh)
            body, truth = cert.body(), check(model.data, cert.encode())[0]
            for _ in range(120):
                bent = bytearray(body)
                for _ in range(rng.choice((1, 1, 2, 5))):
                    bent[rng.randrange(len(bent))] = rng.choice((0, 1, 255, rng.randrange(256)))
                if rng.random() < 0.2:
                    del bent[rng.randrange(len(bent)):]
                code, out, err = check(model.data, cert.encode(bytes(bent)))
                self.assertIn(code, (0, 1) if truth == 0 else (1,), out + err)


# ---- Invalid ---------------------------------------------------------------------------------

OPEN = (TET[0], TET[1][:3])
BOOK = (TET[0] + [(5, 5, 5)], TET[1] + [(0, 1, 4)])
CROSSED = joined(moved(CUBE, (0, 0, 0), 4), moved(TET, (3, 1, 1), 2))
BROKEN = {
    1: (TET[0], TET[1] + [(0, 0, 1)]), 2: (TET[0], TET[1] + [(2, 1, 0)]), 3: OPEN, 4: BOOK,
    5: (TET[0], TET[1][:3] + [TET[1][3][::-1]]), 6: joined(TET, moved(TET, (1, 0, 0))),
    7: CROSSED, 8: turned(TET), 9: joined(moved(CUBE, (-1, -1, -1), 3), CUBE)}


class Invalid(Case):
    def check_one(self, condition, mesh, rule, fields, **changes):
        model = model_of(mesh)
        cert = rp.Invalid(model, [(rule, fields)])
        if condition is None:
            self.accepts(model, cert.encode(**changes), "rules M%d" % rule)
        else:
            self.rejects(condition, model, cert.encode(**changes))

    def test_every_rule_is_accepted_with_a_true_witness(self):
        for rule, mesh in BROKEN.items():
            with self.subTest(rule=rule):
                model = model_of(mesh)
                witnesses = rp.find_witnesses(model)
                if rule >= 8:
                    witnesses = [(rule, w[1]) for w in witnesses if w[0] == 8]
                self.assertIn(rule, [w[0] for w in witnesses])
                self.accepts(model, rp.Invalid(model, witnesses).encode())
                for w in witnesses:
                    self.accepts(model, rp.Invalid(model, [w]).encode())

    def test_every_format(self):
        for writer, (fmt, write) in WRITERS.items():
            model = rp.Model(write(CROSSED), fmt)
            witnesses = rp.find_witnesses(model)
            self.assertTrue(witnesses)
            self.accepts(model, rp.Invalid(model, witnesses).encode())

    # PROVES MESH-9.M1
    def test_no_witness_holds_on_a_solid(self):
        """All small witnesses of the rules without weights, and axis parallel ones of M7."""
        model = model_of(TWIST)
        n, v = len(model.faces), len(model.points)
        for f in range(n):
            self.check_one("I1", TWIST, 1, rp.u32(f))
            for u in range(3):
                self.check_one("I8", TWIST, 8, rp.u32(f) + bytes([u]))
            g = (f + 1) % n
            for i in range(3):
                w = b"".join(rp.natural(int(k == i)) for k in range(3))
                self.check_one("I7", TWIST, 7, rp.u32(f, g) + w + w)
        for a in range(v):
            self.check_one("I6", TWIST, 6, rp.u32(a))
            self.check_one("I3", TWIST, 3, rp.u32(a, (a + 1) % v))
            self.check_one("I5", TWIST, 5, rp.u32(a, (a + 1) % v))

    def test_B1_body(self):
        model = model_of(CROSSED)
        cert = rp.Invalid(model, [w for w in rp.find_witnesses(model) if w[0] == 7][:2])
        self.accepts(model, cert.encode())
        body = cert.body()
        f, v = len(model.faces), len(model.points)
        for b in (b"VTMV" + body[4:], body[:4] + rp.u32(f + 1) + body[8:], body + b"\0",
                  body[:8] + rp.u32(v - 1) + body[12:], body[:12] + rp.u32(1) + body[16:],
                  body[:12] + rp.u32(3) + body[16:], body[:12] + rp.u32(2 ** 32 - 1) + body[16:],
                  body[:12] + rp.u32(0), body[:12] + rp.u32(0) + body[16:]):
            self.rejects("B1", model, cert.encode(b))
        for n in range(len(body)):
            self.rejects("B1", model, cert.encode(body[:n]))

        def raw(*witnesses):
            return body[:12] + rp.u32(len(witnesses)) + b"".join(witnesses)
        zeros = b"\0" * 24
        for w in ((b"\0" + rp.u32(0),), (b"\x0a" + rp.u32(0),), (b"\x03" + rp.u32(0, 1), b"\x01" + rp.u32(0)),
                  (b"\x01" + rp.u32(f),), (b"\x02" + rp.u32(0, f),), (b"\x02" + rp.u32(f, 0),),
                  (b"\x03" + rp.u32(v, 0),), (b"\x04" + rp.u32(0, v),), (b"\x05" + rp.u32(v, 0),),
                  (b"\x06" + rp.u32(v),), (b"\x06" + rp.u32(2 ** 32 - 1),),
                  (b"\x07" + rp.u32(0, f) + zeros,), (b"\x07" + rp.u32(f, 0) + zeros,),
                  (b"\x08" + rp.u32(f) + b"\0",), (b"\x08" + rp.u32(0) + b"\x03",),
                  (b"\x09" + rp.u32(0) + b"\xff",),
                  (b"\x07" + rp.u32(0, 12) + rp.u32(1) + b"\0" + zeros[4:],),
                  (b"\x07" + rp.u32(0, 12) + rp.u32(2) + b"\1\0" + zeros[4:],),
                  (b"\x07" + rp.u32(0, 12) + rp.u32(2 ** 32 - 1) + zeros,),
                  (b"\x07" + rp.u32(0, 12) + rp.u32(4097) + b"\1" * 4097 + zeros[4:],)):
            self.rejects("B1", model, cert.encode(raw(*w)))
        long = b"\x07" + rp.u32(0, 12) + (rp.u32(4096) + b"\1" * 4096) * 6
        self.rejects("I7", model, cert.encode(raw(long)))

    def test_I1(self):
        flat = (TET[0] + [(2, 0, 0)], TET[1] + [(0, 1, 4)])
        self.check_one(None, flat, 1, rp.u32(4))
        self.check_one("I1", flat, 1, rp.u32(0))

    def test_I2(self):
        mesh = (TET[0], TET[1] + [(2, 1, 0), (0, 0, 1), (0, 1, 1)])
        self.check_one(None, mesh, 2, rp.u32(0, 4))
        self.check_one("I2", mesh, 2, rp.u32(5, 6))  # fewer than three vertices
        self.check_one("I2", mesh, 2, rp.u32(0, 0))
        self.check_one("I2", mesh, 2, rp.u32(0, 1))
        for f in range(4):  # two common vertices, every one of the three missing
            for g in range(4):
                self.check_one("I2", mesh, 2, rp.u32(f, g))
        self.check_one("I2", mesh, 2, rp.u32(5, 0))
        self.check_one("I2", mesh, 2, rp.u32(0, 5))

    def test_I3(self):
        self.check_one(None, OPEN, 3, rp.u32(1, 2))
        self.check_one(None, OPEN, 3, rp.u32(2, 1))
        self.check_one("I3", OPEN, 3, rp.u32(0, 1))
        self.check_one("I3", OPEN, 3, rp.u32(1, 1))
        self.check_one("I3", (TET[0] + [(9, 9, 9)], OPEN[1]), 3, rp.u32(1, 4))
        self.check_one("I3", (TET[0], [(0, 1, 0), (1, 2, 3)]), 3, rp.u32(0, 1))

    def test_I4(self):
        self.check_one(None, BOOK, 4, rp.u32(0, 1))
        self.check_one(None, BOOK, 4, rp.u32(1, 0))
        self.check_one("I4", BOOK, 4, rp.u32(0, 2))
        self.check_one("I4", BOOK, 4, rp.u32(0, 4))
        self.check_one("I4", BOOK, 4, rp.u32(0, 0))

    def test_I5(self):
        mesh = BROKEN[5]
        self.check_one(None, mesh, 5, rp.u32(2, 1))
        self.check_one("I5", mesh, 5, rp.u32(1, 2))
        self.check_one("I5", mesh, 5, rp.u32(0, 1))
        self.check_one("I5", mesh, 5, rp.u32(1, 1))
        self.check_one("I5", (TET[0], [(0, 1, 2), (0, 1, 3), (1, 0, 3)]), 5, rp.u32(0, 1))
        self.check_one("I5", (TET[0], [(0, 1, 2), (0, 1, 3), (0, 1, 2)]), 5, rp.u32(0, 1))

    def test_I6(self):
        mesh = joined(BROKEN[6], ([(9, 9, 9)], []))
        self.check_one(None, mesh, 6, rp.u32(1))
        self.check_one("I6", mesh, 6, rp.u32(0))
        self.check_one("I6", mesh, 6, rp.u32(7))  # no triangle
        fan = ([(0, 0, 0)] + [(1, i, i * i) for i in range(6)],
               [(0, 1, 2), (0, 3, 4), (0, 5, 6), (0, 2, 3)])
        self.check_one(None, fan, 6, rp.u32(0))
        self.check_one("I6", (fan[0], fan[1] + [(0, 4, 5)]), 6, rp.u32(0))
        self.check_one("I6", (fan[0], fan[1] + [(0, 5, 1), (0, 4, 6)]), 6, rp.u32(0))
        # A triangle of fewer than three vertices is at no vertex: it joins no fans.
        self.check_one(None, (fan[0], fan[1] + [(0, 0, 5), (4, 0, 0), (0, 0, 1)]), 6, rp.u32(0))

    def seven(self, condition, mesh, f, g, w, x):
        self.check_one(condition, mesh, 7, rp.u32(f, g) + b"".join(map(rp.natural, w + x)))

    def test_I7(self):
        model = model_of(CROSSED)
        f, g, w, x = next((f, g, *p) for f in range(12) for g in range(12, 16)
                          for p in [rp.meeting_point(model, f, g)] if p)
        w, x = list(w), list(x)
        self.seven(None, CROSSED, f, g, w, x)
        self.seven(None, CROSSED, g, f, x, w)
        self.seven(None, CROSSED, f, g, [c << 3000 for c in w], [3 * c for c in x])
        self.seven("I7", CROSSED, f, g, [w[0] + 1] + w[1:], x)
        self.seven("I7", CROSSED, f, g, w, x[:2] + [x[2] + (1 << 2000)])
        self.seven("I7", CROSSED, f, g, [0, 0, 0], x)
        self.seven("I7", CROSSED, f, g, w, [0, 0, 0])
        self.seven("I7", CROSSED, f, g, [0, 0, 0], [0, 0, 0])
        self.seven("I7", CROSSED, f, f, w, w)
        # Neighbours meet in their common edge only; a common corner does not count.
        self.seven("I7", TET, 0, 1, [1, 0, 0], [1, 0, 0])
        self.seven("I7", TET, 0, 1, [1, 0, 1], [1, 1, 0])
        # A vertex in the middle of a triangle, and one of a triangle folded onto its neighbour.
        fold = ([(0, 0, 0), (4, 0, 0), (0, 4, 0), (1, 1, 0), (9, 9, 9)],
                [(0, 1, 2), (0, 1, 3), (3, 4, 2)])
        self.seven(None, fold, 1, 0, [0, 0, 1], [2, 1, 1])
        self.seven(None, fold, 2, 0, [1, 0, 0], [2, 1, 1])
        self.seven(None, fold, 0, 1, [2, 1, 1], [0, 0, 1])
        self.seven("I7", fold, 1, 0, [0, 0, 1], [1, 1, 1])
        # Degenerate triangles are the business of M1.
        flat = (fold[0] + [(2, 0, 0)], fold[1] + [(0, 1, 5), (1, 1, 4)])
        self.seven("I7", flat, 3, 1, [0, 0, 1], [1, 1, 0])
        self.seven("I7", flat, 1, 3, [1, 1, 0], [0, 0, 1])
        self.seven("I7", flat, 0, 4, [0, 1, 0], [1, 0, 0])

    def test_I7_far_and_near(self):
        """Coordinates of very different size, and of both signs."""
        for e in (1, 2.0 ** -60, 2.0 ** -600, 5e-324, 1e300):
            for s in (1, -1):
                mesh = ([(-3 * s, -1, -e), (5 * s, -2, -e), (s, 7, -e), (s, 1, -e), (s, 1, e), (2 * s, 1, e)],
                        [(0, 1, 2), (3, 4, 5)])
                model = model_of(mesh)
                found = rp.meeting_point(model, 0, 1)
                self.assertIsNotNone(found)
                self.seven(None, mesh, 0, 1, list(found[0]), list(found[1]))
                self.seven("I7", mesh, 0, 1, list(found[1]), list(found[0]))

    # PROVES MESH-9.M8: the witness holds on inward shells, and on no face of a solid (above).
    def test_I8_I9(self):
        for rule, condition in ((8, "I8"), (9, "I9")):
            self.check_one(None, turned(CUBE), rule, rp.u32(0) + b"\0")
            self.check_one(condition, CUBE, rule, rp.u32(0) + b"\0")
            # The first face of the cube is at x = 0: its normal has no part along y.
            self.check_one(condition, turned(CUBE), rule, rp.u32(0) + b"\1")
            nest = BROKEN[9]
            model = model_of(nest)
            self.assertNotEqual(rp.winding(model, 12, 0), 0)
            self.check_one(None, nest, rule, rp.u32(12) + b"\0")
            self.check_one(condition, nest, rule, rp.u32(0) + b"\0")
            # A triangle through P itself: not applicable.
            touch = joined(turned(CUBE), ([(0, 0, 0), (0, 1, 0), (0, 0.75, 1.25)], [(0, 1, 2)]))
            model = model_of(touch)
            self.assertTrue(any(rp.stab(model, tuple(
                2 * a + b + c for a, b, c in zip(*(model.ints[v] for v in model.faces[f]))),
                12, 0, False)[1] == 0 for f in (0, 1)))
            found = [rp.winding(model, f, 0) for f in (0, 1)]
            for f in (0, 1):
                self.check_one(None if found[f] else condition, touch, rule, rp.u32(f) + b"\0")
            self.assertIn(0, found)

    def test_I10_rules(self):
        for rules in ("M1", "M1 M3", "M3 M4"):
            self.check_one("I10", OPEN, 3, rp.u32(1, 2), rules=rules)

    def test_conditions_come_in_order(self):
        model = model_of(OPEN)
        cert = rp.Invalid(model, [(1, rp.u32(0)), (3, rp.u32(0, 1))])
        self.rejects("I1", model, cert.encode())
        self.rejects("I1", model, cert.encode(rules="M7"))

    def test_work_of_many_witnesses_is_bounded(self):
        mesh = triangles(voxels({(x, y, 0) for x in range(12) for y in range(12)}))
        model = model_of(mesh)
        cert = rp.Invalid(model, [(8, rp.u32(0) + b"\0")] * 40000)
        code, out, _ = check(model.data, cert.encode())
        self.assertEqual(code, 1, out)

    def test_random_changes_never_crash(self):
        rng = random.Random(13)
        for mesh in BROKEN.values():
            model = model_of(mesh)
            cert = rp.Invalid(model, rp.find_witnesses(model))
            body = cert.body()
            for _ in range(40):
                bent = bytearray(body)
                for _ in range(rng.choice((1, 2, 5))):
                    bent[rng.randrange(len(bent))] = rng.choice((0, 1, 255, rng.randrange(256)))
                code, out, err = check(model.data, cert.encode(bytes(bent)))
                self.assertIn(code, (0, 1), out + err)


# ---- Refused models --------------------------------------------------------------------------

class Refuses(Case):
    def test_what_no_format_allows(self):
        for fmt, write in WRITERS.values():
            good = write(TET)
            for start in (b"\xff\xfe", b"\xfe\xff", b"\0\0\xfe\xff", b"\xff\xfe\0\0", b"\x1f\x8b\x08",
                          b"PK\3\4", b"BZh9", b"\xfd7zXZ\0", b"\x28\xb5\x2f\xfd",
                          b"version https://git-lfs.github.com/spec/v1\n"):
                self.refuses(fmt, start + good)
            self.refuses(fmt, b"")

    def test_truncated_files(self):
        for name, (fmt, write) in WRITERS.items():
            good = write(TET)
            if name in ("stl binary, more", "stl binary, solid"):
                continue
            # Text formats: the last token may lose characters and still be one.
            binary = "binary" in name or "little" in name or "big" in name
            for n in range(0, len(good.rstrip()) - (1 if binary else 4), 3 if binary else 7):
                if fmt == "obj" and n > good.index(b"\nf" if b"\nf" in good else b"\rf"):
                    break  # an OBJ file does not say how long it is
                self.refuses(fmt, good[:n])

    def test_obj(self):
        v = b"v 0 0 0\nv 1 0 0\nv 0 1 0\n"
        for text in (b"v 0 0\nf 1 1 1", b"v 0 0 x\n" + v + b"f 1 2 3", b"v 0 0 nan\n" + v + b"f 1 2 3",
                     b"v 0 0 inf\n" + v + b"f 1 2 3", b"v 0 0 1e309\n" + v + b"f 1 2 3",
                     b"v 0 0 0x1\n" + v + b"f 1 2 3", b"v 0 0 1,5\n" + v + b"f 1 2 3",
                     b"v 0 0 1.5.5\n" + v + b"f 1 2 3", b"v 0 0 1e\n" + v + b"f 1 2 3",
                     b"v 0 0 .\n" + v + b"f 1 2 3", b"v 0 0 +\n" + v + b"f 1 2 3",
                     b"v 0 0 1e+\n" + v + b"f 1 2 3", b"v 0 0 --1\n" + v + b"f 1 2 3",
                     b"v 0 0\x001\n" + v + b"f 1 2 3", b"v 0 0 1d5\n" + v + b"f 1 2 3",
                     v, v + b"f 1 2", v + b"f", v + b"f 0 1 2", v + b"f 1 2 4", v + b"f 1 2 -4",
                     v + b"f 1 2 3x", v + b"f 1 2 /3", v + b"f 1 2 3.0", v + b"f 1 2 +", v + b"f 1 2 -",
                     v + b"f 1 2 99999999999999999999999", v + b"f 1 2 4294967299",
                     v + b"f 1 2 -4294967293", v + b"f 1 2 18446744073709551619",
                     b"f -1 -2 -3\n" + v, v + b"f 1 2\n3", v + b"f 1 2 #3", b"#" + v.replace(b"\n", b"\\\n")):
            self.refuses("obj", text)
        self.refuses("obj", v + b"f 1 2 77\n", "found '77'")

    def test_off(self):
        body = b"\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
        for text in (b"OOFF" + body, b"4OFF" + body, b"nOFF" + body, b"OFF BINARY" + body, b"NCOFF" + body,
                     b"off" + body, b"CSTOFF" + body, body, b"OFFX" + body, b"OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0",
                     b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n", b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3",
                     b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1", b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n2",
                     b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n-3 0 1 2", b"OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2",
                     b"OFF\n-3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2", b"OFF\n3 -1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2",
                     b"OFF\n3.0 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2", b"OFF\n3 1 0 0 0 0\n1 0 0\n0 1 0\n3 0 1 2",
                     b"OFF\n4000000000 1 0\n0 0 0", b"OFF\n99999999999999999999 1 0\n0 0 0",
                     b"OFF\n3 4000000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2",
                     b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2"):
            self.refuses("off", text)

    def test_stl(self):
        good = stl_text(TET)
        for old, new in ((b"endloop", b""), (b"endloop", b"vertex 1 1 1 endloop"), (b"loop", b"lop"),
                         (b"endfacet", b"endfacets"), (b"outer", b"outer outer"), (b"vertex", b"vertx"),
                         (b"endsolid", b""), (b"endsolid", b"endsolid\nstray"), (b"facet", b"facette"),
                         (b"endsolid", b"endsolid\nendsolid"), (b"0.0 1.0", b"0.0 nan"), (b"0.0 1.0", b"0.0"),
                         (b"0.0 1.0", b"0.0 inf"), (b"solid", b"solids")):
            self.assertIn(old, good)
            self.refuses("stl", good.replace(old, new, 1))
        self.refuses("stl", b"solid x\nendsolid x\n", "no triangle")
        self.refuses("stl", b"solid x")
        binary = bytearray(stl_binary(TET))
        for n in (5, 2 ** 31, 2 ** 32 - 1):
            self.refuses("stl", bytes(binary[:80]) + rp.u32(n) + bytes(binary[84:]), "too early")
        self.refuses("stl", bytes(binary[:80]) + rp.u32(0) + b"", "no triangle")
        for bits in (0x7f800000, 0xff800000, 0x7fc00000, 0x7f800001):
            self.refuses("stl", bytes(binary[:96]) + rp.u32(bits) + bytes(binary[100:]), "not finite")

    def test_ply(self):
        good = ply(TET)
        huge = b"element face 4000000000\n"
        for old, new in ((b"ply", b"PLY"), (b"ply", b" ply"), (b"ply", b"ply "), (b"ply", b"\nply"),
                         (b"format ascii 1.0", b"format ascii 1.1"), (b"format ascii 1.0", b"format ASCII 1.0"),
                         (b"format ascii 1.0", b"format binary 1.0"), (b"format ascii 1.0\n", b""),
                         (b"format ascii 1.0", b"comment\nformat ascii 1.0"), (b"1.0\n", b"1.0\r\n"),
                         (b"1.0\n", b"1.0\nformat ascii 1.0\n"), (b"comment x", b"komment x"),
                         (b"element vertex 4", b"element vertex"), (b"element vertex 4", b"element vertex -4"),
                         (b"element vertex 4", b"element vertex 4 4"), (b"element vertex 4", b"element vertex four"),
                         (b"element vertex 4", b"element vertex 5"), (b"element vertex 4", b"element point 4"),
                         (b"element vertex 4", b"element vertex 4000000000"), (b"element face 4\n", huge),
                         (b"element face 4\n", b"element face 999999999999999999999999\n"),
                         (b"element face 4\n", b"element face 0\n"), (b"element face", b"element faces"),
                         (b"property float x", b"property real x"), (b"property float x", b"property float"),
                         (b"property float x", b"property list uchar float x"), (b"float z", b"float w"),
                         (b"property float x", b"property float x\nproperty float x"),
                         (b"vertex_indices", b"vertex_list"), (b"list uchar int", b"list float int"),
                         (b"list uchar int", b"list uchar float"), (b"list uchar int", b"list uchar long"),
                         (b"list uchar int", b"int"), (b"vertex_indices", b"vertex_indices x"),
                         (b"end_header", b"end_headers"), (b"end_header\n", b""),
                         (b"vertex_indices\n", b"vertex_indices\nproperty list uchar int vertex_index\n"),
                         (b"end_header", b"element face 0\nproperty list uchar int vertex_index\nend_header"),
                         (b"end_header", b"element vertex 0\nend_header"), (b"comment x", b"property int q"),
                         (b"3 1 2 3", b"3 1 2 4"), (b"3 1 2 3", b"3 1 2 -1"), (b"3 1 2 3", b"2 1 2"),
                         (b"3 1 2 3", b"3.0 1 2 3"), (b"3 1 2 3", b"3 1 2 3.0"), (b"3 1 2 3", b"-3 1 2 3"),
                         (b"3 1 2 3", b"4000000000 1 2 3"), (b"0.0 1.0", b"0.0 nan"), (b"0.0 1.0", b"0.0 1e999")):
            self.assertIn(old, good)
            self.refuses("ply", good.replace(old, new, 1))
        for kind in ("little", "big"):
            write = WRITERS["ply " + kind][1]
            data = write(TET)
            at = data.index(b"end_header\n") + 11
            real = 4 if kind == "little" else 8
            for bits in (b"\xff" * real, b"\x00\x00\xc0\x7f" if real == 4 else b"\x7f\xf0" + b"\0" * 6):
                self.refuses("ply", data[:at] + bits + data[at + real:], "not finite")
            face = at + 4 * 3 * real
            self.refuses("ply", data[:face] + b"\x02" + data[face + 1:])
            self.refuses("ply", data[:face] + b"\xff" + data[face + 1:])
        data = WRITERS["ply little"][1](TET)
        self.refuses("ply", data.replace(b"list uchar", b"list char").replace(b"\x03\0\0\0\0", b"\xfd\0\0\0\0"))
        for index in (4, -1, -2, 2 ** 31 - 1):
            bent = data[:-4] + struct.pack("<i", index)
            self.refuses("ply", bent, "out of range")
        none = b"ply\nformat ascii 1.0\nelement nothing 1000000000000\nend_header\n"
        self.refuses("ply", none)
        lots = data.replace(b"element face", b"element nothing 1000000000000000000\nelement face")
        model = rp.Model(data, "ply")
        model.data = lots
        self.accepts(model, rp.prove_valid(model).encode())  # it has no properties, so no bytes

    def test_ply_headers_of_other_words(self):
        good = ply(TET)
        for old, new in ((b"format ascii 1.0", b"version ascii 1.0"), (b"comment x", b"element list of four words"),
                         (b"comment x", b"property set of four words"), (b"comment x", b"scalar float q"), (b"float x", b"list uchar char q"),
                         (b"end_header", b"element tristrips 0\nend_header"),
                         (b"end_header", b"element tristrips 0\nproperty int q\nend_header"),
                         (b"end_header", b"element tristrips 0\nproperty list int int vertex_indices\n"
                                         b"property list int int vertex_index\nend_header"),
                         (b"comment x", b"comment x\r"), (b"comment x", b"comment\rx")):
            self.assertIn(old, good)
            self.refuses("ply", good.replace(old, new, 1))

    def test_exponents_are_digits(self):
        v = b"v 0 0 0\nv 1 0 0\nv 0 1 %s\nf 1 2 3\n"
        for number in (b"1e5x", b"1e5/", b"1e-5.", b"1e5.5", b"1e:", b"1e-/"):
            self.refuses("obj", v % number)

    def test_strips(self):
        head = ("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
                "end_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n")
        for strip in ("2 0 1", "3 0 1 -1", "3 0 0 1", "4 0 1 2 4", "4 0 1 2 -2", "2 0 9", "-1", "0",
                      "7 0 1 -1 1 2 -1 3"):
            self.refuses("ply", (head + strip).encode())


# ---- Real models -----------------------------------------------------------------------------

class RealModels(Case):
    @classmethod
    def setUpClass(cls):
        manifest = os.path.join(DATA, "mesh", "MANIFEST.tsv")
        if not os.path.exists(manifest):
            raise unittest.SkipTest("no real models: set VERITOPE_DATA")
        with open(manifest, encoding="utf-8") as file:
            names = file.readline().rstrip("\n").split("\t")
            cls.rows = [dict(zip(names, line.rstrip("\n").split("\t"))) for line in file]

    def path(self, row):
        return os.path.join(DATA, "mesh", row["file"])

    def fmt(self, row):
        return row["format"][:3]

    def test_malformed_ones_are_refused(self):
        rows = [r for r in self.rows if r["class"] == "malformed"]
        self.assertGreater(len(rows), 30)
        for row in rows:
            with self.subTest(file=row["file"]), open(self.path(row), "rb") as file:
                self.refuses(self.fmt(row), file.read())

    def test_small_solids_are_accepted(self):
        rows = [r for r in self.rows if r["class"] in ("solid1", "solidN") and int(r["triangles"]) <= 500]
        self.assertGreater(len(rows), 15)
        for row in rows:
            with self.subTest(file=row["file"]):
                model = rp.load(self.path(row), self.fmt(row))
                cert = rp.prove_valid(model)
                self.assertEqual(cert.quantities["genus"], int(row["genus"]))
                self.accepts(model, cert.encode(), "%s shells" % row["shells"],
                             "%s genus" % row["genus"])

    def test_small_broken_ones_are_rejected_and_their_witnesses_accepted(self):
        done = 0
        for row in self.rows:
            if row["valid_solid"] != "0" or row["class"] == "malformed" or int(row["triangles"]) > 300:
                continue
            with self.subTest(file=row["file"]):
                model = rp.load(self.path(row), self.fmt(row))
                witnesses = rp.find_witnesses(model)
                self.assertTrue(witnesses)
                self.accepts(model, rp.Invalid(model, witnesses).encode())
                code, out, err = check(model.data, rp.prove_valid(model).encode())
                self.assertEqual(code, 1, out + err)
                rules = {w[0] for w in witnesses}
                named = out.split(":")[0].split()[1]
                expected = {"V3": {1}, "V4": {3, 4, 5}, "V5": {2}, "V6": {6}, "V9": {7}, "V10": {8}}
                self.assertTrue(rules & expected[named], out + str(rules))
                done += 1
        self.assertGreater(done, 20)


if __name__ == "__main__":
    unittest.main()
