# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope classify: answers of all kinds of points files, certificates that both checkers accept, statuses, outputs."""
import json
import os
import pathlib
import struct
import subprocess
import sys
import threading
import unittest
from fractions import Fraction

import schema
import support
from support import BIN, Folder, run

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import every_claim  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
CHECKER = ROOT / "verify" / "checker" / "veritope_check.py"

VERTICES = "".join(f"{i & 1} {i >> 1 & 1} {i >> 2}\n" for i in range(8))
FACES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)]


def off(faces):
    return f"OFF\n8 {len(faces)} 0\n" + VERTICES + "".join("%d %s\n" % (len(f), " ".join(map(str, f))) for f in faces)


POINTS = "x,y,z\n# comment\n\n0.5, 0.5, 0.5\n2 2 2\n1;1/2;0x1p-2\n0 0 0\n1/3 1/3 1/3\n"
ANSWERS = "0.5 0.5 0.5 in 1 0\n2 2 2 out 0 -\n1 1/2 0x1p-2 on - 0\n0 0 0 on - 0\n1/3 1/3 1/3 in 1 0\n"


def npy(rows, kind="<f8", shape=None):
    header = "{'descr': '%s', 'fortran_order': False, 'shape': %s, }" % (kind, shape or (len(rows), 3))
    header += " " * (-(len(header) + 11) % 64) + "\n"
    code = kind[0] + {"8": "d", "4": "f"}[kind[2]]
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode() + b"".join(struct.pack(code[0] + 3 * code[1], *r) for r in rows)


