# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Points of a microstructure and of voids in a model (docs/certificates/micro-inside.md, sections 4 and 5): I2 and I3.
All numbers are exact."""
from bisect import bisect_left, bisect_right
from collections import namedtuple
from fractions import Fraction
from itertools import product
from math import inf

from ..common.errors import Reject
from ..points.box_tree import BoxTree
from ..points.points_check import Point
from .micro_cell_map import CellMap
from .micro_slices import are_apart, hull_of, outward
from .micro_tile import is_missed

FREE_OF_TRIANGLE, UNITS_OF_POINT = 100, 1000
FREE_VISITED, VISITED_OF_VOID = 1 << 22, 64
NO_CORNER = 8

# An entry of the body. x: in the parameters of the volume; corner: from 0 to 8.
Void = namedtuple("Void", "volume x corner")

# ---------------------------------------------------------------- points in space

def image(volume, parameters):
    """The point of the volume's map."""
    axes = [span_of(p, knots, t) for p, knots, t in zip(volume.degrees, volume.knots, parameters)]
    points = {at: volume.at(*at) for at in product(*[range(k - p, k + 1) for k, p in zip(axes, volume.degrees)])}
    for axis, (p, knots, t, k) in enumerate(zip(volume.degrees, volume.knots, parameters, axes)):
        lines = {}
        for at in sorted(points):
            lines.setdefault(at[1:], []).append(points[at])
        # The first axis is done and leaves; the next one is the first.
        points = {at: evaluated(p, knots, t, k, line) for at, line in lines.items()}
    x, y, z, w = points[()]
    return x / w, y / w, z / w

def span_of(p, knots, t):
    return bisect_right(knots, t, p, len(knots) - p - 1) - 1

def evaluated(p, knots, t, k, line):
    """De Boor's scheme."""
    for r in range(1, p + 1):
        for j in range(p, r - 1, -1):
            lo, hi = knots[k - p + j], knots[k + 1 + j - r]
            s = (t - lo) / (hi - lo)
            line[j] = [(1 - s) * a + s * b for a, b in zip(line[j - 1], line[j])]
    return line[p]

class OnSurface(Exception):
    """The point lies on the surface of the model, or it is not shown to lie off it."""

class Winding:
    """Winding numbers of a mesh.  tree: of the boxes of its triangles in binary64; shell_of: of each triangle; depths:
    of the shells."""

    def __init__(self, mesh, tree, shell_of, depths):
        self.mesh, self.tree, self.shell_of, self.depths = mesh, tree, shell_of, depths
        self.condition, self.left = None, 0

    def begin(self, condition, num_points):
        """From now on the work counts for this condition."""
        self.condition = condition
        self.left = FREE_OF_TRIANGLE * len(self.mesh.triangles) + UNITS_OF_POINT * num_points

    def at(self, point):
        """(Point, the triangles that it may lie on or that the ray along the first axis may stab)"""
        (x, _, *across), boxes = outward([(c, c) for c in point]), self.tree.boxes
        found = [f for f in self.tree.meeting((x, inf, *across)) if is_unit(boxes[f], *point)]
        self.left -= len(found)
        if self.left < 0:
            raise Reject(self.condition, "the rays pass too many triangles")
        return Point([(c.numerator, c.denominator) for c in point], self.mesh.unit, self.mesh.points,
                     self.mesh.triangles), found

    def around(self, point):
        """The winding number."""
        at, near = self.at(point)
        return at.winding(near, 0)

    def shells_around(self, point):
        """The shells whose winding number is not 0."""
        at, near = self.at(point)
        of_shells = {}
        for f in near:
            if at.is_on(f):
                raise OnSurface("triangle %d" % f)
            of_shells.setdefault(self.shell_of[f], []).append(f)
        return {shell for shell, triangles in of_shells.items() if at.winding(triangles, 0)}

def is_unit(box, x, y, z):
    """Does a triangle with this box count, for the direction 0, in section 5 of points.md?"""
    x0, x1, y0, y1, z0, z1 = box
    return x <= x1 and (y0 <= y < y1 and z0 <= z < z1 or x0 <= x and y0 <= y <= y1 and z0 <= z <= z1)

# ---------------------------------------------------------------- I2

def test_i2(model, tiles, glued, winding):
    """winding: Winding, or that of inside_shells.py."""
    firsts = list(glued.first_patches())
    winding.begin("I2", len(firsts))
    for cell, patch in firsts:
        n = bisect_right(glued.base, cell) - 1
        try:
            number = winding.around(image_of_corner(model, tiles, model.grids[n], cell - glued.base[n], patch))
        except OnSurface as on:
            raise Reject("I2", "a point of a shell may lie on %s" % on) from None
        if number != 1:
            raise Reject("I2", "the winding number around a point of the shell at patch %d of cell %d of grid %d is %d"
                         % (patch, cell - glued.base[n], n, number))

def image_of_corner(model, tiles, grid, cell, patch):
    """The image of S(0, 0)."""
    patch = tiles[grid.cells[cell] - 1].patches[patch]
    point = at_cell(grid, patch, cell)[0]
    ends = [b[i:i + 2] for b, i in zip(grid.breaks, grid.index(cell))]
    return image(model.cage[grid.volume], [lo + (hi - lo) * c for c, (lo, hi) in zip(point, ends)])

