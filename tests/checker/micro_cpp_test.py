#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker of microstructure-1: microstructures whose numbers are known by hand, and for each condition a file or certificate that fails
by it alone. VERITOPE_CHECK names the checker, VERITOPE the program that certifies cages."""
import itertools
import json
import math
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
from micro_files import HALF, Grid, Micro, Patch, Tile     # noqa: E402

VERITOPE = os.environ["VERITOPE"]
WHOLE = 1 << 20


def jack_numbers(k, m, n):
    """A block of jacks that are glued to all their neighbours."""
    tiles, caps = k * m * n, 3 * k * m * n - k * m - m * n - n * k
    return tiles, tiles, caps, 1, 1, caps - tiles + 1


def one(tile, **others):
    return Micro([Grid.block((1, 1, 1), **others)], [tile])


def stack(*tiles, numbers=None):
    """One cell above the other."""
    n = len(tiles)
    return Micro([Grid([[0, 1], [0, 1], [Q(i, n) for i in range(n + 1)]], {(0, 0, i): i for i in range(n)}, numbers=numbers)], tiles)


def jack_or(change, **options):
    """A jack whose patches the function changes."""
    tile = mf.jack(**options)
    change(tile.patches)
    return tile


def cup():
    """A block on a cap on z = 0, with an annulus as its cap on z = 1 around a dip."""
    def ring(half, z):
        return [(HALF + a * half, HALF + b * half, Q(z)) for a, b in mf.CYCLE]
    low, high, inner, dip = ring(Q(1, 4), 0), ring(Q(1, 4), 1), ring(Q(1, 8), 1), (HALF, HALF, Q(7, 8))
    facets = [low]
    for k, n in zip(range(4), (1, 2, 3, 0)):
        facets += [(low[k], low[n], high[n], high[k]), (high[k], high[n], inner[n], inner[k]), (inner[k], inner[n], dip)]
    return mf.polyhedron("cup", facets)


def facet_of_hole():
    return mf.facet([(HALF + a * Q(1, 8), HALF + b * Q(1, 8), Q(1)) for a, b in mf.CYCLE], mf.MIDDLE)


def raised(patch):
    """The patch in the degrees (2, 2)."""
    def line(p, q):
        return [p, tuple((a + b) / 2 for a, b in zip(p, q)), q]
    lists = []
    for p00, p01, p10, p11 in patch.points:
        columns = zip(line(p00, p10), line(p01, p11))
        lists.append([x for a, b in columns for x in line(a, b)])
    return Patch(lists, (2, 2), patch.wall)


class Judged(unittest.TestCase):
    def judge(self, text, certificate, *expected):
        code, condition, printed = judges.in_cpp(text, certificate)
        self.assertEqual((code, condition), expected, printed)

    def accept(self, micro, *numbers, options=()):
        self.judge(*mf.certified(micro, numbers, VERITOPE, *options), 0, "ACCEPT")

    def reject(self, micro, condition, *, options=(), numbers=None):
        self.judge(*mf.certified(micro, numbers or (0,) * 6, VERITOPE, *options), 1, condition)

    def refuse(self, micro, **members):
        text, certificate = mf.certified(micro, (0,) * 6, VERITOPE, members=members)
        self.judge(text, certificate, 4, "")


class Honest(Judged):
    def test_blocks_of_jacks_have_the_genus_of_their_graphs(self):
        for n in ((1, 1, 1), (1, 1, 2), (2, 2, 2), (3, 2, 4)):
            self.accept(Micro([Grid.block(n)], [mf.jack()]), *jack_numbers(*n))
            graded = Grid.block(n, numbers=lambda axis, i, j, k: 7919 * (1 + axis + 3 * i + 5 * j + 7 * k))
            self.accept(Micro([graded], [mf.jack(slope=Q(1, 16))]), *jack_numbers(*n))

    def test_tiles_that_do_not_touch_are_components(self):
        cells = {i: 0 for i in itertools.product(range(3), repeat=3) if sum(i) % 2 == 0}
        board = Grid([[Q(i, 3) for i in range(4)]] * 3, cells)
        self.accept(Micro([board], [mf.jack()]), 27, 14, 0, 14, 14, 0)
        across = mf.rod(axis=0)
        self.accept(Micro([Grid.block((2, 2, 1))], [across]), 4, 4, 2, 2, 2, 0)
        self.accept(Micro([Grid.block((1, 1, 2))], [across]), 2, 2, 0, 2, 2, 0)
        self.accept(Micro([], [across]), 0, 0, 0, 0, 0, 0)

    def test_an_annulus_as_a_cap_closes_a_void(self):
        below = cup()
        above = below.turned((0, 1, 2), (0, 0, 1))
        self.accept(one(below), 1, 1, 0, 1, 1, 0)
        self.accept(stack(below, above), 2, 2, 1, 1, 2, 0)
        self.accept(stack(above, below, above), 3, 3, 2, 1, 2, 0)
        disk = mf.rod(axis=2)
        self.reject(stack(below, disk), "T4")              # the disk covers the annulus

    def test_caps_are_equal_in_other_degrees_and_turned(self):
        rod, tile = mf.rod(), mf.rod()
        top = tile.patches[1]
        tile.patches[1] = top.mapped(lambda x: x)          # the other direction of one parameter, then the parameters exchanged
        for turns in range(4):
            p00, p01, p10, p11 = tile.patches[1].points[0]
            tile.patches[1] = Patch([[p10, p00, p11, p01]])
            self.accept(stack(tile, rod), 2, 2, 1, 1, 1, 0)
        tile.patches[1] = raised(tile.patches[1])
        self.accept(stack(tile, rod), 2, 2, 1, 1, 1, 0)
        self.accept(stack(rod, tile.turned((0, 1, 2), (0, 0, 1))), 2, 2, 1, 1, 1, 0)

    def test_caps_of_several_patches_are_equal_patch_for_patch(self):
        keel = mf.keel(ridge=Q(1, 16))
        self.accept(stack(keel.turned((0, 1, 2), (0, 0, 1)), keel), 2, 2, 2, 1, 1, 1)
        one_patch = mf.rod(first=(Q(1, 8), Q(1, 4)), second=(Q(3, 8), Q(5, 8)))
        self.reject(stack(one_patch, keel), "T4")          # the same square, cut into two patches on one side

    def test_equal_at_their_numbers_though_not_as_families(self):
        tiles = mf.jack(half=Q(1, 8), slope=Q(1, 16)), mf.jack(half=Q(3, 16), slope=-Q(1, 16))
        self.accept(stack(*tiles, numbers=lambda axis, i, j, k: WHOLE // 2), 2, 2, 1, 1, 1, 0)
        self.reject(stack(*tiles, numbers=lambda axis, i, j, k: WHOLE // 2 + 1), "T4")

    def test_a_range_of_one_number(self):
        tile = mf.jack(slope=Q(1, 16)).copy(range=(5, 5))
        self.accept(one(tile, numbers=lambda *i: 5), 1, 1, 0, 1, 1, 0)
        self.reject(one(tile, numbers=lambda *i: 6), "G1")


class Cages(Judged):
    def test_grids_of_one_volume_meet(self):
        coarse, fine = mf.rod(first=(Q(1, 8), Q(3, 8)), second=(Q(1, 8), Q(3, 8))), mf.rod()
        tiles = [coarse, fine, mf.jack()]
        below = Grid([[0, 1], [0, 1], [0, HALF]], {(0, 0, 0): 0})
        above = Grid([[0, HALF, 1], [0, HALF, 1], [HALF, 1]], {(0, 0, 0): 1, (0, 1, 0): 2, (1, 1, 0): 2})
        self.accept(Micro([below, above], tiles), 5, 4, 2, 2, 2, 0)
        self.accept(Micro([above, below], tiles), 5, 4, 2, 2, 2, 0)
        under = Grid([*above.breaks[:2], [0, HALF]], above.cells)
        over = Grid([[0, 1], [0, 1], [HALF, 1]], {(0, 0, 0): 0})
        self.accept(Micro([under, over], tiles), 5, 4, 2, 2, 2, 0)
        moved = Grid(above.breaks, {(0, 0, 0): 2})
        self.reject(Micro([below, moved], tiles), "T4")
        apart = Grid(above.breaks, {(1, 0, 0): 1, (0, 1, 0): 1})
        self.accept(Micro([below, apart], tiles), 5, 3, 0, 3, 3, 0)
        uneven = Grid([[0, Q(1, 3), 1], [0, 1], [HALF, 1]], {(0, 0, 0): 1, (1, 0, 0): 1})
        self.reject(Micro([below, uneven], tiles), "T4")

    def test_numbers_of_two_grids_are_compared(self):
        tile = mf.jack(slope=Q(1, 16))
        for above, verdict in ((3, None), (4, "T4")):
            grids = [Grid([[0, 1], [0, 1], [0, HALF]], {(0, 0, 0): 0}, numbers=lambda *i: 3),
                     Grid([[0, 1], [0, 1], [HALF, 1]], {(0, 0, 0): 0}, numbers=lambda *i, n=above: n)]
            if verdict is None:
                self.accept(Micro(grids, [tile]), 2, 2, 1, 1, 1, 0)
            else:
                self.reject(Micro(grids, [tile]), verdict)

    def test_a_smaller_cap_of_a_finer_grid_is_equal_at_its_numbers(self):
        """The cell below is twice as wide, and its arm goes to the quarter of the wall that the cell above covers."""
        small = mf.rod(first=(Q(3, 16), Q(5, 16)), second=(Q(3, 16), Q(5, 16)))
        graded = mf.jack(slope=Q(1, 8))                    # half side 1/8 + t / 8 of a cell of half the width
        below = Grid([[0, 1], [0, 1], [0, HALF]], {(0, 0, 0): 0})
        for number, verdict in ((0, True), (1, False)):
            above = Grid([[0, HALF], [0, HALF], [HALF, 1]], {(0, 0, 0): 1}, numbers=lambda *i, n=number: n)
            micro = Micro([below, above], [small, graded])
            self.accept(micro, 2, 2, 1, 1, 1, 0) if verdict else self.reject(micro, "T4")

    def glued_along_x(self, order, flips, options):
        """A bar along x through two volumes, of which the second has other parameters."""
        bar = mf.rod(axis=0, first=(Q(1, 8), Q(3, 8)), second=(Q(1, 4), Q(5, 8)))
        cage = [mf.volume(), mf.volume(lambda x, y, z: (x + 1, y, z), order, flips)]
        grids = [Grid.block((1, 1, 1)), Grid.block((1, 1, 1), tile=1, volume=1)]
        self.accept(Micro(grids, [bar, bar.turned(order, flips)], cage), 2, 2, 1, 1, 1, 0, options=options)
        wrong = mf.rod(axis=0, first=(Q(1, 16), Q(3, 8)), second=(Q(1, 4), Q(5, 8)))
        self.reject(Micro(grids, [bar, wrong.turned(order, flips)], cage), "T4", options=options)

    def test_two_volumes_are_glued_under_every_symmetry(self):
        codes = set()
        for order in itertools.permutations(range(3)):
            for flips in itertools.product((0, 1), repeat=3):
                is_odd = (sum(flips) + (order not in ((0, 1, 2), (1, 2, 0), (2, 0, 1)))) % 2 == 1
                with self.subTest(order=order, flips=flips):
                    self.glued_along_x(order, flips, ("--orient", "auto") if is_odd else ())
                along = [k for k in range(3) if order[k] != 0]
                codes.add((order[along[0]], flips[along[0]], flips[along[1]]))
        self.assertEqual(len(codes), 8)

    def test_domains_of_glued_volumes_may_differ(self):
        bar = mf.rod(axis=0, first=(Q(1, 8), Q(3, 8)), second=(Q(1, 4), Q(5, 8)))
        cage = [mf.volume(), mf.volume(lambda x, y, z: (x + 1, y, z), domain=(1, 3))]
        cells = {(0, 0, 0): 0, (0, 1, 0): 0}
        grids = [Grid([[0, 1], [0, HALF, 1], [0, 1]], cells), Grid([[1, 2], [1, 2, 3], [1, 3]], cells, volume=1)]
        self.accept(Micro(grids, [bar], cage), 4, 4, 2, 2, 2, 0)
        grids[1] = Grid([[1, 2], [1, Q(3, 2), 3], [1, 3]], cells, volume=1)
        self.reject(Micro(grids, [bar], cage), "T4")
        grids[1] = Grid([[2, 3], [1, 2, 3], [1, 3]], cells, volume=1)          # not at the face
        self.accept(Micro(grids, [bar], cage), 4, 4, 0, 4, 4, 0)

    def test_finer_grids_across_a_turned_face(self):
        """Cells of one size in the first volume, and of half the size in the second one, whose face is turned."""
        for order, flips in (((0, 1, 2), (0, 0, 0)), ((0, 2, 1), (0, 1, 0)), ((1, 0, 2), (0, 1, 0)), ((0, 1, 2), (0, 1, 1)), ((2, 0, 1), (1, 0, 1))):
            quarter = mf.rod(axis=0, first=(Q(1, 8), Q(3, 8)), second=(Q(5, 8), Q(7, 8)))    # (y, z) in [0, 1/2] x [1/2, 1]
            square = mf.rod(axis=0).turned(order, flips)
            cage = [mf.volume(), mf.volume(lambda x, y, z: (x + 1, y, z), order, flips)]
            halves = {0: [0, 1], 1: [0, HALF, 1], 2: [0, HALF, 1]}
            wanted = (0, 0, 1)                             # the cell in the directions of space
            cell = tuple((len(halves[order[k]]) - 2 - wanted[order[k]]) if flips[k] else wanted[order[k]] for k in range(3))
            options = ("--orient", "auto")
            every = itertools.product(*(range(len(halves[order[k]]) - 1) for k in range(3)))
            for other in every:
                grids = [Grid.block((1, 1, 1)), Grid([halves[order[k]] for k in range(3)], {other: 1}, volume=1)]
                glued = int(other == cell)
                self.accept(Micro(grids, [quarter, square], cage), 5, 2, glued, 2 - glued, 2 - glued, 0, options=options)

    def built(self, surface, **more):
        """The cells of a surface that is turned about the axis z."""
        tree = {"format": "veritope-tree-1", "root": {"op": "revolve", "point": [0, 0, 0], "axis": [0, 0, 1], "surface": surface, **more}}
        with tempfile.TemporaryDirectory() as folder:
            tree_file, model = pathlib.Path(folder, "tree.json"), pathlib.Path(folder, "model.vjson")
            tree_file.write_text(json.dumps(tree))
            done = subprocess.run([VERITOPE, "build", tree_file, "-o", model], capture_output=True, text=True, timeout=300, check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            return json.loads(model.read_text())["entities"]

    def rectangle(self, inner):
        return {"degrees": [1, 1], "periodic": [False, False], "knots": [["0", "0", "1", "1"]] * 2, "rational": False, "components": 3,
                "points": [[str(x), "0", str(z)] for z in (0, 1) for x in (inner, 3)]}

    def along_last(self, cage):
        """The breaks of the first volume's third axis, which goes around."""
        return sorted({Q(t) for t in cage[0]["shape"]["knots"][2]})

    def test_a_ring_is_glued_to_itself(self):
        cage = self.built(self.rectangle(2))
        self.assertEqual(len(cage), 1)
        around = self.along_last(cage)
        n = len(around) - 1
        cells = {(0, 0, k): 0 for k in range(n)}
        self.accept(Micro([Grid([[0, 1], [0, 1], around], cells)], [mf.rod()], cage), n, n, n, 1, 1, 1)
        taper, widen = self.taper(), self.taper().turned((0, 1, 2), (0, 0, 1))
        mixed = {(0, 0, k): k % 2 for k in range(n)}
        self.accept(Micro([Grid([[0, 1], [0, 1], around], mixed)], [taper, widen], cage), n, n, n, 1, 1, 1)
        mixed[0, 0, n - 1] = 0
        self.reject(Micro([Grid([[0, 1], [0, 1], around], mixed)], [taper, widen], cage), "T4")
        open_at_the_seam = Grid([[0, 1], [0, 1], around], {(0, 0, k): 0 for k in range(1, n)})
        self.accept(Micro([open_at_the_seam], [mf.rod()], cage), n, n - 1, n - 2, 1, 1, 0)

    def test_a_cell_is_glued_to_itself(self):
        """A closed curve of one polynomial piece, star-shaped around the axis z, times its distance from the axis."""
        curve = ((0, -1), (4, -1), (3, 3), (-3, 3), (-4, -1), (0, -1))
        ring = mf.volume()
        ring["shape"].update(degrees=[1, 1, 5], knots=[["0", "0", "1", "1"], ["0", "0", "1", "1"], ["0"] * 6 + ["1"] * 6],
                             points=[[str(r * x), str(r * y), str(z)] for r in (1, 2) for z in (0, 1) for x, y in curve])
        auto = ("--orient", "auto")
        self.accept(Micro([Grid.block((1, 1, 1))], [mf.rod()], [ring]), 1, 1, 1, 1, 1, 1, options=auto)
        taper, widen = self.taper(), self.taper().turned((0, 1, 2), (0, 0, 1))
        self.reject(Micro([Grid.block((1, 1, 1))], [taper], [ring]), "T4", options=auto)
        self.accept(Micro([Grid([[0, 1], [0, 1], [0, HALF, 1]], {(0, 0, 0): 0, (0, 0, 1): 1})], [taper, widen], [ring]), 2, 2, 2, 1, 1, 1,
                    options=auto)

    def taper(self):
        low, high = self.square(Q(1, 4), 0), self.square(Q(1, 8), 1)
        return mf.polyhedron("taper", [low, high] + [(low[k], low[n], high[n], high[k]) for k, n in ((0, 1), (1, 2), (2, 3), (3, 0))])

    def square(self, half, z):
        return [(HALF + a * half, HALF + b * half, Q(z)) for a, b in mf.CYCLE]

    def test_no_cap_lies_in_a_collapsed_wall(self):
        cage = self.built(self.rectangle(0))
        around = self.along_last(cage)
        n = len(around) - 1
        breaks = [[0, 1], [0, HALF, 1], around]
        inner, outer = {(0, 0, k): 0 for k in range(n)}, {(0, 1, k): 0 for k in range(n)}
        self.accept(Micro([Grid(breaks, outer)], [mf.jack()], cage), 2 * n, n, n, 1, 1, 1)
        self.reject(Micro([Grid(breaks, inner)], [mf.jack()], cage), "G2")
        five = mf.jack(walls=(0, 1, 3, 4, 5))
        self.accept(Micro([Grid(breaks, inner)], [five], cage), 2 * n, n, n, 1, 1, 1)
        clear = Grid([[0, 1], [Q(1, 4), 1], around], inner)
        self.accept(Micro([clear], [mf.jack()], cage), n, n, n, 1, 1, 1)

    def test_left_handed_cells(self):
        cage = [mf.volume(order=(1, 0, 2))]
        self.accept(Micro([Grid.block((2, 2, 2))], [mf.jack()], cage), *jack_numbers(2, 2, 2), options=("--orient", "auto"))

    def test_the_conditions_of_the_cage(self):
        cage = [mf.volume(), mf.volume(lambda x, y, z: (x + 1, y, z))]
        micro = Micro([Grid.block((1, 1, 1))], [mf.jack()], cage)
        text, body = micro.text(), mf.cage_body(micro.cage_text(), VERITOPE)
        numbers = {**dict(zip(mf.NUMBERS, (1, 1, 0, 1, 1, 0))), "bridges": 0}
        first = mf.hints(micro.tiles)
        self.judge(text, mf.certificate(text, first + body, numbers), 0, "ACCEPT")
        at = 4 + 4 + 2 + 6                                 # after magic, count, flags and six counts of breaks: the codes
        changes = {0: (b"V"[0] ^ 1, "B1"), 8: (1, "V2"), at: (1, "V1"), at + 1: (2, "V3")}
        for place, (value, condition) in changes.items():
            lie = body[:place] + bytes([value]) + body[place + 1:]
            self.judge(text, mf.certificate(text, first + lie, numbers), 1, condition)
        self.judge(text, mf.certificate(text, first + body[:-1], numbers), 1, "B1")
        self.judge(text, mf.certificate(text, first + body + b"\0", numbers), 1, "B1")
        overlap = [mf.volume(), mf.volume(lambda x, y, z: (x + HALF, y, z))]
        with self.assertRaises(ValueError):
            mf.certified(Micro([], [mf.jack()], overlap), (0,) * 6, VERITOPE)