class Classify(Folder):
    def setUp(self):
        super().setUp()
        self.box = self.file("box.off", off(FACES))
        self.points = self.file("points.txt", POINTS)

    def file(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def answers(self, points, *options, model=None, status=0):
        done = run("classify", model or self.box, points, *options)
        self.assertEqual((done.returncode, done.stderr), (status, ""))
        return done.stdout

    def test_every_point_has_a_line_in_order(self):
        self.assertEqual(self.answers(self.points), ANSWERS)
        output = self.folder / "answers.txt"
        self.assertEqual(self.answers(self.points, "-o", output), "")
        self.assertEqual(output.read_text(), ANSWERS)
        for jobs in "1", "3":
            self.assertEqual(self.answers(self.points, "--jobs", jobs), ANSWERS)

    def test_decimals_are_rounded_or_exact(self):
        points = self.file("p.txt", "1.00000000000000000001 0.5 0.5\n0.1 0.5 1e-400\n")
        self.assertEqual([line.split()[3] for line in self.answers(points).splitlines()], ["on", "on"])
        exact = self.answers(points, "--decimals", "exact").splitlines()
        self.assertEqual([line.split()[3] for line in exact], ["out", "in"])

    def test_npy_files_are_points(self):
        rows = [(0.5, 0.5, 0.5), (2.0, 0.0, 0.0), (1.0, 0.5, 0.25)]
        want = "0x1p-1 0x1p-1 0x1p-1 in 1 0\n0x1p+1 0x0p+0 0x0p+0 out 0 -\n0x1p+0 0x1p-1 0x1p-2 on - 0\n"
        for kind in "<f8", "<f4", ">f8", ">f4":
            self.assertEqual(self.answers(self.file("p.npy", npy(rows, kind))), want)

    def test_certificates_are_accepted_by_both_checkers_and_lies_rejected(self):
        output, certificate = self.folder / "answers.txt", self.folder / "points.cert"
        report = json.loads(self.answers(self.points, "-o", output, "--certificate", certificate, "--json", "-"))
        self.assertEqual(schema.faults(report), [])
        self.assertEqual(report["counts"], {"points": 5, "in": 2, "on": 2, "out": 1, "undecided": 0})
        self.assertTrue(report["certificate"]["checked"])
        self.assertEqual(report["certificate"]["bytes"], certificate.stat().st_size)
        checkers = [BIN / "veritope-check"], [sys.executable, CHECKER]
        for checker in checkers:
            done = subprocess.run([*checker, self.box, certificate, output], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertTrue(done.stdout.startswith("ACCEPT points-1"))
            lie = self.file("lie.txt", ANSWERS.replace("out 0 -", "in 1 0"))
            self.assertEqual(subprocess.run([*checker, self.box, certificate, lie], capture_output=True).returncode, 1)
            self.assertEqual(subprocess.run([*checker, self.box, certificate], capture_output=True).returncode, 2)

    def test_winding_numbers_of_closed_meshes_that_are_not_valid(self):
        inside_out = self.file("turned.off", off([f[::-1] for f in FACES]))
        done = run("classify", inside_out, self.points)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("INVALID", done.stderr)
        output, certificate = self.folder / "answers.txt", self.folder / "points.cert"
        self.answers(self.points, "--winding", "-o", output, "--certificate", certificate, model=inside_out)
        self.assertEqual(output.read_text(), "0.5 0.5 0.5 - -1 -\n2 2 2 - 0 -\n1 1/2 0x1p-2 on - -\n0 0 0 on - -\n1/3 1/3 1/3 - -1 -\n")
        self.assertTrue(certificate.exists())
        opened = self.file("open.off", off(FACES[1:]))
        done = run("classify", opened, self.points, "--winding")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("not closed", done.stderr)

    def test_a_bad_point_is_named_and_no_file_is_left(self):
        output = self.folder / "answers.txt"
        for text, words in (("1 2 3\n1 2 x\n", "2: column 5: 'x'"), ("1 2\n", "1: column 4"), ("0 0 nan\n", "1: column 5: 'nan' is not finite")):
            points = self.file("bad.txt", text)
            done = run("classify", self.box, points, "-o", output)
            self.assertEqual(done.returncode, 4, done.stderr)
            self.assertIn(f"{points}:{words}", done.stderr)
            self.assertFalse(output.exists())
        for content, words in ((npy([(1, 2, 3)], shape=(2, 3)), "row 1 of 2"), (npy([(1, 2, float("nan"))]), "row 0, column 2 is not finite: nan"),
                               (npy([(1, 2, 3)]) + b"x", "bytes follow"), (npy([(1, 2, 3)], shape=(3,)), "(n, 3)")):
            done = run("classify", self.box, self.file("bad.npy", content), "-o", output)
            self.assertEqual(done.returncode, 4)
            self.assertIn(words, done.stderr)
            self.assertFalse(output.exists())
        done = run("classify", self.box, self.points, "-o", output, "--certificate", self.folder / "no" / "c")
        self.assertEqual((done.returncode, output.exists()), (4, False))     # tried before the work
        done = run("classify", self.box, "-", input=npy([(1, 2, 3)]), text=False)
        self.assertEqual(done.returncode, 4)
        self.assertIn(b"an .npy file is read from a regular file only", done.stderr.replace(b"\n", b" "))
        self.assertEqual(run("classify", self.box, self.folder / "none.txt").returncode, 4)
        self.assertEqual(run("classify", self.folder / "none.off", self.points).returncode, 4)

    def test_usage(self):
        for options in (("--certificate", "c"), ("--json", "-"), ("--decimals", "rounded"), ("-o", self.box), ("-o", self.points),
                        ("-o", "a", "--json", "a"), ("-o", "a", "--certificate", "a"), ("--certificate", "-", "-o", "a"),
                        ("-o", "/dev/null", "--certificate", "c"), ("-o", "a", "--certificate", "."),
                        ("--by", "literally"), ("--origin", "0,0,0"), ("--by", "normal", "--origin", "1,2"), ("--by", "normal", "--origin", "1,2,x"),
                        ("--by", "normal", "-o", "a", "--certificate", "c")):
            done = run("classify", self.box, self.points, *options, cwd=self.folder)
            self.assertEqual(done.returncode, 2, (options, done.stderr))
            self.assertEqual(done.stdout, "")
        pipe = ROOT / "examples" / "quarter_pipe.itd"
        done = run("classify", pipe, self.points)
        self.assertEqual((done.returncode, done.stdout.splitlines()[1]), (0, "2 2 2 out 0 -"))

    def test_points_of_curved_models(self):
        """A lens: two paraboloids z = +-(1 - x^2) (1 - y^2) over a square, which meet along its sides."""
        def sheet(sign):
            bump = (0, 2, 0)                                                 # 1 - x^2 on [-1, 1]
            rows = [[str((i - 1)), str((j - 1)), str(sign * bump[i] * bump[j])] for i in range(3) for j in range(3)]
            if sign < 0:                                                     # the other normal: axes exchanged
                rows = [rows[3 * j + i] for i in range(3) for j in range(3)]
            return {"kind": "surface", "group": None, "attributes": [],
                    "shape": {"degrees": [2, 2], "periodic": [False, False], "knots": [["-1"] * 3 + ["1"] * 3] * 2, "rational": False,
                              "components": 3, "points": rows}}
        walls = self.file("lens.vjson", json.dumps({"format": "veritope-spline-1", "groups": [], "entities": [sheet(1), sheet(-1)]}))
        points = self.file("lens.txt", "0 0 0.1\n0 0 1\n0 0 1.0000000000000000000001\n.5 .5 .5625\n1/3 0 8/9\n.1 .2 -.95\n")
        want = ["in 1 -", "on - -", "out 0 -", "on - -", "on - -", "in 1 -"]
        answers = self.answers(points, "--winding", model=walls).splitlines()
        self.assertEqual([line.split()[3:] for line in answers], [["-", "1", "-"] if w.startswith("in") else ["-", "0", "-"] if w.startswith("out") else w.split() for w in want])
        report = json.loads(run("classify", walls, points, "--winding", "-o", self.folder / "a.txt", "--json", "-").stdout)
        self.assertEqual(schema.faults(report), [])
        self.assertEqual((report["decimals"], report["counts"]["on"], report["counts"]["undecided"]), ("exact", 3, 0))
        opened = self.file("open.vjson", json.dumps({"format": "veritope-spline-1", "groups": [], "entities": [sheet(1)]}))
        for options in (), ("--winding",):
            done = run("classify", opened, points, *options)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertIn("open", done.stderr)
        done = run("classify", walls, points)                                # a sharp rim of zero thickness at its corners has no star boxes
        self.assertIn(done.returncode, (1, 3))

    def test_points_at_irrational_parameters_are_proved(self):
        """z = 1 + x y over x = g(u), y = g(v), g(t) = (t + 3 t^2 - 2 t^3) / 2: most rational points have irrational parameters."""
        g = [Fraction(0), Fraction(1, 6), Fraction(5, 6), Fraction(1)]

        def surface(degrees, points):
            return {"kind": "surface", "group": None, "attributes": [],
                    "shape": {"degrees": degrees, "periodic": [False, False], "knots": [["0"] * (n + 1) + ["1"] * (n + 1) for n in degrees],
                              "rational": False, "components": 3, "points": [[str(c) for c in p] for p in points]}}

        def wall(x, y):
            return surface([3, 1], [[x(t), y(t), z * (1 + x(t) * y(t))] for t in g for z in (0, 1)])
        entities = [surface([3, 3], [[x, y, 1 + x * y] for x in g for y in g]), surface([3, 3], [[y, x, 0] for x in g for y in g]),
                    wall(lambda t: t, lambda t: 0), wall(lambda t: 1, lambda t: t), wall(lambda t: 1 - t, lambda t: 1), wall(lambda t: 0, lambda t: 1 - t)]
        model = self.file("bent.vjson", json.dumps({"format": "veritope-spline-1", "groups": [], "entities": entities}))
        on = [(Fraction(x, 5), Fraction(y, 7)) for x in range(6) for y in range(8)] + [(Fraction(1, 3), Fraction(1, 3)), (Fraction(1, 3), Fraction(2, 3))]
        points = self.file("bent.txt", "".join(f"{x} {y} {1 + x * y}\n" for x, y in on) + "1/3 1/3 0\n1/3 1/3 10/9001\n1/3 1/5 2\n")
        answers, certificate = self.folder / "bent.ans", self.folder / "bent.cert"
        self.answers(points, "-o", answers, "--certificate", certificate, model=model)
        self.assertEqual([line.split()[3] for line in answers.read_text().splitlines()], ["on"] * (len(on) + 1) + ["in", "out"])
        for checker in [BIN / "veritope-check"], [sys.executable, CHECKER]:
            done = subprocess.run([*checker, model, certificate, answers], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def how(self, *options, model=None):
        """What the JSON report says of how the points were asked."""
        report = json.loads(run("classify", model or self.box, self.points, *options, "-o", self.folder / "a.txt", "--json", "-").stdout)
        self.assertEqual(schema.faults(report), [])
        return {key: report[key] for key in ("decimals", "by", "origin", "winding", "reversed")}

    def test_the_report_says_how_the_points_were_asked(self):
        plain = {"decimals": "nearest", "by": "service", "origin": None, "winding": False, "reversed": None}
        self.assertEqual(self.how(), plain)
        self.assertEqual(self.how("--winding", "--decimals", "exact"), plain | {"winding": True, "decimals": "exact"})
        self.assertEqual(self.how("--by", "normal"), plain | {"by": "normal", "origin": ["0/1", "0/1", "0/1"]})
        self.assertEqual(self.how("--by", "literal", "--origin", "1/3,-2,0.5"), plain | {"by": "literal", "origin": ["1/3", "-2/1", "1/2"]})
        taken = self.how("--by", "normal", "--origin", "auto")["origin"]
        self.assertEqual(len(taken), 3)

    def test_the_report_lists_what_orient_auto_reversed(self):
        mixed = self.file("mixed.off", off(FACES[:2] + [f[::-1] for f in FACES[2:4]] + FACES[4:]))
        reversed_ = self.how("--orient", "auto", model=mixed)["reversed"]
        (certified,) = json.loads(run("certify", "--orient", "auto", mixed, "--json", "-").stdout)["files"]
        self.assertEqual((reversed_["parts"], reversed_["total"]), ("faces", certified["reversed"]["faces"]))
        self.assertEqual(len(reversed_["first"]), reversed_["total"])
        self.assertIsNone(self.how("--orient", "auto")["reversed"])
        many = self.file("many.off", self.inside_out_grid())
        reversed_ = self.how("--orient", "auto", model=many)["reversed"]
        self.assertEqual((reversed_["total"], reversed_["first"]), (12 * 16, list(range(100))))

    @staticmethod
    def inside_out_grid(n=4):
        """The cube [0,n]^3 of triangles of the lattice, inside out."""
        numbers, faces = {}, []
        def corner(axis, side, a, b):
            at = [0, 0, 0]
            at[axis], at[(axis + 1) % 3], at[(axis + 2) % 3] = side, a, b
            return numbers.setdefault(tuple(at), len(numbers))
        for axis in range(3):
            for side in 0, n:
                for a in range(n):
                    for b in range(n):
                        q = [corner(axis, side, a + i, b + j) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
                        q = q[::-1] if side == n else q
                        faces += [(q[0], q[1], q[2]), (q[0], q[2], q[3])]
        lines = [" ".join(map(str, p)) for p in numbers] + ["3 " + " ".join(map(str, f)) for f in faces]
        return f"OFF\n{len(numbers)} {len(faces)} 0\n" + "\n".join(lines) + "\n"

    def test_points_of_flat_faces_at_parameters_of_a_high_degree(self):
        square = lambda n, points: {"kind": "surface", "group": None, "attributes": [], "shape": {
            "degrees": [n, n], "periodic": [False, False], "knots": [["0"] * (n + 1) + ["1"] * (n + 1)] * 2, "rational": False, "components": 3,
            "points": [[str(c) for c in p] for p in points]}}
        def end(z, n=7):                                                     # inner control points are moved in the plane
            pairs = ((a, b) if z else (b, a) for a in range(n + 1) for b in range(n + 1))
            moved = lambda a, b: Fraction(a, n) + (Fraction((3 * a + 5 * b) % 7 - 3, 20 * n) if 0 < min(a, b) and max(a, b) < n else 0)
            return square(n, [(moved(a, b), moved(b, a), z) for a, b in pairs])
        corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
        walls = [square(1, [(*a, 0), (*a, 1), (*b, 0), (*b, 1)]) for a, b in zip(corners, corners[1:] + corners[:1])]
        model = self.file("restless.vjson", json.dumps({"format": "veritope-spline-1", "groups": [], "entities": [end(0), end(1), *walls]}))
        points = self.file("p.txt", "1/3 2/5 1\n-1/10 2/5 1\n1/3 2/5 1.%s1\n" % ("0" * 800))
        words = lambda text: [line.split()[3] for line in text.splitlines()]
        self.assertEqual(words(self.answers(points, model=model)), ["on", "out", "out"])
        output, certificate = self.folder / "a.txt", self.folder / "c.cert"
        done = run("classify", model, points, "-o", output, "--certificate", certificate)
        self.assertEqual((done.returncode, words(output.read_text()), certificate.exists()), (3, ["on", "out", "out"], False))
        self.assertIn("parameters are not known", " ".join(done.stderr.split()))
        self.assertEqual(run("boolean", "A", f"A={model}", "-o", self.folder / "e.json").returncode, 0)
        report = json.loads(self.answers(points, "-o", output, "--certificate", certificate, "--json", "-", model=self.folder / "e.json"))
        self.assertEqual((report["certificate"]["uncovered"], report["certificate"]["checked"]), (1, True))

    def test_the_normal_chain_has_the_same_f_for_every_origin(self):
        pipe = ROOT / "examples" / "quarter_pipe.itd"
        points = self.file("many.txt", "".join(f"{x}/5 {y}/5 {z}/5\n" for x in range(-2, 12, 3) for y in range(-2, 12, 3) for z in range(-2, 12, 3)))
        for model in pipe, self.box:
            service = [line.split() for line in self.answers(points, model=model).splitlines()]
            for origin in "0,0,0", "1/3,2,-5", "100,-7,0x1p-3":
                chain = [line.split() for line in self.answers(points, "--by", "normal", "--origin", origin, model=model).splitlines()]
                for s, c in zip(service, chain, strict=True):
                    self.assertEqual((c[:3], c[3], c[5]), (s[:3], "-", "-"))
                    self.assertIn(c[4], ("wall",) if s[3] == "on" else (s[4],), (s, c, origin))
        self.assertIn("1 ", " ".join(s[4] + " " for s in service))

    def test_a_model_on_standard_input_has_certificates_too(self):
        output, certificate = self.folder / "answers.txt", self.folder / "points.cert"
        with open(self.box, "rb") as model:
            done = run("classify", "-", self.points, "--format", "off", "-o", output, "--certificate", certificate, stdin=model)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(subprocess.run([BIN / "veritope-check", self.box, certificate, output], capture_output=True).returncode, 0)

    def test_answers_are_written_though_they_need_more_work_than_checkers_may_spend(self):
        """Points in the middle of a thousand boxes, one inside the other, whose rays meet all of them."""
        vertices, faces = [], []
        for i in range(1200):
            faces += [[v + len(vertices) for v in (f if i % 2 == 0 else f[::-1])] for f in FACES]
            vertices += [[(-1, 1)[k >> a & 1] * (2000 - i) for a in range(3)] for k in range(8)]
        model = self.file("nest.off", f"OFF\n{len(vertices)} {len(faces)} 0\n" + "".join("%d %d %d\n" % tuple(v) for v in vertices)
                          + "".join("%d %s\n" % (len(f), " ".join(map(str, f))) for f in faces))
        points, output, certificate = self.file("mid.txt", "0.25 0.5 0.125\n" * 300), self.folder / "answers.txt", self.folder / "points.cert"
        done = run("classify", model, points, "-o", output, "--certificate", certificate)
        self.assertEqual(done.returncode, 3, done)
        self.assertIn(f"{model}: the points need more work than checkers may spend", done.stderr.replace("\n", " "))
        self.assertEqual(len(output.read_text().splitlines()), 300)
        self.assertFalse(certificate.exists())

    def test_polygons_of_irit_have_answers_without_a_certificate(self):
        square = "[POLYGON 4 [%d %d %d] [%d %d %d] [%d %d %d] [%d %d %d]]"
        corner = [(i & 1, i >> 1 & 1, i >> 2) for i in range(8)]
        model = self.file("box.itd", "[OBJECT A\n" + "\n".join(square % sum((corner[v] for v in f[::-1]), ()) for f in FACES) + "]\n")
        self.assertEqual(self.answers(self.points, model=model), ANSWERS)
        output, certificate = self.folder / "answers.txt", self.folder / "points.cert"
        done = run("classify", model, self.points, "-o", output, "--certificate", certificate)
        self.assertEqual((done.returncode, output.read_text(), certificate.exists()), (3, ANSWERS, False), done)
        self.assertIn("veritope convert writes them as a mesh", done.stderr.replace("\n", " "))

    def test_models_that_face_the_wrong_way_are_taken_reversed(self):
        output, certificate = self.folder / "answers.txt", self.folder / "points.cert"
        square = {"kind": "surface", "group": None, "attributes": [], "shape": {
            "degrees": [1, 1], "periodic": [False, False], "knots": [["0", "0", "1", "1"]] * 2, "rational": False, "components": 3}}
        def spline(faces):                                                   # corners (0,0), (0,1), (1,0), (1,1)
            entities = [square | {"shape": square["shape"] | {"points": [[str(v & 1), str(v >> 1 & 1), str(v >> 2)] for v in (f[0], f[3], f[1], f[2])]}}
                        for f in faces]
            return json.dumps({"format": "veritope-spline-1", "groups": [], "entities": entities})
        inside_out = [f[::-1] for f in FACES]
        for name, text in (("turned.off", off(inside_out)), ("mixed.off", off(FACES[:2] + inside_out[2:])),
                           ("turned.vjson", spline(inside_out)), ("mixed.vjson", spline(FACES[:2] + inside_out[2:]))):
            model = self.file(name, text)
            kept = run("classify", model, self.points)
            self.assertEqual((kept.returncode, kept.stdout), (1, ""), name)
            self.assertEqual(self.answers(self.points, "--orient", "auto", "--decimals", "exact", model=model), ANSWERS, name)
            done = run("classify", model, self.points, "--orient", "auto", "-o", output, "--certificate", certificate)
            self.assertEqual((done.returncode, output.read_text(), certificate.exists()), (3, ANSWERS, False), done)
            self.assertIn("faces of the file", done.stderr.replace("\n", " "))
        sound = self.answers(self.points, "--orient", "auto", "-o", output, "--certificate", certificate)
        self.assertEqual((sound, output.read_text(), certificate.exists()), ("", ANSWERS, True))

    def test_points_of_spline_models_have_certificates_in_every_format(self):
        output, certificate = self.folder / "answers.txt", self.folder / "points.cert"
        for name, (make, of_volumes) in every_claim.FORMATS.items():
            ending, text = make(of_volumes)
            model = self.file("cube" + ending, text)
            self.answers(self.points, "-o", output, "--certificate", certificate, model=model)
            self.assertEqual(output.read_text(), ANSWERS)
            self.assertIn(b'"subject_format":"%s"' % name.encode(), certificate.read_bytes())
            lie = self.file("lie.txt", ANSWERS.replace("out 0 -", "in 1 0"))
            for checker in [BIN / "veritope-check"], [sys.executable, CHECKER]:
                done = subprocess.run([*checker, model, certificate, output], capture_output=True, text=True)
                self.assertEqual((done.returncode, done.stdout[:15]), (0, "ACCEPT points-1"), done)
                self.assertEqual(subprocess.run([*checker, model, certificate, lie], capture_output=True).returncode, 1)
        with open(model, "rb") as stream:
            done = run("classify", "-", self.points, "--format", "mfem", "--winding", "-o", output, "--certificate", certificate, stdin=stream)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_curved_models(self):
        """A pipe, whose points are on it or beside it by very little."""
        model = ROOT / "examples" / "quarter_pipe.itd"
        points = self.file("near.txt", "0 0 0\n1 1 1\n2 0 1/2\n2.00000000000000000000000000000000000000000000001 0 1/2\n")
        output, certificate = self.folder / "answers.txt", self.folder / "points.cert"
        self.answers(points, "-o", output, "--certificate", certificate, model=model, status=0)
        for checker in [BIN / "veritope-check"], [sys.executable, CHECKER]:
            self.assertEqual(subprocess.run([*checker, model, certificate, output], capture_output=True).returncode, 0)

    def test_models_of_which_checkers_read_a_copy_have_answers_without_a_certificate(self):
        faces = [(0, 2, 1, 3), (4, 5, 6, 7), (0, 1, 4, 5), (2, 6, 3, 7), (0, 4, 2, 6), (1, 3, 5, 7)]
        basis = '<Basis type="BSplineBasis" index="%d"><KnotVector degree="1">0 0 1 1</KnotVector></Basis>'
        text = "<xml>" + "".join(
            '<Geometry type="TensorBSpline2" id="%d"><Basis type="TensorBSplineBasis2">%s%s</Basis><coefs geoDim="3">%s</coefs></Geometry>'
            % (i, basis % 0, basis % 1, " ".join("%d %d %d" % (v & 1, v >> 1 & 1, v >> 2) for v in face)) for i, face in enumerate(faces)) + "</xml>"
        model, output, certificate = self.file("cube.xml", text), self.folder / "answers.txt", self.folder / "points.cert"
        done = run("classify", model, self.points, "-o", output, "--certificate", certificate)
        self.assertEqual((done.returncode, output.read_text(), certificate.exists()), (3, ANSWERS, False), done)
        self.assertIn("the checkers do not read this file, but a copy; veritope convert writes it as .vjson", done.stderr.replace("\n", " "))

    def test_a_program_that_waits_gets_its_answers(self):
        with subprocess.Popen([BIN / "veritope", "classify", self.box, "-"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
            limit = threading.Timer(60, process.kill)      # a program that does not answer would wait for ever
            limit.start()
            self.addCleanup(limit.cancel)
            for point, word in (("0.5 0.5 0.5", "in"), ("3 3 3", "out"), ("1/3 1/3 0", "on")):
                process.stdin.write(point + "\n")
                process.stdin.flush()
                self.assertEqual(process.stdout.readline().split()[3], word)
            process.stdin.close()
            self.assertEqual(process.wait(), 0)

    def test_many_points_take_several_batches(self):
        n = 70000
        points = self.file("many.txt", "".join(f"{i % 7 / 4} 0.5 0.5\n" for i in range(n)))
        lines = self.answers(points).splitlines()
        self.assertEqual(len(lines), n)
        words = {0: "on", 1: "in", 2: "in", 3: "in", 4: "on", 5: "out", 6: "out"}
        self.assertTrue(all(line.split()[3] == words[i % 7] for i, line in enumerate(lines)))


if __name__ == "__main__":
    unittest.main()
