# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Lies of the claim microstructure-1 about sweeps (Q1 to Q4); the rest is right. micro_liars.py tells them beside its own.

The cages are affine images of the unit cube, and sweeps are given in its parameters, where the truth about them is known by hand; whether Q2 holds
is found by the tests' own computation, which knows curved cages, too."""
import functools
import itertools
import math
import pathlib
import random
import sys
from fractions import Fraction as Q

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import micro_bridge_examples as bridged                   # noqa: E402
import micro_bridge_liars as bridge_liars                 # noqa: E402
import micro_examples as examples                         # noqa: E402
import micro_variants                                     # noqa: E402
import vmodel_forge                                       # noqa: E402
import vmodel_models as models                            # noqa: E402

HAIR, POOL = Q(1, 1 << 40), 24
Row = bridge_liars.Row


# ---------------------------------------------------------------- affine cages

@functools.lru_cache(POOL)
def affine(k):
    """(cage, matrix) of a cage that is an affine image of the unit cube; half of them are mirrored."""
    rng = random.Random(k)
    matrix = [[Q(rng.choice((1, 2, 3)) if i == j else rng.choice((0, 0, 0, 1, -1, 2)) * (i < j)) for j in range(3)] for i in range(3)]
    rng.shuffle(matrix)
    shift = [Q(rng.randint(-8, 8), 4) for _ in range(3)]
    cage = models.mapped(models.cube(), lambda p: tuple(s + c for s, c in zip(shift, times(matrix, p))))
    flag = int(bridge_liars.det(matrix) < 0)
    return micro_variants.Fixed(vmodel_forge.proved([cage], flags=[flag])), matrix


def times(matrix, p):
    return tuple(sum(a * b for a, b in zip(row, p)) for row in matrix)


class SweepRow(Row):
    """A row of cells in an affine cage. Its sweeps are `clear` of the border of the parameters or not: they are in space."""

    def __init__(self, rng, n=4, held=(0,), tile=None, **more):
        super().__init__(rng, n, held, tile, **more)
        cage, self.matrix = affine(rng.randrange(POOL))
        self.plan = self.plan.changed(cage=cage)

    def vector(self, along, across=(0, 0)):
        """In the parameters: a step along the row, as counted from the first cell, and steps along the other axes."""
        found = list(across)
        found.insert(self.axis, along if self.is_up else -along)
        return [Q(c) for c in found]

    def sweep(self, e, f, cell=0, is_forward=True, wall=None, depth=Q(1, 4)):
        """e, f: in the parameters. Its hint is right if one with K = the inverse of the cage's matrix exists."""
        wall = self.wall(is_forward) if wall is None else wall
        axis, sign = wall // 2, 1 if wall % 2 else -1
        speeds = [Q(2)]
        for g in (e, [b - a for a, b in zip(e, f)]):
            ahead, beside = sign * g[axis], sum(c * c for a, c in enumerate(g) if a != axis)
            if beside and ahead > 0:
                speeds.append(2 * ahead / beside)
        speed = min(speeds).limit_denominator(1 << 20)
        return bridged.Sweep(0, self.cell(cell), wall, times(self.matrix, e), times(self.matrix, f), bridged.inverse(self.matrix), depth,
                             speed if speed > 0 else Q(1))

    def straight(self, length, cell=0, is_forward=True, across=(0, 0), depth=Q(1, 4)):
        step = self.vector(length if is_forward else -length, across)
        return self.sweep([c / 2 for c in step], step, cell, is_forward, depth=depth)

    def with_sweeps(self, *sweeps):
        return self.plan.changed(sweeps=sorted(sweeps, key=lambda s: (s.grid, s.cell, s.wall)),
                                 values={**self.plan.values, "bridges": len(sweeps)})

    def width(self, c):
        return self.places[c + 1] - self.places[c]


def along(sweep, row, e, f):
    """The sweep with another curve."""
    return sweep.changed(e=times(row.matrix, e), f=times(row.matrix, f))


