#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker of vmodel-invalid-1: a true certificate of every finding, and for each condition a lie that differs from a true
certificate in nothing else. Bodies are written here, from the page. VERITOPE_CHECK names the program."""
import hashlib
import itertools
import json
import random
import unittest
from fractions import Fraction as Q

import judges
import model_texts as texts
import vmodel_models as models
from star_box_forge import u32, varint, zigzag
from vmodel_models import box, permuted, spline
from volume_folded_forge import bezier, cube, folded_cube, made_rational, with_knots

KINDS = ("flat", "left-handed", "singular", "overlap", "curve-nonmanifold", "point-nonmanifold")
WHOLE = (0, 0, 0, 1)                                      # an interval: k, e, a, b


def point(cell, *parameters):
    """parameters: (k, n, d) for each axis."""
    return varint(cell) + b"".join(varint(x) for p in parameters for x in p)


def corner_of_cell(cell, *ends):
    return point(cell, *[(0, e, 1) for e in ends])


def middle(cell):
    return point(cell, *[(0, 1, 2)] * 3)


def box_of_cell(cell, *intervals):
    return varint(cell) + b"".join(varint(x) for t in intervals for x in t)


def matrix(*rows):
    return b"".join(zigzag(y) for row in rows for y in row)


def arc(cell, face, side, t=WHOLE):
    return varint(cell) + bytes([face, side]) + b"".join(map(varint, t))


class Body:
    def __init__(self, maps, kind, *parts):
        self.maps, self.kind, self.parts = maps, KINDS.index(kind), b"".join(parts)
        self.count, self.magic, self.values = len(maps), b"VTVI", {}

    def certificate(self, model):
        body = self.magic + u32(self.count) + bytes([self.kind]) + self.parts
        statement = {"certificate": "veritope-certificate-1", "tool": "vmodel_invalid_cpp_test", "claim": "vmodel-invalid-1",
                     "subject_sha256": hashlib.sha256(model).hexdigest(), "subject_bytes": len(model), "subject_format": "vjson",
                     "body_sha256": hashlib.sha256(body).hexdigest(), "finding": KINDS[min(self.kind, 5)], "cells": len(self.maps),
                     **self.values}
        return json.dumps(statement, separators=(",", ":")).encode() + b"\n" + body


def verdict(body, model=None):
    """ACCEPT or the condition that fails."""
    model = texts.json_text(body.maps) if model is None else model
    code, said, output = judges.in_cpp(model, body.certificate(model))
    assert (code, said == "ACCEPT") in ((0, True), (1, False)), output
    return said


IDENTITY = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
UNIT = cube()
FLAT = cube(lambda p: (p[0], p[1], 0))
MIRRORED = cube(lambda p: (-p[0], p[1], p[2]))
# Flat between the knots 1 and 2 of its first axis, and there alone.
FLAT_IN_ONE_SPAN = spline((1, 1, 1), [with_knots(1, [1, 2]), [0, 0, 1, 1], [0, 0, 1, 1]], lambda i, j, k: ((0, 1, 1, 2)[i], j, k))
OVERLAPPING = [UNIT, box((Q(1, 2), 0, 0), (Q(3, 2), 1, 1))]
AT_AN_EDGE = [UNIT, box((1, 1, 0), (2, 2, 1))]            # they share x = y = 1
ARCS = (arc(0, 1, 3), arc(0, 3, 3), arc(1, 0, 2))         # of these two
AT_A_CORNER = [UNIT, box((1, 1, 1), (2, 2, 2))]
OCTANTS = [box(lo, [c + 1 for c in lo]) for lo in itertools.product((0, 1), repeat=3)]
SIX_OF_EIGHT = OCTANTS[1:7]                               # all have the corner (1, 1, 1)
# Its edges along the second axis are points where its third parameter is 0 and its first one at most 1/2: no face is collapsed.
HALF_COLLAPSED = spline((1, 1, 1), [[0, 0, Q(1, 2), 1, 1], [0, 0, 1, 1], [0, 0, 1, 1]],
                        lambda i, j, k: (3 * i - 1, (3 * j - 1) * (k if i < 2 else 1) + (1 - k) * (i < 2), 3 * k - 1))


def corner(cell, number):
    return varint(cell) + bytes([number])


def with_more_knots(m, axis, inner):
    """The map of degree 1 along the axis with the knots inserted."""
    net, knots = m.all(), sorted([*m.knots[axis], *map(Q, inner)])
    n, found = len(knots) - 2, {}
    for index in itertools.product(*[range(n if a == axis else s) for a, s in enumerate(m.sizes)]):
        low, high = [net[index[:axis] + (e,) + index[axis + 1:]] for e in (0, 1)]
        t = (knots[index[axis] + 1] - knots[0]) / (knots[-1] - knots[0])
        found[index] = tuple((1 - t) * x + t * y for x, y in zip(low, high))
    sizes = [n if a == axis else s for a, s in enumerate(m.sizes)]
    points = [found[i, j, k][:None if m.rational else 3] for k in range(sizes[2]) for j in range(sizes[1]) for i in range(sizes[0])]
    return texts.Map(m.degrees, [knots if a == axis else t for a, t in enumerate(m.knots)], points, m.rational)


def weighted(m):
    """The map of degrees 1 with the weights 2^(i + j + k)."""
    return texts.Map(m.degrees, m.knots, [tuple(c * 2 ** bin(n).count("1") for c in (*p, 1)) for n, p in enumerate(m.points)], True)


def true_bodies():
    """name: Body"""
    overlap_box = (middle(0), b"\1", box_of_cell(1, WHOLE, WHOLE, WHOLE), matrix(*IDENTITY))
    moved = [UNIT, box((Q(1, 4), Q(1, 4), Q(1, 4)), (2, 2, 2))]
    folding_edge = spline((1, 1, 1), [[0, 0, 1, 1], [0, 0, 1, 1], with_knots(1, [1])], lambda i, j, k: (i, j, (0, 1, 3 * (i + j))[k]))
    halved = [UNIT, cube(lambda p: (1 + p[0], 1 + p[1], p[2] / 2)), box((1, 1, Q(1, 2)), (2, 2, 1))]
    return {
        "flat": Body([FLAT], "flat", varint(0), bytes(3)),
        "flat in one span": Body([UNIT, FLAT_IN_ONE_SPAN], "flat", varint(1), bytes([1, 0, 0])),
        "flat, rational": Body([weighted(FLAT)], "flat", varint(0), bytes(3)),
        "left-handed": Body([UNIT, MIRRORED], "left-handed", middle(1)),
        "folded": Body([folded_cube()], "left-handed", corner_of_cell(0, 1, 1, 1)),
        "singular": Body([models.squares()], "singular", corner_of_cell(0, 0, 1, 0)),
        "singular inside": Body([bezier((3, 1, 1), lambda u, v, w: ((0, 1, 0, 1)[int(3 * u)], v, w))], "singular", middle(0)),
        "a collapsed face is singular": Body([models.pyramid()], "singular", corner_of_cell(0, 0, 1, 0)),
        "overlap": Body(OVERLAPPING, "overlap", point(0, (0, 3, 4), (0, 1, 2), (0, 1, 2)), b"\0", point(1, (0, 1, 4), (0, 2, 4), (0, 3, 6))),
        "overlap at a boundary": Body(OVERLAPPING, "overlap", middle(0), b"\0", point(1, (0, 0, 1), (0, 1, 2), (0, 1, 2))),
        "overlap with itself": Body([FLAT_IN_ONE_SPAN], "overlap", point(0, (1, 1, 4), (0, 1, 2), (0, 1, 2)), b"\0",
                                    point(0, (1, 3, 4), (0, 1, 2), (0, 1, 2))),
        "overlap with itself in another span": Body([FLAT_IN_ONE_SPAN], "overlap", point(0, (0, 1, 1), (0, 1, 2), (0, 1, 2)), b"\0",
                                                    point(0, (2, 0, 1), (0, 1, 2), (0, 1, 2))),
        "overlap, rational": Body([weighted(UNIT), UNIT], "overlap", middle(0), b"\0", point(1, *[(0, 2, 3)] * 3)),
        "overlap with a box": Body(moved, "overlap", *overlap_box),
        "overlap with a part of a box": Body(moved, "overlap", middle(0), b"\1", box_of_cell(1, *[(0, 2, 0, 1)] * 3), matrix(*IDENTITY)),
        "overlap with a rational box": Body([moved[0], weighted(moved[1])], "overlap", *overlap_box),
        "overlap with a box of the cell": Body([spline((1, 1, 1), [with_knots(1, [1])] + [[0, 0, 1, 1]] * 2, lambda i, j, k: ((0, 1, 0)[i], j, k))],
                                               "overlap", middle(0), b"\1", box_of_cell(0, (1, 0, 0, 1), WHOLE, WHOLE),
                                               matrix((-1, 0, 0), (0, 1, 0), (0, 0, 1))),
        "an edge": Body(AT_AN_EDGE, "curve-nonmanifold", *ARCS),
        "a part of an edge": Body(AT_AN_EDGE, "curve-nonmanifold", *[arc(c, f, s, (0, 3, 1, 4)) for c, f, s in ((1, 2, 2), (0, 1, 3), (0, 3, 3))]),
        "an edge, reversed": Body([UNIT, permuted(AT_AN_EDGE[1], (0, 1, 2), (0, 0, 1))], "curve-nonmanifold", *ARCS),
        "an edge, reversed in part": Body([UNIT, permuted(AT_AN_EDGE[1], (0, 1, 2), (0, 0, 1))], "curve-nonmanifold", arc(0, 1, 3, (0, 2, 0, 1)),
                                          arc(0, 3, 3, (0, 2, 0, 1)), arc(1, 0, 2, (0, 2, 3, 4))),
        "an edge in other degrees": Body([UNIT, models.raised_cell(AT_AN_EDGE[1], 2)], "curve-nonmanifold", *ARCS),
        "a part of a longer edge": Body(halved, "curve-nonmanifold", arc(0, 1, 3, (0, 1, 0, 1)), arc(0, 3, 3, (0, 1, 0, 1)), arc(1, 0, 2)),
        "an edge that runs back": Body([folding_edge], "curve-nonmanifold", arc(0, 0, 2), arc(0, 0, 2, (1, 0, 0, 1)), arc(0, 2, 2)),
        "a corner": Body(AT_A_CORNER, "point-nonmanifold", corner(0, 7)),
        "a corner, from the other cell": Body(AT_A_CORNER, "point-nonmanifold", corner(1, 0)),
        "a corner of three": Body([UNIT, box((1, 0, 0), (2, 1, 1)), box((0, 1, 1), (1, 2, 2))], "point-nonmanifold", corner(0, 7)),
        "an edge has corners": Body(AT_AN_EDGE, "point-nonmanifold", corner(0, 3)),
        "six of eight": Body(SIX_OF_EIGHT, "point-nonmanifold", corner(0, 3)),
        "six of eight, some of them rational": Body([made_rational(m) if n % 2 else models.raised_cell(m, n % 3)
                                                     for n, m in enumerate(SIX_OF_EIGHT)], "point-nonmanifold", corner(0, 3)),
        "two pyramids at their apexes": Body([models.pyramid(), models.mapped(models.pyramid(), lambda p: (-p[0], -p[1], p[2]))],
                                             "point-nonmanifold", corner(0, 0)),
    }


TRUE = true_bodies()


def changed(name, **fields):
    new = Body(fields.get("maps", TRUE[name].maps), KINDS[TRUE[name].kind], TRUE[name].parts)
    for key, value in fields.items():
        setattr(new, key, value)
    return new


def bodies_at_all_corners(maps):
    return [Body(maps, "point-nonmanifold", corner(c, n)) for c in range(len(maps)) for n in range(8)]


def bodies_on_all_edges(maps):
    """Three arcs of every three faces' sides."""
    sides = [(c, f, s) for c in range(len(maps)) for f in range(6) for s in range(4)]
    return [Body(maps, "curve-nonmanifold", *[arc(*side) for side in three]) for three in itertools.combinations(sides, 3)]