class Lies(Judged):
    def test_b1(self):
        micro = one(mf.jack())
        text, cage = micro.text(), mf.cage_body(micro.cage_text(), VERITOPE)
        honest = mf.hints(micro.tiles)
        for body in (b"VTMT" + honest[4:], mf.hints(micro.tiles, (), 0), mf.hints(micro.tiles, (), 2),
                     mf.hints(micro.tiles, (), 1 << 31), honest[:-1], mf.hints([micro.tiles[0].copy(exit=30)]), honest[:13] + b"\4\4" + honest[15:],
                     honest[:8] + b"\1" + honest[9:], honest[:12] + b"\2" + honest[13:], honest[:12] + b"\1\377\0\0\0" + honest[13:]):
            self.judge(text, mf.certificate(text, body + cage, dict.fromkeys((*mf.NUMBERS, "bridges"), 0)), 1, "B1")

    def test_b2(self):
        for centre in ((HALF, HALF, 0), (1, HALF, HALF), (HALF, -HALF, HALF), (HALF, Q(3, 2), HALF), (HALF, HALF, Q(1, 1 << 64))):
            self.reject(one(mf.jack().copy(centre=centre)), "B2")
        near = Q(1 << 63, (1 << 64) - 1)                   # its numbers are short enough, but the exit's middle is elsewhere
        self.reject(one(mf.jack().copy(centre=(HALF, HALF, near))), "F2")
        big = Patch([[(HALF, HALF, HALF)] * 64] * 4, (7, 7), 0)
        tile = mf.jack(slope=Q(1, 16))
        tile.patches += [big] * 60
        self.reject(one(tile), "B2")                       # 60 patches of 4410 coefficients

    def test_s0(self):
        for number in (0, 7, 29):
            gone = jack_or(lambda patches, k=number: patches.pop(k))
            self.reject(one(gone.copy(exit=1 if number else 0)), "S0")
        self.reject(one(jack_or(lambda patches: patches.append(patches[5]))), "S0")
        flipped = jack_or(lambda patches: patches.__setitem__(3, patches[3].mapped(lambda x: x, turn=True)))
        self.reject(one(flipped), "S0")

    def test_s0_sides_agree_for_every_number(self):
        """The sides of an arm agree at t = 0 only."""
        still, moving = mf.jack(), mf.jack(slope=Q(1, 16))
        self.reject(one(moving.copy(patches=[*moving.patches[:-1], still.patches[-1]])), "S0")
        other = moving.patches[1]
        renamed = moving.copy(patches=[moving.patches[0], Patch(other.points, other.degrees, 2), *moving.patches[2:]])
        self.reject(one(renamed), "S0")

    def test_s0_no_side_is_its_own_opposite(self):
        fold = [(Q(1, 4), HALF, HALF), (Q(3, 4), HALF, HALF), (Q(1, 4), HALF, HALF)]
        points = [[tuple(a + b for a, b in zip(p, (0, 0, z))) for p in fold for z in (0, Q(1, 8))]]
        self.reject(one(Tile("fold", [Patch(points, (2, 1))])), "S0")

    def test_f1(self):
        inside_out = jack_or(lambda patches: patches.__setitem__(slice(None), [s.mapped(lambda x: x, turn=True) for s in patches]))
        self.reject(one(inside_out), "F1")
        self.reject(one(mf.jack().copy(centre=(HALF, HALF, Q(1, 32)))), "F1")
        wide = mf.jack(half=Q(1, 8), slope=Q(3, 8), core=Q(3, 8))      # the arms' sides turn inward of the middle for no number
        self.reject(one(wide.copy(centre=(HALF, HALF, Q(1, 16)))), "F1")

    def test_f1_for_every_number_of_the_range(self):
        """The middle is so low that arms to x = 0 show it their other side from t = 1/2 on."""
        tile = mf.jack(slope=Q(1, 4), core=Q(1, 8)).copy(centre=(HALF, Q(5, 12), HALF), exit=2)
        for last, verdict in ((1 << 18, True), ((1 << 19) - 1, True), (1 << 19, False), (WHOLE, False)):
            short = one(tile.copy(range=(0, last)))
            self.accept(short, 1, 1, 0, 1, 1, 0) if verdict else self.reject(short, "F1")

    def test_f1_collapsed_sides_share_no_corner(self):
        a, b = (HALF, HALF, Q(7, 8)), (Q(1, 4), HALF, HALF)
        folded = Patch([[a, a, a, b]])                     # its other two sides are opposite curves
        self.reject(one(jack_or(lambda patches: patches.append(folded))), "F1")

    def test_f2(self):
        self.reject(one(mf.twice_wound()), "F2")
        self.reject(one(mf.jack().copy(exit=8)), "F2")     # a side of an arm
        self.accept(one(mf.jack().copy(exit=2)), 1, 1, 0, 1, 1, 0)
        self.reject(one(mf.jack().copy(centre=(HALF, HALF + Q(1, 64), HALF))), "F2")
        self.reject(one(mf.jack().copy(centre=(HALF + Q(1, 64), HALF, HALF), exit=4)), "F2")
        bigger = jack_or(lambda patches: patches.__setitem__(0, raised(patches[0])))
        self.reject(one(bigger), "F2")
        self.accept(one(bigger.copy(exit=3)), 1, 1, 0, 1, 1, 0)

    def test_f2_looks_beyond_the_exit(self):
        def shrunk(x):
            return tuple(HALF + (c - HALF) / 4 for c in x)
        inner = [s.mapped(shrunk) for s in mf.jack().patches]
        self.accept(one(mf.Tile("inner", inner)), 1, 1, 0, 1, 1, 0)         # without caps
        both = mf.jack().patches + inner
        self.reject(one(mf.Tile("nested", both, exit=len(inner))), "F2")    # the outer surface lies between the exit and the wall
        self.reject(one(mf.Tile("nested", both)), "F2")

    def test_f2_needs_a_parallelogram(self):
        def change(patches):
            def moved(p):                                  # a trapezoid around the same middle
                return (*p[:2], HALF + Q(3, 2) * (p[2] - HALF)) if p[:2] == (0, HALF + Q(1, 8)) else p
            patches[:] = [Patch([list(map(moved, s.points[0]))]) for s in patches]
        self.reject(one(jack_or(change)), "F2")
        self.accept(one(jack_or(change).copy(exit=2)), 1, 1, 0, 1, 1, 0)

    def test_t2_caps_stay_off_the_other_walls(self):
        wide = mf.rod(first=(Q(0), Q(3, 4)))
        self.reject(one(wide), "T2")
        self.reject(one(mf.rod(first=(Q(0), Q(1)), second=(Q(0), Q(1)))), "T2")
        self.accept(one(mf.rod(first=(Q(1, 1 << 40), 1 - Q(1, 1 << 40)))), 1, 1, 0, 1, 1, 0)

    def test_t2_nothing_leaves_the_cube(self):
        out = jack_or(lambda patches: patches.__setitem__(slice(None), [s.mapped(lambda x: (x[0], 2 * x[1] - HALF, x[2])) for s in patches]))
        self.reject(one(out), "T2")                        # arms end outside
        through = mf.rod(first=(-Q(1, 8), Q(3, 4)))
        self.reject(one(through), "T2")

    def test_t2_no_coefficient_is_outside(self):
        """The middle coefficient of a side lies outside of the cube, though its points do not."""
        for x, verdict in ((Q(0), True), (-Q(1, 1 << 20), False)):
            def bulge(patches, middle=x):
                k = next(k for k, s in enumerate(patches) if all(p[0] == Q(1, 8) for p in s.points[0]))
                patches[k] = raised(patches[k])
                patches[k].points[0][4] = (middle, HALF, HALF)
            tile = mf.rod(first=(Q(1, 8), Q(3, 4)))
            bulge(tile.patches)
            self.accept(one(tile), 1, 1, 0, 1, 1, 0) if verdict else self.reject(one(tile), "T2")

    def test_t2_a_body_between_caps_in_a_wall(self):
        """The hole of an annulus, whose sides are all sides of the cap, and which rises from the wall where t > 0."""
        tile = cup()
        annulus = [s for s in tile.patches if (HALF, HALF, Q(7, 8)) not in s.points[0]]
        hole = raised(facet_of_hole())
        dip = [[(Q(0),) * 3] * 9]
        dip[0][4] = (Q(0), Q(0), -Q(1, 8))
        tile = tile.copy(patches=[*annulus, Patch([hole.points[0], dip[0]], (2, 2), 5)], range=(0, WHOLE))
        self.reject(one(tile), "T2")
        self.accept(one(tile.copy(range=(1, WHOLE)), numbers=lambda *i: 1), 1, 1, 0, 1, 1, 0)

    def test_t2_a_side_in_a_wall(self):
        self.reject(one(mf.keel()), "T2")
        self.accept(one(mf.keel(ridge=Q(1, 1 << 30))), 1, 1, 0, 1, 1, 0)
        crossing = mf.keel().turned((1, 0, 2), (0, 0, 1))
        self.reject(stack(crossing, mf.keel()), "T2")
        self.reject(stack(crossing), "T2")

    def test_t2_a_corner_in_a_wall(self):
        """The corner of an octahedron's like touches x = 0, where no cap is."""
        def tile(x):
            ring = [(HALF + a * Q(1, 4), HALF + b * Q(1, 4), Q(0)) for a, b in mf.CYCLE]
            top = [(HALF + a * Q(1, 8), HALF + b * Q(1, 8), Q(1)) for a, b in mf.CYCLE]
            tip = (Q(x), HALF, HALF)
            left, sides = (ring[3], ring[0], top[0], top[3]), ((0, 1), (1, 2), (2, 3))
            facets = [ring, top] + [(ring[a], ring[b], top[b], top[a]) for a, b in sides]
            facets += [(tip, left[k], left[(k + 1) % 4]) for k in range(4)]
            return mf.polyhedron("tip", facets)
        self.reject(one(tile(0)), "T2")
        self.accept(one(tile(Q(1, 1 << 20))), 1, 1, 0, 1, 1, 0)

    def test_t2_a_body_in_a_wall_for_one_number(self):
        """The arm's end leaves its wall except where t = 0: the patch lies in no wall, and touches one."""
        tile = mf.jack(slope=Q(1, 16))
        for k in (0, *range(6, 10)):
            s = tile.patches[k]
            still, moves = s.points
            lifted = [(m[0] + Q(1, 16) * (p[0] == 0), *m[1:]) for p, m in zip(still, moves)]
            tile.patches[k] = Patch([still, lifted], s.degrees, s.wall)
        self.reject(one(tile.copy(exit=1)), "T2")
        self.accept(one(tile.copy(exit=1, range=(1, 1 << 20)), numbers=lambda *i: 1), 1, 1, 0, 1, 1, 0)

    def test_t3(self):
        self.reject(one(mf.pinched()), "T3")
        self.reject(stack(mf.pinched(), mf.pinched()), "T3")

    def test_g1(self):
        tile = mf.jack(slope=Q(1, 16)).copy(range=(10, 20))
        for number, condition in ((10, None), (20, None), (9, "G1"), (21, "G1")):
            micro = one(tile, numbers=lambda *i, n=number: n)
            self.accept(micro, 1, 1, 0, 1, 1, 0) if condition is None else self.reject(micro, condition)
        only_x = mf.jack(walls=(0,), slope=Q(1, 16)).copy(range=(10, 20))
        self.accept(one(only_x, numbers=lambda axis, i, j, k: 10 if axis == 0 and i == 0 else 99), 1, 1, 0, 1, 1, 0)
        self.reject(one(only_x, numbers=lambda axis, i, j, k: 99), "G1")

    def test_t4(self):
        jack, wider, thin = mf.jack(), mf.jack(half=Q(3, 16)), mf.rod(first=(Q(1, 8), Q(1, 4)))
        self.reject(stack(jack, wider), "T4")
        self.reject(stack(jack, mf.rod(first=(Q(3, 8), Q(5, 8) + Q(1, 1 << 60)), second=(Q(3, 8), Q(5, 8)))), "T4")
        self.accept(stack(jack, mf.rod(first=(Q(3, 8), Q(5, 8)), second=(Q(3, 8), Q(5, 8)))), 2, 2, 1, 1, 1, 0)
        self.accept(stack(jack, thin), 2, 2, 0, 2, 2, 0)
        self.reject(stack(jack, mf.rod(first=(Q(1, 8), Q(3, 8)))), "T4")       # closed caps touch in a side
        turned = mf.rod(first=(Q(1, 4), HALF), second=(Q(1, 4), Q(5, 8)))
        self.reject(stack(turned, turned.turned((1, 0, 2), (0, 0, 0))), "T4")
        self.accept(stack(turned, turned), 2, 2, 1, 1, 1, 0)

    def test_t4_is_asked_along_every_axis(self):
        for axis in range(3):
            n = [1, 1, 1]
            n[axis] = 2
            cells = {(0, 0, 0): 0, tuple(int(a == axis) for a in range(3)): 1}
            breaks = [[Q(i, m) for i in range(m + 1)] for m in n]
            self.reject(Micro([Grid(breaks, cells)], [mf.jack(), mf.jack(half=Q(3, 16))]), "T4")
            self.accept(Micro([Grid(breaks, cells)], [mf.jack(), mf.jack()]), 2, 2, 1, 1, 1, 0)

    def test_w3(self):
        honest = jack_numbers(2, 2, 2)
        for k in range(6):
            for step in (-1, 1):
                lie = [n + step * (i == k) for i, n in enumerate(honest)]
                self.reject(Micro([Grid.block((2, 2, 2))], [mf.jack()]), "W3", numbers=lie)

    def test_conditions_come_in_their_order(self):
        both = jack_or(lambda patches: patches.pop(0), half=Q(3, 16))
        self.reject(Micro([Grid.block((1, 1, 1))], [mf.keel(), both]), "T2")   # the first tile's before the second one's S0
        self.reject(Micro([Grid.block((1, 1, 1))], [both, mf.keel()]), "S0")
        unused = mf.pinched()
        self.reject(Micro([Grid.block((1, 1, 1))], [mf.jack(), unused]), "T3")  # tiles that no cell holds, too