def some_length(rng, row, cell=1):
    return row.width(cell) * Q(rng.randint(3, 14), 16)


# ---------------------------------------------------------------- Q2, by the tests' own computation

def keeps_q2(plan, sweep):
    volume, breaks = plan.grids[sweep.grid]
    m, index, axis, end = plan.cage.maps[volume], plan.index(sweep.grid, sweep.cell), sweep.wall // 2, sweep.wall % 2
    ends = [b[i:i + 2] for b, i in zip(breaks, index)]
    lo, hi = ends[axis]
    ends[axis] = [hi - sweep.depth * (hi - lo), hi] if end else [lo, lo + sweep.depth * (hi - lo)]
    net = m.all()
    for a in range(3):
        net = vmodel_forge.along(net, a, m, *ends[a])
    slab = columns_of(net, ends)
    if not all(is_good(sweep.matrix, [column[at] for column in slab[:3]]) for at in slab[0]):
        return False
    last = max(at[axis] for at in net)
    wall = columns_of({at[:axis] + (0,) + at[axis + 1:]: p for at, p in net.items() if at[axis] == end * last}, ends)
    sign = 1 if end else -1
    for g in (sweep.e, [b - a for a, b in zip(sweep.e, sweep.f)]):
        for at, square in wall[3].items():
            found = [column and column[at] for column in wall[:3]]
            found[axis] = [sign * sweep.speed * square * c for c in g]
            if not is_good(sweep.matrix, found):
                return False
    return True


def is_good(matrix, columns):
    return bridge_liars.is_definite([[sum(a * b for a, b in zip(row, column)) for column in columns] for row in matrix])


def columns_of(net, ends):
    """The coefficients of W^2 times the derivatives along the three axes (None along one of degree 0), and of W^2."""
    degrees = [max(at[a] for at in net) for a in range(3)]
    lists, found = [{at: p[c] for at, p in net.items()} for c in range(4)], []
    for a in range(3):
        if degrees[a] == 0:
            found.append(None)
            continue
        lower = [d - (b == a) for b, d in enumerate(degrees)]
        step = tuple(int(b == a) for b in range(3))
        slopes = [{at: degrees[a] * (of[tuple(map(sum, zip(at, step)))] - of[at]) / (ends[a][1] - ends[a][0]) for at in order(lower)} for of in lists]
        one, columns = {at: Q(1) for at in order(step)}, []
        for c in range(3):
            first = product(lists[3], degrees, slopes[c], lower)
            second = product(slopes[3], lower, lists[c], degrees)
            both = {at: first[at] - second[at] for at in first}
            columns.append(product(both, [d + e for d, e in zip(degrees, lower)], one, step))
        found.append({at: [column[at] for column in columns] for at in columns[0]})
    return [*found, product(lists[3], degrees, lists[3], degrees)]


def order(degrees):
    return itertools.product(*[range(d + 1) for d in degrees])


def product(f, degrees, g, more):
    """The Bernstein coefficients of a product."""
    total, found = [a + b for a, b in zip(degrees, more)], {}
    for i, x in f.items():
        for j, y in g.items():
            at = tuple(map(sum, zip(i, j)))
            found[at] = found.get(at, 0) + x * y * binomials(degrees, i) * binomials(more, j) / binomials(total, at)
    return found


def binomials(degrees, index):
    return Q(math.prod(map(math.comb, degrees, index)))


# ---------------------------------------------------------------- lies

