# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The triangles of a mesh in binary64, with bounds for all errors (docs/certificates/micro-inside.md, sections 3 and
6)."""
from functools import lru_cache
from math import inf, sqrt

from ..common.vectors import cross, dot, sub
from ..points.box_tree import BoxTree, boxes_of_triangles

class Triangles:
    """greatest: the greatest coordinate, in absolute value; tree: of their boxes; met: how often a box of points met
    that of a triangle."""

    def __init__(self, mesh):
        self.mesh = mesh
        self.tree = BoxTree(list(boxes_of_triangles(mesh.floats, mesh.triangles)))
        self.greatest = max(map(abs, self.tree.nodes[0][0]))
        self.met = 0
        self.directions = lru_cache(1 << 17)(self.directions)

    def directions(self, f):
        """(d, least of d.a, d.b, d.c, greatest) for the last four of the seven vectors, each divided by its greatest
        component. The components are rounded once, the products are off by at most 12 units in the last place of the
        greatest coordinate."""
        mesh = self.mesh
        n, (a, b, c) = mesh.normals[f], mesh.corners(f)
        corners = [mesh.floats[v] for v in mesh.triangles[f]]
        found = []
        for d in (n, *[cross(n, side) for side in (sub(b, a), sub(c, b), sub(a, c))]):
            scale = max(map(abs, d))
            x, y, z = [t / scale for t in d]
            values = [x * p + y * q + z * r for p, q, r in corners]
            found.append((x, y, z, min(values), max(values)))
        return found

    def not_apart(self, points, triangles):
        """Those of the triangles that are not shown to be apart from the points."""
        x0, x1, y0, y1, z0, z1 = points.box
        boxes, directions, extent, found = self.tree.boxes, self.directions, points.extent, []
        margin = points.slack(self.greatest)
        for f in triangles:
            a, b, c, d, e, g = boxes[f]
            if a > x1 or b < x0 or c > y1 or d < y0 or e > z1 or g < z0:
                continue
            self.met += 1
            for x, y, z, least, greatest in directions(f):
                lo, hi = extent(x, y, z)
                if lo > greatest + margin or hi < least - margin:
                    break
            else:
                found.append(f)
        return found

    def within(self, points, distance):
        """Is there a triangle from which no point is farther than the distance?"""
        x0, x1, y0, y1, z0, z1 = points.box
        margin = points.slack(self.greatest)
        grown = (x0 - distance - margin, x1 + distance + margin, y0 - distance - margin, y1 + distance + margin,
                 z0 - distance - margin, z1 + distance + margin)
        limit, count = distance - margin, 0
        for f in self.tree.meeting(grown):
            count += 1
            corners = [self.mesh.floats[v] for v in self.mesh.triangles[f]]
            if all(distance_to(p, corners) <= limit for p in zip(points.x, points.y, points.z)):
                return True, count
        return False, count

def distance_to(p, corners):
    """At least the distance of the point from the triangle, but for an error that margin() covers: the distance from
    some point of it."""
    a, b, c = corners
    ab, ac, ap = sub(b, a), sub(c, a), sub(p, a)
    g, h, k, u, v = dot(ab, ab), dot(ab, ac), dot(ac, ac), dot(ab, ap), dot(ac, ap)
    det = g * k - h * h
    if det > 0:
        s, t = (k * u - h * v) / det, (g * v - h * u) / det
        if s >= 0 and t >= 0 and s + t <= 1:
            return length_from(ap, ab, ac, s, min(t, 1 - s))
    best = inf
    for s, t in ((of(u, g), 0.), (0., of(v, k)), on_third_side(g, h, k, u, v)):
        best = min(best, length_from(ap, ab, ac, s, t))
    return best

def of(u, g):
    """The parameter of the nearest point of a side."""
    return min(1., max(0., u / g)) if g > 0 else 0.

def on_third_side(g, h, k, u, v):
    t = of(v - u + g - h, g - 2 * h + k)
    return 1 - t, t

def length_from(ap, ab, ac, s, t):
    """s, t >= 0, and their sum is at most 1 but for one rounding."""
    x, y, z = [p - s * q - t * r for p, q, r in zip(ap, ab, ac)]
    return sqrt(x * x + y * y + z * z)
