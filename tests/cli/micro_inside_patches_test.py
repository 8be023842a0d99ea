#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope micro and certify --model with solids of splines: bridges to patches, and the claim about the inside."""
import json
import unittest
from fractions import Fraction

import cylinders
import schema
import support
from support import MODELS, run


def cylinder(low, high, radius, turned=False, middle=4):
    """Entities of the cylinder of that radius around (x, middle, middle) from x = low to high; turned: inside out."""
    low, high, radius, middle = (Fraction(x) for x in (low, high, radius, middle))
    entities = json.loads(cylinders.cylinder(0, low, high, radius=radius, place=lambda p: (p[2], p[0] + middle, p[1] + middle)))["entities"]
    for entity in entities if turned else ():
        shape = entity["shape"]  # of degrees (2, 1), in one piece: the first parameter runs backwards
        rows = [shape["points"][2 * i:2 * i + 2] for i in range(3)]
        shape["points"] = [point for row in reversed(rows) for point in row]
    return entities


class MicroInsidePatches(support.Folder):
    def setUp(self):
        super().setUp()
        self.out, self.solid, self.certificate = (self.folder / name for name in ("out.vmicro", "solid.vjson", "out.cert"))
        self.cage = self.volumes("box", {"op": "box", "min": [0, 0, 0], "max": [8, 8, 8]})

    def write(self, *parts):
        frame = json.loads(cylinders.cylinder(0, 0, 1))
        self.solid.write_text(json.dumps({**frame, "entities": [e for part in parts for e in part]}))
        return self.solid

    def micro(self, *arguments, counts="8,8,8", expect=0):
        done = run("micro", "--cage", self.cage, "--tile", "jack,degree=1", "--counts", counts, "-o", self.out, "--json", "-", *arguments, timeout=600)
        self.assertEqual(done.returncode, expect, done)
        report = json.loads(done.stdout)
        self.assertEqual(schema.faults(report), [])
        return report

    def certify(self, model, expect=0):
        done = run("certify", self.out, "--model", model, "--json", "-", timeout=600)
        self.assertEqual(done.returncode, expect, done)
        document = json.loads(done.stdout)
        self.assertEqual(schema.faults(document), [])
        return document["files"][0]

    def reason(self, model):
        file = self.certify(model, expect=3)
        self.assertEqual((file["verdict"], file["inside"], file["certificate"]), ("UNDECIDED", None, None))
        return file["reasons"][0]

    def test_bridges_lead_to_the_skin_and_everything_is_inside_and_checked(self):
        solid = self.write(cylinder(".8", "7.1", "3.1"))
        report = self.micro("--model", solid)
        bridges = report["bridges"]
        self.assertGreater(bridges["caps"], 50)
        self.assertGreaterEqual(bridges["built"], 0.85 * bridges["caps"])
        self.assertEqual(bridges["built"] + sum(bridges["dropped"].values()), bridges["caps"])
        self.assertEqual(bridges["kink_degrees"], {"lo": 0, "hi": 0})
        skin = (6.3 ** 2 + 2 * 6.2 ** 2) ** .5 / 100
        self.assertTrue(0 < bridges["reach"]["lo"] <= bridges["reach"]["hi"] <= 1.01 * skin, bridges)
        file = self.certify(solid)
        self.assertEqual((file["verdict"], file["certificate"]["checked"]), ("VALID", True))
        self.assertEqual((file["counts"]["bridges"], file["inside"]["voids"]), (bridges["built"], 0))
        top, _, bottom = file["inside"]["skin"].partition("/")
        self.assertLessEqual(int(top) / int(bottom or 1), 1.01 * skin)
        self.assertEqual(file["inside"]["model"]["format"], "vjson")
        done = run("certify", self.out, "--model", solid)
        self.assertIn(f"inside {solid} (checked)\n", done.stdout)
        for jobs in (1, 3):
            self.assertEqual(self.micro("--model", solid, "--jobs", jobs)["output"]["sha256"], report["output"]["sha256"])
        near = self.micro("--model", solid, "--alpha", "1/3", "--skin", "0.02")
        self.assertLessEqual(near["bridges"]["reach"]["hi"], 0.02)
        self.assertIsNone(self.micro("--model", solid, "--bridge", "none")["bridges"])

    def test_formats(self):
        volumes = self.volumes("cylinder", {"op": "place", "translate": [4, 4, 1], "of": {"op": "cylinder", "radius": 3, "height": 6}})
        self.write(json.loads(cylinders.cylinder(4, 1, 7, radius=3, place=lambda p: (p[0], p[1] + 4, p[2])))["entities"])
        self.micro("--model", volumes, counts="4,4,5")
        for ending, source in (("vjson", self.solid), ("itd", self.solid), ("g2", self.solid), ("vjson", volumes)):
            model = self.folder / f"other.{ending}"
            done = run("convert", "--lossy", source, model)
            self.assertEqual(done.returncode, 0, done)
            self.expect_checked(model, ending + ("-faces" if source == volumes else ""))
        self.cage = self.volumes("bar", {"op": "box", "min": [".25"] * 3, "max": ["1.75", ".75", ".75"]})
        self.micro(counts="3,1,1")
        self.expect_checked(MODELS / "splines" / "two_cubes.mesh", "mfem-faces")

    def expect_checked(self, model, name):
        """The claim of self.out and the model is proved, with this model_format, and both checkers accept it."""
        done = run("certify", self.out, "--model", model, "--certificate", self.certificate, timeout=600)
        self.assertEqual((done.returncode, done.stdout[:5]), (0, "VALID"), done)
        self.assertIn(f"inside {model} (checked)\n", done.stdout)
        explained = run("explain-certificate", self.certificate).stdout
        self.assertIn("the model as a body: star-box-2", explained)
        self.assertIn(f"model_format: {name}\n", explained)
        for checker in ([support.BIN / "veritope-check"], [support.sys.executable, "-B", support.CHECKER_PY]):
            done = run(*checker[1:], self.out, self.certificate, "--model", model, program=checker[0], timeout=600)
            self.assertEqual((done.returncode, done.stdout[:21]), (0, "ACCEPT micro-inside-1"), done)

    def test_voids(self):
        self.micro(counts="4,4,4")
        whole = cylinder(-1, 9, 8)
        # Between the arms of jacks; then in a node.
        file = self.certify(self.write(whole, cylinder(".1", ".3", ".1", True, middle=".25")))
        self.assertEqual((file["verdict"], file["inside"]["voids"], file["certificate"]["checked"]), ("VALID", 1, True))
        node = self.reason(self.write(whole, cylinder(".9", "1.1", ".1", True, middle=1)))
        self.assertEqual(node["code"], "not-inside")
        self.assertRegex(node["message"], r"^I3: no point was found in the void of the solid behind surface \d+")

    def test_contacts_and_crossings_name_the_cell_and_the_surface(self):
        self.micro(counts="4,4,4")
        for ends in ((0, 8), (-1, 7.5), (1, 9)):
            reason = self.reason(self.write(cylinder(*ends, 8)))
            self.assertEqual(reason["code"], "not-inside")
            self.assertRegex(reason["message"], r"^I1: patch \d+ of the tile of cell \(\d, \d, \d\) of grid 0 is not proved to miss surface \d+")
            (part,) = reason["parts"]
            self.assertEqual((part["volume"], len(part["box"])), (0, 3))
        self.assertRegex(self.reason(self.write(cylinder(20, 21, 1)))["message"], r"^I2: a point of patch \d+ ")

    def test_models_that_are_no_solid(self):
        self.micro(counts="2,2,2")
        opened = self.reason(self.write(cylinder(-1, 9, 8)[1:]))
        self.assertEqual(opened["code"], "model-invalid")
        self.assertTrue(opened["message"].startswith(f"{self.solid}: the model is INVALID: "), opened)
        inward = self.reason(self.write(cylinder(-1, 9, 8, True)))
        self.assertEqual(inward["code"], "model-invalid")
        # A format that checkers do not read.
        self.assertEqual(self.reason(MODELS / "splines" / "surface.xml")["code"], "not-covered")
        self.solid.write_text(self.solid.read_text()[:-100])
        for model in (self.solid, self.out, self.folder / "none.vjson"):
            done = run("certify", self.out, "--model", model)
            self.assertEqual((done.returncode, done.stdout), (4, ""), done)
            self.assertIn(str(model), done.stderr)


if __name__ == "__main__":
    unittest.main()