def misled_sweeps(rng):
    """Q2: the sweep goes back into its cell, along its wall or nowhere; K, d or l are wrong, or those of another sweep."""
    row = SweepRow(rng)
    length = some_length(rng, row)
    lean = [length * Q(rng.randint(-4, 4), 8) for _ in range(2)]
    true, what = row.straight(length, across=lean), rng.randrange(9)
    if what == 0:                                         # into its own arm, so short that it stays in the slab
        short = row.vector(row.width(0) * Q(rng.randint(1, 3), 16))
        lie = along(true, row, [-c / 2 for c in short], [-c for c in short])
        lie = lie if rng.random() < .5 else lie.changed(matrix=[[-c for c in line] for line in lie.matrix])
    elif what == 1:                                       # out and back to the cap
        out = row.vector(length)
        lie = along(true, row, out, [c * rng.choice((Q(0), Q(1, 2), Q(1))) for c in out])
    elif what == 2:                                       # nowhere at first, or nowhere
        out = row.vector(length)
        lie = along(true, row, [Q(0)] * 3, rng.choice((out, [Q(0)] * 3)))
    elif what == 3:                                       # along the wall
        lie = along(true, row, row.vector(0, (length, Q(0))), row.vector(0, (2 * length, Q(0))))
    elif what == 4:
        signs = rng.choice(((-1, -1, -1), (-1, -1, 1), (1, -1, -1), (-1, 1, -1), (0, 0, 0), (1, 1, 0)))
        lie = true.changed(matrix=[[s * c for c in line] for s, line in zip(signs, true.matrix)])
    elif what == 5:                                       # K of a sweep across another axis, or of another cage
        turn = rng.choice((1, 2))
        other = affine(rng.randrange(POOL))[1]
        lie = true.changed(matrix=rng.choice((true.matrix[turn:] + true.matrix[:turn], bridged.inverse(other),
                                              [list(line) for line in zip(*true.matrix)])))
    elif what == 6:                                       # l, for a sweep that leans
        step = row.vector(length, [length * Q(rng.choice((-1, 1)) * rng.randint(4, 12), 8) for _ in range(2)])
        true = row.sweep([c / 2 for c in step], step)
        lie = true.changed(speed=true.speed * rng.choice((2, 3, 8, 1 << 20)))
    elif what == 7:
        yield from deep_slabs(rng)
        return
    else:                                                 # the wall on the other side of the cell, or across another axis
        lie = true.changed(wall=rng.choice([w for w in range(6) if w != true.wall]))
    if not keeps_q2(row.plan, lie):
        yield "Q2_misled", row.with_sweeps(lie)


def deep_slabs(rng):
    """Q2: K holds at the wall of a curved cage, but not in all of the slab."""
    cage = bow(rng.randrange(4))
    plan = bridged.Micro(cage, [(0, [[Q(0), Q(1)]] * 3)], [examples.jack(grows=Q(0))], [[0]])
    plan.values = dict(cells=1, tiles=1, glued_caps=0, components=1, shells=1, genus=0, bridges=1)
    true = bridged.swept(plan, 0, 0, rng.randrange(2), Q(1, 4), depth=Q(1, 64))
    for depth in (Q(1), Q(3, 4), Q(1, 2)):
        lie = true.changed(depth=depth)
        if keeps_q2(plan, true) and not keeps_q2(plan, lie):
            yield "Q2_deep", plan.changed(sweeps=[lie])


@functools.lru_cache(None)
def bow(k):
    """A cage whose first axis turns by more than a right angle."""
    turn = ((1, 0), (1, 1), (Q(-1, 2) - Q(k, 8), 1))

    def point(i, j, k):
        return ((2 + j) * turn[i][0], (2 + j) * turn[i][1], Q(k))
    return micro_variants.Fixed(vmodel_forge.proved([models.spline((2, 1, 1), [[Q(0)] * 3 + [Q(1)] * 3] + [[Q(0)] * 2 + [Q(1)] * 2] * 2, point)], flags=[1]))


