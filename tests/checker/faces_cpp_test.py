#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""reading-rule-faces.md in the C++ checker: which faces of volumes are left, in which order and direction. VERITOPE_CHECK and
VERITOPE_PRINT_MODEL name the programs."""
import copy
import itertools
import os
import random
import unittest
from fractions import Fraction as Q

import judges
import printed_models
import star_box_forge as forge
import volume_grids as grids
from volume_grids import LINEAR, SKEW

SCALE = int(os.environ.get("VT_TEST_SCALE", "1"))
CUBIC, QUARTIC = [(p, (0,) * (p + 1) + (1,) * (p + 1)) for p in (3, 4)]
WRITERS = {"g2-faces": grids.g2, "itd-faces": grids.itd, "vjson-faces": grids.vjson, "mfem-faces": grids.mfem_patches}


def place(x, y, z):
    return 4 * x + y * z, 4 * y + x, 4 * z + x * y


def in_space(entities):
    """As MFEM has them: all rational."""
    out = copy.deepcopy(entities)
    for e in out:
        if not e["shape"]["rational"]:
            e["shape"].update(rational=True, components=4, points=[[*p, "1"] for p in e["shape"]["points"]])
    return out


def changed(e, **values):
    return dict(e, shape=dict(e["shape"], **values))


def moved(e, change):
    """With other control points."""
    return changed(e, points=[[str(c) for c in change(tuple(map(Q, p)))] for p in e["shape"]["points"]])


def raised(e, axis):
    """Raises the degree along a Bezier axis by one; the map stays the same."""
    axes, points = grids.axes_of(e), grids.points_of(e)
    p = axes[axis][0]
    axes[axis] = p + 1, (0,) * (p + 2) + (1,) * (p + 2)
    out = {}
    for i in itertools.product(*(range(len(grids.greville(a))) for a in axes)):
        def at(k):
            j = list(i)
            j[axis] = k
            return points.get(tuple(j))
        k, share = i[axis], Q(i[axis], p + 1)
        before, here = at(k - 1), at(k)
        out[i] = tuple(share * a + (1 - share) * b for a, b in zip(before or here, here or before))
    return grids.entity(axes, out, e["shape"]["rational"])


class FacesTest(printed_models.PrintedTest):
    def left(self, faces, volumes, formats=tuple(WRITERS)):
        for fmt in formats:
            with self.subTest(fmt):
                self.reads(in_space(faces) if fmt == "mfem-faces" else faces, WRITERS[fmt](volumes), fmt)

    def numbers_left(self, volumes, fmt="vjson-faces"):
        """The numbers of the faces that are left."""
        every = [printed_models.wanted(grids.face_of(v, a, e, hand)) for v, hand in volumes for a in range(3) for e in (0, 1)]
        found = self.entities(WRITERS[fmt]([v for v, _ in volumes]), fmt)
        out, at = [], 0
        for entity in found:
            while every[at] != entity:
                at += 1
            out.append(at)
            at += 1
        return out


class Faces(FacesTest):
    def test_one_volume_in_all_positions(self):
        """The numbers, the parameters and the hand: 48 ways to lay the axes of a volume."""
        for turn in grids.SIGNED:
            grid = grids.Grid(axes=[[SKEW], [LINEAR], [QUARTIC]], turns=[turn], place=place)
            self.left(grid.faces(), grid.volumes(), ("g2-faces", "vjson-faces"))

    def test_the_page_written_out(self):
        """The unit cube: face 6v + 2a + e, its corner and the directions of its parameters."""
        found = self.entities(grids.g2(grids.Grid().volumes()), "g2-faces")
        self.assertEqual([e["points"] for e in found],
                         [[(0, 0, 0), (0, 1, 0), (0, 0, 1), (0, 1, 1)], [(1, 0, 0), (1, 0, 1), (1, 1, 0), (1, 1, 1)],
                          [(0, 0, 0), (0, 0, 1), (1, 0, 0), (1, 0, 1)], [(0, 1, 0), (1, 1, 0), (0, 1, 1), (1, 1, 1)],
                          [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)], [(0, 0, 1), (0, 1, 1), (1, 0, 1), (1, 1, 1)]])

    def test_grids_in_every_format(self):
        rng = random.Random(91)
        cells = list(itertools.product((0, 1), repeat=3))
        axes = [[SKEW, (1, (0, 0, Q(1, 8), 1, 1))], [(1, (0, 0, Q(1, 2), 2, 2)), SKEW], [QUARTIC, LINEAR]]
        for case in range(12 * SCALE):
            chosen = rng.sample(cells, rng.choice((1, 2, 3, 5, 8)))
            weight = (lambda x, y, z: 1 + x + 2 * y * z) if case % 2 else None
            grid = grids.Grid(chosen, axes, [rng.choice(grids.SIGNED) for _ in chosen], place, weight)
            with self.subTest(seed=91, case=case):
                self.left(grid.faces(), grid.volumes())
                self.reads(in_space(grid.faces()), grids.mesh_of_grid(grid, rng, case % 3 == 0).text(), "mfem-faces")

    def test_a_solid_is_certified_in_every_format(self):
        grid = grids.Grid([(0, 0, 0), (1, 0, 0)], place=lambda x, y, z: (4 * x, 4 * y, 4 * z))
        prover = forge.Prover(grid.faces()).prove()
        texts = [(fmt, write(grid.volumes())) for fmt, write in WRITERS.items()] + [("mfem-faces", grids.mesh_of_grid(grid).text())]
        for fmt, text in texts:
            prover.plan.values["subject_format"] = fmt
            code, condition, out = judges.in_cpp(text.encode(), prover.plan.certificate(text.encode()))
            self.assertEqual((code, condition), (0, "ACCEPT"), (fmt, out))
            prover.plan.values["subject_format"] = fmt[:-6]
            self.assertNotEqual(judges.in_cpp(text.encode(), prover.plan.certificate(text.encode()))[0], 0, fmt)
        hole = grids.Grid([(0, 0, 0), (1, 0, 0)], place=lambda x, y, z: (4 * x, 4 * y, 4 * z)).volumes()
        hole[1] = moved(hole[1], lambda p: (p[0] + Q(1, 2 ** 30), *p[1:]))     # the faces between the two cells differ now
        text = grids.g2(hole).encode()
        prover.plan.values["subject_format"] = "g2-faces"
        self.assertEqual(judges.in_cpp(text, prover.plan.certificate(text))[:2], (1, "B1"))


class Hands(FacesTest):
    def test_the_corners_that_say_something_decide_and_must_agree(self):
        """Corners are made flat one after the other, by moving their neighbours along u into them. One that is turned contradicts those that
        are not flat."""
        axes = [CUBIC] * 3
        points = {i: tuple(map(Q, i)) for i in itertools.product(range(4), repeat=3)}
        for number in range(8):
            corner = tuple(3 * (number >> k & 1) for k in range(3))
            beside = corner[0] + (1 if corner[0] == 0 else -1), *corner[1:]
            for sign in (1, -1):
                bent = dict(points)
                bent[beside] = tuple(p + sign * (q - p) for p, q in zip(corner, points[beside]))
                if sign == 1 or number == 7:
                    self.left_or_turned(axes, bent, sign)
                else:
                    self.refused("the volume is folded: its corners have different hands", grids.vjson([grids.entity(axes, bent)]), fmt="vjson-faces")
            points[beside] = points[corner]

    def left_or_turned(self, axes, points, hand):
        volume = grids.entity(axes, points)
        found = self.entities(grids.vjson([volume]), "vjson-faces")
        expected = [printed_models.wanted(grids.face_of(volume, a, e, hand)) for a in range(3) for e in (0, 1)]
        self.assertEqual(found, expected)

    def test_inner_places_and_none(self):
        """All corners are flat: the first (i, j, k) that is not flat decides; if all are flat, the hand is +1."""
        axes = [(3, (0,) * 4 + (1,) * 4)] * 3
        cube = {i: tuple(map(Q, i)) for i in itertools.product(range(4), repeat=3)}
        for sign in (1, -1):
            points = {i: (sign * p[0], p[1], p[2]) for i, p in cube.items()}
            for i in list(points):
                if sum(k in (1, 2) for k in i) == 1:      # along the edges nothing moves near a corner
                    near = tuple(k if k in (0, 3) else 3 * (k == 2) for k in i)
                    points[i] = points[near]
            self.left_or_turned(axes, points, sign)
        flat = {i: (x + 7 * z, y, x + 7 * z + 2 * y) for i, (x, y, z) in cube.items()}
        self.left_or_turned(axes, flat, 1)

    def test_only_a_thousand_places_are_tried(self):
        """There are 1,100. All points are one but for four, at the place that would decide; number 999 is the last one that is tried."""
        axes = [(1, tuple([0] + list(range(12)) + [11])), (1, tuple([0] + list(range(11)) + [10])), (1, tuple([0] + list(range(11)) + [10]))]
        for decisive, hand in ((999, -1), (1000, 1)):
            points = {i: (Q(0), Q(0), Q(0)) for i in itertools.product(range(12), range(11), range(11))}
            i = decisive % 11, decisive // 11 % 10, decisive // 110
            corner = {(i[0], i[1], i[2]): (5, 5, 5), (i[0] + 1, i[1], i[2]): (4, 5, 5), (i[0], i[1] + 1, i[2]): (5, 6, 5), (i[0], i[1], i[2] + 1): (5, 5, 6)}
            for key, value in corner.items():
                points[key] = tuple(map(Q, value))
            volume = grids.entity(axes, points)
            self.assertEqual(self.first_hand(points, axes), hand)
            expected = [printed_models.wanted(f) for f in (grids.face_of(volume, a, e, hand) for a in range(3) for e in (0, 1)) if self.has_area(f)]
            self.assertTrue(expected)
            self.assertEqual(self.entities(grids.vjson([volume]), "vjson-faces"), expected, decisive)

    def first_hand(self, points, axes):
        """By the page, in fractions."""
        n = [len(grids.greville(a)) for a in axes]

        def det(o, *ends):
            a, b, c = [[x - y for x, y in zip(points[e], points[o])] for e in ends]
            return sum(a[k] * (b[(k + 1) % 3] * c[(k + 2) % 3] - b[(k + 2) % 3] * c[(k + 1) % 3]) for k in range(3))
        for c in range(8):
            e = [c >> k & 1 for k in range(3)]
            o = tuple(e[k] * (n[k] - 1) for k in range(3))
            d = det(o, *(tuple(o[m] + (1 - 2 * e[m]) * (m == k) for m in range(3)) for k in range(3)))
            if d:
                return (1 if d > 0 else -1) * (-1) ** sum(e)
        places = [(i, j, k) for k in range(n[2] - 1) for j in range(n[1] - 1) for i in range(n[0] - 1)]
        for o in places[:1000]:
            d = det(o, *(tuple(o[m] + (m == k) for m in range(3)) for k in range(3)))
            if d:
                return 1 if d > 0 else -1
        return 1

    @staticmethod
    def has_area(face):
        points = grids.points_of(face)
        rows, columns = [{p for (i, _), p in points.items() if i == k} for k in range(99)], [{p for (_, j), p in points.items() if j == k} for k in range(99)]
        return any(len(r) > 1 for r in rows) and any(len(c) > 1 for c in columns)


class LeftOut(FacesTest):
    def test_points_and_curves(self):
        """A wedge, a pyramid and a ball's octant: sides that are lines or points."""
        box = grids.Grid(axes=[[SKEW], [LINEAR], [LINEAR]]).volume((0, 0, 0))
        for change, gone in ((lambda p: (p[0], p[1] * (1 - p[0]), p[2]), {1}), (lambda p: (p[0], p[1] * (1 - p[0]), p[2] * (1 - p[0])), {1}),
                             (lambda p: (p[0] * (1 - p[2]), p[1], p[2]), {5}), (lambda p: (p[0], p[1], p[2] * (1 - p[1])), {3})):
            self.assertEqual(self.numbers_left([(moved(box, change), 1)]), [f for f in range(6) if f not in gone])
        self.refused("no boundary face is left", grids.vjson([moved(box, lambda p: (p[0], 0, 0))]), grids.vjson([moved(box, lambda p: (1, 2, 3))]), fmt="vjson-faces")

    def test_weights_of_curves(self):
        """A side is a curve iff its weights are a product, too."""
        def with_weights(weight):
            grid = grids.Grid(weight=weight)
            return moved(grid.volume((0, 0, 0)), lambda p: (p[0], p[1] * (1 - p[0] / p[3]), p[2], p[3]))      # face 1 is the segment along z
        self.assertEqual(self.numbers_left([(with_weights(lambda x, y, z: (1 + y) * (2 + z)), 1)]), [0, 2, 3, 4, 5])
        self.assertEqual(self.numbers_left([(with_weights(lambda x, y, z: 1 + y * z), 1)]), [0, 1, 2, 3, 4, 5])

    def test_walls_and_what_is_none(self):
        a = grids.Grid(place=place)
        two = grids.Grid([(0, 0, 0), (1, 0, 0)], [[SKEW, SKEW], [SKEW], [QUARTIC]], None, place)
        one, other = two.volumes()
        self.assertEqual(self.numbers_left([(one, 1), (other, 1)]), [0, 2, 3, 4, 5, 7, 8, 9, 10, 11])
        every = list(range(12))
        for change in (lambda e: moved(e, lambda p: (p[0] + Q(1, 2 ** 60), p[1], p[2])),                                       # a hair
                       lambda e: changed(e, knots=[e["shape"]["knots"][0], ["0", "0", "0", "1/3", "1", "1", "1"], e["shape"]["knots"][2]])):  # other knots
            self.assertEqual(self.numbers_left([(one, 1), (change(other), 1)]), every)
        for knots in (["5", "5", "5", "11/2", "7", "7", "7"], ["-1", "-1", "-1", "-3/4", "0", "0", "0"]):                       # the same up to an affine map
            moved_knots = changed(other, knots=[other["shape"]["knots"][0], knots, other["shape"]["knots"][2]])
            self.assertEqual(self.numbers_left([(one, 1), (moved_knots, 1)]), [0, 2, 3, 4, 5, 7, 8, 9, 10, 11])
        # Three equal faces all stay; a volume that comes twice lies on the same side of all of its faces.
        self.assertEqual(self.numbers_left([(one, 1), (other, 1), (one, 1)]), list(range(18)))
        self.assertEqual(self.numbers_left([(a.volume((0, 0, 0)), 1)] * 2), every)

    def test_factors_of_homogeneous_points(self):
        """All of a face times one factor is the same; one point times a factor is not; polynomial and rational faces can be equal."""
        two = grids.Grid([(0, 0, 0), (1, 0, 0)], [[SKEW, SKEW], [SKEW], [QUARTIC]], None, place, lambda x, y, z: 1 + y + z)
        one, other = two.volumes()
        wall = [0, 2, 3, 4, 5, 7, 8, 9, 10, 11]
        self.assertEqual(self.numbers_left([(one, 1), (moved(other, lambda p: [Q(3, 7) * c for c in p]), 1)]), wall)
        points = other["shape"]["points"]
        bent = changed(other, points=[[str(2 * Q(c)) for c in points[0]], *points[1:]])
        self.assertEqual(self.numbers_left([(one, 1), (bent, 1)]), list(range(12)))
        plain = grids.Grid([(0, 0, 0), (1, 0, 0)], [[SKEW, SKEW], [SKEW], [QUARTIC]], None, place).volumes()
        rational = moved(in_space([plain[1]])[0], lambda p: [Q(5, 3) * c for c in p])
        self.assertEqual(self.numbers_left([(plain[0], 1), (rational, 1)]), wall)

    def test_a_ring_of_one_volume(self):
        """Its first and its last face are one."""
        corners = [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 0)]
        points = {(i, j, k): tuple(map(Q, (corners[i][0] * (2 + j), corners[i][1] * (2 + j), k))) for i in range(5) for j in (0, 1) for k in (0, 1)}
        ring = grids.entity([(1, (0, 0, 1, 2, 3, 4, 4)), LINEAR, LINEAR], points)
        for hand, e in ((-1, ring), (1, moved(ring, lambda p: (p[0], -p[1], p[2])))):
            self.assertEqual(self.numbers_left([(e, hand)]), [2, 3, 4, 5])

    def test_lowest_degrees(self):
        """The face of one volume has higher degrees than the other's: equal all the same, and the entities keep their degrees."""
        two = grids.Grid([(0, 0, 0), (1, 0, 0)], [[LINEAR, LINEAR], [LINEAR], [(2, (0, 0, 0, 1, 1, 1))]], None, place)
        one, other = two.volumes()
        wall = [0, 2, 3, 4, 5, 7, 8, 9, 10, 11]
        for steps in ([1], [1, 1], [2], [1, 2, 1, 2, 2]):
            high = other
            for axis in steps:
                high = raised(high, axis)
            self.assertEqual(self.numbers_left([(one, 1), (high, 1)]), wall)
            self.assertEqual(self.numbers_left([(raised(one, 1), 1), (high, 1)]), wall)
            hair = moved(high, lambda p: (p[0], p[1], p[2] + (Q(1, 2 ** 40) if p == tuple(map(Q, high["shape"]["points"][1])) else 0)))
            self.assertEqual(self.numbers_left([(one, 1), (hair, 1)]), list(range(12)))
        # A knot inside stays, though the map would have a lower degree.
        knotted = grids.Grid([(0, 0, 0), (1, 0, 0)], [[LINEAR, LINEAR], [(2, (0, 0, 0, Q(1, 2), 1, 1, 1))], [LINEAR]], None, place).volumes()
        plain = grids.Grid([(0, 0, 0), (1, 0, 0)], [[LINEAR, LINEAR], [LINEAR], [LINEAR]], None, place).volumes()
        self.assertEqual(self.numbers_left([(plain[0], 1), (knotted[1], 1)]), list(range(12)))


