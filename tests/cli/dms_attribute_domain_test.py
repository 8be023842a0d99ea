#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Attribute domains of simplex-spline solids: values beside an evaluator in fractions that shares no code with the program, what each verb does
with them, certificates, and refusals."""
import copy
import json
import random
import sys
import unittest
from fractions import Fraction as F

import schema
from support import MODELS, ROOT, Folder, run

sys.path[:0] = [str(ROOT / "tests" / "support")]
import dms_files                                          # noqa: E402
import dms_oracle                                         # noqa: E402

MODEL, TETRAHEDRON = MODELS / "dms" / "attribute_domain.vdms", MODELS / "dms" / "tetrahedron.vdms"


def drawn(rng, degree, corners, tetrahedra, attributes, move=F(1, 30), separate=False):
    """An attribute domain over the unit tetrahedron with inner clouds collapsed and outer ones along the outward diagonals."""
    clouds = []
    for p in corners:
        knots = [p]
        if rng.random() < 0.6 and degree > 1 and p.count(0) >= 2:  # a corner of the unit tetrahedron
            out = [c - F(1, 4) for c in p]
            knots += [[c + step * move * o for c, o in zip(p, out)] for step in (rng.randint(0, 3) for _ in range(degree))]
        clouds.append([[str(c) for c in k] for k in knots])
    value = lambda: [str(F(rng.randint(-20, 20), rng.randint(1, 6))) for _ in attributes]     # noqa: E731
    if separate:
        control = [{"tetrahedron": t, "beta": list(b), "value": value()} for t in range(len(tetrahedra)) for b in dms_oracle.indices(degree)]
    else:
        keys = sorted({tuple(sorted(v for v, b in zip(t, beta) for _ in range(b))) for t in tetrahedra for beta in dms_oracle.indices(degree)})
        control = [{"at": list(k), "value": value()} for k in keys]
    return {"degree": degree, "attributes": attributes, "vertices": clouds, "tetrahedra": tetrahedra, "control": control}


H, Z, ONE = F(1, 2), F(0), F(1)
UNIT = [[Z, Z, Z], [ONE, Z, Z], [Z, ONE, Z], [Z, Z, ONE]]
DOMAINS = [
    (UNIT, [[0, 1, 2, 3]]),
    (UNIT + [[H, Z, Z]], [[0, 4, 2, 3], [4, 1, 2, 3]]),
    (UNIT + [[F(1, 4)] * 3], [[4, 1, 2, 3], [0, 4, 2, 3], [0, 1, 4, 3], [0, 1, 2, 4]]),
    (UNIT + [[F(1, 3), F(1, 3), Z]], [[4, 1, 2, 3], [0, 4, 2, 3], [0, 1, 4, 3]]),
]
POINTS = ["1/4 1/4 1/4", "1/2 0 0", "0 0 0", "1/3 1/3 0", "1/2 1/5 1/7", "1/3 1/3 1/3", "1/5 0.25 0x1p-3", "0 1 0", "1/2 1/4 1/4"]


def numbers(text):
    return [F(float.fromhex(t)) if "x" in t else F(t) for t in text.split()]


class AttributeDomain(Folder):
    def write(self, model, name="m.vdms"):
        (self.folder / name).write_text(json.dumps(model))
        return name

    def evaluate(self, model, points, *options, status=0):
        done = run("dms", "eval", model, "-", *options, "--json", "-", input="".join(p + "\n" for p in points), cwd=self.folder)
        self.assertEqual(done.returncode, status, done)
        document = json.loads(done.stdout)
        self.assertEqual(schema.faults(document), [])
        return document

    def drawn(self, seed):
        rng = random.Random(seed)
        model = json.loads(TETRAHEDRON.read_text())
        corners, tetrahedra = DOMAINS[seed % len(DOMAINS)]
        model["attribute_domain"] = drawn(rng, rng.randint(1, 3), corners, tetrahedra, ["heat", "load"], separate=seed % 3 == 0)
        return model

    def test_values_and_derivatives_are_those_of_both_splines(self):
        for seed in range(8):
            model = self.drawn(seed)
            rng = random.Random(seed + 100)
            points = [*POINTS]
            for _ in range(6):
                parts = [rng.randint(1, 9) for _ in range(4)]
                points.append(" ".join(str(F(p, sum(parts))) for p in parts[:3]))
            answer = self.evaluate(self.write(model), points, "--exact", "--gradient")
            self.assertEqual(answer["attributes"], ["density", "heat", "load"])
            for text, point in zip(points, answer["points"]):
                value, gradient = dms_oracle.values(model, numbers(text))
                self.assertEqual([F(x) for x in point["exact"]], value, (seed, text))
                self.assertEqual([[F(x) for x in row] for row in point["gradient"]], gradient, (seed, text))
                self.assertEqual(point["tetrahedron"], 0)

    def test_enclosures_contain_the_exact_values(self):
        model = self.write(self.drawn(5))
        points = POINTS + ["1/5 1/%d 1/4" % k for k in range(3, 40)] + ["2 0 0"]
        exact = self.evaluate(model, points, "--exact", "--gradient")["points"]
        for e, d in zip(exact, self.evaluate(model, points, "--gradient")["points"]):
            self.assertEqual(d["tetrahedron"], e["tetrahedron"])
            if e["exact"] is None:
                self.assertIsNone(d["lo"])
                continue
            self.assertEqual(len(d["lo"]), 6)
            for x, lo, hi in zip(e["exact"], d["lo"], d["hi"]):
                self.assertTrue(F(lo) <= F(x) <= F(hi))
            for row, lows, highs in zip(e["gradient"], d["gradient_lo"], d["gradient_hi"]):
                for x, lo, hi in zip(row, lows, highs):
                    self.assertTrue(F(lo) <= F(x) <= F(hi))
        self.assertIsNone(exact[-1]["exact"])

    def test_another_boundary_is_refused_with_a_point_of_one_alone(self):
        model = json.loads(MODEL.read_text())
        model["attribute_domain"]["vertices"][0][0][0] = "-1/1099511627776"
        name = self.write(model)
        document = self.evaluate(name, ["0 0 0"], status=1)
        (defect,) = document["defects"]
        self.assertEqual((defect["code"], document["points"]), ("domains-differ", []))
        x, y, z = (F(c) for c in defect["point"])
        on_unit = min(x, y, z, 1 - x - y - z) == 0
        self.assertEqual(defect["domain"], "geometry" if on_unit else "attributes")
        for verb in (("xray", name, "-", "--attribute", "heat"), ("iso", name, "--attribute", "heat", "--level", "1", "--within", "1", "-o", "f.off"),
                     ("refine", name, "--at", "1/4,1/5,1/6", "-o", "r.vdms"), ("boundary", name, "-o", "b.vjson"), ("edit", name, "s.json", "-o", "e.vdms")):
            (self.folder / "s.json").write_text("[]")
            done = run("dms", *verb, input="0 0 0 1 0 0\n", cwd=self.folder)
            self.assertEqual(done.returncode, 1, done)
            self.assertIn("domains-differ: the point (", done.stderr)
        done = run("certify", name, "--json", "-", cwd=self.folder)
        self.assertEqual(done.returncode, 3, done)
        (reason,) = json.loads(done.stdout)["files"][0]["reasons"]
        self.assertEqual(reason["code"], "not-covered")
        self.assertIn("domains-differ", reason["message"])

    def test_defects_of_the_attribute_domain_name_it(self):
        model = json.loads(MODEL.read_text())
        model["attribute_domain"]["tetrahedra"][1][:2] = [1, 4]
        document = self.evaluate(self.write(model), ["0 0 0"], status=1)
        self.assertEqual({d["domain"] for d in document["defects"]}, {"attributes"})
        self.assertEqual(document["defects"][0]["message"], "attribute domain: tetrahedron 1: d < 0")

    def test_files_are_rewritten_and_described(self):
        for seed in range(6):
            name = self.write(self.drawn(seed))
            for source, target in ((name, "a.vdms"), ("a.vdms", "b.vdms")):
                done = run("convert", source, target, cwd=self.folder)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
            text = (self.folder / "a.vdms").read_text()
            self.assertEqual(text, (self.folder / "b.vdms").read_text())
            self.assertEqual(dms_oracle.values(text, [F(1, 5)] * 3), dms_oracle.values(self.drawn(seed), [F(1, 5)] * 3))
        document = json.loads(run("info", MODEL, "--json", "-").stdout)
        self.assertEqual(schema.faults(document), [])
        own = document["files"][0]["attribute_domain"]
        self.assertEqual((own["degree"], own["attributes"], own["counts"]["tetrahedra"]), (1, ["heat"], 2))
        self.assertIsNone(json.loads(run("info", TETRAHEDRON, "--json", "-").stdout)["files"][0]["attribute_domain"])
        self.assertRegex(run("info", MODEL).stdout, r"attribute domain +2 tetrahedra, 5 vertices")

    def test_integrals_and_level_sets_are_of_the_attribute_domain(self):
        # heat is 1 at (1/2, 0, 0), 0 at the corners: along the edge a hat, with the integral 1/2.
        done = run("dms", "xray", MODEL, "-", "--attribute", "heat", "--json", "-", input="0 0 0 1 0 0\n", cwd=self.folder)
        self.assertEqual(json.loads(done.stdout)["segments"][0]["mean"], "1/2")
        done = run("dms", "iso", MODEL, "--attribute", "heat", "--level", "1/2", "--within", "1", "-o", "f.off", "--json", "-", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done)
        document = json.loads(done.stdout)
        self.assertEqual((document["certified"], document["components"], document["euler"]), (True, 1, 1))
        done = run("dms", "iso", MODEL, "--attribute", "heat", "--level", "1/2", "--within", "1", "-o", "g.off", "--space", "solid", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done)
        lines = [(self.folder / f).read_text().splitlines() for f in ("f.off", "g.off")]
        self.assertEqual(len(lines[0]), len(lines[1]))
        count, geometry = int(lines[0][1].split()[0]), json.loads(MODEL.read_text())
        for at, image in zip(*(part[2:2 + count] for part in lines)):
            value, _ = dms_oracle.values(geometry, [F(float(c)) for c in at.split()]) or (None, None)
            if value:
                for x, y in zip(value[:3], image.split()):
                    self.assertAlmostEqual(float(x), float(y), 12)
        done = run("dms", "iso", MODEL, "--attribute", "cold", "--level", "1", "--within", "1", "-o", "f.off", cwd=self.folder)
        self.assertIn("the attributes density, heat", done.stderr)

    def test_edits_and_refinement_keep_it(self):
        own = json.loads(MODEL.read_text())["attribute_domain"]
        for at in "1/4,1/5,1/6", "1/3,1/3,0", "1/2,0,0":
            done = run("dms", "refine", MODEL, "--at", at, "-o", "r.vdms", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done)
            self.assertEqual(json.loads((self.folder / "r.vdms").read_text())["attribute_domain"], own)
        (self.folder / "s.json").write_text('[{"move": "control", "at": [3,3], "by": ["0", "0", "1/8"]}]')
        done = run("dms", "edit", MODEL, "s.json", "-o", "e.vdms", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done)
        self.assertEqual(json.loads((self.folder / "e.vdms").read_text())["attribute_domain"], own)
        (self.folder / "s.json").write_text('[{"move": "coefficient", "at": [3,3], "attribute": "heat", "to": "1"}]')
        done = run("dms", "edit", MODEL, "s.json", "-o", "x.vdms", cwd=self.folder)
        self.assertEqual(done.returncode, 4, done)
        self.assertIn("has a domain of its own", done.stderr)
        (self.folder / "s.json").write_text('[{"move": "knot", "vertex": 3, "knot": 0, "by": ["0", "0", "1/8"]}]')
        done = run("dms", "edit", MODEL, "s.json", "-o", "x.vdms", cwd=self.folder)
        self.assertEqual(done.returncode, 1, done)
        self.assertIn("domains-differ", done.stderr)
        self.assertFalse((self.folder / "x.vdms").exists())

    def test_domains_of_make_and_fit_have_none(self):
        model = json.loads((MODELS / "dms" / "domain.vdms").read_text())
        model["attribute_domain"] = json.loads(MODEL.read_text())["attribute_domain"]
        name = self.write(model)
        (self.folder / "d.txt").write_text("1/4 1/4 1/4 1\n")
        for words in (("make", name, "-o", "x.vdms", "--degree", "2"), ("fit", "d.txt", "-o", "x.vdms", "--domain", name, "--degree", "2")):
            done = run("dms", *words, cwd=self.folder)
            self.assertEqual(done.returncode, 1, done)
            self.assertIn("must not have an attribute domain", done.stderr)

    def test_certificates_are_about_the_geometry(self):
        model = json.loads(dms_files.model(2, [[p] for p in UNIT], [[0, 1, 2, 3]]))
        alone = json.loads(run("certify", self.write(model), "--json", "-", cwd=self.folder).stdout)["files"][0]
        model["attribute_domain"] = json.loads(MODEL.read_text())["attribute_domain"]
        name = self.write(model)
        done = run("certify", name, "--certificate", "m.cert", "--json", "-", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done)
        with_own = json.loads(done.stdout)["files"][0]
        for key in "verdict", "counts", "shells", "volume":
            self.assertEqual(with_own[key], alone[key])
        # Folded at the vertex 1, whatever the attribute domain is.
        entry = next(c for c in model["control"] if c["at"] == [1, 1])
        entry["value"][0] = "-1"
        model["attribute_domain"]["tetrahedra"][0].reverse()
        done = run("certify", self.write(model), "--json", "-", cwd=self.folder)
        self.assertEqual(done.returncode, 1, done)
        self.assertEqual(json.loads(done.stdout)["files"][0]["defects"][0]["code"], "jacobian")


if __name__ == "__main__":
    unittest.main()
