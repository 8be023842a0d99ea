#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The Python checker of microstructure-1 and micro-inside-1: sweeps. Each lie names the condition that rejects it, and is accepted without that
condition, so that it breaks nothing else. More lies are in tests/mutation/micro_sweep_liars.py."""
import itertools
import json
import pathlib
import random
import sys
import unittest
from fractions import Fraction as Q

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / part) for part in ("tests/support", "tests/mutation", "verify/checker")]
import mesh_models as meshes                              # noqa: E402
import micro_bridge_examples as bridged                   # noqa: E402
import micro_examples as examples                         # noqa: E402
import micro_inside_examples as insides                   # noqa: E402
import micro_inside_test as inside_test                   # noqa: E402
import micro_sweep_liars as liars                         # noqa: E402
from micro_bridges_test import Judged, row                # noqa: E402
from veritope_checker.micro import inside_parts, inside_points, micro_check, micro_read, micro_sweeps    # noqa: E402
from veritope_checker.micro.micro_body import SweepHint   # noqa: E402
from veritope_checker.common.errors import Reject         # noqa: E402
from veritope_checker.patches.star_box_read import Body   # noqa: E402

CURVED = ("bent", "rational", "mirrored", "cube with breaks")


def with_sweeps(plan, *sweeps):
    return plan.changed(sweeps=list(sweeps)).settled()


class SweepsTest(Judged):
    def bar(self, cage="cube", **more):
        plan = row(cage=cage)
        return with_sweeps(plan, bridged.swept(plan, 0, 0, 0, Q(1, 2), **more))

    # ------------------------------------------------------------ honest

    def test_every_wall_of_curved_cages(self):
        for cage in CURVED:
            plan = row(cage=cage) if cage != "cube with breaks" else row(cage=cage).changed(
                grids=[(0, [sorted(set(t)) for t in liars.models.honest(cage).maps[0].knots])])
            if cage == "cube with breaks":
                counts = plan.counts(0)
                plan = plan.changed(cells=[[0] + [None] * (counts[0] * counts[1] * counts[2] - 1)])
            sweeps = [bridged.swept(plan, 0, 0, w, Q(1, 4), depth=Q(1, 8)) for w in (0, 2, 3, 4, 5)]
            good = [sweep for sweep in sweeps if liars.keeps_q2(plan, sweep)]
            self.assertGreater(len(good), 2, cage)
            self.judged("ACCEPT", with_sweeps(plan, *good))

    def test_depths_and_slanted_curves(self):
        for depth in (Q(1), Q(1, 3), Q(1, 64)):
            self.judged("ACCEPT", self.bar(depth=depth))
        self.judged("ACCEPT", self.bar(bend=(0, Q(1, 8), Q(-1, 9))))

    def test_graded_jacks(self):
        number = examples.UNIT // 3
        plan = row(1, tile=examples.jack(), walls=[[[number, 2 * number]] * 3]).changed(grids=[(0, [[Q(1, 4), Q(3, 4)]] * 3)], cells=[[0]])
        self.judged("ACCEPT", with_sweeps(plan, *[bridged.swept(plan, 0, 0, wall, Q(1, 2)) for wall in range(6)]))

    # ------------------------------------------------------------ lies

    def test_q1(self):
        two = row(held=(0, 1))
        glued = with_sweeps(two, bridged.swept(two, 0, 0, 1, Q(1, 16)))
        self.judged("Q1", glued)
        self.judged("Q3", glued, ("Q1",))
        many = row(tile=examples.lattice_tile(5, [examples.pattern("block", 5)] * 6, scale=(Q(9, 10), Q(0))))
        self.dies_by("Q1", with_sweeps(many, bridged.swept(many, 0, 0, 0, Q(1, 4))))

    def test_q2(self):
        plan = self.bar()
        sweep = plan.sweeps[0]
        for lie in (sweep.changed(matrix=[[-c for c in line] for line in sweep.matrix]), sweep.changed(matrix=[[Q(0)] * 3] * 3),
                    sweep.changed(e=(0, 0, 0)), sweep.changed(f=(0, 0, 0)), sweep.changed(f=sweep.e), sweep.changed(e=sweep.f[1:] + sweep.f[:1])):
            self.assertFalse(liars.keeps_q2(plan, lie))
            self.dies_by("Q2", plan.changed(sweeps=[lie]))
        # 4 ahead > l beside^2 decides if K is the inverse; at the limit the determinant is 0
        leaning = sweep.changed(e=(-Q(1, 4), Q(1, 4), 0), f=(-Q(1, 2), Q(1, 2), 0), matrix=[[Q(i == j) for j in range(3)] for i in range(3)])
        for speed, expected in ((Q(16), "Q2"), (Q(16) - liars.HAIR, "ACCEPT"), (Q(16) + liars.HAIR, "Q2")):
            self.judged(expected, plan.changed(sweeps=[leaning.changed(speed=speed)]))
        short = sweep.changed(e=(Q(1, 64), 0, 0), f=(Q(1, 32), 0, 0))                        # into the own arm, within the slab
        self.dies_by("Q2", plan.changed(sweeps=[short]))

    def test_q3(self):
        plan = row(held=(0, 2))
        for length, expected in ((Q(1, 4), "Q3"), (Q(1, 4) + liars.HAIR, "Q3"), (Q(1, 4) - liars.HAIR, "ACCEPT"), (Q(3), "Q3")):
            lie = with_sweeps(plan, bridged.swept(plan, 0, 0, 1, length, depth=Q(1, 16)))
            self.judged(expected, lie)
            self.judged("ACCEPT", lie, ("Q3",))

    def test_q3_of_its_own_tile(self):
        for length, expected in ((Q(1), "ACCEPT"), (Q(5, 2), "ACCEPT"), (Q(3), "Q3"), (Q(4), "Q3")):
            lie = liars.hook().changed(sweeps=[liars.across_the_hook(length, Q(1, 4), Q(1, 32))])
            self.judged(expected, lie)
            self.judged("ACCEPT", lie, ("Q3",))
        self.judged("Q2", liars.hook().changed(sweeps=[liars.across_the_hook(Q(1), Q(1, 4), Q(1))]))

    def test_q4(self):
        plan = row(held=(0, 2))
        for second, expected in ((Q(1, 8), "Q4"), (Q(1, 7), "Q4"), (Q(1, 8) - liars.HAIR, "ACCEPT")):
            lie = with_sweeps(plan, bridged.swept(plan, 0, 0, 1, Q(1, 8)), bridged.swept(plan, 0, 2, 0, second))
            self.judged(expected, lie)
            self.judged("ACCEPT", lie, ("Q4",))

    def test_the_order_of_conditions(self):
        plan = row(held=(0, 2))
        first, second = bridged.swept(plan, 0, 0, 1, Q(1, 8)), bridged.swept(plan, 0, 2, 0, Q(1, 7))
        self.judged("Q2", with_sweeps(plan, first, second.changed(speed=Q(1), matrix=[[Q(0)] * 3] * 3)))
        self.judged("Q3", with_sweeps(plan, bridged.swept(plan, 0, 0, 1, Q(1, 4)), second.changed(matrix=[[Q(0)] * 3] * 3)))
        self.judged("W3", with_sweeps(plan, first), bridges=0)

    # ------------------------------------------------------------ bodies and files

    def test_bodies(self):
        plan = self.bar()
        sweep, long = plan.sweeps[0], Q(1, (1 << 64) + 1)
        for fields in ({"depth": Q(0)}, {"depth": 1 + long}, {"depth": Q(-1)}, {"speed": Q(0)}, {"speed": Q(-4)}):
            self.judged("B1", plan.changed(sweeps=[sweep.changed(**fields)]))
        for fields in ({"depth": Q(1, 2) + long}, {"speed": 4 + long}, {"matrix": [[c + long for c in line] for line in sweep.matrix]}):
            self.dies_by("B2", plan.changed(sweeps=[sweep.changed(**fields)]))
        text, lie = plan.text(), plan.changed(sweeps=[])
        lie.made = text
        self.judged("B1", lie)
        body = plan.body()
        self.judged("B1", plan.changed(body=lambda: body[:8] + b"\xff\xff\xff\xff" + body[12:]))

    def test_numbers_that_binary64_does_not_hold(self):
        plan = row(1)
        for size in (Q(10) ** 120, Q(10) ** 400):
            sweep = bridged.swept(plan, 0, 0, 0, Q(1, 2))
            huge = sweep.changed(e=tuple(c * size for c in sweep.e), f=tuple(c * size for c in sweep.f), depth=Q(1, 8))
            self.judged("Q3", with_sweeps(plan, huge))
            self.judged("ACCEPT", with_sweeps(plan, huge), ("Q3",))

    def test_forbidden_files_are_refused(self):
        plan = self.bar()
        made = json.loads(plan.text())
        good = made["sweeps"][0]
        bridge = json.loads(bridged.straight(plan, 0, 0, 1, Q(7, 8)).json())

        def changed(**fields):
            return {"sweeps": [{**good, **fields}]}
        axis = good["axis"]
        for fields in ({"sweeps": {}}, {"sweeps": None}, {"sweeps": [None]}, changed(more=1), changed(grid=1), changed(cell=4), changed(cell=1),
                       changed(wall=6), changed(wall="0"), changed(axis=axis[:1]), changed(axis=[*axis, axis[0]]), changed(axis=[axis[0][:2], axis[1]]),
                       changed(axis=[[0, 0, 0], axis[1]]), changed(axis=[["1/0", "0", "0"], axis[1]]), {"sweeps": [good, good]},
                       changed(axis=[["1/%d" % (1 << 2304), "0", "0"], axis[1]]), {"bridges": [bridge]}):
            lie = {**made, **fields}
            order = ("format", "model", "cage", "grids", "tiles", "cells", "walls", "bridges", "sweeps", "materials")
            text = json.dumps({key: lie[key] for key in order if key in lie}).encode()
            with self.assertRaises(Exception, msg=fields) as raised:
                micro_read.Microstructure(text)
            self.assertEqual(type(raised.exception).__name__, "Refused", fields)
        two = [good, {**good, "wall": 2}]
        for sweeps, is_good in ((two, True), (two[::-1], False)):
            text = json.dumps({**made, "sweeps": sweeps}).encode()
            if is_good:
                self.assertEqual(len(micro_read.Microstructure(text).sweeps), 2)
            else:
                self.assertRaises(Exception, micro_read.Microstructure, text)
        micro_read.Microstructure(json.dumps({**{k: made[k] for k in made if k != "sweeps"}, "bridges": [bridge], "sweeps": []}).encode())


class InsideTest(inside_test.Judged):
    """Sweeps in meshes."""

    def with_sweeps(self, walls=range(6), **more):
        plan = inside_test.small()
        found = [bridged.swept(plan, 0, 0, w, Q(1, 8), **{k: v for k, v in more.items() if k != "speed"}) for w in walls]
        return with_sweeps(plan, *[sweep.changed(speed=more.get("speed", sweep.speed)) for sweep in found])

    def test_sweeps_to_the_skin(self):
        plan, mesh = self.with_sweeps(), inside_test.move(inside_test.CUBE, (0.0625,) * 3, 0.875)
        for skin, expected in (("1/8", "ACCEPT"), ("626/10000", "ACCEPT"), ("624/10000", "I4"), ("0", "I4"), ("-", "I4")):
            self.says(expected, insides.Inside(plan, mesh, skin=skin))
        self.says("I4", insides.Inside(self.with_sweeps([1, 2], bend=(Q(0), Q(1, 32), Q(0))), mesh, skin="1/16"))

    def test_i1_of_sweeps(self):
        plan = self.with_sweeps()
        for gap, expected in ((0.125, "I1"), (0.125 - 2.0 ** -30, "ACCEPT"), (0.1875, "I1")):
            self.says(expected, insides.Inside(plan, inside_test.move(inside_test.CUBE, (gap,) * 3, 1 - 2 * gap)))

    def test_voids_beside_sweeps(self):
        plan = self.with_sweeps([5], bend=(Q(1, 8), Q(0), Q(0)), speed=Q(4))
        for x, expected in ((Q(1, 2) + Q(5, 32), "I3"), (Q(1, 2) + Q(13, 32), "ACCEPT")):
            middle = (x, Q(1, 2), Q(25, 32))
            void = meshes.move(meshes.CUBE, tuple(float(c - Q(1, 256)) for c in middle), 1 / 128)
            self.says(expected, insides.Inside(plan, meshes.join(inside_test.AROUND, meshes.turned(void)), voids=[(0, middle, 8)]))


class LawsTest(unittest.TestCase):
    """What the checker computes, against slow computations of the tests' own."""

    def cages(self):
        for name in CURVED:
            plan = liars.models.honest(name)
            knots = [sorted(set(t)) for t in plan.maps[0].knots]
            counts = [len(t) - 1 for t in knots]
            yield bridged.Micro(plan, [(0, knots)], [examples.jack(grows=Q(0))], [[0] * (counts[0] * counts[1] * counts[2])])

    def test_q2(self):
        rng, found = random.Random(4), [0, 0]
        for plan in self.cages():
            model = micro_read.Microstructure(plan.text())
            for _ in range(30):
                cell, wall = rng.randrange(len(plan.cells[0])), rng.randrange(6)
                sweep = bridged.swept(plan, 0, cell, wall, Q(1, 4), [Q(rng.randint(-9, 9), 40) for _ in range(3)], Q(rng.randint(1, 8), 8))
                sweep.speed *= Q(rng.choice((1, 1, 2, 9)), rng.choice((1, 2, 8)))
                read = micro_read.Microstructure(plan.changed(sweeps=[sweep]).text()).sweeps[0]
                holds = True
                try:
                    micro_sweeps.test_q2(model, read, SweepHint(Body(sweep.hint())), micro_sweeps.Work(1))
                except Reject:
                    holds = False
                self.assertEqual(holds, liars.keeps_q2(plan, sweep), (plan.cage, cell, wall))
                found[holds] += 1
        self.assertGreater(min(found), 20, found)

    def test_boxes_contain_sweeps(self):
        rng = random.Random(5)
        for plan in self.cages():
            cell = rng.randrange(len(plan.cells[0]))
            sweeps = [bridged.swept(plan, 0, cell, w, Q(1, 4), [Q(rng.randint(-9, 9), 40) for _ in range(3)]) for w in range(6)]
            model = micro_read.Microstructure(plan.changed(sweeps=sweeps).text())
            checker = micro_check.Checker({"subject_bytes": 1 << 20, "claim": "microstructure-1"}, plan.changed(sweeps=sweeps).body(), model,
                                          ("Q1", "Q2", "Q3", "Q4"))
            checker.test()
            parts, (lo, hi) = inside_parts.Parts(model, checker.tiles), (Q(3, 8), Q(5, 8))
            for sweep in model.sweeps:
                exact, node = inside_points.box_around(model, checker.tiles, sweep), parts.of_sweep(sweep)
                ends, w = [[lo, hi], [lo, hi]], [Q(0), Q(1)]
                for level in range(10):
                    for u, v, t in itertools.product((0, 1), repeat=3):
                        at = [ends[0][u], ends[1][v]]
                        at.insert(sweep.wall // 2, Q(sweep.wall % 2))
                        s = w[t]
                        point = [a + 2 * s * (1 - s) * e + s * s * f for a, e, f in zip(plan.in_space(0, cell, at), *sweep.axis)]
                        self.assertTrue(all(a <= c <= b for c, (a, b) in zip(point, exact)), (sweep.wall, at))
                        # The patch's own parameters are not known here, so only halves of w are compared.
                        if level < 1:
                            self.assertTrue(all(node.box[2 * a] <= c <= node.box[2 * a + 1] for a, c in enumerate(point)))
                    halves = node.halves()
                    self.assertEqual([kid.level for kid in halves], [node.level + 1] * 2)
                    if node.level % 3 == 2:
                        which = rng.randrange(2)
                        w[1 - which] = sum(w) / 2
                        node = halves[which]
                        self.assertEqual([node.lo, node.hi], w)
                    else:
                        node = halves[0]
                self.assertTrue(all(a - Q(1, 10 ** 9) <= c for c, (a, _) in zip(node.box[::2], exact)))
                self.assertTrue(all(c <= b + Q(1, 10 ** 9) for c, (_, b) in zip(node.box[1::2], exact)))

    def test_too_much_work(self):
        work = micro_sweeps.Work(0)
        self.assertRaises(Reject, work.spend, 1 << 20, 1 << 16)


if __name__ == "__main__":
    unittest.main()
