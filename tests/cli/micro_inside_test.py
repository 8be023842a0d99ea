#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope certify --model: microstructures in the interior of solids, and what is not proved to be there."""
import json
import unittest

import schema
import support
from support import MODELS, run


def cube(low, high, turned=False):
    """The corners and faces of the cube [low, high]^3, or [low[i], high[i]] along the axes; turned: inside out."""
    low, high = (x if isinstance(x, tuple) else (x,) * 3 for x in (low, high))
    corners = [(x, y, z) for z in (low[2], high[2]) for y in (low[1], high[1]) for x in (low[0], high[0])]
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return corners, [face[::-1] for face in faces] if turned else faces


def off(*parts):
    corners = [p for part in parts for p in part[0]]
    firsts = [sum(len(part[0]) for part in parts[:i]) for i in range(len(parts))]
    faces = [[i + first for i in face] for part, first in zip(parts, firsts) for face in part[1]]
    return f"OFF\n{len(corners)} {len(faces)} 0\n" + "".join("%r %r %r\n" % p for p in corners) + "".join(f"4 {' '.join(map(str, f))}\n" for f in faces)


class MicroInside(support.Folder):
    def setUp(self):
        super().setUp()
        self.out, self.solid, self.certificate = (self.folder / name for name in ("out.vmicro", "solid.off", "out.cert"))
        cage = self.volumes("box", {"op": "box", "min": [0, 0, 0], "max": [8, 8, 8]})
        done = run("micro", "--cage", cage, "--tile", "jack,degree=1", "--counts", "4,4,4", "-o", self.out)
        self.assertEqual(done.returncode, 0, done)

    def certify(self, *parts, expect=0):
        """The report for a model."""
        self.solid.write_text(off(*parts))
        done = run("certify", self.out, "--model", self.solid, "--json", "-")
        self.assertEqual(done.returncode, expect, done)
        document = json.loads(done.stdout)
        self.assertEqual(schema.faults(document), [])
        return document["files"][0]

    def reason(self, *parts):
        file = self.certify(*parts, expect=3)
        self.assertEqual((file["verdict"], file["inside"], file["certificate"]), ("UNDECIDED", None, None))
        self.assertEqual(file["error"]["code"], file["reasons"][0]["code"])
        return file["reasons"][0]

    def test_inside_and_checked(self):
        file = self.certify(cube(-1, 9))
        self.assertEqual((file["verdict"], file["certificate"]["checked"]), ("VALID", True))
        self.assertEqual((file["counts"]["tiles"], file["counts"]["genus"]), (64, 2 * 64 - 3 * 16 + 1))
        model = {"path": str(self.solid), "sha256": support.only_file(self.solid)["sha256"], "bytes": self.solid.stat().st_size, "format": "off"}
        self.assertEqual(file["inside"], {"model": model, "voids": 0, "skin": None})
        done = run("certify", self.out, "--model", self.solid)
        self.assertIn(f"genus 81, inside {self.solid} (checked)\n", done.stdout)
        self.assertIn(f"\n  model        {self.solid}, in its interior\n", done.stdout)
        # Without --model nothing is said of it.
        self.assertIsNone(support.only_file(self.out)["inside"])

    def test_voids(self):
        file = self.certify(cube(-1, 9), cube(.25, .375, True), cube((1.75, 1.75, 1.75), (2.25, 2.25, 2.25), True))
        self.assertEqual((file["verdict"], file["inside"]["voids"]), ("VALID", 2))
        node = self.reason(cube(-1, 9), cube(.875, 1.125, True))
        self.assertEqual((node["code"], node["parts"]), ("not-inside", []))
        self.assertTrue(node["message"].startswith("I3: no point was found in the void of the solid behind triangle 12 "), node)

    def test_contacts_and_crossings_name_the_cell_and_the_triangle(self):
        for solid in (cube(0, 8), cube(-1, 7.5), cube(1, 9)):
            reason = self.reason(solid)
            self.assertEqual(reason["code"], "not-inside")
            self.assertRegex(reason["message"], r"^I1: patch \d+ of the tile of cell \(\d, \d, \d\) of grid 0 is not proved to miss triangle \d+$")
            (part,) = reason["parts"]
            self.assertEqual((part["volume"], len(part["box"])), (0, 3))

    def test_a_gap_that_the_checkers_do_not_see_is_undecided(self):
        for k in range(50, 39, -1):
            gap = 8 * 2.0**-k
            reason = self.reason(cube(-gap, 8 + gap))
            self.assertEqual((reason["code"], reason["message"][:3]), ("not-inside", "I1:"), k)
        for k in (36, 30, 20):
            self.assertEqual(self.certify(cube(-8 * 2.0**-k, 8 + 8 * 2.0**-k))["verdict"], "VALID", k)

    def test_elsewhere(self):
        self.assertRegex(self.reason(cube(20, 21))["message"], r"^I2: a point of patch \d+ of the tile of cell \(0, 0, 0\) of grid 0 is not in the interior")
        self.assertIn("I2", self.reason(cube(-2, 10), cube(-1, 9, True))["message"])

    def test_a_model_that_bounds_no_solid(self):
        for model, rule in ((MODELS / "m3_missing_face.off", "M3"), (MODELS / "m9_inside_out.off", "M8")):
            done = run("certify", self.out, "--model", model, "--json", "-")
            file = json.loads(done.stdout)["files"][0]
            self.assertEqual((done.returncode, file["error"]["code"]), (3, "model-invalid"))
            self.assertTrue(file["error"]["message"].startswith(f"{model}: the model is INVALID: {rule}: "), file["error"])

    def test_models_that_cannot_be_read(self):
        for model in (self.folder / "none.off", self.out, MODELS / "unreadable_empty.off"):
            done = run("certify", self.out, "--model", model)
            self.assertEqual((done.returncode, done.stdout), (4, ""), done)
            self.assertIn(str(model), done.stderr)

    def test_wrong_usage(self):
        self.solid.write_text(off(cube(-1, 9)))
        for arguments, why in (([self.solid], "is a mesh"), ([self.out, self.solid], "is a mesh"), ([self.folder / "box.vjson"], "is a file of splines")):
            done = run("certify", *arguments, "--model", self.solid)
            self.assertEqual((done.returncode, done.stdout), (2, ""), done)
            self.assertIn("--model is for microstructures; ", done.stderr)
            self.assertIn(why, done.stderr)
        done = run("certify", self.out, "--model", "-", input="")
        self.assertEqual(done.returncode, 2, done)
        done = run("certify", "-", "--format", "off", "--model", self.solid, input=self.solid.read_text())
        self.assertEqual(done.returncode, 2, done)

    def test_standard_input_and_other_names(self):
        solid = self.folder / "-x.off"
        solid.write_text(off(cube(-1, 9)))
        for model in (solid, "-x.off"):
            done = run("certify", "-", "--format", "vmicro", f"--model={model}", input=self.out.read_text(), cwd=self.folder)
            self.assertEqual((done.returncode, done.stdout[:5]), (0, "VALID"), done)

    def test_the_certificate_is_the_same_for_every_number_of_jobs_and_can_be_read(self):
        self.solid.write_text(off(cube(-1, 9), cube(.25, .375, True)))
        kept = set()
        for jobs in (1, 2, 5):
            done = run("certify", self.out, "--model", self.solid, "--certificate", self.certificate, "-j", jobs)
            self.assertEqual(done.returncode, 0, done)
            kept.add(self.certificate.read_bytes())
        self.assertEqual(len(kept), 1)
        done = run("explain-certificate", self.certificate)
        self.assertEqual(done.returncode, 0, done)
        for line in ("claim: micro-inside-1\n", "skin: -\n", "voids: 1\n", "model_format: off\n", "the microstructure as a body: microstructure-1\n",
                     "the model as a body: mesh-valid-1, 24 triangles, 16 vertex ids\n"):
            self.assertIn(line, done.stdout)
        for checker in ([support.BIN / "veritope-check"], [support.sys.executable, "-B", support.CHECKER_PY]):
            done = run(*checker[1:], self.out, self.certificate, "--model", self.solid, program=checker[0])
            self.assertEqual((done.returncode, done.stdout[:21]), (0, "ACCEPT micro-inside-1"), done)


if __name__ == "__main__":
    unittest.main()
