#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The Python checker of micro-inside-1 about spline models. More lies are in tests/mutation/micro_spline_liars.py."""
import copy
import itertools
import pathlib
import random
import sys
import unittest
from fractions import Fraction as Q

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / part) for part in ("tests/support", "tests/mutation", "verify/checker")]
import micro_inside_examples as insides                   # noqa: E402
import micro_inside_test as inside_test                   # noqa: E402
import micro_spline_liars as liars                        # noqa: E402
import star_box_forge as forge                            # noqa: E402
import star_box_models as solids                          # noqa: E402
from veritope_checker.micro import inside_patches, inside_shells, inside_space    # noqa: E402
from veritope_checker.common.errors import Reject         # noqa: E402
from veritope_checker.patches.star_box_patches import patches_of    # noqa: E402
from veritope_checker.patches.star_box_read import read_model    # noqa: E402
from veritope_checker.points.patch_points_check import Grid, Model    # noqa: E402

small, block, HALF = inside_test.small, inside_test.block, liars.HALF
KINDS = {"ball": lambda: insides.ball(HALF, Q(2)), "octants": lambda: solids.octant_sphere(2), "triangles": solids.cubic_octahedron,
         "torus": lambda: solids.torus(), "corners": lambda: liars.joined((Q(1), HALF, False, 2))}


def fail(condition, why):
    raise Reject(condition, why)


def model_of(entities):
    read = read_model(forge.encode_model(entities))
    breaks = [[sorted(set(t)) for t in e.knots] if e.kind == "surface" else None for e in read]
    return read, breaks


class SplineTest(inside_test.Judged):
    def test_models_of_every_kind(self):
        for kind in ("ball", "octants", "corners"):
            plan = insides.proved(KINDS[kind])
            self.says("ACCEPT", insides.InsideSpline(block(2) if kind != "corners" else small(), plan))
            self.says("I2", insides.InsideSpline(small(cage="cube").changed(cage=liars.vmodel_models.forge.proved(
                [liars.vmodel_models.box((7, 7, 7), (8, 8, 8))])), plan))
        # The triangles bulge to less than 6/5: a jack in [1/4, 3/4]^3 around the origin
        cage = liars.vmodel_models.forge.proved([liars.vmodel_models.box((-Q(1, 2),) * 3, (Q(1, 2),) * 3)])
        self.says("ACCEPT", insides.InsideSpline(small().changed(cage=cage), insides.proved(KINDS["triangles"])))

    def test_a_model_close_to_the_caps(self):
        for gap in (Q(1, 8), Q(1, 1 << 10), Q(1, 1 << 30)):
            self.says("ACCEPT", insides.InsideSpline(block(2), liars.proved((Q(1, 2) + gap, HALF, False))))
        self.dies_by("I1", insides.InsideSpline(block(2), liars.proved((Q(1, 2), HALF, False))))

    def test_the_skin(self):
        """A bridge that ends 1/8 before the face of a cube, whose ends are 1/4 wide."""
        plan = inside_test.with_bridges(small(), Q(1, 8))
        model = liars.proved((Q(1, 2), HALF, False))
        for skin, expected in (("1/5", "ACCEPT"), ("1260/10000", "ACCEPT"), ("1/8", "I4"), ("1240/10000", "I4"), ("0", "I4"), ("-", "I4")):
            self.says(expected, insides.InsideSpline(plan, model, skin=skin))
        self.says("I4", insides.InsideSpline(small(), model, skin="1"))

    def test_flags(self):
        size, middle = Q(1, 32), (Q(1, 8),) * 3
        turned = liars.proved((Q(1), HALF, False), (size, middle, False), flags=(0, 1))
        self.dies_by("I0", insides.InsideSpline(small(), turned, voids=[(0, middle, 8)]))
        self.says("I0", insides.InsideSpline(small(), liars.proved((Q(1), HALF, True), flags=(1,))))

    def test_voids(self):
        size, middle = Q(1, 32), (Q(1, 8),) * 3
        other = tuple(1 - c for c in middle)
        honest = insides.InsideSpline(small(), liars.hollow((size, middle), (size, other)), voids=[(0, middle, 8), (0, other, 8)])
        self.says("ACCEPT", honest)
        for voids in ([], honest.voids[:1], honest.voids[::-1], [(0, (Q(5, 32), *middle[1:]), 8), honest.voids[1]]):
            self.dies_by("I3", honest.changed(voids=voids))
        nested = liars.proved((Q(1), HALF, False), (size, middle, True), (size / 2, middle, False))
        between = tuple(c + size * Q(3, 4) for c in middle)
        self.says("ACCEPT", insides.InsideSpline(small(), nested, voids=[(0, between, 8)]))
        self.dies_by("I3", insides.InsideSpline(small(), nested, voids=[(0, middle, 8)]))

    def test_breaks_and_bodies_of_the_model(self):
        plan = liars.proved((Q(1), HALF, False))
        honest = insides.InsideSpline(small(), plan)
        for breaks in ([Q(0), Q(1, 2)], [Q(1, 4), Q(1)], [Q(0), Q(2)]):
            lie = copy.deepcopy(plan)
            lie.breaks[3][1] = breaks
            self.says("B1", insides.InsideSpline(small(), lie))
        lie = copy.copy(plan)
        lie.tail = b"\0"
        self.says("B1", insides.InsideSpline(small(), lie))
        self.says("S1", honest.changed(values={"model_format": "chain"}))
        self.says("ERROR", honest.changed(values={"model_format": "off"}))
        self.says("ERROR", honest.changed(values={"model_format": "vjson-faces"}))
        self.says("A1", honest.changed(values={"model_bytes": 1}))

    def test_added_breaks(self):
        split = insides.bridged.SplitProver(liars.joined((Q(1), HALF, False)), search=True).prove().plan
        self.says("ACCEPT", insides.InsideSpline(small(), split))


