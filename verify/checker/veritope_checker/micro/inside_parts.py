# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The parts of a microstructure and their nodes, with points in space, in binary64 with bounds for all errors
(docs/certificates/micro-inside.md, section 3, and microstructure.md, section 7b)."""
from functools import lru_cache
from math import inf

from .inside_blocks import Block, Blocks, size_of
from .inside_nodes import TINY, ULP, nearest, node_of
from .inside_space import MAX_COORDINATE, Space

KEPT = 1 << 12                                              # nodes of patches with numbers
KEPT_CELLS, KEPT_LEVELS = 16, 6                             # cells with their nodes; levels of a part

class Parts:
    """model: Microstructure; tiles: of micro_tile.py.  count: of the parts."""

    def __init__(self, model, tiles):
        self.model, self.tiles = model, tiles
        self.space_of = lru_cache(None)(lambda volume: Space(model.cage[volume]))
        self.blocks_of = lru_cache(None)(lambda n: Blocks(n, model.grids[n], self.space_of(model.grids[n].volume)))
        self.node_of_patch = lru_cache(KEPT)(self.node_of_patch)
        self.of_cell = lru_cache(KEPT_CELLS)(self.of_cell)
        cells = b"".join(grid.cells for grid in model.grids)
        self.count = sum(len(tile.patches) * cells.count(n + 1) for n, tile in enumerate(tiles))
        self.count += len(model.bridges) + len(model.sweeps)

    def node_of_patch(self, tile, n, number):
        patch = self.tiles[tile].patches[n]
        return node_of(patch.at_number(number), [d + 1 for d in patch.degrees])

    def in_cell(self, grid, cell, n):
        """The node in the unit cube of patch n of the tile in the cell."""
        wall = self.tiles[grid.cells[cell] - 1].patches[n].wall
        return self.node_of_patch(grid.cells[cell] - 1, n, 0 if wall is None else grid.number(cell, wall))

    def of_cell(self, number, cell):
        """The nodes of the patches of the tile in a cell."""
        grid, frame = self.model.grids[number], self.blocks_of(number).frame(cell)
        count = len(self.tiles[grid.cells[cell] - 1].patches)
        return [PatchNode(frame, self.in_cell(grid, cell, n)) for n in range(count)]

    def cap(self, sweep):
        """(frame of its cell, node of its cap in the unit cube).  Q1 holds, or it is not tested."""
        grid = self.model.grids[sweep.grid]
        in_wall = self.tiles[grid.cells[sweep.cell] - 1].in_wall[sweep.wall]
        return self.blocks_of(sweep.grid).frame(sweep.cell), self.in_cell(grid, sweep.cell, min(in_wall, default=0))

    def of_sweep(self, sweep):
        return SweepNode(*self.cap(sweep), Curve(*sweep.axis))

    def of_bridge(self, bridge):
        space = self.space_of(bridge.volume)
        return BridgeNode(space, node_of(in_unit(space, bridge.points), [*[d + 1 for d in bridge.degrees], 3]))

    def ends(self):
        """(what it is, node of its end face) for each bridge and each sweep."""
        for n, bridge in enumerate(self.model.bridges):
            space = self.space_of(bridge.volume)
            node = node_of(in_unit(space, bridge.of_list(2)), [d + 1 for d in bridge.degrees])
            yield "bridge %d" % n, BridgeNode(space, node)
        for n, sweep in enumerate(self.model.sweeps):
            yield "sweep %d" % n, EndNode(*self.cap(sweep), Curve(*sweep.axis))

def in_unit(space, points):
    return [[space.in_unit(axis, c) for axis, c in enumerate(point)] for point in points]

def halves_of(x, parts):
    """The halves of a node; of a single cell the nodes of its patches."""
    if type(x) is Block and x.cell is not None:
        return parts.of_cell(x.blocks.number, x.cell)
    return x.halves()

class PartNode:
    """A node of a part.  points: a list for each box of parameters; box: of them all; size: its greatest side."""

    def __init__(self, level, points):
        self.level, self.points, self.kids = level, points, None
        self.box = points[0].box if len(points) == 1 else tuple(
            f(p.box[n] for p in points) for n, f in enumerate((min, max) * 3))
        self.size = size_of(self.box)

    def pieces(self):
        return self.points

    def halves(self):
        """Two nodes; they are kept if the level is low."""
        kids = self.kids or self.made_halves()
        self.kids = kids if self.level < KEPT_LEVELS else None
        return kids

class PatchNode(PartNode):
    """A node of a patch in a cell.  node: in the unit cube."""

    def __init__(self, frame, node):
        self.frame, self.node = frame, node
        super().__init__(node.level, [frame.points(node.box)])

    def made_halves(self):
        return [PatchNode(self.frame, node) for node in self.node.halves()]

class BridgeNode(PartNode):
    """A node of a bridge, or of its end face.  node: in the volume's parameters, brought to [0, 1]."""

    def __init__(self, space, node):
        self.space, self.node = space, node
        super().__init__(node.level, list(space.parts(node.box)))

    def made_halves(self):
        return [BridgeNode(self.space, node) for node in self.node.halves()]


