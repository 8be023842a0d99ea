# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope intersect: reports against their schema and known pairs, curves, bad input, statuses."""
import json
import math
import re
import unittest
import xml.etree.ElementTree

import schema
import support
from support import Folder, run


def surface(rows, degree_u, degree_v, rational=False):
    """An .itd file of one Bezier surface; rows[v][u] of coordinates."""
    kind = ("P" if rational else "E") + "3"
    lines = [f"[SURFACE BEZIER {len(rows[0])} {len(rows)} {kind}"]
    lines += ["  [" + " ".join(map(str, p)) + "]" for row in rows for p in row]
    return "[OBJECT S\n" + "\n".join(lines) + "\n]\n]\n"


def paraboloid(a, b, c):
    """z = a x^2 + b y^2 + c over [-1, 1]^2."""
    square = [1, -1, 1]
    return surface([[(i - 1, j - 1, a * square[i] + b * square[j] + c) for i in range(3)] for j in range(3)], 2, 2)


def plane(height, size=2):
    return surface([[(-size, -size, height), (size, -size, height)], [(-size, size, height), (size, size, height)]], 1, 1)


class Intersect(Folder):
    def file(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def report(self, a, b, *options):
        done = run("intersect", a, b, "--json", "-", *options)
        document = json.loads(done.stdout)
        self.assertEqual(schema.faults(document), [])
        self.assertEqual(document["complete"], document["unresolved"] == [])
        self.assertEqual(done.returncode, 0 if document["complete"] else 3)
        return document

    def test_a_circle_is_one_loop_with_its_length(self):
        document = self.report(self.file("bowl.itd", paraboloid(1, 1, 0)), self.file("plane.itd", plane(0.25)))
        (branch,) = document["branches"]
        self.assertTrue(branch["closed"] and not branch["partial"])
        low, high = branch["length"]
        self.assertLessEqual(low, math.pi)
        self.assertGreaterEqual(high, math.pi)
        self.assertLess(high - low, 0.05)
        self.assertLess(branch["gap"], 1e-6)
        for box in branch["boxes"]:  # each holds a point of the circle
            (x0, x1), (y0, y1), (z0, z1) = box["space"]
            self.assertLessEqual(min(x0 * x0, x1 * x1) + min(y0 * y0, y1 * y1), 0.25 + 1e-9 if x0 * x1 > 0 and y0 * y1 > 0 else 9)
            self.assertTrue(z0 <= 0.25 <= z1)

    def test_apart_tangent_and_equal(self):
        bowl = self.file("bowl.itd", paraboloid(1, 2, 0))
        apart = self.report(bowl, self.file("below.itd", plane(-1e-9)))
        self.assertEqual([apart[k] for k in ("branches", "overlaps", "tangencies", "unresolved")], [[], [], [], []])
        touching = self.report(bowl, self.file("floor.itd", plane(0)))
        (place,) = touching["tangencies"]
        self.assertEqual(place["shape"], "elliptic")
        self.assertTrue(place["separation"][0] <= 0 <= place["separation"][1])
        same = self.report(bowl, bowl)
        self.assertEqual(len(same["overlaps"]), 1)

    def test_a_small_loop_is_found(self):
        document = self.report(self.file("bowl.itd", paraboloid(1, 1, 0)), self.file("plane.itd", plane(1e-10)))
        self.assertEqual([b["closed"] for b in document["branches"]], [True])
        self.assertLessEqual(document["branches"][0]["length"][0], 2 * math.pi * 1e-5)

    def test_text_says_the_same(self):
        done = run("intersect", self.file("bowl.itd", paraboloid(1, 1, 0)), self.file("plane.itd", plane(0.25)))
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stdout, r"^COMPLETE .* 1 loops, 0 arcs, 0 tangencies and overlaps\n")
        self.assertRegex(done.stdout, r"loop  length 3\.1\d* to 3\.1\d*  gap at most")

    def test_curves_as_json_and_vtu(self):
        a, b = self.file("bowl.itd", paraboloid(1, 1, 0)), self.file("plane.itd", plane(0.25))
        for name in ("curves.json", "curves.vtu"):
            self.assertEqual(run("intersect", a, b, "-o", self.folder / name).returncode, 0)
        (curve,) = json.loads((self.folder / "curves.json").read_text())["curves"]
        ends = [(s["control"][0], s["control"][3]) for s in curve["segments"]]
        for (_, end), (begin, _) in zip(ends, ends[1:] + ends[:1]):
            for p, q in zip(end, begin):
                self.assertAlmostEqual(p, q, 12)
        piece = xml.etree.ElementTree.parse(self.folder / "curves.vtu").find(".//Piece")
        self.assertEqual(piece.get("NumberOfCells"), "1")
        coordinates = [float(v) for v in piece.find("Points/DataArray").text.split()]
        self.assertEqual(len(coordinates), 3 * int(piece.get("NumberOfPoints")))
        for x, y, z in zip(*[iter(coordinates)] * 3):
            self.assertAlmostEqual(x * x + y * y, 0.25, 5)

    def test_bad_input_is_named(self):
        good = self.file("plane.itd", plane(0))
        cases = [("zero.itd", surface([[(0, 0, 0, 0), (1, 1, 0, 0)], [(1, 0, 1, 0), (1, 1, 1, 0)]], 1, 1, True), "weight"),
                 ("short.itd", plane(0)[:-30], "short.itd"), ("nothing.itd", "[OBJECT N\n  [NUMBER 1]\n]\n", "no surface")]
        for name, text, word in cases:
            for order in (0, 1):
                pair = [self.file(name, text), good]
                done = run("intersect", *(pair if order == 0 else pair[::-1]))
                self.assertEqual((done.returncode, done.stdout), (4, ""), name)
                self.assertIn(word, done.stderr)
                self.assertIn(name, done.stderr)

    def test_wrong_usage(self):
        good = self.file("plane.itd", plane(0))
        for arguments in ([good], [good, good, good], [good, good, "-o", "x.txt"], [good, good, "--gap", "-1"], [good, good, "-o", str(good)]):
            done = run("intersect", *arguments)
            self.assertEqual((done.returncode, done.stdout), (2, ""), arguments)

    def test_a_gap_is_a_length(self):
        good = self.file("plane.itd", plane(0))
        for gap in ("nan", "0", "inf", "-1", "1e-301", "1e301", "x", ""):
            done = run("intersect", good, good, "--gap=" + gap)
            self.assertEqual((done.returncode, done.stdout), (2, ""), gap)
            self.assertIn("--gap", done.stderr)
            if gap:
                self.assertIn("must be a length from 1e-300 to 1e300, not " + gap, done.stderr)

    def test_two_outputs_that_are_one_file_are_named_by_their_options(self):
        good, out = self.file("plane.itd", plane(0)), self.folder / "x.json"
        done = run("intersect", good, good, "-o", out, "--json", out)
        self.assertEqual((done.returncode, done.stdout, out.exists()), (2, "", False))
        self.assertIn("--output and --json would both write", done.stderr)

    def test_the_budget_ends_with_what_is_left(self):
        document = self.report(self.file("bowl.itd", paraboloid(1, 1, 0)), self.file("plane.itd", plane(0.25)), "--max-pairs", "20")
        self.assertFalse(document["complete"])
        self.assertGreaterEqual(document["unresolved"][0]["spent"]["pairs"], 20)


if __name__ == "__main__":
    unittest.main()
