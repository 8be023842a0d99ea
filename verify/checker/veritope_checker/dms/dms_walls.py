# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Planes between knots and a tetrahedron or a tile (docs/certificates/dms-solid.md, sections 4 to 6)."""
from ..common.vectors import cross, dot, sub

class Region:
    """A triangle, a tetrahedron, or the convex hull of several ones, with the planes that may part knots from it.
    planes: (vector, number), all of the region on one closed side, not all of it in the plane; other ones are left
    out."""

    def __init__(self, corners, planes):
        self.corners, self.masks = corners, {}
        self.normal = normal_of(corners) if len(corners) == 3 else None
        self.lows = [min(c) for c in zip(*corners)]
        self.highs = [max(c) for c in zip(*corners)]
        self.sides = []
        for vector, number in planes:
            side = side_of(corners, vector, number)
            if side:
                self.sides.append((vector, number, side))

    def mask(self, point):
        """Bit i is set if the point is on the other closed side of plane i."""
        if point not in self.masks:
            bits = 0
            for i, (c, low, high) in enumerate(zip(point, self.lows, self.highs)):
                bits |= (c < low or c == low < high) << 2 * i | (c > high or c == high > low) << 2 * i + 1
            for i, (vector, number, side) in enumerate(self.sides):
                bits |= (side * (dot(vector, point) - number) <= 0) << 6 + i
            self.masks[point] = bits
        return self.masks[point]

    def misses(self, points):
        """Whether one of the planes parts these points from the region."""
        if self.normal:
            points = self.in_plane(points)
        bits = -1
        for point in points:
            bits &= self.mask(point)
            if not bits:
                return False
        return True

    def in_plane(self, points):
        """Those of a list that can lie in a tile: if all are on one side of its plane, those in the plane."""
        heights = [dot(self.normal, sub(p, self.corners[0])) for p in points]
        if min(heights) < 0 < max(heights):
            return points
        return [p for p, height in zip(points, heights) if not height]

    def misses_triangle(self, three):
        """misses(), or the plane of the three points does it."""
        if self.misses(three):
            return True
        normal = normal_of(three)
        return side_of(self.corners, normal, dot(normal, three[0])) != 0

def normal_of(corners):
    return cross(sub(corners[1], corners[0]), sub(corners[2], corners[0]))

def side_of(corners, vector, number):
    """1 or -1 if the corners are on one closed side of the plane, not all in it; otherwise 0."""
    side = 0
    for corner in corners:
        height = dot(vector, corner) - number
        if height * side < 0:
            return 0
        side = side or (height > 0) - (height < 0)
    return side

def face_planes(corners):
    """Those of the faces of a tetrahedron."""
    for m in range(4):
        a, b, c = corners[:m] + corners[m + 1:]
        normal = normal_of((a, b, c))
        yield normal, dot(normal, a)

def upright_planes(corners):
    """Those that contain an edge and the normal of a triangle."""
    normal = normal_of(corners)
    for a, b in zip(corners, [*corners[1:], corners[0]]):
        vector = cross(normal, sub(b, a))
        yield vector, dot(vector, a)
