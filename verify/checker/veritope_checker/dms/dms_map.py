# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Simplex splines and the map of a solid (docs/formats/dms-files.md, "The map"), in exact numbers.

The domain is scaled by the least common denominator of its knots if that is short, so that coordinates are integers:
the values of the map stay, derivatives change by a positive factor."""
from fractions import Fraction
from itertools import combinations
from math import ceil, floor, lcm

from ..common.vectors import cross, dot, sub
from ..points.box_tree import BoxTree

MAX_SCALE_BITS = 512
AXES = ((1, 0, 0), (0, 1, 0), (0, 0, 1))

def det(a, b, c, e):
    return dot(cross(sub(b, a), sub(c, a)), sub(e, a))

def multi_indices(total, parts):
    """All lists of `parts` numbers >= 0 with this sum, in descending order."""
    if parts == 1:
        return [(total,)]
    return [(first, *rest) for first in range(total, -1, -1) for rest in multi_indices(total - first, parts - 1)]

def scale_of(clouds):
    scale = 1
    for cloud in clouds:
        for knot in cloud:
            for c in knot:
                scale = lcm(scale, c.denominator)
                if scale.bit_length() > MAX_SCALE_BITS:
                    return 1
    return scale

def box_of(points):
    """As a BoxTree wants it, rounded outward."""
    return tuple(end for c in zip(*points) for end in (floor(min(c)), ceil(max(c))))

class Map:
    """model: a Spline.  knots: of each vertex, scaled; gammas: of |gamma| = n - 1; tree: boxes of all knots that the
    V_gamma of each tetrahedron have; spend(): is called for each value of a simplex spline."""

    def __init__(self, model, spend):
        self.model, self.spend, self.scale = model, spend, scale_of(model.clouds)
        self.knots = [[self.scaled(knot) for knot in cloud] for cloud in model.clouds]
        self.gammas = multi_indices(model.degree - 1, 4)
        used = range(model.degree)
        self.tree = BoxTree([box_of([self.knots[v][i] for v in t for i in used]) for t in model.tetrahedra])
        self.cells = BoxTree([box_of(self.corners(t)) for t in range(len(model.tetrahedra))])
        self.affine_maps = {}                               # by tetrahedron and gamma
        self.names = {}                                     # of different knots, so that V is a list of numbers
        self.places = []

    def scaled(self, point):
        point = [self.scale * c for c in point]
        return tuple(c.numerator if c.denominator == 1 else c for c in point)

    def corners(self, t):
        return [self.knots[v][0] for v in self.model.tetrahedra[t]]

    def value(self, t, beta):
        """c(I, beta)."""
        if not self.model.shared:
            return self.model.control[t, beta]
        vertices = self.model.tetrahedra[t]
        return self.model.control[tuple(sorted(v for v, b in zip(vertices, beta) for _ in range(b)))]

    def w_of(self, t, gamma):
        return [self.knots[v][i] for v, i in zip(self.model.tetrahedra[t], gamma)]

    def v_of(self, t, gamma):
        """The knots of V_gamma, as (vertex, index)."""
        return [(v, k) for v, i in zip(self.model.tetrahedra[t], gamma) for k in range(i + 1)]

    def values_about(self, t, gamma):
        """c(I, gamma + e_m), m = 0, ..., 3."""
        return [self.value(t, (*gamma[:m], gamma[m] + 1, *gamma[m + 1:])) for m in range(4)]

    def derivative(self, t, gamma):
        """G_gamma, but for a positive factor: rows are components."""
        return linear_part(self.w_of(t, gamma), self.values_about(t, gamma))

    def affine(self, t, gamma):
        """L_gamma in integers: (rows, offset, denominator > 0), it takes q to (rows q + offset) / denominator. So the
        rows are those of G_gamma times a positive factor."""
        if (t, gamma) not in self.affine_maps:
            rows = self.derivative(t, gamma)
            origin, value = self.w_of(t, gamma)[0], self.values_about(t, gamma)[0]
            offset = [c - dot(row, origin) for row, c in zip(rows, value)]
            *rows, offset, (denominator,) = integer_rows([*rows, offset, [1]])
            self.affine_maps[t, gamma] = rows, offset, denominator
        return self.affine_maps[t, gamma]

    def at(self, point, near):
        """s at a point of the domain (scaled). near: (tetrahedron, gamma) of all V_gamma whose hulls have the point."""
        total = [0, 0, 0]
        for t, gamma, basis in self.basis_at(point, near):
            for share, c in zip(barycentric(point, self.w_of(t, gamma)), self.values_about(t, gamma)):
                total = [a + basis * share * b for a, b in zip(total, c)]
        return total

    def derivative_at(self, point, near):
        """Ds at a point of the domain (scaled), but for a positive factor: rows are components."""
        total = [[0] * 3 for _ in range(3)]
        for t, gamma, basis in self.basis_at(point, near):
            total = [[a + basis * b for a, b in zip(row, other)]
                     for row, other in zip(total, self.derivative(t, gamma))]
        return total

    def basis_at(self, point, near):
        """(tetrahedron, gamma, N_gamma(point)) of those that do not vanish."""
        path, memo = self.path_from(point), {}
        for t, gamma in near:
            name = sorted(self.name(self.knots[v][k]) for v, k in self.v_of(t, gamma))
            basis = self.simplex_spline(tuple(name), path, memo)
            if basis:
                yield t, gamma, basis * det(*self.w_of(t, gamma))

    def all_near(self, point):
        """(tetrahedron, gamma) of all V_gamma whose hulls may have the point."""
        return [(t, gamma) for t in self.tree.meeting(box_of([point])) for gamma in self.gammas]

    def is_in_domain(self, point):
        return any(is_in_closed(self.corners(t), point) for t in self.cells.meeting(box_of([point])))

    def path_from(self, point):
        """The point and the directions of the path that leaves it, by rule H."""
        straight, here = (point, *AXES), []
        for t in sorted(self.cells.meeting(box_of([point]))):
            corners = self.corners(t)
            if contains(corners, straight):
                return straight
            if not here and is_in_closed(corners, point):
                here = corners
        middle = [Fraction(sum(c), 4) for c in zip(*here)]
        return (point, sub(middle, point), *AXES)

    def name(self, knot):
        if knot not in self.names:
            self.names[knot] = len(self.places)
            self.places.append(knot)
        return self.names[knot]

    def simplex_spline(self, names, path, memo):
        """M(u|V), V by the names of its knots, ascending."""
        if names in memo:
            return memo[names]
        self.spend()
        points = [self.places[n] for n in names]
        if len(names) == 4:
            d = det(*points)
            found = Fraction(1, abs(d)) if d and contains(points, path) else 0
        else:
            found = 0
            at = independent(points)
            if at:
                for share, m in zip(barycentric(path[0], [points[i] for i in at]), at):
                    if share:
                        found += share * self.simplex_spline(names[:m] + names[m + 1:], path, memo)
        memo[names] = found
        return found

def independent(points):
    """The places of four points that are not in one plane, or None."""
    first = 0
    second = next((i for i, p in enumerate(points) if p != points[first]), None)
    if second is None:
        return None
    line = sub(points[second], points[first])
    third = next((i for i, p in enumerate(points) if any(cross(line, sub(p, points[first])))), None)
    if third is None:
        return None
    normal = cross(line, sub(points[third], points[first]))
    fourth = next((i for i, p in enumerate(points) if dot(normal, sub(p, points[first]))), None)
    return None if fourth is None else (first, second, third, fourth)

def faces_and_apexes(corners):
    """(three corners, the fourth one) for each m, so that the volume of the point before the three has the sign of
    lambda_m times that of the whole."""
    a, b, c, e = corners
    return ((b, c, e), a), ((a, e, c), b), ((a, b, e), c), ((a, c, b), e)

def barycentric(point, corners):
    d = det(*corners)
    return [Fraction(det(point, *face), d) for face, _ in faces_and_apexes(corners)]

def contains(corners, path):
    """Rule H, for a tetrahedron that is not flat."""
    for face, apex in faces_and_apexes(corners):
        normal = cross(sub(face[1], face[0]), sub(face[2], face[0]))
        inner = dot(normal, sub(apex, face[0]))
        signs = (dot(normal, sub(path[0], face[0])), *(dot(normal, step) for step in path[1:]))
        if next(s for s in signs if s) * inner < 0:
            return False
    return True

def is_in_closed(corners, point):
    return all(dot(cross(sub(f[1], f[0]), sub(f[2], f[0])), sub(point, f[0]))
               * dot(cross(sub(f[1], f[0]), sub(f[2], f[0])), sub(apex, f[0])) >= 0
               for f, apex in faces_and_apexes(corners))

def linear_part(points, values):
    """The matrix, a row for each component, of the affine map that takes four points to four values."""
    origin, *rest = points
    a, b, c = [sub(p, origin) for p in rest]
    d = dot(cross(a, b), c)
    gradients = [[Fraction(x, d) for x in v] for v in (cross(b, c), cross(c, a), cross(a, b))]
    steps = [sub(v, values[0]) for v in values[1:]]
    return [[sum(step[i] * g[j] for step, g in zip(steps, gradients)) for j in range(3)] for i in range(3)]

def integer_rows(rows):
    """Rows of numbers times a common factor > 0 that makes them integers, the least one."""
    factor = lcm(*[c.denominator for row in rows for c in row])
    return [[int(c * factor) for c in row] for row in rows]

class Interpolation:
    """The Bernstein coefficients of a polynomial of degree n on a simplex with `corners` corners from its values at the
    points (indices + 1) / (n + corners)."""
    known = {}

    def __init__(self, n, corners):
        self.indices, self.n, self.num_corners = multi_indices(n, corners), n, corners
        self.shares = [[Fraction(i + 1, n + corners) for i in index] for index in self.indices]
        self.inverse = inverse_of([[bernstein(index, shares) for index in self.indices] for shares in self.shares])

    @classmethod
    def of(cls, n, corners):
        if (n, corners) not in cls.known:
            cls.known[n, corners] = cls(n, corners)
        return cls.known[n, corners]

    def points(self, corners):
        return [tuple(sum(share * c[i] for share, c in zip(shares, corners)) for i in range(3))
                for shares in self.shares]

    def coefficients(self, values):
        return [[sum(a * v[i] for a, v in zip(row, values) if a) for i in range(3)] for row in self.inverse]

def bernstein(index, shares):
    value, left = Fraction(1), sum(index)
    for i, share in zip(index, shares):
        for k in range(i):
            value *= share * Fraction(left, k + 1)
            left -= 1
    return value

def inverse_of(rows):
    """The inverse of a regular matrix."""
    n = len(rows)
    table = [[*row, *(Fraction(i == j) for j in range(n))] for i, row in enumerate(rows)]
    for i in range(n):
        pivot = next(k for k in range(i, n) if table[k][i])
        table[i], table[pivot] = table[pivot], table[i]
        table[i] = [c / table[i][i] for c in table[i]]
        for k in range(n):
            if k != i and table[k][i]:
                table[k] = [a - table[k][i] * b for a, b in zip(table[k], table[i])]
    return [row[n:] for row in table]

def triples(points):
    """Three different ones of them, not on one line."""
    for three in combinations(sorted(set(points)), 3):
        if any(cross(sub(three[1], three[0]), sub(three[2], three[0]))):
            yield three
