# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The patches of star_box_check.py: exact Bezier coefficients, the polynomials of S1, gluing
(docs/certificates/star-box.md, section 3).

An *array* holds the coefficients of one polynomial as a list of rows.  Tensor: row i, entry j of u^i v^j.  Triangle:
row r = j + k, entry k of the coefficient of corner 0^i corner 1^j corner 2^k.  A *net* is the arrays of x, y, z, w.
Nets are multiplied by, or divided by, common factors > 0 so that all their coefficients are integers.
"""
from bisect import bisect_right
from fractions import Fraction
from functools import lru_cache
from itertools import islice
from math import comb, gcd, lcm
from operator import add, mul

from ..common.errors import Reject

FULL = 1 << 36                          # the side of a patch's parameter domain in integers: 12 + 24 halvings
MAX_BITS, MAX_KNOT_BITS, MAX_SIZE = 8192, 2048, 1 << 20


# ---------------------------------------------------------------- arrays: halves, quarters, sides

def halves(c):
    """The Bernstein coefficients on both halves, times 2^degree."""
    n = len(c) - 1
    left, right = [0] * (n + 1), [0] * (n + 1)
    for r in range(n, -1, -1):
        left[n - r], right[r] = c[0] << r, c[-1] << r
        c = list(map(add, c, c[1:]))
    return left, right

def transposed(rows):
    return [list(r) for r in zip(*rows)]

def half_of_tensor(rows, axis, which):
    if axis == 0:
        return transposed([halves(c)[which] for c in zip(*rows)])
    return [halves(r)[which] for r in rows]

def quarters_of_tensor(rows):
    """The four quarters by (u half, v half), times 2^(both degrees)."""
    result = []
    for part in zip(*[halves(c) for c in zip(*rows)]):
        result += [list(q) for q in zip(*[halves(r) for r in transposed(part)])]
    return result

def moved_corner(levels, corner):
    """The triangle with this corner moved to the point at which levels were evaluated. levels[r]: after r steps, all of
    one scale."""
    n = len(levels) - 1
    if corner == 0:
        return [[levels[n - r][r][k] for k in range(r + 1)] for r in range(n + 1)]
    if corner == 1:
        return [[levels[r - k][k][k] for k in range(r + 1)] for r in range(n + 1)]
    return [[levels[k][r - k][0] for k in range(r + 1)] for r in range(n + 1)]

def bisected(rows, e):
    """The triangles with corner e + 1, or corner e + 2, moved to the midpoint of the side opposite to e, times
    2^degree."""
    n, levels = len(rows) - 1, []
    for r in range(n, -1, -1):
        levels.append([[c << r for c in row] for row in rows])
        if e == 0:
            rows = [list(map(add, row, row[1:])) for row in rows[1:]]
        elif e == 1:
            rows = [list(map(add, row, below[1:])) for row, below in zip(rows, rows[1:])]
        else:
            rows = [list(map(add, row, below)) for row, below in zip(rows, rows[1:])]
    return moved_corner(levels, (e + 1) % 3), moved_corner(levels, (e + 2) % 3)

def quarters_of_triangle(rows):
    """The quarters (c0, m2, m1), (m2, c1, m0), (m1, m0, c2), (m0, m1, m2), times 2^(2 degree)."""
    n = len(rows) - 1
    right, left = bisected(rows, 0)                         # (c0, m0, c2), (c0, c1, m0)
    second, near = bisected(left, 2)                        # (m2, c1, m0), (c0, m2, m0)
    third = bisected(right, 1)[1]                           # (m1, m0, c2)
    levels = []                                             # of near at m1 = c0 - m2 + m0
    for _ in range(n + 1):
        levels.append(near)
        near = [[a - b + c for a, b, c in zip(row, below, below[1:])] for row, below in zip(near, near[1:])]
    middle = moved_corner(levels, 0)                        # (m1, m2, m0)
    return [moved_corner(levels, 2), second, third,
            [[middle[k + n - r][n - r] for k in range(r + 1)] for r in range(n + 1)]]

def side_of_tensor(rows, s):
    return [[r[0] for r in rows], rows[-1], [r[-1] for r in rows[::-1]], rows[0][::-1]][s]

def side_of_triangle(rows, s):
    return [rows[-1], [r[-1] for r in rows[::-1]], [r[0] for r in rows]][s]


# ---------------------------------------------------------------- section 3: patches and X

def integers(values, most_bits, what):
    """The values times a factor > 0 that makes them integers without a common factor."""
    factor = 1
    for v in values:
        factor = lcm(factor, v.denominator)
        if factor.bit_length() > most_bits:
            raise Reject("B2", "%s are too long" % what)
    result = [v.numerator * (factor // v.denominator) for v in values]
    if any(abs(v).bit_length() > most_bits for v in result):
        raise Reject("B2", "%s are too long" % what)
    common = gcd(*result) or 1
    return [v // common for v in result]

def bezier_matrix(p, t, b):
    """Row i: the blossom at 0 (p - i times) and b (i times) of the p + 1 control points of the 2p knots t, times one
    factor > 0."""
    matrix = []
    for i in range(p + 1):
        d = [[int(j == c) for c in range(p + 1)] for j in range(p + 1)]
        for r in range(1, p + 1):
            at = 0 if r <= p - i else b
            common = lcm(*[t[p + j - r] - t[j - 1] for j in range(r, p + 1)])
            for j in range(p, r - 1, -1):
                lo, hi = t[j - 1], t[p + j - r]
                f = common // (hi - lo)
                d[j] = [f * ((hi - at) * x + (at - lo) * y) for x, y in zip(d[j - 1], d[j])]
        matrix.append(d[p])
    common = gcd(*[x for row in matrix for x in row])
    return [[x // common for x in row] for row in matrix]

def apply(matrix, rows):
    columns = list(zip(*rows))
    return [[sum(map(mul, line, column)) for column in columns] for line in matrix]

def axis_matrix(entity, axis, lo, hi):
    """(last control point, matrix) of the Bezier coefficients between two breaks without a knot between them."""
    k, numbers = axis_numbers(entity, axis, lo, hi)
    return k, bezier_matrix(entity.degrees[axis], numbers[:-1], numbers[-1])

def axis_numbers(entity, axis, lo, hi):
    """(last control point, the 2p knots around the interval and its end), all minus its begin, as integers."""
    p, knots = entity.degrees[axis], entity.knots[axis]
    k = bisect_right(knots, lo, p, len(knots) - p) - 1
    return k, integers([x - lo for x in knots[k - p + 1:k + p + 1]] + [hi - lo], MAX_KNOT_BITS, "knots and breaks")

def net_of(rows, unit):
    """The arrays of the points in units of 2^E, times one factor that makes them integers."""
    scale = Fraction(2) ** -unit
    flat = integers([c for row in rows for x, y, z, w in row for c in (x * scale, y * scale, z * scale, w)],
                    MAX_BITS, "control points")
    points = zip(*[iter(flat)] * 4)
    net = [list(islice(points, len(row))) for row in rows]
    return [[[point[c] for point in row] for row in net] for c in range(4)]

def triangle_patch(entity, flag, unit):
    return Patch(entity, flag, net_of(entity.rows, unit))

def along_u(entity, unit, u, kv):
    """The arrays whose rows are Bezier coefficients in u, and whose columns are the control points kv - q to kv. u: a
    result of axis_matrix."""
    (p, q), (ku, mu) = entity.degrees, u
    net = net_of([row[kv - q:kv + 1] for row in entity.rows[ku - p:ku + 1]], unit)
    return [transposed(apply(mu, a)) for a in net]

def surface_patch(entity, flag, columns, v, outer):
    """The patch of two intervals; columns: of along_u; v: a result of axis_matrix; outer: of outer_sides_of."""
    net = [transposed(apply(v[1], a)) for a in columns]
    common = gcd(*[c for a in net for row in a for c in row])
    return Patch(entity, flag, [[[c // common for c in row] for row in a] for a in net], outer)

def outer_sides_of(u, v, m, n):
    """The sides of patch (u, v) of m times n that lie on the border of the entity's domain."""
    return [side for side, is_outer in enumerate((v == 0, u == m - 1, v == n - 1, u == 0)) if is_outer]