def straight(tile, cell, wall, length, *, grid=None, cuts=(), turn=False, left=False, **others):
    """A bridge that goes straight from a cap of one patch to `length` beyond its wall, in one volume. grid: where the cell is. turn: its first two
    parameters are turned by a right angle. left: they change places, so that it is left-handed."""
    place, axis, end = grid or Grid.block((1, 1, 1)), wall // 2, wall % 2
    n = place.size()
    index = cell // (n[1] * n[2]), cell // n[2] % n[1], cell % n[2]
    cap = next(s for s in tile.patches if all(p[axis] == end for p in s.points[0]))
    lo, hi = ([place.breaks[a][index[a] + e] for a in range(3)] for e in (0, 1))
    points = [tuple(lo[a] + (hi[a] - lo[a]) * p[a] for a in range(3)) for p in cap.points[0]]
    if turn:
        points = [points[1], points[3], points[0], points[2]]
    lists = [[(*p[:axis], p[axis] + (1 if end else -1) * length * Q(k, 2), *p[axis + 1:]) for p in points] for k in range(3)]
    lists = righted(lists)
    if left:
        lists = [[p[0], p[2], p[1], p[3]] for p in lists]
    return mf.Bridge.along(lists, cell, wall, cuts=cuts, **{"matrix": inverse_of(lists), **others})


