# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Lies of the claim microstructure-1 about bridges (R1 to R4), tiles that star boxes prove (F3), and cells in a row; the rest is right.
micro_liars.py tells them beside its own. The numbers of the statements are counted by hand: a jack is a ball, two jacks in a row make one."""
import functools
import itertools
import pathlib
import sys
from fractions import Fraction as Q

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import micro_bridge_examples as bridged                   # noqa: E402
import micro_examples as examples                         # noqa: E402
import vmodel_models as models                            # noqa: E402

HAIRS = (Q(1, 1 << 30), Q(-1, 1 << 60), Q(1, 1 << 12), Q(-1, 100))
CAGES = ("cube", "bent", "rational", "mirrored")          # with the parameters [0, 1]^3


# ---------------------------------------------------------------- rows of cells

class Row:
    """n cells in a row along an axis, of which `held` hold the tile; the first or the last one has a bridge from its inner wall."""

    def __init__(self, rng, n=4, held=(0,), tile=None, **more):
        self.axis, self.is_up = rng.randrange(3), rng.random() < .5
        steps = [rng.randint(3, 6) for _ in range(n)]
        self.places = [Q(sum(steps[:i]), sum(steps)) for i in range(n + 1)]
        held = held if self.is_up else [n - 1 - c for c in held]
        along = self.places if self.is_up else [1 - x for x in self.places[::-1]]
        breaks = [along if a == self.axis else [Q(0), Q(1)] for a in range(3)]
        self.tile, self.n = tile or examples.jack(Q(1, 5), rng.choice((Q(1, 8), Q(1, 10), Q(1, 7))), Q(0)), n
        cells = [0 if c in held else None for c in range(n)]
        self.plan = bridged.Micro(models.honest(rng.choice(CAGES)), [(0, breaks)], [self.tile], [cells], **more)
        glued = sum(a == b == 0 for a, b in zip(cells, cells[1:]))
        parts = len(held) - glued
        self.plan.values = dict(cells=n, tiles=len(held), glued_caps=glued, components=parts, shells=parts, genus=0, bridges=0)

    def place(self, x):
        """A coordinate along the row, as counted from the first cell."""
        return x if self.is_up else 1 - x

    def cell(self, c):
        return c if self.is_up else self.n - 1 - c

    def wall(self, is_end=True):
        return 2 * self.axis + (is_end == self.is_up)

    def bridge(self, end, cell=0, is_forward=True, cuts=()):
        return bridged.straight(self.plan, 0, self.cell(cell), self.wall(is_forward), self.place(end), cuts=cuts)

    def at(self, point, x):
        """The point with another coordinate along the row."""
        return tuple(self.place(x) if a == self.axis else c for a, c in enumerate(point))

    def to(self, bridge, end):
        """The bridge with its lists 1 and 2 at other places."""
        first = self.place(bridge.points[0, 0, 0][self.axis])
        return bridge.moved(1, lambda p: self.at(p, (first + end) / 2)).moved(2, lambda p: self.at(p, end))

    def beside(self, point, step):
        """The point moved across the row."""
        b = (self.axis + 1) % 3
        return tuple(c + step if a == b else c for a, c in enumerate(point))

    def with_bridges(self, *bridges):
        return self.plan.changed(bridges=list(bridges), values={**self.plan.values, "bridges": len(bridges)})


def fitted(bridge):
    """With the matrix that belongs to its first corner."""
    return bridge.changed(matrix=bridged.inverse(bridged.jacobian(bridge.points, bridge.degrees)))


def some_end(rng, row):
    """A place before the row's end, beyond the second cell's begin."""
    lo = row.places[1]
    return lo + (1 - lo) * Q(rng.randint(4, 15), 16)


def some_cuts(rng):
    return sorted({Q(rng.randint(1, 31), 32) for _ in range(rng.choice((0, 0, 1, 2)))})


# ---------------------------------------------------------------- R1, by the tests' own computation

def derivative(bridge, axis):
    """{index: vector}: a multiple of the derivative in the degrees of the bridge."""
    top, points = (*bridge.degrees, 2)[axis], bridge.points
    found = {}
    for at in points:
        def step(i, at=at):
            lo, hi = [points[tuple(i + k if a == axis else c for a, c in enumerate(at))] for k in (0, 1)]
            return [b - a for a, b in zip(lo, hi)]
        i, zero = at[axis], [Q(0)] * 3
        low, high = step(i - 1) if i else zero, step(i) if i < top else zero
        found[at] = [i * a + (top - i) * b for a, b in zip(low, high)]
    return found


def is_definite(m):
    """By the pivots of Gauss's scheme."""
    m = [[m[i][j] + m[j][i] for j in range(3)] for i in range(3)]
    for c in range(3):
        if m[c][c] <= 0:
            return False
        for r in range(c + 1, 3):
            f = m[r][c] / m[c][c]
            m[r] = [x - f * y for x, y in zip(m[r], m[c])]
    return True


