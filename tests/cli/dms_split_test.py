#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope dms refine on faces and edges: values before and after by an evaluator in fractions that shares no code with the program, bounds of
the change, and what --max-change refuses."""
import json
import random
import sys
import unittest
from fractions import Fraction as F

import schema
from support import MODELS, ROOT, Folder, run

sys.path[:0] = [str(ROOT / "tests" / "support")]
import dms_oracle                                         # noqa: E402

DOMAIN = MODELS / "dms" / "domain.vdms"
PLACES = (("1/2,0,0", "edge", 2), ("1/8,1/8,1/8", "edge", 3), ("1/3,1/3,0", "face", 1), ("5/12,5/12,1/12", "face", 2), ("1/3,1/3,1/12", "tetrahedron", 1))


class Splits(Folder):
    def model(self, clouds, degree, seed, control=True):
        """A model over four tetrahedra around (1/4, 1/4, 1/4) with drawn control points."""
        run("dms", "make", DOMAIN, "-o", "made.vdms", "--degree", str(degree), "--clouds", clouds, cwd=self.folder)
        model, rng = json.loads((self.folder / "made.vdms").read_text()), random.Random(seed)
        if control:
            model["attributes"] = ["a"]
            for entry in model["control"]:
                entry["value"] = [str(F(v) + F(rng.randint(-8, 8), 64)) for v in entry["value"]] + [str(rng.randint(-3, 3))]
        (self.folder / "m.vdms").write_text(json.dumps(model))
        return model

    def refine(self, at, *options, status=0):
        done = run("dms", "refine", "m.vdms", "--at", at, *options, "-o", "r.vdms", "--json", "-", cwd=self.folder)
        self.assertEqual(done.returncode, status, done)
        document = json.loads(done.stdout)
        self.assertEqual(schema.faults(document), [])
        self.assertEqual(list(document), schema.keys_of("dms_refine"))
        return document

    def points(self, at, seed):
        rng, out = random.Random(seed), [[F(c) for c in at.split(",")]]
        for _ in range(6):
            parts = [rng.randint(1, 9) for _ in range(4)]
            out.append([F(p, sum(parts)) for p in parts[:3]])
        for target in [F(1, 4)] * 3, [F(1, 3), F(1, 3), F(0)], [F(1, 2), F(0), F(0)]:  # near the vertex
            out.append([(c * 3 + t) / 4 for c, t in zip(out[0], target)])
        return out

    def test_collapsed_clouds_keep_the_map(self):
        for degree in 1, 2, 3:
            model = self.model("collapsed", degree, degree)
            for at, on, cut in PLACES:
                document = self.refine(at, "--max-change", "0")
                self.assertEqual((document["on"], document["written"]), (on, True), at)
                self.assertEqual([(c["of"], c["lo"], c["hi"]) for c in document["change"]], [(name, 0, 0) for name in ("x", "y", "z", "a")])
                refined = json.loads((self.folder / "r.vdms").read_text())
                self.assertEqual(len(document["cut"]), cut)
                self.assertEqual(len(refined["tetrahedra"]), 4 + len(document["cut"]) * (len(document["simplex"]) - 1))
                for u in self.points(at, degree)[:10 if degree < 3 else 2]:
                    self.assertEqual(dms_oracle.values(refined, u)[0], dms_oracle.values(model, u)[0], (degree, at, u))

    def test_other_clouds_change_by_no_more_than_the_bounds(self):
        changed = 0
        for degree, seed, places in ((2, 7, PLACES), (2, 8, PLACES), (3, 9, PLACES[1:4:2])):
            model = self.model("1/10:%d" % seed, degree, seed)
            for at, _, _ in places:
                document = self.refine(at)
                refined = json.loads((self.folder / "r.vdms").read_text())
                for u in self.points(at, seed)[:5 if degree < 3 else 2]:
                    old, new = dms_oracle.values(model, u)[0], dms_oracle.values(refined, u)[0]
                    for change, x, y in zip(document["change"], old, new):
                        self.assertLessEqual(abs(x - y), F(change["hi"]), (degree, seed, at, u))
                for change in document["change"]:
                    self.assertLessEqual(change["lo"], change["hi"])
                    changed += change["lo"] > 0
                    self.assertEqual(change["hi"] > 0, change["lo"] > 0)
        self.assertGreater(changed, 20)

    def test_the_identity_stays(self):
        self.model("1/10:7", 3, 0, control=False)
        for at, _, _ in PLACES:
            self.assertEqual({c["hi"] for c in self.refine(at, "--max-change", "0")["change"]}, {0})

    def test_greater_changes_are_refused(self):
        self.model("1/10:7", 2, 7)
        at = "5/12,5/12,1/12"
        most = max(c["hi"] for c in self.refine(at)["change"])
        self.assertGreater(most, 0)
        (self.folder / "r.vdms").unlink()
        document = self.refine(at, "--max-change", str(F(most) * F(999, 1000)), status=3)
        self.assertEqual((document["written"], document["defects"]), (False, []))
        self.assertFalse((self.folder / "r.vdms").exists())
        self.refine(at, "--max-change", str(F(most)))
        done = run("dms", "refine", "m.vdms", "--at", at, "--max-change", "1/1000000", "-o", "x.vdms", cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (3, "veritope: the map may change by more than --max-change\n"))
        self.assertTrue(done.stdout.startswith("not written  x.vdms  vertex 5 on the face of the vertices 1, 2, 4 of 2 tetrahedra, 8 tetrahedra, "), done)
        self.assertRegex(done.stdout, r"\n  x changes by at most 0\.\d+, at some point by 0\.\d+\n")
        for wrong in "-1", "x", "nan":
            done = run("dms", "refine", "m.vdms", "--at", at, "--max-change", wrong, "-o", "x.vdms", cwd=self.folder)
            self.assertEqual(done.returncode, 2, done)
        self.assertFalse((self.folder / "x.vdms").exists())

    def test_defects_are_reported(self):
        self.model("collapsed", 2, 1)
        document = self.refine("1/2,0,0", "--cloud", "1/2,1/8,1/8", status=1)
        self.assertEqual((document["written"], document["change"], document["on"]), (False, None, "edge"))
        self.assertIn("cloud-inside", {d["code"] for d in document["defects"]})
        text = (self.folder / "m.vdms").read_text().replace("[4, 1, 2, 3]", "[1, 4, 2, 3]")
        (self.folder / "m.vdms").write_text(text)
        document = self.refine("1/2,0,0", status=1)
        self.assertEqual((document["on"], document["defects"][0]["code"]), (None, "tet-reversed"))


if __name__ == "__main__":
    unittest.main()