class Refusals(FacesTest):
    def test_entities_that_are_no_volumes_in_space(self):
        cube = grids.Grid().volumes()
        face = grids.face_of(cube[0], 0, 0)
        self.refused("entity 1: not a volume with at least three coordinates", grids.g2(cube + [face]), fmt="g2-faces")
        self.refused("entity 0: not a volume with at least three coordinates", grids.mfem_patches([face]), fmt="mfem-faces")
        self.refused("an entity is no volume", grids.vjson(cube + [face]), grids.vjson([face]), fmt="vjson-faces")
        self.refused("geometry other than volumes", grids.itd(cube) + grids.itd([face], "SURFACE"), fmt="itd-faces")
        self.refused("geometry other than surfaces", grids.itd(cube), fmt="itd")
        self.refused("no boundary face is left", grids.vjson([]), fmt="vjson-faces")
        plane = "700 1 0 0 2 0 " + "2 2 0 0 1 1 " * 3 + "1 2 " * 8
        self.refused("entity 0: not a volume with at least three coordinates", plane, fmt="g2-faces")

    def test_knots(self):
        for knots, word in (("0 1 2 3", "begin and end"), ("0 0 1 2", "begin and end"), ("0 1 2 2", "begin and end")):
            text = grids.g2(grids.Grid().volumes()).replace("2 2\n0 0 1 1", "2 2\n" + knots, 1)
            self.refused("entity 0: the knots of an axis do not " + word, text, fmt="g2-faces")
        double = grids.Grid(axes=[[(1, (0, 0, Q(1, 2), Q(1, 2), 1, 1))], [LINEAR], [LINEAR]]).volumes()
        self.refused("an inner knot occurs more often than the degree", grids.g2(double), fmt="g2-faces")
        for fmt in ("g2", "vjson"):
            self.assertEqual(printed_models.printed(grids.g2(double) if fmt == "g2" else grids.vjson(double), fmt)[0], 0)

    def test_lengths(self):
        cube = grids.g2(grids.Grid().volumes())
        for knot, good in (("4e616", False), ("2e616", True), ("1e617", False), ("1e-616", True), ("1e-617", False)):
            status, out = printed_models.printed(cube.replace("0 0 1 1", "0 0 %s %s" % (knot, knot), 1), "g2-faces")
            self.assertEqual((status, "2048 bits" in out), (0 if good else 4, not good), (knot, out[:200]))
        for word, good in (("1e2466", True), ("2e2466", False), ("1e-2466", True), ("1e-2467", False)):
            status, out = printed_models.printed(cube.replace("1 1 1\n", "1 1 %s\n" % word), "g2-faces")
            self.assertEqual((status, "8192 bits" in out), (0 if good else 4, not good), (word, out[:200]))

    def test_json(self):
        cube = grids.vjson(grids.Grid().volumes())
        self.assertEqual(len(self.entities(cube, "vjson-faces")), 6)
        self.assertEqual(self.entities(cube, "vjson"), [{"kind": "other", "rational": False, "components": 0, "degrees": [], "knots": [], "points": []}])
        for old, new in (('"degrees": [1, 1, 1]', '"degrees": [1, 1]'), ('"degrees": [1, 1, 1]', '"degrees": [1, 1, 0]'), ("[false, false, false]", "[false, false]"),
                         ("[false, false, false]", "[true, false, false]"), ('"rational": false', '"rational": true'), ('"components": 3', '"components": 4'),
                         ('["0", "0", "1", "1"]', '["0", "0", "1"]')):
            self.assertIn(old, cube)
            self.refused("", cube.replace(old, new, 1), fmt="vjson-faces")

    def test_itd(self):
        grid = grids.Grid(axes=[[SKEW], [LINEAR], [QUARTIC]], place=place)
        text = grids.itd(grid.volumes())
        self.reads(grid.faces(), text.replace("TRIVAR BSPLINE", "MULTIVAR BSPLINE 3"), "itd-faces")
        self.reads(grid.faces(), "[OBJECT [a [SURFACE]] N " + text.replace("TRIVAR BSPLINE", "TRIVAR BSPLINE [rgb 1]") + "]", "itd-faces")
        bezier = "[TRIVAR BEZIER 2 2 2 E3 [0 0 0] [1 0 0] [0 1 0] [1 1 0] [0 0 1] [1 0 1] [0 1 1] [1 1 1]]"
        self.reads(grids.Grid().faces(), bezier, "itd-faces")
        power = "[TRIVAR POWER 2 2 2 E3 [0 0 0] [1 0 0] [0 1 0] [0 0 0] [0 0 1] [0 0 0] [0 0 0] [0 0 0]]"
        self.reads(grids.Grid().faces(), power, "itd-faces")
        self.refused("another number of parameters", text.replace("TRIVAR BSPLINE", "MULTIVAR BSPLINE 2"), fmt="itd-faces")
        self.refused("more control points than the file can hold", text.replace("TRIVAR BSPLINE 4 2 5", "TRIVAR BSPLINE 4000 4000 4000"), fmt="itd-faces")
        # KVP says which control points there are: point i of an axis is the given point i mod m.
        wrapped = "[TRIVAR BSPLINE 3 2 2 2 2 2 E3 [KVP 0 0 1 2 3 3] [KV 0 0 1 1] [KV 0 0 1 1] %s]"
        rows = [[(1, 0), (0, 1), (-1, -1)][i] for i in range(3)]
        wrapped %= " ".join("[%d %d %d]" % (x * (1 + j), y * (1 + j), k) for k in (0, 1) for j in (0, 1) for x, y in rows)
        self.assertEqual(len(self.entities(wrapped, "itd-faces")), 4)


