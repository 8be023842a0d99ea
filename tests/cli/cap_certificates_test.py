# SPDX-License-Identifier: LGPL-3.0-or-later
"""Certificates of answers about expressions at the centres of discs, to which a side of flat patches is collapsed."""
import json
import os
import pathlib
import random
import sys
import unittest
from fractions import Fraction as Q

import boolean_test
import expression_certificates_test
from cylinders import HALF, cylinder
from support import run

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "mutation"))
import expression_forge  # noqa: E402
import patch_points_forge  # noqa: E402

Base = expression_certificates_test.AnsweredExpressions
DISTANCES = (0, Q(1, 4), Q(1, 2), 1, Q(3, 2))             # of points from a first axis, in one direction


def rational_rotation(rng):
    """A map: a rotation, given by a quaternion of integers, and a shift."""
    while True:
        a, b, c, d = (rng.randint(-4, 4) for _ in range(4))
        n = a * a + b * b + c * c + d * d
        if n:
            break
    rows = ((a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)), (2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)),
            (2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d))
    shift = [Q(rng.randint(-9, 9), rng.choice((1, 2, 7))) for _ in range(3)]
    return lambda p: [sum(r * x for r, x in zip(row, p)) / Q(n) + s for row, s in zip(rows, shift)]


def unit_vector(rng):
    p, q = rng.choice(((1, 0), (3, 4), (5, 12), (8, 15), (7, 24), (0, 1), (-4, 3)))
    n = Q({1: 1, 25: 5, 169: 13, 289: 17, 625: 25}[p * p + q * q])
    return p / n, q / n


class Caps(Base):
    def words(self):
        return " ".join(line.split()[3] for line in (self.folder / "answers").read_text().splitlines())

    def covers(self, expression, operands, points, words, uncovered=0):
        report = self.answer(expression, *(f"{name}={operands[name]}" for name in sorted(operands) if name in expression), points=points)
        self.assertEqual((self.words(), report["certificate"]["uncovered"]), (words, uncovered), expression)
        self.check(0, f"{uncovered} not covered")

    # PROVES POINT-7.P
    def test_stacked_cylinders(self):
        self.file("low.vjson", cylinder(0, 0, 2))
        self.file("high.vjson", cylinder(0, 2, 4))
        self.file("wide.vjson", cylinder(Q(1, 4), 2, 3, radius=2, turn=(Q(3, 5), Q(4, 5))))
        self.file("floor.off", boolean_test.box((-3, -3, -1), (3, 3, 0)))
        self.file("wall.off", boolean_test.box((0, -3, -1), (3, 3, 5)))
        operands = {"L": "low.vjson", "H": "high.vjson", "W": "wide.vjson", "F": "floor.off", "X": "wall.off"}
        points = "0 0 2", "1/4 0 2", "0 0 0", "0 0 4", "0 0 1"
        for expression, words in (("L | H", "in in on on in"), ("L & H", "out out out out out"), ("L - H", "on on on out in"), ("H - L", "on on out on out"),
                                  ("L | W", "in in on out in"), ("L & W", "out out out out out"), ("L - W", "on on on out in"), ("L | F", "on on in out in"),
                                  ("F - L", "out out on out out"), ("L & F", "out out out out out"), ("F | L | H", "in in in on in"), ("L & X", "on on on out on"),
                                  ("(L | H) - X", "on out on on on"), ("(L & X) | (H - X)", "on on on on on"), ("X & L & H", "out out out out out")):
            self.covers(expression, operands, points, words)

    def test_where_they_stay_uncovered(self):
        """A side collapsed where a patch leaves in directions of a half turn, or with a curved wall; a rim of a cap."""
        self.file("low.vjson", cylinder(0, 0, 2, arc=HALF))
        self.file("high.vjson", cylinder(0, 2, 4))
        (self.folder / "ball.vjson").write_bytes(patch_points_forge.Solid([patch_points_forge.ball()]).encode())
        self.file("half.off", boolean_test.box((0, -2, -2), (2, 2, 2)))
        operands = {"L": "low.vjson", "H": "high.vjson", "B": "ball.vjson", "X": "half.off"}
        self.covers("L | H", operands, ("0 0 2", "1/4 1/4 2", "3/5 4/5 2", "0 0 0"), "in in on on", 2)
        self.covers("B & X", operands, ("0 0 1", "0 0 -1", "0 0 0"), "on on on", 2)

    def test_turned_cylinders_and_cones(self):
        """Two discs with different centres in one plane, which a third wall passes; the truth is that of half-spaces."""
        first, count = int(os.environ.get("VT_TEST_SEED", "0")), 8 * int(os.environ.get("VT_TEST_SCALE", "1"))
        for seed in range(first, first + count):
            rng = random.Random(seed)
            place, x, radii = rational_rotation(rng), rng.choice(DISTANCES), (rng.choice((Q(7, 4), 2, 3)), rng.choice((Q(7, 4), 2, 3)))
            sides = rng.choice((-1, 1)), rng.choice((-1, 1))  # on which side of z = 0 the solids are
            for name, at, radius, side in (("a", 0, radii[0], sides[0]), ("b", x, radii[1], sides[1])):
                low, high = sorted((0, side * rng.randint(1, 2)))
                other = rng.choice((None, 0, 1)) if side > 0 else None    # a cone stands on z = 0
                self.file(name + ".vjson", cylinder(at, low, high, radius=radius, top=other, turn=unit_vector(rng), place=place))
            bounds = [(-4, 4), (-4, 4), rng.choice(((-3, 0), (0, 3), (-3, 3)))]
            bounds[1] = rng.choice((bounds[1], (0, 4)))
            corners, quads = expression_forge.box_corners(*zip(*bounds))
            entities = [expression_forge.fan_forge.plain([tuple(place(corners[v])) for v in quad]) for quad in quads]
            (self.folder / "c.vjson").write_bytes(expression_forge.encode(entities))
            expression = rng.choice(("A | B", "A & B", "A - B", "A - B - C", "(A | B) & C", "A & C", "(A - C) | (B - A)", "A | B | C", "B - C", "A & !B & C"))
            at = [(d, 0, 0) for d in DISTANCES]
            cells = [(y, z) for y in (-1, 1) for z in (-1, 1)]
            words = []
            for _ in at:
                values = set()
                for y, z in cells:
                    bits = {"A": z == sides[0], "B": z == sides[1], "C": bounds[1][0] <= y <= 4 and bounds[2][0] <= z <= bounds[2][1]}
                    values.add(bool(eval(expression.replace("-", "& ~").replace("!", "~").translate(
                        {ord(k): str(-1 if bits[k] else 0) for k in "ABC"}))))
                words.append("on" if len(values) == 2 else "in" if True in values else "out")
            self.covers(expression, {k: k.lower() + ".vjson" for k in "ABC"}, [" ".join(map(str, place(p))) for p in at], " ".join(words))


if __name__ == "__main__":
    unittest.main()
