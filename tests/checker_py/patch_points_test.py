#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Tests of docs/certificates/points.md, section 6: true answers about spline models are accepted along every direction, and each condition
rejects lies that break nothing else. What is true say the formulas of patch_points_forge.py."""
import itertools
import json
import pathlib
import random
import sys
import unittest
import unittest.mock
from fractions import Fraction as Q

import mesh_test                                          # says where the others are

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import every_claim                                        # noqa: E402
import patch_points_forge as forge                        # noqa: E402
import points_forge                                       # noqa: E402
import star_box_forge                                     # noqa: E402
import star_box_models as models                          # noqa: E402
from patch_points_forge import PatchLine, PatchPlan, Solid    # noqa: E402
from veritope_checker.points import patch_winding         # noqa: E402

vc, condition_of = mesh_test.vc, mesh_test.attacks.condition_of
HALF, THIRD = Q(1, 2), Q(1, 3)
TINY = Q(1, 2 ** 300)


def text(q):
    return ["%d/%d" % (Q(c).numerator, Q(c).denominator) for c in q]


def off(q, f, direction=0):
    return PatchLine(text(q), "-", str(f), "-", direction)


def on(q, patch, u, v):
    return PatchLine(text(q), "on", "-", "-", (patch, (Q(u), Q(v))))


def on_at(solid, patch, u, v):
    """The true line of a point of a patch."""
    return on(forge.point_at(solid.entities[patch], (Q(u), Q(v))), patch, u, v)


class PatchPointsTest(unittest.TestCase):
    def says(self, expected, plan, skip=None, model=None, **statement):
        model = plan.mesh.encode() if model is None else model
        files = model, plan.copy(values={**plan.values, **statement}).certificate(model), plan.answers()
        code, message = vc.check(*files) if skip is None else vc._check(*files[:2], frozenset(skip), files[2])
        self.assertEqual(condition_of(code, message) if code < 2 else code, expected, message)
        return message

    def accepts(self, solid, *lines):
        self.says("ACCEPT", PatchPlan(solid, lines, "exact", True))

    def rejects(self, condition, solid, *lines):
        plan = PatchPlan(solid, lines, "exact", True)
        self.says(condition, plan)
        self.says("ACCEPT", plan, (condition,))

    def everywhere(self, solid, q, f):
        """Along every direction the number is f, and no other one."""
        for direction in range(6):
            self.accepts(solid, off(q, f, direction))
            for other in (f - 1, f + 1):
                self.rejects("P4", solid, off(q, other, direction))


BALL, CUBE, TETRAHEDRON, TORUS = forge.ball(), forge.cube(), forge.tetrahedron(), forge.torus()
SHIFTED = CUBE.placed([1, 1, 1], [Q(1, 7), Q(1, 9), Q(1, 11)])


class Off(PatchPointsTest):
    def test_solids_cavities_overlaps_and_shells_that_are_turned(self):
        for part, inner, outer in ((BALL, (0, 0, 0), (1, 1, 1)), (CUBE, (Q(1, 9), 0, 0), (2, 0, 0)),
                                   (TETRAHEDRON, (Q(1, 9),) * 3, (HALF, HALF, HALF)), (TORUS, (2, Q(1, 9), 0), (0, 0, 0))):
            self.everywhere(Solid([part]), inner, 1)
            self.everywhere(Solid([part]), outer, 0)
            self.everywhere(Solid([part.reversed()]), inner, -1)
        self.everywhere(Solid([CUBE, SHIFTED]), (HALF, HALF, HALF), 2)
        self.everywhere(Solid([CUBE, SHIFTED.reversed()]), (HALF, HALF, HALF), 0)
        self.everywhere(Solid([CUBE, BALL.placed([HALF] * 3, [0] * 3).reversed()]), (Q(1, 4), 0, 0), 0)

    def test_rays_through_edges_vertices_poles_and_along_faces(self):
        self.everywhere(Solid([CUBE]), (0, 0, 0), 1)
        self.everywhere(Solid([CUBE]), (2, 1, 1), 0)
        self.everywhere(Solid([CUBE]), (2, 1, HALF), 0)
        self.everywhere(Solid([BALL]), (0, 0, 2), 0)
        self.everywhere(Solid([BALL]), (0, 0, -HALF), 1)
        self.everywhere(Solid([TORUS]), (3, 0, 1), 0)
        self.everywhere(Solid([TORUS]), (1, 0, 1), 0)
        self.everywhere(Solid([TETRAHEDRON]), (-1, 0, 0), 0)

    def test_points_that_are_nearly_on_the_surface(self):
        for solid, q, k in ((Solid([CUBE]), (THIRD, HALF, 1), 2), (Solid([CUBE]), (1, 1, 1), 0), (Solid([CUBE]), (1, HALF, 1), 0),
                            (Solid([BALL]), (Q(3, 5), Q(4, 5), 0), 0), (Solid([BALL]), (0, 0, 1), 2), (Solid([TORUS]), (3, 0, 0), 0),
                            (Solid([TETRAHEDRON]), (THIRD, THIRD, THIRD), 1), (Solid([TETRAHEDRON]), (0, 0, 1), 0)):
            for step in (TINY, -TINY * 3 / 7):
                near = list(map(Q, q))
                near[k] += step
                f = solid.truth(near)
                if f is None:                             # from an edge along a face
                    continue
                for direction in (0, 5):
                    self.accepts(solid, off(near, f, direction))
                self.says("P4", PatchPlan(solid, [off(near, 1 - f, 3)], "exact", True))

    def test_random_solids(self):
        for seed in range(40):
            rng = random.Random(seed)
            self.says("ACCEPT", forge.true_plan(forge.solid(rng), rng, 12))


class On(PatchPointsTest):
    def test_borders_corners_and_collapsed_sides(self):
        for part in (BALL, CUBE, TETRAHEDRON, TORUS, forge.cube(3), forge.cube(1, Q(5))):
            solid = Solid([part])
            for patch, entity in enumerate(solid.entities):
                for at in ((0, 0), (0, 1), (1, 0), (1, 1), (0, THIRD), (Q(2, 7), 0), (THIRD, Q(1, 4)), (1, Q(1, 5))):
                    if forge.is_in_domain(entity, at):
                        self.accepts(solid, on_at(solid, patch, *at))

    def test_other_parameters_patches_and_points(self):
        solid = Solid([BALL])
        line = on_at(solid, 3, THIRD, Q(1, 4))
        for patch, at in ((3, (Q(1, 4), THIRD)), (3, (THIRD, Q(1, 4) + TINY)), (4, (THIRD, Q(1, 4)))):
            self.rejects("P2", solid, line.changed(code=(patch, at)))
        self.rejects("P2", solid, line.changed(tokens=[*line.tokens[:2], line.tokens[2] + "0"]))

    def test_parameters_beyond_the_domain(self):
        cube, tetrahedron = Solid([CUBE]), Solid([TETRAHEDRON])
        for at in ((Q(5, 4), HALF), (HALF, Q(5, 4)), (-TINY, HALF), (HALF, -TINY), (1 + TINY, 0)):
            self.rejects("P2", cube, on_at(cube, 0, *at))
        for at in ((HALF, HALF + TINY), (-TINY, HALF), (HALF, -TINY), (2, -1), (-1, 1), (-HALF, HALF), (Q(3, 2), -HALF)):
            self.rejects("P2", tetrahedron, on_at(tetrahedron, 0, *at))

    def test_points_on_the_surface_are_not_off(self):
        """The checkers give up within seconds."""
        for solid, q in ((Solid([CUBE]), (1, THIRD, THIRD)), (Solid([TETRAHEDRON]), (0, 0, 0)), (Solid([BALL]), (0, 0, 1))):
            for f in (0, 1):
                self.rejects("B1", solid, off(q, f, 4))


def wavy_cube():
    """[-1, 1]^3, whose faces have the parameters g(u), g(v) with g(t) = (t + 3 t^2 - 2 t^3) / 2."""
    g = [2 * c - 1 for c in (Q(0), Q(1, 6), Q(5, 6), Q(1))]
    faces = [star_box_forge.surface([[at(u, v) for v in g] for u in g]) for at in models.cube_faces()]
    return Solid([forge.Part(faces, CUBE.level, CUBE.size)])


THIRD_OF_G = [Q(-2), Q(3), Q(9), Q(-6)]                   # its root in [0, 1] is where g is 1/3


def both_roots(c, d):
    """The point of the face x = 1 of the wavy cube with g(u) = c and g(v) = d as a Root: u and v are polynomials in u + 2 v, of degree 9."""
    def times(f, h):                                      # 3 x 3 coefficients of u^i v^j, modulo u^3 = 3/2 u^2 + u/2 - c, and v likewise
        out = [[Q(0)] * 5 for _ in range(5)]
        for (i, j), (k, m) in itertools.product(itertools.product(range(3), repeat=2), repeat=2):
            out[i + k][j + m] += f[i][j] * h[k][m]
        for e in (4, 3):
            for j in range(5):
                for low, factor in ((1, Q(3, 2)), (2, HALF), (3, -c)):
                    out[e - low][j] += factor * out[e][j]
        for row in out[:3]:
            for e in (4, 3):
                for low, factor in ((1, Q(3, 2)), (2, HALF), (3, -d)):
                    row[e - low] += factor * row[e]
        return [row[:3] for row in out[:3]]

    def unit(i, j):
        return [[Q((i, j) == (k, m)) for m in range(3)] for k in range(3)]

    u, v, theta = unit(1, 0), unit(0, 1), [[Q(0), Q(2), Q(0)], [Q(1), Q(0), Q(0)], [Q(0)] * 3]
    powers = [unit(0, 0)]
    for _ in range(9):
        powers.append(times(powers[-1], theta))
    columns = [sum(p, []) for p in powers[:9]]
    rows = [[*(col[r] for col in columns), *(sum(x, [])[r] for x in (powers[9], u, v))] for r in range(9)]
    for k in range(9):                                    # Gauss and Jordan
        pivot = next(r for r in range(k, 9) if rows[r][k])
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [x / rows[k][k] for x in rows[k]]
        rows = [row if r == k else [x - row[k] * y for x, y in zip(row, rows[k])] for r, row in enumerate(rows)]
    modulus = [-row[9] for row in rows] + [Q(1)]

    def root_of_g(value):
        low, high = Q(0), Q(1)
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if middle + 3 * middle ** 2 - 2 * middle ** 3 < 2 * value else (low, middle)
        return low
    at, width = root_of_g(c) + 2 * root_of_g(d), Q(1, 2 ** 40)
    return forge.Root(modulus, (at - width, at + width), [row[10] for row in rows], [row[11] for row in rows])


class Algebraic(PatchPointsTest):
    """On the face x = 1, whose parameters are y and z."""

    def at(self, y, z, **how):
        root = forge.Root(**{"modulus": THIRD_OF_G, "ends": (Q(0), Q(1)), "u": [Q(0), Q(1)], "v": [HALF], **how})
        return PatchLine(text((1, y, z)), "on", "-", "-", (0, root))

    def test_parameters_that_are_not_rational(self):
        cube = wavy_cube()
        self.accepts(cube, self.at(-THIRD, 0), self.at(-THIRD, -THIRD, v=[Q(0), Q(1)]), self.at(-THIRD, THIRD, v=[Q(1), Q(-1)]),
                     self.at(-THIRD, 1, v=[Q(1)]), self.at(-THIRD, -1, v=[Q(0), Q(0), Q(0)]), self.at(-THIRD, 0, ends=(Q(9, 25), Q(37, 100))),
                     self.at(-THIRD, 0, u=[Q(-2), Q(4), Q(9), Q(-6)], ends=(Q(9, 25), Q(37, 100))))

    def test_two_parameters_of_two_fields(self):
        root = both_roots(THIRD, Q(1, 5))
        self.assertEqual(len(root.modulus), 10)
        line = PatchLine(text((1, -THIRD, Q(-3, 5))), "on", "-", "-", (0, root))
        self.accepts(wavy_cube(), line)
        self.rejects("P2", wavy_cube(), line.changed(tokens=text((1, -THIRD, Q(-3, 5) + TINY))))
        self.rejects("P2", wavy_cube(), line.changed(code=(0, root.changed(u=root.v, v=root.u))))

    def test_lies(self):
        cube = wavy_cube()
        for line in (self.at(THIRD, 0), self.at(-THIRD, Q(1, 2 ** 99)), self.at(-THIRD, 0, modulus=[Q(-1), Q(3)]), self.at(-THIRD, 0, ends=(Q(9, 20), Q(1))),
                     self.at(-THIRD, 0, ends=(Q(-1), Q(1))), self.at(-THIRD, 0, ends=(Q(-1), Q(2))), self.at(-THIRD, 0, v=[HALF, Q(1, 2 ** 70)]),
                     self.at(-THIRD, 0, modulus=[c * d for c, d in zip(THIRD_OF_G, (1, 1, 1, 2))]), self.at(-THIRD, 3, v=[Q(2)])):
            self.rejects("P2", cube, line)
        for how in ({"modulus": [Q(1)]}, {"modulus": [*THIRD_OF_G, Q(0)]}, {"ends": (Q(1), Q(0))}, {"ends": (Q(1), Q(1))}, {"u": [Q(0)] * 66}):
            self.says("B1", PatchPlan(cube, [self.at(-THIRD, 0, **how)], "exact", True))

    def test_triangles(self):
        solid = Solid([TETRAHEDRON])
        q = forge.point_at(solid.entities[0], (THIRD, Q(1, 5)))
        fifth = [Q(1, 5)]
        for root, expected in ((forge.Root([Q(-1), Q(3)], (Q(0), HALF), [Q(0), Q(1)], fifth), "ACCEPT"),
                               (forge.Root([Q(-1), Q(3)], (Q(0), Q(1)), [Q(0), Q(1)], fifth), "P2"),                # beyond the domain at 1
                               (forge.Root([Q(1), Q(3)], (-HALF, Q(0)), [Q(0), Q(-1)], fifth), "ACCEPT"),
                               (forge.Root([Q(-1), Q(0), Q(9)], (Q(0), HALF), [Q(0), Q(0), Q(3)], fifth), "ACCEPT"),
                               (forge.Root([Q(-1), Q(0), Q(9)], (Q(0), HALF), [Q(0), Q(1)], fifth), "P2"),          # not at the other root
                               (forge.Root([Q(-1), Q(0), Q(8)], (Q(0), HALF), [Q(0), Q(1)], fifth), "P2")):
            self.says(expected, PatchPlan(solid, [PatchLine(text(q), "on", "-", "-", (0, root))], "exact", True))

    def test_much_work(self):
        """Numbers of two thousand bits and polynomials of degree 64."""
        long = Q(2 ** 2000 + 1, 3 ** 1200)
        self.rejects("B1", wavy_cube(), self.at(-THIRD, 0, modulus=[long] * 65, u=[long] * 65, v=[long] * 65))


class Bodies(PatchPointsTest):
    def setUp(self):
        self.solid = Solid([TETRAHEDRON, SHIFTED])
        self.plan = PatchPlan(self.solid, [off((3, 3, 3), 0, 5), on_at(self.solid, 0, HALF, Q(1, 4)), PatchLine(text((0, 0, 0)), "undecided", "-", "-", None)],
                              "exact", True)

    def test_bytes(self):
        self.says("ACCEPT", self.plan)
        body = self.plan.body()
        for plan in (self.plan.copy(extra=b"\0"), self.plan.copy(magic=b"VTPS"), self.plan.copy(breaks=b""), self.plan.with_line(0, code=6)):
            self.says("B1", plan)
        for size in range(len(body)):
            plan = self.plan.copy()
            plan.body = lambda size=size: body[:size]
            self.says("B1", plan)
        good = self.plan.lines[1].bytes()
        for code in (b"\x0a" + good[1:], good[:1] + b"\2" + good[2:], b"\x80\0" + good[1:], good[:2] + b"\4\4" + good[4:],
                     good[:2] + b"\2\0" + good[4:], good[:2] + b"\0\0\2\0\1\1\1" + good[4:]):
            self.says("B1", self.plan.with_line(1, code=code))

    def test_numbers_of_patches_entities_and_points(self):
        for step in ((1, 0), (-1, 0), (0, 1), (0, -1)):
            plan = self.plan.copy()
            plan.head = lambda step=step: [10 + s for s in step]
            self.says("B1", plan)
        for key in ("points", "on", "undecided"):
            self.says("A2", self.plan, **{key: self.plan.quantities()[key] + 1})

    def test_long_parameters(self):
        u = Q(3 ** 200, 2 ** 330)
        self.accepts(self.solid, on_at(self.solid, 1, u, Q(1, 7)), on_at(self.solid, 5, u, u))

    def test_finer_breaks(self):
        solid = Solid([CUBE])
        thirds = [Q(0), THIRD, Q(1)]
        axis = star_box_forge.u32(3) + b"".join(map(star_box_forge.rational, thirds))
        # The third face axis by axis: what its neighbours have differs along some common edges, unless all have the same breaks.
        plan = PatchPlan(solid, [off((0, 0, 0), 1)], "exact", True).copy(breaks=12 * axis)
        plan.head = lambda: [24, 6]
        self.says("P1", plan)                             # a side at 1/3 of one face is one at 2/3 of its neighbour
        halves = star_box_forge.u32(3) + b"".join(map(star_box_forge.rational, (0, HALF, 1)))
        q = forge.point_at(solid.entities[1], (Q(3, 4), Q(1, 8)))
        for patch, at, expected in ((6, (HALF, Q(1, 4)), "ACCEPT"), (4, (HALF, Q(1, 4)), "P2"), (1, (Q(3, 4), Q(1, 8)), "P2")):
            plan = PatchPlan(solid, [off((0, 0, 0), 1, 2), on(q, patch, *at)], "exact", True).copy(breaks=12 * halves)
            plan.head = lambda: [24, 6]
            self.says(expected, plan)

    def test_too_many_patches_for_the_bytes(self):
        """Two lists of breaks cut a surface into their product."""
        rows = [[(Q(i), Q(j), Q(0)) for j in range(2)] for i in range(2)]
        solid = Solid([])
        solid.entities = [star_box_forge.surface(rows)]
        n = 200
        axis = star_box_forge.u32(n + 1) + b"".join(star_box_forge.rational(Q(k, n)) for k in range(n + 1))
        plan = PatchPlan(solid, [], "exact", True).copy(breaks=2 * axis)
        plan.head = lambda: [n * n, 1]
        self.says("B1", plan)


class Models(PatchPointsTest):
    def test_complexes_that_are_not_closed(self):
        faces = CUBE.entities
        moved = json.loads(json.dumps(faces[0]))
        moved["shape"]["points"][0][0] = "1/2"
        lines = [off((5, 5, 5), 0)]
        for entities in (faces[1:], faces + faces[:1], [forge.reversed_entity(faces[0]), *faces[1:]], [moved, *faces[1:]]):
            solid = Solid([])
            solid.entities = entities
            self.says("P1", PatchPlan(solid, lines, "exact", True))
            self.says("P1", PatchPlan(solid, [], "exact", True))

    def test_entities_that_are_no_patches_in_space(self):
        curve = {"kind": "curve", "group": None, "attributes": [], "shape": {}}
        plane = star_box_forge.surface([[(0, 0), (0, 1)], [(1, 0), (1, 1)]])
        steep = star_box_forge.surface([[(i, 0, 0), (i, 1, 0)] for i in range(17)])
        for extra in (curve, plane, steep):
            solid = Solid([CUBE])
            solid.entities = [*solid.entities, extra]
            plan = PatchPlan(solid, [], "exact", True)
            plan.head = lambda extra=extra: [6 + (extra is not curve), 7]
            self.says("B2", plan)

    def test_weights_and_broken_models_are_refused(self):
        for weight in ("0", "-1"):
            solid = Solid([forge.cube(1, Q(3))])
            solid.entities[0]["shape"]["points"][0][3] = weight
            self.says(4, PatchPlan(solid, [off((5, 5, 5), 0)], "exact", True))
        self.says(4, PatchPlan(Solid([CUBE]), [], "exact", True), model=b"{")

    def test_every_format(self):
        for name, (make, of_volumes) in every_claim.FORMATS.items():
            model = make(of_volumes)[1].encode()
            solid = Solid([CUBE])                         # six surfaces on [0, 1]^2
            lines = [off((HALF, HALF, HALF), 1, 1), off((2, HALF, HALF), 0, 4), off((HALF, HALF, -TINY), 0, 3)]
            plan = PatchPlan(solid, lines, "exact", True)
            self.says("ACCEPT", plan, model=model, subject_format=name)
            self.says("P4", plan.with_line(1, f="1"), model=model, subject_format=name)

    def test_a_volume_without_its_faces(self):
        model = every_claim.as_vjson(True)[1].encode()
        plan = PatchPlan(Solid([]), [], "exact", True)
        plan.head = lambda: [0, 1]
        self.says("B2", plan, model=model)


class Bound(PatchPointsTest):
    """tests/checker runs it with both checkers at once: it takes long."""

    def test_the_bound_is_the_same_everywhere(self):
        """Points beside a sphere: so many are accepted, one more is not."""
        solid, line = Solid([BALL]), off((Q(3, 5), Q(4, 5) + Q(1, 2 ** 700), 0), 0, 0)
        spent = []
        with unittest.mock.patch.object(patch_winding.Work, "add", lambda work, units: spent.append(units)):
            self.accepts(solid, line)
        units = sum(spent)
        self.assertLess(units, patch_winding.UNITS_OF_POINT)
        size = len(solid.encode()) + len(PatchPlan(solid, [], "exact", True).body())
        most = (patch_winding.FREE_UNITS + 96 * size) // (units - 4096 - 96)
        self.accepts(solid, *most * [line])
        self.says("B1", PatchPlan(solid, (most + 1) * [line], "exact", True))


class Work(PatchPointsTest):
    def test_one_point_has_a_bound_of_its_own(self):
        self.rejects("B1", Solid([BALL]), off((Q(3, 5), Q(4, 5) + Q(1, 2 ** 3000), 0), 0, 0))

    def test_long_coordinates(self):
        self.accepts(Solid([BALL]), PatchLine(["1e-4096", "-0.%s1" % ("0" * 4000), "1/%d" % 3 ** 2000], "-", "1", "-", 2))
        self.accepts(Solid([BALL]), PatchLine(["1e4096", "0", "-1e4096"], "-", "0", "-", 2))


def load_tests(loader, _tests, _pattern):
    return unittest.TestSuite(loader.loadTestsFromTestCase(case) for case in (Off, On, Algebraic, Bodies, Models, Work))


if __name__ == "__main__":
    unittest.main()
