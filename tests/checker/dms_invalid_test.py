#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim dms-invalid-1: for each kind of witness, true ones made by hand are accepted, and each false one dies by the condition
that is named."""
import itertools
import json
import pathlib
import random
import sys
import unittest
from fractions import Fraction as Q

import judges

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests" / "support")]
import dms_files as files                                  # noqa: E402
import dms_invalid_files as made                           # noqa: E402

CHECKERS = {"C++": judges.in_cpp}                          # (exit code, condition or ACCEPT, all that was printed) of a model and a certificate
CORNERS = [[Q(c) for c in p] for p in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))]
TET = [0, 1, 2, 3]


def same(p):
    return list(p)


def mirrored(p):
    return [-p[0], p[1], p[2]]


def flat(p):
    return [p[0] + p[1] / 3, p[1], p[0] - p[1]]


def curved_and_flat(p):
    return [p[0] + p[1] * p[1], p[1] + p[2] * p[0], 0]


def one(degree=1, warp=same):
    """One tetrahedron, its clouds collapsed."""
    return files.model(degree, [[p] for p in CORNERS], [TET], warp)


def pair(second, degree=1, warp=same, tetrahedra=(TET, [4, 5, 6, 7])):
    """Two tetrahedra; second: the corners from number 4 on."""
    return files.model(degree, [[[Q(c) for c in p]] for p in [*CORNERS, *second]], [list(t) for t in tetrahedra], warp)


def moved(by):
    return [[c + b for c, b in zip(p, by)] for p in CORNERS]


def block(degree=2, counts=(1, 1, 1), radius=Q(1, 20), warp=same, seed=1):
    """Cubes, each of six tetrahedra; the inner vertices have clouds."""
    points, tetrahedra = files.grid_domain(counts)
    return files.model(degree, files.clouds_of(points, degree, counts, radius, seed), tetrahedra, warp)


def with_clouds(clouds, warp=same):
    """Degree 2, one tetrahedron; clouds: those of its vertices, lists of second knots."""
    return files.model(2, [[p, *more] for p, more in zip(CORNERS, clouds)], [TET], warp)


def changed(data, change):
    file = json.loads(data)
    change(file)
    return json.dumps(file).encode()


class Case(unittest.TestCase):
    def judged(self, expected, proof, body=None, **values):
        certificate = proof.certificate(body, **values)
        for name, checker in CHECKERS.items():
            code, condition, text = checker(proof.data, certificate)
            self.assertEqual((condition, code), (expected, 0 if expected == "ACCEPT" else 1), f"{name}: {text}")

    def accepted(self, proof):
        self.judged("ACCEPT", proof)


def every_kind():
    """A true certificate of each kind."""
    return [made.tet_reversed(pair(moved((3, 0, 0)), tetrahedra=(TET, [4, 5, 7, 6])), 1),
            made.face_overused(pair([(0, 0, 2)], tetrahedra=(TET, [0, 1, 2, 4])), (0, 3), (1, 3)),
            made.cloud_degenerate(with_clouds([[[Q(1)] * 3], [], [], []]), 0, (1, 0, 0, 0)),
            no_core(), inside(), made.negative_jacobian(one(1, mirrored), [Q(1, 5)] * 3),
            made.zero_jacobian(one(2, curved_and_flat), 0, small()), made.edge_overused(fan_of_two(2), 0, 1), made.several_fans(fan_of_two(1), 0),
            faces_meet(), made.tetrahedra_meet(pair(moved([Q(1, 8)] * 3)), 0, 1, [Q(1, 5)] * 3),
            made.images_meet(one(1, flat), [Q(1, 8), Q(1, 8), 0], [Q(1, 8), Q(1, 8), Q(1, 2)]), crossing(slid()), covering()]


def fan_of_two(common):
    """Two tetrahedra with one or two common vertices."""
    others = [(-1, 0, 0), (0, -1, 0), (0, 0, -1)] if common == 1 else [(0, -1, 0), (0, 0, -1)]
    return pair(others, tetrahedra=(TET, [0, 1, 4, 5] if common == 2 else [0, 4, 6, 5]))


def small(at=(Q(1, 8), Q(1, 8), Q(1, 8)), size=Q(1, 16)):
    return [[a + size * c for a, c in zip(at, p)] for p in CORNERS]


def no_core(turn=Q(0), factor=Q(1)):
    """Vertices 0 and 1 have knots in one plane with the edge of 2 and 3, or beyond one another. Corners (1, 0, 0), (0, 1, 0), 0, (0, 0, 1)."""
    order = [CORNERS[i] for i in (1, 2, 0, 3)]
    p, q = [Q(1, 2) - turn, Q(1, 2), Q(0)], [Q(1, 2), Q(1, 2) - turn, Q(0)]
    data = files.model(2, [[order[0], p], [order[1], q], [order[2]], [order[3]]], [TET])
    one_up, other_up = made.height([p, *order[1:]], 1), made.height([order[0], q, *order[2:]], 0)
    ratio = -one_up[0] / other_up[0]
    return made.cloud_no_core(data, 0, [((1, 0, 0, 0), 1, Q(1)), ((0, 1, 0, 0), 0, ratio * factor)])


def inside(weights=(0, 1, 0, 0), sums=(1, 0, 0), knot=(Q(1, 8),) * 3, f=(0, 3), tetrahedron=0):
    """The second knot of vertex 0 is in the tetrahedron. Face 3 is (0, 2, 1)."""
    return made.cloud_inside(with_clouds([[list(knot)], [], [], []]), f, sums, tetrahedron, [Q(w) for w in weights])


def faces_meet(w=(1, 1, 1), x=(1, 0, 0), f=(0, 0), g=(1, 1)):
    """Vertex 4 touches face 0, (1, 2, 3), from outside. Face 1 of (4, 5, 6, 7) is (4, 7, 6)."""
    return made.faces_meet(pair(moved([Q(1, 3)] * 3)), f, g, [Q(c) for c in w], [Q(c) for c in x])


class Proofs(Case):
    # PROVES DMS-2
    def test_every_kind(self):
        for kind, proof in enumerate(every_kind()):
            with self.subTest(made.FINDINGS[kind]):
                self.assertEqual(proof.kind, kind)
                self.accepted(proof)

    def test_wrong_words_and_numbers(self):
        for kind, proof in enumerate(every_kind()):
            self.judged("S1", proof, finding="M5")
            self.judged("B3", proof, finding=made.FINDINGS[(kind + 1) % len(made.FINDINGS)])
            self.judged("B3", proof, tetrahedra=99)
            self.judged("S1", proof, subject_format="vmicro")

    def test_a_sound_model_has_none_of_these_defects(self):
        sound = one(2)
        for proof in every_kind():
            if proof.kind not in (0, 1, 9, 10, 12):           # they name more than one tetrahedron
                proof.data = sound
                self.judged(f"W{proof.kind}", proof)


class Tetrahedra(Case):
    def test_reversed(self):
        data = pair(moved((3, 0, 0)), tetrahedra=(TET, [4, 5, 7, 6]))
        self.judged("W0", made.tet_reversed(data, 0))
        self.accepted(made.tet_reversed(pair([(0, 1, 1), (1, 0, 0), (0, 1, 0), (-1, 2, 1)]), 1))       # it has no volume

    def test_overused_faces(self):
        data = pair([(0, 0, 2)], tetrahedra=(TET, [0, 1, 2, 4]))
        self.judged("W1", made.face_overused(data, (0, 3), (0, 3)))
        self.judged("W1", made.face_overused(data, (0, 0), (1, 0)))
        opposite = pair([(0, 0, -2)], tetrahedra=(TET, [0, 2, 1, 4]))
        self.judged("W1", made.face_overused(opposite, (0, 3), (1, 3)))
        turned = pair([(0, 0, 2)], tetrahedra=(TET, [1, 2, 0, 4]))
        self.accepted(made.face_overused(turned, (0, 3), (1, 3)))

    def test_common_inner_points(self):
        data, u = pair(moved([Q(1, 8)] * 3)), [Q(1, 5)] * 3
        self.judged("W10", made.tetrahedra_meet(data, 0, 0, u))
        self.judged("W10", made.tetrahedra_meet(data, 0, 1, [Q(1, 8)] * 3))                            # on the border
        self.judged("W10", made.tetrahedra_meet(data, 0, 1, [Q(1, 3), Q(1, 3), Q(1, 3)]))
        self.judged("W10", made.tetrahedra_meet(data, 0, 1, [Q(1, 9)] * 3))
        reversed_one = pair(moved([Q(1, 8)] * 3), tetrahedra=(TET, [4, 5, 7, 6]))
        self.judged("W10", made.tetrahedra_meet(reversed_one, 0, 1, u))


class Clouds(Case):
    def test_degenerate(self):
        data = with_clouds([[[Q(1)] * 3], [], [], []])
        self.judged("W2", made.cloud_degenerate(data, 0, (0, 0, 0, 0)))
        self.judged("W2", made.cloud_degenerate(data, 0, (0, 1, 0, 0)))
        self.judged("W2", made.cloud_degenerate(data, 0, (2, 0, 0, 0)))
        self.judged("W2", made.cloud_degenerate(data, 0, (1, 1, 0, 0)))
        self.judged("W2", made.cloud_degenerate(data, 0, (255, 255, 255, 255)))
        self.accepted(made.cloud_degenerate(with_clouds([[[Q(1), Q(0), Q(0)]], [], [], []]), 0, (1, 0, 0, 0)))

    def test_separate_control_points_have_one_more_knot(self):
        far = [Q(2)] * 3
        data = changed(files.separate(one(2)), lambda f: f["vertices"][0].extend([f["vertices"][0][0], [str(c) for c in far]]))
        self.accepted(made.cloud_degenerate(data, 0, (2, 0, 0, 0)))
        self.judged("W2", made.cloud_degenerate(data, 0, (1, 0, 0, 0)))
        self.judged("W2", made.cloud_degenerate(data, 0, (3, 0, 0, 0)))

    def test_no_core(self):
        self.judged("W3", no_core(factor=Q(2)))            # not constant
        self.judged("W3", no_core(factor=Q(-1)))
        proof = no_core()
        for gamma, m, y in (((1, 1, 0, 0), 1, 1), ((0, 0, 0, 0), 1, 1), ((1, 0, 0, 0), 0, 1), ((255, 255, 255, 255), 1, 1), ((1, 0, 0, 0), 1, 0)):
            self.judged("W3", made.cloud_no_core(proof.data, 0, [(gamma, m, Q(y)), ((0, 1, 0, 0), 0, Q(1))]))
        # The sum of the four heights of one tetrahedron is constant, but positive.
        self.judged("W3", made.cloud_no_core(proof.data, 0, [((0, 0, 0, 0), m, Q(1)) for m in range(4)]))
        self.judged("W3", made.cloud_no_core(proof.data, 0, [((0, 0, 0, 0), 0, Q(1))]))

    def test_no_core_by_four_heights(self):
        turn = Q(1, 6)
        data = no_core(turn).data
        # Where the first two heights are positive, x or y is negative.
        order = [CORNERS[i] for i in (1, 2, 0, 3)]
        p, q = [Q(1, 2) - turn, Q(1, 2), Q(0)], [Q(1, 2), Q(1, 2) - turn, Q(0)]
        up = [made.height([p, *order[1:]], 1), made.height([order[0], q, *order[2:]], 0), made.height(order, 0), made.height(order, 1)]
        a, b = up[0][0] + up[1][0], up[0][1] + up[1][1]
        self.assertLess(max(a, b), 0)
        parts = [((1, 0, 0, 0), 1, Q(1)), ((0, 1, 0, 0), 0, Q(1)), ((0, 0, 0, 0), 0, -a / up[2][0]), ((0, 0, 0, 0), 1, -b / up[3][1])]
        self.accepted(made.cloud_no_core(data, 0, parts))
        self.judged("W3", made.cloud_no_core(data, 0, parts[:3]))
        self.judged("W3", made.cloud_no_core(no_core(-turn).data, 0, parts))

    def test_reversed_parts_of_a_core_do_not_count(self):
        # Beyond the plane of the others, vertex 0 makes d negative; that height and the one of the plane would add up to 0.
        data = with_clouds([[[Q(1)] * 3], [], [], []])
        reversed_one = [[Q(1)] * 3, *CORNERS[1:]]
        sums = [a / b for a, b in zip(made.height(reversed_one, 0), made.height(CORNERS, 0))]
        self.assertEqual(sums, [1] * 4)
        self.judged("W3", made.cloud_no_core(data, 0, [((1, 0, 0, 0), m, Q(1)) for m in range(4)]))

    def test_a_knot_inside(self):
        self.judged("W4", inside(weights=(1, 0, 0, 0)))
        self.judged("W4", inside(weights=(0, 1, 0, -1)))
        self.judged("W4", inside(weights=(0, 0, 0, 0)))
        self.accepted(inside(weights=(0, 2, Q(1, 9), Q(3, 11))))
        self.judged("W4", inside(sums=(0, 0, 0), weights=(0, 1, 0)))
        self.judged("W4", inside(sums=(2, 0, 0), weights=(0, 1, 0, 0, 0)))
        self.judged("W4", inside(sums=(0, 1, 0)))
        self.judged("W4", inside(sums=(255, 255, 255), weights=[1] * 768))
        self.judged("W4", inside(knot=(Q(1, 8), Q(1, 8), Q(-1, 8))))
        self.judged("W4", inside(knot=(Q(1, 8), Q(1, 8), Q(0))))
        self.judged("B1", inside(tetrahedron=1))

    def test_a_knot_inside_of_an_inner_face(self):
        f = (0, 3)
        data = changed(pair([(0, 0, -1)], 2, tetrahedra=(TET, [0, 2, 1, 4])), lambda file: file["vertices"][0].append(["1/8"] * 3))
        self.judged("W4", made.cloud_inside(data, f, (1, 0, 0), 0, [Q(0), Q(1), Q(0), Q(0)]))
        self.accepted(made.cloud_inside(data, (0, 1), (1, 0, 0), 0, [Q(0), Q(1), Q(0), Q(0)]))


class Boundary(Case):
    def test_edges(self):
        data = fan_of_two(2)
        self.judged("W7", made.edge_overused(data, 1, 0))
        self.judged("W7", made.edge_overused(data, 0, 0))
        self.judged("W7", made.edge_overused(data, 0, 2))
        self.judged("B1", made.edge_overused(data, 0, 6))

    def test_fans(self):
        data = fan_of_two(1)
        self.judged("W8", made.several_fans(data, 1))
        self.judged("W8", made.several_fans(one(), 0))
        self.judged("B1", made.several_fans(data, 7))
        self.judged("W8", made.several_fans(fan_of_two(2), 0))         # the edge connects them
        self.judged("W8", made.several_fans(changed(one(), lambda f: f["vertices"].append([["9", "9", "9"]])), 4))

    def test_faces(self):
        self.accepted(faces_meet((2, 2, 2), (Q(1, 3), 0, 0)))
        self.judged("W9", faces_meet((1, 1, 2)))
        self.judged("W9", faces_meet((1, 1, -1)))
        self.judged("W9", faces_meet((0, 0, 0)))
        self.judged("W9", faces_meet(x=(0, 0, 0)))
        self.judged("W9", faces_meet(x=(1, 1, -1)))
        self.judged("W9", faces_meet(g=(0, 0), x=(1, 1, 1)))
        self.judged("W9", faces_meet(g=(0, 1), x=(1, 0, 0)))
        neighbours = pair([(0, 0, -1)], tetrahedra=(TET, [0, 2, 1, 4]))
        point = [Q(0), Q(1), Q(1)]                         # of (0, 3, 2)
        self.judged("W9", made.faces_meet(neighbours, (0, 3), (0, 1), [Q(1), Q(1), Q(0)], [Q(1), Q(0), Q(1)]))       # an inner face
        self.judged("W9", made.faces_meet(neighbours, (0, 1), (0, 0), point, [Q(0), Q(1), Q(1)]))                    # their common edge


class Maps(Case):
    POINTS = [[Q(c) for c in p] for p in itertools.product((0, 1, Q(1, 2), Q(3, 4), 2), repeat=3)]

    def test_a_negative_determinant_anywhere(self):
        data = block(2, (2, 2, 2), Q(1, 4), mirrored)
        knots = [[Q(c) for c in knot] for cloud in json.loads(data)["vertices"] for knot in cloud]
        for u in [*self.POINTS[::7], *knots[-3:], [Q(1, 3), Q(1, 5), Q(6, 7)]]:
            self.accepted(made.negative_jacobian(data, u))
        for degree in (1, 3, 4):
            self.accepted(made.negative_jacobian(block(degree, (1, 1, 2), Q(1, 4), mirrored), [Q(1, 3), Q(1, 2), Q(1)]))
        for u in ([Q(-1), Q(0), Q(0)], [Q(5, 2), Q(1), Q(1)]):
            self.judged("W5", made.negative_jacobian(data, u))
        self.judged("W5", made.negative_jacobian(block(2, (2, 2, 2), Q(1, 4)), [Q(1)] * 3))
        self.judged("W5", made.negative_jacobian(block(2, warp=flat), [Q(1, 2)] * 3))

    def test_a_fold(self):
        # x (3 - 2 x) falls where x > 3/4: control points of degree 2 need the blossom of the square.
        def fold(data):
            def change(file):
                for c in file["control"]:
                    x = [Q(file["vertices"][v][0][0]) for v in c["at"]]
                    c["value"][0] = str(3 * sum(x) / 2 - 2 * x[0] * x[1])
            return changed(data, change)
        data = fold(block(2, (2, 1, 1), Q(0)))
        for x, condition in ((Q(1, 2), "W5"), (Q(3, 4), "W5"), (Q(751, 1000), "ACCEPT"), (Q(2), "ACCEPT")):
            self.judged(condition, made.negative_jacobian(data, [x, Q(1, 3), Q(1, 4)]))
        for x, condition in ((Q(1), "ACCEPT"), (Q(6, 5), "W11")):
            self.judged(condition, made.images_meet(data, [Q(1, 2), Q(1, 3), Q(1, 4)], [x, Q(1, 3), Q(1, 4)]))

    def test_equal_images_anywhere(self):
        # With clouds the value of an affine map is exact at knots and on faces, too.
        for data in (block(2, (2, 2, 2), Q(1, 4), flat), block(3, (2, 2, 2), Q(1, 4), flat), files.separate(block(2, (1, 1, 1), Q(0), flat))):
            top = 2 if len(json.loads(data)["tetrahedra"]) > 6 else 1
            for x, y in ((Q(0), Q(0)), (Q(1, 2), Q(1)), (Q(1), Q(1)), (Q(1, 3), Q(2, 7))):
                for z, other in ((Q(0), Q(top)), (Q(1, 2), Q(1)), (Q(1, 3), Q(5, 7))):
                    self.accepted(made.images_meet(data, [x, y, z], [x, y, other]))
            self.judged("W11", made.images_meet(data, [Q(1)] * 3, [Q(1)] * 3))
            self.judged("W11", made.images_meet(data, [Q(1)] * 3, [Q(1), Q(1), Q(5)]))
            self.judged("W11", made.images_meet(data, [Q(1), Q(1), Q(-1, 9)], [Q(1)] * 3))
            self.judged("W11", made.images_meet(data, [Q(1), Q(1), Q(1)], [Q(1), Q(1, 2), Q(1)]))

    def test_a_flat_leaf(self):
        for data in (one(2, curved_and_flat), one(1, flat), one(3, flat), one(4, flat)):
            self.accepted(made.zero_jacobian(data, 0, small()))
            self.accepted(made.zero_jacobian(data, 0, CORNERS))
        data = one(2, curved_and_flat)
        self.accepted(made.zero_jacobian(data, 0, small(), [[Q(1), Q(0), Q(0), Q(1, 2)], [Q(0), Q(3), Q(-1), Q(5)]]))
        self.judged("W6", made.zero_jacobian(one(2), 0, small()))
        self.judged("W6", made.zero_jacobian(one(2, lambda p: [p[0] * p[0], p[1], p[2]]), 0, small()))
        self.judged("W6", made.zero_jacobian(data, 0, small((Q(-1, 64), Q(1, 8), Q(1, 8)))))
        points = small()
        self.judged("W6", made.zero_jacobian(data, 0, [points[i] for i in (0, 1, 3, 2)]))
        self.judged("W6", made.zero_jacobian(data, 0, [points[0], *points[:3]]))
        self.judged("B1", made.zero_jacobian(data, 1, points))

    def test_a_flat_leaf_among_knots(self):
        data = block(2, (2, 2, 2), Q(1, 4), flat)
        file = json.loads(data)
        corners = [[Q(c) for c in file["vertices"][v][0]] for v in file["tetrahedra"][0]]
        self.judged("W6", made.zero_jacobian(data, 0, corners))        # knots cut it
        def near(corner, size):
            return [[a + size * (b - a) for a, b in zip(corners[corner], p)] for p in corners]
        self.accepted(made.zero_jacobian(data, 0, near(0, Q(1, 64))))

    def test_the_conditions_that_make_a_map(self):
        kinds = {5: lambda data: made.negative_jacobian(data, [Q(1, 5)] * 3), 6: lambda data: made.zero_jacobian(data, 0, small()),
                 11: lambda data: made.images_meet(data, [Q(1, 5)] * 3, [Q(1, 6)] * 3), 12: lambda data: crossing(data, at=0),
                 13: lambda data: made.point_covered(data, 0, small(), [Q(1, 5)] * 3)}
        twice = pair([(0, 0, 2)], 2, tetrahedra=(TET, [0, 1, 2, 4]))
        apart = changed(files.separate(pair([(0, 0, -1)], 2, tetrahedra=(TET, [0, 2, 1, 4]))),
                        lambda f: next(c for c in f["control"] if c["beta"] == [2, 0, 0, 0])["value"].__setitem__(0, "1/7"))
        for kind, proof in kinds.items():
            with self.subTest(kind):
                self.judged("D1", proof(pair(moved((3, 0, 0)), tetrahedra=(TET, [4, 5, 7, 6]))))
                self.judged("D2", proof(twice))
                self.judged("E1", proof(apart))
                self.judged("E2", proof(with_clouds([[[Q(1)] * 3], [], [], []])))
                self.judged("E3", proof(with_clouds([[[Q(1, 8)] * 3], [], [], []])))

    def test_planes_of_the_boundary(self):
        # The hull of a face and of a knot outside of it passes the second tetrahedron: no axis and none of its faces parts them.
        corners = [[8 * c for c in p] for p in CORNERS] + [[Q(c) for c in p] for p in ((-2, 0, 1), (-1, 3, 3), (0, 8, 6), (-4, 1, 1))]
        clouds = [[p] for p in corners]
        clouds[0].append([Q(-3), Q(-5), Q(-1)])
        data, u = files.model(2, clouds, [TET, [4, 5, 6, 7]], mirrored), [Q(1, 5)] * 3
        plane = [Q(c) for c in (23, -5, -4, -50)]
        at = range(1, 4)                                   # the faces of vertex 0
        self.judged("E3", made.negative_jacobian(data, u))
        self.accepted(made.negative_jacobian(data, u, {face: [plane] for face in at}))
        self.accepted(made.negative_jacobian(data, u, {face: [[-c for c in plane], [Q(0), Q(0), Q(1), Q(7)]] for face in at}))
        self.judged("E3", made.negative_jacobian(data, u, {0: [plane]}))
        self.judged("E3", made.negative_jacobian(data, u, {face: [[*plane[:3], Q(-39)]] for face in at}))       # it cuts the hull
        self.judged("E3", made.negative_jacobian(data, u, {face: [[*plane[:3], Q(-51)]] for face in at}))       # it cuts the tetrahedron
        # A plane does not help a knot inside.
        self.judged("E3", made.negative_jacobian(with_clouds([[[Q(1, 8), Q(1, 9), Q(1, 10)]], [], [], []], mirrored), u,
                                                 {0: [[Q(1), Q(1), Q(1), Q(1)]]}))

    def test_limits(self):
        data, u = one(1, mirrored), [Q(1, 5)] * 3
        self.judged("B2", made.negative_jacobian(data, [Q(1, 5) + Q(1, 3**700), *u[1:]]))
        self.judged("B2", made.negative_jacobian(data, u, {1: [[Q(1), Q(0), Q(0), Q(3**700)]]}))
        self.judged("B2", made.negative_jacobian(changed(data, lambda f: f["control"][0]["value"].__setitem__(1, str(3**170))), u))
        self.judged("B2", made.negative_jacobian(changed(data, lambda f: f["vertices"][0][0].__setitem__(1, str(3**170))), u))
        self.judged("B2", made.negative_jacobian(one(7, mirrored), u))
        self.accepted(made.negative_jacobian(one(6, mirrored), u))
        self.judged("B2", made.tetrahedra_meet(pair(moved([Q(1, 8)] * 3)), 0, 1, [Q(1, 5) + Q(1, 3**700), *u[1:]]))
        # What needs no map has no limits but those of the file.
        self.accepted(made.tet_reversed(changed(one(9), lambda f: f["tetrahedra"][0].__setitem__(slice(2, 4), [3, 2])), 0))
        far = pair([[(c - Q(1, 9)) * 3**1000 for c in p] for p in CORNERS])
        self.accepted(made.tetrahedra_meet(far, 0, 1, u))


# ---------------------------------------------------------------- crossings

def triangle(data, f, points):
    """s on the triangle of these points in a face of a collapsed tetrahedron, as a function of (s, t)."""
    file = json.loads(data)
    t = file["tetrahedra"][f[0]]
    corners = [[float(Q(c)) for c in file["vertices"][v][0]] for v in t]
    values = {tuple(c["at"]): [float(Q(x)) for x in c["value"]] for c in file["control"]}
    whole = made.d(*corners)

    def value(beta):
        return values[tuple(sorted(v for v, b in zip(t, beta) for _ in range(b)))]

    def at(s, u):
        weights = (1 - s, s * (1 - u), s * u)
        place = [sum(w * float(p[k]) for w, p in zip(weights, points)) for k in range(3)]
        barycentric = [made.d(*(place if i == m else c for i, c in enumerate(corners))) / whole for m in range(4)]
        return made.bezier(value, barycentric)(file["degree"])
    return at


def corners_of(data, f):
    file = json.loads(data)
    return [[Q(c) for c in file["vertices"][file["tetrahedra"][f[0]][k]][0]] for k in made.FACES[f[1]]]


def crossing(data, f=(0, 0), g=None, at=(.6, .5, .6, .5), fixed=1, width=1 / 256, first=None, second=None, planes=((), ()), sheets=None,
             change=None):
    """A crossing of two pieces, by default whole faces. at: near it; 0: it is not looked for. sheets: as enclosed() has
    them. change(rectangles, rows): a lie."""
    g = g or (len(json.loads(data)["tetrahedra"]) - 1, 1)
    first, second = first or corners_of(data, f), second or corners_of(data, g)
    if at == 0:
        interval = (2, 1, 2)
        rectangles, rows = ([(2, 1, 1), interval], [interval, interval]), [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    else:
        rectangles, rows = made.enclosed(sheets or [triangle(data, f, first), triangle(data, g, second)], at, fixed, width)
    if change:
        change(rectangles, rows)
    return made.images_cross(data, [(f, first, planes[0]), (g, second, planes[1])], rectangles, rows)


def slid(by=Q(13, 40), degree=1):
    """Two tetrahedra whose images overlap: the points (3/5, 1/2) of face 0 of the first one and of face 1 of the second one have one."""
    return pair(moved((3, 0, 0)), degree, lambda p: p if p[0] < 2 else [p[0] - 3 + by + p[2] / 4, p[1], p[2]])


def umbrella(degree=2):
    """A tetrahedron over the triangle (-1, -1), (0, 1), (1, -1); on it s is (x x, x y, y), by which (x, 0) and (-x, 0) have one image."""
    corners = [[Q(c) for c in p] for p in ((-1, -1, 0), (1, -1, 0), (0, 1, 0), (0, 0, 1))]
    control = {}
    for at in itertools.combinations_with_replacement(TET, degree):
        (x, y, z), (u, v, w) = (corners[i] for i in at)
        control[at] = [x * u, (x * v + y * u) / 2, (y + v - z - w) / 2]
    return files.text(degree, [[p] for p in corners], [TET], control)


class Crossings(Case):
    def lie(self, change, **values):
        self.judged("W12", crossing(slid(), change=change, **values))

    def test_pieces_of_two_faces(self):
        for degree in (1, 2, 3):
            for fixed in range(4):
                self.accepted(crossing(slid(degree=degree), fixed=fixed))
        data = slid()
        middle = made.mean(corners_of(data, (0, 0)), (1, 1, 1))
        part = [made.mean([p, middle], (7, 1)) for p in corners_of(data, (0, 0))]
        self.accepted(crossing(data, first=part))

    def test_no_crossing(self):
        proof = crossing(slid())
        proof.data = slid(Q(3))
        self.judged("W12", proof)

    def test_lies_about_pieces(self):
        data = slid()
        whole = corners_of(data, (0, 0))
        self.judged("W12", crossing(data, first=[whole[i] for i in (0, 2, 1)]))                # turned
        wide = [made.mean([p, made.mean(whole, (1, 1, 1))], (5, -1)) for p in whole]
        self.judged("W12", crossing(data, first=wide))                                         # beyond the face
        off = [[p[0] + Q(1, 1000), *p[1:]] for p in whole]
        self.judged("W12", crossing(data, first=off))
        self.judged("W12", crossing(data, f=(0, 1), first=whole))
        both = pair([(0, 0, -1), *moved((3, 0, 0))], 1, lambda p: p if p[0] < 2 else [p[0] - 3, p[1] + Q(3, 10), p[2] - Q(3, 10)],
                    (TET, [0, 2, 1, 4], [5, 6, 7, 8]))
        self.judged("W12", crossing(both, f=(0, 3), g=(2, 2)))                         # an inner face
        self.judged("B1", crossing(data, f=(0, 4), first=whole, at=0))

    def test_lies_about_intervals(self):
        def ends(sheet, number, low=None, high=None):
            def change(rectangles, _):
                k, a, b = rectangles[sheet][number]
                rectangles[sheet][number] = k, a if low is None else low, b if high is None else (1 << k) - high
            return change
        for sheet, number, fixed, ways in ((0, 0, 1, ("low", "high")), (0, 1, 0, ("low", "high")), (1, 0, 3, ("low",))):
            for way in ways:
                with self.subTest(sheet=sheet, number=number, way=way):
                    self.accepted(crossing(slid(), fixed=fixed, change=ends(sheet, number, **{way: 1})))
                    self.lie(ends(sheet, number, **{way: 0}), fixed=fixed)
        self.accepted(crossing(slid(), fixed=3, change=ends(1, 0, high=0)))
        self.accepted(crossing(slid(), fixed=2, change=ends(1, 1, low=0, high=0)))
        self.lie(lambda rectangles, _: rectangles[0].__setitem__(0, (20, rectangles[0][0][1], rectangles[0][0][1])))     # two points
        self.lie(lambda rectangles, _: rectangles[0].__setitem__(1, (20, rectangles[0][1][1], rectangles[0][1][1] + 1)))  # none
        for interval in ((63, 1, 2), (3, 5, 4), (3, 4, 9)):
            self.judged("B1", crossing(slid(), change=lambda rectangles, _, new=interval: rectangles[1].__setitem__(0, new)))

    def test_lies_about_rows(self):
        self.lie(lambda _, rows: rows.reverse())
        self.lie(lambda _, rows: rows.__setitem__(0, [-y for y in rows[0]]))
        self.lie(lambda _, rows: rows.__setitem__(1, rows[0]))
        self.lie(lambda _, rows: rows.__setitem__(2, [0, 0, 0]))

    def test_pieces_of_one_face(self):
        data, f = umbrella(), (0, 3)
        first = [[Q(c) for c in p] for p in ((Q(1, 8), Q(-1, 8), 0), (Q(1, 4), Q(1, 8), 0), (Q(3, 8), Q(-1, 8), 0))]
        second = [[x - Q(1, 2), y, z] for x, y, z in first]
        for fixed in range(4):
            self.accepted(crossing(data, f, f, (.75, 1 / 3, .75, 1 / 3), fixed, first=first, second=second))
            self.accepted(crossing(data, f, f, (.875, 3 / 7, .625, .2), fixed))    # one piece, disjoint parameters
            self.accepted(crossing(data, f, f, (.875, 3 / 7, .625, .2), fixed, width=1 / 32))
        # A side of one piece parts them; the lines of the other one's sides cut the first one, or have both on one side.
        point = [[Q(x, 8), Q(y, 8), Q(0)] for x, y in ((1, 0), (3, 1), (3, -1))]
        wall = [[Q(x, 8), Q(y, 8), Q(0)] for x, y in ((-1, 2), (-1, -2), (-3, 0))]
        self.accepted(crossing(data, f, f, (.5, .5, .75, 2 / 3), 0, first=point, second=wall))
        self.accepted(crossing(data, f, f, (.75, 2 / 3, .5, .5), first=wall, second=point, planes=([[Q(1), Q(2), Q(3), Q(4)]], [])))
        # The crossing is there, but the pieces have common points, and are not the same.
        whole = corners_of(data, f)
        self.judged("W12", crossing(data, f, f, (.75, 1 / 3, .625, .2), first=first))
        self.judged("W12", crossing(data, f, f, (.875, 3 / 7, .5, .75), second=[whole[i] for i in (1, 2, 0)]))

    def test_one_piece_and_common_parameters(self):
        data, f = umbrella(), (0, 3)
        proof = crossing(data, f, f, (.875, 3 / 7, .625, .2), 1)
        self.accepted(proof)
        def overlap(rectangles, _):
            rectangles[0][0], rectangles[1][0] = (3, 4, 7), (3, 7, 8)
            rectangles[1][1] = (2, 0, 2)
        self.judged("W12", crossing(data, f, f, (.875, 3 / 7, .625, .2), 1, change=overlap))

    def test_faces_that_knots_cut(self):
        for reach in (False, True):
            data, f, g, sheets = two_blocks(reach)
            places, parts = [], []
            for named, sheet in zip((f, g), sheets):
                corners = corners_of(data, named)
                parts.append(corners)
                places += [.6, .45]
            proof = crossing(data, f, g, places, first=parts[0], second=parts[1], sheets=[affine(s, p) for s, p in zip(sheets, parts)])
            self.judged("W12" if reach else "ACCEPT", proof)


def affine(sheet, points):
    """s is known on the points; as a function of (s, t)."""
    images = [[float(c) for c in sheet(p)] for p in points]
    return lambda s, t: [(1 - s) * a + s * (1 - t) * b + s * t * c for a, b, c in zip(*images)]


def two_blocks(reach):
    """(data, face, face, two functions): two cubes of degree 2 with clouds on their borders, if they reach outward. The image of the
    second one is turned and moved into the first."""
    points, tetrahedra = files.grid_domain((1, 1, 1))
    clouds = files.clouds_of(points, 2, (1, 1, 1), Q(1, 8), 3, reach)
    if reach:                                              # two knots of the face x = 1 lie in its plane
        for cloud in clouds:
            cloud[1:] = [[cloud[0][0] if cloud[0][0] == 1 else c[0], *c[1:]] for c in cloud[1:]]
    far = [[[c[0] + 5, *c[1:]] for c in cloud] for cloud in clouds]
    def second(p):
        x, y, z = p[0] - 5, p[1], p[2]
        return [x + Q(1, 2) + y / 8, y + Q(1, 3) - x / 9, z + Q(1, 16)]
    data = files.model(2, clouds + far, tetrahedra + [[v + len(clouds) for v in t] for t in tetrahedra], lambda p: p if p[0] < 3 else second(p))
    file = json.loads(data)
    faces = made.boundary(file)
    def on(x, y, first):
        return next(f for f in faces if (f[0] < 6) == first and all(c[0] == x or c[1] == y for c in corners_of(data, f)))
    return data, on(1, None, True), on(None, 0, False), (same, second)


# ---------------------------------------------------------------- coverings

HAIR = Q(1, 2**40)
V, U = [Q(1, 5), Q(1, 4), Q(1, 6)], [Q(13, 4), Q(1, 8), Q(1, 3)]


def around(v, size=Q(1, 32)):
    """A small tetrahedron with this mean."""
    return [[a + size * (c - Q(1, 4)) for a, c in zip(v, p)] for p in CORNERS]


def curved(p):
    return [p[0] + p[1] / 3 - p[0] * p[2], p[1] + p[0] * p[0] / 2, p[2] - p[0] * p[1] / 4]


def image(data, v):
    """s at a point of the first tetrahedron, whose vertices are the corners and whose clouds are collapsed."""
    file = json.loads(data)
    values = {tuple(c["at"]): [Q(x) for x in c["value"]] for c in file["control"]}
    return made.bezier(lambda beta: values[tuple(m for m, b in enumerate(beta) for _ in range(b))], [1 - sum(v), *v])(file["degree"])


def small_part(x):
    """A map of the second of two tetrahedra that takes U to x."""
    return lambda p: [a + (b - c) / 50 for a, b, c in zip(x, p, U)]


def nested(degree=2, warp=curved, v=V):
    """Two tetrahedra far from each other; the image of the second is inside of that of the first, and U and v have one image."""
    second = small_part(image(one(degree, warp), v))
    return pair(moved((3, 0, 0)), degree, lambda p: warp(p) if p[0] < 2 else second(p))


def covering(data=None, points=None, u=U, tetrahedron=0, planes=()):
    return made.point_covered(data or nested(), tetrahedron, points or around(V), u, planes)


def aimed(x, change=lambda file: None):
    """The first tetrahedron is the leaf and its map, of degree 2, the identity, before the change; U has the image x."""
    second = small_part(x)
    return covering(changed(pair(moved((3, 0, 0)), 2, lambda p: p if p[0] < 2 else second(p)), change), CORNERS)


class Coverings(Case):
    def rejected(self, **values):
        self.judged("W13", covering(**values))

    def test_a_body_inside_of_another_one(self):
        for degree in (1, 2, 3):
            self.accepted(covering(nested(degree)))
            self.accepted(covering(nested(degree, lambda p: mirrored(curved(p)))))     # e < 0
            self.accepted(covering(files.separate(nested(degree))))
        self.accepted(covering(planes=[[Q(1), Q(0), Q(0), Q(1, 5)], [Q(0), Q(3), Q(-1), Q(5)]]))
        self.accepted(covering(nested(warp=same), CORNERS))
        for u in ([Q(3), Q(0), Q(0)], [Q(10, 3)] + [Q(1, 3)] * 2):                     # a vertex, a point of a face
            self.accepted(covering(points=around(V, Q(1, 8)), u=u, data=nested(degree=1, warp=same)))

    def test_cubes(self):
        points, tetrahedra = files.grid_domain((1, 1, 1))
        both = [*points, *([c + 5 * (i == 0) for i, c in enumerate(p)] for p in points)]
        data = files.model(2, [[p] for p in both], tetrahedra + [[v + 8 for v in t] for t in tetrahedra],
                           lambda p: p if p[0] < 3 else [Q(1, 4) + (p[0] - 5) / 4 + p[1] / 9, Q(1, 3) + p[1] / 5, Q(2, 5) + p[2] / 7])
        u = [Q(21, 4), Q(1, 3), Q(1, 2)]
        v = [Q(1, 4) + Q(1, 16) + Q(1, 27), Q(1, 3) + Q(1, 15), Q(2, 5) + Q(1, 14)]
        of = [i for i, t in enumerate(tetrahedra) if min(made.d(*(v if k == m else points[w] for k, w in enumerate(t))) for m in range(4)) > 0]
        for tetrahedron in range(12):
            self.judged("ACCEPT" if [tetrahedron] == of else "W13", covering(data, around(v, Q(1, 100)), u, tetrahedron))

    def test_two_places_of_one_body(self):
        # x (1 - x): 1/4 and 3/4 have one image, and near 3/4 the map turns space over.
        def fold(file):
            for c in file["control"]:
                x = [Q(file["vertices"][v][0][0]) for v in c["at"]]
                c["value"][0] = str(sum(x) / 2 - x[0] * x[1])
        data = changed(one(2), fold)
        near, far = [Q(1, 4), Q(1, 16), Q(1, 16)], [Q(3, 4), Q(1, 16), Q(1, 16)]
        for v, u in ((near, far), (far, near)):
            self.accepted(covering(data, around(v), u))
            self.rejected(data=data, points=around(v), u=v)
        self.rejected(data=data, points=CORNERS, u=near)

    def test_lies_about_the_point(self):
        corners = around(V)
        self.rejected(u=V)
        self.rejected(u=[a + HAIR for a in V])
        for inside in (3, 2, 1):                           # on a face, an edge, a corner
            self.rejected(u=made.mean(corners[:inside], [1] * inside))
        self.rejected(u=made.mean(corners, (1, 1, 1, -HAIR)))                          # beyond a face, and so is its image
        self.rejected(points=around(V, Q(1, 1000)), u=[U[0], U[1] + Q(1, 4), U[2]])    # another image
        self.rejected(data=aimed(V).data, points=CORNERS, u=V)
        for u in ([Q(-1), Q(0), Q(0)], [Q(3) - HAIR, Q(1, 8), Q(1, 8)], [Q(50)] * 3):
            self.rejected(u=u)

    def test_lies_about_the_leaf(self):
        points, data = around(V), nested(warp=same)
        self.accepted(covering(data, points))
        self.rejected(data=data, points=[points[i] for i in (0, 1, 3, 2)])
        self.rejected(data=data, points=[*points[:3], made.mean(points[:3], (1, 1, 1))])
        self.rejected(data=data, points=[points[0]] * 4)
        self.rejected(data=data, points=[[-HAIR, Q(0), Q(0)], *CORNERS[1:]])
        self.rejected(data=data, points=around(V, Q(3)))
        self.rejected(data=data, points=points, tetrahedron=1)
        self.rejected(data=data, points=around([V[0] + Q(1, 16), *V[1:]]))

    def test_a_leaf_among_knots(self):
        first, tetrahedra = files.grid_domain((2, 2, 2))
        clouds = files.clouds_of(first, 2, (2, 2, 2), Q(1, 4), 1)
        corners = [first[v] for v in tetrahedra[0]]
        far = len(first)
        def judged(expected, points):
            x = made.mean(points, [1] * 4)
            data = files.model(2, clouds + [[[c[0] + 9, *c[1:]]] for c in CORNERS], [*tetrahedra, [far + v for v in TET]],
                               lambda p: p if p[0] < 5 else [a + (b - c) / 50 for a, b, c in zip(x, p, (9, 0, 0))])
            self.judged(expected, covering(data, points, [Q(9), Q(0), Q(0)]))
        judged("W13", corners)                             # knots cut it
        judged("ACCEPT", [made.mean([corners[0], p], (63, 1)) for p in corners])

    def test_images_that_are_not_covered(self):
        for m in range(4):
            face = [1] * 4
            for share, expected in ((HAIR, "ACCEPT"), (0, "W13"), (-HAIR, "W13"), (-5, "W13")):
                face[m] = share
                self.judged(expected, aimed(made.mean(CORNERS, face)))

    def test_a_coefficient_that_passes_the_image(self):
        x = [Q(1, 4)] * 3
        for m in range(4):
            for j, k in itertools.combinations([i for i in range(4) if i != m], 2):
                for share, expected in ((Q(1, 4) - HAIR, "ACCEPT"), (Q(1, 4), "W13"), (Q(1, 4) + HAIR, "W13")):
                    place = made.mean([CORNERS[m], CORNERS[j], CORNERS[k]], (share, (1 - share) / 2, (1 - share) / 2))
                    def change(file, at=[j, k], place=place):
                        next(c for c in file["control"] if c["at"] == at)["value"][:] = map(str, place)
                    self.judged(expected, aimed(x, change))

    def test_flat_images(self):
        for degree, warp in ((1, flat), (2, flat), (2, curved_and_flat)):
            self.rejected(data=nested(degree, warp), points=around(V))

    def test_numbers_of_the_body(self):
        plane, long = [Q(1), Q(0), Q(0), Q(1, 5)], Q(1, 3**700)
        proof = covering(planes=[plane])
        self.accepted(proof)
        self.judged("B2", covering(u=[U[0] + long, *U[1:]]))
        self.judged("B2", covering(points=[[V[0] + long, *V[1:]], *around(V)[1:]]))
        self.judged("B2", covering(planes=[[*plane[:3], long]]))
        self.judged("B2", made.point_covered(nested(), 0, around(V), U, planes={1: [[*plane[:3], long]]}))
        self.judged("B2", covering(pair(moved((3, 0, 0)), 7)))
        self.judged("B2", covering(changed(nested(), lambda f: f["control"][0]["value"].__setitem__(1, str(3**170)))))
        self.judged("B1", covering(tetrahedron=2))
        self.judged("B1", covering(planes=[[Q(0), Q(0), Q(0), Q(1)]]))
        body, listed = proof.body(), made.planes_of([plane])
        self.judged("B1", proof, body.replace(listed, b"\xff\xff\x7f" + listed[1:]))  # planes that are not there
        self.judged("B1", proof, body[:8] + b"\x0e" + body[9:])                        # a kind above the last one
        self.judged("B1", proof, body[:-12] + b"\7\0\0\0" + body[-7:])                # one face fewer


class Bodies(Case):
    def test_every_truncation(self):
        for proof in every_kind():
            body = proof.body()
            for end in range(len(body)):
                self.judged("B1", proof, body[:end])
            self.judged("B1", proof, body + b"\0")

    def test_every_byte_changed(self):
        draw = random.Random(1)
        for proof in every_kind():
            body = proof.body()
            for at in range(len(body)):
                mask = draw.choice((1, 2, 0x80, 0xff))
                changed_body = body[:at] + bytes([body[at] ^ mask]) + body[at + 1:]
                for name, checker in CHECKERS.items():
                    code, _, text = checker(proof.data, proof.certificate(changed_body))
                    self.assertIn(code, (0, 1), f"{name}, kind {proof.kind}, byte {at}, mask {mask}: {text}")

    def test_large_counts(self):
        proof = made.negative_jacobian(one(1, mirrored), [Q(1, 5)] * 3)
        body = proof.body()
        self.judged("B1", proof, body[:-8] + b"\xff\xff\xff\xff" + body[-4:])
        self.judged("B1", proof, body[:-1] + b"\xff\xff\xff\xff\x0f")
        self.judged("B1", proof, body[:-8] + b"\3\0\0\0" + body[-3:])                         # one face fewer
        self.judged("B1", proof, body[:-1] + b"\1" + made.rationals([Q(0), Q(0), Q(0), Q(1)]))  # a plane without a normal

    def test_refused_models(self):
        proof = made.tet_reversed(one(), 0)
        proof.data = proof.data.replace(b'"degree": 1', b'"degree": 2')
        for name, checker in CHECKERS.items():
            self.assertEqual(checker(proof.data, proof.certificate())[0], 4, name)


if __name__ == "__main__":
    unittest.main()