def righted(lists):
    """The bridge with these lists, right-handed."""
    a = lists[0]
    if mf.determinant(*(mf.subtract(x, a[0]) for x in (a[2], a[1], lists[1][0]))) > 0:
        return lists
    return [[p[0], p[2], p[1], p[3]] for p in lists]


def inverse_of(lists):
    """K: the signs of the inverse of J at a corner, whose columns are parallel to axes."""
    a = lists[0]
    columns = [mf.subtract(x, a[0]) for x in (a[2], a[1], lists[1][0])]
    return tuple((x > 0) - (x < 0) for column in columns for x in column)


class Bridges(Judged):
    COLUMN = Grid([[0, 1], [0, 1], [Q(i, 4) for i in range(5)]], {(0, 0, 0): 0})    # one cell with a tile below three empty ones

    def column(self, *bridges, tile=None, cells=None, grid=None, cage=None):
        place = grid or Grid(self.COLUMN.breaks, cells or self.COLUMN.cells)
        return Micro([place], [tile or mf.rod()], cage, bridges=bridges)

    def up(self, length=Q(1, 2), **others):
        """From the first cell of the column upward, with the orientation of J that K can meet."""
        return straight(mf.rod(), 0, 5, length, grid=self.COLUMN, **others)

    def accept_column(self, *bridges, **others):
        self.accept(self.column(*bridges, **others), 4, 1, 0, 1, 1, 0)

    def test_straight_bridges(self):
        for turn in (False, True):
            for length in (Q(1, 8), Q(1, 2), Q(3, 4) - Q(1, 1 << 60)):
                self.accept_column(self.up(length, turn=turn))
                self.accept_column(self.up(length, turn=turn, cuts=(Q(1, 3), HALF)))
        self.accept(one(mf.jack(), numbers=None), 1, 1, 0, 1, 1, 0)
        five = Grid([[Q(i, 3) for i in range(4)]] * 3, {(1, 1, 1): 0})
        jack = mf.jack()
        every = [straight(jack, 13, wall, Q(1, 4), grid=five) for wall in range(6)]
        self.accept(Micro([five], [jack], bridges=every), 27, 1, 0, 1, 1, 0)

    def test_a_bridge_from_a_wall_with_a_number(self):
        jack = mf.jack(slope=Q(1, 16))
        for number, verdict in ((1 << 19, True), ((1 << 19) + 1, False)):
            grid = Grid(self.COLUMN.breaks, self.COLUMN.cells, numbers=lambda *i, n=number: n)
            bridge = straight(mf.jack(half=Q(5, 32)), 0, 5, Q(1, 4), grid=grid)
            micro = self.column(bridge, tile=jack, grid=grid)
            self.accept(micro, 4, 1, 0, 1, 1, 0) if verdict else self.reject(micro, "R2")

    def test_b1(self):
        self.reject(self.column(self.up(cuts=(HALF, HALF))), "B1")
        self.reject(self.column(self.up(cuts=(HALF, Q(1, 3)))), "B1")
        self.reject(self.column(self.up(cuts=(0,))), "B1")
        self.reject(self.column(self.up(cuts=(1,))), "B1")
        self.reject(self.column(self.up(cuts=(-HALF,))), "B1")
        micro = self.column(self.up())
        text, cage, numbers = micro.text(), mf.cage_body(micro.cage_text(), VERITOPE), {**dict(zip(mf.NUMBERS, (4, 1, 0, 1, 1, 0))), "bridges": 1}
        honest = mf.hints(micro.tiles, micro.bridges)
        self.judge(text, mf.certificate(text, honest + cage, numbers), 0, "ACCEPT")
        self.judge(text, mf.certificate(text, honest + cage, {**numbers, "bridges": 0}), 1, "W3")
        for body in (mf.hints(micro.tiles), mf.hints(micro.tiles, micro.bridges * 2), honest[:-1] + b"\0", honest[:-1], honest + b"\0"):
            self.judge(text, mf.certificate(text, body + cage, numbers), 1, "B1")

    def test_b2(self):
        self.reject(self.column(self.up(matrix=[1 << 64, *[0] * 7, 1])), "B2")
        self.reject(self.column(self.up(cuts=(Q(1, 1 << 64),))), "B2")
        self.accept_column(self.up(matrix=[k * ((1 << 64) - 1) for k in self.up().matrix], cuts=(Q(1, (1 << 64) - 1),)))
        long = self.up()
        long.points[2] = (*long.points[2][:2], Q(1, 1 << 2303) + long.points[2][2])
        self.accept_column(long)
        for k, prime in enumerate((3, 5, 7, 11)):          # a common denominator of more than 8192 bits
            x = long.points[3 * k + 2]
            power = prime ** int(2290 / math.log2(prime))
            long.points[3 * k + 2] = (*x[:2], HALF + Q(1, power))
        self.reject(self.column(long), "B2")

    def test_r1(self):
        good = self.up()
        k = good.matrix
        self.accept_column(good)
        self.accept_column(self.up(matrix=[Q(x, 3) for x in k]))
        for matrix in ((0,) * 9, [-x for x in k], (*k[:6], *(-x for x in k[6:])), (*(-x for x in k[:6]), *k[6:])):
            self.reject(self.column(self.up(matrix=matrix)), "R1")
        left = self.up(left=True)                          # det J < 0, so det K < 0 where K J is positive
        self.reject(self.column(left), "R1")
        left.matrix = k
        self.reject(self.column(left), "R1")
        back = self.up()
        for k in range(4):                                 # turns back at the end: list 2 is below list 1
            x = back.points[3 * k + 2]
            back.points[3 * k + 2] = (*x[:2], back.points[3 * k + 1][2] - Q(1, 16))
        self.reject(self.column(back), "R1")
        flat = self.up()
        flat.points[3] = flat.points[0]
        self.reject(self.column(flat), "R1")

    def test_r1_of_random_bridges(self):
        """Their lists 1 and 2 are moved at random, and K, too; the condition is tested here by eliminating variables."""
        rng = random.Random(int(os.environ.get("VT_SEED", "20261130")))
        wide = Grid([[Q(0), Q(3, 8), Q(5, 8), Q(1)]] * 2 + [[Q(0), Q(1, 4), Q(1)]], {(1, 1, 0): 0})
        seen = set()
        for turn in range(60):
            low, (p, q), step = straight(mf.rod(), 8, 5, Q(3, 8), grid=wide, turn=rng.random() < 0.5), rng.choice(((1, 1), (2, 1), (1, 3), (2, 2))), 64
            lists = [elevated(low.points[k::3], p, q) for k in range(3)]
            size = rng.choice((1, 2, 4, 8))
            lists[1:] = [[tuple(c + Q(rng.randint(-size, size), 8 * step) for c in x) for x in points] for points in lists[1:]]
            matrix = [k + Q(rng.randint(-size, size), 8) for k in low.matrix]
            bridge = mf.Bridge.along(lists, 8, 5, degrees=(p, q), matrix=matrix)
            micro = Micro([wide], [mf.rod()], bridges=[bridge])
            verdict = meets_r1(lists, p, q, matrix)
            seen.add(verdict)
            with self.subTest(turn=turn):
                self.accept(micro, 18, 1, 0, 1, 1, 0) if verdict else self.reject(micro, "R1")
        self.assertEqual(seen, {True, False})

    def test_r2(self):
        self.reject(self.column(self.up(volume=1), cage=[mf.volume(), mf.volume(lambda x, y, z: (x + 2, y, z))]), "R2")
        thin = straight(mf.rod(first=(Q(1, 4), HALF)), 0, 5, Q(1, 2), grid=self.COLUMN)
        self.reject(self.column(thin), "R2")
        two = {(0, 0, 0): 0, (0, 0, 1): 0}
        self.reject(Micro([Grid(self.COLUMN.breaks, two)], [mf.rod()], bridges=[self.up()]), "R2")    # the cap is glued
        self.reject(self.column(straight(mf.jack(), 0, 5, Q(1, 2), grid=self.COLUMN), tile=mf.jack(walls=range(5))), "R2")    # there is no cap
        outward = straight(mf.rod(), 0, 4, Q(1, 4), grid=self.COLUMN)
        self.reject(self.column(outward), "R2")            # the wall lies in a face that is not glued
        keel = mf.keel(ridge=Q(1, 16)).turned((0, 1, 2), (0, 0, 1))
        self.reject(self.column(self.up(), tile=keel), "R2")    # two caps of two patches
        cupped = cup()                                     # an annulus of four patches
        self.reject(self.column(self.up(), tile=cupped), "R2")
        high = self.up(turn=True)
        for k in range(4):                                 # list 0 is a little beyond the front
            high.points[3 * k] = (*high.points[3 * k][:2], Q(1, 4) + Q(1, 1 << 20))
        self.reject(self.column(high), "R2")

    def test_r2_in_other_degrees(self):
        for turns in range(2):
            for p, q in ((2, 2), (3, 1), (1, 2), (7, 7)):
                low = self.up(turn=turns == 1)
                lists = [low.points[k::3] for k in range(3)]
                lists = [elevated(points, p, q) for points in lists]
                self.accept_column(mf.Bridge.along(lists, 0, 5, degrees=(p, q), matrix=low.matrix))
        tile = mf.rod()
        tile.patches[1] = raised(tile.patches[1])
        self.accept_column(self.up(), tile=tile)

    def test_r3(self):
        self.reject(self.column(self.up(Q(3, 4))), "R3")   # the end lies in the face of the volume
        above = {(0, 0, 0): 0, (0, 0, 3): 0}
        full = Micro([Grid(self.COLUMN.breaks, above)], [mf.rod()], bridges=[self.up(Q(1, 2))])
        self.reject(full, "R3")                            # the end touches a cell with a tile
        self.accept(Micro([Grid(self.COLUMN.breaks, above)], [mf.rod()], bridges=[self.up(HALF - Q(1, 1 << 40))]), 4, 2, 0, 2, 2, 0)
        for k in (1, 2):
            wide = self.up(turn=True)
            wide.points[k] = (0, *wide.points[k][1:])
            self.reject(self.column(wide), "R3")

    def test_r3_other_slices_miss_the_own_cell(self):
        wide = Grid([[Q(i, 2) for i in range(3)], [0, 1], [Q(i, 4) for i in range(5)]], {(0, 0, 0): 0})
        up = straight(mf.rod(), 0, 5, Q(1, 2), grid=wide, turn=True)
        self.accept(Micro([wide], [mf.rod()], bridges=[up]), 8, 1, 0, 1, 1, 0)
        self.accept(Micro([wide], [mf.rod()], bridges=[straight(mf.rod(), 0, 5, HALF, grid=wide, cuts=(Q(1, 1 << 40),))]), 8, 1, 0, 1, 1, 0)
        beside = {(0, 0, 0): 0, (1, 0, 1): 0}              # a cell beside the bridge
        self.accept(Micro([Grid(wide.breaks, beside)], [mf.rod()], bridges=[up]), 8, 2, 0, 2, 2, 0)

    def test_a_bridge_that_slices_save(self):
        """It leans over a cell with a tile: the box of the whole meets that cell, those of its slices do not."""
        grid = Grid([[Q(i, 4) for i in range(5)], [0, 1], [Q(i, 8) for i in range(9)]], {(0, 0, 0): 0, (2, 0, 1): 0})
        up = straight(mf.rod(), 0, 5, Q(1, 2), grid=grid, turn=True)
        for k in range(4):
            x = up.points[3 * k + 2]
            up.points[3 * k + 2] = (x[0] + Q(3, 8), *x[1:])
        up.matrix = tuple(x * (100 if k > 5 else 1) for k, x in enumerate(up.matrix))
        micro = Micro([grid], [mf.rod()], bridges=[up])
        self.reject(micro, "R3")
        up.cuts = (HALF,)
        self.accept(micro, 32, 2, 0, 2, 2, 0)

    def test_r4(self):
        grid = Grid([[0, 1], [0, 1], [Q(i, 5) for i in range(6)]], {(0, 0, 0): 0, (0, 0, 4): 0})
        for gap, verdict in ((Q(1, 1 << 60), True), (0, False), (-Q(1, 10), False)):
            up, down = straight(mf.rod(), 0, 5, Q(3, 10) - gap, grid=grid), straight(mf.rod(), 4, 4, Q(3, 10), grid=grid)
            micro = Micro([grid], [mf.rod()], bridges=[up, down])
            self.accept(micro, 5, 2, 0, 2, 2, 0) if verdict else self.reject(micro, "R4")

    def test_bridges_across_glued_faces(self):
        """From a tile at x = 1 of the first volume into the second one, whose parameters are turned."""
        for order in itertools.permutations(range(3)):
            for flips in itertools.product((0, 1), repeat=3):
                for is_reversed in (False, True):
                    with self.subTest(order=order, flips=flips, is_reversed=is_reversed):
                        self.across(order, flips, is_reversed)

    def across(self, order, flips, is_reversed):
        """is_reversed: the volume with the tile comes second. Its domain is [0, 1], the other one's [1, 3]."""
        bar = mf.rod(axis=0, first=(Q(1, 8), Q(3, 8)), second=(Q(1, 4), Q(5, 8)))
        cage = [mf.volume(), mf.volume(lambda x, y, z: (x + 1, y, z), order, flips, domain=(1, 3))]
        straight_on = straight(bar, 0, 1, HALF)

        def place(x):
            """From space to the other volume's parameters."""
            unit = (x[0] - 1, x[1], x[2])
            return tuple(1 + 2 * (1 - unit[order[k]] if flips[k] else unit[order[k]]) for k in range(3))
        lists = [[place(p) for p in straight_on.points[k::3]] for k in range(3)]
        lists = righted(lists)
        if is_reversed:
            cage.reverse()
        bridge = mf.Bridge.along(lists, 0, 1, volume=int(not is_reversed), matrix=inverse_of(lists))
        grid = Grid.block((1, 1, 1), volume=int(is_reversed))
        options = ("--orient", "auto")
        self.accept(Micro([grid], [bar], cage, bridges=[bridge]), 1, 1, 0, 1, 1, 0, options=options)
        wrong = mf.Bridge.along(righted(lists[::-1]), 0, 1, volume=bridge.volume, matrix=inverse_of(righted(lists[::-1])))
        self.reject(Micro([grid], [bar], cage, bridges=[wrong]), "R2", options=options)
        own = mf.Bridge.along(lists, 0, 1, volume=int(is_reversed), matrix=inverse_of(lists))
        self.reject(Micro([grid], [bar], cage, bridges=[own]), "R2", options=options)
        moved = mf.Bridge.along([[tuple(c + (k == 0) * Q(1, 1 << 30) for c in p) for p in points] for k, points in enumerate(lists)], 0, 1,
                                volume=bridge.volume, matrix=bridge.matrix)
        self.reject(Micro([grid], [bar], cage, bridges=[moved]), "R2", options=options)

    def test_refused(self):
        micro = self.column(self.up())
        good = self.up().json()
        self.accept(micro, 4, 1, 0, 1, 1, 0)
        for change in ({"grid": 1}, {"grid": -1}, {"cell": 1}, {"cell": 4}, {"cell": -1}, {"wall": 6}, {"wall": "5"}, {"volume": 1}, {"volume": None},
                       {"degrees": [1]}, {"degrees": [1, 8]}, {"degrees": [0, 1]}, {"degrees": [1, 2]}, {"points": good["points"][:-1]},
                       {"points": good["points"] + [["0", "0", "0"]]}, {"points": [["0", "0"], *good["points"][1:]]},
                       {"points": [["0", "0", 0], *good["points"][1:]]}, {"points": [["0", "0", f"1/{1 << 2304}"], *good["points"][1:]]},
                       {"points": [["0", "0", str(1 << 2304)], *good["points"][1:]]}, {"more": 1}):
            self.refuse(micro, bridges=json.dumps([{**good, **change}]))
        for key in good:
            self.refuse(micro, bridges=json.dumps([{k: v for k, v in good.items() if k != key}]))
        self.refuse(micro, bridges=json.dumps([good, good]))
        self.refuse(micro, bridges=json.dumps([good, {**good, "wall": 4}]))
        self.refuse(micro, bridges="null")
        for member, key in (("bridges", "grid"), ("bridges", "volume"), ("bridges", "cell"), ("grids", "volume")):
            plain = micro.members()[member]
            self.assertIn(f'"{key}": 0', plain)
            self.refuse(micro, **{member: plain.replace(f'"{key}": 0', f'"{key}": -0')})    # an integer has no sign
        text = self.column().text(bridges="[]")
        body = mf.hints([mf.rod()]) + mf.cage_body(micro.cage_text(), VERITOPE)
        self.judge(text, mf.certificate(text, body, {**dict(zip(mf.NUMBERS, (4, 1, 0, 1, 1, 0))), "bridges": 0}), 0, "ACCEPT")


