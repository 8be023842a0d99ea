# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Flat triangles in mesh boxes: which meet a box, and whether two of them meet properly (section 5 of star-box.md)."""
from collections import namedtuple
from fractions import Fraction

from ..common.vectors import cross, dot, sub

# A tested triangle: the number of its patch, its corners, their vertex classes, the edges of X on its sides.
Flat = namedtuple("Flat", "patch corners vertices edges")

def corners_of(patch):
    """The corners of a flat triangle."""
    return [tuple(Fraction(c, p[3]) for c in p[:3]) for p in (patch.side(1)[1], patch.side(2)[1], patch.side(0)[1])]

def triangle_misses_box(t, box):
    """A separating direction among the 13 that decide it for a triangle, degenerate or not, and a box."""
    units = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    edges = [sub(t[i - 2], t[i]) for i in range(3)]
    for axis in [*units, cross(edges[0], edges[1]), *[cross(u, e) for u in units for e in edges]]:
        of_t = [dot(axis, p) for p in t]
        if (min(of_t) > sum(max(n * l, n * h) for n, l, h in zip(axis, box.lo, box.hi)) or
                max(of_t) < sum(min(n * l, n * h) for n, l, h in zip(axis, box.lo, box.hi))):
            return True
    return False

def common_points(s, t):
    """Corners of the intersection of two triangles, t not degenerate: s cut by the plane and the sides of t."""
    normal, polygon = cross(sub(t[1], t[0]), sub(t[2], t[0])), list(s)
    planes = [(normal, t[0]), (tuple(-n for n in normal), t[0])]
    planes += [(cross(normal, sub(t[i - 2], t[i])), t[i]) for i in range(3)]
    for n, at in planes:
        heights, result = [dot(n, sub(p, at)) for p in polygon], []
        for i, (p, h) in enumerate(zip(polygon, heights)):
            q, g = polygon[i - 1], heights[i - 1]
            if min(g, h) < 0 < max(g, h):
                result.append(tuple((x * h - y * g) / (h - g) for x, y in zip(q, p)))
            if h >= 0:
                result.append(p)
        polygon = result
    return polygon

def meet_properly(s, t, common, num_edges):
    """Do triangles meet exactly in the hull of the common vertices?  common: their points."""
    if (len(common), num_edges) not in ((0, 0), (1, 0), (2, 1)):
        return False
    points = common_points(s, t)
    if len(common) < 2:
        return all(p in common for p in points)
    along = sub(common[1], common[0])
    return all(cross(sub(p, common[0]), along) == (0, 0, 0) for p in points)