# ---------------------------------------------------------------- sweeps

class Curve:
    """2 w (1 - w) e + w^2 f.  Its points are within `error`."""

    def __init__(self, e, f):
        self.e, self.f = [[nearest(c) for c in vector] for vector in (e, f)]
        greatest = max(map(abs, self.e + self.f))
        self.error = 16 * ULP * greatest + TINY if greatest < MAX_COORDINATE else inf
        if self.error == inf:
            self.e = self.f = [0.] * 3

    def at(self, a, b):
        """The blossom: the coefficient 1 on [a, b] if both differ."""
        s, t = a * (1 - b) + b * (1 - a), a * b
        return [s * x + t * y for x, y in zip(self.e, self.f)]

class Sums:
    """The sums of Points and the three of a curve: what Points can do, but for the list."""

    def __init__(self, points, steps, error):
        self.points, self.steps, self.error = points, steps, points.error + error
        pad = error + 4 * ULP * max(map(abs, [*points.box, *sum(steps, [])]))
        self.box = tuple(f(step[n // 2] for step in steps) + c + (pad if n % 2 else -pad)
                         for n, (c, f) in enumerate(zip(points.box, (min, max) * 3)))

    def extent(self, x, y, z):
        lo, hi = self.points.extent(x, y, z)
        values = [x * p + y * q + z * r for p, q, r in self.steps]
        return lo + min(values), hi + max(values)

    def slack(self, greatest=0.):
        limit = max([greatest, *map(abs, self.box), *[abs(c) for step in self.steps for c in step]])
        return 3 * self.error + 128 * ULP * limit + TINY if limit < MAX_COORDINATE else inf

class SweepNode(PartNode):
    """node: of the cap, in the unit cube; lo, hi: the interval of w."""

    def __init__(self, frame, node, curve, lo=0., hi=1., level=0):
        self.frame, self.node, self.curve, self.lo, self.hi = frame, node, curve, lo, hi
        steps = [curve.at(lo, lo), curve.at(lo, hi), curve.at(hi, hi)]
        super().__init__(level, [Sums(frame.points(node.box), steps, curve.error)])

    def made_halves(self):
        if self.level % 3 < 2:
            both = [(node, self.lo, self.hi) for node in self.node.halves()]
        else:
            middle = (self.lo + self.hi) / 2
            both = (self.node, self.lo, middle), (self.node, middle, self.hi)
        return [SweepNode(self.frame, node, self.curve, lo, hi, self.level + 1) for node, lo, hi in both]

class EndNode(PartNode):
    """A node of the end face of a sweep."""

    def __init__(self, frame, node, curve):
        self.frame, self.node, self.curve = frame, node, curve
        super().__init__(node.level, [frame.points(node.box).moved(*curve.f, curve.error)])

    def made_halves(self):
        return [EndNode(self.frame, node, self.curve) for node in self.node.halves()]
