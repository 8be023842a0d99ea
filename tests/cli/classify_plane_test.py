# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope classify with a region of the plane: loops of Bezier curves and conic arcs, points with two coordinates."""
import json
import struct
import unittest

import schema
from support import Folder, run


def curve(points, rational=False, degree=None):
    """A Bezier curve, or a chain of them in one B-spline with inner knots of full multiplicity."""
    degree = degree or len(points) - 1
    pieces = (len(points) - 1) // degree
    knots = ["0"] * (degree + 1)
    for i in range(1, pieces):
        knots += [str(i)] * degree
    knots += [str(pieces)] * (degree + 1)
    shape = {"degrees": [degree], "periodic": [False], "knots": [knots], "rational": rational,
             "components": len(points[0]), "points": [[str(x) for x in p] for p in points]}
    return {"kind": "curve", "group": None, "attributes": [], "shape": shape}


def model(*curves):
    return json.dumps({"format": "veritope-spline-1", "groups": [], "entities": list(curves)})


# The unit circle as four conic arcs in one curve: ((1 - t^2) : 2 t : 1 + t^2) and its turns.
CIRCLE = curve([(1, 0, 1), (1, 1, 1), (0, 2, 2), (-2, 2, 2), (-4, 0, 4), (-4, -4, 4), (0, -8, 8), (8, -8, 8),
                (16, 0, 16)], True, 2)
# Above the parabola y = x^2 and below y = 1.
PARABOLA = model(curve([(-1, 1), (0, -1), (1, 1)]), curve([(1, 1), (-1, 1)]))
SQUARE = [(0, 0), (2, 0), (2, 2), (0, 2), (0, 0)]


class ClassifyPlane(Folder):
    def file(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def classify(self, text, points, *options):
        return run("classify", self.file("plane.vjson", text), self.file("points", points), *options)

    def answers(self, text, points, *options):
        done = self.classify(text, points, *options)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def test_points_are_in_on_or_out(self):
        self.assertEqual(
            self.answers(model(CIRCLE), "x,y\n0,0\n3/5 4/5\n0.6 -0.8\n2;0\n0x1p-3 0\n\n0 1e-400\n"),
            "0 0 in 1 -\n3/5 4/5 on - -\n0.6 -0.8 on - -\n2 0 out 0 -\n0x1p-3 0 in 1 -\n0 1e-400 in 1 -\n")
        self.assertEqual(self.answers(PARABOLA, "0 0\n1/3 1/9\n1/3 0.11\n1/3 0.12\n0 1\n1 1\n-3 1\n"),
                         "0 0 on - -\n1/3 1/9 on - -\n1/3 0.11 out 0 -\n1/3 0.12 in 1 -\n0 1 on - -\n1 1 on - -\n"
                         "-3 1 out 0 -\n")

    def test_loops_may_cross_and_turn_either_way(self):
        self.assertEqual(self.answers(model(*(curve([b, a]) for a, b in zip(SQUARE, SQUARE[1:]))), "1 1\n3 1\n"),
                         "1 1 in -1 -\n3 1 out 0 -\n")
        self.assertEqual(self.answers(model(*(curve([a, b]) for a, b in zip(SQUARE, SQUARE[1:])), CIRCLE),
                                      "1/4 1/4\n3/2 3/2\n-1/4 0\n", "--winding"),
                         "1/4 1/4 - 2 -\n3/2 3/2 - 1 -\n-1/4 0 - 1 -\n")

    def test_npy_files_have_two_columns(self):
        header = "{'descr': '<f8', 'fortran_order': False, 'shape': (2, %d), }\n"
        def npy(columns, *numbers):
            text = (header % columns).encode()
            return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(text)) + text + struct.pack(f"<{len(numbers)}d", *numbers)
        self.assertEqual(self.answers(model(CIRCLE), npy(2, .5, .5, 1, 1)),
                         "0x1p-1 0x1p-1 in 1 -\n0x1p+0 0x1p+0 out 0 -\n")
        done = self.classify(model(CIRCLE), npy(3, 0, 0, 0, 0, 0, 0))
        self.assertEqual(done.returncode, 4)
        self.assertIn("with the shape (2,3) instead of (n, 2)", done.stderr)

    def test_the_report_has_no_verdict(self):
        out = self.folder / "answers"
        report = json.loads(self.answers(model(CIRCLE), "0 0\n1 0\n2 0\n", "-o", out, "--json", "-"))
        self.assertEqual(schema.faults(report), [])
        self.assertIsNone(report["model"]["verdict"])
        self.assertEqual(report["counts"], {"points": 3, "in": 1, "on": 1, "out": 1, "undecided": 0})
        self.assertEqual(report["decimals"], "exact")

    def test_every_number_of_threads_gives_the_same_answers(self):
        points = "".join(f"{i}/37 {j}/41\n" for i in range(-40, 40, 3) for j in range(-44, 44, 3))
        self.assertEqual(self.answers(model(CIRCLE), points, "--jobs", "1"),
                         self.answers(model(CIRCLE), points, "--jobs", "3"))

    def test_open_loops_name_the_curve(self):
        sides = [curve([a, b]) for a, b in zip(SQUARE, SQUARE[1:])]
        done = self.classify(model(sides[0], sides[1], sides[3]), "1 1\n")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("plane.vjson: entity 1: the loops are not closed: the curve ends at (2, 2), where fewer curves "
                      "start than end", done.stderr)

    def test_points_have_two_coordinates(self):
        for points, words in (("1 2 3\n", "points:1: column 5: a point has two coordinates, but there are 3"),
                              ("1 2\n1\n", "points:2: column 2: a point has two coordinates, but there are 1")):
            done = self.classify(model(CIRCLE), points)
            self.assertEqual(done.returncode, 4)
            self.assertIn(words, done.stderr)

    def test_options_of_space_are_refused(self):
        out = self.folder / "answers"
        for options in (("--by", "normal"), ("-o", out, "--certificate", self.folder / "c")):
            done = self.classify(model(CIRCLE), "0 0\n", *options)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn("is for models in space", done.stderr)
            self.assertFalse(out.exists())

    def test_curves_in_space_bound_nothing(self):
        done = self.classify(model(curve([(0, 0, 0), (1, 0, 0)])), "0 0 0\n")
        self.assertEqual(done.returncode, 3)
        self.assertIn("such shapes bound no solid", done.stderr)


if __name__ == "__main__":
    unittest.main()
