#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker of micro-inside-1: microstructures in boxes with holes, about which the truth is known by hand, and for each condition a file
or certificate that fails by it alone. VERITOPE_CHECK names the checker, VERITOPE the program that certifies cages and meshes."""
import itertools
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction as Q

import judges

sys.path.insert(0, str(judges.ROOT / "tests" / "support"))
import micro_files as mf                                   # noqa: E402
from micro_files import HALF, Grid, Mesh, Micro, Void      # noqa: E402
from micro_cpp_test import jack_numbers, straight    # noqa: E402

VERITOPE = os.environ["VERITOPE"]
INNER = (1, 1, 0, 1, 1, 0)


def one_of(n, cells, tile=None, **others):
    """A grid of n^3 cells in [0, 1]^3 of which these hold the tile."""
    return Micro([Grid([[Q(i, n) for i in range(n + 1)]] * 3, dict.fromkeys(cells, 0), **others)], [tile or mf.jack()])


def middle(tile=None, **others):
    """The middle one of 27 cells."""
    return one_of(3, [(1, 1, 1)], tile, **others)


def numbers_of(micro, *numbers):
    return (sum(len(list(itertools.product(*map(range, g.size())))) for g in micro.grids), *numbers)


class Judged(unittest.TestCase):
    def judge(self, given, *expected):
        text, certificate, solid = given
        code, condition, printed = judges.in_cpp(text, certificate, solid=solid)
        self.assertEqual((code, condition), expected, printed)

    def accept(self, micro, solid, numbers=INNER[1:], *, options=(), **more):
        self.judge(mf.certified_inside(micro, solid, numbers_of(micro, *numbers), VERITOPE, *options, **more), 0, "ACCEPT")

    def reject(self, micro, solid, condition, *, options=(), **more):
        self.judge(mf.certified_inside(micro, solid, (0,) * 6, VERITOPE, *options, **more), 1, condition)


def cube(half, centre=HALF):
    return Mesh().box((centre - half,) * 3, (centre + half,) * 3)


class Inside(Judged):
    def test_a_tile_in_a_box(self):
        for half in (Q(1, 5), Q(1, 2), 3, Q(1, 6) + Q(1, 1 << 30)):
            self.accept(middle(), cube(half))
        for half in (Q(1, 6), Q(1, 6) - Q(1, 1 << 30), Q(1, 8), Q(3, 24)):
            self.reject(middle(), cube(half), "I1")

    def test_outside(self):
        self.reject(middle(), Mesh().box((2, 2, 2), (3, 3, 3)), "I2")
        self.reject(middle(), Mesh().box((0, 0, 0), (Q(1, 4), 1, 1)), "I2")
        self.reject(middle(), Mesh().box((Q(1, 3), 0, 0), (Q(3, 4), 1, 1)), "I1")
        far = Mesh().box((2, 2, 2), (3, 3, 3)).box((0, 0, 0), (1, 1, 1))
        self.accept(middle(), far)
        in_core = cube(Q(1, 32))                           # it lies in the tile's core: their surfaces do not meet
        self.reject(middle(), in_core, "I2")

    def test_each_shell_counts(self):
        two = one_of(5, [(1, 1, 1), (3, 1, 1)])
        both, left, right = ((Q(1, 10), Q(9, 10)), (Q(1, 10), HALF), (HALF, Q(9, 10)))
        for (lo, hi), verdict in ((both, True), (left, False), (right, False)):
            solid = Mesh().box((lo, Q(1, 10), Q(1, 10)), (hi, HALF, HALF))
            if verdict:
                self.accept(two, solid, (2, 0, 2, 2, 0))
            else:
                self.reject(two, solid, "I2")

    def test_blocks(self):
        cells = list(itertools.product((1, 2), repeat=3))
        self.accept(one_of(4, cells), cube(Q(3, 10)), jack_numbers(2, 2, 2)[1:])
        self.reject(one_of(4, cells), cube(Q(1, 4)), "I1")
        self.accept(Micro([Grid.block((2, 2, 2))], [mf.jack()]), cube(1), jack_numbers(2, 2, 2)[1:])

    def test_random_boxes(self):
        """A box is convex: it holds a tile if and only if it holds its corners."""
        seed = int(os.environ.get("VT_SEED", "20261127"))
        rng = random.Random(seed)
        for turn in range(60):
            tile = mf.jack(half=Q(rng.randint(1, 5), 32), core=Q(rng.randint(3, 6), 32), walls=rng.sample(range(6), rng.randint(1, 6)), slope=Q(1, 64))
            number, number_of = rng.randrange(1 << 20), {}
            micro = middle(tile, numbers=lambda axis, *i, n=number: n)
            bent = [[rng.uniform(-0.05, 0.05) for _ in range(3)] for _ in range(8)]
            bent = [tuple(Q(x).limit_denominator(1000) for x in b) for b in bent]

            def place(x, y, z, bent=bent):
                b = bent[int(4 * x + 2 * y + z)]
                return (x + b[0], y + b[1], z + b[2])
            micro.cage = [mf.volume(place)]
            corners = [self.image(place, p, number) for s in tile.patches for p in self.points_of(s, number)]
            lo, hi = ([f(p[k] for p in corners) for k in range(3)] for f in (min, max))
            room = [rng.choice((Q(1, 1 << 20), Q(1, 100), -Q(1, 1 << 20), -Q(1, 50), Q(1, 10))) for _ in range(6)]
            solid = Mesh().box([lo[k] - room[k] for k in range(3)], [hi[k] + room[3 + k] for k in range(3)])
            with self.subTest(seed=seed, turn=turn, room=room):
                if min(room) > 0:
                    self.accept(micro, solid)
                else:
                    self.reject(micro, solid, "I1")

    def test_random_projective_cages(self):
        """A rational volume of the degrees 1 whose map is projective, so that facets stay flat."""
        rng = random.Random(int(os.environ.get("VT_SEED", "20261128")))
        for turn in range(40):
            rows = [[Q(rng.randint(-9, 9), 100) + (k == r) for k in range(3)] + [Q(rng.randint(-9, 9), 100)] for r in range(3)]
            weight = [Q(rng.randint(-20, 20), 100) for _ in range(3)]

            def homogeneous(x, rows=rows, weight=weight):
                return [sum(a * b for a, b in zip(row, (*x, 1))) for row in rows] + [1 + sum(a * b for a, b in zip(weight, x))]

            def place(x):
                *p, w = homogeneous(x)
                return tuple(c / w for c in p)
            micro = middle(mf.jack(core=Q(rng.randint(3, 6), 32)))
            micro.cage = [mf.volume()]
            micro.cage[0]["shape"].update(rational=True, components=4, points=[[str(c) for c in homogeneous(tuple(map(Q, x)))]
                                                                              for x in itertools.product((0, 1), repeat=3)])
            corners = [place(tuple((1 + c) / 3 for c in p)) for s in micro.tiles[0].patches for p in s.points[0]]
            lo, hi = ([f(p[k] for p in corners) for k in range(3)] for f in (min, max))
            room = [rng.choice((Q(1, 1 << 26), Q(1, 100), -Q(1, 1 << 26), Q(1, 10), Q(1, 5))) for _ in range(6)]
            solid = Mesh().box([lo[k] - room[k] for k in range(3)], [hi[k] + room[3 + k] for k in range(3)])
            with self.subTest(turn=turn, room=room):
                if min(room) > 0:
                    self.accept(micro, solid)
                else:
                    self.reject(micro, solid, "I1")

    def points_of(self, s, number):
        t = Q(number, 1 << 20)
        return [tuple(sum(c[k] * t ** j for j, c in enumerate(of)) for k in range(3)) for of in zip(*s.points)]

    def image(self, place, p, number):
        """The image of a point of the cell [1/3, 2/3]^3 under the trilinear map of the corners' images."""
        x = [(1 + c) / 3 for c in p]
        out = [Q(0)] * 3
        for ends in itertools.product((0, 1), repeat=3):
            weight = Q(1)
            for e, c in zip(ends, x):
                weight *= c if e else 1 - c
            out = [o + weight * c for o, c in zip(out, place(*map(Q, ends)))]
        return out

    def test_knots_and_degrees(self):
        """The cage has knots inside of it, and a rational one has weights."""
        knots = mf.volume(degree=2)
        knots["shape"]["knots"] = [["0", "0", "0", "1/3", "2/3", "1", "1", "1"]] * 3
        grevilles = [Q(0), Q(1, 6), HALF, Q(5, 6), Q(1)]
        knots["shape"]["points"] = [[str(c) for c in p] for p in itertools.product(grevilles, repeat=3)]
        micro = middle()
        micro.cage = [knots]
        self.accept(micro, cube(Q(1, 5)))
        self.accept(micro, cube(Q(1, 6) + Q(1, 1 << 28)))
        self.reject(micro, cube(Q(1, 6)), "I1")
        weighted = mf.volume()
        weighted["shape"].update(rational=True, components=4, points=[[str(w * Q(c)) for c in map(Q, p)] + [str(w)] for p, w in zip(
            mf.volume()["shape"]["points"], [Q(3)] * 8)])
        micro.cage = [weighted]
        self.accept(micro, cube(Q(1, 5)))
        self.reject(micro, cube(Q(1, 6)), "I1")

    def test_a_dent_between_arms(self):
        """A notch comes near to the tile from outside, without touching it."""
        micro = middle(mf.jack(half=Q(1, 8), core=Q(1, 8)))
        for depth, verdict in ((Q(13, 24) + Q(1, 1 << 20), True), (Q(13, 24) - Q(1, 1 << 20), False)):
            solid = dented(depth)
            self.accept(micro, solid) if verdict else self.reject(micro, solid, "I1")


