#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The Python checker of vmodel-invalid-1: true findings of each kind, a lie for every condition, valid models about which no finding is
accepted, limits, hostile bytes. A lie that the test calls `alone` is accepted without the condition that rejects it."""
import collections
import itertools
import os
import random
import unittest
from fractions import Fraction as Q

import model_texts as texts
import vmodel_forge
import vmodel_invalid_forge as forge
import vmodel_invalid_models as models
import vmodel_models as valid
from vmodel_invalid_forge import WHOLE, Invalid
from vmodel_invalid_lies import bent_bytes, lies, negated
from vmodel_invalid_models import HALF, IDENTITY, OCTANT_RINGS, arc, at, border_cycles, sides_by_curve
from volume_folded_forge import bezier, cube

from veritope_checker import program as vc                # star_box_forge says where it is
from veritope_checker.patches.model_maps import Volume
from veritope_checker.vmodel import vmodel_equal, vmodel_invalid_check

SCALE = int(os.environ.get("VT_TEST_SCALE", "1"))
CONDITIONS = ("B2", "B3", "F1", "H1", "Z1", "O1", "O2", "O3", "O4", "C1", "C2", "C3", "V1", "P1", "P2")


class InvalidTest(unittest.TestCase):
    def line(self, lie, skip=()):
        model = lie.model()
        return vc._check(model, lie.certificate(model), frozenset(skip))

    def says(self, expected, lie, skip=()):
        code, line = self.line(lie, skip)
        self.assertEqual(line.split(":")[0].replace("REJECT ", "").replace("ACCEPT " + lie.claim, "ACCEPT"), expected, line)
        self.assertEqual(code, {"ACCEPT": 0, "ERROR": 4}.get(expected, 1), line)

    def alone(self, condition, lie):
        self.says(condition, lie)
        self.says("ACCEPT", lie, {condition})


class Honest(InvalidTest):
    # PROVES VMODEL-2
    def test_findings_of_every_kind(self):
        for name in models.made():
            with self.subTest(name):
                self.says("ACCEPT", models.honest(name))
        self.assertEqual({f.kind for f in models.made().values()}, set(forge.KINDS))


class Lies(InvalidTest):
    # PROVES VMODEL-2.F
    def test_each_is_rejected_by_one_condition_and_accepted_without_it(self):
        found = collections.Counter()
        for what, condition, lie in lies():
            with self.subTest(what, condition=condition, parts=lie.parts):
                self.alone(condition, lie)
                found[condition] += 1
        self.assertEqual(set(found), set(CONDITIONS))


class ValidModels(InvalidTest):
    """No finding but left-handed and singular is accepted about them."""

    def test_no_corner_is_accepted(self):
        for name, maps in models.valid_models().items():
            for seed in range(2):
                cells = maps if seed == 0 else valid.renamed(maps, random.Random(name))[0]
                first = Invalid(cells, "point-nonmanifold", 0, 0)
                first.model()
                for cell, corner in itertools.product(range(len(cells)), range(8)):
                    with self.subTest(name, seed=seed, cell=cell, corner=corner):
                        self.says("P2", first.changed(parts=(cell, corner)))

    def test_no_three_sides_with_one_curve_are_accepted(self):
        tried = 0
        for name, maps in models.valid_models().items():
            rng, first = random.Random(name), Invalid(maps, "curve-nonmanifold")
            first.model()
            for arcs in sides_by_curve(maps).values():
                for three in rng.sample(list(itertools.combinations(arcs, 3)), min(4 * SCALE, len(arcs) * (len(arcs) - 1) * (len(arcs) - 2) // 6)):
                    with self.subTest(name, arcs=three):
                        self.says("C3", first.changed(parts=three))
                        tried += 1
        self.assertGreater(tried, 500)

    def test_no_point_and_no_box_is_an_overlap(self):
        """Points on a common face, in both cells; boxes with the rows that fit the cell."""
        rng = random.Random(5)
        for name, maps in models.valid_models().items():
            for trial in range(3 * SCALE):
                cells = [rng.randrange(len(maps)) for _ in range(2)]
                a, b = [(c, tuple((rng.randrange(len(set(t)) - 1), rng.choice((Q(1, 2), Q(1, 4), Q(2, 3)))) for t in maps[c].knots)) for c in cells]
                if a != b:
                    self.says("O3", Invalid(maps, "overlap", a, b))
                spans = [(k, 3, *sorted(rng.sample(range(9), 2))) for k, _ in b[1]]
                for y in (IDENTITY, negated(IDENTITY), tuple(tuple(rng.randint(-9, 9) for _ in range(3)) for _ in range(3))):
                    code, line = self.line(Invalid(maps, "overlap", a, (b[0], spans), y))
                    self.assertRegex(line, "REJECT O[24]", (name, trial, a, b, spans, y))

    def test_left_handed_and_singular_are_claims_of_their_own(self):
        """A reversed cell is left-handed, though the model is valid; a wedge is singular at its edge."""
        self.says("ACCEPT", Invalid(models.valid_models()["two, one of them mirrored and turned"], "left-handed", at(1, HALF, HALF, HALF)))
        self.says("ACCEPT", Invalid(models.valid_models()["a fan"], "singular", at(3, 0, HALF, HALF)))


class LiesThatTwoConditionsReject(InvalidTest):
    # PROVES VMODEL-2.O
    def test_a_point_on_a_face_of_its_box(self):
        for axis, part in itertools.product(range(3), ((0, 1, 0, 1), (0, 1, 1, 2))):
            parts = [WHOLE] * 3
            parts[axis] = part
            self.says("O2", Invalid([cube()], "overlap", at(0, HALF, HALF, HALF), (0, tuple(parts)), IDENTITY))


class Links(InvalidTest):
    """Cells around a point or a line, of which some are there. The point is claimed truly if the border of the cells, cut by a small sphere,
    is more than one cycle."""

    # PROVES VMODEL-2.P
    def test_all_sets_of_octants(self):
        counts = collections.Counter()
        for chosen in range(1, 256):
            octants = [o for o in range(8) if chosen >> o & 1]
            cells = [models.unit_box(*[(o >> a & 1) - 1 for a in range(3)]) for o in octants]
            cycles = border_cycles(octants, OCTANT_RINGS)
            self.says("ACCEPT" if cycles > 1 else "P2", Invalid(cells, "point-nonmanifold", 0, 7 - octants[0]))
            counts[cycles] += 1
        self.assertEqual(counts, {0: 1, 1: 162, 2: 82, 3: 8, 4: 2})

    def test_all_sets_of_pyramids(self):
        """Six pyramids with one apex, to which a face of each is collapsed; around each diagonal of the cube there are three."""
        pyramids, counts = valid.pyramids_of_a_cube(), collections.Counter()
        rings = [[x, 2 + y, 4 + z] for x, y, z in itertools.product((0, 1), repeat=3)]
        for chosen in range(1, 64):
            there = [n for n in range(6) if chosen >> n & 1]
            cycles = border_cycles(there, rings)
            cells, _ = valid.renamed([pyramids[n] for n in there], random.Random(chosen))
            self.says("ACCEPT" if cycles > 1 else "P2", Invalid(cells, "point-nonmanifold", *models.corner_at(cells, (0, 0, 0))))
            counts[cycles] += 1
        self.assertEqual(counts, {0: 1, 1: 56, 2: 6})

    def test_all_sets_of_wedges(self):
        """Four wedges around an axis, onto which a face of each is collapsed: the ends of the axis, and three sides along it."""
        fan = valid.fan()
        for chosen in range(1, 16):
            there = [n for n in range(4) if chosen >> n & 1]
            cells = [fan[n] for n in there]
            says = "ACCEPT" if there in ([0, 2], [1, 3]) else "P2"
            for end in (0, 1):
                self.says(says, Invalid(cells, "point-nonmanifold", *models.corner_at(cells, (0, 0, end))))
            sides = [(n, face) for n in range(len(there)) for face in (2, 3)]
            for three in itertools.combinations(sides, 3):
                border = all((there[n] + (1 if face == 3 else -1)) % 4 not in there for n, face in three)
                self.says("ACCEPT" if border else "C3", Invalid(cells, "curve-nonmanifold", *[arc(n, face, 2) for n, face in three]))

    # PROVES VMODEL-2.C
    def test_all_sets_of_quadrants(self):
        """Three arcs along the line are claimed truly if they are sides of border faces."""
        for chosen in range(1, 16):
            quadrants = [q for q in range(4) if chosen >> q & 1]
            cells = [models.unit_box(*[(q >> a & 1) - 1 for a in range(2)], 0) for q in quadrants]
            sides = [(n, q, axis) for n, q in enumerate(quadrants) for axis in range(2)]
            for three in itertools.combinations(sides, 3):
                arcs = [arc(n, 2 * axis + 1 - (q >> axis & 1), 2 + 1 - (q >> 1 - axis & 1)) for n, q, axis in three]
                borders = all(q ^ 1 << axis not in quadrants for _, q, axis in three)
                self.says("ACCEPT" if borders else "C3", Invalid(cells, "curve-nonmanifold", *arcs))


class EqualFaces(InvalidTest):
    def symmetries(self, first, second):
        """(face, symmetry) for the faces of the second cell that face 1 of the first equals."""
        faces = vmodel_equal.AllFaces([checkers(m) for m in (first, second)], lambda units: None)
        return [pair for pair in vmodel_equal.Candidates(faces, range(12)).equal_to(1)]

    def test_all_names_and_directions_of_parameters(self):
        """The common face of two cells has no symmetry of its own: one of eight fits, that of vmodel-1; knots differ on both sides."""
        bump = [Q(0), Q(1, 8), Q(1, 4), Q(1, 2)]

        def cell(first):
            return cube(lambda p: (first + p[0] + (bump[int(p[1] + 2 * p[2])] if first + p[0] == 1 else 0), p[1], p[2]))
        found = set()
        for axes in itertools.permutations(range(3)):
            for reverse in itertools.product((0, 1), repeat=3):
                other = valid.permuted(cell(1), axes, reverse)
                codes = vmodel_forge.glued(vmodel_forge.Faces([cell(0), other], [[[], [], []]] * 2), [0, valid.is_mirror(axes, reverse)])
                for ours in (cell(0), models.with_knot(cell(0), 1, Q(1, 3)), models.with_knot(cell(0), 2, Q(2, 7))):
                    for theirs in (other, models.with_knot(other, 1, Q(1, 5)), valid.weighted(valid.raised_cell(other, 2), 3)):
                        self.assertEqual(self.symmetries(ours, theirs), [codes[1]])
                found.add(codes[1])
        self.assertEqual(len(found), 48)

    def test_faces_that_are_not_equal(self):
        right = models.unit_box(1, 0, 0)
        self.assertEqual(self.symmetries(cube(), right), [(6, 0)])
        hair = Q(1, 1 << 52)
        for corner in range(8):
            moved = cube(lambda p, n=corner: (1 + p[0], p[1], p[2] + (hair if p == (n & 1, n >> 1 & 1, n >> 2) else 0)))
            self.assertEqual(self.symmetries(cube(), moved), [(6, 0)] if corner & 1 else [])
        squared = (0, Q(1, 4), 1)                         # the points of the face under another map: v -> (v + v^2) / 2
        self.assertEqual(self.symmetries(cube(), bezier((1, 2, 1), lambda u, v, w: (1 + u, squared[int(2 * v)], w))), [])
        shifted = models.with_knot(right, 1, HALF)        # its pieces are those of a face with a knot at 1/3
        shifted = texts.Map(shifted.degrees, [shifted.knots[0], [0, 0, Q(1, 3), 1, 1], shifted.knots[2]], shifted.points)
        self.assertEqual(self.symmetries(cube(), shifted), [])
        bulge = bezier((1, 2, 2), lambda u, v, w: (1 + u + (1 if (v, w) == (HALF, HALF) else 0), v, w))
        self.assertEqual(self.symmetries(cube(), bulge), [])

    def test_a_bump_between_knots(self):
        """One of two faces has a bump at the knot 1/5, which ends at the knots 1/10 and 3/10; the other has no knots."""
        knots = [[0, 0, 1, 1], [0, 0, Q(1, 10), Q(2, 10), Q(3, 10), 1, 1], [0, 0, 1, 1]]
        for bump in (0, 1):
            ours = valid.spline((1, 1, 1), knots, lambda i, j, k, b=bump: (Q(i) + (Q(b, 8) if (i, j) == (1, 2) else 0), knots[1][1 + j], Q(k)))
            for axes in itertools.permutations(range(3)):
                for reverse in itertools.product((0, 1), repeat=3):
                    theirs = valid.permuted(models.unit_box(1, 0, 0), axes, reverse)
                    self.assertEqual(len(self.symmetries(ours, theirs)), 1 - bump)
                    ours_last = valid.permuted(ours, axes, reverse)
                    faces = vmodel_equal.AllFaces([checkers(models.unit_box(1, 0, 0)), checkers(ours_last)], lambda units: None)
                    self.assertEqual(len(list(vmodel_equal.Candidates(faces, range(12)).equal_to(0))), 1 - bump)

    def test_faces_with_a_symmetry_of_their_own(self):
        """All corners of the face are two points: four symmetries take corners to corners, one makes the maps equal."""
        def cell(first):
            return bezier((1, 2, 1), lambda u, v, w: (first + u, (0, 1, 0)[int(2 * v)], w + v / 8 * (first + u == 9)))
        faces = self.symmetries(cell(0), cell(1))
        self.assertEqual(faces, [(6, 0)])


def checkers(m):
    """The map as the checker reads it."""
    return Volume(m.degrees, m.knots, m.rational, 3, list(m.all().values()))


class Bodies(InvalidTest):
    def test_every_format(self):
        for name in ("a flat cell", "a mirrored cube", "overlapping cubes, a box", "two cubes at an edge", "two cubes at a corner", "a spiral"):
            for subject_format in ("itd", "g2", "mfem"):
                with self.subTest(name, format=subject_format):
                    self.says("ACCEPT", models.honest(name).changed(subject_format=subject_format))
        for subject_format in ("vjson-faces", "stl"):
            self.says("S1", models.honest("a flat cell").changed(values={"subject_format": subject_format}))

    def test_statements(self):
        true = models.honest("a flat cell")
        for values in ({"finding": "folded"}, {"finding": ""}, {"cells": "1"}, {"pieces": 1}):
            self.says("S1", true.changed(values=values))

    def test_b1_of_the_head(self):
        for true in map(models.honest, ("a flat cell", "two cubes at an edge", "overlapping cubes", "two cubes at a corner")):
            for magic in (b"VTVM", b"VTVF", b"vtvi"):
                self.says("B1", true.changed(magic=magic))
            for count in (0, true.count + 1, 1 << 20, (1 << 32) - 1):
                self.says("B1", true.changed(count=count))
            for number in (6, 7, 255):
                self.says("B1", true.changed(number=number))
            self.says("B1", true.changed(tail=b"\0"))

    def test_b1_of_places(self):
        cubes = [cube(), models.unit_box(1, 1, 0)]
        ab = models.honest("two cubes at an edge").parts[:2]
        for cell in (2, 1 << 62, 1 << 63):
            for lie in (Invalid(cubes, "flat", cell, (0, 0, 0)), Invalid(cubes, "left-handed", at(cell, 0, 0, 0)),
                        Invalid(cubes, "overlap", at(0, 0, 0, 0), at(cell, 0, 0, 0)), Invalid(cubes, "point-nonmanifold", cell, 0),
                        Invalid(cubes, "overlap", at(0, 0, 0, 0), (cell, (WHOLE,) * 3), IDENTITY),
                        Invalid(cubes, "curve-nonmanifold", *ab, arc(cell, 0, 0))):
                self.says("B1", lie)
        self.says("B1", Invalid(cubes, "point-nonmanifold", 0, 8))
        for face, side in ((6, 0), (255, 0), (0, 4), (0, 255)):
            self.says("B1", Invalid(cubes, "curve-nonmanifold", *ab, arc(1, face, side)))
        for axis in range(3):
            spans = [0, 0, 0]
            spans[axis] = 1
            self.says("B1", Invalid(cubes, "flat", 0, tuple(spans)))
            for bad in ((1, 0), (0, (0, 0)), (0, (1, 0)), (0, (2, 1)), (1 << 63, 0)):
                numbers = [(0, HALF)] * 3
                numbers[axis] = bad
                self.says("B1", Invalid(cubes, "singular", (0, tuple(numbers))))
            for bad in ((1, 0, 0, 1), (0, 0, 0, 2), (0, 0, 1, 1), (0, 1, 1, 1), (0, 1, 1, 0), (0, 63, 0, 1), (0, 62, 0, (1 << 62) + 1), (0, 0, 0, 0)):
                parts = [WHOLE] * 3
                parts[axis] = bad
                self.says("B1", Invalid(cubes, "overlap", at(0, HALF, HALF, HALF), (1, tuple(parts)), IDENTITY))
                self.says("B1", Invalid(cubes, "curve-nonmanifold", *ab, arc(1, 0, 2, bad)))

    def test_the_span_of_an_arc_is_of_the_axis_along_which_its_side_runs(self):
        maps = [models.with_knot(cube(), axis, HALF) for axis in range(3)]
        for along, m in enumerate(maps):
            for face, side in itertools.product(range(6), range(4)):
                runs = vmodel_forge.OTHERS[face // 2][side // 2]
                self.says("C1" if runs == along else "B1", Invalid([m], "curve-nonmanifold", *[arc(0, face, side, (1, 0, 0, 1))] * 3))

    def test_every_body_that_is_cut_off(self):
        for name in ("a flat cell", "a mirrored cube", "overlapping cubes", "overlapping cubes, a box", "two cubes at an edge", "two cubes at a corner"):
            true = models.honest(name)
            body = true.body()
            for n in range(len(body)):
                self.says("B1", true.changed(body=lambda n=n: body[:n]))

    def test_no_volumes(self):
        self.says("B1", models.honest("a flat cell").changed(text=texts.json_text([]), count=0))
        plane = texts.bezier((1, 1), lambda u, v: (u, v, 0))
        self.says("ERROR", models.honest("a flat cell").changed(text=texts.json_text([cube(), plane])))


class Limits(InvalidTest):
    def test_knots_of_a_point(self):
        for bits, says in ((255, "H1"), (256, "B2")):
            far = Q(1 << bits)
            m = texts.Map((1, 1, 1), [[0, 0, far, far]] + [texts.bezier_knots(1)] * 2, cube().points)
            self.says(says, Invalid([m], "left-handed", at(0, HALF, HALF, HALF)))

    def test_knots_of_what_is_cut(self):
        """The difference of two breaks has 2048 bits, or one more."""
        for power, says in ((2046, "F1"), (2047, "B2")):
            knots = [[-(1 << power)] * 2 + [1 << power] * 2] + [texts.bezier_knots(1)] * 2
            self.says(says, Invalid([texts.Map((1, 1, 1), knots, cube().points)], "flat", 0, (0, 0, 0)))

    def test_control_points_of_what_is_cut(self):
        """The least common denominator of two coordinates has 8192 bits, or one more."""
        true = models.honest("two cubes at an edge")
        for bits, says in ((4096, "ACCEPT"), (4097, "B2")):
            small = {(1, 1, 0): Q(1, 1 << 4096), (1, 1, 1): Q(1, (1 << bits - 1) + 1)}
            maps = [texts.Map(m.degrees, m.knots, [(p[0] / 4, p[1] / 4, p[2] / 4 + small.get(p, 0)) for p in m.points]) for m in true.maps]
            self.says(says, Invalid(maps, true.kind, *true.parts))


class Units(InvalidTest):
    def takes(self, units, lie):
        """It is accepted with so many units, and not with one fewer."""
        allowed = vmodel_invalid_check.allowed
        try:
            for most in (units, units - 1) if units else (0,):
                vmodel_invalid_check.allowed = lambda count, most=most: most
                self.says("ACCEPT" if most == units else "B2", lie)
        finally:
            vmodel_invalid_check.allowed = allowed

    def test_units_by_hand(self):
        """An interval takes 3 units in the degree 1, a piece 3 x 16 + 2, N on it 5, a product 2 x 8 + 2, a curve 4 + 2."""
        interval, piece, product, curve = 3, 50, 18, 6
        cell = 3 * interval + piece
        self.takes(cell + 5, models.honest("a flat cell"))
        self.takes(cell + 5, models.honest("flat on one span"))
        self.takes(0, models.honest("a mirrored cube"))
        self.takes(0, models.honest("overlapping cubes"))
        self.takes(cell, models.honest("overlapping cubes, a box"))
        self.takes(3 * (interval + curve) + 3 * 11 + 2 * cell, models.honest("two cubes at an edge"))
        self.takes(2 * cell + 6 * 5 + 2 + 12, models.honest("two cubes at a corner"))
        # Two cells with a common face, of nine faces at the corner; eight of 18 walks pass it.
        three = [cube(), models.unit_box(1, 0, 0), models.unit_box(1, 1, 1)]
        same = 4 * interval + 2 * product
        self.takes(3 * cell + 9 * 8 + 2 * same + 3 + 18, Invalid(three, "point-nonmanifold", 0, 7))
        for reverse in itertools.product((0, 1), repeat=3):
            turned = three[0], valid.permuted(three[1], (1, 2, 0), reverse), three[2]
            self.takes(3 * cell + 9 * 8 + 2 * same + 3 + 18, Invalid(list(turned), "point-nonmanifold", 0, 7))
        three[1] = models.with_knot(three[1], 1, HALF)    # four intervals of one axis, two of the other; two products of each face
        self.takes(3 * cell + interval + piece + 9 * 8 + 2 * (6 * interval + 4 * product) + 3 + 18,
                   Invalid(three, "point-nonmanifold", 0, 7))

    def test_faces_with_the_same_corners(self):
        """They are compared in all symmetries that fit: eight, where all corners are one point."""
        number = itertools.count(1)

        def point(u, v, w):
            return (0, 0, 0) if {u, v, w} <= {0, 1} else (u, v + Q(next(number), 1000), w)
        cells = [bezier((2, 2, 2), point) for _ in range(2)]
        interval, piece, product = 1 + 8 * 64 // 32, 3 * (27 * 3 * 33 // 32) + 2, 2 * (9 * 3 * 33 // 32) + 2
        self.takes(2 * (3 * interval + piece) + 12 * 11 * (1 + 8 * (4 * interval + 2 * product)) + 16 + 12 * 8,
                   Invalid(cells, "point-nonmanifold", 0, 0))


class Hostile(InvalidTest):
    def test_bytes_of_bodies(self):
        """No certificate about a valid model is accepted."""
        rng, found = random.Random(11), collections.Counter()
        names = [name for name in models.valid_models() if name not in ("mirrored", "two, one of them mirrored and turned", "in a cube")]
        valid_ones = {name: Invalid(models.valid_models()[name], "flat") for name in names}
        shapes = [true for true in models.made().values() if true.kind not in ("left-handed", "singular")]
        for trial in range(1000 * SCALE):
            true, about = rng.choice(shapes), valid_ones[rng.choice(names)]
            about.model()
            about = about.changed(kind=true.kind, number=true.number, parts=true.parts)
            body = about.body()
            if rng.random() < .5:
                body = bent_bytes(rng, body)
            if body[8:9] in (b"\1", b"\2"):
                continue
            code, line = self.line(about.changed(body=lambda body=body: body))
            self.assertEqual(code, 1, (trial, body.hex(), line))
            found[line[7:9]] += 1
        self.assertGreater(len(found), 5, found)


if __name__ == "__main__":
    unittest.main()