def patches_of(entity, breaks, flag, unit):
    """The patches of one entity, v fastest."""
    if entity.kind == "triangle":
        yield triangle_patch(entity, flag, unit)
        return
    us, vs = [[axis_matrix(entity, axis, lo, hi) for lo, hi in zip(b, b[1:])] for axis, b in enumerate(breaks)]
    for i, u in enumerate(us):
        made = {}                                           # of along_u, for each interval of knots of v
        for j, v in enumerate(vs):
            if v[0] not in made:
                made[v[0]] = along_u(entity, unit, u, v[0])
            yield surface_patch(entity, flag, made[v[0]], v, outer_sides_of(i, j, len(us), len(vs)))

class Patch:
    """net: integers.  sides[s]: None collapsed, else (edge, first of the two?).  component: number.
    outer: the sides on the border of the entity's domain."""

    def __init__(self, entity, flag, net, outer=(0, 1, 2)):
        self.is_tensor, self.flag, self.degrees = entity.kind == "surface", flag, entity.degrees
        self.is_flat = not self.is_tensor and self.degrees == (1,) and not entity.rational
        self.rational, self.num_sides = entity.rational, 4 if self.is_tensor else 3
        self.quarters = quarters_of_tensor if self.is_tensor else quarters_of_triangle
        self.side_of = side_of_tensor if self.is_tensor else side_of_triangle
        self.net = net
        p, q = self.degrees * (1 if self.is_tensor else 2)
        self.num_g = 9 * p * q if self.is_tensor else 3 * p * (3 * p - 1) // 2
        self.both_degrees, self.bits = (p, q), longest(self.net)
        if self.num_g * self.bits > MAX_SIZE:
            raise Reject("B2", "the coefficients of a patch are too long for its degree")
        self.g, self.component, self.roots, self.index = None, None, (0, 0), 0
        self.sides, self.outer = [None] * self.num_sides, outer

    def corner(self, s, end):
        """The corner where side s starts (end 0) or ends, in the patch's own direction."""
        return (s + end + (not self.is_tensor)) % self.num_sides

    def side(self, s, net=None):
        """The homogeneous points of side s of a node with this net, in the patch's own direction."""
        return list(zip(*[self.side_of(a, s) for a in net or self.net]))

    def corner_of(self, rows):
        """The entries of an array at the corners."""
        corners = [rows[0][0], rows[-1][0], rows[-1][-1]]
        return corners + [rows[0][-1]] if self.is_tensor else corners

    def on_root(self, arrays, at):
        """The arrays on the root with these corners."""
        if not self.is_tensor:
            return arrays
        for axis, levels in enumerate(self.roots):
            for level in range(1, levels + 1):
                which = at[0][axis] * 2 ** level // FULL % 2
                arrays = [half_of_tensor(a, axis, which) for a in arrays]
        return arrays

    def make_g(self):
        """The arrays D, X, Y, Z of Bernstein coefficients with g_c = D - c.(X, Y, Z), times one factor > 0."""
        if self.g is None:
            self.g = determinant(self.net, self.is_tensor)
            if self.flag:
                self.g = [[[-c for c in row] for row in a] for a in self.g]
        return self.g