class Findings(unittest.TestCase):
    def test_true_certificates_are_accepted(self):
        for name, body in TRUE.items():
            with self.subTest(name):
                self.assertEqual(verdict(body), "ACCEPT")

    def test_valid_models_have_no_vertex_twice(self):
        neighbours = [UNIT, box((1, 0, 0), (2, 1, 1))]
        valid = {"a cube": [UNIT], "two": neighbours, "an L": [*neighbours, box((0, 1, 0), (1, 2, 1))], "seven of eight": OCTANTS[:7],
                 "knots inserted on one side": [UNIT, with_more_knots(with_more_knots(neighbours[1], 1, [Q(1, 3), Q(1, 2)]), 2, [Q(1, 5)])],
                 "knots inserted on both sides, one turned": [
                     with_more_knots(UNIT, 1, [Q(1, 4), Q(1, 2)]),
                     permuted(with_more_knots(with_more_knots(neighbours[1], 1, [Q(1, 3), Q(1, 2)]), 2, [Q(1, 5)]), (2, 0, 1), (1, 1, 0))],
                 "in other degrees and weights": [models.raised_cell(UNIT, 1), models.weighted(models.raised_cell(neighbours[1], 2))],
                 "a ring": [models.closed_frame()], "a wedge": [cube(lambda p: (p[0], p[0] * p[1], p[2]))],
                 "a wedge beside a box": [cube(lambda p: (p[0], p[0] * p[1], p[2])), box((0, -1, 0), (1, 0, 1))],
                 "a pyramid": [models.pyramid()], "six pyramids": models.pyramids_of_a_cube(), "a fan": models.fan(),
                 "three quarters of a fan": models.fan()[:3], "a shrunk edge": [models.shrunk_edge()],
                 "half collapsed, split": models.half_collapsed(True), "a figure eight": models.figure_eight()}
        for name, maps in valid.items():
            for body in bodies_at_all_corners(maps):
                with self.subTest(name, corner=body.parts):
                    self.assertEqual(verdict(body), "P2")

    def test_valid_models_have_no_arc_thrice(self):
        wedge = cube(lambda p: (p[0], p[0] * p[1], p[2]))
        for name, maps in {"a cube": [UNIT], "a wedge": [wedge]}.items():
            for body in bodies_on_all_edges(maps):
                self.assertIn(verdict(body), ("C2", "C3"), (name, body.parts))
        ring = [models.closed_frame()]
        for three in itertools.combinations([(0, f, s) for f in (2, 4) for s in (0, 1, 2, 3)], 3):
            self.assertIn(verdict(Body(ring, "curve-nonmanifold", *[arc(*a) for a in three])), ("C2", "C3"), three)

    def test_a_corner_at_which_a_fan_is_missing_a_sector(self):
        """Opposite wedges of a fan share their axis; two that are side by side are one solid."""
        a, b, c, _ = models.fan()
        on_axis = (arc(0, 2, 2), arc(0, 3, 2), arc(1, 2, 2))
        self.assertEqual(verdict(Body([a, c], "curve-nonmanifold", *on_axis)), "ACCEPT")
        self.assertEqual(verdict(Body([a, b], "curve-nonmanifold", *on_axis)), "C3")
        self.assertEqual(verdict(Body([a, c], "point-nonmanifold", corner(0, 0))), "ACCEPT")
        self.assertEqual(verdict(Body([a, b], "point-nonmanifold", corner(0, 0))), "P2")


