# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Values of simplex-spline solids by the definitions of docs/formats/dms-files.md, in fractions: for tests. It shares no code with the
program or the checkers, and has no caches beside the recurrence's."""
import functools
import itertools
import json
from fractions import Fraction as F


def det(a, b, c):
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]))


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def d(w):
    return det(*(minus(p, w[0]) for p in w[1:]))


@functools.lru_cache(maxsize=None)
def frame(w):
    """For each corner its barycentric coordinate at the origin and the derivatives along the axes; nothing for a flat w."""
    whole = d(w)
    if not whole:
        return None
    at = lambda u: [d([*w[:m], u, *w[m + 1:]]) / whole for m in range(4)]     # noqa: E731
    zero, *ends = (at([F(int(i == a)) for i in range(3)]) for a in (-1, 0, 1, 2))
    return [(zero[m], [end[m] - zero[m] for end in ends]) for m in range(4)]


def shares(w, u):
    """The barycentric coordinates of u, or nothing for a flat w."""
    known = frame(tuple(map(tuple, w)))
    return known and [base + sum(s * x for s, x in zip(slope, u)) for base, slope in known]


def slopes(w):
    """For each corner the derivatives of its barycentric coordinate along the axes."""
    return [slope for _, slope in frame(tuple(map(tuple, w)))]


class Spline:
    """One spline of a file: its geometry, or its attribute domain."""

    def __init__(self, part):
        self.n = part["degree"]
        self.clouds = [[[F(c) for c in knot] for knot in cloud] for cloud in part["vertices"]]
        self.tetrahedra = part["tetrahedra"]
        self.shared = "at" in part["control"][0]
        self.control = {}
        for entry in part["control"]:
            key = tuple(entry["at"]) if self.shared else (entry["tetrahedron"], *entry["beta"])
            self.control[key] = [F(c) for c in entry["value"]]

    def knot(self, vertex, i):
        return self.clouds[vertex][i if i < len(self.clouds[vertex]) else 0]

    def point(self, t, beta):
        if not self.shared:
            return self.control[(t, *beta)]
        return self.control[tuple(sorted(v for v, b in zip(self.tetrahedra[t], beta) for _ in range(b)))]

    def path(self, u):
        """Directions: the path is u + e1 x1 + e2 x2 + ... with falling e. Nothing outside of the domain."""
        axes = [[F(int(i == a)) for i in range(3)] for a in range(3)]
        corners = [[self.knot(v, 0) for v in t] for t in self.tetrahedra]
        if any(enters(w, u, axes) for w in corners):
            return axes
        for w in corners:
            if min(shares(w, u)) >= 0:
                middle = [sum(p[c] for p in w) / 4 for c in range(3)]
                return [minus(middle, u), *axes]
        return None

    def value(self, u):
        """(values, gradients) at u, or nothing."""
        path = self.path(u)
        if path is None:
            return None
        size = len(next(iter(self.control.values())))
        value, gradient, known = [F(0)] * size, [[F(0)] * 3 for _ in range(size)], {}
        last = self.n - 1 if self.shared else self.n
        for t, corners in enumerate(self.tetrahedra):
            for gamma in indices(last):
                w = [self.knot(v, i) for v, i in zip(corners, gamma)]
                knots = sorted(tuple(self.knot(v, k)) for v, i in zip(corners, gamma) for k in range(i + 1))
                height = simplex_spline(tuple(knots), u, path, known)
                if self.shared:
                    terms = [(self.point(t, raised(gamma, m)), share * height, [self.n * s * height for s in slope])
                             for m, (share, slope) in enumerate(zip(shares(w, u), slopes(w)))] if height else []
                else:
                    terms = [(self.point(t, gamma), height, gradient_of(tuple(knots), u, path, known))]
                for control, factor, slope in terms:
                    for c in range(size):
                        value[c] += d(w) * factor * control[c]
                        for a in range(3):
                            gradient[c][a] += d(w) * slope[a] * control[c]
        return value, gradient


def enters(w, u, path):
    base = shares(w, u)
    if base is None or min(base) < 0:
        return False
    if min(base) > 0:
        return True
    slope = slopes(w)
    for m in range(4):
        along = [base[m], *(sum(s * x for s, x in zip(slope[m], way)) for way in path)]
        if next(x for x in along if x) < 0:
            return False
    return True


@functools.lru_cache(maxsize=None)
def independent(knots):
    return next((w for w in itertools.combinations(range(len(knots)), 4) if frame(tuple(knots[i] for i in w))), None)


def simplex_spline(knots, u, path, known):
    """M(u | knots), with d of the frame for degree 0 in the denominator."""
    if knots in known:
        return known[knots]
    four = independent(knots)
    if four is None:
        result = F(0)
    elif len(knots) == 4:
        result = 1 / abs(d(knots)) if enters(knots, u, path) else F(0)
    else:
        w = [knots[i] for i in four]
        result = sum(share * simplex_spline(knots[:i] + knots[i + 1:], u, path, known) for i, share in zip(four, shares(w, u)) if share)
    known[knots] = result
    return result


def gradient_of(knots, u, path, known):
    four, k = independent(knots), len(knots) - 4
    if four is None or k == 0:
        return [F(0)] * 3
    parts = [simplex_spline(knots[:i] + knots[i + 1:], u, path, known) for i in four]
    return [k * sum(s[a] * p for s, p in zip(slopes([knots[i] for i in four]), parts)) for a in range(3)]


def indices(total):
    return [g for g in itertools.product(range(total + 1), repeat=4) if sum(g) == total]


def raised(gamma, m):
    return tuple(g + (i == m) for i, g in enumerate(gamma))


def values(data, u):
    """The values and gradients of a file at u: those of the geometry, then those of its attribute domain."""
    file = json.loads(data) if isinstance(data, (str, bytes)) else data
    parts = [Spline(file).value(u)]
    if "attribute_domain" in file:
        parts.append(Spline(file["attribute_domain"]).value(u))
    return None if parts[0] is None else tuple(sum((p[i] for p in parts), []) for i in range(2))
