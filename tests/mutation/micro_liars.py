#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Lying provers against the checkers of the claim microstructure-1: tiles that are open, folded, wound twice, or touch walls outside of
their caps, walls whose caps do not fit, numbers that are wrong; the rest is right. As vmodel_liars.py, whose harness this is. Run

    python3 tests/mutation/micro_liars.py --count 100000 --honest 500 --seed 1 --python-share .05 --checker PATH_TO_veritope-check
"""
import functools
import itertools
import pathlib
import random
import sys
from fractions import Fraction as Q

import attacks
import patch_attacks
import micro_bridge_liars
import micro_sweep_liars
import micro_variants
import vmodel_liars

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import micro_examples as examples                         # noqa: E402

PARTS = ["T2 cap", "T2 body", "T2 side", "T2 corner"]      # of T2, each of which must be needed alone
CONDITIONS = ["B2", "S0", "F1", "F2", "F3", "T2", "T3", "G1", "G2", "T4", "R1", "R2", "R3", "R4", "Q1", "Q2", "Q3", "Q4", "W3"]
OF_CAGES = ["V1", "V2", "V3", "V4", "C1", "C2", "C3", "C4", "W1", "W2", "P1"]
UNIT, HALF, HAIR = examples.UNIT, examples.HALF, Q(1, 1 << 60)
models, forge = vmodel_liars.models, vmodel_liars.forge
ALL, OPPOSITE = range(6), (1, 0, 3, 2, 5, 4)


# ---------------------------------------------------------------- cages

@functools.lru_cache(None)
def cage_named(name):
    made = {"tricubic": lambda: forge.proved([models.bent(3)]),
            "three in a row": lambda: forge.proved([models.box((i, 0, 0), (i + 1, 1, 1)) for i in range(3)])}
    return made[name]() if name in made else models.honest(name)


CAGES = ("cube", "bent", "tricubic", "rational", "a ring", "cube with breaks", "mirrored", "two", "two, one of them mirrored and turned",
         "two with breaks", "two, in other degrees", "three in an L", "curved pair", "in a cube", "a wedge", "a pyramid", "six pyramids",
         "a fan", "half collapsed, split", "squares", "a tree", "a shrunk edge", "apart", "three in a row")


def some_cage(rng, names=CAGES):
    if rng.random() < .08 and names is CAGES:
        return in_json(vmodel_liars.random_polycube(rng))
    plan = cage_named(rng.choice(names))
    return in_json(vmodel_liars.placed(plan, rng) if rng.random() < .4 else plan)


def in_json(plan):
    return plan if plan.subject_format == "vjson" and plan.text else plan.changed(subject_format="vjson", text=None)


def even_breaks(plan, volume, n):
    """n equal intervals along each axis."""
    return [[t[0] + (t[-1] - t[0]) * Q(i, n) for i in range(n + 1)] for t in plan.maps[volume].knots]


# ---------------------------------------------------------------- honest microstructures

class Kind:
    """Tiles of one file that fit each other: their walls have no caps, the caps `main`, or the cap of the exit."""

    def __init__(self, rng):
        r = rng.random()
        self.n, self.main = (3, "centre") if r < .5 else (5, "block") if r < .65 else (5, "row") if r < .7 else \
            (7, "ring") if r < .85 else (7, "corners")
        if self.main == "row":
            self.n, self.main = 5, "centre"
        self.exit = "centre" if self.main in ("ring", "corners") else self.main
        grows = rng.choice((Q(0), Q(1, 20), Q(1, 20), Q(1, 64)))
        self.scale = (rng.choice((Q(17, 20), Q(9, 10))), grows)
        self.lo = rng.choice((0, rng.randrange(UNIT)))
        self.hi = rng.choice((self.lo, rng.randint(self.lo, UNIT), UNIT))
        self.driver = rng.sample(ALL, 6) if rng.random() < .1 else ALL
        self.same = rng.randint(self.lo, self.hi) if self.driver != ALL else None

    def number(self, rng):
        """The number of a wall; where caps depend on other walls than their own, all numbers are equal."""
        return rng.randint(self.lo, self.hi) if self.same is None else self.same

    def tile(self, rng, kinds, **options):
        """kinds: for each wall main, exit or none."""
        depths, low = {}, rng.choice((Q(3, 5), Q(7, 10)))

        def depth(v):
            return depths.setdefault(v, low + Q(rng.randrange(33), 256))
        extent = (rng.choice((self.lo, rng.randint(0, self.lo))), rng.choice((self.hi, rng.randint(self.hi, UNIT))))
        tile = examples.lattice_tile(self.n, [examples.pattern({"main": self.main, "exit": self.exit, "none": "none"}[k], self.n) for k in kinds],
                                     self.scale, extent, depth, driver=self.driver, **options)
        tile.kinds = kinds
        return described(tile, rng)

    def fit(self, one, other):
        return "none" in (one, other) or one == other or self.main == "corners" or self.main == self.exit

    def some_tiles(self, rng):
        found = []
        for _ in range(rng.choice((1, 1, 2, 3))):
            share = rng.choice((1, .8, .5))
            kinds = ["main" if rng.random() < share else "none" for _ in ALL]
            kinds[rng.randrange(6)] = "exit"
            found.append(self.tile(rng, kinds))
        return found


def described(tile, rng):
    """The patches start at other corners, have higher degrees, and more lists; the exit only starts elsewhere."""
    for n in range(len(tile.quads)):
        turn = rng.randrange(4)
        tile.quads[n] = tile.quads[n][turn:] + tile.quads[n][:turn]
        tile.patches[n] = tile.patch(n)
        if n != tile.exit and rng.random() < .1:
            tile.patches[n] = examples.raised(tile.patches[n], rng.randrange(2))
        wall, degrees, lists = tile.patches[n]
        if wall is None and tile.extent and rng.random() < .1:
            tile.patches[n] = rng.randrange(6), degrees, lists
        elif wall is not None and rng.random() < .1:
            tile.patches[n] = wall, degrees, lists + [[[Q(0)] * 3] * len(lists[0])] * rng.choice((1, 2))
    if tile.extent and all(wall is None for wall, _, _ in tile.patches):
        tile.extent = None
    return tile


def some_grids(rng, plan):
    """(grids, are walls of faces and of several grids equal where they meet?)"""
    volumes = range(len(plan.maps))
    inner = any(len(set(t)) > 2 for m in plan.maps for t in m.knots)
    if not inner and rng.random() < .7:
        n = rng.choice((1, 2, 3) if len(volumes) < 3 else (1, 1, 2))
        chosen = [v for v in volumes if rng.random() < .85] or [0]
        grids = []
        for v in chosen:
            breaks = even_breaks(plan, v, n)
            axis, at = rng.randrange(3), rng.randrange(n + 1)
            for part in ([breaks[axis][:at + 1], breaks[axis][at:]] if rng.random() < .3 else [breaks[axis]]):
                if len(part) > 1:
                    grids.append((v, [part if a == axis else b for a, b in enumerate(breaks)]))
        return grids, True
    grids = []
    for v in volumes:
        breaks = []
        for t in plan.maps[v].knots:
            places = {t[0] + (t[-1] - t[0]) * Q(i, 12) for i in rng.sample(range(13), rng.choice((2, 2, 3)))}
            lo, hi = min(places), max(places)
            breaks.append(sorted(places | {x for x in t if lo < x < hi}))
        axis = rng.randrange(3)
        if len(breaks[axis]) > 2 and rng.random() < .3:
            at = rng.randrange(1, len(breaks[axis]) - 1)
            grids += [(v, [part if a == axis else b for a, b in enumerate(breaks)]) for part in (breaks[axis][:at + 1], breaks[axis][at:])]
        else:
            grids.append((v, breaks))
    return grids[:5], False


def filled(rng, plan, grids, tiles, fit, are_even, numbers=None, share=.8):
    """Cells hold tiles that fit those beside them; numbers(): of a wall."""
    micro = examples.Micro(plan, grids, tiles, [], None)
    micro.cells = [[None] * (len(b[0]) - 1) * (len(b[1]) - 1) * (len(b[2]) - 1) for _, b in grids]
    beside, places = {}, {}
    for g, of_grid in enumerate(micro.cells):
        for c in range(len(of_grid)):
            for w in ALL:
                point = [HALF] * 3
                point[w // 2] = Q(w % 2)
                places[g, c, w] = micro.in_space(g, c, point)
                beside.setdefault(places[g, c, w], []).append((g, c, w))
    at_ends = {(g, c, w) for g, c, w in places if not 0 < micro.index(g, c)[w // 2] + w % 2 < len(grids[g][1][w // 2]) - 1}
    order = sorted({(g, c) for g, c, _ in places})
    rng.shuffle(order)
    for g, c in order:
        def is_good(tile):
            for w in ALL:
                if tile.kinds[w] != "none" and (micro.code(g, c, w) == 1 or not are_even and (g, c, w) in at_ends):
                    return False
                for h, d, x in beside[places[g, c, w]]:
                    if micro.cells[h][d] is not None and not fit(tile.kinds[w], tiles[micro.cells[h][d]].kinds[x]):
                        return False
                if tile.kinds[w] != "none" and any((h, d) == (g, c) and x != w and not fit(tile.kinds[w], tile.kinds[x])
                                                   for h, d, x in beside[places[g, c, w]]):
                    return False
            return True
        good = [n for n, tile in enumerate(tiles) if is_good(tile)]
        if good and rng.random() < share:
            micro.cells[g][c] = rng.choice(good)
    if any(tile.extent for tile in tiles):
        known = {}
        micro.walls = []
        for g, (_, breaks) in enumerate(grids):
            counts = [len(b) - 1 for b in breaks]
            lists = [[0] * (counts[0] * counts[1] * counts[2] // counts[a] * (counts[a] + 1)) for a in range(3)]
            for c in range(len(micro.cells[g])):
                for w in ALL:
                    if micro.cells[g][c] is not None:
                        axis, n = micro.wall_index(g, c, w)
                        lists[axis][n] = known.setdefault(places[g, c, w], numbers())
            micro.walls.append(lists)
    return micro


def some_micro(rng):
    plan, kind = some_cage(rng), Kind(rng)
    grids, are_even = some_grids(rng, plan)
    if kind.n == 7:
        grids = grids[:2]
    micro = filled(rng, plan, grids, kind.some_tiles(rng), kind.fit, are_even, lambda: kind.number(rng),
                   rng.choice((1, .8, .5)))
    if rng.random() < .3:
        micro.model = {"name": "a.stl", "sha256": "0123456789abcdef" * 4}
    return micro.settled()


def coarse_and_fine(rng):
    """One cell beside n by n ones, whose numbers are such that the cap of the coarse one is that of the middle one, or apart from all."""
    plan = in_json(cage_named(rng.choice(("cube", "bent", "two", "two, one of them mirrored and turned", "two with breaks"))))
    tile = examples.jack(Q(1, 5), Q(1, 16), Q(5, 16), (0, UNIT))
    n, is_equal = rng.choice(((3, True), (3, True), (2, False)))
    first, second = [(0, even_breaks(plan, 0, 1))], [(1, even_breaks(plan, 1, n))] if len(plan.maps) > 1 else []
    if not second:
        breaks, axis = even_breaks(plan, 0, n), rng.randrange(3)
        middle = [breaks[axis][0], (breaks[axis][0] + breaks[axis][-1]) / 2, breaks[axis][-1]]
        first = [(0, [middle[:2] if a == axis else [b[0], b[-1]] for a, b in enumerate(breaks)])]
        second = [(0, [middle[1:] if a == axis else b for a, b in enumerate(breaks)])]
    micro = examples.Micro(plan, first + second, [tile], [], [])
    for _, breaks in micro.grids:
        counts = [len(b) - 1 for b in breaks]
        size = counts[0] * counts[1] * counts[2]
        micro.cells.append([0] * size)
        fine = size > 1
        # half of a cap's width is 1/16 + 5/16 t: 1/16 of the coarse wall are 3/16 of a fine one
        micro.walls.append([[2 * UNIT // 5 if fine and is_equal else 0] * (size // c * (c + 1)) for c in counts])
    if is_equal:                                          # 2/5 of 2^20 is no integer
        tile.vertices = {name: (wall, p, tuple(x * Q(UNIT, 5) * 2 / (2 * UNIT // 5) for x in more)) for name, (wall, p, more) in tile.vertices.items()}
        tile.patches = [tile.patch(k) for k in range(30)]
    return micro.settled()


IMAGES = tuple(itertools.product((0, 1), repeat=3))


def turned_pair(rng, image=None):
    """Two cells in glued faces, with a cap that is another one after each symmetry of the square; image: of the second one, by default the
    one that fits."""
    while True:
        plan = in_json(vmodel_liars.random_polycube(rng))
        glued = [(f, code[0]) for f, code in enumerate(plan.codes) if isinstance(code, tuple)]
        if glued:
            break
    f, g = rng.choice(glued)
    cap = [v for v in itertools.product(range(1, 5), repeat=2) if v not in ((4, 1), (4, 2))]

    def tile(face, turn):
        swap, first, second = turn
        of = [v[::-1] if swap else v for v in cap]
        of = [(5 - i if first else i, 5 - j if second else j) for i, j in of]
        return with_patterns(5, {face % 6: of, (face % 6 + 2) % 6: examples.pattern("centre", 5)}, scale=(Q(9, 10), Q(0)))
    for turn in IMAGES if image is None else (image,):
        micro = examples.Micro(plan, [(x // 6, even_breaks(plan, x // 6, 1)) for x in (f, g)], [tile(f, (0, 0, 0)), tile(g, turn)], [[0], [1]])
        if image is not None or micro.equal_walls():
            return micro


def honest(rng):
    """(name, model, certificate)"""
    r = rng.random()
    micro = coarse_and_fine(rng) if r < .1 else turned_pair(rng).settled() if r < .2 else some_micro(rng)
    micro = micro_sweep_liars.honest_plan(rng) if r > .85 else micro
    yield "micro", micro.text(), micro.certificate()


# ---------------------------------------------------------------- lies

def told(lie, *skip):
    """With the numbers that the checker finds if it does not test some conditions, nor the cage; others than these fail, too, if it finds
    none."""
    import veritope_checker.micro.micro_check as check
    from veritope_checker.common.errors import Reject
    from veritope_checker.micro.micro_read import Microstructure

    class OfTiles(check.Checker):
        def codes_of_cage(self):
            return lie.cage.codes
    text, body = lie.text(), lie.body()
    statement = {"claim": "microstructure-1", "subject_bytes": len(text)}
    values = dict.fromkeys(examples.KEYS, 1)
    try:
        checker = OfTiles(statement, body, Microstructure(text), frozenset(skip))
        checker.test()
        values = checker.numbers()
    except Reject:
        pass
    if any(v < 0 or v != int(v) for v in values.values()):
        values = dict.fromkeys(examples.KEYS, 1)
    return lie.changed(values={key: int(v) for key, v in values.items()})


def small(rng, tiles, cells=None, cage=None, walls=None, counts=None):
    """A grid of a few cells in one volume."""
    plan = cage or some_cage(rng, ("cube", "bent", "cube with breaks", "rational", "mirrored"))
    counts = counts or rng.choice(((1, 1, 2), (1, 2, 1), (2, 1, 1), (2, 2, 1), (1, 1, 1)))
    breaks = [[t[0] + (t[-1] - t[0]) * Q(i, n) for i in range(n + 1)] for t, n in zip(plan.maps[0].knots, counts)]
    size = counts[0] * counts[1] * counts[2]
    if walls is None and any(tile.extent for tile in tiles):
        lo, hi = max(t.extent[0] for t in tiles if t.extent), min(t.extent[1] for t in tiles if t.extent)
        walls = [[[rng.randint(lo, hi) for _ in range(size // n * (n + 1))] for n in counts]]
    return examples.Micro(plan, [(0, breaks)], tiles, cells or [[rng.randrange(len(tiles)) for _ in range(size)]], walls)


def with_patterns(n, of_walls, **options):
    return examples.lattice_tile(n, [of_walls.get(w, []) for w in ALL], **options)


def plain_tile(rng, walls=ALL, n=3):
    kind = Kind(rng)
    kind.n, kind.main, kind.exit = n, "centre", "centre"
    return kind.tile(rng, ["main" if w in walls else "none" for w in ALL])


def moved(points, k, step):
    return [[c + s for c, s in zip(p, step)] if i == k else p for i, p in enumerate(points)]


def some_step(rng):
    step = [Q(0)] * 3
    step[rng.randrange(3)] = rng.choice((HAIR, -HAIR, Q(1, 1 << 20), Q(1, 64)))
    return step


def open_tiles(rng):
    """S0: two patches are missing, one is there twice, or a corner of one is elsewhere."""
    tile = plain_tile(rng)
    inner = [n for n, quad in enumerate(tile.quads) if all(tile.wall_of(name) is None for name in quad)]
    two = sorted(rng.sample(inner, 2)) if inner else []
    what = rng.randrange(4)
    if what == 0 and two:
        for n in two[::-1]:
            del tile.patches[n]
        tile.exit -= sum(n < tile.exit for n in two)
    elif what == 1:
        tile.patches.append(tile.patches[rng.choice([n for n in range(len(tile.patches)) if n != tile.exit])])
    elif what == 2:
        n = rng.choice([n for n in range(len(tile.patches)) if n != tile.exit])
        wall, degrees, lists = tile.patches[n]
        lists = [moved(lists[0], rng.randrange(len(lists[0])), some_step(rng)), *lists[1:]]
        tile.patches[n] = wall, degrees, lists
    else:                                                 # a side moves with the number of one wall, the next one does not
        found = [n for n, (_, _, lists) in enumerate(tile.patches) if n != tile.exit and any(c for p in lists[-1] for c in p) and len(lists) > 1]
        if not found:
            return
        n = rng.choice(found)
        wall, degrees, lists = tile.patches[n]
        if rng.random() < .5:
            tile.patches[n] = (wall + rng.randint(1, 5)) % 6, degrees, lists
        else:
            tile.patches[n] = wall, degrees, [lists[0], moved(lists[1], rng.randrange(len(lists[1])), some_step(rng)), *lists[2:]]
    yield "S0_open", told(small(rng, [tile]), "S0")


def folded_tiles(rng):
    """F1: a vertex is beyond the edges around it, or the centre is elsewhere."""
    tile, what = plain_tile(rng), rng.randrange(4)
    if what < 2:
        n = tile.quads[0].__len__() and max(max(v) for v in tile.vertices)
        free = [v for v in tile.vertices if tile.wall_of(v) is None and sum(x in (0, n) for x in v) >= 2]
        name = rng.choice(free)
        wall, point, more = tile.vertices[name]
        axis = rng.randrange(3)
        tile.vertices[name] = wall, tuple(1 - c if a == axis else c for a, c in enumerate(point)), more
        tile.patches = [tile.patch(k) for k in range(len(tile.quads))]
    else:
        middle = [sum(c) / 4 for c in zip(*[tile.at(name, [(tile.extent or (0, 0))[0]] * 6) for name in tile.quads[tile.exit]])]
        axis = next(a for a in range(3) if middle[a] in (0, 1))
        at = abs(middle[axis] - rng.choice((Q(1, 64), Q(1, 16), Q(1, 8), Q(15, 16), Q(1, 1 << 40))))
        tile.centre = tuple(at if a == axis else c for a, c in enumerate(tile.centre))
    if is_folded(tile):                                   # else it is another tile that is star-shaped
        yield "F1_folded", told(small(rng, [tile]), "F1")


def is_folded(tile):
    """Whether the centre is on or behind the plane of two sides at a corner of a patch, for the least numbers or the greatest ones."""
    for number in tile.extent or (0,):
        for quad in tile.quads:
            corners = [tile.at(name, [number] * 6) for name in quad]
            for k, p in enumerate(corners):
                u, v, w = [[a - b for a, b in zip(q, p)] for q in (corners[(k + 1) % 4], corners[k - 1], tile.centre)]
                if any(u) and any(v) and micro_bridge_liars.det([u, v, w]) >= 0:
                    return True
    return False


def wound_tiles(rng):
    """F2: two nested surfaces, a double pyramid whose equator winds twice, or another exit or centre."""
    what = rng.randrange(4)
    if what == 0:
        tile, inner = plain_tile(rng), plain_tile(rng, ())
        factor = rng.choice((HALF, Q(1, 8), Q(1, 64)))
        quads = [[[HALF + (c - HALF) * factor for c in p] for p in lists[0]] for _, _, lists in inner.patches]
        tile.patches += [(None, degrees, [points]) for (_, degrees, _), points in zip(inner.patches, quads)]
    elif what == 1:
        ring = [(2, 0), (2, 2), (0, 2), (-2, 2), (-2, 0), (-2, -2), (0, -2), (2, -2)]
        radii = [Q(rng.randrange(60, 80), 640) for _ in range(16)]
        turns = [(HALF + x * radii[k], HALF + y * radii[k], HALF) for k in range(16) for x, y in [ring[k % 8]]]
        patches = []
        for end in (Q(1, 4), Q(3, 4)):
            apex = (HALF, HALF, end)
            for k in range(16):
                a, b = (turns[k], turns[(k + 1) % 16])[::1 if end > HALF else -1]
                patches.append((None, (1, 1), [[list(a), list(apex), list(b), list(apex)]]))
        tile = plain_tile(rng)
        tile.patches, tile.extent, tile.exit = patches, None, rng.randrange(32)
    else:
        tile = plain_tile(rng)
        if what == 2:
            tile.exit = rng.choice([n for n in range(len(tile.patches)) if n != tile.exit])
            middle = [sum(c) / 4 for c in zip(*[tile.at(v, [(tile.extent or (0, 0))[0]] * 6) for v in tile.quads[tile.exit]])]
            if sum(a != b for a, b in zip(middle, tile.centre)) == 1:
                return                                    # it may be right, too
        else:
            tile.centre = tuple(c + Q(rng.choice((-1, 1)), 1 << 40) for c in tile.centre)
    yield "F2_wound", told(small(rng, [tile]), "F2")


def full_cells(rng):
    """T2(1): the tiles are whole cells, two of which meet in an edge."""
    vertices = {v: (None, tuple(map(Q, v)), (0, 0, 0)) for v in itertools.product((0, 1), repeat=3)}
    quads = []
    for wall in ALL:
        axis, end = wall // 2, wall % 2
        first, second = [(1, 2), (2, 0), (0, 1)][axis][::1 if end else -1]
        quad = []
        for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
            v = [0, 0, 0]
            v[axis], v[first], v[second] = end, a, b
            quad.append(tuple(v))
        quads.append(tuple(quad))
    tile = examples.Tile(vertices, quads, None, exit=rng.randrange(6))
    cells = rng.choice(([0, None, None, 0], [None, 0, 0, None]))
    yield "T2 cap", told(small(rng, [tile], [cells], counts=rng.choice(((2, 2, 1), (2, 1, 2), (1, 2, 2)))), "T2 cap")


def bulging(rng):
    """T2(2): a patch bulges out of the cube."""
    tile = plain_tile(rng)
    free = [n for n, quad in enumerate(tile.quads) if all(tile.wall_of(v) is None for v in quad)] or [0]
    n = rng.choice(free)
    patch = tile.patch(n)
    for axis in (0, 1):
        patch = examples.raised(patch, axis)
    wall, degrees, lists = patch
    middle = lists[0][4]
    # outward, until the middle control point is outside of the cube, along its longest coordinate
    off = [c - HALF for c in middle]
    most = max(map(abs, off))
    factor = (HALF + rng.choice((Q(1, 1 << 20), Q(1, 16), Q(1, 2)))) / most
    lists = [[[HALF + x * factor for x in off] if k == 4 else p for k, p in enumerate(lists[0])]]
    tile.patches[n] = wall, degrees, lists
    yield "T2 body", told(small(rng, [tile]), "T2 body")


def keels(rng):
    """T2(2): an edge runs in the wall between two caps."""
    wall = rng.randrange(6)
    caps = [(i, j) for i, j in itertools.product((1, 2), (2, 3))] + [(i, j) for i, j in itertools.product((3, 4), (3, 4))]
    if rng.random() < .5:
        caps = [(j, i) for i, j in caps]
    of_walls = {wall: caps, OPPOSITE[wall]: caps, (wall + 2) % 6: examples.pattern("centre", 5)}
    tile = with_patterns(5, of_walls)
    yield "T2 side", told(small(rng, [tile], counts=line_along(wall // 2), cells=[[0, 0]]), "T2 side")


def line_along(axis):
    return tuple(2 if a == axis else 1 for a in range(3))


def tips(rng):
    """T2(2): a vertex is in the wall and in no cap."""
    wall = rng.randrange(6)
    tip = [rng.choice([(i, j) for i in range(1, 5) for j in range(1, 5)])]
    of_walls = {wall: tip, OPPOSITE[wall]: tip, (wall + 2) % 6: examples.pattern("centre", 5)}
    yield "T2 corner", told(small(rng, [with_patterns(5, of_walls)], counts=line_along(wall // 2), cells=[[0, 0]]), "T2 corner")


def pinched(rng):
    """T3: a ring of a cap touches itself in a vertex, where the next cell's does so, too; or two caps have a common vertex (which T4 does
    not allow beside equal ones, either)."""
    wall = rng.randrange(6)
    if rng.random() < .3:
        caps, n, name = [*itertools.product((1, 2), repeat=2), *itertools.product((2, 3), repeat=2)], 5, "T3_two_caps"
    else:
        caps = [v for v in itertools.product(range(1, 8), repeat=2) if v not in ((4, 4), (1, 1), (1, 2), (2, 1), (2, 2))]
        n, name = 8, "T3_ring"
    if rng.random() < .5:
        caps = [(i, n - j) for i, j in caps]
    exit, middle = (wall + 2) % 6, Q(7, 16) if n == 8 else HALF
    exits = list(itertools.product((3, 4), repeat=2)) if n == 8 else examples.pattern("centre", 5)
    tile = with_patterns(n, {wall: caps, OPPOSITE[wall]: caps, exit: exits}, scale=(rng.choice((Q(1), Q(9, 10))) if n < 8 else Q(1), Q(0)),
                         centre=tuple(HALF if a == exit // 2 else middle for a in range(3)))
    yield name, told(small(rng, [tile], counts=line_along(wall // 2), cells=[[0, 0]]), "T3")


def crossing_keels(rng):
    """T2(2): an edge runs in the wall from one cap to another, and another one across it on the other side."""
    first = [*itertools.product((1, 2), (2, 3)), *itertools.product((3, 4), (3, 4))]
    second = [*itertools.product((2, 3), (1, 2)), *itertools.product((3, 4), (3, 4))]
    even, xs, ys = [[Q(c, 100) for c in places] for places in ((0, 20, 40, 60, 80, 100), (0, 20, 42, 50, 58, 100), (0, 20, 55, 65, 90, 100))]
    axis = rng.randrange(3)
    p, q = examples.OTHERS[axis]
    places, centre = [even] * 3, [HALF] * 3
    places[p], places[q], centre[q] = xs, ys, Q(3, 5)
    exit = 2 * p + rng.randrange(2)
    cap = examples.pattern("centre", 5)
    low = with_patterns(5, {exit: cap, 2 * axis + 1: first}, scale=(Q(1), Q(0)))
    high = with_patterns(5, {exit: cap, 2 * axis: second}, scale=(Q(1), Q(0)), centre=tuple(centre), places=places)
    yield "T2 side", told(small(rng, [low, high], [[0, 1]], counts=line_along(axis)), "T2 side")


def bad_members(rng):
    """F1, T2: only the member of the family that the cells hold, at an end of the range, is folded, leaves the cube, or touches a wall."""
    name, wall, is_low = rng.choice(("F1", "T2", "T2 corner")), rng.randrange(6), rng.random() < .5
    axis = wall // 2
    tile = with_patterns(5, {(wall + 2) % 6: examples.pattern("centre", 5)})
    place, sideways = rng.choice((2, 3)), rng.choice((-1, 1)) * Q(2, 5)
    out = Q(1) if name == "T2 corner" else 1 + rng.choice((HAIR, Q(1, 8)))
    for of in (2 * axis, 2 * axis + 1):
        v = [place] * 3
        v[axis] = 5 * (of % 2)
        _, point, _ = tile.vertices[tuple(v)]
        step = [(of % 2 - c) * out if a == axis else Q(0) for a, c in enumerate(point)]
        if name == "F1":
            step = [sideways if a == examples.OTHERS[axis][0] else Q(0) for a in range(3)]
        if is_low:
            point, step = [a + b for a, b in zip(point, step)], [-b for b in step]
        tile.vertices[tuple(v)] = of, tuple(point), tuple(step)
    tile.extent = (0, UNIT)
    tile.patches = [tile.patch(n) for n in range(len(tile.quads))]
    counts = line_along(axis)
    walls = [[[0 if is_low else UNIT] * (2 // n * (n + 1)) for n in counts]]
    yield name if " " in name else name + "_member", told(small(rng, [tile], [[0, 0]], counts=counts, walls=walls), name)


def out_of_range(rng):
    """G1: arms of a jack cross each other once their numbers are large."""
    lo = rng.choice((0, UNIT // 8))
    tile = examples.jack(Q(1, 5), Q(1, 8), Q(1), (lo, UNIT // 4))
    micro = small(rng, [tile], counts=rng.choice(((1, 1, 1), (2, 1, 1), (1, 2, 2))))
    cell = rng.randrange(len(micro.cells[0]))
    for w in rng.sample(ALL, rng.randint(3, 6)):
        axis, n = micro.wall_index(0, cell, w)
        micro.walls[0][axis][n] = rng.choice((UNIT, UNIT // 2, UNIT // 4 + 1 if rng.random() < .3 else UNIT))
    yield "G1_range", told(micro, "G1")


def in_collapsed_walls(rng):
    """G2: a cap lies in a face that is collapsed."""
    plan = in_json(cage_named(rng.choice(("a wedge", "a pyramid", "a fan", "six pyramids", "half collapsed, split"))))
    places = [f for f, code in enumerate(plan.codes) if code == 1]
    f = rng.choice(places)
    n = rng.choice((1, 2))
    tile = plain_tile(rng)
    lists = [rng.randint(*tile.extent) for _ in range(9)] if tile.extent else None
    breaks = even_breaks(plan, f // 6, n)
    micro = examples.Micro(plan, [(f // 6, breaks)], [tile], [[0] * n ** 3],
                           lists and [[[lists[0]] * (n * n * (n + 1))] * 3])
    yield "G2_collapsed", told(micro, "G2")


def caps_that_differ(rng):
    """T4: beside each other are tiles whose caps are not equal, by a hair or more; in a grid, or in two grids."""
    wall, what = rng.randrange(6), rng.randrange(6)
    line = line_along(wall // 2)
    if what == 0:                                         # sizes
        a = examples.jack(Q(1, 5), Q(1, 8), Q(0))
        b = examples.jack(Q(1, 5), Q(1, 8) + rng.choice((HAIR, -HAIR, Q(1, 32))), Q(0))
        tiles = [a, b]
    elif what == 1:                                       # one vertex, in each patch that has it
        a, b = examples.jack(Q(1, 5), Q(1, 8), Q(0)), examples.jack(Q(1, 5), Q(1, 8), Q(0))
        side = OPPOSITE[wall] if wall % 2 else wall
        name = rng.choice([v for v in b.vertices if b.wall_of(v) == side])
        axis = rng.choice(examples.OTHERS[side // 2])
        of, point, more = b.vertices[name]
        b.vertices[name] = of, tuple(c + rng.choice((-1, 1)) * HAIR if k == axis else c for k, c in enumerate(point)), more
        b.patches = [b.patch(k) for k in range(30)]
        b.exit = rng.choice([4 + 5 * w for w in ALL if w != side])
        tiles = [a, b]
    elif what == 2:                                       # squares that touch in a corner
        first = list(itertools.product((1, 2), repeat=2))
        second = list(itertools.product((2, 3), repeat=2))
        exits = {(wall + 2) % 6: examples.pattern("centre", 5)}
        low, high = sorted((wall, OPPOSITE[wall]))
        tiles = [with_patterns(5, {**exits, high: first}), with_patterns(5, {**exits, low: second})]
    elif what == 3:                                       # one has another cap, or a cap more, where the next one has a large one
        low, high = sorted((wall, OPPOSITE[wall]))
        exits = {(wall + 2) % 6: examples.pattern("centre", 7)}
        tiles = [with_patterns(7, {**exits, high: examples.pattern(rng.choice(("ring", "block")), 7)}),
                 with_patterns(7, {**exits, low: examples.pattern(rng.choice(("centre", "corners")), 7)})]
    elif what == 4:                                       # a square inside a ring's hole: not apart by hulls
        low, high = sorted((wall, OPPOSITE[wall]))
        tiles = [with_patterns(5, {high: examples.pattern("block", 5), (wall + 2) % 6: examples.pattern("centre", 5)}),
                 with_patterns(5, {low: [(1, 1), (1, 2), (2, 1), (2, 2)], (wall + 2) % 6: examples.pattern("centre", 5)})]
    else:                                                 # the same outlines, cut in another way
        a, b = examples.jack(Q(1, 5), Q(1, 8), Q(0)), examples.jack(Q(1, 5), Q(1, 8), Q(0))
        n = 4 + 5 * (OPPOSITE[wall] if wall % 2 else wall)
        _, _, (points,) = b.patches[n]
        patch = examples.raised(examples.raised((None, (1, 1), [points]), 0), 1)
        middle = [list(p) for p in patch[2][0]]
        axis = rng.choice(examples.OTHERS[wall // 2])
        middle[4][axis] += rng.choice((HAIR, Q(1, 64)))
        b.patches[n] = patch[0], patch[1], [middle]
        b.exit = next(4 + 5 * w for w in ALL if 4 + 5 * w != n)
        tiles = [a, b]
    micro = small(rng, tiles, [[0, 1]], counts=line)
    if rng.random() < .4:                                 # in two grids
        volume, breaks = micro.grids[0]
        axis = wall // 2
        halves = [(volume, [b[k:k + 2] if a == axis else b for a, b in enumerate(breaks)]) for k in (0, 1)]
        if all(len(set(t)) == 2 for t in micro.cage.maps[0].knots):
            micro = examples.Micro(micro.cage, halves, tiles, [[0], [1]], micro.walls and [[[micro.walls[0][0][0]] * 2] * 3] * 2)
    yield "T4_differ", told(micro, "T4")


def numbers_that_differ(rng):
    """T4: the wall of two volumes, or of two grids, or of a ring has another number on one side."""
    plan = in_json(cage_named(rng.choice(("two", "two, one of them mirrored and turned", "two with breaks", "curved pair", "a ring", "three in a row"))))
    tile = examples.jack(Q(1, 5), Q(1, 8), Q(1, 8))
    k = rng.randrange(UNIT)
    if len(plan.maps) == 1:
        knots = plan.maps[0].knots
        grids = [(0, [sorted(set(t)) for t in knots])]
    else:
        grids = [(v, even_breaks(plan, v, 1)) for v in range(len(plan.maps)) if all(len(set(t)) == 2 for t in plan.maps[v].knots) or True]
        grids = [(v, [sorted(set(t)) for t in plan.maps[v].knots]) for v, _ in grids]
        if len({tuple(len(b) for b in breaks) for _, breaks in grids}) > 1:
            return
    micro = examples.Micro(plan, grids, [tile], [], [])
    for _, breaks in grids:
        counts = [len(b) - 1 for b in breaks]
        size = counts[0] * counts[1] * counts[2]
        micro.cells.append([0] * size)
        micro.walls.append([[k] * (size // n * (n + 1)) for n in counts])
    walls = [(g, c, w) for g, c in micro.held() for w in ALL if micro.code(g, c, w) == 2 or isinstance(micro.code(g, c, w), tuple)]
    g, c, w = rng.choice(walls)
    axis, n = micro.wall_index(g, c, w)
    micro.walls[g][axis][n] = rng.choice((k + 1, max(0, k - 1) if k else 1, UNIT, 0 if k else 1))
    if micro.walls[g][axis][n] != k:
        yield "T4_numbers", told(micro, "T4")


def driven_by_other_walls(rng):
    """T4: caps depend on the numbers of other walls than their own, and these differ."""
    wall = rng.randrange(6)
    driver = [(w + rng.choice([d for d in range(2, 6) if (w + d) % 6 // 2 != w // 2])) % 6 for w in ALL]
    tile = examples.lattice_tile(3, [examples.pattern("centre", 3)] * 6, scale=(Q(9, 10), Q(1, 20)), driver=driver)
    axis, k = wall // 2, rng.randrange(UNIT)
    counts = line_along(axis)
    micro = small(rng, [tile], [[0, 0]], counts=counts, walls=[[[k] * (2 // n * (n + 1)) for n in counts]])
    of, n = micro.wall_index(0, 0, driver[2 * axis + 1])
    micro.walls[0][of][n] = rng.choice((k + 1, UNIT))
    yield "T4_driven", told(micro, "T4")


def turned_caps(rng):
    """T4: caps that a turn changes, in the wall of two volumes whose parameters are turned."""
    plan = in_json(cage_named(rng.choice(("two, one of them mirrored and turned", "two with breaks", "a ring", "two"))))
    of = [v for v in itertools.product(range(1, 5), repeat=2) if v != (4, 4)]
    walls = {w: of if rng.random() < .7 else [(5 - i, j) for i, j in of] for w in ALL}
    walls[5] = examples.pattern("centre", 5)
    tile = with_patterns(5, walls, scale=(Q(9, 10), Q(0)))
    grids = [(v, [sorted(set(t)) for t in m.knots]) for v, m in enumerate(plan.maps)]
    micro = examples.Micro(plan, grids, [tile], [[0] * ((len(b[0]) - 1) * (len(b[1]) - 1) * (len(b[2]) - 1)) for _, b in grids])
    meet = sum(isinstance(code, tuple) for code in plan.codes) + sum(len(of_grid) - 1 for of_grid in micro.cells)
    if micro.equal_walls() != meet:
        yield "T4_turned", told(micro, "T4")
    micro = turned_pair(rng, rng.choice(IMAGES))
    if not micro.equal_walls():
        yield "T4_turned", told(micro, "T4")


def coarse_and_fine_overlap(rng):
    """T4: caps of a coarse cell overlap or touch those of fine ones."""
    micro = coarse_and_fine(rng)
    is_third = max(map(len, micro.cells)) % 3 == 0
    sizes = (Q(1, 8), Q(1, 5)) if is_third else (Q(1, 4), Q(1, 5), Q(1, 6))
    lie = examples.Micro(micro.cage, micro.grids, [examples.jack(Q(1, 5), rng.choice(sizes), Q(0))], micro.cells)
    yield "T4_fine", told(lie, "T4")
    if is_third:                                          # another number on one side
        lie = micro.changed(walls=[[[k + 1 if k else k for k in w] for w in lists] for lists in micro.walls])
        yield "T4_fine", told(lie, "T4")


def wrong_numbers(rng):
    micro = some_micro(rng)
    for key in rng.sample(examples.KEYS, 3):
        step = rng.choice((-1, 1, 2))
        if micro.values[key] + step >= 0:
            yield "W3_" + key, micro.changed(values={**micro.values, key: micro.values[key] + step})


def other_cells(rng):
    """The numbers are those before a cell was emptied, or before a tile without one of the caps came into it."""
    micro = some_micro(rng)
    held = micro.held()
    if not held:
        return
    g, c = rng.choice(held)
    lie = micro.changed(cells=[list(of_grid) for of_grid in micro.cells])
    lie.cells[g][c] = None
    if lie.walls is not None:
        lie.walls = [[list(w) for w in lists] for lists in micro.walls]
        for w in ALL:
            axis, n = lie.wall_index(g, c, w)
            step = 1 if w % 2 else -1
            index = list(lie.index(g, c))
            index[w // 2] += step
            counts = lie.counts(g)
            inside = 0 <= index[w // 2] < counts[w // 2]
            if not inside or lie.cells[g][(index[0] * counts[1] + index[1]) * counts[2] + index[2]] is None:
                lie.walls[g][axis][n] = 0
    yield "W3_cell", lie


def bad_hints(rng):
    """B2: a centre is too long, or there are too many coefficients."""
    if rng.random() < .1:
        tile = examples.jack()
        tile.patches = [patch if n == tile.exit or n % 2 else long_patch(patch) for n, patch in enumerate(tile.patches)]
        tiles = [tile] * 5
        yield "B2_size", told(small(rng, tiles, [[0]], counts=(1, 1, 1)))
        return
    tile = plain_tile(rng)
    micro = small(rng, [tile])
    middle = [sum(c) / 4 for c in zip(*[tile.at(name, [(tile.extent or (0, 0))[0]] * 6) for name in tile.quads[tile.exit]])]
    axis = next(a for a in range(3) if middle[a] in (0, 1))
    at = rng.choice((HALF + Q(1, (1 << 64) + 1), HALF - Q(1, 1 << 64), Q(0), Q(1), Q(-1, 2), Q(3, 2)))
    micro.hints = [(tuple(at if a == axis else c for a, c in enumerate(tile.centre)), tile.exit)]
    yield "B2_centre", told(micro, "B2")


def long_patch(patch):
    for _ in range(6):
        patch = examples.raised(examples.raised(patch, 0), 1)
    wall, degrees, lists = patch
    return (wall, degrees, lists + [[[Q(0)] * 3] * len(lists[0])] * (4 - len(lists))) if wall is not None else patch


def false_cages(rng):
    """The cage is folded or overlaps itself, or its part of the body is bent."""
    name = rng.choice(vmodel_liars.NAMES)
    plan = vmodel_liars.false_models.false(name)[0] if rng.random() < .6 else vmodel_liars.bent(cage_named(rng.choice(CAGES)), rng)
    if all(len(m.degrees) == 3 for m in plan.maps):
        tile = plain_tile(rng, (0, 1))
        tile = examples.lattice_tile(3, [examples.pattern("centre", 3) if w == 1 else [] for w in ALL], (Q(9, 10), Q(0)))
        lie = examples.Micro(in_json(plan.changed(text=None)), [(0, [sorted(set(t)) for t in plan.maps[0].knots])], [tile], [])
        counts = lie.counts(0)
        lie.cells = [[0] * (counts[0] * counts[1] * counts[2])]
        yield "cage_" + name.replace(" ", "_") if plan.text else "cage_bent", lie.changed(values=dict.fromkeys(examples.KEYS, 1))


def malformed(rng):
    true = small(rng, [plain_tile(rng)])
    body = true.body()
    for n in rng.sample(range(len(body)), 2):
        yield "cut_off", true.changed(values=dict.fromkeys(examples.KEYS, 1), body=lambda n=n: body[:n])
    values = dict.fromkeys(examples.KEYS, 1)
    yield "too_long", true.changed(values=values, tail=b"\0")
    yield "count", true.changed(values=values, count=rng.choice((0, 2, (1 << 32) - 1)))
    yield "exit", true.changed(values=values, hints=[(true.hints[0][0], len(true.tiles[0].patches))])
    yield "magic", true.changed(values=values, magic=rng.choice((b"VTVM", b"vtms")))


STRATEGIES = ((open_tiles, 8), (folded_tiles, 8), (wound_tiles, 8), (full_cells, 5), (bulging, 6), (keels, 4), (crossing_keels, 3), (tips, 5), (pinched, 5), (bad_members, 6),
              (out_of_range, 6), (in_collapsed_walls, 6), (caps_that_differ, 14), (numbers_that_differ, 8), (driven_by_other_walls, 4), (turned_caps, 4),
              (coarse_and_fine_overlap, 6), (wrong_numbers, 8), (other_cells, 4), (bad_hints, 4), (false_cages, 10), (malformed, 1),
              *micro_bridge_liars.STRATEGIES, *micro_sweep_liars.STRATEGIES)
ALONE = (false_cages, malformed, micro_bridge_liars.forged_slices, micro_bridge_liars.false_boxes,      # their lies are in the cage or the body
         micro_sweep_liars.forged_hints)
VARIANTS = 40                                             # of each other lie


def told_by(strategy, rng):
    for name, lie in strategy(rng):
        yield name, lie.text(), lie.certificate()


def micro_attacks(rng):
    """(name, model, certificate)"""
    strategy, = rng.choices([s for s, _ in STRATEGIES], [w for _, w in STRATEGIES])
    for name, lie in strategy(rng):
        yield name, lie.text(), lie.certificate()
        for other in micro_variants.variants(lie, rng, 0 if strategy in ALONE else VARIANTS):
            yield name, other.text(), other.certificate()


class Run(vmodel_liars.Run):
    conditions, implied = CONDITIONS, {}

    @staticmethod
    def attacks(rng):
        return patch_attacks.subjects(micro_attacks(rng))

    @staticmethod
    def honest_certificates(rng):
        return patch_attacks.subjects(honest(rng))

    def attack(self, name, case, cert, seed):
        super().attack(name, case, cert, seed)
        if name in PARTS and self.alone[name] < self.often_enough:
            self.alone[name] += self.py._check(case.bytes, cert, frozenset([name]))[0] == 0


def missing_conditions(alone):
    return vmodel_liars.missing_conditions(alone, CONDITIONS + PARTS)


if __name__ == "__main__":
    sys.exit(vmodel_liars.main(sys.argv[1:], Run, "micro", CONDITIONS + PARTS))