class Hostile(unittest.TestCase):
    def test_changed_bodies_do_not_crash(self):
        rng = random.Random(20)
        for name, body in TRUE.items():
            for _ in range(4):
                parts = bytearray(body.parts)
                for _ in range(rng.randint(1, 3)):
                    parts[rng.randrange(len(parts))] = rng.choice((0, 1, 2, 127, 128, 255, rng.randrange(256)))
                if rng.randrange(4) == 0:
                    del parts[rng.randrange(len(parts)):]
                model = texts.json_text(body.maps)
                code, _, said = judges.in_cpp(model, changed(name, parts=bytes(parts)).certificate(model))
                self.assertIn(code, (0, 1), (name, bytes(parts), said))

    def test_work_is_limited(self):
        """Cells whose faces have equal corners, and differ inside, so that every two of them are cut and compared."""
        def cell(c):
            inside = 20 * (c + 1)
            return bezier((15, 1, 1), lambda u, v, w: (15 * u - c * ((u, v, w) == (0, 1, 1)), *(x + (inside if 0 < u < 1 else 0) for x in (v, w))))
        few = Body([cell(c) for c in range(4)], "point-nonmanifold", corner(0, 0))
        self.assertEqual(verdict(few), "ACCEPT")
        many = Body([cell(c) for c in range(30)], "point-nonmanifold", corner(0, 0))
        self.assertEqual(verdict(many), "B2")


