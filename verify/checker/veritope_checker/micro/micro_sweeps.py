# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Sweeps (docs/certificates/microstructure.md, section 7b): their order, Q1 and Q2; micro_sweep_pairs.py has Q3 and
Q4."""
from fractions import Fraction
from math import lcm

from ..common.errors import Reject
from ..common.vectors import dot
from ..patches.model_powers import scaled
from ..vmodel.vmodel_sign import Packing, difference
from .inside_parts import Parts
from .micro_bridges import is_positive
from .micro_cell_map import CellMap, face_of, longest
from .micro_polynomials import split
from .micro_sweep_pairs import SweepPairs

FREE_UNITS, UNITS_OF_SWEEP = 1 << 28, 1 << 16               # of Q2: this checker's own bound
LIMB, LIMBS_OF_UNIT = 64, 32

def test_sweeps(model, hints, tiles, glued, skip):
    """glued: of micro_numbers.py."""
    if not model.sweeps:
        return
    pairs, work = SweepPairs(Parts(model, tiles), hints), Work(len(model.sweeps))

    def tested(condition, test, *arguments):
        if condition not in skip:
            try:
                test(*arguments)
            except Reject as rejection:
                raise Reject(condition, "sweep %d: %s" % (number, rejection.why)) from None

    for number, (sweep, hint) in enumerate(zip(model.sweeps, hints)):
        tested("Q1", test_q1, model, sweep, tiles, glued)
        tested("Q2", test_q2, model, sweep, hint, work)
        tested("Q3", pairs.test_q3, number)
    if "Q4" not in skip:
        pairs.test_q4()


# ---------------------------------------------------------------- Q1

def the_cap(model, tiles, start):
    """(tile, number of its only cap in the wall at which a bridge or a sweep starts, that cap's only patch)"""
    tile = tiles[model.grids[start.grid].cells[start.cell] - 1]
    caps = [n for n, (wall, _) in enumerate(tile.caps) if wall == start.wall]
    if len(caps) != 1 or len(tile.caps[caps[0]][1]) != 1:
        raise Reject("Q1", "the wall has not one cap of one patch")
    return tile, caps[0], tile.patches[tile.caps[caps[0]][1][0]]

def test_q1(model, sweep, tiles, glued):
    _, cap, _ = the_cap(model, tiles, sweep)
    if glued.masks[glued.base[sweep.grid] + sweep.cell] >> cap & 1:
        raise Reject("Q1", "its cap is equal to another one")


# ---------------------------------------------------------------- Q2

class Work:
    def __init__(self, count):
        self.left = FREE_UNITS + UNITS_OF_SWEEP * count

    def spend(self, coefficients, bits):
        self.left -= coefficients * (1 + (bits // LIMB) ** 2 // LIMBS_OF_UNIT)
        if self.left < 0:
            raise Reject("Q2", "the coefficients of all sweeps are too many and too long")

def test_q2(model, sweep, hint, work):
    """All columns are multiplied by K, by one factor > 0 and, for each index, by another one."""
    grid, axis, end = model.grids[sweep.grid], sweep.wall // 2, sweep.wall % 2
    cell, depth = CellMap(grid, sweep.cell, model.cage[grid.volume]), hint.depth
    ends = [(Fraction(0), Fraction(1))] * 3
    ends[axis] = (1 - depth, Fraction(1)) if end else (Fraction(0), depth)
    cell.spend(ends, work.spend)
    net, sizes = cell.net_on(ends)
    rows = split(scaled(sum(hint.matrix, []))[0], 3)
    net = [*[[dot(row, point) for point in zip(*net[:3])] for row in rows], net[3]]
    factors = [(n - 1) / (width * (hi - lo)) for n, width, (lo, hi) in zip(sizes, cell.widths, ends)]
    slab = Derivatives(net, sizes, cell.rational)
    numbers = scaled(factors)[0]
    for coefficients in zip(*[column for a in range(3) for column in slab.columns(a)]):
        test_positive([[f * c for f, c in zip(numbers, coefficients[k::3])] for k in range(3)])
    e, f = sweep.axis
    speed = hint.speed if end else -hint.speed
    for vector in (e, [y - x for x, y in zip(e, f)]):
        beyond = [speed * dot(row, vector) for row in rows]
        test_wall(Derivatives(face_of(net, sizes, axis, end), [1 if a == axis else n for a, n in enumerate(sizes)],
                              cell.rational), axis, factors, beyond)

def test_wall(wall, axis, factors, beyond):
    """beyond: K times the vector that takes the place of column `axis`, but for the factor c."""
    first, second = [a for a in range(3) if a != axis]
    common = lcm(*[c.denominator for c in (factors[first], factors[second], *beyond)])
    f, g = [int(factors[a] * common) for a in (first, second)]
    across = [int(c * common) for c in beyond]
    for *both, square in zip(*wall.columns(first), *wall.columns(second), wall.squares()):
        m = [[0] * 3 for _ in range(3)]
        for k in range(3):
            m[k][first], m[k][second], m[k][axis] = f * both[k], g * both[3 + k], square * across[k]
        test_positive(m)

def test_positive(m):
    if not is_positive(m):
        raise Reject("Q2", "a matrix K C + (K C)^T is not positive definite")

class Derivatives:
    """The coefficients of W^2 times the derivatives of (X, Y, Z) / W along the axes of a box, divided by the degrees;
    with their binomials. If the map is polynomial, W has one coefficient's value, and they are divided by that."""

    def __init__(self, net, sizes, rational):
        self.net, self.sizes, self.rational = net, sizes, rational
        bits = longest(net) + sum(sizes) + 2
        self.packing = Packing([2 * n - 1 for n in sizes] if rational else sizes, 2 * bits if rational else bits)
        self.whole = [self.packing.packed(a, sizes) for a in net] if rational else None

    def columns(self, axis):
        """Three lists."""
        slopes = [self.packing.packed(*difference(a, axis, self.sizes)) for a in self.net[:4 if self.rational else 3]]
        if self.rational:
            x, w, dw = self.whole[:3], self.whole[3], slopes[3]
            slopes = [w * d - dw * c for d, c in zip(slopes, x)]
        raised = 1 + (1 << 8 * self.packing.width * self.stride(axis))
        return [self.packing.unpacked(d * raised) for d in slopes[:3]]

    def stride(self, axis):
        _, n, m = self.packing.sizes
        return (n * m, m, 1)[axis]

    def squares(self):
        """The coefficients of W^2, divided as the derivatives are."""
        if self.rational:
            return self.packing.unpacked(self.whole[3] ** 2)
        return self.packing.unpacked(self.packing.packed(self.net[3], self.sizes))
