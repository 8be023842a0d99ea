# SPDX-License-Identifier: Apache-2.0 OR MIT
"""How the surface of a microstructure lies near a mesh (docs/certificates/micro-inside.md, sections 3 and 6): I1 and
I4."""
from fractions import Fraction
from itertools import islice
from math import nextafter

from ..common.errors import Reject
from .inside_nodes import nearest

MAX_LEVEL, FREE_NODES, NODES_OF_PART, MAX_PAIRS = 60, 1 << 22, 64, 1 << 30
MAX_SKIN_LEVEL, MAX_SKIN_NODES, SKIN_NODES_OF_BRIDGE = 24, 4096, 256
LONG = 64                                                   # a list of triangles that is worth a search in the tree

class Surface:
    """Counts nodes and pairs. parts: Parts; triangles: Triangles."""

    def __init__(self, parts, triangles):
        self.parts, self.model, self.triangles = parts, parts.model, triangles
        self.nodes = self.pairs = 0
        self.most_nodes = FREE_NODES + NODES_OF_PART * parts.count

    def see(self, condition, nodes, pairs):
        self.nodes += nodes
        self.pairs += pairs
        if self.nodes > self.most_nodes or self.pairs + self.triangles.met > MAX_PAIRS:
            raise Reject(condition, "too many nodes, or nodes near too many triangles")

    # ------------------------------------------------------------ I1

    def test_i1(self):
        for n, grid in enumerate(self.model.grids):
            for cell, near in self.cells_near(n):
                for patch, node in enumerate(self.parts.of_cell(n, cell)):
                    if not self.is_off(node, near):
                        raise Reject("I1", "patch %d of the tile in cell %d of a grid in volume %d may meet the mesh"
                                     % (patch, cell, grid.volume))
        for n, bridge in enumerate(self.model.bridges):
            if not self.is_off(self.parts.of_bridge(bridge), None):
                raise Reject("I1", "bridge %d may meet the mesh" % n)
        for n, sweep in enumerate(self.model.sweeps):
            if not self.is_off(self.parts.of_sweep(sweep), None):
                raise Reject("I1", "sweep %d may meet the mesh" % n)

    def cells_near(self, number):
        """(cell, triangles that may meet it) for each cell of a grid that holds a tile and is not passed over."""
        todo = [self.parts.blocks_of(number).whole()] if any(self.model.grids[number].cells) else []
        while todo:
            block = todo.pop()
            near = None
            for points in block.pieces():
                near = self.near(points, block.cell is not None)
            if near or near is None:
                if block.cell is not None:
                    yield block.cell, near
                else:
                    todo += block.halves()

    def near(self, points, all_of_them):
        """The triangles that may meet the points, or just one of them."""
        found = self.triangles.tree.meeting(points.box)
        return self.triangles.not_apart(points, found) if all_of_them else list(islice(found, 1))

    def is_off(self, node, near):
        """Does the descent end?  near: the triangles that may meet the node; None for all."""
        todo = [(node, near)]
        while todo:
            node, near = todo.pop()
            found = []
            for points in node.pieces():
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
        """skin: a fraction."""
        self.nodes = self.pairs = self.triangles.met = 0
        self.most_nodes = FREE_NODES + SKIN_NODES_OF_BRIDGE * (len(self.model.bridges) + len(self.model.sweeps))
        distance = nextafter(nearest(skin), 0)
        test_ends(self.parts, Fraction(skin), lambda points: self.is_within(points, distance))

    def is_within(self, points, distance):
        found, count = self.triangles.within(points, distance)
        self.see("I4", 1, count)
        return found

def test_ends(parts, skin, is_within):
    """I4, if is_within(points) says whether they may be dropped."""
    for name, node in parts.ends():
        todo, visited = [node], 0
        while todo:
            node, visited = todo.pop(), visited + 1
            if visited > MAX_SKIN_NODES:
                raise Reject("I4", "the end of %s takes too many nodes" % name)
            if not all(map(is_within, node.pieces())):
                if node.level == MAX_SKIN_LEVEL:
                    raise Reject("I4", "the end of %s may be farther than %s from the model" % (name, skin))
                todo += node.halves()
