#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope dms: values of simplex-spline solids beside fractions, models over domains, refusals; info and convert of files .vdms, the page
and the schema of the format."""
import copy
import json
import math
import pathlib
import random
import re
import sys
import unittest
import xml.etree.ElementTree
from fractions import Fraction as F

import schema
from support import MODELS, ROOT, Folder, run

sys.path[:0] = [str(ROOT / "tests" / "support")]
import dms_defective                                      # noqa: E402

DOMAIN, TETRAHEDRON = MODELS / "dms" / "domain.vdms", MODELS / "dms" / "tetrahedron.vdms"


def fractions(texts):
    return [F(t) for t in texts]


def bernstein(model, u):
    """The value of a model with collapsed clouds whose only tetrahedron is the unit one: x, y, z and the attributes at u, by the definition."""
    lam = [1 - sum(u), *u]
    total = [F(0)] * len(model["control"][0]["value"])
    for entry in model["control"]:
        weight, left = F(1), model["degree"]
        for m in range(4):
            for i in range(entry["at"].count(m)):
                weight *= lam[m] * F(left, i + 1)
                left -= 1
        for c, text in enumerate(entry["value"]):
            total[c] += weight * F(text)
    return total


class Dms(Folder):
    def evaluate(self, model, points, *options, status=0):
        done = run("dms", "eval", model, "-", *options, "--json", "-", input="".join(p + "\n" for p in points), cwd=self.folder)
        self.assertEqual(done.returncode, status, done)
        document = json.loads(done.stdout)
        self.assertEqual(schema.faults(document), [])
        self.assertEqual(list(document), schema.keys_of("dms_eval"))
        return document

    def make(self, *options, domain=DOMAIN, name="m.vdms"):
        done = run("dms", "make", domain, "-o", name, *options, cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""), done)
        return self.folder / name, done.stdout

    def test_the_page_shows_what_the_program_prints(self):
        (self.folder / "domain.vdms").write_bytes(DOMAIN.read_bytes())
        page = (ROOT / "docs" / "cli" / "dms.md").read_text()
        block = page.split("```\n")[1]
        self.assertTrue(block.startswith("$ "))
        for part in re.split(r"(?m)^\$ ", block)[1:]:
            command, answer = part.split("\n", 1)
            words = command.split()
            given = None
            if words[0] == "echo":
                given = " ".join(words[1:words.index("|")]) + "\n"
                words = words[words.index("|") + 1:]
            self.assertEqual(words[0], "veritope")
            done = run(*words[1:], **({"input": given} if given else {}), cwd=self.folder)
            self.assertEqual((done.returncode, done.stdout), (0, answer), command)

    def test_values_of_a_collapsed_tetrahedron_are_bernsteins(self):
        model = json.loads(TETRAHEDRON.read_text())
        model["vertices"] = [cloud[:1] for cloud in model["vertices"]]
        path = self.folder / "collapsed.vdms"
        path.write_text(json.dumps(model))
        points = ["0 0 0", "1 0 0", "0 1 0", "0 0 1", "1/3 1/3 1/3", "1/5 0.25 0x1p-3", "1/2 0 0", "0 1/3 2/3", "1/7 1/7 1/7"]
        answer = self.evaluate(path, points, "--exact", "--gradient")
        self.assertEqual((answer["degree"], answer["attributes"]), (2, ["density"]))
        for text, point in zip(points, answer["points"]):
            u = [F(t) if "x" not in t else F(float.fromhex(t)) for t in text.split()]
            self.assertEqual(fractions(point["exact"]), bernstein(model, u), text)
            self.assertEqual(point["tetrahedron"], 0)
            step = F(1, 3)  # quadratic: the central difference is exact
            for axis in range(3):
                up, down = ([c + s * step * (i == axis) for i, c in enumerate(u)] for s in (1, -1))
                slope = [(a - b) / (2 * step) for a, b in zip(bernstein(model, up), bernstein(model, down))]
                self.assertEqual([F(row[axis]) for row in point["gradient"]], slope, text)

    def test_enclosures_contain_the_exact_values_and_are_narrow(self):
        model, _ = self.make("--degree", "3", "--clouds", "0.1:5", "--control", "edges")
        points = ["1/4 1/4 1/4", "1/3 1/5 1/7", "0 0 0", "1/3 1/3 1/3", "1e-9 0.5 0.25"]
        exact = self.evaluate(model, points, "--exact", "--gradient")["points"]
        for e, d in zip(exact, self.evaluate(model, points, "--gradient")["points"]):
            self.assertEqual((d["exact"], d["gradient"], e["lo"], e["hi"], e["gradient_lo"], e["gradient_hi"]), (None,) * 6)
            self.assertEqual(d["tetrahedron"], e["tetrahedron"])
            for value, lo, hi in zip(fractions(e["exact"]), d["lo"], d["hi"]):
                self.assertTrue(F(lo) <= value <= F(hi) and F(hi) - F(lo) <= F(1, 10**12))
            for row, lows, highs in zip(e["gradient"], d["gradient_lo"], d["gradient_hi"]):
                for value, lo, hi in zip(fractions(row), lows, highs):
                    self.assertTrue(F(lo) <= value <= F(hi))

    def test_enclosures_of_many_points_hold_and_are_narrow(self):
        rng = random.Random(5)
        points = []
        for i in range(90):
            parts = [rng.randint(1, 99) for _ in range(4)]
            corner = rng.choice("012") if i % 9 == 0 else ""  # on a face of the domain
            at = [F(0) if corner == str(axis) else F(parts[axis], sum(parts)) for axis in range(3)]
            points.append(" ".join((str(float(c)), "%.7f" % c, str(c))[i % 3] for c in at))
        points += ["0 0 0", "1/4 1/4 1/4", "0.25 0.25 0.25", "2 0 0", "0 0 -1e-300"]
        for degree in "1", "2", "3", "4":
            model, _ = self.make("--degree", degree, "--clouds", "0.1:5", "--control", "edges")
            document = json.loads(model.read_text())
            greatest = [max(abs(F(e["value"][c])) for e in document["control"]) for c in range(len(document["control"][0]["value"]))]
            exact = self.evaluate(model, points, "--exact", "--gradient")["points"]
            enclosed = self.evaluate(model, points, "--gradient")["points"]
            lines = run("dms", "eval", model, "-", input="".join(p + "\n" for p in points), cwd=self.folder).stdout.splitlines()
            self.assertEqual((len(enclosed), len(lines)), (len(points), len(points)))
            wide = 0
            for text, line, e, d in zip(points, lines, exact, enclosed):
                self.assertEqual(d["tetrahedron"], e["tetrahedron"], text)
                if e["tetrahedron"] is None:
                    self.assertEqual((line, set(d.values())), ("outside", {None}))
                    continue
                numbers = [float(t) for t in line.split()]
                for most, value, lo, hi, number in zip(greatest, fractions(e["exact"]), d["lo"], d["hi"], numbers):
                    self.assertTrue(F(lo) <= value <= F(hi), (text, value, lo, hi))
                    self.assertLessEqual(F(hi) - F(lo), most / 10**12)
                    self.assertLessEqual(abs(F(number) - value), most / (2 * 10**12))
                    self.assertRegex(line.split()[0], r"^-?[0-9]\.[0-9]{16}e[-+][0-9]{2}$")
                    wide += F(hi) - F(lo) > F(math.ulp(number)) * 4
                for most, row, lows, highs in zip(greatest, e["gradient"], d["gradient_lo"], d["gradient_hi"]):
                    for value, lo, hi in zip(fractions(row), lows, highs):
                        self.assertTrue(F(lo) <= value <= F(hi), (text, value, lo, hi))
                        self.assertLessEqual(F(hi) - F(lo), max(most / 10**12, 4 * F(math.ulp(hi))))
            if int(degree) < 4:  # most points did not take the exact way
                self.assertGreater(wide, 90)

    def test_points_outside_have_no_values(self):
        model, _ = self.make("--degree", "2")
        for options in ((), ("--exact",), ("--exact", "--gradient")):
            inside, outside = self.evaluate(model, ["0 0 0", "0 0 -1e-300"], *options)["points"]
            self.assertEqual(set(outside.values()), {None})
            self.assertIsNotNone(inside["tetrahedron"])
        done = run("dms", "eval", model, "-", input="# a comment\n\n0 0 0\n2 0 0\n", cwd=self.folder)
        self.assertEqual(done.stdout.split("\n"), [" ".join(["0.0000000000000000e+00"] * 3), "outside", ""])

    def test_values_beyond_binary64_are_infinite(self):
        far = [[0, 0, 0], ["1e400", 0, 0], [0, "-1e400", 0], [0, 0, "1e400"]]
        points = [list(map(str, p)) for p in far]
        (self.folder / "far.vdms").write_text(json.dumps({
            "format": "veritope-dms-1", "degree": 1, "attributes": ["a"], "vertices": [[p] for p in points], "tetrahedra": [[0, 2, 1, 3]],
            "control": [{"at": [m], "value": p + ["1"]} for m, p in enumerate(points)]}))
        done = run("dms", "eval", "far.vdms", "-", input="2e399 -3e399 1\n", cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout), (0, "inf -inf 1.0000000000000000e+00 1.0000000000000000e+00\n"))
        point, = self.evaluate("far.vdms", ["2e399 -3e399 1"])["points"]
        self.assertEqual((point["lo"], point["hi"]), ([None, None, 1, 1],) * 2)

    def test_made_models_are_the_identity(self):
        points = ["1/4 1/4 1/4", "1/3 1/5 1/7", "0 0 0", "1 0 0", "1/3 1/3 1/3", "1/2 1/2 0", "1e-9 0.5 0.25"]
        for degree in "1", "2", "4":
            for clouds in "collapsed", "0.1:5", "1/20", "3:1":
                model, said = self.make("--degree", degree, "--clouds", clouds)
                self.assertRegex(said, f"^wrote  m.vdms  degree {degree}, 4 tetrahedra, [0-9]+ knots, [0-9]+ control points\\n$")
                for text, point in zip(points, self.evaluate(model, points, "--exact", "--gradient")["points"]):
                    self.assertEqual(fractions(point["exact"]), [F(t) for t in text.split()])
                    self.assertEqual([fractions(row) for row in point["gradient"]], [[F(i == j) for j in range(3)] for i in range(3)])
        self.assertIn("deviation: control points lie up to 0.0", self.make("--degree", "3", "--clouds", "1/10:2", "--control", "edges")[1])
        self.assertIn("deviation: control points lie up to 0 ", self.make("--degree", "3", "--control", "edges")[1])
        same = [self.make("--degree", "3", "--clouds", "1/10:" + seed)[0].read_bytes() for seed in ("1", "1", "2")]
        self.assertEqual(same[0], same[1])
        self.assertNotEqual(same[0], same[2])

    def test_models_with_defects_are_refused(self):
        for change, code in (((0, [1, 4, 2, 3]), "tet-reversed"), ((3, [0, 1, 2, 3]), "tet-face-overused")):
            model = json.loads(DOMAIN.read_text())
            model["tetrahedra"][change[0]] = change[1]
            (self.folder / "bad.vdms").write_text(json.dumps(model))
            document = self.evaluate("bad.vdms", ["0 0 0"], status=1)
            self.assertIn(code, [d["code"] for d in document["defects"]])
            self.assertEqual(document["points"], [])
            done = run("dms", "make", "bad.vdms", "-o", "x.vdms", "--degree", "2", cwd=self.folder)
            self.assertEqual(done.returncode, 1)
            self.assertIn("the domain has defects: " + code + ":", " ".join(done.stderr.split()))
        model = json.loads(TETRAHEDRON.read_text())
        model["vertices"][3].append(["0", "0", "-1"])
        (self.folder / "bad.vdms").write_text(json.dumps(model))
        document = self.evaluate("bad.vdms", ["0 0 0"], status=1)
        self.assertEqual([(d["code"], d["tetrahedra"], d["beta"]) for d in document["defects"]], [("cloud-degenerate", [0], [0, 0, 0, 1]), ("cloud-inside", [0, 0], [0, 0, 0, 1])])
        done = run("dms", "eval", "bad.vdms", "-", input="0 0 0\n", cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("bad.vdms: cloud-degenerate: tetrahedron 0, beta (0,0,0,1): d < 0", " ".join(done.stderr.split()))

    def test_wrong_files_have_their_place(self):
        for text, words in (("0 0\n", "standard input:1: column 4: a point has three coordinates"), ("0 0 nan\n", "standard input:1"),
                            ("0 0 0\n0 0 0 0\n", "standard input:2")):
            done = run("dms", "eval", DOMAIN, "-", input=text)
            self.assertEqual(done.returncode, 4, done)
            self.assertIn(words, done.stderr)
        self.assertEqual(run("dms", "eval", "nothing.vdms", "-", input="").returncode, 4)
        self.assertEqual(run("dms", "eval", MODELS / "m3_crack.stl", "-", input="").returncode, 4)
        (self.folder / "short.vdms").write_bytes(DOMAIN.read_bytes()[:-40])
        done = run("dms", "make", "short.vdms", "-o", "x.vdms", "--degree", "2", cwd=self.folder)
        self.assertEqual(done.returncode, 4)
        self.assertIn("line 20", done.stderr)
        self.assertFalse((self.folder / "x.vdms").exists())

    def test_a_model_that_is_none_is_a_fault_of_the_file_for_every_verb(self):
        def changed(change):
            model = json.loads(TETRAHEDRON.read_text())
            change(model)
            return model

        (self.folder / "s.json").write_text("[]")
        for change in (lambda m: m.update(degree=0), lambda m: m["control"].pop(), lambda m: m["control"].append(m["control"][0]),
                       lambda m: m["vertices"].__setitem__(0, []), lambda m: m["tetrahedra"].__setitem__(0, [0, 0, 1, 2])):
            (self.folder / "bad.vdms").write_text(json.dumps(changed(change)))
            for verb in (("eval", "bad.vdms", "-"), ("make", "bad.vdms", "-o", "x.vdms", "--degree", "2"), ("boundary", "bad.vdms", "-o", "x.vjson"),
                         ("edit", "bad.vdms", "s.json", "-o", "x.vdms"), ("refine", "bad.vdms", "--at", "1/4,1/4,1/4", "-o", "x.vdms")):
                done = run("dms", *verb, input="0 0 0\n", cwd=self.folder)
                self.assertEqual(done.returncode, 4, done)
                self.assertRegex(" ".join(done.stderr.split()), r"bad\.vdms: line 1")

    def test_standard_input_is_a_model_and_standard_output_has_one_document(self):
        done = run("dms", "make", "-", "-o", "-", "--degree", "2", input=DOMAIN.read_text(), cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""), done)
        self.assertEqual(done.stdout, self.make("--degree", "2")[0].read_text())
        done = run("dms", "refine", DOMAIN, "--at", "1/4,1/4,1/5", "-o", "-", "--json", "-", cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout), (2, ""), done)
        self.assertIn("--output and --json would both write standard output", " ".join(done.stderr.split()))

    def test_help_of_verbs_fits_and_their_options_are_on_the_page(self):
        page = (ROOT / "docs" / "cli" / "dms.md").read_text()
        for verb in "eval", "make":
            done = run("dms", verb, "--help")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            lines = done.stdout.rstrip("\n").split("\n")
            self.assertLessEqual(len(lines), 25)
            self.assertLessEqual(max(map(len, lines)), 80)
            for option in set(re.findall(r"--[a-z-]+", done.stdout)) - {"--help"}:
                self.assertIn(option if not option.startswith("--max-") else "--max-...", page)

    def test_info_and_convert_know_the_files(self):
        document = json.loads(run("info", "--json", "-", TETRAHEDRON).stdout)
        self.assertEqual(schema.faults(document), [])
        file = document["files"][0]
        self.assertEqual(list(file), schema.keys_of("info_dms_file"))
        self.assertEqual((file["format"], file["degree"], file["attributes"], file["control"]), ("vdms", 2, ["density"], "shared"))
        self.assertEqual(file["counts"], {"vertices": 4, "knots": 7, "collapsed": 2, "tetrahedra": 1, "control_points": 10})
        said = run("info", TETRAHEDRON).stdout
        self.assertIn("domain       1 tetrahedron, 4 vertices, 7 knots, 2 clouds collapsed", said)
        self.assertIn("attributes   density", said)
        spaced = self.folder / "spaced.json"
        spaced.write_text(json.dumps(json.loads(TETRAHEDRON.read_text()), indent=1))
        done = run("convert", spaced, "o.vdms", "--format", "vdms", cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout), (0, "wrote  o.vdms  1 tetrahedron, nothing lost\n"), done)
        self.assertEqual((self.folder / "o.vdms").read_bytes(), TETRAHEDRON.read_bytes())
        done = run("convert", TETRAHEDRON, "-", "--to", "vdms")
        self.assertEqual(done.stdout, TETRAHEDRON.read_text())
        done = run("convert", TETRAHEDRON, "o.stl", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("does not end in vdms or vtu", " ".join(done.stderr.split()))

    def test_convert_writes_bezier_cells(self):
        done = run("convert", MODELS / "dms" / "inner_clouds.vdms", "o.vtu", cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""), done)
        self.assertRegex(done.stdout, "^wrote  o.vtu  [0-9]+ Bezier cells of 4 tetrahedra, a picture\n$")
        piece = xml.etree.ElementTree.parse(self.folder / "o.vtu").getroot().find("UnstructuredGrid/Piece")
        arrays = {a.get("Name"): a.text.split() for a in piece.iter("DataArray")}
        cells = int(piece.get("NumberOfCells"))
        self.assertEqual(set(arrays["types"]), {"78"})
        self.assertEqual(sorted(set(arrays["tetrahedron"])), ["0", "1", "2", "3"])
        self.assertEqual(len(arrays["tetrahedron"]), cells)
        self.assertEqual(arrays["offsets"], [str(10 * (i + 1)) for i in range(cells)])
        self.assertEqual(len(arrays["Points"]), 3 * int(piece.get("NumberOfPoints")))
        self.assertEqual(sorted(set(map(int, arrays["connectivity"]))), list(range(int(piece.get("NumberOfPoints")))))
        # A collapsed tetrahedron has its own control points, and its attribute beside them.
        done = run("convert", TETRAHEDRON, "-", "--to", "vtu")
        self.assertEqual((done.returncode, done.stderr), (0, ""), done)
        self.assertIn('Name="density"', done.stdout)

    def test_convert_to_cells_refuses_what_it_cannot_show(self):
        done = run("convert", MODELS / "dms" / "attribute_domain.vdms", "o.vtu", cwd=self.folder)
        self.assertEqual(done.returncode, 1, done)
        self.assertIn("it would lose something: 1 attribute over a domain of its own. --lossy", " ".join(done.stderr.split()))
        self.assertFalse((self.folder / "o.vtu").exists())
        done = run("convert", MODELS / "dms" / "attribute_domain.vdms", "o.vtu", "--lossy", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done)
        self.assertIn("lossy: 1 attribute over a domain of its own", " ".join(done.stdout.split()))
        for code, data in dms_defective.defective().items():
            if code in ("jacobian", "jacobian-zero", "meeting", "crossing", "covering"):
                continue
            (self.folder / "bad.vdms").write_bytes(data)
            done = run("convert", "bad.vdms", "bad.vtu", cwd=self.folder)
            self.assertEqual(done.returncode, 1, done)
            self.assertIn(f"bad.vdms: {code}: ", " ".join(done.stderr.split()))
            self.assertFalse((self.folder / "bad.vtu").exists())

    def test_certify_proves_a_solid_and_a_fold(self):
        folded = MODELS / "dms" / "folded.vdms"
        done = run("certify", TETRAHEDRON, folded, "--json", self.folder / "r.json")
        self.assertEqual(done.returncode, 1, done)
        self.assertIn("1 body, genus 0, volume about 0.166667 (checked)", done.stdout)
        self.assertIn("  proof        1 leaf, 4 patches of the surface", done.stdout)
        self.assertIn("jacobian: the determinant of the derivative is below 0 at (", " ".join(done.stdout.split()))
        document = json.loads((self.folder / "r.json").read_text())
        self.assertEqual(schema.faults(document), [])
        valid, bad = document["files"]
        self.assertEqual(list(valid), schema.keys_of("dms_file"))
        self.assertEqual((valid["verdict"], valid["shells"], valid["defects"], valid["reasons"]), ("VALID", [{"genus": 0}], [], []))
        self.assertEqual(valid["counts"], {"tetrahedra": 1, "control_points": 10, "degree": 2, "leaves": 1, "patches": 4, "faces": None, "bodies": 1,
                                           "defects": 0})
        self.assertTrue(valid["volume"]["lo"] <= 1 / 6 <= valid["volume"]["hi"], valid["volume"])
        self.assertEqual((bad["verdict"], bad["shells"], bad["volume"], bad["reasons"]), ("INVALID", [], None, []))
        (defect,) = bad["defects"]
        self.assertEqual((defect["code"], defect["tetrahedra"], defect["beta"], defect["other_parameter"]), ("jacobian", [0], None, None))
        self.assertLess(F(defect["value"]), 0)
        point = self.evaluate(folded, [" ".join(defect["parameter"])], "--exact", "--gradient")["points"][0]
        (a, b, c), (d, e, f), (g, h, i) = ([F(x) for x in row] for row in point["gradient"][:3])
        self.assertEqual(a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g), F(defect["value"]))

    def test_certify_proves_a_creased_surface_by_pairs_of_faces(self):
        done = run("certify", MODELS / "dms" / "outward_clouds.vdms", "--json", self.folder / "r.json")
        self.assertEqual(done.returncode, 0, done)
        self.assertIn("1 body, genus 0, volume about 0.999287 (checked)", done.stdout)
        self.assertIn("  proof        6 leaves, pairs of 12 faces of the surface", done.stdout)
        document = json.loads((self.folder / "r.json").read_text())
        self.assertEqual(schema.faults(document), [])
        found = document["files"][0]
        self.assertEqual((found["counts"]["faces"], found["counts"]["patches"]), (12, None))
        # The patches have the same volume, as a solid of their own.
        self.assertEqual(run("dms", "boundary", MODELS / "dms" / "outward_clouds.vdms", "-o", "b.vjson", cwd=self.folder).returncode, 0)
        self.assertEqual(run("certify", "b.vjson", "--json", "b.json", cwd=self.folder).returncode, 0)
        patches = json.loads((self.folder / "b.json").read_text())["files"][0]
        self.assertLess(abs(patches["volume"]["lo"] - found["volume"]["lo"]), 1e-9)

    def test_a_narrow_fold_where_clouds_reach_outward_is_found_by_samples(self):
        done = run("certify", MODELS / "dms" / "narrow_fold.vdms")
        self.assertEqual(done.returncode, 1, done)
        self.assertIn("jacobian: the determinant of the derivative is below 0 at (", " ".join(done.stdout.split()))
        self.assertIn("accepted by veritope-check", " ".join(done.stdout.split()))

    def test_a_body_inside_of_the_image_of_another_one_is_invalid(self):
        (self.folder / "nested.vdms").write_bytes(dms_defective.defective()["covering"])
        done = run("certify", "nested.vdms", "--json", "r.json", cwd=self.folder)
        self.assertEqual(done.returncode, 1, done)
        self.assertIn("accepted by veritope-check", " ".join(done.stdout.split()))
        document = json.loads((self.folder / "r.json").read_text())
        self.assertEqual(schema.faults(document), [])
        defect, = document["files"][0]["defects"]
        self.assertEqual((defect["code"], len(defect["tetrahedra"]), defect["other_parameter"]), ("patches-crossing", 2, None))
        self.assertEqual(len(defect["parameter"]), 3)

    def test_two_points_with_one_image_are_found_where_determinants_are_0(self):
        """z -> z^2 on the half plane x >= 0."""
        done = run("certify", MODELS / "dms" / "opposite_points.vdms")
        self.assertEqual(done.returncode, 1, done)
        self.assertIn("patches-touching: the points (0, -1/2, 0) and (0, 1/2, 0) of the domain have one image (checked)", " ".join(done.stdout.split()))

    def test_a_surface_that_nearly_folds_is_proved_by_pairs_of_faces(self):
        """Its ten patches would need 30,000 star boxes."""
        done = run("certify", MODELS / "dms" / "near_fold.vdms")
        self.assertEqual(done.returncode, 0, done)
        self.assertIn("1 body, genus 0, volume about 22.8934 (checked)", done.stdout)
        self.assertIn("  proof        11 leaves, pairs of 10 faces of the surface", done.stdout)

    def test_boxes_of_a_thin_slab_are_those_that_the_checker_accepts(self):
        done = run("certify", MODELS / "dms" / "thin_slab.vdms")
        self.assertEqual(done.returncode, 0, done)
        self.assertIn("1 body, genus 0, volume about 0.0342191 (checked)", done.stdout)

    def test_every_verb_refuses_domains_and_clouds_with_defects(self):
        for code, data in dms_defective.defective().items():
            if code in ("jacobian", "jacobian-zero", "meeting", "crossing", "covering"):
                continue
            (self.folder / "bad.vdms").write_bytes(data)
            document = self.evaluate("bad.vdms", ["1/4 1/4 1/4"], status=1)
            self.assertEqual((document["defects"][0]["code"], document["points"]), (code, []))

    @unittest.skipIf(schema.jsonschema is None, "python3-jsonschema is not installed")
    def test_files_obey_the_schema_and_the_schema_is_tight(self):
        of_dms = json.loads((ROOT / "docs" / "formats" / "dms.schema.json").read_text())
        of_splines = json.loads((ROOT / "docs" / "formats" / "spline.schema.json").read_text())
        validator = schema.jsonschema.Draft202012Validator(of_dms)
        validator.check_schema(of_dms)
        self.assertEqual(of_dms["$defs"]["number"], of_splines["$defs"]["number"])
        page = (ROOT / "docs" / "formats" / "dms-files.md").read_text()
        for text in TETRAHEDRON.read_text(), DOMAIN.read_text(), page.split("```json\n")[1].split("```")[0]:
            self.assertEqual([], [e.message for e in validator.iter_errors(json.loads(text))])
            shown = self.folder / "shown.vdms"
            shown.write_text(text)
            self.assertEqual(run("convert", shown, "-", "--to", "vdms").stdout, text)
        document = json.loads(TETRAHEDRON.read_text())
        separate = copy.deepcopy(document)
        betas = [[i, j, k, 2 - i - j - k] for i in range(3) for j in range(3 - i) for k in range(3 - i - j)]
        separate["control"] = [{"tetrahedron": 0, "beta": b, "value": ["0"] * 4} for b in betas]
        self.assertEqual([], [e.message for e in validator.iter_errors(separate)])
        for place, value in ((["format"], "veritope-dms-2"), (["extra"], 0), (["degree"], 0), (["degree"], 10), (["degree"], "2"),
                             (["attributes"], ["a", "a"]), (["attributes"], [""]), (["vertices", 0], []), (["vertices", 0, 0], ["0", "0"]),
                             (["vertices", 0, 0, 0], 0), (["vertices", 0, 0, 0], "nan"), (["vertices"], []), (["tetrahedra"], []),
                             (["tetrahedra", 0], [0, 1, 2]), (["tetrahedra", 0], [0, 1, 2, 2]), (["tetrahedra", 0, 0], -1), (["control"], []),
                             (["control", 0, "at"], []), (["control", 0, "value"], ["0", "0"]), (["control", 0, "beta"], [2, 0, 0, 0])):
            broken = copy.deepcopy(document)
            part = broken
            for key in place[:-1]:
                part = part[key]
            part[place[-1]] = value
            self.assertFalse(validator.is_valid(broken), place)


if __name__ == "__main__":
    unittest.main()
