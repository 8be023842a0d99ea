# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The winding number of patches around a point: docs/certificates/points.md, section 6, pieces, curves and work."""
from functools import reduce
from operator import or_

from ..common.vectors import cross
from ..patches.patch_invalid_check import part, value_at
from ..patches.star_box_patches import halves

MOST_HALVINGS = 4096                                        # in one parameter; of a part of a line
PARAMETER_BITS = 2 * MOST_HALVINGS                          # parts of sides of pieces are halved, too
ONE = 1 << PARAMETER_BITS                                   # parameters are integers in units of 2^-8192
UNITS_OF_POINT, FREE_UNITS, UNITS_OF_BYTE, UNITS_EACH = 1 << 22, 1 << 25, 96, 1 << 12

class LeftOver(Exception):
    """A piece or a part of a line was halved too often."""

class TooMuchWork(Exception):
    """More units were spent than the page allows."""

class Work:
    """Units that may still be spent, on all points and on the current one."""

    def __init__(self, num_points, num_bytes):
        self.left, self.left_of_point = FREE_UNITS + UNITS_OF_BYTE * num_bytes + UNITS_EACH * num_points, UNITS_OF_POINT

    def begin_point(self):
        self.left_of_point = UNITS_OF_POINT

    def add(self, units):
        self.left -= units
        self.left_of_point -= units
        if self.left < 0 or self.left_of_point < 0:
            raise TooMuchWork

    def add_piece(self, grid, point_bits, cuts):
        (p, q), (i, j) = grid.degrees, cuts
        h = grid.bits + point_bits + p * i + q * j
        self.add(16 + ((p + 1) * (q + 1) * h * (64 * (p + q) + h) >> 16))

    def add_part(self, line, point_bits, lo, hi):
        k = PARAMETER_BITS - trailing_zeros(lo | hi | ONE)
        h = line.bits + point_bits + line.degree * k + line.bits_across
        self.add(8 + ((line.degree + 1) ** 2 * h >> 11))

    def add_on(self, grid, point_bits, at):
        p, q = grid.degrees
        g = max(abs(n).bit_length() for t in at for n in (t.numerator, t.denominator))
        h = grid.bits + point_bits + (p + q) * g
        self.add(16 + ((p + 1) * (q + 1) * (p + q) * h * (64 + g) >> 18))

    def add_on_algebraic(self, grid, point_bits, at):
        p, q = grid.degrees
        h = grid.bits + point_bits + (p + q) * (at.size + 1) * at.bits
        self.add(16 + (((p + 1) * (q + 1) + 4 * (p + q)) * at.size ** 2 * h ** 2 >> 22))

def trailing_zeros(n):
    return (n & -n).bit_length() - 1

def one_sign(values):
    """1 or -1 if all values have this sign, else 0."""
    least, most = min(values), max(values)
    return (least > 0) - (most < 0)

def winding(model, point, patches, direction, work):
    """Steps 1 to 4 and the sum of the page; patches: at least all that are not missed by step 1 or 2."""
    axis, ahead_sign = direction // 2, 1 - 2 * (direction % 2)
    axes = (axis + 1) % 3, (axis + 2) % 3, axis
    lines, open_piece = Lines(model, point, axes[:2]), None
    for patch in patches:
        grid = model.grids[patch]
        todo = [(grid.around(point), (0, 0), (ONE, ONE), (0, 0))]
        while todo:
            net, lo, hi, cuts = todo.pop()
            flat = [[c for row in a for c in row] for a in net]
            p, q, u = (one_sign(flat[k]) for k in axes)
            if p or q or u == -ahead_sign:
                continue
            work.add_piece(grid, point.bits, cuts)
            if u == ahead_sign:
                lines.add_piece(patch, lo, hi)
                continue
            normal = mean_normal(net)
            side = one_sign([normal[0] * x + normal[1] * y + normal[2] * z for x, y, z in zip(*flat)])
            if side:
                if side * normal[axis] * ahead_sign > 0:
                    lines.add_piece(patch, lo, hi)
                continue
            k = parameter_to_halve(grid, net, lo, hi, cuts)
            if cuts[k] == MOST_HALVINGS:
                open_piece = patch
                continue
            middle = (lo[k] + hi[k]) // 2
            ends = (lo, with_entry(hi, k, middle)), (with_entry(lo, k, middle), hi)
            for half, (a, b) in zip(halves_of(net, k), ends):
                todo.append((half, a, b, with_entry(cuts, k, cuts[k] + 1)))
    if open_piece is not None:
        raise LeftOver("a piece of patch %d is left over" % open_piece)
    return lines.sum(work) * ahead_sign

def with_entry(pair, k, value):
    return (value, pair[1]) if k == 0 else (pair[0], value)

def mean_normal(net):
    first, second = [], []
    for rows in net:
        a, b, c, d = rows[0][0], rows[-1][0], rows[0][-1], rows[-1][-1]
        first.append(b - a + d - c)
        second.append(c - a + d - b)
    return cross(first, second)

