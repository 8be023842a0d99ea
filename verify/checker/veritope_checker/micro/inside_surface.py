# SPDX-License-Identifier: Apache-2.0 OR MIT
"""How the surface of a microstructure lies near a mesh (docs/certificates/micro-inside.md, sections 3 and 6): I1 and
I4."""
from bisect import bisect_right
from functools import lru_cache
from itertools import islice, product
from math import inf, nextafter

from ..common.errors import Reject
from .inside_nodes import node_of
from .inside_space import PAD, Space

MAX_LEVEL, FREE_NODES, NODES_OF_PART, MAX_PAIRS = 60, 1 << 22, 64, 1 << 30
MAX_SKIN_LEVEL, MAX_SKIN_NODES, SKIN_NODES_OF_BRIDGE = 24, 4096, 256
KEPT = 1 << 12                                              # nodes of patches with numbers
LONG = 64                                                   # a list of triangles that is worth a search in the tree

class Surface:
    """Counts nodes and pairs. model: Microstructure; tiles: of micro_tile.py; triangles: Triangles."""

    def __init__(self, model, tiles, triangles):
        self.model, self.tiles, self.triangles = model, tiles, triangles
        self.space_of = lru_cache(None)(lambda volume: Space(model.cage[volume]))
        self.node_of_patch = lru_cache(KEPT)(self.node_of_patch)
        self.nodes = self.pairs = 0
        cells = b"".join(grid.cells for grid in model.grids)
        parts = sum(len(tile.patches) * cells.count(n + 1) for n, tile in enumerate(tiles)) + len(model.bridges)
        self.most_nodes = FREE_NODES + NODES_OF_PART * parts

    def see(self, condition, nodes, pairs):
        self.nodes += nodes
        self.pairs += pairs
        if self.nodes > self.most_nodes or self.pairs + self.triangles.met > MAX_PAIRS:
            raise Reject(condition, "too many nodes, or nodes near too many triangles")

    def node_of_patch(self, tile, n, number):
        patch = self.tiles[tile].patches[n]
        return node_of(patch.at_number(number), [d + 1 for d in patch.degrees])

    # ------------------------------------------------------------ I1

    def test_i1(self):
        for grid in self.model.grids:
            for cell, span, place, near in Blocks(grid, self.space_of(grid.volume), self.triangles).cells_near():
                self.test_cell(grid, cell, span, place, near)
        for n, bridge in enumerate(self.model.bridges):
            space = self.space_of(bridge.volume)
            node = node_of(in_unit(space, bridge.points), [*[d + 1 for d in bridge.degrees], 3])
            if not self.is_off(node, space.parts, None):
                raise Reject("I1", "bridge %d may meet the mesh" % n)

    def test_cell(self, grid, cell, span, place, near):
        """place: where the cell's parameters are, for each axis (begin, length)."""
        space, (tile, (a, s), (b, t), (c, r)) = self.space_of(grid.volume), (grid.cells[cell] - 1, *place)

        def parts(box):
            x0, x1, y0, y1, z0, z1 = box
            yield space.on_span(span, (a + s * x0 - PAD, a + s * x1 + PAD, b + t * y0 - PAD, b + t * y1 + PAD,
                                       c + r * z0 - PAD, c + r * z1 + PAD))

        for n, patch in enumerate(self.tiles[tile].patches):
            number = 0 if patch.wall is None else grid.number(cell, patch.wall)
            if not self.is_off(self.node_of_patch(tile, n, number), parts, near):
                raise Reject("I1", "patch %d of the tile in cell %d of a grid in volume %d may meet the mesh" % (
                    n, cell, grid.volume))

    def is_off(self, node, parts, near):
        """Does the descent end?  parts: of the box of a node, Points each; near: the triangles that may meet the node;
        None for all."""
        todo = [(node, near)]
        while todo:
            node, near = todo.pop()
            found = []
            for points in parts(node.box):
                self.see("I1", 1, 0)
                is_long = near is None or len(near) > LONG
                some = self.triangles.tree.meeting(points.box) if is_long else near
                found += self.triangles.not_apart(points, some)
            if found:
                if node.level == MAX_LEVEL:
                    return False
                found = list(dict.fromkeys(found))
                todo += [(kid, found) for kid in node.halves()]
        return True

    # ------------------------------------------------------------ I4

    def test_i4(self, skin):
        self.nodes = self.pairs = self.triangles.met = 0
        self.most_nodes = FREE_NODES + SKIN_NODES_OF_BRIDGE * len(self.model.bridges)
        distance = nextafter(to_float(skin), 0)
        for n, bridge in enumerate(self.model.bridges):
            space = self.space_of(bridge.volume)
            node = node_of(in_unit(space, bridge.of_list(2)), [d + 1 for d in bridge.degrees])
            if not self.is_near(node, space, distance):
                raise Reject("I4", "the end of bridge %d may be farther than %s from the mesh" % (n, skin))

    def is_near(self, node, space, distance):
        todo, visited = [node], 0
        while todo:
            node, visited = todo.pop(), visited + 1
            if visited > MAX_SKIN_NODES:
                return False
            for points in space.parts(node.box):
                found, count = self.triangles.within(points, distance)
                self.see("I4", 1, count)
                if not found:
                    if node.level == MAX_SKIN_LEVEL:
                        return False
                    todo += node.halves()
                    break
        return True

