#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The Python checker of volume-folded-1: volumes that fold, a lie for every condition, limits, volumes that do not fold, hostile bytes. A
lie is rejected by its condition and, where the test says `alone`, accepted without it."""
import copy
import itertools
import os
import random
import unittest
from fractions import Fraction as Q

import model_texts as texts
import star_box_test as star
import volume_folded_forge as forge
from volume_folded_forge import BEGIN, END, FIRST, LAST, MIDDLE, Fold

vc = star.vc
SCALE = int(os.environ.get("VT_TEST_SCALE", "1"))
TOP = 1 << 63
FORMATS = ("vjson", "itd", "g2", "mfem")


def random_volume(rng):
    """A grid that is out of order here and there."""
    degrees = [rng.randint(1, 3) for _ in range(3)]
    knots = [[t - Q(8, 5) for t in forge.with_knots(p, sorted(rng.choice((1, 2, Q(7, 3))) for _ in range(rng.randint(0, p))))] for p in degrees]
    sizes = [len(t) - p - 1 for p, t in zip(degrees, knots)]
    rational, points = rng.random() < .5, []
    for index in itertools.product(*map(range, sizes[::-1])):
        w = rng.randint(1, 4) if rational else 1
        p = [w * (Q(c) + Q(rng.randint(-9, 9), 8)) for c in index[::-1]]
        points.append((*p, w) if rational else p)
    return texts.Map(degrees, knots, points, rational)


class FoldTest(unittest.TestCase):
    def says(self, expected, fold, skip=()):
        model = fold.model()
        code, line = vc._check(model, fold.certificate(model), frozenset(skip))
        self.assertEqual(line.split(":")[0].replace("REJECT ", "").replace("ACCEPT " + fold.claim, "ACCEPT"), expected, line)
        self.assertEqual(code, {"ACCEPT": 0, "ERROR": 4}.get(expected, 1), line)

    def alone(self, condition, fold):
        self.says(condition, fold)
        self.says("ACCEPT", fold, {condition})

    def changed(self, fold, **fields):
        fold = copy.copy(fold)
        for key, value in fields.items():
            setattr(fold, key, value)
        return fold


class Honest(FoldTest):
    # PROVES INVALID-4
    def test_volumes_that_fold_are_refuted_in_every_format(self):
        for name, fold in forge.honest():
            for subject_format in FORMATS:
                with self.subTest(name, format=subject_format):
                    fold.subject_format, fold.text = subject_format, None
                    self.says("ACCEPT", fold)

    # PROVES INVALID-4.J1
    # PROVES INVALID-4.J2
    def test_both_signs_are_those_of_another_way_to_compute_them(self):
        """At random points of random volumes, rational or not, with inner knots or not."""
        rng, signs = random.Random(4), []
        for _ in range(25 * SCALE):
            m = random_volume(rng)
            knots = m.knots
            for _ in range(2):
                a, b = [tuple((rng.randrange(len(set(t)) - 1), rng.choice((0, 1, Q(1, 2), Q(rng.randint(1, 12), 13)))) for t in knots) for _ in "AB"]
                of_a, of_b = forge.sign(m, a), forge.sign(m, b)
                signs += [of_a, of_b]
                self.says("J1" if of_a <= 0 else "J2" if of_b >= 0 else "ACCEPT", Fold([m], a, b))
        self.assertGreater(min(signs.count(1), signs.count(-1)), 10)

    # PROVES INVALID-4.J1
    # PROVES INVALID-4.J2
    def test_the_signs_change_where_the_determinant_is_0(self):
        """Two points of a piece, 2^-30 apart, with the zero between them."""
        rng, found = random.Random(7), 0
        while found < 8 * SCALE:
            m = random_volume(rng)
            at = [(rng.randrange(len(set(t)) - 1), Q(rng.randint(0, 4), 4)) for t in m.knots]
            axis = rng.randrange(3)

            def point(t, at=at, axis=axis):
                return tuple((k, t if a == axis else x) for a, (k, x) in enumerate(at))
            ends, signs = [Q(0), Q(1)], [forge.sign(m, point(t)) for t in (0, 1)]
            if signs[0] * signs[1] != -1:
                continue
            for _ in range(30):
                middle = sum(ends) / 2
                side = forge.sign(m, point(middle)) != signs[0]
                ends[side] = middle
            if 0 in [forge.sign(m, point(t)) for t in ends]:
                continue
            found += 1
            good = Fold([m], *[point(t) for t in ends][::signs[0]])
            self.says("ACCEPT", good)
            self.says("J1", self.changed(good, a=good.b, b=good.a))

    def test_the_example_of_the_page(self):
        fold = Fold([forge.folded_cube()])
        self.assertEqual((forge.determinant(fold.maps[0], FIRST), forge.determinant(fold.maps[0], LAST)), (1, -2))
        self.assertEqual(fold.body()[8:], bytes([0] + [0, 0, 1] * 3 + [0, 1, 1] * 3))

    def test_affine_maps_of_space_and_of_parameters(self):
        """A mirror in space exchanges the points, as does one axis that is reversed; a mirror of both changes nothing."""
        fold = Fold([forge.folded_cube()])
        for axes in itertools.permutations(range(3)):
            for signs in itertools.product((1, -1), repeat=3):
                is_odd = (sum(a > b for a, b in itertools.combinations(axes, 2)) + signs.count(-1)) % 2 == 1
                m = fold.maps[0]
                points = [tuple(s * 3 * p[a] + Q(1, 7) for a, s in zip(axes, signs)) for p in m.points]
                moved = texts.Map(m.degrees, [[5 * t - 2 for t in knots] for knots in m.knots], points)
                good = Fold([moved], *((LAST, FIRST) if is_odd else (FIRST, LAST)))
                self.says("ACCEPT", good)
                self.says("J1", self.changed(good, a=good.b, b=good.a))

    def test_numbers_need_not_be_in_lowest_terms_and_may_be_long(self):
        near = (0, (TOP - 2, TOP - 1))
        self.says("ACCEPT", Fold([forge.folded_cube()], ((0, (0, 5)),) * 3, ((0, (7, 7)),) * 3))
        self.says("ACCEPT", Fold([forge.folded_cube()], ((0, (1, TOP - 1)),) * 3, (near,) * 3))

    def test_degree_15(self):
        for degree, says in ((15, "ACCEPT"), (16, "B2")):
            x = [0, 9, *range(2, degree - 1), -9 + degree, degree]
            m = forge.bezier((degree, 1, 1), lambda u, v, w, x=x, d=degree: (x[int(d * u)], v, w))
            found = {forge.sign(m, p): p for p in [((0, Q(i, 16)), BEGIN, END) for i in range(17)]}
            self.says(says, Fold([m], found[1], found[-1]))
            if says == "B2":
                self.alone("B2", Fold([m], found[1], found[-1]))


class Lies(FoldTest):
    # PROVES INVALID-4.J1
    # PROVES INVALID-4.J2
    def test_equal_signs_and_zero(self):
        fold = Fold([forge.folded_cube()])
        self.alone("J2", self.changed(fold, b=FIRST))
        self.alone("J1", self.changed(fold, a=LAST))
        self.says("J1", self.changed(fold, a=LAST, b=FIRST))
        # det J is 0 along an edge that is one point
        wedge = forge.cube(lambda p: (0, 0, p[2]) if p == (1, 0, p[2]) else p)
        bent = texts.Map(wedge.degrees, wedge.knots, [p if p != (1, 1, 1) else (-3, 1, 1) for p in wedge.points])
        found = {forge.sign(bent, p): p for p in forge.points_of(bent)}
        self.says("ACCEPT", Fold([bent], found[1], found[-1]))
        self.alone("J1", Fold([bent], found[0], found[-1]))
        self.alone("J2", Fold([bent], found[1], found[0]))

    def test_volumes_that_do_not_fold(self):
        for m in (forge.cube(), forge.made_rational(forge.cube()), forge.cube(lambda p: (p[1], p[0], p[2]))):
            for a, b in itertools.product(forge.points_of(m), repeat=2):
                if hash((a, b)) % 29 == 0:
                    self.says("J1" if forge.sign(m, a) < 0 else "J2", Fold([m], a, b))

    def test_the_wrong_side_of_a_knot(self):
        ridge = forge.graph(forge.with_knots(1, [1]), lambda t: t if t <= 1 else 2 - t)
        left, right, rest = (0, 1), (1, 0), (MIDDLE, MIDDLE)
        self.says("ACCEPT", Fold([ridge], (left, *rest), (right, *rest)))
        self.alone("J2", Fold([ridge], (left, *rest), (left, *rest)))
        self.alone("J1", Fold([ridge], (right, *rest), (right, *rest)))

    def test_pieces_and_numbers_that_do_not_exist(self):
        fold = Fold([forge.cube(), forge.folded_cube()], entity=1)
        self.says("ACCEPT", fold)
        for axis in range(3):
            for bad in ((1, 0), (TOP - 1, 0), (0, (0, 0)), (0, (1, 0)), (0, (2, 1)), (0, (TOP - 1, TOP - 2)), (0, (1 << 62, 1)), (TOP, 0), (0, (TOP, TOP)),
                        (0, ((1 << 64) - 1, (1 << 64) - 1))):
                for which in "ab":
                    point = list(getattr(fold, which))
                    point[axis] = bad
                    self.says("B1", self.changed(fold, **{which: tuple(point)}))

    def test_the_volume_and_the_counts(self):
        fold = Fold([forge.cube(), forge.folded_cube()], entity=1)
        for entity in (2, 3, 1 << 32, TOP - 1, TOP):
            self.says("B1", self.changed(fold, entity=entity, values={"entity": 1}))
        for count in (0, 1, 3, (1 << 32) - 1):
            self.says("B1", self.changed(fold, count=count))
        self.says("J2", self.changed(fold, entity=0))
        self.alone("B3", self.changed(fold, values={"entity": 0}))
        self.alone("B3", self.changed(fold, values={"volumes": 1}))
        self.alone("B3", self.changed(fold, values={"volumes": 3}))
        self.says("B1", self.changed(fold, magic=b"VTI2"))
        self.says("B1", self.changed(fold, tail=b"\0"))
        self.says("S1", self.changed(fold, values={"finding": "fold"}))
        self.says("S1", self.changed(fold, values={"subject_format": "vjson-faces"}))
        self.says("S1", self.changed(fold, claim="volume-folded-2"))

    def test_every_body_that_is_cut_off(self):
        fold = Fold([forge.folded_cube()])
        body = fold.body()
        for n in range(len(body)):
            self.says("B1", self.changed(fold, body=lambda n=n: body[:n]))
        for n in range(8, len(body)):                       # a varint that is not in its shortest form
            self.says("B1", self.changed(fold, body=lambda n=n: body[:n] + bytes([body[n] | 128, 0]) + body[n + 1:]))

    def test_entities_that_are_no_volumes_in_space(self):
        surface = texts.bezier((1, 1), lambda u, v: (u, v, 0))
        plane = texts.bezier((1, 1, 1), lambda u, v, w: (u, v))
        for subject_format in ("vjson", "itd", "g2"):
            self.says("ERROR", Fold([forge.folded_cube(), surface], subject_format=subject_format))
        for subject_format in ("vjson", "g2"):
            self.says("ERROR", Fold([forge.folded_cube(), plane], subject_format=subject_format))
        self.says("B1", Fold([]))

    def test_axes_that_are_not_clamped_or_may_be_torn(self):
        m = forge.folded_cube()
        for knots in ([-1, 0, 1, 1], [0, 0, 1, 2]):
            self.says("ERROR", Fold([texts.Map(m.degrees, [knots, *m.knots[1:]], m.points)]))
        torn = texts.Map((1, 1, 1), [[0, 0, 1, 1, 2, 2], *m.knots[1:]], [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1, 3, 2)])
        self.says("ERROR", Fold([torn], FIRST, ((1, 0), MIDDLE, MIDDLE)))


class Limits(FoldTest):
    """Each limit of B2, at it and beyond it."""

    def test_bits_of_control_points(self):
        for bits, says in ((8192, "ACCEPT"), (8193, "ERROR")):
            far = (1 << bits) - 1
            self.says(says, Fold([forge.cube(lambda p, far=far: (0, 0, 0) if p == (1, 1, 1) else (far * p[0], p[1], p[2]))]))
        # each control point is short enough, and their least common denominator need not be
        for bits, says in ((4096, "ACCEPT"), (4097, "B2")):
            small = {(1, 0, 0): Q(1, 1 << 4096), (0, 1, 0): Q(1, (1 << bits - 1) + 1)}
            fold = Fold([forge.cube(lambda p, small=small: (0, 0, 0) if p == (1, 1, 1) else (*p[:2], p[2] + small.get(p, 0)))])
            self.says(says, fold) if says == "ACCEPT" else self.alone("B2", fold)

    def test_bits_of_all_control_points_of_a_box(self):
        """512 points of 8192 bits are 2^22 in all; 576 are too many."""
        for degrees, says in (((7, 7, 7), "ACCEPT"), ((8, 7, 7), "B2")):
            far = (1 << 8191) + 1                           # 8192 bits

            def point(u, v, w, n=degrees[0], far=far):
                return (far if (u, v, w) == (0, 0, 0) else (0, 9, -9, 3)[min(3, int(n * u))], 7 * v, 7 * w)
            m = forge.bezier(degrees, point)
            found = {forge.sign(m, p): p for p in [FIRST, LAST, (END, END, BEGIN), (MIDDLE, END, END), (BEGIN, END, END)]}
            self.assertLessEqual({1, -1}, set(found))
            fold = Fold([m], found[1], found[-1])
            self.says(says, fold) if says == "ACCEPT" else self.alone("B2", fold)

    def test_bits_of_knots(self):
        for bits, says in ((256, "ACCEPT"), (257, "B2")):
            for last in ((1 << bits) - 1, Q(1, (1 << bits) - 1)):
                m = forge.folded_cube()
                fold = Fold([texts.Map(m.degrees, [m.knots[0], [0, 0, last, last], m.knots[2]], m.points)])
                self.says(says, fold) if says == "ACCEPT" else self.alone("B2", fold)
        # only the knots of the piece count: here those of the second piece are long, and no point lies there
        m = forge.graph([Q(0), Q(0), Q(1), Q(2), Q(1 << 300), Q(1 << 300)], lambda t: {0: 0, 1: 1, 2: 0}.get(t, -1))
        self.says("ACCEPT", Fold([m], FIRST, ((1, 0), MIDDLE, MIDDLE)))
        self.alone("B2", Fold([m], FIRST, ((2, 0), MIDDLE, MIDDLE)))


class Hostile(FoldTest):
    def test_bytes_of_bodies(self):
        """An ACCEPT is right: the signs are computed in another way."""
        rng, accepted = random.Random(9), 0
        folds = [fold for _, fold in forge.honest()] + [Fold([forge.cube(), forge.cube()], entity=1)]
        for trial in range(600 * SCALE):
            fold = rng.choice(folds)
            fold.subject_format, fold.text = "vjson", None
            lie = bytearray(fold.body())
            for _ in range(rng.randint(1, 3)):
                at = rng.randrange(len(lie))
                if rng.random() < .7:
                    lie[at] = rng.choice((lie[at] ^ 1 << rng.randrange(8), 0, 1, 2, 127, 128, 255))
                elif rng.random() < .5:
                    del lie[at:at + rng.randint(1, 4)]
                else:
                    lie[at:at] = bytes(rng.randrange(4) for _ in range(rng.randint(1, 4)))
                lie = lie or bytearray(1)
            changed = self.changed(fold, body=lambda lie=lie: bytes(lie))
            for entity in range(len(fold.maps)):
                changed.values = {"entity": entity}
                code, line = vc._check(fold.model(), changed.certificate(), frozenset())
                self.assertIn(code, (0, 1), (trial, bytes(lie).hex(), line))
                accepted += code == 0
                if code == 0:
                    a, b = decoded(bytes(lie))
                    self.assertEqual((forge.sign(fold.maps[entity], a), forge.sign(fold.maps[entity], b)), (1, -1), bytes(lie).hex())
        self.assertGreater(accepted, 20)


def decoded(body):
    """The points of a body."""
    at, numbers = 8, []
    while at < len(body):
        value = shift = 0
        while body[at] & 128:
            value, shift, at = value | (body[at] & 127) << shift, shift + 7, at + 1
        numbers.append(value | body[at] << shift)
        at += 1
    triples = [(numbers[i], (numbers[i + 1], numbers[i + 2])) for i in range(1, 19, 3)]
    return tuple(triples[:3]), tuple(triples[3:])


if __name__ == "__main__":
    unittest.main()