def parameter_to_halve(grid, net, lo, hi, cuts):
    """0 for u, 1 for v: step 4."""
    is_collapsed = [border is None for border in grid.borders]
    at_pole = (lo[0] == 0 and is_collapsed[3] or hi[0] == ONE and is_collapsed[1],
               lo[1] == 0 and is_collapsed[0] or hi[1] == ONE and is_collapsed[2])
    if at_pole[0] != at_pole[1]:
        return 0 if at_pole[0] else 1
    along_v = longest_row(net)
    along_u = longest_row([list(zip(*rows)) for rows in net])
    if along_u != along_v:
        return 0 if along_u > along_v else 1
    return 0 if cuts[0] <= cuts[1] else 1

def longest_row(net):
    return max(sum(abs(b - a) for row in rows for a, b in zip(row, row[1:])) for rows in zip(*net))

def halves_of(net, k):
    """Both halves in parameter k, each divided by the powers of two that all its numbers have."""
    if k == 0:
        net = [list(zip(*rows)) for rows in net]
    both = [[halves(row) for row in rows] for rows in net]
    for which in (0, 1):
        half = [[pair[which] for pair in rows] for rows in both]
        twos = trailing_zeros(reduce(or_, [c for rows in half for row in rows for c in row]) or 1)
        half = [[[c >> twos for c in row] for row in rows] for rows in half]
        yield [list(zip(*rows)) for rows in half] if k == 0 else half

class Line:
    """curve: its coefficients (x, y) relative to the point, on the whole line."""

    def __init__(self, grid, curve, bits_across=0):
        self.curve, self.bits, self.bits_across, self.degree = curve, grid.bits, bits_across, len(curve[0]) - 1

class Span:
    """The part of a line on which coefficients are computed, as part() takes it."""

    def __init__(self, lo, hi):
        zeros = trailing_zeros(lo | hi | ONE)
        self.lo, self.hi, self.full = lo >> zeros, hi >> zeros, ONE >> zeros

class Lines:
    """The intervals of sides of pieces that are ahead, by lines."""

    def __init__(self, model, point, axes):
        self.model, self.point, self.axes, self.intervals = model, point, axes, {}

    def add_piece(self, patch, lo, hi):
        for side in range(4):
            along, rises = side % 2, side < 2
            place = (lo[1], hi[0], hi[1], lo[0])[side]
            a, b, sign = lo[along], hi[along], 1 if rises else -1
            if place == (0, ONE, ONE, 0)[side]:
                border = self.model.grids[patch].borders[side]
                if border is None:
                    continue
                edge, is_first = border
                if rises != is_first:                       # t rises where the first side travels
                    a, b = ONE - b, ONE - a
                key, sign = edge, 1 if is_first else -1
            else:
                key = patch, along, place
            self.intervals.setdefault(key, []).append((a, b, sign))

    def sum(self, work):
        return sum(self.number(key, intervals, work) for key, intervals in self.intervals.items())

    def number(self, key, intervals, work):
        change, surplus, line, total = {}, 0, None, 0
        for a, b, sign in intervals:
            change[a] = change.get(a, 0) + sign
            change[b] = change.get(b, 0) - sign
        ends = sorted(change)
        for a, b in zip(ends, ends[1:]):
            surplus += change[a]
            if surplus:
                line = line or self.line(key)
                curve = line.curve if (a, b) == (0, ONE) else [part(c, Span(a, b)) for c in line.curve]
                total += surplus * self.crossing_number(line, curve, a, b, work)
        return total

    def line(self, key):
        if isinstance(key, int):
            patch, side = self.model.firsts[key]
            grid = self.model.grids[patch]
            ends = [rows[-1] if side == 1 else rows[0] if side == 3 else [row[0 if side == 0 else -1] for row in rows]
                    for rows in self.arrays(patch)]
            return Line(grid, [end if side < 2 else end[::-1] for end in ends])
        patch, along, place = key
        grid, zeros = self.model.grids[patch], trailing_zeros(place)
        at, levels = place >> zeros, PARAMETER_BITS - zeros
        curve = [[value_at(row, at, 1 << levels) for row in (rows if along == 0 else zip(*rows))]
                 for rows in self.arrays(patch)]
        return Line(grid, curve, grid.degrees[1 - along] * levels)

    def arrays(self, patch):
        """Those of x and y on the whole patch."""
        around = self.model.grids[patch].around(self.point)
        return [around[k] for k in self.axes]

    def crossing_number(self, line, curve, lo, hi, work):
        total, todo = 0, [(curve, lo, hi, 0)]
        while todo:
            (x, y), lo, hi, halvings = todo.pop()
            work.add_part(line, self.point.bits, lo, hi)
            if min(y) >= 0 or max(y) < 0 or max(x) <= 0:
                continue
            if min(x) >= 0:
                total += (y[-1] >= 0) - (y[0] >= 0)
                continue
            if halvings == MOST_HALVINGS:
                raise LeftOver("a part of a line is left over")
            middle = (lo + hi) // 2
            for (x, y), (a, b) in zip(zip(halves(x), halves(y)), ((lo, middle), (middle, hi))):
                todo.append(((x, y), a, b, halvings + 1))
        return total