class BoundsTest(unittest.TestCase):
    """What is computed in binary64 contains what is computed exactly."""

    def test_nodes_contain_the_patches(self):
        rng = random.Random(11)
        for make in KINDS.values():
            model = Model(*model_of(make()), fail)
            for grid in rng.sample(model.grids, 4):
                node, ends = inside_patches.node_of(grid), [[Q(0), Q(1)], [Q(0), Q(1)]]
                for level in range(14):
                    for at in itertools.product(*ends):
                        exact = point_of(grid, at)
                        self.assertTrue(all(Q(node.box[2 * a]) <= exact[a] <= Q(node.box[2 * a + 1]) for a in range(3)))
                        if node.across():
                            normal, (lo, hi) = node.across()
                            product = sum(Q(n) * c for n, c in zip(normal, exact))
                            slack = Q(node.points.slack())
                            self.assertTrue(lo - slack <= product <= hi + slack)
                    self.assertEqual(node.level, level)
                    self.assertLess(node.points.error, 1e-12)
                    which, axis = rng.randrange(2), level % 2
                    ends[axis][1 - which] = sum(ends[axis]) / 2
                    node = node.halves()[which]

    def test_trees_contain_all_patches(self):
        for make in KINDS.values():
            model = Model(*model_of(make()), fail)
            todo, found = [inside_patches.tree_of(model.grids)], 0
            while todo:
                node = todo.pop()
                if node.level == 0:
                    found += 1
                    continue
                for kid in node.halves():
                    self.assertTrue(all(node.box[2 * a] <= kid.box[2 * a] and kid.box[2 * a + 1] <= node.box[2 * a + 1] for a in range(3)))
                    todo.append(kid)
            self.assertEqual(found, len(model.grids))

    def test_distances(self):
        rng = random.Random(12)
        for _ in range(200):
            ends = [sorted(rng.randrange(-16, 17) / 8 for _ in range(2)) for _ in range(3)]
            box = [c for pair in ends for c in pair]
            points = [tuple(rng.randrange(-16, 17) / 8 for _ in range(3)) for _ in range(rng.randint(1, 4))]
            least, most = inside_patches.distances(points, box)
            exact = [sum(max(lo - c, 0, c - hi) ** 2 for c, (lo, hi) in zip(p, ends)) for p in points]
            far = [max(sum((a - b) ** 2 for a, b in zip(p, corner)) for corner in itertools.product(*ends)) for p in points]
            self.assertLessEqual(Q(least) ** 2, Q(max(exact)))
            self.assertGreaterEqual(Q(most) ** 2, Q(max(far)))
            self.assertAlmostEqual(least ** 2, max(exact))
            self.assertAlmostEqual(most ** 2, max(far))

    def test_numbers_that_binary64_does_not_hold(self):
        for size in (Q(10) ** 120, Q(10) ** 400):
            entity = forge.surface([[tuple(size * c for c in p) for p in row] for row in (((0, 0, 0), (0, 1, 0)), ((1, 0, 0), (1, 1, 1)))])
            read, _ = model_of([entity])
            patch, = patches_of(read[0], [[Q(0), Q(1)]] * 2, 0, 0)
            node = inside_patches.node_of(Grid(patch))
            self.assertEqual(node.points.error, inside_patches.inf)
            self.assertEqual(node.halves()[0].points.error, inside_patches.inf)

    def test_winding_numbers(self):
        """Inside, outside and on the surface of a model and of its shells."""
        entities = insides.ball((0, 0, 0), Q(2)) + insides.ball((0, 0, 0), Q(1), is_reversed=True) + insides.ball((5, 0, 0), Q(1))
        found = inside_shells.PatchWinding(*model_of(entities), 1 << 20, fail)
        found.begin("I3", 9)
        self.assertEqual(found.depths, [0, 1, 0])
        for point, number, shells in (((0, 0, 0), 0, {0, 1}), ((Q(3, 2), 0, 0), 1, {0}), ((5, 0, 0), 1, {2}), ((9, 0, 0), 0, set())):
            self.assertEqual(found.around([Q(c) for c in point]), number)
            self.assertEqual(found.shells_around([Q(c) for c in point]), shells)
        corner = [Q(c, found.model.grids[0].rows[0][0][3]) for c in found.model.grids[0].rows[0][0][:3]]
        self.assertRaises((inside_shells.OnSurface, Reject), found.around, corner)
        found.begin("I2", 0)
        found.work.left = 10
        with self.assertRaises(Reject) as raised:
            found.around([Q(1, 3)] * 3)
        self.assertEqual(raised.exception.condition, "I2")

    def test_skins_are_searched_within_bounds(self):
        """From the middle of a ball all of its nodes are equally far: the search ends by its own bound."""
        model = Model(*model_of(insides.ball((0, 0, 0), Q(1))), fail)
        near = inside_patches.NearPatches(type("Parts", (), {"count": 0, "model": None})(), model.grids)
        middle = inside_space.Points([0.], [0.], [0.], 1e-15)
        self.assertFalse(near.is_within(middle, 0.9))
        self.assertTrue(near.is_within(middle, 1.2))
        self.assertLess(near.pairs, 1 << 18)


def point_of(grid, at):
    """De Casteljau's scheme, exactly."""
    values = [list(row) for row in grid.rows]
    for t in at:
        lines = [list(column) for column in zip(*values)]
        found = []
        for line in lines:
            while len(line) > 1:
                line = [tuple((1 - t) * a + t * b for a, b in zip(p, q)) for p, q in zip(line, line[1:])]
            found.append(line[0])
        values = [[p] for p in found]
    *point, w = values[0][0]
    return [c / w for c in point]


if __name__ == "__main__":
    unittest.main()
