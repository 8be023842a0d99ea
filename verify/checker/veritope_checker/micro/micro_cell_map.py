# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The map of a volume on boxes in a cell, exactly."""
from bisect import bisect_left, bisect_right
from fractions import Fraction
from itertools import product
from math import gcd, lcm, prod

from ..vmodel.vmodel_pieces import applied, coefficients, interval, window
from .inside_space import nothing

class CellMap:
    """Its parameters are those of the unit cube.  net: the coefficients of X, Y, Z, W in the box of knots around the
    cell, integers; places: where the cell begins and ends in that box, for each axis; widths: of the cell."""

    def __init__(self, grid, cell, volume):
        self.volume, self.rational, self.sizes = volume, volume.rational, [p + 1 for p in volume.degrees]
        self.widths, self.places, chosen = [], [], []
        for axis, i in enumerate(grid.index(cell)):
            lo, hi = grid.breaks[axis][i:i + 2]
            knots = volume.knots[axis]
            begin, end = knots[bisect_right(knots, lo) - 1], knots[bisect_left(knots, hi)]
            chosen.append(interval(volume, axis, begin, end, nothing))
            self.widths.append(hi - lo)
            self.places.append([Fraction(t - begin) / (end - begin) for t in (lo, hi)])
        self.net = coefficients((volume.at(*at) for at in product(*map(window, chosen))), chosen, nothing)

    def places_of(self, ends):
        """The ends of a box in the cell, in the box of knots."""
        return [[a + (b - a) * t for t in pair] for (a, b), pair in zip(self.places, ends)]

    def spend(self, ends, spend):
        """spend(number of coefficients, bits) for net_on(ends) and the products of two of its lists."""
        bits = longest(self.net) + sum((n - 1) * lcm(*[t.denominator for t in pair]).bit_length()
                                       for n, pair in zip(self.sizes, self.places_of(ends)))
        spend(prod(2 * n - 1 for n in self.sizes) if self.rational else prod(self.sizes), bits)

    def net_on(self, ends):
        """(coefficients, sizes) on a box in the cell: the least and the greatest parameter for each axis."""
        net = self.net
        for axis, pair in enumerate(self.places_of(ends)):
            if pair != [0, 1]:
                matrix = blossoms(self.sizes[axis] - 1, *pair)
                net = [applied(matrix, a, axis, self.sizes) for a in net]
        common = gcd(*[c for a in net for c in a]) or 1
        return [[c // common for c in a] for a in net], self.sizes

    def points_on(self, ends):
        """The coefficients on a box, divided by their weights."""
        net, _ = self.net_on(ends)
        return [[Fraction(c, w) for c in point] for *point, w in zip(*net)]

def blossoms(p, lo, hi):
    """Row i: the factors of the coefficients in the blossom at lo (p - i times) and hi (i times), times one factor."""
    common = lcm(lo.denominator, hi.denominator)
    both, rows = [int(t * common) for t in (lo, hi)], []
    for i in range(p + 1):
        row = [1]
        for t in [both[0]] * (p - i) + [both[1]] * i:
            s = common - t
            row = [s * row[0], *[t * a + s * b for a, b in zip(row, row[1:])], t * row[-1]]
        rows.append(row)
    return rows

def face_of(net, sizes, axis, end):
    """The coefficients on a face of the box."""
    stride, block = prod(sizes[axis + 1:]), prod(sizes[axis:])
    first = (sizes[axis] - 1) * stride if end else 0
    return [[c for start in range(first, len(a), block) for c in a[start:start + stride]] for a in net]

def longest(net):
    return max(abs(c).bit_length() for a in net for c in a)