def dented(depth):
    """The box [1/4, 3/4]^3 without the part of it where x, y and z > depth, a box at its corner."""
    lo, hi = Q(1, 4), Q(3, 4)
    axis = [lo, depth, hi]
    mesh, names = Mesh(), {}

    def corner(*i):
        if i not in names:
            names[i] = len(mesh.corners)
            mesh.corners.append(tuple(float(axis[k]) for k in i))
        return names[i]
    cells = set(itertools.product((0, 1), repeat=3)) - {(1, 1, 1)}
    for cell in sorted(cells):
        for a in range(3):
            for e in (0, 1):
                if tuple(c + (2 * e - 1) * (k == a) for k, c in enumerate(cell)) in cells:
                    continue
                quad = []
                for s, t in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    i = list(cell)
                    i[a] += e
                    i[(a + 1) % 3] += s
                    i[(a + 2) % 3] += t
                    quad.append(corner(*i))
                quad = quad if e else quad[::-1]
                mesh.triangles += [(quad[0], quad[1], quad[2]), (quad[0], quad[2], quad[3])]
    return mesh


class Voids(Judged):
    def solid(self, *holes):
        mesh = cube(Q(1, 2))
        for lo, hi in holes:
            mesh.box(lo, hi, inward=True)
        return mesh

    def test_a_void_in_an_empty_cell(self):
        hole = ((Q(1, 8),) * 3, (Q(1, 4),) * 3)
        solid, x = self.solid(hole), (Q(3, 16),) * 3
        self.accept(middle(), solid, voids=[Void(x)])
        self.reject(middle(), solid, "I3")
        self.reject(middle(), self.solid(), "I3", voids=[Void(x)])
        self.reject(middle(), solid, "I3", voids=[Void(x)] * 2)
        self.reject(middle(), solid, "I3", voids=[Void((Q(1, 16),) * 3)])    # it is not in the void
        self.reject(middle(), solid, "I3", voids=[Void((Q(1, 8), Q(3, 16), Q(3, 16)))])    # on its surface
        self.reject(middle(), solid, "I3", voids=[Void(x, corner=0)])    # the cell is empty
        self.reject(middle(), solid, "I3", voids=[Void((0, 0, 0))])
        self.reject(middle(), solid, "I3", voids=[Void((-HALF, HALF, HALF))])

    def test_random_voids(self):
        """The arms are as thick as the core, so that the tile is three boxes that cross. A void misses it, or is in it, or meets its surface."""
        rng = random.Random(int(os.environ.get("VT_SEED", "20261129")))
        lo, hi = Q(1, 3) + Q(1, 3) * Q(5, 16), Q(1, 3) + Q(1, 3) * Q(11, 16)
        bars = [[(Q(1, 3), Q(2, 3)) if k == axis else (lo, hi) for k in range(3)] for axis in range(3)]
        seen = set()
        for turn in range(60):
            at = [rng.choice((lo, hi)) + Q(rng.randint(-60, 60), 1024) for _ in range(3)]
            half = [Q(rng.randint(1, 40), 2048) for _ in range(3)]
            if rng.random() < 0.3:                         # a side comes very near to a bar
                k = rng.randrange(3)
                at[k] = (lo if at[k] < HALF else hi) + (1 if at[k] > HALF else -1) * (half[k] + Q(rng.choice((-1, 1)), 1 << 30))
            hole = [[c - h for c, h in zip(at, half)], [c + h for c, h in zip(at, half)]]
            hole = [[Q(float(c)) for c in p] for p in hole]
            x = [(a + b) / 2 for a, b in zip(*hole)]
            misses = all(any(hole[1][k] < bar[k][0] or bar[k][1] < hole[0][k] for k in range(3)) for bar in bars)
            condition = None if misses else "I1" if self.meets_surface(hole, bars) else "I3"
            corner = sum((c > HALF) << k for k, c in enumerate(x))
            seen.add(condition)
            solid, micro = self.solid(hole), middle(mf.jack(half=Q(3, 16), core=Q(3, 16)))
            with self.subTest(turn=turn, hole=hole):
                if condition is None:
                    self.accept(micro, solid, voids=[Void([c.limit_denominator(1 << 40) for c in x], corner)])
                else:
                    self.reject(micro, solid, condition, voids=[Void([c.limit_denominator(1 << 40) for c in x], corner)])
        self.assertEqual(seen, {None, "I1", "I3"})

    def meets_surface(self, hole, bars):
        """Whether a box that meets the union of the bars is not a part of its interior. Both are cut at all their coordinates."""
        axes = [sorted({b[k][e] for b in bars for e in (0, 1)} | {hole[0][k], hole[1][k]}) for k in range(3)]
        for i in itertools.product(*(range(len(a) - 1) for a in axes)):
            middle_of = [(axes[k][i[k]] + axes[k][i[k] + 1]) / 2 for k in range(3)]
            if all(hole[0][k] < middle_of[k] < hole[1][k] for k in range(3)) and not any(
                    all(bar[k][0] < middle_of[k] < bar[k][1] for k in range(3)) for bar in bars):
                return True
        return any(hole[0][k] <= Q(1, 3) or hole[1][k] >= Q(2, 3) for k in range(3))

    def test_voids_come_in_the_order_of_shells(self):
        holes = [((Q(1, 8),) * 3, (Q(1, 4),) * 3), ((Q(3, 4),) * 3, (Q(7, 8),) * 3)]
        entries = [Void((Q(3, 16),) * 3), Void((Q(13, 16),) * 3)]
        self.accept(middle(), self.solid(*holes), voids=entries)
        self.reject(middle(), self.solid(*holes), "I3", voids=entries[::-1])

    def test_a_void_beside_a_tile(self):
        """In the cell of the tile, between three of its arms: the corner (0, 0, 0) of the cell is near."""
        hole = ((Q(11, 30),) * 3, (Q(12, 30),) * 3)
        solid, x = self.solid(hole), (Q(23, 60),) * 3
        for corner in range(9):                            # the boxes to the other ones meet an arm
            if corner in (0, 1, 2, 4):
                self.accept(middle(), solid, voids=[Void(x, corner)])
            else:
                self.reject(middle(), solid, "I3", voids=[Void(x, corner)])
        graded = middle(mf.jack(slope=Q(3, 16)), numbers=lambda *i: 0)
        self.accept(graded, solid, voids=[Void(x, 0)])
        far = ((Q(18, 30), Q(11, 30), Q(18, 30)), (Q(19, 30), Q(12, 30), Q(19, 30)))
        self.accept(middle(), self.solid(far), voids=[Void((Q(37, 60), Q(23, 60), Q(37, 60)), 5)])
        self.reject(middle(), self.solid(far), "I3", voids=[Void((Q(37, 60), Q(23, 60), Q(37, 60)), 6)])

    def test_x_on_the_wall_of_a_cell(self):
        hole = ((Q(3, 10),) * 3, (Q(11, 30),) * 3)
        solid, x = self.solid(hole), (Q(1, 3), Q(34, 100), Q(34, 100))
        self.reject(middle(), solid, "I3", voids=[Void(x)])    # in a closed cell with a tile
        self.reject(middle(), solid, "I3", voids=[Void(x, 0)])
        self.accept(middle(), solid, voids=[Void((Q(32, 100), *x[1:]))])
        self.accept(middle(), solid, voids=[Void((Q(34, 100), *x[1:]), 0)])

    def test_a_void_in_the_material(self):
        hole = ((Q(31, 64),) * 3, (Q(33, 64),) * 3)
        for corner in range(9):
            self.reject(middle(), self.solid(hole), "I3", voids=[Void((HALF,) * 3, corner)])

    def test_a_solid_in_a_void(self):
        """Depth 2: a point in the inner solid is in the void's shell, too, but not in the hole behind it."""
        hole = ((Q(1, 16),) * 3, (Q(5, 16),) * 3)
        solid = self.solid(hole).box((Q(1, 8),) * 3, (Q(1, 4),) * 3)
        self.accept(middle(), solid, voids=[Void((Q(3, 32),) * 3)])
        self.reject(middle(), solid, "I3", voids=[Void((Q(3, 16),) * 3)])
        twice = Mesh().box((Q(1, 8),) * 3, (Q(1, 4),) * 3)
        twice.box(*hole, inward=True).box((0, 0, 0), (1, 1, 1))
        self.accept(middle(), twice, voids=[Void((Q(3, 32),) * 3)])

    def test_a_void_that_a_wall_of_tiles_encloses(self):
        """Blocks around an empty cell; a void in this cell."""
        cells = [i for i in itertools.product(range(3), repeat=3) if i != (1, 1, 1)]
        micro = one_of(3, cells)
        hole = ((Q(2, 5),) * 3, (Q(3, 5),) * 3)
        caps = 54 - 6
        self.accept(micro, Mesh().box((-1,) * 3, (2,) * 3).box(*hole, inward=True), (26, caps, 1, 1, caps - 26 + 1), voids=[Void((HALF,) * 3)])

    def test_bridges_in_the_way(self):
        """A bridge leans to y > 1/2; its box holds the second x, though the bridge misses the void there."""
        micro = middle()
        bridge = straight(mf.jack(), 13, 0, Q(1, 4), grid=micro.grids[0])
        bridge.points = [(p[0], p[1] + Q(k % 3, 12), p[2]) for k, p in enumerate(bridge.points)]
        bridge.matrix = tuple(x * (100 if k > 5 else 1) for k, x in enumerate(bridge.matrix))
        micro.bridges = [bridge]
        for lo, hi, verdict in ((Q(26, 64), Q(28, 64), True), (Q(30, 64), Q(32, 64), False)):
            hole = ((Q(3, 32), lo, Q(31, 64)), (Q(5, 32), hi, Q(33, 64)))
            voids = [Void((Q(1, 8), (lo + hi) / 2, HALF))]
            if verdict:
                self.accept(micro, self.solid(hole), voids=voids, skin="1")
            else:
                self.reject(micro, self.solid(hole), "I3", voids=voids, skin="1")


