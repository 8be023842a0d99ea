# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Polynomials of the patches of tiles (docs/certificates/microstructure.md, sections 3 to 6): Bernstein forms in u, v
and the number t of a wall, forms in powers, and G."""
from fractions import Fraction
from functools import lru_cache
from math import comb, gcd, lcm
from operator import mul

from ..patches.model_powers import scaled
from ..patches.star_box_patches import transposed
from ..vmodel.vmodel_glue import moved
from ..vmodel.vmodel_sign import Packing, difference

UNIT = 1 << 20                                              # a wall with the number k has t = k / UNIT

@lru_cache(1000)
def matrix_in_t(r, extent):
    """(rows, common denominator): row i has the factors of the r lists of a patch in its Bernstein coefficients with
    the index i in t, times the denominator."""
    lo, hi = [Fraction(k, UNIT) for k in extent or (0, 0)]
    if lo == hi:
        rows = [[lo ** m for m in range(r)]]
    else:
        shifted = [[(hi - lo) ** k * comb(m, k) * lo ** (m - k) if m >= k else 0 for m in range(r)] for k in range(r)]
        rows = [[sum(Fraction(comb(i, k), comb(r - 1, k)) * shifted[k][m] for k in range(i + 1)) for m in range(r)]
                for i in range(r)]
    common = lcm(*[c.denominator for row in rows for c in row])
    return [[int(c * common) for c in row] for row in rows], common

def in_bernstein(lists, extent):
    """(Bernstein coefficients over the range, common denominator), of points of integers that are factors of powers of
    t."""
    rows, common = matrix_in_t(len(lists), extent)
    return [[[sum(map(mul, row, values)) for values in zip(*points)] for points in zip(*lists)] for row in rows], common

def at_number(lists, number):
    """(the points for one number of the wall, common denominator)"""
    found, common = in_bernstein(lists, (number, number))
    return found[0], common

def in_powers(vectors):
    """Bernstein coefficients become those of powers; the last ones are dropped while they are 0."""
    n, powers = len(vectors) - 1, []
    for k in range(n + 1):
        powers.append([comb(n, k) * c for c in vectors[0]])
        vectors = [[b - a for a, b in zip(p, q)] for p, q in zip(vectors, vectors[1:])]
    while len(powers) > 1 and not any(powers[-1]):
        powers.pop()
    return powers

def text_of(vectors, common):
    """A text has a keyed hash: no file can make many that have one hash."""
    return ";".join(",".join("%x/%x" % (c // g, common // g) for c in vector for g in (gcd(c, common),))
                    for vector in vectors)

def of_lists(wall, lists):
    """(the wall on whose number the lists depend, or None; the lists without the last ones that are 0)"""
    while len(lists) > 1 and not any(c for point in lists[-1] for c in point):
        lists = lists[:-1]
    return (wall if len(lists) > 1 else None), lists

def curve_key(wall, lists, common):
    """A text that is equal for curves that are one polynomial map of their parameter and of all numbers. The points of
    the lists are integers, which the common denominator divides."""
    wall, lists = of_lists(wall, lists)
    return "%s|%s" % (wall, text_of(in_powers([sum(points, []) for points in map(list, zip(*lists))]), common))

def map_key(wall, lists, common, degrees):
    """A text that is equal for maps of the square that are equal after one of its symmetries."""
    wall, lists = of_lists(wall, lists)
    vectors = [sum(points, []) for points in map(list, zip(*lists))]
    rows = split(vectors, degrees[1] + 1)
    return "%s|%s" % (wall, min(grid_text(moved(rows, symmetry), common) for symmetry in range(8)))

def grid_text(rows, common):
    """The map's coefficients of powers, without the last rows and columns that are 0."""
    width = len(rows[0][0])
    columns = in_powers([sum(column, []) for column in transposed(rows)])
    rows = in_powers([sum(row, []) for row in transposed([split(column, width) for column in columns])])
    return "!".join(text_of(split(row, width), common) for row in rows)

def split(row, width):
    return [row[i:i + width] for i in range(0, len(row), width)]


# ---------------------------------------------------------------- G

class Winding:
    """G of a patch with these Bernstein coefficients over a common denominator, and the centre a."""

    def __init__(self, coefficients, common, degrees, centre):
        self.sizes = [degrees[0] + 1, degrees[1] + 1, len(coefficients)]
        self.of_g = [3 * degrees[0], 3 * degrees[1], 3 * len(coefficients) - 2]
        (x, y, z), factor = scaled(centre)
        values = [factor * of_t[n][c] - common * shift for c, shift in enumerate((x, y, z))
                  for n in range(len(coefficients[0])) for of_t in coefficients]
        factor, count = gcd(*values) or 1, len(values) // 3
        values = [v // factor for v in values]
        self.values = split(values, count)
        self.bits = max(abs(v).bit_length() for v in values)

    def coefficients(self):
        """{index: the coefficient of the index in u, v, t, times a factor > 0}"""
        packing = Packing(self.of_g, 3 * (self.bits + sum(self.sizes)) + 6)
        (a, b, c), (d, e, f) = [[packing.packed(*difference(v, axis, self.sizes)) for v in self.values]
                                for axis in (0, 1)]
        g, h, i = [packing.packed(v, self.sizes) for v in self.values]
        found = iter(packing.unpacked(a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g)))
        l, m, n = self.of_g
        return {(i, j, k): next(found) for i in range(l) for j in range(m) for k in range(n)}
