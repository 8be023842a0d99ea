# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Blocks of the cells of a grid, with the points of the volume's map on them (docs/certificates/micro-inside.md,
section 3)."""
from bisect import bisect_right
from functools import lru_cache
from itertools import product

from .inside_space import PAD

KEPT = 1 << 12                                              # points of blocks

class Frame:
    """A cell. key: (number of the grid, cell); place: where its parameters are, for each axis (begin, length)."""

    def __init__(self, space, span, place, key):
        self.space, self.span, self.place, self.key = space, span, place, key

    def points(self, box):
        """The Points of a box in the unit cube."""
        x0, x1, y0, y1, z0, z1 = box
        (a, s), (b, t), (c, r) = self.place
        return self.space.on_span(self.span, (a + s * x0 - PAD, a + s * x1 + PAD, b + t * y0 - PAD, b + t * y1 + PAD,
                                              c + r * z0 - PAD, c + r * z1 + PAD))

class Blocks:
    """number: of the grid."""

    def __init__(self, number, grid, space):
        self.number, self.grid, self.space = number, grid, space
        self.places = [[space.in_unit(axis, t) for t in b] for axis, b in enumerate(grid.breaks)]
        self.rounded = [list(map(float, places)) for places in self.places]
        knots = [[space.in_unit(axis, t) for t in space.knots[axis]] for axis in range(3)]
        self.spans = [[bisect_right(knots[axis], t) - 1 for t in self.places[axis][:-1]] for axis in range(3)]
        self.points = lru_cache(KEPT)(self.points)

    def whole(self):
        return Block(self, tuple((0, n) for n in self.grid.counts))

    def points(self, ends, span):
        box = [place + sign * PAD for places, pair in zip(self.rounded, ends)
               for place, sign in zip((places[pair[0]], places[pair[1]]), (-1, 1))]
        return self.space.on_span(span, box)

    def holds_tile(self, ends):
        (i0, i1), (j0, j1), (k0, k1) = ends
        _, n, m = self.grid.counts
        if (k0, k1) == (0, m):                              # rows follow each other
            rows = (self.grid.cells[(i * n + j0) * m:(i * n + j1) * m] for i in range(i0, i1))
        else:
            rows = (self.grid.cells[(i * n + j) * m + k0:(i * n + j) * m + k1]
                    for i, j in product(range(i0, i1), range(j0, j1)))
        return any(row.count(0) != len(row) for row in rows)

    def frame(self, cell):
        index = self.grid.index(cell)
        place = [(float(p[n]), float(p[n + 1] - p[n])) for p, n in zip(self.places, index)]
        return Frame(self.space, tuple(spans[n] for spans, n in zip(self.spans, index)), place, (self.number, cell))

class Block:
    """Cells of a grid: a range for each axis.  span: the only one in which they lie, or None; cell: the number of the
    only cell, or None; box: of what the map may be; size: its greatest side."""
    level = -1                                              # it is no node

    def __init__(self, blocks, ends):
        self.blocks, self.ends, self.parts = blocks, ends, None
        self.spans = [(spans[lo], spans[hi - 1]) for spans, (lo, hi) in zip(blocks.spans, ends)]
        self.span = tuple(a for a, _ in self.spans) if all(a == b for a, b in self.spans) else None
        self.cell = None
        if all(hi - lo == 1 for lo, hi in ends):
            _, n, m = blocks.grid.counts
            (i, _), (j, _), (k, _) = ends
            self.cell = (i * n + j) * m + k
        self.box = blocks.space.hull(self.spans) if self.span is None else self.points().box
        self.size = size_of(self.box)

    def points(self):
        """Needs a span."""
        return self.blocks.points(self.ends, self.span)

    def pieces(self):
        """The points of the map, or none if there is no span."""
        return [self.points()] if self.span else ()

    def halves(self):
        """The parts that hold a tile, at most two: cut at a knot if there is one inside, else in the middle of the
        longest axis. They are kept."""
        if self.parts is None:
            ends, spans = self.ends, self.spans
            axis = max(range(3), key=lambda a: (spans[a][0] != spans[a][1], ends[a][1] - ends[a][0]))
            (lo, hi), numbers = ends[axis], self.blocks.spans[axis]
            at_knots = [n for n in range(lo + 1, hi) if numbers[n] != numbers[n - 1]]
            middle = at_knots[len(at_knots) // 2] if at_knots else (lo + hi) // 2
            both = [ends[:axis] + (part,) + ends[axis + 1:] for part in ((lo, middle), (middle, hi))]
            self.parts = [Block(self.blocks, part) for part in both if self.blocks.holds_tile(part)]
        return self.parts

def size_of(box):
    a, b, c, d, e, f = box
    return max(b - a, d - c, f - e)
