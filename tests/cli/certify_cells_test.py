# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope certify on volumes: what is wrong with cells, in text and JSON, and certificates that both checkers accept."""
import json
import subprocess
import sys
import unittest
from fractions import Fraction

import schema
from support import BIN, MODELS, ROOT, Folder, run

PATCHES = MODELS / "patches"
# model: the code, and (cell, part) of each place
INVALID = {
    "left_handed_smallest": ("left-handed", [(0, "")]),
    "overlap_smallest": ("overlap", [(0, ""), (1, "")]),
    "flat_smallest": ("flat", [(1, "")]),
    "curve_nonmanifold_smallest": ("curve-nonmanifold", [(0, "u1v1"), (0, "u1v1"), (1, "u0v0")]),
    "curve_nonmanifold_split": ("curve-nonmanifold", None),
    "point_nonmanifold_smallest": ("point-nonmanifold", [(0, "u1v1w1"), (1, "u0v0w0")]),
    "volume_folded_smallest": ("folded", [(0, ""), (0, "")]),
}
UNDECIDED = {"contact_smallest": "contact", "partial_contact_smallest": "partial-contact"}
VALID = ("left_handed_nearest_valid", "overlap_nearest_valid", "curve_nonmanifold_nearest_valid", "contact_nearest_valid",
         "partial_contact_nearest_valid", "wedge", "volume_folded_nearest_valid")