def in_unit(space, points):
    return [[space.in_unit(axis, c) for axis, c in enumerate(point)] for point in points]

def to_float(value):
    try:
        return float(value)
    except OverflowError:
        return inf


# ---------------------------------------------------------------- blocks of cells

class Blocks:
    """Passes over blocks of cells that are apart from all triangles."""

    def __init__(self, grid, space, triangles):
        self.grid, self.space, self.triangles = grid, space, triangles
        self.places = [[space.in_unit(axis, t) for t in b] for axis, b in enumerate(grid.breaks)]
        self.rounded = [list(map(float, places)) for places in self.places]
        knots = [[space.in_unit(axis, t) for t in space.knots[axis]] for axis in range(3)]
        self.spans = [[bisect_right(knots[axis], t) - 1 for t in self.places[axis][:-1]] for axis in range(3)]

    def cells_near(self):
        """(cell, its span, its place, triangles that may meet it) for each cell that holds a tile and is not passed
        over."""
        todo = [tuple((0, n) for n in self.grid.counts)]
        while todo:
            block = todo.pop()
            if not self.holds_tile(block):
                continue
            ends = [(spans[lo], spans[hi - 1]) for spans, (lo, hi) in zip(self.spans, block)]
            near = None
            if all(a == b for a, b in ends):
                span = tuple(a for a, _ in ends)
                points = self.space.on_span(span, self.box_of(block))
                near = self.near(points, all(hi - lo == 1 for lo, hi in block))
                if not near:
                    continue
            if all(hi - lo == 1 for lo, hi in block):
                (i, _), (j, _), (k, _) = block
                cell = (i * self.grid.counts[1] + j) * self.grid.counts[2] + k
                place = [(float(p[n]), float(p[n + 1] - p[n])) for p, (n, _) in zip(self.places, block)]
                yield cell, span, place, near
            else:
                todo += self.parts_of(block, ends)

    def near(self, points, all_of_them):
        """The triangles that may meet the points, or just one of them."""
        found = self.triangles.tree.meeting(points.box)
        return self.triangles.not_apart(points, found) if all_of_them else list(islice(found, 1))

    def box_of(self, block):
        return [place + sign * PAD for places, ends in zip(self.rounded, block)
                for place, sign in zip((places[ends[0]], places[ends[1]]), (-1, 1))]

    def holds_tile(self, block):
        (i0, i1), (j0, j1), (k0, k1) = block
        _, n, m = self.grid.counts
        if (k0, k1) == (0, m):                              # rows follow each other
            rows = (self.grid.cells[(i * n + j0) * m:(i * n + j1) * m] for i in range(i0, i1))
        else:
            rows = (self.grid.cells[(i * n + j) * m + k0:(i * n + j) * m + k1]
                    for i, j in product(range(i0, i1), range(j0, j1)))
        return any(row.count(0) != len(row) for row in rows)

    def parts_of(self, block, ends):
        """Two parts: at a knot if there is one inside, else at the middle of the longest axis."""
        axis = max(range(3), key=lambda a: (ends[a][0] != ends[a][1], block[a][1] - block[a][0]))
        (lo, hi), spans = block[axis], self.spans[axis]
        at_knots = [n for n in range(lo + 1, hi) if spans[n] != spans[n - 1]]
        middle = at_knots[len(at_knots) // 2] if at_knots else (lo + hi) // 2
        return [block[:axis] + (part,) + block[axis + 1:] for part in ((lo, middle), (middle, hi))]
