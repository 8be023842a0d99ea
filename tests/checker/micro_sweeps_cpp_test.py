#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker of sweeps in microstructure-1: sweeps whose truth is known by hand, and for each condition a file or certificate that fails by
it alone. VERITOPE_CHECK names the checker, VERITOPE the program that certifies cages."""
import itertools
import json
import os
import random
import unittest
from fractions import Fraction as Q
from math import comb

import micro_cpp_test as base
import micro_files as mf
from micro_files import HALF, Grid, Micro, Sweep

UP = (0, 0, Q(1, 4))
COLUMN = Grid([[0, 1], [0, 1], [Q(i, 4) for i in range(5)]], {(0, 0, 0): 0})    # one cell with a tile below three empty ones


def straight(direction, cell=0, wall=5, **others):
    """A sweep with a constant speed to `direction` from the cap."""
    return Sweep(cell, wall, [Q(x) / 2 for x in direction], direction, **others)


def column(*sweeps, tile=None, grid=None, cage=None):
    return Micro([grid or COLUMN], [tile or mf.rod()], cage, sweeps=sweeps)


# ---------------------------------------------------------------- polynomials in three parameters, exactly

class Polynomial:
    """terms: {exponents: coefficient}"""

    def __init__(self, terms):
        self.terms = {at: c for at, c in terms.items() if c}

    def __add__(self, other):
        return Polynomial({at: self.terms.get(at, 0) + other.terms.get(at, 0) for at in {*self.terms, *other.terms}})

    def __mul__(self, other):
        found = {}
        for (a, x), (b, y) in itertools.product(self.terms.items(), other.terms.items()):
            at = tuple(i + j for i, j in zip(a, b))
            found[at] = found.get(at, 0) + x * y
        return Polynomial(found)

    def times(self, factor):
        return Polynomial({at: factor * c for at, c in self.terms.items()})

    def derivative(self, axis):
        return Polynomial({tuple(i - (a == axis) for a, i in enumerate(at)): at[axis] * c for at, c in self.terms.items() if at[axis]})

    def bernstein(self, degrees):
        """{index: coefficient} on [0, 1]^3."""
        found = {}
        for index in itertools.product(*(range(n + 1) for n in degrees)):
            total = Q(0)
            for at, c in self.terms.items():
                if all(i >= e for i, e in zip(index, at)):
                    for i, e, n in zip(index, at, degrees):
                        c = c * Q(comb(i, e), comb(n, e))
                    total += c
            found[index] = total
        return found


def through_corners(values, lo, hi):
    """The trilinear polynomial with these values at the corners of the box from lo to hi, in parameters of that box, and then of [0, 1]^3."""
    total = Polynomial({})
    for ends in itertools.product((0, 1), repeat=3):
        part = Polynomial({(0, 0, 0): values[ends]})
        for axis, e in enumerate(ends):
            unit = tuple(int(a == axis) for a in range(3))
            step = hi[axis] - lo[axis]
            linear = {(0, 0, 0): lo[axis], unit: step} if e else {(0, 0, 0): 1 - lo[axis], unit: -step}
            part = part * Polynomial(linear)
        total = total + part
    return total


def is_definite(m):
    """A symmetric matrix, by elimination."""
    m = [list(row) for row in m]
    while m:
        if m[0][0] <= 0:
            return False
        m = [[x - row[0] * y / m[0][0] for x, y in zip(row[1:], m[0][1:])] for row in m[1:]]
    return True


def meets_q2(corners, lo, hi, sweep):
    """Q2 for a cage whose map has these homogeneous values at the corners of [0, 1]^3, and a cell from lo to hi."""
    axis, end = divmod(sweep.wall, 2)
    k = [sweep.matrix[3 * r:3 * r + 3] for r in range(3)]

    def is_good(columns, index):
        product = [[sum(a * b[index] for a, b in zip(row, column)) for column in columns] for row in k]
        return is_definite([[product[r][c] + product[c][r] for c in range(3)] for r in range(3)])

    def growth(lo, hi):
        """D and W^2 in the degrees (2, 2, 2), on a box."""
        x, y, z, w = (through_corners({e: v[i] for e, v in corners.items()}, lo, hi) for i in range(4))
        columns = []
        for a in range(3):
            if lo[a] == hi[a]:
                columns.append(None)
                continue
            rate = 1 / (hi[a] - lo[a])
            columns.append([(w * c.derivative(a) + (w.derivative(a) * c).times(-1)).times(rate).bernstein((2, 2, 2)) for c in (x, y, z)])
        return columns, (w * w).bernstein((2, 2, 2))
    slab, width = [list(lo), list(hi)], hi[axis] - lo[axis]
    slab[1 - end][axis] = slab[end][axis] - (2 * end - 1) * sweep.depth * width
    columns, square = growth(*slab)
    if not all(is_good(columns, index) for index in square):
        return False
    wall = [list(lo), list(hi)]
    wall[1 - end][axis] = wall[end][axis]
    columns, square = growth(*wall)
    e, f = sweep.axis
    for g in (e, [b - a for a, b in zip(e, f)]):
        columns[axis] = [{index: (2 * end - 1) * sweep.speed * c * square[index] for index in square} for c in g]
        if not all(is_good(columns, index) for index in square):
            return False
    return True


class Judged(base.Judged):
    def accept_column(self, *sweeps, **others):
        self.accept(column(*sweeps, **others), 4, 1, 0, 1, 1, 0)

    def reject_column(self, condition, *sweeps, **others):
        self.reject(column(*sweeps, **others), condition)


class Sweeps(Judged):
    def test_straight_sweeps(self):
        for length in (Q(1, 8), Q(1, 2), Q(3, 4), 10):
            for depth in (1, HALF, Q(1, 100)):
                self.accept_column(straight((0, 0, length), speed=2 / Q(length), depth=depth))
        three = Grid([[Q(i, 3) for i in range(4)]] * 3, {(1, 1, 1): 0})
        every = []
        for wall in range(6):
            direction = [Q(0)] * 3
            direction[wall // 2] = Q(wall % 2 * 2 - 1)
            every.append(straight(direction, 13, wall, speed=2))
        self.accept(Micro([three], [mf.jack()], sweeps=every), 27, 1, 0, 1, 1, 0)
        self.accept(Micro([three], [mf.jack()], sweeps=every[:1] + every[3:]), 27, 1, 0, 1, 1, 0)

    def test_curved_sweeps(self):
        self.accept_column(Sweep(0, 5, (0, 0, 1), (HALF, 0, 2)))
        self.accept_column(Sweep(0, 5, (HALF, -HALF, 1), (0, 0, 2)))

    def test_a_cap_with_a_number(self):
        grid = Grid(COLUMN.breaks, COLUMN.cells, numbers=lambda *i: 1 << 19)
        self.accept_column(straight((0, 0, 2)), tile=mf.jack(slope=Q(1, 16)), grid=grid)

    def test_a_sweep_out_of_a_face_of_the_cage(self):
        self.accept_column(straight((0, 0, -2), wall=4))

    def test_b1(self):
        for change in ({"depth": 0}, {"depth": -1}, {"depth": Q(5, 4)}, {"speed": 0}, {"speed": -1}):
            self.reject_column("B1", straight((0, 0, 2), **change))
        micro = column(straight((0, 0, 2)))
        text, cage, numbers = micro.text(), mf.cage_body(micro.cage_text(), base.VERITOPE), {**dict(zip(mf.NUMBERS, (4, 1, 0, 1, 1, 0))), "bridges": 1}
        honest = mf.hints(micro.tiles, micro.sweeps)
        self.judge(text, mf.certificate(text, honest + cage, numbers), 0, "ACCEPT")
        self.judge(text, mf.certificate(text, honest + cage, {**numbers, "bridges": 0}), 1, "W3")
        for body in (mf.hints(micro.tiles), mf.hints(micro.tiles, micro.sweeps * 2), honest[:-1] + b"\0", honest[:-1], honest + b"\0"):
            self.judge(text, mf.certificate(text, body + cage, numbers), 1, "B1")
        short = b"VTMS" + (1).to_bytes(4, "little") + (2**32 - 1).to_bytes(4, "little") + honest[12:]
        self.judge(text, mf.certificate(text, short + cage, numbers), 1, "B1")

    def test_b2(self):
        long = 1 << 64
        for change in ({"matrix": [Q(1, long), *mf.UNIT_MATRIX[1:]]}, {"matrix": [*mf.UNIT_MATRIX[:8], long]}, {"depth": Q(1, long)}, {"speed": long},
                       {"speed": Q(1, long)}):
            self.reject_column("B2", straight((0, 0, 2), **change))
        most = long - 1
        self.accept_column(straight((0, 0, 2), matrix=[most * k for k in mf.UNIT_MATRIX], depth=Q(long - 2, most)))

    def test_q1(self):
        two = Grid(COLUMN.breaks, {(0, 0, 0): 0, (0, 0, 1): 0})
        self.reject_column("Q1", straight((0, 0, 2)), grid=two)    # the cap is glued
        self.reject_column("Q1", straight((0, 0, 2)), tile=mf.jack(walls=range(5)))    # there is no cap
        keel = mf.keel(ridge=Q(1, 16)).turned((0, 1, 2), (0, 0, 1))
        self.reject_column("Q1", straight((0, 0, 2)), tile=keel)    # two caps of two patches
        self.reject_column("Q1", straight((0, 0, 2)), tile=base.cup())    # an annulus of four patches

    def test_q2_on_the_slab(self):
        good = straight((0, 0, 2))
        self.accept_column(good)
        for matrix in ((0,) * 9, [-k for k in mf.UNIT_MATRIX], (-1, 0, 0, 0, 1, 0, 0, 0, 1), (1, 0, 0, 0, 1, 0, 0, 0, 0)):
            self.reject_column("Q2", straight((0, 0, 2), matrix=matrix))
        self.reject_column("Q2", straight((0, 0, 2), matrix=(1, 2, 0, 0, 1, 0, 0, 0, 1)))    # its symmetric part is singular
        self.accept_column(straight((0, 0, 2), matrix=(1, 2 - Q(1, 1 << 30), 0, 0, 1, 0, 0, 0, 1)))

    def test_q2_depends_on_the_depth(self):
        """The tile turns by more than a right angle in its cell, so that K = 1 serves near to the wall only."""
        cage = [horseshoe(HALF)]
        slow = straight((0, 0, -4), wall=5, matrix=(-1, 0, 0, 0, 1, 0, 0, 0, -1), depth=Q(1, 8))
        one = Grid.block((1, 1, 1))
        self.accept(Micro([one], [mf.rod()], cage, sweeps=[slow]), 1, 1, 0, 1, 1, 0)
        slow.depth = Q(1)
        self.reject(Micro([one], [mf.rod()], cage, sweeps=[slow]), "Q2")
        slow = straight((0, 0, -4), wall=4, depth=Q(1, 8))
        self.accept(Micro([one], [mf.rod()], cage, sweeps=[slow]), 1, 1, 0, 1, 1, 0)
        slow.depth = Q(1)
        self.reject(Micro([one], [mf.rod()], cage, sweeps=[slow]), "Q2")

    def test_q2_beyond_the_wall(self):
        self.reject_column("Q2", straight((0, 0, -2)))     # into the tile
        self.reject_column("Q2", Sweep(0, 5, (0, 0, 1), (0, 0, HALF)))    # turns back
        self.reject_column("Q2", Sweep(0, 5, (0, 0, 1), (0, 0, 1)))    # stops
        self.reject_column("Q2", Sweep(0, 5, (0, 0, 0), (0, 0, 1)))
        self.reject_column("Q2", straight((2, 0, 0)))      # in the wall
        self.reject_column("Q2", straight((0, 0, 2), wall=4))

    def test_q2_and_the_speed(self):
        """With e = (1, 0, 1/4), K C' + its transpose has the minors 2, 4 and 2 (l - l^2)."""
        for speed, verdict in ((HALF, True), (1 - Q(1, 1 << 30), True), (1, False), (2, False)):
            sweep = straight((2, 0, HALF), speed=speed)
            self.accept_column(sweep) if verdict else self.reject_column("Q2", sweep)

    def test_q2_of_random_sweeps(self):
        """In cages of one cell with 27, polynomial and rational; the condition is tested here with polynomials over the rational numbers."""
        rng = random.Random(int(os.environ.get("VT_SEED", "20261201")))
        three = Grid([[Q(i, 3) for i in range(4)]] * 3, {(1, 1, 1): 0})
        seen = set()
        for turn in range(60):
            is_rational, size = turn % 2 == 1, rng.choice((1, 2, 4))
            corners = {}
            for ends in itertools.product((0, 1), repeat=3):
                w = 1 + Q(rng.randint(-size, size), 16) if is_rational else Q(1)
                corners[ends] = [w * (e + Q(rng.randint(-size, size), 20)) for e in ends] + [w]
            cage = mf.volume()
            order = list(itertools.product((0, 1), repeat=3))
            cage["shape"].update(rational=is_rational, components=4 if is_rational else 3,
                                 points=[[str(c) for c in corners[e][:4 if is_rational else 3]] for e in order])
            wall = rng.randrange(6)
            normal = [Q(0)] * 3
            normal[wall // 2] = Q(wall % 2 * 2 - 1)
            e = [n * HALF + Q(rng.randint(-size, size), 10) for n in normal]
            f = [2 * a + Q(rng.randint(-size, size), 10) for a in e]
            matrix = [k + Q(rng.randint(-size, size), 8) for k in mf.UNIT_MATRIX]
            sweep = Sweep(13, wall, e, f, matrix=matrix, depth=rng.choice((1, HALF, Q(1, 10))), speed=rng.choice((1, 2, HALF)))
            verdict = meets_q2(corners, [Q(1, 3)] * 3, [Q(2, 3)] * 3, sweep)
            seen.add((is_rational, verdict))
            with self.subTest(turn=turn):
                micro = Micro([three], [mf.jack()], [cage], sweeps=[sweep])
                self.accept(micro, 27, 1, 0, 1, 1, 0) if verdict else self.reject(micro, "Q2")
        self.assertEqual(len(seen), 4)

    def test_q3_a_tile_in_the_way(self):
        above = Grid(COLUMN.breaks, {(0, 0, 0): 0, (0, 0, 3): 0})
        for length, verdict in ((HALF - Q(1, 1 << 30), True), (HALF, False), (Q(5, 8), False), (3, False)):
            micro = column(straight((0, 0, length), speed=2 / length), grid=above)
            self.accept(micro, 4, 2, 0, 2, 2, 0) if verdict else self.reject(micro, "Q3")

    def test_q3_rows_of_the_matrix_part_what_axes_do_not(self):
        """It leans over a tile beside it. The rows of K, and halves, part them."""
        grid = Grid([[Q(i, 4) for i in range(5)], [0, 1], [Q(i, 8) for i in range(9)]], {(0, 0, 0): 0, (2, 0, 1): 0})
        for matrix in (mf.UNIT_MATRIX, (1, 0, -HALF, 0, 1, 0, HALF, 0, 1)):
            self.accept(Micro([grid], [mf.rod()], sweeps=[straight((Q(1, 4), 0, HALF), matrix=matrix, speed=2)]), 32, 2, 0, 2, 2, 0)
        self.reject(Micro([grid], [mf.rod()], sweeps=[straight((HALF, 0, Q(1, 8)), speed=HALF, matrix=(1, 0, 0, 0, 1, 0, 0, 0, 9))]), "Q3")

    def test_q3_over_a_cap_in_the_same_wall(self):
        """A neighbour's cap lies in the plane of the wall, and the sweep ends above it; or it reaches the rod above."""
        cells = {(0, 0, 0): 0, (1, 0, 0): 0, (1, 0, 2): 0}
        grid = Grid([[Q(i, 2) for i in range(3)], [0, 1], [Q(i, 4) for i in range(5)]], cells)
        for height, verdict in ((Q(1, 8), True), (Q(1, 4) - Q(1, 1 << 30), True), (Q(1, 4), False)):
            micro = Micro([grid], [mf.rod()], sweeps=[straight((HALF, 0, height))])
            self.accept(micro, 8, 3, 0, 3, 3, 0) if verdict else self.reject(micro, "Q3")

    def test_q3_the_own_tile(self):
        """The tile is a loop that is nearly closed; the sweep goes on from its end, to where it begins."""
        one = Grid.block((1, 1, 1))
        for length, verdict in ((Q(1, 4), True), (2, False)):
            sweep = straight([c * length for c in (-HALF, 0, -HALF)], matrix=loop_matrix(), depth=Q(1, 64), speed=8 / length)
            micro = Micro([one], [mf.rod()], [loop()], sweeps=[sweep])
            self.accept(micro, 1, 1, 0, 1, 1, 0) if verdict else self.reject(micro, "Q3")

    def test_q4(self):
        grid = Grid([[0, 1], [0, 1], [Q(i, 5) for i in range(6)]], {(0, 0, 0): 0, (0, 0, 4): 0})
        for gap, verdict in ((Q(1, 1 << 30), True), (0, False), (-Q(1, 10), False)):
            up, down = straight((0, 0, Q(3, 10) - gap), speed=6), straight((0, 0, -Q(3, 10)), 4, 4, speed=6)
            micro = Micro([grid], [mf.rod()], sweeps=[up, down])
            self.accept(micro, 5, 2, 0, 2, 2, 0) if verdict else self.reject(micro, "Q4")

    def test_two_sweeps_that_cross_above_the_cage(self):
        grid = Grid([[Q(i, 2) for i in range(3)], [0, 1], [0, 1]], {(0, 0, 0): 0, (1, 0, 0): 0})
        apart = [straight((0, y, 2), cell) for cell, y in ((0, 1), (1, -1))]
        self.accept(Micro([grid], [mf.rod()], sweeps=apart), 2, 2, 0, 2, 2, 0)
        crossing = [straight((x, 0, 2), cell) for cell, x in ((0, HALF), (1, -HALF))]
        self.reject(Micro([grid], [mf.rod()], sweeps=crossing), "Q4")
        curved = [Sweep(cell, 5, (x, 0, 1), (0, 0, 2)) for cell, x in ((0, -Q(1, 4)), (1, Q(1, 4)))]
        self.accept(Micro([grid], [mf.rod()], sweeps=curved), 2, 2, 0, 2, 2, 0)

    def test_random_prisms(self):
        """Straight sweeps and rods are convex: they are disjoint if and only if the normal of a face of one, or a product of two edges, parts them."""
        rng = random.Random(int(os.environ.get("VT_SEED", "20261203")))
        n, seen = 5, set()
        for turn in range(80):
            cells = rng.sample(list(itertools.product(range(n), repeat=3)), 3)
            grid = Grid([[Q(i, n) for i in range(n + 1)]] * 3, dict.fromkeys(cells, 0))
            bodies, sweeps, own = [], [], []
            low, high = Q(1, 4 * n), Q(3, 4 * n)
            for cell in cells:
                x, y, z = (Q(i, n) for i in cell)
                bodies.append([(x + u, y + v, z + w) for u in (low, high) for v in (low, high) for w in (0, Q(1, n))])
                own.append(cell)
            for cell in sorted(rng.sample(cells, rng.choice((1, 2, 3)))):
                if tuple(c + (k == 2) for k, c in enumerate(cell)) in cells:
                    continue
                direction = (Q(rng.randint(-8, 8), 16), Q(rng.randint(-8, 8), 16), Q(rng.randint(4, 12), 16))
                number = (cell[0] * n + cell[1]) * n + cell[2]
                sweeps.append(straight(direction, number, 5, speed=direction[2]))
                x, y, z = Q(cell[0], n), Q(cell[1], n), Q(cell[2] + 1, n)
                base_points = [(x + u, y + v, z) for u in (low, high) for v in (low, high)]
                bodies.append(base_points + [tuple(a + b for a, b in zip(p, direction)) for p in base_points])
                own.append(cell)
            glued = sum(tuple(c + (k == 2) for k, c in enumerate(cell)) in cells for cell in cells)
            condition = None
            for i, j in itertools.combinations(range(len(bodies)), 2):
                if j >= 3 and own[i] != own[j] and not are_apart(bodies[i], bodies[j]):
                    condition = "Q3" if i < 3 else condition or "Q4"
            with self.subTest(turn=turn, cells=cells, sweeps=[b.json() for b in sweeps]):
                seen.add((condition, len(sweeps) > 1))
                micro = Micro([grid], [mf.rod()], sweeps=sweeps)
                if condition:
                    self.reject(micro, condition)
                else:
                    self.accept(micro, n ** 3, 3, glued, 3 - glued, 3 - glued, 0)
        self.assertLessEqual({(None, True), ("Q3", True), ("Q4", True)}, seen)

    def test_the_first_sweep_that_fails_is_named(self):
        grid = Grid([[Q(i, 2) for i in range(3)], [0, 1], [Q(i, 4) for i in range(5)]], {(0, 0, 0): 0, (1, 0, 0): 0, (0, 0, 3): 0})
        long, bad = straight((0, 0, 2)), straight((0, 0, 2), 4, speed=2, matrix=(0,) * 9)
        self.reject(Micro([grid], [mf.rod()], sweeps=[long, bad]), "Q3")
        self.reject(Micro([grid], [mf.rod()], sweeps=[straight((0, 0, 2), matrix=(0,) * 9), straight((0, 0, 2), 4)]), "Q2")

    def test_numbers_that_are_too_large_for_bounds(self):
        self.reject_column("Q2", straight((0, 0, 1 << 2000)))
        self.reject_column("Q2", straight((0, 0, Q(1, 1 << 2000))))

    def test_refused(self):
        micro = column(straight((0, 0, 2)))
        good = micro.sweeps[0].json()
        self.accept(micro, 4, 1, 0, 1, 1, 0)
        e, f = good["axis"]
        for change in ({"grid": 1}, {"grid": -1}, {"cell": 1}, {"cell": 4}, {"cell": -1}, {"wall": 6}, {"wall": "5"}, {"more": 1}, {"volume": 0}, {"axis": [e]},
                       {"axis": [e, f, f]}, {"axis": [e, f[:2]]}, {"axis": [e, [*f, "0"]]}, {"axis": [e, [*f[:2], 0]]}, {"axis": [*e, *f]},
                       {"axis": [e, [*f[:2], f"1/{1 << 2304}"]]}, {"axis": [e, [*f[:2], str(1 << 2304)]]}):
            self.refuse(micro, sweeps=json.dumps([{**good, **change}]))
        for key in good:
            self.refuse(micro, sweeps=json.dumps([{k: v for k, v in good.items() if k != key}]))
        self.refuse(micro, sweeps=json.dumps([good, good]))
        self.refuse(micro, sweeps=json.dumps([good, {**good, "wall": 4}]))
        self.refuse(micro, sweeps="null")
        bridged = Micro(micro.grids, micro.tiles, bridges=[base.straight(mf.rod(), 0, 5, HALF, grid=COLUMN)])
        self.accept(bridged, 4, 1, 0, 1, 1, 0)
        self.refuse(bridged, sweeps=json.dumps([{**good, "wall": 4}]))
        members = bridged.members()
        self.refuse(Micro(micro.grids, micro.tiles), materials="[]", sweeps=json.dumps([good]))    # they come before materials
        self.refuse(Micro(micro.grids, micro.tiles), sweeps="[]", bridges=members["bridges"])    # and after bridges
        text = bridged.text(sweeps="[]", materials="[]")
        body = mf.hints(bridged.tiles, bridged.bridges) + mf.cage_body(bridged.cage_text(), base.VERITOPE)
        self.judge(text, mf.certificate(text, body, {**dict(zip(mf.NUMBERS, (4, 1, 0, 1, 1, 0))), "bridges": 1}), 0, "ACCEPT")


def are_apart(first, second):
    """For two parallelepipeds, by their corners in the order of three binary digits."""
    edges = [[mf.subtract(body[1 << k], body[0]) for k in range(3)] for body in (first, second)]
    normals = [mf.cross(of[a], of[b]) for of in edges for a, b in ((0, 1), (1, 2), (2, 0))] + [mf.cross(a, b) for a in edges[0] for b in edges[1]]
    for normal in normals:
        low, high = ([sum(a * b for a, b in zip(normal, p)) for p in body] for body in (first, second))
        if max(low) < min(high) or max(high) < min(low):
            return True
    return False


def bent(curve, across, width):
    """A volume along a curve in the plane of x and z; the other coordinates of a point move along `across`, and y."""
    cage = mf.volume()
    points = [[str(Q(c) + (Q(u) - HALF) * width * n) if k != 1 else str(Q(v) * width) for k, (c, n) in enumerate(zip(at, beside))]
              for u in (0, 1) for v in (0, 1) for at, beside in zip(curve, across)]
    degree = len(curve) - 1
    cage["shape"].update(degrees=[1, 1, degree], points=points, knots=[["0", "0", "1", "1"]] * 2 + [["0"] * (degree + 1) + ["1"] * (degree + 1)])
    return cage


def horseshoe(width):
    return bent([(0, 0, 0), (1, 0, 3), (2, 0, 0)], [(1, 0, 0), (0, 0, -1), (-1, 0, 0)], width)


def loop():
    """It ends at (1/2, 1) toward (-5, -6), and begins at (-1/2, 0)."""
    return bent([(-HALF, 0, 0), (-3, 0, 4), (3, 0, 4), (HALF, 0, 1)], [(1, 0, Q(3, 5)), (HALF, 0, -1), (-HALF, 0, -1), (-1, 0, Q(4, 5))], Q(1, 4))


def loop_matrix():
    """The inverse of the map's derivative at its end, up to scales of the rows, of which the last one is greater: the loop turns."""
    u, v, t = (-Q(1, 4), 0, Q(1, 5)), (0, Q(1, 4), 0), (3 * (HALF - 3), 0, 3 * (1 - 4))
    d = mf.determinant(u, v, t)
    return [scale * c / d for scale, row in ((1, mf.cross(v, t)), (1, mf.cross(t, u)), (16, mf.cross(u, v))) for c in row]


if __name__ == "__main__":
    unittest.main()