class Lies(unittest.TestCase):
    def rejects(self, condition, body, model=None):
        self.assertEqual(verdict(body, model), condition)

    def test_s1(self):
        self.rejects("S1", changed("flat", values={"finding": "crossing"}))
        self.rejects("S1", changed("flat", values={"subject_format": "vjson-faces"}))

    def test_b1(self):
        for fields in ({"magic": b"VTVM"}, {"count": 2}, {"kind": 6}, {"parts": bytes(5)}, {"parts": bytes(3)}, {"parts": b"\1" + bytes(3)},
                       {"parts": b"\0\1\0\0"}, {"parts": b"\0\0\0\1"}):
            self.rejects("B1", changed("flat", **fields))
        good = [(0, 1, 2)] * 3
        for bad in ((1, 1, 2), (0, 1, 0), (0, 3, 2)):
            for axis in range(3):
                self.rejects("B1", changed("left-handed", parts=point(1, *good[:axis], bad, *good[axis + 1:])))
        self.rejects("B1", changed("left-handed", parts=middle(2)))
        a, y = middle(0), matrix(*IDENTITY)
        for bad in ((1, 0, 0, 1), (0, 63, 0, 1), (0, 0, 0, 2), (0, 2, 3, 2), (0, 2, 2, 2)):
            self.rejects("B1", changed("overlap with a box", parts=a + b"\1" + box_of_cell(1, WHOLE, bad, WHOLE) + y))
            self.rejects("B1", changed("an edge", parts=ARCS[0] + ARCS[1] + arc(1, 0, 2, bad)))
        self.rejects("B1", changed("overlap with a box", parts=a + b"\2" + box_of_cell(1, WHOLE, WHOLE, WHOLE) + y))
        self.rejects("B1", changed("overlap with a box", parts=a + b"\1" + box_of_cell(2, WHOLE, WHOLE, WHOLE) + y))
        self.rejects("B1", changed("overlap with a box", parts=TRUE["overlap with a box"].parts[:-1]))
        for bad in (arc(2, 0, 2), arc(1, 6, 2), arc(1, 0, 4)):
            self.rejects("B1", changed("an edge", parts=ARCS[0] + ARCS[1] + bad))
        self.rejects("B1", changed("a corner", parts=corner(0, 8)))
        self.rejects("B1", changed("a corner", parts=corner(2, 7)))

    def test_b2(self):
        long = bezier((16, 1, 1), lambda u, v, w: (u, v, w))
        self.rejects("B2", Body([FLAT, long], "flat", varint(0), bytes(3)))
        tiny = Q(1, 1 << 260)
        near = texts.Map((1, 1, 1), [[0, 0, tiny, tiny], [0, 0, 1, 1], [0, 0, 1, 1]], MIRRORED.points)
        self.rejects("B2", Body([near], "left-handed", middle(0)))
        self.rejects("B2", Body([UNIT, near], "overlap", middle(0), b"\0", middle(1)))

    def test_b2_of_what_is_cut(self):
        """Differences of knots have at most 2048 bits: at 1, between 0 and 2, they are the numerators over 2^2040 and 3^..."""
        t = Q(1, 3 ** 1280)                               # 2029 bits
        knots = [0, 0, t, Q(1, 2 ** 1000), 1, 1]
        maps = [spline((1, 1, 1), [knots, [0, 0, 1, 1], [0, 0, 1, 1]], lambda i, j, k: (i, j, 0))]
        self.rejects("ACCEPT", Body(maps, "flat", varint(0), bytes([0, 0, 0])))
        self.rejects("B2", Body(maps, "flat", varint(0), bytes([1, 0, 0])))

    def test_b3(self):
        self.rejects("B3", changed("flat", values={"finding": "singular"}))
        self.rejects("B3", changed("a corner", values={"cells": 3}))

    def test_f1_h1_z1(self):
        self.rejects("F1", changed("flat", maps=[UNIT]))
        self.rejects("F1", changed("flat in one span", parts=varint(1) + bytes([0, 0, 0])))
        self.rejects("F1", changed("flat in one span", parts=varint(1) + bytes([2, 0, 0])))
        self.rejects("F1", changed("flat", maps=[models.squares()]))
        self.rejects("H1", changed("left-handed", parts=middle(0)))
        self.rejects("H1", changed("folded", parts=corner_of_cell(0, 0, 0, 0)))
        self.rejects("H1", changed("singular", kind=1))
        self.rejects("Z1", changed("singular", parts=middle(0)))
        self.rejects("Z1", changed("left-handed", kind=2))

    def test_o1(self):
        """A lies on each face of its cell in turn."""
        for axis, end in itertools.product(range(3), range(2)):
            at = [(0, 1, 2)] * 3
            at[axis] = (0, end, 1)
            self.rejects("O1", Body([UNIT, UNIT], "overlap", point(0, *at), b"\0", point(1, *at)))
        at = ((2, 5, 5), (0, 1, 2), (0, 1, 2))            # the last knot, by the last span
        self.rejects("O1", Body([FLAT_IN_ONE_SPAN] * 2, "overlap", point(0, *at), b"\0", point(1, *at)))

    def test_o2(self):
        inside = ((0, 1, 2), (0, 1, 2))
        self.rejects("O2", changed("overlap", parts=middle(0) + b"\0" + point(0, *[(0, 3, 6)] * 3)))
        # A knot as the end of one span and as the begin of the next one.
        self.rejects("O2", Body([FLAT_IN_ONE_SPAN], "overlap", point(0, (0, 7, 7), *inside), b"\0", point(0, (1, 0, 3), *inside)))
        of_box = b"\1" + box_of_cell(0, (1, 1, 0, 1), WHOLE, WHOLE) + matrix((-1, 0, 0), (0, 1, 0), (0, 0, 1))
        ridge = TRUE["overlap with a box of the cell"].maps
        self.rejects("O2", Body(ridge, "overlap", point(0, (0, 1, 1), *inside), of_box))
        self.rejects("O2", Body(ridge, "overlap", point(0, (1, 1, 2), *inside), of_box))
        self.rejects("O4", Body(ridge, "overlap", point(0, (1, 2, 3), *inside), of_box))

    def test_o3_o4(self):
        for axis in range(3):
            at = [[0, 1, 4], [0, 1, 2], [0, 1, 2]]
            at[axis][1:] = 3, 8
            self.rejects("O3", changed("overlap", parts=point(0, (0, 3, 4), (0, 1, 2), (0, 1, 2)) + b"\0" + point(1, *at)))
            rows = [list(row) for row in IDENTITY]
            for value in (0, -1):
                rows[axis][axis] = value
                parts = middle(0) + b"\1" + box_of_cell(1, WHOLE, WHOLE, WHOLE) + matrix(*rows)
                self.rejects("O4", changed("overlap with a box", parts=parts))
            ends = [WHOLE] * 3
            # 1/2 is at 1/7 of the side: below the first, above the second; at the begin of the third.
            for part in ((0, 2, 1, 4), (0, 3, 0, 1)):
                ends[axis] = part
                parts = middle(0) + b"\1" + box_of_cell(1, *ends) + matrix(*IDENTITY)
                self.rejects("O4", changed("overlap with a box", parts=parts))
        touching = [UNIT, box((Q(1, 2), 0, 0), (1, 1, 1))]  # a coefficient that is 0
        self.rejects("O4", changed("overlap with a box", maps=touching))

    def test_c1(self):
        self.rejects("C1", changed("an edge", parts=ARCS[0] + ARCS[1] + ARCS[0]))
        self.rejects("C1", changed("an edge", parts=ARCS[0] + arc(0, 1, 3, (0, 3, 3, 4)) + ARCS[2]))
        self.rejects("C1", changed("an edge", parts=ARCS[0] + arc(0, 1, 3, (0, 62, 1, 2)) + arc(0, 1, 3, (0, 62, 2, 3))))
        self.rejects("C2", changed("an edge", parts=arc(0, 1, 3, (0, 1, 1, 2)) + arc(0, 1, 3, (0, 62, 1, 2)) + arc(0, 1, 3, (0, 62, 2, 3))))

    def test_c2(self):
        self.rejects("C2", changed("an edge", parts=ARCS[0] + ARCS[1] + arc(1, 0, 3)))
        self.rejects("C2", changed("an edge", parts=ARCS[0] + ARCS[1] + arc(1, 0, 2, (0, 1, 0, 1))))
        self.rejects("C2", changed("an edge", parts=arc(0, 0, 0) + ARCS[1] + ARCS[2]))
        shrunk = models.shrunk_edge()                     # the edge x = y = 1 is a point
        self.rejects("C2", changed("an edge", maps=[shrunk, shrunk]))
        # A curve of the same points at another speed.
        slow = [UNIT, bezier((1, 1, 2), lambda u, v, w: (1 + u, 1 + v, (0, 0, 1)[int(2 * w)]))]
        self.rejects("C2", changed("an edge", maps=slow))

    def test_c3(self):
        self.rejects("C3", changed("an edge", maps=[*AT_AN_EDGE, box((1, 0, 0), (2, 1, 1))]))
        self.rejects("C3", changed("an edge", maps=[*AT_AN_EDGE, box((0, 1, 0), (1, 2, 1))]))
        third = with_more_knots(permuted(box((1, 0, 0), (2, 1, 1)), (2, 0, 1), (1, 0, 1)), 0, [Q(1, 3)])
        self.rejects("C3", changed("an edge", maps=[*AT_AN_EDGE, third]))
        # A face with the same corners is another one: it is curved.
        bulging = bezier((2, 2, 2), lambda u, v, w: (1 + u - (Q(1, 9) if u == 0 and v == w == Q(1, 2) else 0), v, w))
        self.rejects("ACCEPT", changed("an edge", maps=[*AT_AN_EDGE, bulging]))
        wedge = cube(lambda p: (p[0], p[0] * p[1], p[2]))
        self.rejects("C3", Body([wedge], "curve-nonmanifold", arc(0, 2, 2), arc(0, 3, 2), arc(0, 0, 2)))

    def test_v1(self):
        self.rejects("V1", changed("an edge", maps=[*AT_AN_EDGE, HALF_COLLAPSED]))
        self.rejects("V1", changed("a corner", maps=[*AT_A_CORNER, HALF_COLLAPSED]))
        far = models.mapped(HALF_COLLAPSED, lambda p: (p[0], p[1], p[2] + 3))
        self.rejects("ACCEPT", changed("an edge", maps=[*AT_AN_EDGE, far]))
        self.rejects("ACCEPT", changed("a corner", maps=[*AT_A_CORNER, far]))
        touching = models.mapped(HALF_COLLAPSED, lambda p: (p[0], p[1], p[2] + 2))  # from z = 1 on
        self.rejects("V1", changed("a corner", maps=[*AT_A_CORNER, touching]))

    def test_p1(self):
        """Three faces are equal."""
        thick = box((1, 0, 0), (3, 1, 1))
        self.rejects("P1", Body([UNIT, box((1, 0, 0), (2, 1, 1)), thick, AT_A_CORNER[1]], "point-nonmanifold", corner(0, 7)))
        self.rejects("ACCEPT", Body([UNIT, thick, AT_A_CORNER[1]], "point-nonmanifold", corner(0, 7)))

    def test_p2(self):
        self.rejects("P2", changed("a corner", parts=corner(0, 6)))
        self.rejects("P2", changed("six of eight", parts=corner(0, 2)))
        self.rejects("P2", changed("six of eight", maps=[*SIX_OF_EIGHT, OCTANTS[7]]))
        self.rejects("P2", changed("six of eight", maps=OCTANTS[1:] + OCTANTS[:1]))  # there is no border


if __name__ == "__main__":
    unittest.main()
