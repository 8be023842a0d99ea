# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Maps of two or three parameters as files hold them: control points with the first axis fastest."""
from math import prod

from .star_box_read import Entity

class Volume:
    """points: homogeneous, (x, y, z, w), the first axis fastest; sizes: their numbers along the axes."""
    kind = "volume"

    def __init__(self, degrees, knots, rational, dimension, points):
        self.degrees, self.knots, self.rational, self.dimension = tuple(degrees), knots, rational, dimension
        self.sizes, self.points = sizes_of(self.degrees, knots), points

    def strides(self):
        return 1, self.sizes[0], self.sizes[0] * self.sizes[1]

    def at(self, *index):
        return self.points[sum(i * stride for i, stride in zip(index, self.strides()))]

def sizes_of(degrees, knots):
    return [len(t) - p - 1 for p, t in zip(degrees, knots)]

def map_of(degrees, knots, rational, dimension, points):
    """A surface or a volume. points: as in Volume."""
    if len(degrees) == 3:
        return Volume(degrees, knots, rational, dimension, points)
    surface = Entity("surface")
    surface.degrees, surface.knots, surface.rational, surface.dimension = tuple(degrees), knots, rational, dimension
    m, n = sizes_of(degrees, knots)
    surface.rows = [[points[i + m * j] for j in range(n)] for i in range(m)]
    return surface

def last_axis_first(points, sizes):
    """Points with the last axis fastest, reordered so that the first one is."""
    (l, m, n), result = sizes, []
    for k in range(n):
        for j in range(m):
            result += points[j * n + k:prod(sizes):m * n]
    return result