class Cells(Folder):
    def certified(self, path, *options):
        done = run("certify", path, "--json", "-", "--certificate", self.folder / "c.cert", *options)
        report = json.loads(done.stdout)
        if schema.jsonschema is not None:
            schema.validator().validate(report)
        (one,) = report["files"]
        self.assertEqual(done.returncode, {"VALID": 0, "INVALID": 1, "UNDECIDED": 3}[one["verdict"]], done)
        return one

    def expect_accepted(self, path, claim):
        for checker in ([BIN / "veritope-check"], [sys.executable, "-B", ROOT / "verify" / "checker" / "veritope_check.py"]):
            done = subprocess.run([*checker, path, self.folder / "c.cert"], capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stdout.replace(":", "").split()[:2]), (0, ["ACCEPT", claim]), (path, done))

    def expect_invalid(self, path, code, *options):
        one = self.certified(path, *options)
        self.assertEqual((one["verdict"], [d["code"] for d in one["defects"]]), ("INVALID", [code]), path)
        self.expect_accepted(path, "volume-folded-1" if code == "folded" else "vmodel-invalid-1")
        (defect,) = one["defects"]
        lengths = {len(defect[key]) for key in ("cells", "parts", "parameters", "boxes")}
        self.assertEqual(len(lengths), 1, defect)
        for parameters, box in zip(defect["parameters"], defect["boxes"]):
            self.assertTrue((parameters is None) != (box is None), defect)
            for low, high in box or ():
                self.assertLessEqual(Fraction(low), Fraction(high), defect)
        return defect

    def test_what_is_wrong_is_named_and_proved(self):
        for name, (code, places) in INVALID.items():
            defect = self.expect_invalid(PATCHES / f"{name}.itd", code)
            if places is not None:
                self.assertEqual(list(zip(defect["cells"], defect["parts"])), places, name)
            self.assertEqual(defect["fold"] is None, code != "folded")

    def test_points_are_exact(self):
        expected = {"point_nonmanifold_smallest": ["1/1", "1/1", "1/1"], "curve_nonmanifold_smallest": ["1/1", "1/1", "1/2"],
                    "left_handed_smallest": ["1/2", "1/2", "1/2"]}
        for name, point in expected.items():
            self.assertEqual(self.expect_invalid(PATCHES / f"{name}.itd", INVALID[name][0])["point"], point, name)

    def test_an_overlap_is_a_point_of_one_cell_and_of_the_other_or_in_a_box_of_it(self):
        corner = (PATCHES / "overlap_smallest.itd").read_text()                                # [0, 1]^3 and [1/2, 2]^3
        (self.folder / "off.itd").write_text(corner.replace("0.5", "0.6"))
        for path, low in ((PATCHES / "overlap_smallest.itd", Fraction(1, 2)), (self.folder / "off.itd", Fraction(3, 5))):
            defect = self.expect_invalid(path, "overlap")
            point, known = [Fraction(x) for x in defect["point"]], 0
            for cell, parameters, box in zip(defect["cells"], defect["parameters"], defect["boxes"]):
                begin, length = ((0, 1), (low, 2 - low))[cell]
                ranges = box or [(x, x) for x in parameters]
                known += box is None
                for x, (lo, hi) in zip(point, ranges):
                    self.assertTrue(begin + length * Fraction(lo) <= x <= begin + length * Fraction(hi), defect)
            self.assertGreaterEqual(known, 1)

    def test_what_touches_is_undecided(self):
        for name, code in UNDECIDED.items():
            one = self.certified(PATCHES / f"{name}.itd")
            self.assertEqual((one["verdict"], one["error"]["code"], one["reasons"][0]["code"]), ("UNDECIDED", code, code), name)

    def test_their_neighbours_are_valid(self):
        for name in VALID:
            path = PATCHES / f"{name}.itd"
            self.assertEqual(self.certified(path)["verdict"], "VALID", name)
            self.expect_accepted(path, "vmodel-1")

    def test_regular_is_asked_for(self):
        wedge = PATCHES / "wedge.itd"
        one = self.certified(wedge)
        self.assertEqual((one["verdict"], one["regular"], len(one["singular"])), ("VALID", False, 1))
        defect = self.expect_invalid(wedge, "singular", "--regular")
        self.assertEqual(defect["cells"], [0])
        self.assertEqual(Fraction(defect["parameters"][0][0]), 0)                              # u = 0 is the collapsed face
        self.assertEqual(self.certified(PATCHES / "overlap_nearest_valid.itd", "--regular")["verdict"], "VALID")

    def test_a_volume_that_may_be_torn_is_not_covered(self):
        """A bar with a knot as often as twice its degree 1, beside a bar of the same length: their faces are not glued."""
        points = "".join("[%d %d %d]" % (x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1, 1, 2))
        whole = "".join("[%d %d %d]" % (x, y, z) for z in (0, 1) for y in (1, 2) for x in (0, 2))
        path = self.folder / "torn.itd"
        path.write_text("[TRIVAR BSPLINE 4 2 2 2 2 2 E3 [KV 0 0 1 1 2 2] [KV 0 0 1 1] [KV 0 0 1 1] %s]\n[TRIVAR BEZIER 2 2 2 E3 %s]\n"
                        % (points, whole))
        one = self.certified(path)
        self.assertEqual((one["verdict"], one["error"]["code"]), ("UNDECIDED", "not-covered"))
        self.assertIn("entity 0: the inner knot 1 of u occurs more often than the degree", one["error"]["message"])

    def test_a_determinant_that_is_zero_at_one_point(self):
        """(u (1 - 2 w), v, w) folds at w = 1/2, where a whole plane has the determinant 0."""
        points = "".join("[%d %d %d]" % (u * (1 - 2 * w), v, w) for w in (0, 1) for v in (0, 1) for u in (0, 1))
        path = self.folder / "hour.itd"
        path.write_text("[TRIVAR BEZIER 2 2 2 E3 %s]\n" % points)
        self.expect_invalid(path, "folded")

    def test_orient_auto_reverses_what_keep_refuses(self):
        path = PATCHES / "left_handed_smallest.itd"
        text = run("certify", path).stdout
        self.assertIn("--orient auto", text)
        one = self.certified(path, "--orient", "auto")
        self.assertEqual((one["verdict"], one["reversed"]), ("VALID", [0]))

    def test_all_cells_that_fold_are_listed(self):
        folded = (PATCHES / "volume_folded_smallest.itd").read_text()
        path = self.folder / "two.itd"
        path.write_text(folded + (PATCHES / "overlap_nearest_valid.itd").read_text() + folded)
        one = self.certified(path)
        self.assertEqual([(d["code"], set(d["cells"])) for d in one["defects"]], [("folded", {0}), ("folded", {3})])
        self.expect_accepted(path, "volume-folded-1")


if __name__ == "__main__":
    unittest.main()