def loose_sweeps(rng):
    """Q1: the cap is glued, has many patches, or the wall has no cap."""
    what = rng.randrange(3)
    if what == 0:
        row = SweepRow(rng, held=(0, 1))
        length = row.width(1) * Q(rng.randint(1, 3), 16)
        yield "Q1_glued", row.with_sweeps(row.straight(length))
    elif what == 1:
        row = SweepRow(rng, tile=examples.lattice_tile(5, [examples.pattern("block", 5)] * 6, scale=(Q(9, 10), Q(0))))
        yield "Q1_many", row.with_sweeps(row.straight(some_length(rng, row)))
    else:
        row = SweepRow(rng)
        kinds = ["none" if w == row.wall() else "block" for w in range(6)]
        row.plan.tiles[0] = tile = examples.lattice_tile(3, [examples.pattern(kind, 3) for kind in kinds], scale=(Q(9, 10), Q(0)))
        row.plan.hints = [(tile.centre, tile.exit)]
        yield "Q1_none", row.with_sweeps(row.straight(some_length(rng, row)))


def sweeps_into_tiles(rng):
    """Q3: the sweep touches the cap of another tile, enters it or passes through it, straight or bent."""
    row, what = SweepRow(rng, 4, (0, 2)), rng.randrange(4)
    gap = row.width(1)
    if what == 0:                                         # onto the cap, by a hair or more
        lie = row.straight(gap + rng.choice((0, HAIR, Q(1, 64))))
    elif what == 1:                                       # through all of it
        lie = row.straight(gap + row.width(2) + row.width(3) * Q(rng.randint(1, 8), 4))
    elif what == 2:                                       # askew
        step = row.vector(gap + row.width(2) * Q(rng.randint(1, 3), 4), [Q(rng.randint(-2, 2), 64) for _ in range(2)])
        lie = row.sweep([c / 2 for c in step], step)
    else:                                                 # aside, and back
        out = gap + row.width(2) * Q(1, 4)
        lie = row.sweep(row.vector(out / 2, (Q(rng.choice((-1, 1)), 4), Q(0))), row.vector(out))
    if keeps_q2(row.plan, lie):
        yield "Q3_tile", row.with_sweeps(lie)


@functools.lru_cache(None)
def hook():
    """A cage like a hook, one leg of which is longer, with a jack in its only cell. In one plane the ends of the first axis point down."""
    middle = ((1, -1), (1, 2), (-1, 2), (-1, 0))

    def point(i, j, k):
        return (*[c * (1 + j) for c in middle[i]], Q(k))
    volume = models.spline((3, 1, 1), [[Q(0)] * 4 + [Q(1)] * 4] + [[Q(0)] * 2 + [Q(1)] * 2] * 2, point)
    plan = bridged.Micro(micro_variants.Fixed(vmodel_forge.proved([volume], flags=[1])), [(0, [[Q(0), Q(1)]] * 3)], [examples.jack(grows=Q(0))], [[0]])
    plan.values = dict(cells=1, tiles=1, glued_caps=0, components=1, shells=1, genus=0, bridges=1)
    return plan


def across_the_hook(length, down, depth):
    """From the shorter leg towards the longer one, which it meets beyond the length 11/4."""
    true = bridged.swept(hook(), 0, 0, 1, Q(1, 4), depth=depth)
    f = (length, -down, Q(0))
    return true.changed(e=tuple(c / 2 for c in f), f=f, speed=down / (64 * length ** 2))


def sweeps_into_themselves(rng):
    """Q3: the sweep meets another arm of its own tile, outside of the slab."""
    lie = across_the_hook(Q(rng.randint(24, 32), 8), Q(rng.randint(1, 4), 8), rng.choice((Q(1, 64), Q(1, 32))))
    if keeps_q2(hook(), lie):
        yield "Q3_own", hook().changed(sweeps=[lie])