class Skin(Judged):
    def with_bridge(self, length=Q(1, 4), **others):
        micro = middle()
        micro.bridges = [straight(mf.jack(), 13, 1, length, grid=micro.grids[0], **others)]
        return micro

    def test_the_skin(self):
        """The end is at x = 2/3 + 1/4 = 11/12; the box ends at 15/16."""
        solid = cube(Q(7, 16))
        gap = Q(15, 16) - Q(11, 12)
        for skin, verdict in ((gap + Q(1, 1 << 18), True), (gap - Q(1, 1 << 30), False), (1, True), (0, False)):
            micro = self.with_bridge()
            if verdict:
                self.accept(micro, solid, skin=str(skin))
            else:
                self.reject(micro, solid, "I4", skin=str(skin))

    def test_a_bridge_meets_the_model(self):
        for half, condition in ((Q(11, 12) - HALF, "I1"), (Q(2, 5), "I1"), (Q(1, 5), "I1")):
            self.reject(self.with_bridge(), cube(half), condition, skin="1")
        self.accept(self.with_bridge(), cube(Q(11, 12) - HALF + Q(1, 1 << 30)), skin="1")
        pin = Mesh().box((0, 0, 0), (1, 1, 1)).box((Q(3, 4), Q(7, 16), Q(7, 16)), (Q(7, 8), Q(9, 16), Q(9, 16)), inward=True)
        self.reject(self.with_bridge(), pin, "I1", skin="1")

    def test_an_end_near_several_triangles(self):
        """The diagonal of the face crosses the end, so that it has to be cut."""
        micro = self.with_bridge()
        gap = Q(15, 16) - Q(11, 12)
        self.accept(micro, cube(Q(7, 16)), skin=str(gap + Q(1, 1 << 10)))

    def test_knots_across_a_bridge(self):
        knots = mf.volume(degree=2)
        inner = ["1/3", "2/3", "3/4", "5/6"]
        knots["shape"]["knots"] = [["0", "0", "0", *inner, "1", "1", "1"]] * 3
        t = [Q(x) for x in ("0", "0", "0", *inner, "1", "1", "1")]
        grevilles = [(t[i + 1] + t[i + 2]) / 2 for i in range(len(t) - 3)]
        knots["shape"]["points"] = [[str(c) for c in p] for p in itertools.product(grevilles, repeat=3)]
        micro = self.with_bridge()
        micro.cage = [knots]
        micro.grids[0] = Grid([[0, Q(1, 3), Q(2, 3), Q(3, 4), Q(5, 6), 1]] * 3, {(1, 1, 1): 0})
        micro.bridges = [straight(mf.jack(), 31, 1, Q(1, 4), grid=micro.grids[0])]
        self.accept(micro, cube(Q(7, 16)), skin="1/16")
        self.reject(micro, cube(Q(11, 12) - HALF), "I1", skin="1")
        self.reject(micro, cube(Q(7, 16)), "I4", skin="1/64")

    def test_s1(self):
        solid = cube(Q(7, 16))
        self.reject(self.with_bridge(), solid, "I4", skin="-")
        for skin in ("", "1/0", "1/00", "-1", "1.5", "1/", "/1", "1/2/3", " 1", "9" * 101, "1/" + "9" * 101):
            self.reject(self.with_bridge(), solid, "S1", skin=skin)
        self.accept(self.with_bridge(), solid, skin="9" * 100 + "/" + "9" * 100)
        self.reject(middle(), solid, "I4", skin="1")
        for changes in ({"model_format": "vmicro"}, {"model_format": "vjson-"}, {"model_format": "off,ply"}, {"model_sha256": "0"}, {"more": 1}):
            self.reject(middle(), solid, "S1", **changes)
        self.reject(middle(), solid, "S2", reading_rule="")


