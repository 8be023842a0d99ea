# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Nodes of the descents of docs/certificates/micro-inside.md: polynomial maps of a square or a cube, halved at 1/2,
with the boxes around their coefficients, in binary64 with bounds for all errors."""
from itertools import chain
from math import inf, prod

ULP = 2.0 ** -53                                            # the relative error of one operation
TINY = 1e-300                                               # pays for what underflows

class Node:
    """arrays: the coefficients of each coordinate; level: of the node; box: (least x, greatest x, least y, ...) of what
    the coefficients may be.  The coordinates are between 0 and 1 in absolute value."""
    __slots__ = ("arrays", "sizes", "level", "box", "error", "kids")

    def __init__(self, arrays, sizes, level=0, error=2 * ULP):
        """sizes: of the axes; the first one is the slowest, and the next to be halved.  error: of the coefficients and
        of the ends of the box."""
        self.arrays, self.sizes, self.level, self.error, self.kids = arrays, sizes, level, error, None
        x, y, z = arrays
        e = error + TINY
        self.box = (min(x) - e, max(x) + e, min(y) - e, max(y) + e, min(z) - e, max(z) + e)

    def halves(self):
        """Two nodes, the lower half first. They are kept."""
        if self.kids is None:
            n = self.sizes[0]
            pairs = [halves(a, n) for a in self.arrays]
            # Each step of de Casteljau's scheme is a mean of numbers up to 1; the ends of boxes are rounded, too.
            error = self.error + (n + 1) * ULP
            self.kids = [Node([pair[which] for pair in pairs], self.sizes[1:] + self.sizes[:1], self.level + 1, error)
                         for which in (0, 1)]
        return self.kids

def halves(values, n):
    """The coefficients on both halves along the slowest of the axes, which has n of them and becomes the fastest."""
    step = len(values) // n
    rows = [values[i:i + step] for i in range(0, len(values), step)]
    left, right = [rows[0]], [rows[-1]]
    while len(rows) > 1:
        rows = [[(a + b) * .5 for a, b in zip(p, q)] for p, q in zip(rows, rows[1:])]
        left.append(rows[0])
        right.append(rows[-1])
    return rotated(left), rotated(right[::-1])

def rotated(rows):
    """The array with the axis of the rows as the fastest one."""
    return list(chain.from_iterable(zip(*rows)))

def node_of(points, sizes):
    """The node of level 0 with these points, which are fractions from -1 to 1, the last axis the fastest."""
    assert len(points) == prod(sizes)
    return Node([[float(c) for c in column] for column in zip(*points)], tuple(sizes))

def nearest(c):
    """The binary64 number nearest to a fraction, or an infinity."""
    try:
        return float(c)
    except OverflowError:
        return inf if c > 0 else -inf