def det(m):
    return sum(m[0][a] * (m[1][(a + 1) % 3] * m[2][(a + 2) % 3] - m[1][(a + 2) % 3] * m[2][(a + 1) % 3]) for a in range(3))


def keeps_r1(bridge):
    if det(bridge.matrix) <= 0:
        return False
    nets = [derivative(bridge, axis) for axis in range(3)]
    return all(is_definite([[sum(k * nets[c][at][r] for r, k in enumerate(line)) for c in range(3)] for line in bridge.matrix])
               for at in bridge.points)


# ---------------------------------------------------------------- lies

def folded_bridges(rng):
    """R1: a list is beyond the next one, the bridge is left-handed or flat, or K is wrong or another bridge's."""
    row = Row(rng)
    end = some_end(rng, row)
    true = row.bridge(end, cuts=some_cuts(rng))
    what = rng.randrange(7)
    if what == 0:
        lie = true.moved(1, lambda p: row.at(p, end + (1 - end) * Q(rng.randint(0, 7), 8)))
    elif what < 3:
        lie = true.changed(points={(1 - i, j, k): p for (i, j, k), p in true.points.items()})
        lie = lie if what == 1 else fitted(lie)           # det K < 0
    elif what == 3:
        lie = true.changed(matrix=[[Q(0)] * 3] * 3)
    elif what == 4:
        kept = rng.randrange(3)
        lie = true.changed(matrix=[[c if r == kept else -c for c in line] for r, line in enumerate(true.matrix)])
    elif what == 5:                                       # a bridge along another axis
        turn = rng.choice((1, 2))
        lie = true.changed(matrix=[[line[(a + turn) % 3] for a in range(3)] for line in true.matrix])
    else:                                                 # the end is smaller than a point, turned around
        axes = [a for a in range(3) if a != row.axis]
        factor = Q(-rng.randint(1, 8), 8)
        middle = [sum(p[a] for (_, _, k), p in true.points.items() if k == 2) / 4 for a in range(3)]
        lie = true.moved(2, lambda p: tuple(middle[a] + (c - middle[a]) * factor if a in axes else c for a, c in enumerate(p)))
    if not keeps_r1(lie):
        yield "R1_folded", row.with_bridges(lie)