class Materials(Judged):
    def judge_materials(self, expected, materials, micro=None, **members):
        micro = micro or Micro([Grid.block((1, 1, 2))], [mf.rod()])
        text = micro.text(materials=materials, **members)
        body = mf.hints(micro.tiles) + mf.cage_body(micro.cage_text(), VERITOPE)
        numbers = {**dict(zip(mf.NUMBERS, (2, 2, 1, 1, 1, 0))), "bridges": 0}
        self.judge(text, mf.certificate(text, body, numbers), *expected)

    def test_materials(self):
        accepted, refused = (0, "ACCEPT"), (4, "")
        values = [0, -1, 1, (1 << 52) - 1, 1 - (1 << 52), *range(7)]
        good = {"name": "share", "values": [values]}
        self.judge_materials(accepted, json.dumps([good]))
        self.judge_materials(accepted, json.dumps([good] * 16))
        self.judge_materials(accepted, "[]")
        self.judge_materials(refused, json.dumps([good] * 17))
        for value in (1 << 52, -(1 << 52), 10**17, -(10**17), "1", None, 1.5, True):
            self.judge_materials(refused, json.dumps([{**good, "values": [[value, *values[1:]]]}]))
        for value in ("-0", "01", "+1", "1e3", "1.0", "--1", "-", ""):
            self.judge_materials(refused, '[{"name": "a", "values": [[%s,0,0,0,0,0,0,0,0,0,0,0]]}]' % value)
        for change in ({"values": []}, {"values": [values, values]}, {"values": [values[1:]]}, {"values": [[*values, 0]]}, {"values": values}, {"name": 1},
                       {"unit": "m"}):
            self.judge_materials(refused, json.dumps([{**good, **change}]))
        for key in good:
            self.judge_materials(refused, json.dumps([{k: v for k, v in good.items() if k != key}]))

    def test_order_of_keys(self):
        micro = Micro([Grid.block((1, 1, 2))], [mf.rod()])
        self.refuse(micro, materials="[]", bridges="[]")   # materials come last