class Hostile(FacesTest):
    def test_many_equal_faces_and_many_volumes_take_no_time(self):
        """0.3 MB: the same volume 2,000 times, and 2,000 volumes on one stack."""
        cube = grids.Grid().volumes()
        self.assertEqual(len(self.entities(grids.g2(cube) * 2000, "g2-faces")), 12000)
        stack = "".join("700 1 0 0 3 0 2 2 0 0 1 1 2 2 0 0 1 1 2 2 0 0 1 1 " + " ".join("%d %d %d" % (x, y, z + k) for k in (0, 1) for y in (0, 1) for x in (0, 1)) + "\n"
                        for z in range(2000))
        self.assertEqual(len(self.entities(stack, "g2-faces")), 8002)

    def test_long_numbers(self):
        """60 kB of volumes whose numbers have 8,000 bits, flat ones too."""
        words = ("7e2400", "3e2399", "9e2000", "0", "5e1234")
        rng = random.Random(97)
        for flat in (False, True):
            text = ""
            for _ in range(250):
                points = [[rng.choice(words) for _ in range(3)] for _ in range(8)]
                text += "700 1 0 0 3 1 2 2 0 0 1 1 2 2 0 0 3e600 3e600 2 2 0 0 1 1 " + " ".join("%s %s %s 7e1200" % ((x, y, x) if flat else (x, y, z)) for x, y, z in points) + "\n"
            status, out = printed_models.printed(text, "g2-faces")
            self.assertIn(status, (0, 4), out[:300])


if __name__ == "__main__":
    unittest.main()