class Lies(Judged):
    def test_a1(self):
        micro, solid = middle(), cube(Q(1, 5))
        text, certificate, model = mf.certified_inside(micro, solid, numbers_of(micro, *INNER[1:]), VERITOPE)
        self.judge((text, certificate, model), 0, "ACCEPT")
        self.judge((text, certificate, model + b"\n"), 1, "A1")
        self.judge((text, certificate, model.replace(b"OFF", b"off")), 1, "A1")
        self.reject(micro, solid, "A1", model_bytes=1)

    def test_b1_b2(self):
        micro, solid = middle(), cube(Q(1, 5))
        text, model = micro.text(), solid.text()
        structure = mf.hints(micro.tiles) + mf.cage_body(micro.cage_text(), VERITOPE)
        of_mesh = mf.certified_body(model, VERITOPE, b"VTMV", suffix=".off")
        numbers = {**dict(zip(mf.NUMBERS, numbers_of(micro, *INNER[1:]))), "bridges": 0}
        good, x = mf.inside_body(structure, of_mesh), (HALF,) * 3

        def judge(body, *expected, **changes):
            self.judge((text, mf.inside_certificate(text, model.encode(), body, {**numbers, **changes}), model.encode()), *expected)
        judge(good, 0, "ACCEPT")
        for body in (b"VTMS" + good[4:], good[:-1], good + b"\0", mf.inside_body(structure, of_mesh, count=1), mf.inside_body(structure, of_mesh, [Void(x, 9)]),
                     mf.inside_body(structure, of_mesh, [Void(x, volume=1)]), good[:4] + b"\xff" * 4 + good[8:], good[:8] + b"\xff" * 4 + good[12:],
                     mf.inside_body(structure + b"\0", of_mesh), mf.inside_body(structure, of_mesh + b"\0"), mf.inside_body(structure, of_mesh[:-1])):
            judge(body, 1, "B1")
        judge(mf.inside_body(structure, of_mesh, [Void((Q(1, 1 << 64), *x[1:]))]), 1, "B2")
        other = mf.hints([mf.jack().copy(exit=8)]) + structure[len(mf.hints(micro.tiles)):]
        judge(mf.inside_body(other, of_mesh), 1, "F2")
        order = bytearray(of_mesh)
        order[12:16] = order[16:20]
        judge(mf.inside_body(structure, bytes(order)), 1, "V1")
        for key in (*mf.NUMBERS, "bridges"):
            judge(good, 1, "W3", **{key: numbers[key] + 1})

    def test_refused(self):
        micro, solid = middle(), cube(Q(1, 5))
        text, certificate, model = mf.certified_inside(micro, solid, numbers_of(micro, *INNER[1:]), VERITOPE)
        bad = model[:-4]
        body = certificate.split(b"\n", 1)[1]
        numbers = {**dict(zip(mf.NUMBERS, numbers_of(micro, *INNER[1:]))), "bridges": 0}
        self.judge((text, mf.inside_certificate(text, bad, body, numbers), bad), 4, "")
        self.judge((text[:-2], mf.inside_certificate(text[:-2], model, body, numbers), model), 4, "")

    def test_usage(self):
        micro, solid = middle(), cube(Q(1, 5))
        text, certificate, model = mf.certified_inside(micro, solid, numbers_of(micro, *INNER[1:]), VERITOPE)
        plain = mf.certified(micro, numbers_of(micro, *INNER[1:]), VERITOPE)
        self.assertEqual(judges.in_cpp(text, certificate)[0], 2)
        self.assertEqual(judges.in_cpp(*plain)[0], 0)
        self.assertEqual(judges.in_cpp(*plain, solid=model)[0], 2)
        self.assertEqual(judges.in_cpp(text, certificate, b"", solid=model)[0], 2)
        with tempfile.TemporaryDirectory() as folder:
            paths = [os.path.join(folder, name) for name in ("m", "c", "s")]
            for path, data in zip(paths, (text, certificate, model)):
                pathlib.Path(path).write_bytes(data)
            m, c, s = paths
            for line, code in (((m, c, "--model", s), 0), ((m, "--model", s, c), 2), (("--model", s, m, c), 2), ((m, c, "--model"), 2),
                               ((m, c, "--model", s, "--model", s), 2), ((m, c, "--model", s, s), 2), ((m, c, s, "--model", s), 2),
                               ((m, c, "--model", s + "x"), 4), ((m, c, "--solid", s), 2), ((m, c, s), 2)):
                run = subprocess.run([judges.CHECK, *line], capture_output=True, text=True, timeout=60, check=False)
                self.assertEqual(run.returncode, code, (line, run.stdout, run.stderr))


if __name__ == "__main__":
    unittest.main()