def sweeps_in_touch(rng):
    """Q4: two sweeps meet head on, or lean against each other."""
    if rng.random() < .5:
        row = SweepRow(rng, rng.choice((3, 4)), (0, 2))
        gap = row.width(1)
        first = gap * Q(rng.randint(1, 8), 9)
        second = gap - first + rng.choice((0, HAIR, first / 3))
        yield "Q4_head_on", row.with_sweeps(row.straight(first, 0), row.straight(second, 2, False))
        return
    row = SweepRow(rng, 2, (0, 1))
    axis = rng.choice([a for a in range(3) if a != row.axis])
    wall, height = 2 * axis + rng.randrange(2), Q(rng.randint(2, 6), 4)
    apart = (row.places[2] - row.places[0]) / 2
    sweeps = []
    for cell, lean in ((0, apart / 2 * rng.choice((1, Q(9, 8)))), (1, -apart / 2)):
        step = row.vector(lean)
        step[axis] = height if wall % 2 else -height
        sweeps.append(row.sweep([c / 2 for c in step], step, cell, wall=wall))
    plan = row.with_sweeps(*sweeps)
    if all(keeps_q2(plan, sweep) for sweep in sweeps):
        yield "Q4_lean", plan


def forged_hints(rng):
    """B1, B2: depths and speeds that the page forbids, numbers of too many digits, a sweep without its hint."""
    row, what = SweepRow(rng), rng.randrange(4)
    true, long = row.straight(some_length(rng, row)), Q(1, (1 << 64) + 1)
    if what == 0:
        fields = rng.choice(({"depth": Q(0)}, {"depth": 1 + HAIR}, {"depth": Q(-1, 2)}, {"speed": Q(0)}, {"speed": -true.speed}))
        yield "B1_hint", row.with_sweeps(true.changed(**fields))
    elif what == 1:
        fields = rng.choice(({"depth": Q(1, 4) - long}, {"speed": true.speed + long}, {"speed": Q(1 << 64)}))
        yield "B2_hint", row.with_sweeps(true.changed(**fields))
    elif what == 2:
        yield "B2_matrix", row.with_sweeps(true.changed(matrix=[[c + long for c in line] for line in true.matrix]))
    else:
        other = row.straight(some_length(rng, row), is_forward=False)
        lie = row.with_sweeps(true, other) if rng.random() < .5 else row.with_sweeps()
        lie.made = row.with_sweeps(true).text()
        yield "B1_dropped", lie


def uncounted_sweeps(rng):
    """W3: sweeps are not counted as bridges, or as something else."""
    row = SweepRow(rng)
    true = row.with_sweeps(row.straight(some_length(rng, row)))
    key, step = rng.choice((("bridges", -1), ("bridges", 1), ("glued_caps", 1), ("tiles", 1), ("components", 1)))
    yield "W3_sweeps", true.changed(values={**true.values, key: true.values[key] + step})


STRATEGIES = ((misled_sweeps, 16), (loose_sweeps, 8), (sweeps_into_tiles, 10), (sweeps_into_themselves, 4), (sweeps_in_touch, 10),
              (forged_hints, 6), (uncounted_sweeps, 3))


# ---------------------------------------------------------------- the truth

def honest_plan(rng):
    """Sweeps from all free walls of one or two tiles, straight, leaning or bent, that end before they meet anything."""
    row = SweepRow(rng, held=rng.choice(((0,), (0, 2), (1,))))
    sweeps, walls = [], []
    for c, tile in enumerate(row.plan.cells[0]):
        walls += [(c, w) for w in range(6)] if tile is not None else []
    for cell, wall in rng.sample(walls, rng.randint(1, len(walls))):
        width = [b[i + 1] - b[i] for b, i in zip(row.plan.grids[0][1], row.plan.index(0, cell))]
        least = min(row.width(c) for c in range(4))
        axis, sign = wall // 2, 1 if wall % 2 else -1
        e = [least * Q(rng.randint(-2, 2), 32) for _ in range(3)]
        e[axis] = sign * least * Q(rng.randint(2, 5), 32)
        f = [2 * c + least * Q(rng.randint(-1, 1), 64) for c in e]
        counted = cell if row.is_up else row.n - 1 - cell
        sweeps.append(row.sweep(e, f, counted, wall=wall, depth=rng.choice((Q(1, 16), Q(1, 3), Q(1))) if min(width) else Q(1)))
    return row.with_sweeps(*sweeps)
