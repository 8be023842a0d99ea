#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope project: the schema holds, the numbers are true of the file, bad input has its status."""
import json
import math
import unittest
from fractions import Fraction

import schema
from support import VALID, Folder, run

# (u, v, u^2 + v^2) on [-2, 2]^2 as a GoTools surface: the bowl of tests/interval/spline_shapes.h over [0, 1]^2.
BOWL = """200 1 0 0
3 0
3 3
0 0 0 1 1 1
3 3
0 0 0 1 1 1
-2 -2 8
0 -2 0
2 -2 8
-2 0 0
0 0 -8
2 0 0
-2 2 8
0 2 0
2 2 8
"""


class Project(Folder):
    def bowl(self):
        path = self.folder / "bowl.g2"
        path.write_text(BOWL)
        return path

    def report(self, *arguments):
        done = run("project", "--json", "-", *arguments)
        self.assertEqual("", done.stderr)
        return done.returncode, json.loads(done.stdout)

    def test_all_critical_points_of_a_bowl(self):
        status, report = self.report("0.1,1/7,1.5", self.bowl())
        self.assertEqual(0, status)
        self.assertTrue(report["complete"])
        target = report["targets"][0]
        free = [p["kind"] for p in target["points"] if not any(p["held"])]
        self.assertEqual(["maximum", "minimum", "saddle"], sorted(free))
        nearest = target["points"][report["nearest"]["point"]]
        self.assertEqual("minimum", nearest["kind"])
        self.assertEqual(["1/10", "1/7", "3/2"], report["point"])

    def test_every_distance_is_that_of_the_parameters(self):
        point = [Fraction(1, 10), Fraction(1, 7), Fraction(3, 2)]
        _, report = self.report("1/10,1/7,0x1.8p0", self.bowl())
        for p in report["targets"][0]["points"]:
            u, v = (sum(map(Fraction, side)) / 2 for side in p["parameters"])
            x, y = 4 * u - 2, 4 * v - 2
            d = math.dist([x, y, x * x + y * y], point)
            self.assertLess(abs(d - p["distance"][0]), 1e-9)
            self.assertLess(p["distance"][1] - p["distance"][0], 1e-9)
            self.assertGreaterEqual(d, report["distance"][0] - 1e-12)

    def test_the_report_obeys_its_schema(self):
        for arguments in (["1,2,3"], ["0,0,1.5", "--max-boxes", "500"]):
            _, report = self.report(*arguments, self.bowl())
            self.assertEqual([], schema.faults(report))
            self.assertEqual(schema.keys_of("projection"), list(report))

    def test_a_circle_of_nearest_points_is_undecided(self):
        status, report = self.report("0,0,3/2", "--max-boxes", "500", self.bowl())
        self.assertEqual(3, status)
        self.assertFalse(report["complete"])
        self.assertIsNone(report["nearest"])
        low, high = report["distance"]
        self.assertTrue(low <= math.sqrt(1.25) <= high, report["distance"])

    def test_text_names_the_nearest_point(self):
        done = run("project", "-1,2,0.5", self.bowl())
        self.assertEqual((0, ""), (done.returncode, done.stderr))
        self.assertRegex(done.stdout, r"^COMPLETE  .*bowl\.g2  distance ([0-9.]+) to (?!\1\n)[0-9.]+\n  surface 0: nearest is point [0-9]+\n")

    def test_bad_input(self):
        bowl = self.bowl()
        for point in ("1,2,x", "1,,3", "", "1,2,nan"):
            self.assertEqual(2, run("project", point, bowl).returncode, point)
        for coordinate, words in (("1e999999", "exponent is over the limit 4096"), ("0x1p5000", "exponent is over the limit 4096"), ("nan", "not finite"),
                                  ("1/0", "not finite"), ("0." + "1" * 1001, "more than the limit 1000"), ("1" * 5097, "more than the limit 5096"), ("x", "not a decimal")):
            done = run("project", coordinate + ",2,3", bowl)
            self.assertEqual(2, done.returncode, coordinate)
            self.assertIn(words, done.stderr)
            self.assertIn(f"'{coordinate}'", done.stderr)
        done = run("project", "1,2", bowl)
        self.assertEqual(4, done.returncode)
        self.assertIn("POINT has 2 coordinates, and entity 0 has 3", done.stderr)
        cut = self.folder / "cut.g2"
        cut.write_text(BOWL[:60])
        self.assertEqual(4, run("project", "1,2,3", cut).returncode)
        self.assertEqual(4, run("project", "1,2,3", self.folder / "none.g2").returncode)
        self.assertEqual(4, run("project", "1,2,3", VALID).returncode)
        self.assertEqual(2, run("project", "1,2,3").returncode)
        self.assertEqual(2, run("project", "1,2,3", bowl, "--json", bowl).returncode)


if __name__ == "__main__":
    unittest.main()