@lru_cache(1000)
def binomials(is_tensor, p, q):
    """The binomial factors of a polynomial of these degrees (of a triangle: p = q)."""
    if is_tensor:
        return [[comb(p, i) * comb(q, j) for j in range(q + 1)] for i in range(p + 1)]
    return [[comb(p, r) * comb(r, k) for k in range(r + 1)] for r in range(p + 1)]

class Packing:
    """Products of polynomials in Bernstein form.  Without their binomial factors they multiply like polynomials in
    powers; each is packed into one integer, 8 * width bits a coefficient."""

    def __init__(self, is_tensor, degrees, bits):
        """degrees: of the products (of a triangle: twice the same).  bits: every coefficient of a product, with its
        binomial factor, is below 2^bits in absolute value."""
        self.is_tensor, self.degrees, self.width, self.stride = is_tensor, degrees, bits // 8 + 1, degrees[1] + 1

    def place(self, r, k):
        """The number of the coefficient in row r, entry k."""
        return (r if self.is_tensor else r - k) * self.stride + k

    def packed(self, rows):
        factors = binomials(self.is_tensor, len(rows) - 1, len(rows[-1]) - 1)
        return sum(f * c << 8 * self.width * self.place(r, k) for r, pair in enumerate(zip(rows, factors))
                   for k, (c, f) in enumerate(zip(*pair)))

    def unpacked(self, product):
        """The coefficients with their binomial factors."""
        p, q = self.degrees
        half, count = 1 << 8 * self.width - 1, self.stride * (p + 1)
        bias = half * (((1 << 8 * self.width * count) - 1) // ((1 << 8 * self.width) - 1))
        data = (product + bias).to_bytes(self.width * count + 1, "little")
        return [[int.from_bytes(data[i * self.width:(i + 1) * self.width], "little") - half
                 for i in (self.place(r, k) for k in range((q if self.is_tensor else r) + 1))] for r in range(p + 1)]

    def coefficients(self, products):
        """The arrays of the products, all times one factor > 0."""
        factors = binomials(self.is_tensor, *self.degrees)
        common = lcm(*[c for row in factors for c in row])
        return [[[c * (common // f) for c, f in zip(row, line)] for row, line in zip(self.unpacked(product), factors)]
                for product in products]

def derivatives(rows, is_tensor):
    """The arrays of the derivatives along u and v (of a triangle: along c1 - c0 and c2 - c0), divided by degrees."""
    u = [[y - x for x, y in zip(r, s)] for r, s in zip(rows, rows[1:])]
    if is_tensor:
        return u, [[y - x for x, y in zip(r, r[1:])] for r in rows]
    return u, [[y - x for x, y in zip(r, s[1:])] for r, s in zip(rows, rows[1:])]

def longest(net):
    return max(abs(c).bit_length() for a in net for row in a for c in row)

def determinant(net, is_tensor):
    """The 3 x 3 minors of (F, F_u, F_v)."""
    p, q = len(net[0]) - 1, len(net[0][-1]) - 1
    # |coefficient| < 6 * 2^(bits + p + q) * 4^(bits + p + q + 1)
    packing = Packing(is_tensor, (3 * p - 1, 3 * q - 1) if is_tensor else (3 * p - 2,) * 2,
                      3 * (longest(net) + p + q + 4))
    f = [packing.packed(a) for a in net]
    u, v = zip(*[map(packing.packed, derivatives(a, is_tensor)) for a in net])

    def minor(i, j, k):
        return (f[i] * (u[j] * v[k] - u[k] * v[j]) - f[j] * (u[i] * v[k] - u[k] * v[i])
                + f[k] * (u[i] * v[j] - u[j] * v[i]))

    return packing.coefficients([minor(*columns) for columns in ((0, 1, 2), (1, 2, 3), (2, 0, 3), (0, 1, 3))])

class Groups:
    """Classes of 0, 1, ... by union-find."""

    def __init__(self, n):
        self.parent = list(range(n))

    def find(self, x):
        while self.parent[x] != x:
            self.parent[x] = x = self.parent[self.parent[x]]
        return x

    def unite(self, x, y):
        x, y = self.find(x), self.find(y)
        self.parent[max(x, y)] = min(x, y)

    def number(self):
        """The number of each element's class; classes are ordered by their least elements."""
        numbers = {}
        return [numbers.setdefault(self.find(x), len(numbers)) for x in range(len(self.parent))]

def is_collapsed(curve):
    return all(p[c] * curve[0][3] == curve[0][c] * p[3] for p in curve for c in range(3))

def curve_key(points):
    """A text that is equal for homogeneous curves that agree, in any degree, up to a positive factor.  A text has a
    keyed hash."""
    powers, n = [], len(points) - 1
    for k in range(n + 1):                                  # coefficients of the powers of t
        powers += [comb(n, k) * c for c in points[0]]
        points = [[b - a for a, b in zip(p, q)] for p, q in zip(points, points[1:])]
    while not any(powers[-4:]):
        del powers[-4:]
    common = gcd(*powers)
    return ",".join("%x" % (c // common) for c in powers)

def glue(patches, fail):
    """P1.  Sets sides and components; returns (edges, vertices, [chi of each component], vertex class of corner 4 *
    patch + s)."""
    places, components, corners, edges = {}, Groups(len(patches)), Groups(4 * len(patches)), 0
    for i, patch in enumerate(patches):
        for s in range(patch.num_sides):
            curve = patch.side(s)
            x, y = 4 * i + patch.corner(s, 0), 4 * i + patch.corner(s, 1)
            if is_collapsed(curve):
                if s not in patch.outer:
                    fail("P1", "side %d of patch %d is collapsed, and inside of its surface" % (s, i))
                corners.unite(x, y)
            else:
                curve = curve[::-1] if patch.flag else curve
                places.setdefault(curve_key(curve), []).append((patch, i, s, x, y, curve_key(curve[::-1])))
    for key, sides in places.items():
        back = sides[0][5]
        others = places.get(back, [])
        if len(sides) != 1 or len(others) != 1 or back == key:
            fail("P1", "side %d of patch %d has %d opposite and %d equal sides" %
                 (sides[0][2], sides[0][1], len(others), len(sides) - 1))
        for (patch, i, s, x, y, _), other in zip(sides, others if back != key else []):
            if patch.sides[s] is None:
                other, j, t, z, w, _ = other
                patch.sides[s], other.sides[t] = (edges, True), (edges, False)
                edges += 1
                components.unite(i, j)
                for a, b in ((x, w), (y, z)) if patch.flag == other.flag else ((x, z), (y, w)):
                    corners.unite(a, b)
    for patch, _, s, _, _, _ in [side for sides in places.values() for side in sides]:
        if patch.sides[s] is None:                          # with P1 only if it is not tested
            patch.sides[s], edges = (edges, True), edges + 1
    numbers, classes = components.number(), corners.number()
    chi = [0] * (max(numbers, default=-1) + 1)
    for patch, n in zip(patches, numbers):
        patch.component = n
        chi[n] += 1 - sum(1 for side in patch.sides if side and side[1])
    owner = {}
    for i, patch in enumerate(patches):
        for s in range(patch.num_sides):
            owner[classes[4 * i + s]] = patch.component
    for n in owner.values():
        chi[n] += 1
    return edges, len(owner), chi, classes
