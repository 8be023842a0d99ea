# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Bridges (docs/certificates/microstructure.md, section 7): their order, R1 and R2; micro_slices.py has R3 and R4."""
from fractions import Fraction

from ..common.errors import Reject
from ..common.vectors import cross, dot
from ..patches.model_powers import scaled
from ..vmodel.vmodel_pieces import OTHERS
from .micro_caps import OWN
from .micro_polynomials import map_key, split
from .micro_slices import Slices
from .micro_walls import face_of_wall

def test_bridges(model, hints, tiles, codes, glued, skip):
    """glued: of micro_numbers.py."""
    sides, slices = OtherSides(model, codes), Slices(model)

    def tested(condition, test, *arguments):
        if condition not in skip:
            try:
                test(*arguments)
            except Reject as rejection:
                raise Reject(condition, "bridge %d: %s" % (number, rejection.why)) from None

    for number, (bridge, hint) in enumerate(zip(model.bridges, hints)):
        side = sides.of(bridge)
        tested("R1", test_r1, bridge, hint.matrix)
        tested("R2", test_r2, bridge, side, model, tiles, glued)
        slices.add(bridge, hint.cuts)
        tested("R3", slices.test_r3, bridge, side)
    if "R4" not in skip:
        slices.test_r4()


# ---------------------------------------------------------------- R1

def test_r1(bridge, matrix):
    rows = split(scaled(sum(matrix, []))[0], 3)
    if dot(rows[0], cross(rows[1], rows[2])) <= 0:
        raise Reject("R1", "det K is not positive")
    for columns in derivatives(bridge):
        if not is_positive([[dot(row, column) for column in columns] for row in rows]):
            raise Reject("R1", "a matrix K J + (K J)^T is not positive definite")

def derivatives(bridge):
    """The Bernstein coefficients of (b_u, b_v, b_w) in the degrees of b, times one factor > 0."""
    degrees = (*bridge.degrees, 2)
    points = split(scaled(sum(bridge.points, []))[0], 3)
    strides = (3 * degrees[1] + 3, 3, 1)
    for n in range(len(points)):
        columns = []
        for stride, degree in zip(strides, degrees):
            i = n // stride % (degree + 1)                  # i (b_i - b_(i-1)) + (degree - i) (b_(i+1) - b_i)
            before, after = points[n - stride if i else n], points[n + stride if i < degree else n]
            columns.append([i * (y - x) + (degree - i) * (z - y) for x, y, z in zip(before, points[n], after)])
        yield columns

def is_positive(m):
    """Is m + its transpose positive definite?"""
    a, d, f = 2 * m[0][0], 2 * m[1][1], 2 * m[2][2]
    b, c, e = m[0][1] + m[1][0], m[0][2] + m[2][0], m[1][2] + m[2][1]
    minor = a * d - b * b
    return a > 0 and minor > 0 and minor * f + 2 * b * c * e - a * e * e - d * c * c > 0


# ---------------------------------------------------------------- the other side

class OtherSide:
    """volume: its number; axis, at: the plane of the wall there; beyond: 1 if what is beyond has greater parameters, -1
    if less; in_face: whether the wall lies in a face; place: brings parameters in the wall to those of this side."""

    def __init__(self, volume, axis, at, beyond, in_face, place):
        self.volume, self.axis, self.at, self.beyond, self.in_face = volume, axis, at, beyond, in_face
        self.place = place

class OtherSides:
    def __init__(self, model, codes):
        self.model, self.glued = model, {}                  # {face: (other face, map of its parameters)}
        for f, code in enumerate(codes):
            if type(code) is tuple:
                g, symmetry = code
                self.glued[f] = g, lambda x, y, s=symmetry: flipped(*exchanged(x, y, s), s)
                self.glued[g] = f, lambda x, y, s=symmetry: exchanged(*flipped(x, y, s), s)

    def of(self, bridge):
        """The other side, or None if the wall lies in a face that is not glued."""
        grid = self.model.grids[bridge.grid]
        axis, end, index = bridge.wall // 2, bridge.wall % 2, grid.index(bridge.cell)
        at = grid.breaks[axis][index[axis] + end]
        face = face_of_wall(grid, bridge.cell, bridge.wall, self.model.cage)
        if face is None:
            def place(x, y):
                return with_coordinate(axis, at, x, y)
            return OtherSide(grid.volume, axis, at, 1 if end else -1, False, place)
        if face not in self.glued:
            return None
        other, along = self.glued[face]
        knots, theirs = self.model.cage[grid.volume].knots, self.model.cage[other // 6].knots
        axis, end = other % 6 // 2, other % 2
        at = theirs[axis][-end]

        def across(x, y):
            x, y = along(*[part(t, knots[a]) for t, a in zip((x, y), OTHERS[bridge.wall // 2])])
            return with_coordinate(axis, at, *[in_domain(t, theirs[a]) for t, a in zip((x, y), OTHERS[axis])])
        return OtherSide(other // 6, axis, at, -1 if end else 1, True, across)

def exchanged(x, y, symmetry):
    return (y, x) if symmetry & 1 else (x, y)

def flipped(x, y, symmetry):
    return 1 - x if symmetry & 2 else x, 1 - y if symmetry & 4 else y

def part(t, knots):
    return (t - knots[0]) / (knots[-1] - knots[0])

def in_domain(t, knots):
    return knots[0] + (knots[-1] - knots[0]) * t

def with_coordinate(axis, value, x, y):
    point = [x, y]
    point.insert(axis, value)
    return point


# ---------------------------------------------------------------- R2

def test_r2(bridge, side, model, tiles, glued):
    if side is None or bridge.volume != side.volume:
        raise Reject("R2", "its volume is not that on the other side of the wall")
    grid = model.grids[bridge.grid]
    tile = tiles[grid.cells[bridge.cell] - 1]
    caps = [n for n, (wall, _) in enumerate(tile.caps) if wall == bridge.wall]
    if len(caps) != 1 or len(tile.caps[caps[0]][1]) != 1:
        raise Reject("R2", "the wall has not one cap of one patch")
    if glued.masks[glued.base[bridge.grid] + bridge.cell] >> caps[0] & 1:
        raise Reject("R2", "its cap is equal to another one")
    patch = tile.patches[tile.caps[caps[0]][1][0]]
    cap, first = cap_points(grid, bridge, patch, side), bridge.of_list(0)
    if cap != first and key_of(cap, patch.degrees) != key_of(first, bridge.degrees):
        raise Reject("R2", "its list 0 is not the cap")

def cap_points(grid, bridge, patch, side):
    """The control points of the cap, in the parameters of the other side."""
    points = patch.at_number(0 if patch.wall is None else grid.number(bridge.cell, patch.wall))
    index, axes = grid.index(bridge.cell), OTHERS[bridge.wall // 2]
    ends = [grid.breaks[a][index[a]:index[a] + 2] for a in axes]
    return [side.place(*[lo + (hi - lo) * point[a] for a, (lo, hi) in zip(axes, ends)]) for point in points]

def key_of(points, degrees):
    numbers, common = scaled([Fraction(c) for point in points for c in point])
    return map_key(OWN, [split(numbers, 3)], common, degrees)