def raised_once(row):
    """A Bernstein polynomial of points in the next degree."""
    n = len(row)
    padded = [row[0], *row, row[-1]]
    return [tuple(Q(i, n) * a + Q(n - i, n) * b for a, b in zip(padded[i], padded[i + 1])) for i in range(n + 1)]


def meets_r1(lists, p, q, matrix):
    """R1 for a bridge with these lists, second parameter fastest."""
    net = {(i, j, k): lists[k][i * (q + 1) + j] for i in range(p + 1) for j in range(q + 1) for k in range(3)}
    columns = []
    for axis, n in enumerate((p, q, 2)):
        column = {}
        for index in net:
            if index[axis] == 0:
                line = [net[tuple(t if a == axis else c for a, c in enumerate(index))] for t in range(n + 1)]
                slopes = raised_once([tuple(n * (b - a) for a, b in zip(x, y)) for x, y in zip(line, line[1:])])
                column.update({tuple(t if a == axis else c for a, c in enumerate(index)): slopes[t] for t in range(n + 1)})
        columns.append(column)

    def is_positive(m):
        """Whether a symmetric matrix is positive definite, by elimination."""
        m = [list(row) for row in m]
        while m:
            if m[0][0] <= 0:
                return False
            m = [[x - row[0] * y / m[0][0] for x, y in zip(row[1:], m[0][1:])] for row in m[1:]]
        return True
    rows = [matrix[3 * r:3 * r + 3] for r in range(3)]
    products = [[[sum(a * b for a, b in zip(row, column[index])) for column in columns] for row in rows] for index in net]
    return mf.determinant(*rows) > 0 and all(is_positive([[m[r][c] + m[c][r] for c in range(3)] for r in range(3)]) for m in products)


