# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The map of a volume in binary64, with bounds for all errors (docs/certificates/micro-inside.md, section 3).

Parameters are brought to [0, 1] over the volume's domain. The map on a box of them is a convex combination of the
Bernstein coefficients on the span of knots that contains it, divided by weights: so an error of a coordinate is at most
a number of units in the last place of the greatest coordinate, over the least weight on the box. `unit` counts them,
with plenty to spare."""
from bisect import bisect_left, bisect_right
from fractions import Fraction
from itertools import chain, product
from math import inf, prod

from ..vmodel.vmodel_pieces import coefficients, interval, window
from .inside_nodes import TINY, ULP, nearest

PAD = 4 * ULP                                               # for parameters, which are sums of two numbers up to 1
MAX_COORDINATE = 1e100                                      # beyond it nothing is claimed

class Space:
    """volume: of the cage."""

    def __init__(self, volume):
        self.volume, self.spans, self.controls = volume, {}, None
        self.knots = [sorted(set(t)) for t in volume.knots]
        self.places = [[float(self.in_unit(axis, t)) for t in knots] for axis, knots in enumerate(self.knots)]

    def in_unit(self, axis, t):
        """The parameter over the domain, exactly."""
        first, last = self.volume.knots[axis][0], self.volume.knots[axis][-1]
        return Fraction(t - first) / (last - first)

    def parts(self, box):
        """The Points for each span of knots that the box (least, greatest for each axis) meets."""
        ranges = []
        for axis in range(3):
            places, lo, hi = self.places[axis], box[2 * axis] - PAD, box[2 * axis + 1] + PAD
            last = len(places) - 2
            ranges.append(range(min(last, max(0, bisect_right(places, lo) - 1)),
                                1 + max(0, min(last, bisect_left(places, hi) - 1))))
        for span in product(*ranges):
            yield self.on_span(span, box)

    def hull(self, ends):
        """A box around the map on a range of spans for each axis: (first, last)."""
        if self.controls is None:
            points = [[nearest(c / w) for c in point] for *point, w in self.volume.points]
            self.controls = [list(column) for column in zip(*points)]
        last = [[bisect_right(t, knots[n], p, len(t) - p - 1) - 1 for n in pair]
                for pair, knots, t, p in zip(ends, self.knots, self.volume.knots, self.volume.degrees)]
        (i, l), (j, m), (k, n) = [(a - p, b + 1) for (a, b), p in zip(last, self.volume.degrees)]
        _, step, plane = self.volume.strides()
        found = []
        for column in self.controls:
            rows = [column[r * plane + q * step + i:r * plane + q * step + l] for r in range(k, n) for q in range(j, m)]
            lo, hi = min(map(min, rows)), max(map(max, rows))
            pad = 4 * ULP * max(abs(lo), abs(hi)) + TINY
            found += [lo - pad, hi + pad] if pad < MAX_COORDINATE else [-inf, inf]
        return tuple(found)

    def on_span(self, span, box):
        """The Points for the part of the box in this span: three numbers of intervals between knots."""
        if span not in self.spans:
            self.spans[span] = Span(self, span)
        return self.spans[span].points(box)

class Points:
    """x, y, z: lists of coordinates, all within `error`; box: of what they may be."""
    __slots__ = ("x", "y", "z", "error", "box")

    def __init__(self, x, y, z, error):
        self.x, self.y, self.z, self.error = x, y, z, error
        self.box = (min(x) - error, max(x) + error, min(y) - error, max(y) + error, min(z) - error, max(z) + error)

    def extent(self, x, y, z):
        """The least and the greatest product with a vector, but for an error that slack() bounds."""
        values = [x * p + y * q + z * r for p, q, r in zip(self.x, self.y, self.z)]
        return min(values), max(values)

    def slack(self, greatest=0.):
        """Bounds the errors of the products of these points, and of others up to `greatest`, with a vector whose
        components are at most 1, and off by at most a unit in the last place."""
        limit = max(greatest, *map(abs, self.box))
        return 3 * self.error + 64 * ULP * limit + TINY if limit < MAX_COORDINATE else inf

    def moved(self, x, y, z, error):
        """The points plus a vector, whose components are within `error`."""
        greatest = max(abs(x), abs(y), abs(z), *map(abs, self.box))
        return Points([c + x for c in self.x], [c + y for c in self.y], [c + z for c in self.z],
                      self.error + error + 4 * ULP * greatest)

class Span:
    def __init__(self, space, span):
        volume = space.volume
        chosen = [interval(volume, axis, *space.knots[axis][n:n + 2], nothing) for axis, n in enumerate(span)]
        net = coefficients((volume.at(*at) for at in product(*map(window, chosen))), chosen, nothing)
        self.sizes, self.rational = [p + 1 for p in volume.degrees], volume.rational
        self.ends = [space.places[axis][n:n + 2] for axis, n in enumerate(span)]
        self.net = scaled_net(net, self.rational)
        greatest = max(map(greatest_of, net[:3], [net[3]] * 3))
        # Rounded nets, three products with matrices whose entries are products of p factors, a quotient.
        self.unit = (16 + 12 * sum(volume.degrees)) * ULP
        self.error = 2 * self.unit * greatest + TINY if greatest < MAX_COORDINATE else inf

    def points(self, box):
        values = self.net
        for axis, n in enumerate(self.sizes):
            values = along(values, weights(n - 1, *self.local(axis, box)))
        n = prod(self.sizes)
        x, y, z = values[:n], values[n:2 * n], values[2 * n:3 * n]
        if not self.rational:
            return Points(x, y, z, self.error)
        w = values[3 * n:]
        least = min(w)
        if not least > 4 * self.unit:                       # weights are at most 1, and off by at most a unit
            return Points(x, y, z, inf)
        x, y, z = [[a / b for a, b in zip(c, w)] for c in (x, y, z)]
        return Points(x, y, z, 2 * self.error / least + TINY)

    def local(self, axis, box):
        """The ends of the box in this span, brought to [0, 1] and rounded outward."""
        (first, last), lo, hi = self.ends[axis], box[2 * axis], box[2 * axis + 1]
        length = last - first
        if not length > 8 * PAD:                            # too short for binary64: all of it
            return 0., 1.
        pad = 4 * PAD / length
        return min(1., max(0., (lo - first) / length - pad)), min(1., max(0., (hi - first) / length + pad))

def nothing(units):
    """The work of vmodel-1 was counted when its conditions were tested."""

def scaled_net(net, rational):
    """The coefficients with the coordinates as the last axis, those of each axis before.  Weights are at most 1; of a
    net that is not rational they are left out."""
    heaviest = max(net[3])
    return list(chain.from_iterable(zip(*[[rounded(c, heaviest) for c in a] for a in (net if rational else net[:3])])))

def greatest_of(values, weights_of):
    return max(abs(rounded(c, w)) for c, w in zip(values, weights_of))

def rounded(c, w):
    try:
        return c / w                                        # of integers: rounded once
    except OverflowError:
        return inf if c > 0 else -inf

def weights(p, lo, hi):
    """Row i: the factors of the p + 1 coefficients in the blossom at lo (p - i times) and hi (i times)."""
    if p == 1:
        return ((1. - lo, lo), (1. - hi, hi))
    rows = []
    for i in range(p + 1):
        row = [1.]
        for t in [lo] * (p - i) + [hi] * i:
            s = 1. - t
            row = [s * row[0], *[t * a + s * b for a, b in zip(row, row[1:])], t * row[-1]]
        rows.append(row)
    return rows

def along(values, rows):
    """The products of the matrix with the slowest axis, which becomes the fastest one."""
    n = len(rows)
    step = len(values) // n
    parts = [values[i:i + step] for i in range(0, len(values), step)]
    if n == 2:
        (a, b), (p, q) = rows, parts
        (s, t), (u, v) = a, b
        made = [[s * x + t * y for x, y in zip(p, q)], [u * x + v * y for x, y in zip(p, q)]]
    elif n == 3:
        made = [[a * x + b * y + c * z for x, y, z in zip(*parts)] for a, b, c in rows]
    elif n == 4:
        made = [[a * x + b * y + c * z + d * w for x, y, z, w in zip(*parts)] for a, b, c, d in rows]
    else:
        made = [[sum(map(float.__mul__, row, column)) for column in zip(*parts)] for row in rows]
    return list(chain.from_iterable(zip(*made)))