def loose_bridges(rng):
    """R2: the bridge does not start at the cap, by a hair or more; the cap is glued or has many patches, or there is no cap in the wall."""
    what = rng.randrange(6)
    if what < 2:
        row = Row(rng)
        true = row.bridge(some_end(rng, row), cuts=some_cuts(rng))
        step, which = rng.choice(HAIRS), rng.choice(sorted({at[:2] for at in true.points}))
        yield "R2_hair", row.with_bridges(true.changed(points={
            at: row.beside(p, step) if at[2] == 0 and (what == 0 or at[:2] == which) else p for at, p in true.points.items()}))
        return
    if what == 2:
        tile = examples.lattice_tile(5, [examples.pattern("block", 5)] * 6, scale=(Q(9, 10), Q(0)))
        row = Row(rng, tile=tile)
        yield "R2_many", row.with_bridges(row.bridge(some_end(rng, row)))
        return
    row = Row(rng)
    true = row.bridge(some_end(rng, row))
    if what == 3:
        kinds = ["none" if w == row.wall() else "block" for w in range(6)]
        row.plan.tiles[0] = tile = examples.lattice_tile(3, [examples.pattern(kind, 3) for kind in kinds], scale=(Q(9, 10), Q(0)))
        row.plan.hints = [(tile.centre, tile.exit)]
        yield "R2_no_cap", row.with_bridges(true)
    elif what == 4:
        walls = [w for w in range(6) if w // 2 != row.axis]
        yield "R2_border", row.with_bridges(true.changed(wall=rng.choice([*walls, row.wall(False)])))
    else:
        two = Row(rng, held=(0, 1))
        yield "R2_glued", two.with_bridges(two.bridge(some_end(rng, two)))


def bridges_elsewhere(rng):
    """R3: the bridge leaves the volume, ends on its border, leans out of it, or meets its own cell or one of another tile."""
    what = rng.randrange(5)
    if what == 0:
        row = Row(rng)
        end = rng.choice((Q(1), 1 + Q(1, 1 << 50), Q(9, 8), Q(2)))
        yield "R3_box", row.with_bridges(row.bridge(end, cuts=some_cuts(rng)))
    elif what == 1:
        row = Row(rng)
        lie = row.bridge(some_end(rng, row))
        top = max(p[(row.axis + 1) % 3] for p in lie.points.values())
        out, share = 1 - top + rng.choice((0, Q(1, 1 << 40), Q(1, 8))), rng.choice((Q(1, 2), Q(1, 3), Q(1)))
        for k, step in ((1, out * share), (2, out)):
            lie = lie.moved(k, lambda p, step=step: row.beside(p, step))
        yield "R3_leans", row.with_bridges(fitted(lie))
    elif what == 2:                                       # onto or into the cell of another tile
        row = Row(rng, 4, (0, 3))
        end = row.places[3] + rng.choice((0, Q(1, 1 << 50), Q(1, 64)))
        yield "R3_tile", row.with_bridges(row.bridge(end, cuts=some_cuts(rng)))
    elif what == 3:                                       # through it
        row = Row(rng, 4, (0, 2))
        yield "R3_through", row.with_bridges(row.bridge(row.places[3] + (1 - row.places[3]) * Q(rng.randint(1, 7), 8), cuts=some_cuts(rng)))
    else:                                                 # into its own cell; a slice that is not the first one may not touch it
        row = Row(rng)
        true = row.bridge(some_end(rng, row))
        back = row.places[1] - rng.choice((0, 0, Q(1, 1 << 40), Q(1, 64)))
        yield "R3_own_cell", row.with_bridges(true.moved(1, lambda p: row.at(p, back)))


def around_a_ring(rng):
    """R3: a bridge goes around a ring and ends in its own cell."""
    ring = models.honest("a ring")
    x, y, z = [sorted(set(t)) for t in ring.maps[0].knots]
    plan = bridged.Micro(ring, [(0, [x[:2], [y[0], y[-1]], [z[0], z[-1]]])], [examples.jack(grows=Q(0))], [[0]])
    plan.values = dict(cells=1, tiles=1, glued_caps=0, components=1, shells=1, genus=0, bridges=1)
    end = x[1] - rng.choice((0, Q(1, 1 << 30), (x[1] - x[0]) / rng.randint(2, 9)))
    bridge = bridged.straight(plan, 0, 0, 0, end, (0, 0, lambda p: (x[-1] - (p[0] - x[0]), *p[1:])), some_cuts(rng))
    yield "R3_ring", plan.changed(bridges=[bridge])


def meeting_bridges(rng):
    """R4: two bridges touch or overlap."""
    row = Row(rng, rng.choice((3, 4)), (0, 2))
    lo, hi = row.places[1:3]
    first = lo + (hi - lo) * Q(rng.randint(1, 8), 9)
    second = first - rng.choice((0, 0, Q(1, 1 << 20), (first - lo) / 3))
    bridges = row.bridge(first, 0, True, some_cuts(rng)), row.bridge(second, 2, False, some_cuts(rng))
    yield "R4_meet", row.with_bridges(*sorted(bridges, key=lambda bridge: bridge.cell))


def forged_slices(rng):
    """B1, B2: s_j that leave gaps or go back, K of too many digits, a bridge without its hint."""
    row, what = Row(rng), rng.randrange(4)
    true = row.bridge(some_end(rng, row), cuts=some_cuts(rng))
    s = Q(rng.randint(1, 31), 32)
    if what == 0:
        wrong = [s, s], [Q(3, 4), Q(1, 4)], [Q(0), s], [s, Q(1)], [s, Q(5, 4)], [-s], [1 + s]
        yield "B1_slices", row.with_bridges(true.changed(cuts=rng.choice(wrong)))
    elif what == 1:
        yield "B2_slices", row.with_bridges(true.changed(cuts=[s + Q(1, (1 << 64) + 1)]))
    elif what == 2:
        yield "B2_matrix", row.with_bridges(true.changed(matrix=[[c + Q(1, (1 << 64) + 1) for c in line] for line in true.matrix]))
    else:
        lie = row.with_bridges(true, true) if rng.random() < .5 else row.with_bridges()
        lie.made = row.with_bridges(true).text()
        yield "B1_dropped", lie


def flipped_bits(rng):
    """W3: a cell gets or loses a tile, the hash and the number of tiles are right again, another number is not."""
    n = rng.randint(3, 6)
    held = sorted(rng.sample(range(n), rng.randint(1, n - 1)))
    c = rng.randrange(n)
    after = sorted(set(held) ^ {c})
    old, row = Row(rng, n, held).plan.values, Row(rng, n, after)
    true = row.plan.values
    guesses = [{**old, "tiles": true["tiles"]}, {**true, "glued_caps": old["glued_caps"]}, {**true, "components": old["components"]},
               {**true, "shells": old["shells"], "genus": abs(old["shells"] - true["shells"])}, {**true, "tiles": old["tiles"]}]
    lies = [values for values in guesses if values != true]
    yield "W3_bit", row.plan.changed(values=rng.choice(lies))


# ---------------------------------------------------------------- tiles by star boxes

def inside_out(voxels):
    tile = bridged.voxel_tile(5, voxels)
    tile.quads = [quad[::-1] for quad in tile.quads]
    tile.patches = [tile.patch(n) for n in range(len(tile.quads))]
    return tile


@functools.lru_cache(None)
def boxed(kind):
    """(tile, proof, shells, genus)"""
    if kind == "apart":
        tile = bridged.voxel_tile(7, [(1, 1, 1), (5, 5, 5)])
        return tile, bridged.boxes_of(tile), 2, 0
    if kind == "nested":                                  # a hollow cube: one body of two shells
        tile = bridged.voxel_tile(5, [v for v in itertools.product((1, 2, 3), repeat=3) if v != (2, 2, 2)])
        return tile, bridged.boxes_of(tile), 2, 0
    if kind == "moving":
        return examples.jack(grows=Q(1, 8)), bridged.boxes_of(examples.jack(grows=Q(0))), 1, 0
    tile, proof = bridged.voxels_proved(5, tuple(bridged.U_SHAPE if kind in ("breaks", "U") else bridged.RING))
    if kind == "breaks":
        proof = bridged.Boxes(bridged.SplitProver(bridged.surfaces_of(tile), search=True).prove().plan)
    elif kind == "flags":
        tile = inside_out(bridged.RING)
        proof = bridged.boxes_of(tile, [1] * len(tile.quads))
    return tile, bridged.Boxes(proof.plan.body() if not isinstance(proof.plan, bytes) else proof.plan), 1, int(kind in ("ring", "flags"))


def boxed_row(rng, tile, proof, shells, genus, n=1):
    row = Row(rng, n, range(n), tile, proofs=[proof])
    row.plan.values = dict(cells=n, tiles=n, glued_caps=0, components=n, shells=n * shells, genus=n * genus, bridges=0)
    if tile.extent:
        size = [n if a == row.axis else 1 for a in range(3)]
        row.plan.walls = [[[0] * (n // c * (c + 1)) for c in size]]
    return row.plan


def false_boxes(rng):
    """F3: two shells, two bodies, flags, added breaks, a tile whose caps move; or another tile's boxes, or another number of holes."""
    kind = rng.choice(("apart", "nested", "moving", "breaks", "flags", "forged", "forged", "genus"))
    if kind == "genus":
        plan = boxed_row(rng, *boxed(rng.choice(("U", "ring"))))
        key = rng.choice(("shells", "genus", "components", "tiles"))
        yield "W3_boxes", plan.changed(values={**plan.values, key: rng.choice([n for n in range(4) if n != plan.values[key]])})
    elif kind == "forged":                                # of one tile the surface of the other one is claimed
        (tile, _, shells, genus), (_, proof, _, _) = rng.sample([boxed("U"), boxed("ring")], 2)
        yield "boxes_of_another", boxed_row(rng, tile, proof, shells, genus)
    else:
        yield "F3_" + kind, boxed_row(rng, *boxed(kind), n=1 if kind in ("apart", "nested", "moving") else rng.choice((1, 1, 2)))


STRATEGIES = ((folded_bridges, 10), (loose_bridges, 10), (bridges_elsewhere, 10), (around_a_ring, 3), (meeting_bridges, 8), (forged_slices, 10),
              (flipped_bits, 6), (false_boxes, 40))
