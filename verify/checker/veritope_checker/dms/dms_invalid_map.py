# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Findings about the map (docs/certificates/dms-invalid.md, sections 3 to 6): W5, W6 and W11 to W13. Each method says
why the condition does not hold, or None; the model obeys V1."""
from functools import lru_cache
from math import lcm

from ..common.vectors import cross, dot, sub
from ..patches.patch_invalid_check import are_independent, over_square, unseparated
from .dms_domain import triangle_entity
from .dms_invalid_domain import face_at, is_of_the_boundary
from .dms_map import bernstein, det, is_in_closed, multi_indices
from .dms_near import coefficients, derivatives, first_cut, leaf_region, tile_region, unexcluded
from .dms_walls import normal_of

def determinant(rows):
    return dot(cross(rows[0], rows[1]), rows[2])

class MapFindings:
    """spline: a Map; spend(): is called for each unit of work."""

    def __init__(self, spline, spend):
        self.spline, self.model, self.spend = spline, spline.model, spend
        self.tests = {"jacobian": self.why_not_negative, "jacobian-zero": self.why_not_flat,
                      "meeting": self.why_no_meeting, "crossing": self.why_no_crossing,
                      "covering": self.why_no_covering}

    def value(self, point):
        return self.spline.at(point, self.spline.all_near(point))

    def why_not_negative(self, point):
        """W5."""
        u = self.spline.scaled(point)
        if not self.spline.is_in_domain(u):
            return "the point is not in the domain"
        if determinant(self.spline.derivative_at(u, self.spline.all_near(u))) >= 0:
            return "the determinant is not negative"
        return None

    def why_no_meeting(self, points):
        """W11."""
        u, v = map(self.spline.scaled, points)
        if u == v or not self.spline.is_in_domain(u) or not self.spline.is_in_domain(v):
            return "they are not two points of the domain"
        return "the images differ" if self.value(u) != self.value(v) else None

    # ------------------------------------------------------------ section 4

    def why_not_flat(self, witness):
        """W6."""
        why = self.why_no_leaf(witness)
        if why:
            return why
        of_leaf = derivatives(self.spline, self.corners, self.near)
        entries = integer_columns([[c for row in d for c in row] for d in of_leaf])
        for weights in weights_at_lattice(self.model.degree):
            a = [sum(w * c for w, c in zip(weights, column) if c) for column in entries]
            if determinant((a[:3], a[3:6], a[6:])):
                return "the determinant does not vanish everywhere in the leaf"
        return None

    def why_no_leaf(self, leaf):
        """What W6 and (l) of W13 say about a leaf alone; keeps its corners and the V_gamma near it."""
        t, points, planes = leaf
        self.corners, root = [self.spline.scaled(p) for p in points], self.spline.corners(t)
        if det(*self.corners) <= 0 or not all(is_in_closed(root, c) for c in self.corners):
            return "the leaf is flat or reversed, or not in its tetrahedron"
        region = leaf_region(self.spline, self.corners, root, planes)
        self.near = list(unexcluded(self.spline, region, self.spend))
        return "the leaf is cut by knots" if first_cut(region, self.near, self.spend) else None

    # ------------------------------------------------------------ section 5

    def why_no_crossing(self, crossing):
        """W12."""
        faces = [face_at(self.model, piece.face) for piece in crossing.pieces]
        pieces = [[self.spline.scaled(p) for p in piece.points] for piece in crossing.pieces]
        return (self.why_no_pieces(faces, pieces) or self.why_cut(pieces, crossing.pieces)
                or why_wrong_intervals(*crossing.at) or self.why_not_apart(faces, pieces, crossing.at)
                or self.why_no_common_image(pieces, crossing))

    def why_no_pieces(self, faces, pieces):
        """(p)"""
        if not is_of_the_boundary(self.model, *faces):
            return "a piece is not of the boundary"
        for face, points in zip(faces, pieces):
            corners = [self.spline.knots[v][0] for v in face]
            normal = normal_of(corners)
            if dot(normal, normal_of(points)) <= 0 or not all(is_in_triangle(p, corners, normal) for p in points):
                return "a piece is flat or reversed, or not in its face"
        return None

    def why_cut(self, pieces, given):
        """(t); keeps the V_gamma near the pieces."""
        self.near = []
        for points, piece in zip(pieces, given):
            region = tile_region(self.spline, points, piece.planes)
            near = list(unexcluded(self.spline, region, self.spend))
            if first_cut(region, near, self.spend):
                return "a piece is cut by knots"
            self.near.append(near)
        return None

    def why_not_apart(self, faces, pieces, at):
        """(d)"""
        if set(faces[0]) != set(faces[1]) or are_beside(*pieces) or are_beside(*pieces[::-1]):
            return None
        if pieces[0] == pieces[1] and any(s.misses(t) for s, t in zip(*at)):
            return None
        return "the pieces may overlap"

    def why_no_common_image(self, pieces, crossing):
        """(y)"""
        nets = [self.net_on(points, near) for points, near in zip(pieces, self.near)]
        if not are_independent(crossing.y) or unseparated(crossing.at, nets, crossing.y):
            return "the images need not cross"
        return None

    def net_on(self, points, near):
        """The net of a tensor patch over (s, t), in integers."""
        rows = triangle_entity(self.model.degree, coefficients(self.spline, points, near)).rows
        factor = lcm(*[c.denominator for row in rows for p in row for c in p])
        return over_square([[[int(p[i] * factor) for p in row] for row in rows] for i in range(4)])

    # ------------------------------------------------------------ section 6

    def why_no_covering(self, witness):
        """W13."""
        leaf, point = witness
        why = self.why_no_leaf(leaf)
        if why:
            return why
        u = self.spline.scaled(point)
        if not self.spline.is_in_domain(u) or is_in_closed(self.corners, u):
            return "the point is not in the domain, or in the leaf"
        on_leaf = dict(zip(multi_indices(self.model.degree, 4), coefficients(self.spline, self.corners, self.near)))
        return why_not_covered(on_leaf, self.value(u))

def why_not_covered(on_leaf, x):
    """(c)"""
    n = max(next(iter(on_leaf)))
    images = [on_leaf[tuple(n * (k == m) for k in range(4))] for m in range(4)]
    whole = det(*images)
    if not whole:
        return "the images of the corners lie in a plane"
    for m in range(4):
        at_x = det(*with_point(images, m, x))
        for beta, b in on_leaf.items():
            if not beta[m] and (at_x - det(*with_point(images, m, b))) * whole <= 0:
                return "no plane parts the image of the point from a face's coefficients"
    return None

def with_point(points, m, point):
    return [*points[:m], point, *points[m + 1:]]

def is_in_triangle(p, corners, normal):
    return not dot(normal, sub(p, corners[0])) and all(
        dot(normal, cross(sub(b, a), sub(p, a))) >= 0 for a, b in zip(corners, [*corners[1:], corners[0]]))

def are_beside(one, other):
    """Whether the line of a side of one triangle parts it from the other one, in their common plane."""
    normal = normal_of(one)
    return any(all(dot(normal, cross(sub(b, a), sub(p, a))) <= 0 for p in other)
               for a, b in zip(one, [*one[1:], one[0]]))

def why_wrong_intervals(a, b):
    """(x)"""
    if sum(at.is_point() for at in (*a, *b)) != 1:
        return "not exactly one of the four intervals is a point"
    if not all(at.is_open() for at in a) or b[0].lo == 0:
        return "an interval has an end of [0, 1]"
    return None

def integer_columns(rows):
    """The columns of a matrix times a factor > 0."""
    factor = lcm(*[c.denominator for row in rows for c in row])
    return [[int(c * factor) for c in column] for column in zip(*rows)]

@lru_cache(None)
def weights_at_lattice(n):
    """The Bernstein polynomials of degree n - 1 at the points of W6, times a factor > 0."""
    indices, lattice = multi_indices(n - 1, 4), multi_indices(3 * (n - 1), 4)
    return [[int(bernstein(index, [i + 1 for i in point])) for index in indices] for point in lattice]
