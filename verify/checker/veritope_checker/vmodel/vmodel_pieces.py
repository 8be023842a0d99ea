# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The pieces of cells (docs/certificates/vmodel.md, sections 2 and 3): Bernstein coefficients, faces and edges.

Coefficients of a piece are four lists, X, Y, Z, W, in which axis 2 is the fastest.
"""
from itertools import product
from math import gcd, prod

from ..common.errors import Reject
from ..patches.star_box_patches import axis_numbers, bezier_matrix, integers

MAX_BITS, MAX_SIZE = 8192, 1 << 24
OTHERS = ((1, 2), (0, 2), (0, 1))       # the two other axes, ascending

class Piece:
    """index: along the three axes; sizes: the numbers of coefficients along them."""

    def __init__(self, index, sizes, net):
        self.index, self.sizes, self.net = index, sizes, net
        self.bits = max(abs(c).bit_length() for a in net for c in a)

    def at(self, *index):
        """The homogeneous coefficient."""
        (_, n, m), (i, j, k) = self.sizes, index
        return tuple(a[(i * n + j) * m + k] for a in self.net)

    def line(self, axis, ends):
        """The coefficients of the edge along the axis, at these ends of the two others."""
        return [self.at(*index) for index in indices_of_edge(self.sizes, axis, ends)]

    def face(self, axis, end):
        """Rows of the coefficients of a face, a row for each along its first parameter."""
        p, q = OTHERS[axis]
        index = [0, 0, 0]
        index[axis] = end * (self.sizes[axis] - 1)
        rows = []
        for index[p] in range(self.sizes[p]):
            rows.append([])
            for index[q] in range(self.sizes[q]):
                rows[-1].append(self.at(*index))
        return rows

def indices_of_edge(sizes, axis, ends):
    index = [0, 0, 0]
    for other, end in zip(OTHERS[axis], ends):
        index[other] = end * (sizes[other] - 1)
    for index[axis] in range(sizes[axis]):
        yield tuple(index)

def edge_number(axis, ends):
    return 4 * axis + ends[0] + 2 * ends[1]

def is_one_point(points):
    """Are these homogeneous points equal as points?"""
    first = points[0]
    return all(p[c] * first[3] == first[c] * p[3] for p in points[1:] for c in range(3))

def pieces_of(volume, breaks, spend):
    """The pieces of a cell, in their order; spend(units) is called for each."""
    axes = [[interval(volume, axis, lo, hi, spend) for lo, hi in zip(b, b[1:])] for axis, b in enumerate(breaks)]
    for index in product(*[range(len(a)) for a in axes]):
        yield piece_on(volume, [a[i] for a, i in zip(axes, index)], spend, index)

def piece_on(volume, chosen, spend, index=(0, 0, 0)):
    """The piece of these three intervals."""
    points = (volume.at(*at) for at in product(*map(window, chosen)))
    num_n = prod((4 if volume.rational else 3) * p for p in volume.degrees)
    return Piece(index, [p + 1 for p in volume.degrees], coefficients(points, chosen, spend, num_n))

def window(chosen):
    """The control points from which the coefficients on an interval are made."""
    last, matrix, _ = chosen
    return range(last + 1 - len(matrix), last + 1)

def coefficients(points, chosen, spend, num_n=0):
    """The four lists of Bernstein coefficients on a product of intervals, last axis fastest; points: the homogeneous
    control points of their windows; num_n: the number of coefficients of N, of a piece."""
    sizes, flat = [len(matrix) for _, matrix, _ in chosen], [c for point in points for c in point]
    flat = integers(flat, MAX_BITS, "control points")
    net = [flat[c::4] for c in range(4)]
    spend(of_products(net, sizes, [bits for _, _, bits in chosen]))
    for axis, (_, matrix, _) in enumerate(chosen):
        if not is_unit(matrix):
            net = [applied(matrix, a, axis, sizes) for a in net]
    common = gcd(*[c for a in net for c in a])
    net = [[c // common for c in a] for a in net]
    bits = max(abs(c).bit_length() for a in net for c in a)
    if num_n * bits > MAX_SIZE:
        raise Reject("B2", "the coefficients of a piece are too long for its degrees")
    spend(2 + (prod(sizes) * sum(n - 1 for n in sizes) * bits >> 12))
    return net

def interval(volume, axis, lo, hi, spend):
    """(last control point, matrix, bits of the numbers from which it is made)"""
    p, (k, numbers) = volume.degrees[axis], axis_numbers(volume, axis, lo, hi)
    bits = max(abs(x).bit_length() for x in numbers)
    spend(1 + (p ** 3 * (64 + (p ** 3 * bits ** 2 >> 13)) >> 5))
    return k, bezier_matrix(p, numbers[:-1], numbers[-1]), bits

def of_products(net, sizes, bits_of_axes):
    """The units of the products with the three matrices."""
    length, units = max(abs(c).bit_length() for a in net for c in a), 0
    for n, bits in zip(sizes, bits_of_axes):
        longer = n * (n - 1) * bits
        units += prod(sizes) * n * (32 + (1 + (longer >> 7)) * (1 + (length >> 6))) >> 5
        length += longer >> 1
    return units

def is_unit(matrix):
    return all(c == (i == j) for i, row in enumerate(matrix) for j, c in enumerate(row))

def applied(matrix, values, axis, sizes):
    """The matrix times each line of values along the axis."""
    stride = prod(sizes[axis + 1:])
    result = [0] * len(values)
    for start in starts_of_lines(sizes, axis):
        line = values[start:start + stride * sizes[axis]:stride]
        for i, row in enumerate(matrix):
            result[start + i * stride] = sum(m * c for m, c in zip(row, line) if m)
    return result

def starts_of_lines(sizes, axis):
    stride = prod(sizes[axis + 1:])
    return [block + i for block in range(0, prod(sizes), stride * sizes[axis]) for i in range(stride)]