def at_cell(grid, patch, cell):
    """The points of a patch, in the unit cube, with the numbers of the cell."""
    return patch.at_number(0 if patch.wall is None else grid.number(cell, patch.wall))


# ---------------------------------------------------------------- I3

class Voids:
    """sweeps: the boxes around them, as those of bridges."""

    def __init__(self, model, tiles, winding):
        self.model, self.tiles, self.winding = model, tiles, winding
        self.visited, self.bridges, self.sweeps = 0, {}, None

    def test(self, entries):
        self.winding.begin("I3", len(entries))
        depths = self.winding.depths
        voids = [shell for shell, depth in enumerate(depths) if depth % 2 == 1]
        if len(voids) != len(entries):
            raise Reject("I3", "%d entries for %d voids" % (len(entries), len(voids)))
        for number, (shell, entry) in enumerate(zip(voids, entries)):
            why = self.why_in_bridge(entry) or self.why_in_tile(entry) or self.why_elsewhere(entry, shell)
            if why:
                raise Reject("I3", "entry %d: %s" % (number, why))
            if self.visited > FREE_VISITED + VISITED_OF_VOID * len(voids):
                raise Reject("I3", "the entries of voids take too much work")

    def why_in_bridge(self, entry):
        knots = self.model.cage[entry.volume].knots
        if not all(t[0] < c < t[-1] for c, t in zip(entry.x, knots)):
            return "the point is not inside of the volume's parameters"
        if entry.volume not in self.bridges:
            hulls = [hull_of(*[[(c, c) for c in point] for point in bridge.points])
                     for bridge in self.model.bridges if bridge.volume == entry.volume]
            self.bridges[entry.volume] = hulls, BoxTree(list(map(outward, hulls))) if hulls else None
        if is_in_one(*self.bridges[entry.volume], entry.x):
            return "the point is in the box of a bridge"

    def why_in_tile(self, entry):
        for grid in self.model.grids:
            if grid.volume == entry.volume:
                near = [cell for cell in cells_at(grid, entry.x) if grid.cells[cell]]
                if near and entry.corner == NO_CORNER:
                    return "the point is in a cell that holds a tile"
                for cell in near:
                    ends = [b[i:i + 2] for b, i in zip(grid.breaks, grid.index(cell))]
                    if all(lo < c < hi for c, (lo, hi) in zip(entry.x, ends)):
                        return self.why_behind(grid, cell, [(c - lo) / (hi - lo) for c, (lo, hi) in zip(entry.x, ends)],
                                               [Fraction(entry.corner >> a & 1) for a in range(3)])
        if entry.corner != NO_CORNER:
            return "the point is in no open cell that holds a tile"

    def why_behind(self, grid, cell, start, end):
        """start, end: in the unit cube."""
        visited = [0]
        for n, patch in enumerate(self.tiles[grid.cells[cell] - 1].patches):
            if not is_missed(at_cell(grid, patch, cell), patch.degrees, start, end, visited):
                return "patch %d may meet the box of the point and the corner" % n
        self.visited += visited[0]

    def why_elsewhere(self, entry, shell):
        point = image(self.model.cage[entry.volume], entry.x)
        if self.model.sweeps:
            if self.sweeps is None:
                hulls = [box_around(self.model, self.tiles, sweep) for sweep in self.model.sweeps]
                self.sweeps = hulls, BoxTree(list(map(outward, hulls)))
            if is_in_one(*self.sweeps, point):
                return "the point is in the box of a sweep"
        try:
            inside = self.winding.shells_around(point)
        except OnSurface as on:
            return "the point is on %s" % on
        if shell not in inside or len(inside) != self.winding.depths[shell] + 1:
            return "the point is inside of %d shells of the model%s" % (
                len(inside), "" if shell in inside else ", and not of the void")

def is_in_one(boxes, tree, point):
    at = [(c, c) for c in point]
    return bool(boxes) and not all(are_apart(boxes[n], at) for n in tree.meeting(outward(at)))

def box_around(model, tiles, sweep):
    """The least closed box around the points of a sweep."""
    grid = model.grids[sweep.grid]
    tile = tiles[grid.cells[sweep.cell] - 1]
    cap = at_cell(grid, tile.patches[min(tile.in_wall[sweep.wall])], sweep.cell)
    ends = [(min(column), max(column)) for column in zip(*cap)]
    points = CellMap(grid, sweep.cell, model.cage[grid.volume]).points_on(ends)
    boxes = [[(c, c) for c in point] for point in points]
    return [(lo + min(0, e, f), hi + max(0, e, f)) for (lo, hi), e, f in zip(hull_of(*boxes), *sweep.axis)]

def cells_at(grid, point):
    """The closed cells that contain the point."""
    ranges = []
    for breaks, c in zip(grid.breaks, point):
        ranges.append(range(max(0, bisect_left(breaks, c) - 1), min(len(breaks) - 1, bisect_right(breaks, c))))
    for i, j, k in product(*ranges):
        yield (i * grid.counts[1] + j) * grid.counts[2] + k
