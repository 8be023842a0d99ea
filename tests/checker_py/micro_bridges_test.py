#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The Python checker of microstructure-1: bridges, materials, and tiles that star boxes prove. Each lie names the condition that rejects it, and
is accepted without that condition, so that it breaks nothing else."""
import itertools
import json
import math
import pathlib
import random
import sys
import unittest
from fractions import Fraction as Q

import vmodel_models as models

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests" / "support"), str(ROOT / "verify" / "checker")]
import micro_bridge_examples as bridged                   # noqa: E402
import micro_examples as examples                         # noqa: E402
from veritope_checker import program                      # noqa: E402
from veritope_checker.micro import micro_bridges, micro_read_bridges, micro_slices    # noqa: E402


def row(n=4, held=(0,), tile=None, cage="cube", walls=None, **more):
    """n cells in a row along the first axis, of which these hold a jack."""
    breaks = [[Q(i, n) for i in range(n + 1)], [Q(0), Q(1)], [Q(0), Q(1)]]
    return bridged.Micro(models.honest(cage), [(0, breaks)], [tile or examples.jack(grows=Q(0))], [[0 if c in held else None for c in range(n)]],
                         walls, **more)


def with_bridges(plan, *bridges):
    return plan.changed(bridges=list(bridges)).settled()


class Judged(unittest.TestCase):
    def says(self, expected, text, certificate, skip=()):
        code, line = program._check(text, certificate, frozenset(skip))
        self.assertEqual(line.split(":")[0].replace("REJECT ", "").replace("ACCEPT microstructure-1", "ACCEPT"), expected, line)
        self.assertEqual(code, {"ACCEPT": 0, "ERROR": 4}.get(expected, 1), line)

    def judged(self, expected, plan, skip=(), **values):
        plan = plan if plan.values else plan.settled()
        self.says(expected, plan.text(), plan.certificate(**values), skip)

    def dies_by(self, condition, plan):
        self.judged(condition, plan)
        self.judged("ACCEPT", plan, (condition,))


class BridgesTest(Judged):
    def bar(self, **more):
        """A jack in the first of four cells, and a bridge through the next ones."""
        plan = row()
        return with_bridges(plan, bridged.straight(plan, 0, 0, 1, Q(7, 8), **more))

    # ------------------------------------------------------------ honest

    def test_a_straight_bridge(self):
        self.judged("ACCEPT", self.bar())
        self.judged("ACCEPT", self.bar(cuts=[Q(1, 3), Q(1, 2)]))
        for wall in range(6):
            plan = row(1).changed(grids=[(0, [[Q(1, 4), Q(3, 4)]] * 3)], cells=[[0]])
            end = Q(7, 8) if wall % 2 else Q(1, 8)
            self.judged("ACCEPT", with_bridges(plan, bridged.straight(plan, 0, 0, wall, end)))

    def test_six_bridges_of_graded_jacks(self):
        number = examples.UNIT // 3
        plan = row(1, tile=examples.jack(), walls=[[[number, 2 * number]] * 3]).changed(grids=[(0, [[Q(1, 4), Q(3, 4)]] * 3)], cells=[[0]])
        honest = with_bridges(plan, *[bridged.straight(plan, 0, 0, wall, Q(7, 8) if wall % 2 else Q(1, 8)) for wall in range(6)])
        self.judged("ACCEPT", honest)
        first, *others = honest.bridges
        self.dies_by("R2", honest.changed(bridges=[first.moved(0, lambda p: (p[0], *[Q(1, 2) + (c - Q(1, 2)) * Q(99, 100) for c in p[1:]])), *others]))

    def test_bridges_into_glued_volumes(self):
        for name in ("two", "two, one of them mirrored and turned", "two with breaks"):
            plan = row(2, cage=name).changed(grids=[(0, [[Q(0), Q(1)]] * 3)], cells=[[0]])
            knots = plan.cage.maps[1].knots
            (face, (other, symmetry)), = [(f, code) for f, code in enumerate(plan.cage.codes) if isinstance(code, tuple)]
            self.assertEqual((face // 6, other // 6), (0, 1))
            honest = with_bridges(plan, bridged.straight(plan, 0, 0, face, *across(face, other, symmetry, knots)))
            self.judged("ACCEPT", honest)
            self.dies_by("R2", honest.changed(bridges=[honest.bridges[0].moved(0, lambda p: [c + Q(1, 100) if 0 < c < 1 else c for c in p])]))
            self.judged("R2", honest.changed(bridges=[honest.bridges[0].changed(volume=0)]))
            back = row(2, cage=name).changed(grids=[(1, [[t[0], t[-1]] for t in knots])], cells=[[0]])
            if name != "two with breaks":
                flip = bridged.straight(back, 0, 0, other % 6, *across(other, face, symmetry, plan.cage.maps[0].knots, True))
                self.judged("ACCEPT", with_bridges(back, flip))

    def test_every_symmetry_of_glued_faces(self):
        rng, seen = random.Random(4), set()
        while len(seen) < 8:
            axes, reverse = rng.sample(range(3), 3), [rng.randrange(2) for _ in range(3)]
            maps = [models.cube(), models.permuted(models.box((1, 0, 0), (2, 1, 1)), axes, reverse)]
            cage = models.forge.proved(maps, flags=[0, models.is_mirror(axes, reverse)])
            (face, (other, symmetry)), = [(f, code) for f, code in enumerate(cage.codes) if isinstance(code, tuple)]
            if symmetry in seen:
                continue
            seen.add(symmetry)
            for volume, to, ends in ((0, other, (face, other)), (1, face, (other, face))):
                tile, own = examples.jack(grows=Q(0)), ends[0] % 6                          # this cap is like none of its images
                for name, (wall, point, more) in tile.vertices.items():
                    if wall == own:
                        far = [(a, c) for a, c in enumerate(point) if a != own // 2]
                        point = tuple(c + (far[0][1] > Q(1, 2)) * (Q(1, 16) if a == far[0][0] else Q(1, 32) if a == far[1][0] else 0)
                                      for a, c in enumerate(point))
                        tile.vertices[name] = wall, point, more
                tile.patches = [tile.patch(n) for n in range(len(tile.quads))]
                tile.exit = 4 + 5 * ((own + 1) % 6)
                plan = bridged.Micro(cage, [(volume, [[Q(0), Q(1)]] * 3)], [tile], [[0]])
                bridge = bridged.straight(plan, 0, 0, ends[0] % 6, *across(*ends, symmetry, cage.maps[to // 6].knots, volume == 1))
                self.judged("ACCEPT", with_bridges(plan, bridge))

    def test_a_bridge_of_a_higher_degree_that_bends(self):
        plan = self.bar()
        bridge = plan.bridges[0]
        points = {(i, j, k): tuple(a + Q(i, 2) * (b - a) for a, b in zip(bridge.points[0, j, k], bridge.points[1, j, k]))
                  for i in range(3) for j in range(2) for k in range(3)}
        bent = bridged.Bridge(0, 0, 1, 0, (2, 1), points).moved(2, lambda p: (p[0], p[1] + Q(1, 50), p[2] + p[1] / 30))
        self.judged("ACCEPT", plan.changed(bridges=[bent]))
        self.judged("ACCEPT", plan.changed(bridges=[bent.changed(points={(i, 1 - j, k): p for (i, j, k), p in bent.points.items()},
                                                                 matrix=[[-c if r == 1 else c for c in line] for r, line in enumerate(bent.matrix)])]),
                    ("R1",))

    # ------------------------------------------------------------ lies

    def test_r1(self):
        plan = self.bar()
        bridge = plan.bridges[0]
        folded = bridge.moved(1, lambda p: (Q(15, 16), *p[1:]))
        self.dies_by("R1", plan.changed(bridges=[folded]))
        mirrored = bridge.changed(points={(1 - i, j, k): p for (i, j, k), p in bridge.points.items()})
        self.dies_by("R1", plan.changed(bridges=[mirrored]))                                # K J is not definite
        mirrored.matrix = bridged.inverse(bridged.jacobian(mirrored.points, mirrored.degrees))
        self.dies_by("R1", plan.changed(bridges=[mirrored]))                                # det K < 0
        self.dies_by("R1", plan.changed(bridges=[bridge.changed(matrix=[[Q(0)] * 3] * 3)]))
        for c in range(3):                                                                  # each minor alone
            spoilt = [list(line) for line in bridge.matrix]
            spoilt[c] = [-x for x in spoilt[c]]
            spoilt[(c + 1) % 3] = [-x for x in spoilt[(c + 1) % 3]]
            self.dies_by("R1", plan.changed(bridges=[bridge.changed(matrix=spoilt)]))
        flat = bridge.moved(1, lambda p: p).moved(2, lambda p: p)
        flat.points.update({(i, j, 1): flat.points[i, j, 0] for i in (0, 1) for j in (0, 1)})
        self.judged("R1", plan.changed(bridges=[flat]))

    def test_r2(self):
        plan = self.bar()
        bridge = plan.bridges[0]
        self.dies_by("R2", plan.changed(bridges=[bridge.moved(0, lambda p: (p[0], p[1] + Q(1, 1 << 30), p[2]))]))
        self.judged("R2", plan.changed(bridges=[bridge.changed(wall=3)]))                   # lies in a face of the cage's border
        many = row(tile=examples.lattice_tile(5, [examples.pattern("block", 5)] * 6, scale=(Q(9, 10), Q(0))))
        self.dies_by("R2", with_bridges(many, bridged.straight(many, 0, 0, 1, Q(7, 8))))    # a cap of many patches
        none = row(tile=examples.lattice_tile(3, [examples.pattern("block" if w != 1 else "none", 3) for w in range(6)], scale=(Q(9, 10), Q(0))))
        self.dies_by("R2", with_bridges(none, bridge))                                      # no cap
        two = row(held=(0, 1))
        self.judged("R2", with_bridges(two, bridge))                                        # a cap that is glued

    def test_r3(self):
        plan = self.bar()
        bridge = plan.bridges[0]
        self.dies_by("R3", plan.changed(bridges=[bridge.moved(2, lambda p: (Q(1), *p[1:]))]))
        self.dies_by("R3", plan.changed(bridges=[bridge.moved(2, lambda p: (Q(9, 8), *p[1:]))]))
        for steps in ((Q(1, 5), Q(2, 5)), (Q(3, 16), Q(3, 8)), (Q(3, 8), Q(3, 4))):          # through, onto and with list 1 onto the side
            leaning = bridge
            for k, step in zip((1, 2), steps):
                leaning = leaning.moved(k, lambda p, step=step: (p[0], p[1] + step, p[2]))
            leaning.matrix = bridged.inverse(bridged.jacobian(leaning.points, leaning.degrees))
            self.dies_by("R3", plan.changed(bridges=[leaning]))
        ahead = row(held=(0, 3))                                                            # touches the cell with the other jack
        self.dies_by("R3", with_bridges(ahead, bridge.moved(2, lambda p: (Q(3, 4), *p[1:])).moved(1, lambda p: (Q(1, 2), *p[1:]))))
        self.judged("ACCEPT", with_bridges(ahead, bridge.moved(2, lambda p: (Q(3, 4) - Q(1, 1 << 40), *p[1:])).moved(1, lambda p: (Q(1, 2), *p[1:]))))
        sliced = self.bar(cuts=[Q(1, 1 << 30)])
        self.judged("ACCEPT", sliced)
        beside = row(held=(0, 2))                                                           # passes the cell of another jack
        self.dies_by("R3", with_bridges(beside, bridge))

    def test_a_bridge_that_goes_back_to_its_own_wall(self):
        plan = self.bar()
        for x in (Q(1, 4), Q(1, 8)):
            lie = plan.changed(bridges=[plan.bridges[0].moved(1, lambda p, x=x: (x, *p[1:]))])
            self.judged("R3", lie, ("R1",))
            self.judged("ACCEPT", lie, ("R1", "R3"))

    def test_a_bridge_around_a_ring_to_its_own_cell(self):
        ring = models.honest("a ring")
        x, y, z = [sorted(set(t)) for t in ring.maps[0].knots]
        (face, (other, symmetry)), = [(f, code) for f, code in enumerate(ring.codes) if isinstance(code, tuple)]
        self.assertEqual((face, other), (0, 1))
        plan = bridged.Micro(ring, [(0, [x[:2], [y[0], y[-1]], [z[0], z[-1]]])], [examples.jack(grows=Q(0))], [[0]])
        _, (volume, axis, place) = across(face, other, symmetry, ring.maps[0].knots)
        for end, cuts, expected in ((x[1] + Q(1, 100), (), "ACCEPT"), (x[1], (), "R3"), (x[1], (Q(1, 2),), "R3")):
            lie = with_bridges(plan, bridged.straight(plan, 0, 0, face, end, (volume, axis, place), cuts))
            self.judged(expected, lie)
            self.judged("ACCEPT", lie, ("R3",))

    def test_r4(self):
        plan = row(3, held=(0, 2))
        first, second = [bridged.straight(plan, 0, c, w, Q(end)) for c, w, end in ((0, 1, Q(1, 2)), (2, 0, Q(1, 2)))]
        self.dies_by("R4", with_bridges(plan, first, second))
        thirds = [bridged.straight(plan, 0, c, w, Q(4, 9)) for c, w in ((0, 1), (2, 0))]    # they touch at a number that binary64 rounds
        self.dies_by("R4", with_bridges(plan, *thirds))
        near = Q(1, 2) + Q(1, 1 << 70)
        self.judged("ACCEPT", with_bridges(plan, first, bridged.straight(plan, 0, 2, 0, near).changed(matrix=second.matrix)))
        self.judged("ACCEPT", with_bridges(plan, first))

    def test_the_order_of_conditions(self):
        plan = row(3, held=(0, 2))
        first, second = [bridged.straight(plan, 0, c, w, Q(1, 2)) for c, w in ((0, 1), (2, 0))]
        folded = second.moved(1, lambda p: (Q(2, 5), *p[1:]))
        self.judged("R1", with_bridges(plan, first, folded))
        self.judged("R2", with_bridges(plan, first.moved(0, lambda p: (p[0], p[1] + Q(1, 1000), p[2])), folded))
        self.judged("W3", with_bridges(plan, first), bridges=0)

    # ------------------------------------------------------------ bodies and files

    def test_bodies(self):
        plan = self.bar(cuts=[Q(1, 3), Q(2, 3)])
        bridge = plan.bridges[0]
        for cuts in ([Q(2, 3), Q(1, 3)], [Q(1, 3), Q(1, 3)], [Q(0)], [Q(1)], [Q(5, 4)], [Q(-1, 4)]):
            self.judged("B1", plan.changed(bridges=[bridge.changed(cuts=cuts)]))
        long = Q(1, (1 << 64) + 1)
        self.dies_by("B2", plan.changed(bridges=[bridge.changed(cuts=[long])]))
        self.dies_by("B2", plan.changed(bridges=[bridge.changed(matrix=[[c + long for c in line] for line in bridge.matrix])]))
        short = plan.changed()
        short.bridges = []
        text, lie = plan.text(), plan.changed()
        lie.made, lie.bridges = text, []
        self.judged("B1", lie)
        lie = plan.changed()
        lie.tail = b"\0"
        self.judged("B1", lie)

    def test_bridges_of_long_numbers(self):
        plan = self.bar()
        bridge = plan.bridges[0]

        def long(power):  # prime denominators, so that they have no common one that is short
            primes = iter([p for p in range(10 ** 6, 10 ** 6 + 500) if all(p % d for d in range(2, 1001))])
            return bridge.changed(points={at: tuple(c + Q(1, next(primes) ** power) if at[2] == 2 else c for c in p) for at, p in bridge.points.items()})
        self.judged("ACCEPT", plan.changed(bridges=[long(33)]))
        self.judged("B2", plan.changed(bridges=[long(35)]))
        self.judged("ERROR", plan.changed(bridges=[bridge.moved(2, lambda p: (p[0] + Q(1, 3 ** 1460), *p[1:]))]))

    def test_forbidden_files_are_refused(self):
        plan = self.bar()
        made = json.loads(plan.text())

        def changed(**fields):
            return [{**made["bridges"][0], **fields}]
        good = made["bridges"][0]
        for n, bridges in enumerate((
                {}, None, [None], changed(more=1), changed(grid=1), changed(grid=-1), changed(cell=4), changed(cell=1), changed(wall=6), changed(wall=True),
                changed(volume=1), changed(volume="0"), changed(degrees=[1]), changed(degrees=[0, 1]), changed(degrees=[8, 1]), changed(degrees=[1, 2]),
                changed(points=[]), changed(points=good["points"][:-1]), changed(points=[["0"] * 2] * 12), changed(points=[[0] * 3] * 12),
                [good, good], [{**good, "wall": 3}, good], [{key: good[key] for key in good if key != "volume"}])):
            with self.subTest(n):
                lie = plan.changed(made=json.dumps({**made, "bridges": bridges}).encode())
                self.judged("ERROR", lie)
        order = [key for key in made if key != "bridges"]
        lie = plan.changed(made=json.dumps({key: made[key] for key in order[:-1] + ["bridges", order[-1]]}).encode())
        self.judged("ERROR", lie)
        self.judged("ACCEPT", plan.changed(made=json.dumps(made).encode()))
        self.judged("ACCEPT", row().changed(no_bridges=True))

    def test_materials(self):
        plan, most = row(2), (1 << 52) - 1
        values = [0, -1, most, -most] + [7] * 8
        honest = json.dumps([{"name": "ink", "values": [values]}, {"values": [values], "name": "ink"}])
        self.judged("ACCEPT", plan.changed(materials=honest))
        self.judged("ACCEPT", plan.changed(materials="[]"))
        for n, lie in enumerate((
                "{}", "[{}]", "null", "[null]", json.dumps([{"name": 1, "values": [values]}]), json.dumps([{"name": "ink", "values": []}]),
                json.dumps([{"name": "ink", "values": [values[1:]]}]), json.dumps([{"name": "ink", "values": [values, values]}]),
                json.dumps([{"name": "ink", "values": [values], "more": 1}]), json.dumps([{"name": "ink", "values": values}]),
                json.dumps([{"name": "ink", "values": [[most + 1] + values[1:]]}]), json.dumps([{"name": "ink", "values": [[-most - 1] + values[1:]]}]),
                json.dumps([{"name": "ink", "values": [[True] + values[1:]]}]), json.dumps([{"name": "ink", "values": [["1"] + values[1:]]}]),
                honest.replace("[0, -1", "[-0, -1"), honest.replace("[0, -1", "[0.0, -1"), honest.replace("[0, -1", "[00, -1"),
                honest.replace("[0, -1", "[+1, -1"), honest.replace("[0, -1", "[1e3, -1"), honest.replace("\"ink\"", "\"\\ud800\""),
                json.dumps([{"name": "ink", "values": [values]}] * 17))):
            with self.subTest(n):
                self.judged("ERROR", plan.changed(materials=lie))
        lie = plan.changed(materials=honest)
        text = lie.text().replace(b",\n\"materials\"", b",\n\"bridges\": [],\n\"materials\"")
        self.judged("ACCEPT", plan.changed(made=text))
        made = json.loads(text)
        swapped = {key: made[key] for key in (*list(made)[:-2], "materials", "bridges")}
        self.judged("ERROR", plan.changed(made=json.dumps(swapped).encode()))

    def test_a_number_of_a_wall_has_no_sign(self):
        plan = examples.Micro(models.honest("cube"), [(0, [[Q(0), Q(1)]] * 3)], [examples.jack()], [[0]], [[[0, 0]] * 3]).settled()
        self.judged("ACCEPT", plan)
        plan.made = plan.text().replace(b"[0,0]", b"[-0,0]", 1)
        self.judged("ERROR", plan)


class BoxesTest(Judged):
    def plan(self, proof, tile, n=1):
        return row(n, held=range(n), tile=tile, proofs=[proof])

    def test_tiles_that_are_not_star_shaped(self):
        for voxels, numbers in ((bridged.U_SHAPE, (1, 1, 0)), (bridged.RING, (1, 1, 1))):
            tile, proof = bridged.voxels_proved(5, tuple(voxels))
            plan = self.plan(proof, tile).settled()
            self.assertEqual([plan.values[key] for key in ("components", "shells", "genus")], list(numbers))
            self.judged("ACCEPT", plan)
        tile, proof = bridged.voxels_proved(5, tuple(bridged.U_SHAPE))
        two = self.plan(proof, tile, 2)
        self.judged("ACCEPT", two)
        self.judged("F1", two.changed(proofs=[None]))

    def test_a_jack_by_star_boxes_with_a_bridge(self):
        tile = examples.jack(grows=Q(0))
        plan = row(tile=tile, proofs=[bridged.boxes_of(tile)])
        self.judged("ACCEPT", with_bridges(plan, bridged.straight(plan, 0, 0, 1, Q(7, 8))))

    def test_f3(self):
        tile, proof = bridged.voxels_proved(5, tuple(bridged.U_SHAPE))
        entities = bridged.surfaces_of(tile)
        self.dies_by("F3", self.plan(bridged.Boxes(bridged.SplitProver(entities, search=True).prove().plan), tile))
        apart = bridged.voxel_tile(7, [(1, 1, 1), (5, 5, 5)])
        self.judged("F3", self.plan(bridged.boxes_of(apart), apart))
        self.judged("ACCEPT", self.plan(bridged.boxes_of(apart), apart), ("F3", "W3"))
        inside_out = bridged.voxel_tile(5, bridged.U_SHAPE)
        inside_out.quads = [quad[::-1] for quad in inside_out.quads]
        inside_out.patches = [inside_out.patch(n) for n in range(len(inside_out.quads))]
        self.dies_by("F3", self.plan(bridged.boxes_of(inside_out, [1] * len(inside_out.quads)), inside_out))

    def test_a_family_has_no_star_boxes(self):
        still, moving = examples.jack(grows=Q(0)), examples.jack(grows=Q(1, 8))
        plan = row(1, tile=moving, walls=[[[0, 0]] * 3], proofs=[bridged.boxes_of(still)])
        self.dies_by("F3", plan)

    def test_conditions_of_star_boxes(self):
        tile, proof = bridged.voxels_proved(5, tuple(bridged.U_SHAPE))
        other, _ = bridged.voxels_proved(5, tuple(bridged.RING))
        self.judged("B1", self.plan(bridged.Boxes(proof.plan.body() + b"\0"), tile))
        self.judged("B1", self.plan(bridged.Boxes(proof.plan.body()[:-1]), tile))
        self.judged("B1", self.plan(proof, other))
        broken = bridged.voxel_tile(5, bridged.U_SHAPE)
        corner = next(name for name in broken.quads[0])
        wall, point, more = broken.vertices[corner]
        broken.vertices[corner] = wall, (point[0], point[1] - Q(1, 10), point[2]), more
        broken.patches[0] = broken.patch(0)
        self.judged("S0", self.plan(proof, broken).changed(values=dict.fromkeys(examples.KEYS, 0)))


class LawsTest(unittest.TestCase):
    """R1 and the boxes of slices, against slow computations of the tests' own."""

    def test_positive_definite_matrices(self):
        rng, found = random.Random(1), [0, 0]
        for _ in range(2000):
            m = [[rng.randrange(-3, 4) + (6 if i == j else 0) * (rng.random() < .8) for j in range(3)] for i in range(3)]
            symmetric, pivots = [[Q(m[i][j] + m[j][i]) for j in range(3)] for i in range(3)], []
            for c in range(3):                                                              # Gauss's scheme: all pivots are positive
                pivots.append(symmetric[c][c])
                for r in range(c + 1, 3) if pivots[-1] > 0 else ():
                    f = symmetric[r][c] / symmetric[c][c]
                    symmetric[r] = [x - f * y for x, y in zip(symmetric[r], symmetric[c])]
            truth = all(p > 0 for p in pivots)
            self.assertEqual(micro_bridges.is_positive(m), truth, m)
            found[truth] += 1
        self.assertGreater(min(found), 300)
        self.assertFalse(micro_bridges.is_positive([[1, 0, 0], [0, 1, 0], [0, 0, 0]]))
        self.assertFalse(micro_bridges.is_positive([[0] * 3] * 3))

    def some_bridge(self, rng):
        p, q = rng.choice(((1, 1), (2, 1), (1, 3), (3, 2)))
        points = {at: tuple(Q(rng.randrange(-20, 21), rng.choice((1, 3, 7))) for _ in range(3))
                  for at in itertools.product(range(p + 1), range(q + 1), range(3))}
        return bridged.Bridge(0, 0, 0, 0, (p, q), points)

    def test_derivatives(self):
        rng = random.Random(2)
        for _ in range(40):
            bridge = self.some_bridge(rng)
            degrees, order = (*bridge.degrees, 2), list(bridge.order())
            read = micro_read_bridges.Bridge(0, 0, 0, 0, bridge.degrees, [list(bridge.points[at]) for at in order])
            nets = [dict(zip(order, column)) for column in zip(*micro_bridges.derivatives(read))]
            at = [Q(rng.randrange(9), 8) for _ in range(3)]
            ratios = set()
            for axis, net in enumerate(nets):
                step = tuple(int(a == axis) for a in range(3))
                lower = {i: [degrees[axis] * (y - x) for x, y in zip(p, bridge.points[tuple(map(sum, zip(i, step)))])]
                         for i, p in bridge.points.items() if i[axis] < degrees[axis]}
                for x, y in zip(value(net, degrees, at), value(lower, [d - s for d, s in zip(degrees, step)], at)):
                    self.assertEqual(bool(x), bool(y))
                    ratios |= {x / y} if y else set()
            self.assertLessEqual(len(ratios), 1)
            self.assertTrue(all(r > 0 for r in ratios))

    def test_boxes_of_slices(self):
        """A box is that of the coefficients on the slice, by de Casteljau's scheme at both ends."""
        rng = random.Random(3)
        for _ in range(40):
            bridge = self.some_bridge(rng)
            read = micro_read_bridges.Bridge(0, 0, 0, 0, bridge.degrees, [list(bridge.points[at]) for at in bridge.order()])
            cuts = sorted({Q(rng.randrange(1, 12), 12) for _ in range(rng.randrange(4))})
            boxes = micro_slices.boxes_of_slices(read, cuts)
            self.assertEqual(len(boxes), len(cuts) + 1)
            for box, s, t in zip(boxes, [Q(0), *cuts], [*cuts, Q(1)]):
                found = []
                for i, j, _ in [at for at in bridge.points if at[2] == 0]:
                    line = [bridge.points[i, j, k] for k in range(3)]
                    for u, v in ((s, s), (s, t), (t, t)):
                        first = [[(1 - u) * a + u * b for a, b in zip(x, y)] for x, y in zip(line, line[1:])]
                        found.append([(1 - v) * a + v * b for a, b in zip(*first)])
                self.assertEqual(box, [(min(c), max(c)) for c in zip(*found)])