def elevated(points, p, q):
    """The bilinear patch in the degrees (p, q)."""
    p00, p01, p10, p11 = points
    return [tuple((1 - u) * ((1 - v) * a + v * b) + u * ((1 - v) * c + v * d) for a, b, c, d in zip(p00, p01, p10, p11))
            for u in (Q(i, p) for i in range(p + 1)) for v in (Q(j, q) for j in range(q + 1))]


class StarBoxes(Judged):
    """Tiles that star boxes prove."""

    def test_honest(self):
        for tile in (mf.jack(), mf.rod(), mf.keel(ridge=Q(1, 16))):
            proved = mf.boxed(tile, VERITOPE)
            self.accept(one(proved), 1, 1, 0, 1, 1, 0)
        proved = mf.boxed(mf.jack(), VERITOPE)
        self.accept(Micro([Grid.block((2, 2, 2))], [proved]), *jack_numbers(2, 2, 2))
        self.accept(stack(proved, mf.jack()), 2, 2, 1, 1, 1, 0)

    def test_a_tile_that_is_not_star_shaped(self):
        """A frame: a rod along z with a hole along x, of genus 1."""
        frame = mf.frame()
        self.reject(one(frame), "F1")
        self.accept(one(mf.boxed(frame, VERITOPE)), 1, 1, 0, 1, 1, 1)
        self.accept(stack(*[mf.boxed(frame, VERITOPE)] * 2), 2, 2, 1, 1, 1, 2)

    def test_f3(self):
        graded, still = mf.jack(slope=Q(1, 16)), mf.boxed(mf.jack(), VERITOPE)
        self.reject(one(graded.copy(boxes=still.boxes), numbers=lambda *i: 0), "F3")
        jack = mf.jack()
        small = [s.mapped(lambda x: tuple(HALF + (c - HALF) / 16 for c in x)) for s in mf.rod(first=(Q(1, 8), Q(3, 8))).patches]
        away = [s.mapped(lambda x: (x[0] + Q(3, 8), x[1] + Q(3, 8), x[2] + Q(3, 8))) for s in small]
        both = mf.boxed(mf.Tile("both", jack.patches + away), VERITOPE)
        self.reject(one(both), "F3")                       # two shells
        hollow = mf.Tile("hollow", jack.patches + [s.mapped(lambda x: x, turn=True) for s in small])
        self.reject(one(mf.boxed(hollow, VERITOPE)), "F3")

    def test_the_conditions_of_star_boxes(self):
        honest = mf.boxed(mf.jack(), VERITOPE)
        self.reject(one(honest.copy(boxes=honest.boxes[:-1])), "B1")
        self.reject(one(honest.copy(boxes=honest.boxes + b"\0")), "B1")
        self.reject(one(honest.copy(boxes=b"")), "B1")
        self.reject(one(honest.copy(boxes=b"VTSB" + honest.boxes[4:])), "B1")
        flags = bytearray(honest.boxes)
        flags[9] = 1
        self.reject(one(honest.copy(boxes=bytes(flags))), "P1")
        self.reject(one(mf.jack(half=Q(3, 16)).copy(boxes=honest.boxes)), "C1")
        broken = jack_or(lambda patches: patches.pop(0)).copy(boxes=honest.boxes)
        self.reject(one(broken), "S0")                     # before the body is read
        self.reject(Micro([Grid.block((1, 1, 1))], [mf.keel(), honest.copy(boxes=b"")]), "T2")


