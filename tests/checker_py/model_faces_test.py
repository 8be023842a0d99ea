#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Models of volumes (docs/certificates/reading-rule-faces.md) in the Python checker: which faces bound them, what is refused,
certificates."""
import itertools
import json
import random
import time
import unittest
from fractions import Fraction as Q

import star_box_forge as forge                            # says where the checker is
import model_texts as texts
import model_volumes as volumes
import star_box_itd_test as itd
from model_volumes import block, made_rational, mapped, rearranged, with_points
from veritope_checker import program as vc
from veritope_checker.common.errors import Refused
from veritope_checker.patches import model_faces
from veritope_checker.patches.model_subject import read_subject

WAYS = [(order, flips) for order in itertools.permutations(range(3)) for flips in itertools.product((0, 1), repeat=3)]


def sheared(p):
    return (p[0], p[1] + p[0] * p[2] / 4, p[2] + p[0] * p[0] / 8)


def bulge(p):
    return [c * (Q(5, 4) - sum(x * x for x in p) * Q(3, 16)) for c in p]


def round_block():
    """144 times as wide, so that its control points are integers."""
    return block((-1, -1, -1), (1, 1, 1), (3, 3, 3), shape=lambda p: [144 * c for c in bulge(p)])


def ring():
    """Four quarters of a ring of square section."""
    arc = ((1, 0, 1), (1, 1, 1), (0, 2, 2))
    made = []
    for _ in range(4):
        points = [((r * x), (r * y), z * w, w) for z in (0, 1) for r in (2, 3) for x, y, w in arc]
        made.append(texts.Map((2, 1, 1), [texts.bezier_knots(p) for p in (2, 1, 1)], points, True))
        arc = tuple((-y, x, w) for x, y, w in arc)
    return made


class FacesTest(unittest.TestCase):
    def left(self, maps, subject_format="vjson"):
        """The faces that are left, as Maps; None if the file is refused."""
        data = texts.WRITERS[subject_format](maps)
        is_read = texts.is_read(vc, data, subject_format + "-faces")
        try:
            found = [texts.meaning(e) for e in read_subject(data, subject_format + "-faces")]
        except Refused:
            found = None
        self.assertEqual(is_read, found is not None)
        return found

    def agrees(self, maps, count=None, subject_format="vjson"):
        """With the page by brute force."""
        found, wanted = self.left(maps, subject_format), volumes.faces(maps)
        self.assertEqual(found is None, wanted is None)
        self.assertTrue(found is None or len(found) == len(wanted) and all(map(texts.same, found, wanted)))
        if count is not None:
            self.assertEqual(len(found or ()), count)
        if wanted:
            self.assert_entities(wanted, texts.WRITERS[subject_format](maps), subject_format + "-faces")

    def assert_entities(self, faces, data, subject_format):
        """A body about these faces passes B1, which compares their number and their knots; one box holds no proof."""
        plan = forge.Plan([f.entity() for f in faces])
        patches = sum(texts.prod(len(axis) - 1 for axis in axes) for axes in plan.breaks)
        plan.roots, plan.trees, plan.boxes = [[0, 0]] * patches, [[0]] * patches, [forge.Box(1, [-1 << 40] * 3, [1 << 41] * 3)]
        plan.values["subject_format"] = subject_format
        code, line = vc.check(data, plan.certificate(data))
        self.assertEqual(code, 1, line)
        self.assertNotIn(line[:9], ("REJECT B1", "REJECT S1"), line)


class Hands(FacesTest):
    def test_the_sign_of_a_determinant(self):
        p, rest = [0, 0, 0, 1], [[1, 0, 0, 1], [0, 1, 0, 1], [0, 0, 1, 1]]
        for n, order in enumerate(itertools.permutations(rest)):
            self.assertEqual(model_faces.orientation(p, *order), (1, -1, -1, 1, 1, -1)[n])
        self.assertEqual(model_faces.orientation(p, rest[0], rest[0], rest[2]), 0)
        rng = random.Random(1)
        for _ in range(200):
            points = [[rng.randint(-3, 3) for _ in range(3)] + [rng.randint(1, 3)] for _ in range(4)]
            a, b, c = [[Q(x, q[3]) - Q(y, points[0][3]) for x, y in zip(q[:3], points[0][:3])] for q in points[1:]]
            det = sum(a[i] * (b[i - 2] * c[i - 1] - b[i - 1] * c[i - 2]) for i in range(3))
            self.assertEqual(model_faces.orientation(*points), (det > 0) - (det < 0))

    def test_faces_look_outward_whichever_way_the_axes_run(self):
        for order, flips in WAYS:
            found = self.left([rearranged(block((0, 0, 0), (2, 3, 4), (1, 2, 3)), order, flips)])
            self.assertEqual(len(found), 6)
            for f in found:
                at = f.all()
                p, u, v = at[0, 0], at[f.sizes[0] - 1, 0], at[0, f.sizes[1] - 1]
                a, b = [[x - y for x, y in zip(q[:3], p)] for q in (u, v)]
                normal = [a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3)]
                middle = [sum(q[i] for q in at.values()) / len(at) - Q(c, 2) for i, c in enumerate((2, 3, 4))]
                self.assertGreater(sum(x * y for x, y in zip(normal, middle)), 0)

    def test_the_corners_whose_determinant_is_not_0_decide(self):
        """Corners that are pinched in turn; a volume all of whose corners are."""
        cube = block(degrees=(2, 2, 2))
        for count in range(1, 9):
            pinched = {tuple(2 * (c >> k & 1) for k in range(3)) for c in range(count)}
            beside = {(1, j, k): (i, j, k) for i, j, k in pinched}

            def change(index, p):
                return cube.all()[beside[index]] if index in beside else p
            self.agrees([with_points(cube, change)])
            self.agrees([rearranged(with_points(cube, change), (1, 0, 2), (0, 0, 0))])

    def test_volumes_with_different_hands_at_corners_are_refused(self):
        """One corner is pulled through the plane of its neighbours; or all of a face but a corner moves beyond the other end."""
        cube = block(degrees=(2, 2, 2))
        for corner in itertools.product((0, 2), repeat=3):
            dented = with_points(cube, lambda index, p: (*[Q(3, 4) - Q(x, 2) for x in p[:3]], 1) if index == corner else p)
            self.agrees([dented], 0)
            self.agrees([block((5, 5, 5), (6, 6, 6)), dented], 0)
        for twist in (1, -1):
            for at in ((0, 0, 0), (2, 2, 2), (2, 0, 2)):
                self.agrees([with_points(cube, lambda index, p: (p[0] * twist + 5, *p[1:]) if index[0] == at[0] and index != at else p)])

    def test_flat_volumes_have_the_hand_1(self):
        """A square, whose two faces with area are a wall; one in which they are not; a segment; a point."""
        square, ramp = block(shape=lambda p: (p[0], p[1], 0)), block(shape=lambda p: (p[0] + 2 * p[2], p[1], 0))
        segment, point = block(shape=lambda p: (0, 0, p[2])), block((0, 0, 0), (0, 0, 0))
        for flat, count in ((square, 0), (ramp, 6), (segment, 0), (point, 0)):
            for order, flips in WAYS:
                turned = rearranged(flat, order, flips)
                self.agrees([turned], count)
                self.agrees([block((5, 5, 5), (6, 6, 6)), turned], 6 + count)

    def test_the_thousandth_determinant_is_the_last(self):
        """A volume of 12 x 12 x 12 points in a plane but for one, which only determinant number 1000 or 1001 sees."""
        n = 12
        knots = [0, *range(n), n - 1]
        for number, hand in ((999, -1), (1000, 1)):
            i, j, k = number % 11, number // 11 % 11, number // 121
            points = [(x + 20 * z, y, -int((x, y, z) == (i, j, k + 1))) for z in range(n) for y in range(n) for x in range(n)]
            volume = texts.Map((1, 1, 1), [knots] * 3, points)
            self.assertTrue(texts.same(self.left([volume])[0], volumes.face(volume, 0, 0, hand)), number)


class Walls(FacesTest):
    def test_two_blocks_in_every_position(self):
        left, right = block(degrees=(2, 1, 4), shape=sheared), block((1, 0, 0), (2, 1, 1), (2, 1, 4), shape=sheared)
        for order, flips in WAYS:
            for other in (right, made_rational(right), mapped(right, (7, -3)), mapped(made_rational(right), (2, 1), Q(5, 3))):
                self.agrees([left, rearranged(other, order, flips)], 10)

    def test_what_is_not_a_wall(self):
        left, right = block(degrees=(1, 2, 2)), block((1, 0, 0), (2, 1, 1), (1, 2, 2))
        half = texts.Map((1, 2, 2), [right.knots[0], [0, 0, 0, Q(1, 2), 1, 1, 1], right.knots[2]],
                         [p for k in range(3) for p in [(x, y, Q(k, 2)) for y in (0, Q(1, 4), Q(3, 4), 1) for x in (1, 2)]])
        moved = with_points(right, lambda index, p: (p[0] + Q(1, 1 << 60), *p[1:]) if index == (0, 1, 1) else p)
        weighted = with_points(made_rational(right), lambda index, p: tuple(2 * c for c in p) if index == (0, 1, 1) else p)
        skew = [mapped(v) for v in (left, right)]
        skew[1].knots[1] = [0, 0, 0, 1, 1, 1]
        for other, count in ((right, 10), (half, 12), (moved, 12), (weighted, 12), (block((1, 0, 0), (2, 2, 1), (1, 2, 2)), 12), (block((2, 0, 0), (3, 1, 1), (1, 2, 2)), 12)):
            self.agrees([left, other], count)

    def test_faces_are_compared_in_their_lowest_degrees(self):
        """A saddle, quadratic along v, in other degrees; what has inner knots is not lowered."""
        def saddle(x, degrees, rational=False):
            n = degrees[1]                                # the control points of v^2 are i (i - 1) / (n (n - 1))

            def point(u, v, w):
                square = v * (v * n - 1) / (n - 1) if n > 1 else v
                p = (x + u, v, w + u * w + square + w * square)
                return (*p, 1) if rational else p
            return texts.bezier(degrees, point, rational)
        low = saddle(0, (1, 2, 1))
        for degrees in ((1, 2, 1), (3, 5, 1), (1, 2, 7), (2, 9, 4), (1, 1, 1)):
            for order, flips in WAYS[::7]:
                for rational in (False, True):
                    self.agrees([low, rearranged(saddle(1, degrees, rational), order, flips)])

        def cut(v, n):                                    # faces of these degrees across u
            return block((1, 0, 0), (2, 1, 1), (1, v, n))
        for v, n, count in ((1, 2, 10), (3, 3, 10), (1, 1, 10), (6, 2, 10)):
            self.agrees([block(degrees=(1, 2, 2)), cut(v, n)], count)
            self.agrees([block(degrees=(1, 2, 2)), rearranged(cut(v, n), (2, 0, 1), (1, 0, 1))], count)
        twice = texts.Map((1, 1, 1), [[0, 0, 1, 1], [0, 0, Q(1, 2), 1, 1], [0, 0, 1, 1]], [(x, Q(y, 2), z) for z in (0, 1) for y in (0, 1, 2) for x in (1, 2)])
        self.agrees([block(degrees=(1, 1, 2)), twice], 12)
        self.agrees([twice, texts.Map((1, 1, 2), twice.knots[:2] + [texts.bezier_knots(2)], [(x, Q(y, 2), Q(z, 2)) for z in (0, 1, 2) for y in (0, 1, 2) for x in (1, 0)])], 10)

    def test_weights_that_are_not_positive_in_the_lowest_degree(self):
        """Weights 5 - 12 t + 12 t^2 in degree 4 are positive; in degree 2 they are 5, -1, 5, and 2, 0, 2 of 2 - 4 t + 4 t^2 have a zero."""
        for low in ((5, -1, 5), (2, 0, 2), (1, Q(-1, 4), 1)):
            def volume(x, degree, low=low):
                def elevate(b, n):
                    while len(b) <= n:
                        p = len(b)
                        b = [(Q(i, p) * b[i - 1] if i else 0) + (Q(p - i, p) * b[i] if i < p else 0) for i in range(p + 1)]
                    return b
                weights, vs = elevate(list(map(Q, low)), degree), elevate([Q(0), Q(0), Q(low[2])], degree)
                points = [((x + u) * w, y, z * w, w) for z in (0, 1) for y, w in zip(vs, weights) for u in (0, 1)]
                return texts.Map((1, degree, 1), [texts.bezier_knots(p) for p in (1, degree, 1)], points, True)
            for degrees in ((8, 8), (8, 7), (7, 9), (10, 8)):
                pair = [volume(x, degree) for x, degree in zip((0, 1), degrees)]
                self.assertTrue(all(p[3] > 0 for v in pair for p in v.points))
                for order, flips in WAYS[::9]:
                    self.agrees([pair[0], rearranged(pair[1], order, flips)], 10)
                    self.agrees([pair[0], rearranged(mapped(pair[1], factor=Q(7, 2)), order, flips)], 10)

    def test_knots_count_up_to_an_affine_map(self):
        def bent(axis, middle, x):
            points = [(x + i, j, k) for k in (0, 1) for j in (0, 1, 3) for i in (0, 1)]
            return texts.Map((1, 1, 1), [[0, 0, 1, 1], axis, [0, 0, 1, 1]], points)
        first = bent([0, 0, 1, 3, 3], 1, 0)
        for axis, count in (([0, 0, 1, 3, 3], 10), ([5, 5, 6, 8, 8], 10), ([0, 0, 2, 6, 6], 10), ([0, 0, 2, 3, 3], 12), ([0, 0, 1, 2, 2], 12), ([-3, -3, -2, 0, 0], 10)):
            self.agrees([first, bent(axis, 1, 1)], count)
        reversed_ = rearranged(bent([0, 0, 1, 3, 3], 1, 1), (0, 1, 2), (0, 1, 0))
        self.assertEqual(reversed_.knots[1], [0, 0, 2, 3, 3])
        self.agrees([first, reversed_], 10)

    def test_three_equal_faces_all_stay(self):
        a, b = block(), block((1, 0, 0), (2, 1, 1))
        self.agrees([a, b, b], 18)                        # the faces of b come twice, too, on one side
        self.agrees([a, a], 12)                           # each face twice, on the same side
        self.agrees([a, b, block((1, 0, 0), (2, 1, 1), degrees=(1, 1, 1))])

    def test_volumes_on_one_side_of_a_face(self):
        """Equal under even symmetries only: the faces stay."""
        self.agrees([block(), block((1, 0, 0), (0, 1, 1)), block((0, 0, 0), (-1, 1, 1))])
        self.agrees([block(), block((0, 0, 0), (2, 1, 1))], 12)
        # A face that is symmetric under odd and even symmetries: equal points. It has no area, whichever way.
        self.agrees([block(shape=lambda p: (p[0], p[0] * p[1], p[0] * p[2]))], 5)

    def test_a_face_with_symmetries_of_its_own(self):
        """The wall is equal to itself under an odd symmetry, in another sense than that of its points: a crease u <-> v."""
        def crease(side):
            return texts.bezier((1, 1, 1), lambda u, v, w: (u + w + 2 * u * w, u + w + 2 * u * w, side * v + (u + w - 2 * u * w)))
        self.agrees([crease(1), crease(-1)])
        self.agrees([crease(1), rearranged(crease(1), (0, 1, 2), (0, 1, 0))])

    def test_a_ring_that_is_closed_on_itself(self):
        quarters = ring()
        self.agrees(quarters, 16)
        # One volume around: at its seams the weights of the quarters, which go from 1 to 2, are brought to one scale.
        points = [tuple(c * Q(2) ** k for c in quarters[k].at(i, r, z)) for z in (0, 1) for r in (0, 1) for k in range(4) for i in range(k != 0, 3)]
        whole = texts.Map((2, 1, 1), [[0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4], [0, 0, 1, 1], [0, 0, 1, 1]], points, True)
        self.agrees([whole], 4)

    def test_random_piles(self):
        """Volumes with few points, so that many faces are equal, collapsed or symmetric."""
        rng = random.Random(12)
        counts = set()
        for _ in range(150):
            made = []
            for _ in range(rng.randint(1, 4)):
                rational, degrees = rng.random() < .3, [rng.choice((1, 1, 1, 2, 4)) for _ in range(3)]
                lo = [rng.randint(0, 1) for _ in range(3)]
                volume = block(lo, [c + 1 for c in lo], degrees, rational)
                if rng.random() < .5:
                    spot = rng.choice(list(volume.all()))
                    volume = with_points(volume, lambda index, p: (rng.randint(0, 2), *p[1:]) if index == spot else p)
                if rational and rng.random() < .6:
                    by = [rng.randint(1, 2) for _ in range(3)]
                    volume = with_points(volume, lambda index, p: tuple(c * by[0] ** index[0] * by[1] ** index[1] * by[2] ** index[2] for c in p))
                if rng.random() < .4:
                    axis, value = rng.randrange(3), rng.randint(0, 1)
                    volume = with_points(volume, lambda index, p: tuple(value * p[3] if k == axis and index[(axis + 1) % 3] == 0 else c for k, c in enumerate(p)))
                volume = rearranged(volume, *rng.choice(WAYS))
                made.append(mapped(volume, (rng.choice((1, 1, 4)), rng.randint(-1, 1)), rng.choice((1, 2, Q(1, 4)))))
                if rng.random() < .3:
                    made.append(rearranged(made[-1], *rng.choice(WAYS)))
            self.agrees(made, subject_format=rng.choice(("vjson", "vjson", "g2", "mfem" if all(m.rational for m in made) else "g2")))
            counts.add(len(self.left(made) or ()))
        self.assertGreater(len(counts), 8)


class Areas(FacesTest):
    def test_points_and_curves_are_left_out(self):
        cone = block(degrees=(1, 2, 1), shape=lambda p: (p[0] * (1 - p[2]), p[1] * (1 - p[2]), p[2]))
        wedge = block(degrees=(1, 2, 1), shape=lambda p: (p[0] * (1 - p[2]), p[1], p[2]))
        for volume in (cone, wedge):
            for order, flips in WAYS[::5]:
                self.agrees([rearranged(volume, order, flips)], 5)
                self.agrees([rearranged(made_rational(volume), order, flips)], 5)

    def test_weights_count(self):
        """A curve whose weights are products, and one whose weights are not: as a map of two parameters it has an image without area
        too, but not by the equations of the page."""
        wedge = made_rational(block(degrees=(2, 2, 1), shape=lambda p: (p[0] * (1 - p[2]), p[1], p[2])))
        product = with_points(wedge, lambda index, p: tuple(c * 3 ** index[0] * 5 ** index[1] for c in p))
        other = with_points(wedge, lambda index, p: tuple(c * (2 if index == (1, 1, 1) else 1) for c in p))
        self.agrees([product], 5)
        self.agrees([other], 6)
        point = made_rational(block(degrees=(1, 1, 1), shape=lambda p: (p[0] * (1 - p[2]), p[1] * (1 - p[2]), p[2])))
        self.agrees([with_points(point, lambda index, p: tuple(c * (2 if index == (1, 1, 1) else 1) for c in p))], 5)

    def test_no_face_is_left(self):
        """A block whose opposite faces are equal in pairs."""
        self.agrees([texts.bezier((1, 1, 1), lambda u, v, w: (u, v, w))] * 1, 6)
        twisted = texts.Map((2, 2, 2), [texts.bezier_knots(2)] * 3, [(x % 2 * (1 + y % 2), y % 2 * (1 + z % 2), z % 2 * (1 + x % 2)) for z in range(3) for y in range(3) for x in range(3)])
        self.agrees([twisted], 0)


class Formats(FacesTest):
    SOLIDS = (("a block", [block((-1, -1, -1), (1, 1, 1))], 0),
              ("a bar of two", [block((-1, -1, -1), (0, 1, 1)), rearranged(block((0, -1, -1), (1, 1, 1)), (2, 0, 1), (1, 0, 0))], 0),
              ("a round block", [round_block()], 0), ("a ring", ring(), 1))

    def test_solids_in_every_format(self):
        for name, maps, genus in self.SOLIDS:
            entities = [f.entity() for f in volumes.faces(maps)]
            prover = forge.Prover(entities).prove()
            self.assertEqual(prover.plan.values["genus"], genus, name)
            for subject_format, write in texts.WRITERS.items():
                if subject_format == "mfem":
                    maps = [made_rational(m) for m in maps]
                    prover = forge.Prover([f.entity() for f in volumes.faces(maps)]).prove()
                texts.accepted(self, vc, write(maps), subject_format + "-faces", prover)

    def test_the_same_maps_in_every_format(self):
        rng = random.Random(6)
        for _ in range(12):
            maps = [rearranged(mapped(block((i, 0, 0), (i + 1, 1, 1), [rng.randint(1, 2) for _ in range(3)], rng.random() < .5), (2, 1)), *rng.choice(WAYS)) for i in range(2)]
            for subject_format in ("vjson", "itd", "g2"):
                self.agrees(maps, subject_format=subject_format)
            self.agrees([made_rational(m) for m in maps], subject_format="mfem")

    def test_other_entities_are_refused(self):
        volume, surface = block(), texts.bezier((1, 1), lambda u, v: (u, v, 0))
        for subject_format in ("vjson", "itd", "g2"):
            self.assertIsNone(self.left([volume, surface], subject_format))
            self.assertIsNone(self.left([surface], subject_format))
        self.assertIsNone(self.left([made_rational(surface)], "mfem"))
        model = json.loads(texts.json_text([volume]))
        curve = {"kind": "curve", "group": None, "attributes": [], "shape": {"degrees": [1], "periodic": [False], "knots": [["0", "0", "1", "1"]], "rational": False,
                                                                           "components": 3, "points": [["0", "0", "0"], ["1", "1", "1"]]}}
        self.assertTrue(texts.is_read(vc, json.dumps(model).encode(), "vjson-faces"))
        for other in (curve, dict(curve, kind="model", shape={}), dict(curve, kind="trimmed", shape={}), forge.triangle([(0, 0, 0), (1, 0, 0), (0, 1, 0)])):
            self.assertFalse(texts.is_read(vc, json.dumps(dict(model, entities=model["entities"] + [other])).encode(), "vjson-faces"))
        self.assertFalse(texts.is_read(vc, json.dumps(dict(model, entities=[])).encode(), "vjson-faces"))
        for dimension in (1, 2):
            plane = texts.bezier((1, 1, 1), lambda u, v, w: [u, v, w][:dimension])
            for subject_format in ("vjson", "g2"):
                self.assertIsNone(self.left([plane], subject_format))
            self.assertIsNone(self.left([texts.bezier((1, 1, 1), lambda u, v, w: [u, v, w][:dimension] + [1], True)], "mfem"))

    def test_attributes(self):
        """Coordinates from the fourth on change nothing; each of their numbers has at most 8192 bits."""
        for rational in (False, True):
            weight = [2] if rational else []
            plain = texts.bezier((1, 1, 1), lambda u, v, w: [2 * u, 2 * v, 2 * w] + weight, rational)
            for subject_format in (("vjson", "g2", "mfem") if rational else ("vjson", "g2")):
                for attributes in ([0], list(range(40)), [Q(-1, 3) if subject_format == "vjson" else Q(-1, 4)]):
                    with_them = texts.bezier((1, 1, 1), lambda u, v, w: [2 * u, 2 * v, 2 * w] + [u + a for a in attributes] + weight, rational)
                    self.assertEqual(*[[vars(m) for m in self.left([maps], subject_format)] for maps in (with_them, plain)])
        for bits, is_read in ((8192, True), (8193, False)):
            long = texts.bezier((1, 1, 1), lambda u, v, w: [u, v, w, (1 << bits - 1) * u])
            self.assertEqual(texts.is_read(vc, texts.json_text([long]), "vjson-faces"), is_read)

    def test_volumes_in_json(self):
        model = json.loads(texts.json_text([block(degrees=(1, 2, 1), rational=True)]))

        def answer(**changes):
            bent = json.loads(json.dumps(model))
            bent["entities"][0]["shape"].update(changes)
            return texts.is_read(vc, json.dumps(bent).encode(), "vjson-faces")
        shape = model["entities"][0]["shape"]
        self.assertTrue(answer())
        for changes in (dict(degrees=[1, 2]), dict(degrees=[1, 2, 2]), dict(degrees=[1, 2, 0]), dict(degrees=[1, 2, 64]), dict(degrees=[1, 2, 1, 1]), dict(periodic=[False, False]),
                        dict(periodic=[False, False, 0]), dict(periodic=[True, False, False]), dict(periodic=[False, True, False]), dict(knots=shape["knots"][:2]),
                        dict(knots=shape["knots"][:2] + [["0", "0", "1"]]), dict(knots=shape["knots"][:2] + [["0", "1", "0", "1"]]), dict(rational=False, components=3), dict(components=3), dict(points=shape["points"][:-1]),
                        dict(points=shape["points"] + shape["points"][:1]), dict(points=[["0", "0", "0", "0"]] * 12), dict(points=[["0", "0", "0", "-1"]] * 12), dict(extra=1)):
            self.assertFalse(answer(**changes), changes)

    def test_volumes_in_itd(self):
        cube = "[TRIVAR BEZIER 2 2 2 E3 [0 0 0][1 0 0][0 1 0][1 1 0][0 0 1][1 0 1][0 1 1][1 1 1]]"

        def faces_in(text):
            data = text.encode()
            return read_subject(data, "itd-faces") if texts.is_read(vc, data, "itd-faces") else None

        wanted = [texts.meaning(f) for f in faces_in(cube)]
        self.assertTrue(all(map(texts.same, wanted, volumes.faces([block()]))))
        for text in (cube.replace("TRIVAR BEZIER", "MULTIVAR BEZIER 3"), cube.replace("TRIVAR BEZIER", "TRIVAR BEZIER [rgb 1]"), "[OBJECT A [OBJECT B %s]]" % cube,
                     cube.replace("BEZIER 2 2 2 E3", "BSPLINE 2 2 2 2 2 2 E3 [KV 0 0 1 1][KV 0 0 1 1][KV 0 0 1 1]"),
                     cube.replace("E3", "P3").replace("[", "[1 ").replace("[1 TRIVAR", "[TRIVAR"), cube.replace("E3", "E5").replace("]", " 8 -9.5]", 8),
                     cube.replace("E3", "P4").replace("[", "[1 ").replace("[1 TRIVAR", "[TRIVAR").replace("]", " 8]", 8).replace("TRIVAR BEZIER", "MULTIVAR BEZIER 3"),
                     "[TRIVAR POWER 2 2 2 E3 [0 0 0][1 0 0][0 1 0][0 0 0][0 0 1][0 0 0][0 0 0][0 0 0]]"):
            found = [texts.meaning(f) for f in faces_in(text)]
            self.assertTrue(all(f.degrees == w.degrees and f.knots == w.knots and f.all() == w.all() for f, w in zip(found, wanted)), text)
        for text in (cube + "[SURFACE BEZIER 2 2 E3 [0 0 0] [1 0 0] [0 1 0] [1 1 0]]", cube.replace("TRIVAR BEZIER", "MULTIVAR BEZIER 2"), cube.replace("TRIVAR BEZIER", "MULTIVAR BEZIER 4"),
                     cube.replace("[1 1 1]", ""), cube.replace("[1 1 1]", "[1 1 1][1 1 1]"), cube.replace("2 2 2", "2 2"), cube.replace("2 2 2", "2 2 1"), cube.replace("E3", "E1"), cube.replace("E3", "E4"),
                     cube.replace("E3", "E10").replace("]", " 1 2 3 4 5 6 7]", 8), cube.replace("E3", "E2").replace(" 0]", "]").replace(" 1]", "]"),
                     "[OBJECT A]", cube + "[CURVE]", cube + "[POLYGON]"):
            self.assertIsNone(faces_in(text), text)
        self.assertFalse(texts.is_read(vc, cube, "itd"))

    def test_kvp_says_which_control_points_there_are(self):
        """Two given points along u, three in all; only clamped knots pass. The ends along u are one segment, so that no corner has a hand."""
        text = "[TRIVAR BSPLINE 2 2 2 2 2 2 E3 [KVP %s][KV 0 0 1 1][KV 0 0 1 1] [0 0 0][1 0 0][0 0 0][1 1 0][0 0 1][1 0 1][0 0 1][1 1 1]]"
        self.assertEqual(len(read_subject((text % "0 0 1 2 2").encode(), "itd-faces")), 4)     # its ends along u have no area
        for knots, good in (("0 0 1 2 2", True), ("0 1 2 3 4", False), ("0 0 1 2 3", False), ("-1 0 1 2 2", False), ("0 0 1 1", False), ("0 0 1 2 2 2", False)):
            self.assertEqual(texts.is_read(vc, text % knots, "itd-faces"), good, knots)

    def test_power_basis(self):
        """A twisted cubic block with random coefficients, against Bernstein coefficients that are summed up as the page says."""
        rng = random.Random(3)
        sizes = (3, 2, 4)
        given = {index: [rng.randint(-9, 9) for _ in range(3)] for index in itertools.product(*map(range, sizes))}
        for axis, index in enumerate(((1, 0, 0), (0, 1, 0), (0, 0, 1))):       # so large that the block does not fold
            given[index][axis] = 10000
        text = "[TRIVAR POWER 3 2 4 E3 %s]" % "".join("[%d %d %d]" % tuple(given[i, j, k]) for k in range(4) for j in range(2) for i in range(3))
        comb = itd.math.comb

        def factor(i, r, n):
            return Q(comb(i, r), comb(n - 1, r)) if r <= i else 0
        points = [[sum(factor(i, r, 3) * factor(j, s, 2) * factor(k, t, 4) * a[c] for (r, s, t), a in given.items()) for c in range(3)]
                  for k in range(4) for j in range(2) for i in range(3)]
        wanted = volumes.faces([texts.Map((2, 1, 3), [texts.bezier_knots(p) for p in (2, 1, 3)], points)])
        self.assertTrue(texts.is_read(vc, text, "itd-faces"))
        self.assertTrue(all(map(texts.same, [texts.meaning(f) for f in read_subject(text.encode(), "itd-faces")], wanted)))


class Refusals(FacesTest):
    def test_axes_begin_and_end_with_equal_knots(self):
        for p in (1, 2, 3):
            whole = [0] * (p + 1) + [1, 1, 1][:p] + [2] * (p + 1)
            for axis in range(3):
                def answer(knots):
                    axes = [[0, 0, 1, 1]] * 3
                    axes[axis], degrees = knots, [1] * 3
                    degrees[axis] = p
                    sizes = [len(t) - q - 1 for t, q in zip(axes, degrees)]
                    points = [(i, j, k) for k in range(sizes[2]) for j in range(sizes[1]) for i in range(sizes[0])]
                    return self.left([texts.Map(degrees, axes, points)]) is not None
                self.assertTrue(answer(whole))
                self.assertFalse(answer([Q(-1, 2)] + whole[1:]))
                self.assertFalse(answer(whole[:-1] + [Q(5, 2)]))
                self.assertFalse(answer([0] * (p + 1) + [1] * (p + 1) + [2] * (p + 1)))
                self.assertTrue(answer([0] * (p + 1) + [1] * p + [Q(3, 2)] * p + [2] * (p + 1)))

    def test_the_lengths_of_numbers(self):
        """8192 bits for the least common denominator of a point and for what it makes of its numbers."""
        long = (1 << 8192) - 1
        for x, good in ((long, True), (long + 1, False), (-long, True), (-long - 1, False), (Q(1, long), True), (Q(1, long + 1), False), (Q(long - 1, long), True), (Q(long + 2, long), False)):
            corner = (1, 1, 1) if x > 0 else (0, 1, 1)     # where it does not fold the block
            volume = with_points(block(), lambda index, p: (x, *p[1:]) if index == corner else p)
            self.assertEqual(self.left([volume]) is not None, good)
        a, b = (1 << 4096) - 1, (1 << 4096) + 1            # their product has 8192 bits
        for y, good in ((Q(1, b), True), (Q(1, 2 * b), False), (Q(1, a), True)):
            volume = with_points(block(), lambda index, p: (Q(1, a), y, *p[2:]) if index == (0, 0, 0) else p)
            self.assertEqual(self.left([volume]) is not None, good)
        inside = with_points(block(degrees=(2, 2, 2)), lambda index, p: (long + 1, *p[1:]) if index == (1, 1, 1) else p)
        self.assertIsNone(self.left([inside]))            # in the middle of the volume, too


class Hostile(FacesTest):
    def head(self, *axes):
        """A volume of degree 10 along each axis, up to its points; or with these knots, linear."""
        axes = axes or ["11 11 " + "0 " * 11 + "1 " * 11] * 3
        return "700 1 0 0 3 0 " + " ".join(axes) + " "

    def test_a_hundred_kilobytes_take_no_time(self):
        rng = random.Random(9)
        many = texts.g2_text([block([rng.randint(0, 1) for _ in range(3)], [2] * 3) for _ in range(400)])
        words = ("1e1200", "3e-1200", "7e-300", "9e1190", "11e-1199", "1e-1")
        grid = [index[::-1] for index in itertools.product(range(11), repeat=3)]           # words but for the corners and their neighbours
        long = self.head() + " ".join(rng.choice(words) if any(1 < i < 9 for i in index) else str(c) for index in grid for c in index)
        flat = self.head() + " ".join("%s %s %s" % (w, w, rng.choice(words)) for w in (rng.choice(words) for _ in range(1331)))
        n = 6000
        knots = "%d 2 -1e-600 -1e-600 %s 1e600 1e600" % (n, " ".join("%de500" % i for i in range(n - 2)))
        bar = self.head(knots, "2 2 0 0 1 1", "2 2 0 0 1 1") + " ".join("%d %d %d" % (i, j, k) for k in (0, 1) for j in (0, 1) for i in range(n))
        for name, data, answer in (("many", many, True), ("long", long, True), ("flat", flat, True), ("bar", bar, True)):
            start = time.process_time()
            self.assertEqual(texts.is_read(vc, data, "g2-faces"), answer, name)
            self.assertLess(time.process_time() - start, 30, name)


class Lies(FacesTest):
    def test_a_missing_wall_and_a_hole_are_not_certified(self):
        """The certificate of a bar of two blocks, for a file in which they do not meet."""
        bar = [block((-1, -1, -1), (0, 1, 1)), block((0, -1, -1), (1, 1, 1))]
        prover = forge.Prover([f.entity() for f in volumes.faces(bar)]).prove()
        prover.plan.values["subject_format"] = "g2-faces"
        for change in (lambda index, p: (p[0] + Q(1, 1 << 30), *p[1:]) if index == (0, 0, 0) else p, lambda index, p: (-p[0], *p[1:])):
            data = texts.g2_text([bar[0], with_points(bar[1], change)])
            code, line = vc.check(data, prover.plan.certificate(data))
            self.assertEqual((code, line[:9]), (1, "REJECT B1"))
        data = texts.g2_text(bar)
        self.assertEqual(vc.check(data, prover.plan.certificate(data))[0], 0)

    def test_an_inverted_pair_is_no_solid(self):
        """Two blocks on the same side of their common face: both faces stay, and P1 sees them."""
        pair = [block(), block((0, 0, 0), (2, 1, 1))]
        prover = forge.Prover([f.entity() for f in volumes.faces(pair)], checked=False)
        prover.plan.trees = [[0] for _ in prover.patches]
        prover.plan.boxes, prover.plan.values["subject_format"] = [forge.Box(1, [-1] * 3, [1 << 30] * 3)], "vjson-faces"
        data = texts.json_text(pair)
        self.assertEqual(vc.check(data, prover.plan.certificate(data))[1][:9], "REJECT P1")


if __name__ == "__main__":
    unittest.main()