def value(net, degrees, at):
    """The sum of coefficients times Bernstein polynomials."""
    total = [Q(0)] * 3
    for index, point in net.items():
        factor = math.prod(math.comb(n, i) * t ** i * (1 - t) ** (n - i) for n, i, t in zip(degrees, index, at))
        total = [x + factor * y for x, y in zip(total, point)]
    return total


def across(face, other, symmetry, knots, back=False):
    """(end of a bridge in the next volume, how points get there); the domain of the first volume is the unit cube or that of `knots`."""
    axis, theirs = face % 6 // 2, other % 6 // 2
    lo, hi = knots[theirs][0], knots[theirs][-1]
    at = knots[theirs][-(other % 2)]

    def place(point):
        x, y = (point[a] for a in bridged.OTHERS[axis])
        if back:
            x, y = (1 - x if symmetry & 2 else x), (1 - y if symmetry & 4 else y)
            x, y = (y, x) if symmetry & 1 else (x, y)
        else:
            x, y = (y, x) if symmetry & 1 else (x, y)
            x, y = (1 - x if symmetry & 2 else x), (1 - y if symmetry & 4 else y)
        found = [knots[a][0] + (knots[a][-1] - knots[a][0]) * t for a, t in zip(bridged.OTHERS[theirs], (x, y))]
        found.insert(theirs, at)
        return tuple(found)
    return at + (Q(3, 4) if at == lo else Q(-3, 4)) * (hi - lo), (other // 6, theirs, place)


if __name__ == "__main__":
    unittest.main()