class Refused(Judged):
    def test_members(self):
        micro = one(mf.jack(slope=Q(1, 16)), numbers=lambda *i: 1)
        self.accept(micro, 1, 1, 0, 1, 1, 0)
        named = Micro(micro.grids, micro.tiles, model={"name": "a", "sha256": "0" * 64})
        self.accept(named, 1, 1, 0, 1, 1, 0)
        for key in micro.members():
            self.refuse(micro, **{key: None})
        self.refuse(micro, format='"veritope-micro-2"')
        for model in ("0", '{"name": "a"}', '{"name": "a", "sha256": "%s"}' % ("0" * 63), '{"name": "a", "sha256": "%s"}' % ("A" * 64)):
            self.refuse(micro, model=model)
        for grids in ('[{"volume": 1, "breaks": [["0", "1"], ["0", "1"], ["0", "1"]]}]', '[{"volume": -1, "breaks": [["0", "1"], ["0", "1"], ["0", "1"]]}]',
                      '[{"volume": 0, "breaks": [["0", "1"], ["0", "1"]]}]', '[{"volume": 0, "breaks": [["0", "1"], ["0", "1"], ["0"]]}]',
                      '[{"volume": 0, "breaks": [["0", "1"], ["0", "1"], ["0", "0", "1"]]}]', '[{"volume": 0, "breaks": [["0", "1"], ["0", "1"], ["0", "2"]]}]',
                      '[{"volume": 0, "breaks": [["0", "1"], ["0", "1"], ["-1", "1"]]}]', '[{"volume": 0, "breaks": [["0", "1"], ["0", "1"], [0, 1]]}]',
                      "[]", "null"):
            self.refuse(micro, grids=grids)
        for cells in ('[["0"], ["0"]]', "[[]]", '[["8", "0"]]', '[["80"]]', '[[""]]', '[["c"]]', '[["g"]]', "[]", '["8"]'):
            self.refuse(micro, cells=cells)
        for walls in ("[]", "[[[1,1],[1,1]]]", "[[[1,1],[1,1],[1]]]", "[[[1,1],[1,1],[1,1,1]]]", "[[[1,1],[1,1],[1,1048577]]]", "[[[1,1],[1,1],[1,-1]]]",
                      "[[[1,1],[1,1],[1,01]]]", "[[[1,1],[1,1],[1,1.0]]]", "[[[1,1],[1,1],[1,1e0]]]", '[[[1,1],[1,1],[1,"1"]]]',
                      "[[[1,1],[1,1],[1,99999999999999999999]]]", "[[[1,1],[1,1],[1,1]],[]]"):
            self.refuse(micro, walls=walls)

    def test_grids(self):
        tile = mf.jack()
        for first, second in (([0, HALF], [Q(1, 4), 1]), ([0, 1], [Q(1, 4), HALF]), ([Q(1, 4), HALF], [0, 1]), ([0, 1], [0, 1])):
            self.refuse(Micro([Grid([axis, [0, 1], [0, 1]], {}) for axis in (first, second)], [tile]))
        two = [mf.volume(), mf.volume(lambda x, y, z: (x + 1, y, z))]
        self.refuse(Micro([Grid.block((1, 1, 1), volume=1), Grid.block((1, 1, 1))], [tile], two))
        knots = mf.volume()
        knots["shape"]["knots"] = [["0", "0", "1/2", "1", "1"], *knots["shape"]["knots"][1:]]
        points = [[str(Q(c)) for c in (Q(i, 2), j, k)] for i in range(3) for j in (0, 1) for k in (0, 1)]
        knots["shape"]["points"] = points
        self.refuse(Micro([Grid.block((1, 1, 1))], [tile], [knots]))
        self.refuse(Micro([Grid.block((3, 1, 1))], [tile], [knots]))
        self.accept(Micro([Grid.block((2, 1, 1))], [tile], [knots]), *jack_numbers(2, 1, 1))
        before = Grid([[0, Q(1, 3), HALF], [0, 1], [0, 1]], {(0, 0, 0): 0, (1, 0, 0): 0})
        self.accept(Micro([before], [tile], [knots]), *jack_numbers(2, 1, 1))

    def test_bits_of_cells_that_do_not_exist_and_two_tiles(self):
        micro = Micro([Grid.block((3, 1, 1))], [mf.jack(), mf.jack()])
        self.accept(micro, 3, 3, 2, 1, 1, 0)
        self.refuse(micro, cells='[["f", "0"]]')
        self.refuse(micro, cells='[["e", "2"]]')
        self.refuse(micro, cells='[["E", "0"]]')

    def test_a_wall_of_no_tile_has_the_number_0(self):
        micro = Micro([Grid([[0, HALF, 1], [0, 1], [0, 1]], {(0, 0, 0): 0}, numbers=lambda *i: 1)], [mf.jack(slope=Q(1, 16))])
        self.accept(micro, 2, 1, 0, 1, 1, 0)
        for walls in ("[[[1,1,1],[1,1,0,0],[1,1,0,0]]]", "[[[1,1,0],[1,1,1,0],[1,1,0,0]]]", "[[[1,1,0],[1,1,0,0],[1,1,0,1]]]"):
            self.refuse(micro, walls=walls)

    def test_tiles(self):
        good = mf.jack()
        micro = one(good)

        def change(**members):
            tile = json.loads(mf.tile_text(good))
            for key, value in members.items():
                (tile["patches"][0] if key in tile["patches"][0] else tile)[key] = value
            return "[" + json.dumps(tile) + "]"
        self.accept(micro, 1, 1, 0, 1, 1, 0)
        points = json.loads(change())[0]["patches"][0]["points"][0]
        for members in ({"range": [0, 1]}, {"wall": 0}, {"wall": 6}, {"wall": -1}, {"degrees": [1]}, {"degrees": [1, 1, 1]}, {"degrees": [0, 1]},
                        {"degrees": [8, 1]}, {"degrees": [1, 2]}, {"points": []}, {"points": [points, points]}, {"points": [points[:3]]},
                        {"points": [points[:3] + [["0", "0"]]]}, {"points": [points[:3] + [["0", "0", "0", "0"]]]}, {"points": [points[:3] + [["0", "0", 0]]]},
                        {"points": [points[:3] + [["0", "0", str(1 << 128)]]]}, {"points": [points[:3] + [["0", "0", f"1/{1 << 128}"]]]},
                        {"patches": []}, {"name": 1}, {"more": 1}):
            self.refuse(micro, tiles=change(**members))
        for ends in ([1], [1, 2, 3], [2, 1], [-1, 1], [0, (1 << 20) + 1]):
            graded = json.loads(mf.tile_text(mf.jack(slope=Q(1, 16))))
            self.refuse(micro, tiles=json.dumps([{**graded, "range": ends}]), walls="[[[0,0],[0,0],[0,0]]]")
        self.refuse(micro, tiles="[]", cells="[[]]")
        sixteen = Micro([], [good] * 16)
        self.refuse(sixteen)
        self.accept(Micro([], [good] * 15), 0, 0, 0, 0, 0, 0)
        many = json.loads(mf.tile_text(good))
        many["patches"] = many["patches"][:1] * 1025
        self.refuse(micro, tiles=json.dumps([many]))

    def test_the_cage_holds_volumes(self):
        surface = mf.volume()
        surface["kind"] = "surface"
        cage = json.dumps({"format": "veritope-spline-1", "groups": [], "entities": [surface]})
        self.refuse(one(mf.jack()), cage=cage)
        self.refuse(one(mf.jack()), cage='{"format": "veritope-spline-1", "groups": [], "entities": []}')
        self.refuse(one(mf.jack()), cage="{}")

    def test_what_follows_and_what_precedes(self):
        micro = one(mf.jack())
        text = micro.text()
        body = mf.hints(micro.tiles) + mf.cage_body(micro.cage_text(), VERITOPE)
        numbers = {**dict(zip(mf.NUMBERS, (1, 1, 0, 1, 1, 0))), "bridges": 0}
        for changed in (text + b"{}", b"[" + text, text[:-2], b"", text.replace(b'"jack"', b'"j\xff"'), text.replace(b'"model": null,\n', b"") + b" "):
            self.judge(changed, mf.certificate(changed, body, numbers), 4, "")
        spaced = text.replace(b",", b" ,\t\r\n")
        self.judge(spaced, mf.certificate(spaced, body, numbers), 0, "ACCEPT")


if __name__ == "__main__":
    unittest.main()
