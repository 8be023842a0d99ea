# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The determinants N of pieces (docs/certificates/vmodel.md, section 5): their coefficients and V2."""
from functools import lru_cache
from itertools import product
from math import comb, lcm, prod

from ..common.errors import Reject
from ..patches.star_box_patches import halves
from .vmodel_pieces import starts_of_lines

BODY = 26                               # the number of the sub-face that is all of a box

def digits(sub_face):
    return sub_face // 9, sub_face // 3 % 3, sub_face % 3

@lru_cache(100)
def binomials(sizes):
    """The product of the binomials of each coefficient."""
    return [prod(comb(n - 1, i) for n, i in zip(sizes, index)) for index in product(*map(range, sizes))]

class Packing:
    """Coefficients times their binomials multiply like those of polynomials in powers. Each polynomial is packed into
    one integer, `width` bytes a coefficient, with the strides of the product."""

    def __init__(self, sizes, bits):
        """sizes: of the product. bits: every coefficient of a product is below 2^bits in absolute value."""
        self.sizes, self.width = sizes, bits // 8 + 1

    def packed(self, values, sizes):
        _, n, m = self.sizes
        places = ((i * n + j) * m + k for i, j, k in product(*map(range, sizes)))
        return sum(c * f << 8 * self.width * place for c, f, place in zip(values, binomials(tuple(sizes)), places))

    def unpacked(self, number):
        count, half = prod(self.sizes), 1 << 8 * self.width - 1
        bias = half * (((1 << 8 * self.width * count) - 1) // ((1 << 8 * self.width) - 1))
        data = (number + bias).to_bytes(self.width * count + 1, "little")
        return [int.from_bytes(data[i * self.width:(i + 1) * self.width], "little") - half for i in range(count)]

def difference(values, axis, sizes):
    """(Coefficients of the derivative along the axis divided by the degree, their sizes.)"""
    stride = prod(sizes[axis + 1:])
    block = stride * sizes[axis]
    return ([values[i + stride] - values[i] for start in range(0, len(values), block)
             for i in range(start, start + block - stride)],
            [n - (a == axis) for a, n in enumerate(sizes)])

def determinant(piece, rational):
    """(The coefficients of N times their binomials, times one factor > 0; their sizes.)"""
    factors, sizes = (4 if rational else 3), piece.sizes
    of_n = [factors * (n - 1) for n in sizes]
    packing = Packing(of_n, factors * (piece.bits + sum(sizes)) + 6)
    rows = [[packing.packed(*difference(a, axis, sizes)) for a in piece.net[:factors]] for axis in range(3)]
    if rational:
        number = -det4([packing.packed(a, sizes) for a in piece.net], *rows)
    else:
        (a, b, c), (d, e, f), (g, h, i) = rows
        number = a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g)
    return packing.unpacked(number), of_n

def of_determinant(piece, rational):
    """The units of N on a piece."""
    limbs, doubled = 2 + piece.bits // 32, prod(2 * n - 1 for n in piece.sizes)
    return 2 + ((doubled if rational else prod(piece.sizes)) * doubled * limbs ** 2 >> 8)

def det4(p, q, r, s):
    def minor(a, b, i, j):
        return a[i] * b[j] - a[j] * b[i]

    return sum(sign * minor(p, q, i, j) * minor(r, s, k, m) for sign, i, j, k, m in (
        (1, 0, 1, 2, 3), (-1, 0, 2, 1, 3), (1, 0, 3, 1, 2), (1, 1, 2, 0, 3), (-1, 1, 3, 0, 2), (1, 2, 3, 0, 1)))

def without_binomials(values, sizes):
    """The Bernstein coefficients, times one factor > 0."""
    factors = binomials(tuple(sizes))
    common = lcm(*factors)
    return [c * (common // f) for c, f in zip(values, factors)]

def on_sub_face(values, sub_face, sizes):
    ranges = [(range(1), range(n - 1, n), range(n))[d] for d, n in zip(digits(sub_face), sizes)]
    _, n, m = sizes
    return [values[(i * n + j) * m + k] for i, j, k in product(*ranges)]

def half(values, sizes, axis, which):
    stride, result = prod(sizes[axis + 1:]), [0] * len(values)
    for start in starts_of_lines(sizes, axis):
        line = slice(start, start + stride * sizes[axis], stride)
        result[line] = halves(values[line])[which]
    return result

def is_part(sub_face, zero, at_ends):
    """Does this sub-face of a node lie in a zero of the piece?  at_ends: for each axis, whether the node begins where
    the piece does, and whether it ends there."""
    return all(z == 2 or d == z and ends[z] for d, z, ends in zip(digits(sub_face), digits(zero), at_ends))

class SignTest:
    """V2 on one piece."""

    def __init__(self, piece, entry, flag, rational, may_vanish, spend):
        """may_vanish(axis, end): whether the piece's face lies in a face of the cell with the code 0 or 1."""
        self.piece, self.zeros, self.tree, self.spend = piece, entry.zeros, iter(entry.tree), spend
        for zero in self.zeros:
            faces = [axis for axis in range(3) if digits(zero)[axis] < 2]
            if len(faces) == 1 and not may_vanish(faces[0], digits(zero)[faces[0]]):
                raise Reject("V2", "a zero is a face that is neither collapsed nor in X")
            if any(z != zero and is_part(zero, z, [(True, True)] * 3) for z in self.zeros):
                raise Reject("V2", "a zero is a part of another one")
        spend(of_determinant(piece, rational))
        self.values, self.sizes = determinant(piece, rational)
        if flag:
            self.values = [-c for c in self.values]
        self.degree = sum(n - 1 for n in self.sizes)

    def run(self):
        for zero in self.zeros:
            if any(on_sub_face(self.values, zero, self.sizes)):
                raise Reject("V2", "N is not 0 on a zero")
        self.spend_on_node(0)
        symbol = next(self.tree)
        if symbol == 0:
            return self.test_leaf(self.values, [(True, True)] * 3)
        self.test_halves(without_binomials(self.values, self.sizes), [(True, True)] * 3, symbol - 1, 0)

    def spend_on_node(self, level):
        self.spend(1 + (prod(self.sizes) * self.degree * (4 * self.piece.bits + level * self.degree) >> 14))

    def test_halves(self, values, at_ends, axis, level):
        for which in range(2):
            part = half(values, self.sizes, axis, which)
            ends = list(at_ends)
            ends[axis] = (ends[axis][0] and which == 0, ends[axis][1] and which == 1)
            self.spend_on_node(level + 1)
            symbol = next(self.tree)
            if symbol == 0:
                self.test_leaf(part, ends)
            else:
                self.test_halves(part, ends, symbol - 1, level + 1)

    def test_leaf(self, values, at_ends):
        least = min(values)
        if least > 0:
            return
        if least < 0:
            raise Reject("V2", "N has a negative coefficient on a leaf")
        for sub_face in range(BODY + 1):
            if any(is_part(sub_face, zero, at_ends) for zero in self.zeros):
                continue
            if max(on_sub_face(values, sub_face, self.sizes)) == 0:
                raise Reject("V2", "N has no positive coefficient on sub-face %d of a leaf" % sub_face)
