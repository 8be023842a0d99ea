# SPDX-License-Identifier: Apache-2.0 OR MIT
"""What sweeps meet (docs/certificates/microstructure.md, section 7b): Q3 and Q4, in binary64 with bounds for all
errors."""
from functools import lru_cache
from math import inf, nextafter

from ..common.errors import Reject
from ..points.box_tree import BoxTree
from .inside_pairs import descends, part_along
from .inside_parts import PatchNode

MAX_LEVEL, FREE_PAIRS, PAIRS_OF_SWEEP = 40, 1 << 22, 1 << 12
KEPT = 1 << 10                                              # whole sweeps, and the rows of their matrices

class SweepPairs:
    """parts: Parts; hints: of micro_body.py."""

    def __init__(self, parts, hints):
        self.parts, self.sweeps, self.hints = parts, parts.model.sweeps, hints
        self.left = FREE_PAIRS + PAIRS_OF_SWEEP * len(self.sweeps)
        self.whole, self.rows_of = lru_cache(KEPT)(self.whole), lru_cache(KEPT)(self.rows_of)
        self.grids = [parts.blocks_of(n).whole() if any(grid.cells) else None
                      for n, grid in enumerate(parts.model.grids)]
        self.held = [n for n, whole in enumerate(self.grids) if whole]
        self.tree = BoxTree([self.grids[n].box for n in self.held])

    def whole(self, number):
        return self.parts.of_sweep(self.sweeps[number])

    def rows_of(self, number):
        """The rows of K, divided by their greatest components."""
        return [[float(c / max(map(abs, row))) for c in row] for row in self.hints[number].matrix if any(row)]

    def counts(self, condition):
        def see(_):
            self.left -= 1
            if self.left < 0:
                raise Reject(condition, "too many pairs of nodes whose boxes meet")
        return see

    def test_q3(self, number):
        node, sweep, vectors = self.whole(number), self.sweeps[number], self.rows_of(number)
        is_in_slab = self.slab_of(number)

        def are_apart(x, y):
            if type(x) is PatchNode and x.frame.key == (sweep.grid, sweep.cell) and is_in_slab(x.node.box):
                return True
            return any(part_along(vectors, points, y.points[0]) for points in x.pieces())

        for n in self.tree.meeting(node.box):
            whole = self.grids[self.held[n]]
            if not descends(whole, node, self.parts, MAX_LEVEL, self.counts("Q3"), are_apart):
                raise Reject("Q3", "it may meet a tile in grid %d" % self.held[n])
        node.kids = None

    def slab_of(self, number):
        """The function that says of a box in the unit cube of the cell whether it lies in the slab."""
        axis, end, depth = self.sweeps[number].wall // 2, self.sweeps[number].wall % 2, self.hints[number].depth
        if depth == 1:
            return lambda box: True
        if end:
            least = nextafter(float(1 - depth), inf)
            return lambda box: box[2 * axis] >= least
        greatest = nextafter(float(depth), -inf)
        return lambda box: box[2 * axis + 1] <= greatest

    def test_q4(self):
        boxes = [self.whole(n).box for n in range(len(self.sweeps))]
        tree, see = BoxTree(boxes), self.counts("Q4")
        for n, box in enumerate(boxes):
            for m in tree.meeting(box):
                if m < n and not self.are_apart(m, n, see):
                    raise Reject("Q4", "sweeps %d and %d may meet" % (m, n))

    def are_apart(self, m, n, see):
        one, other, vectors = self.whole(m), self.whole(n), self.rows_of(m) + self.rows_of(n)
        found = descends(one, other, self.parts, MAX_LEVEL, see,
                         lambda x, y: part_along(vectors, x.points[0], y.points[0]))
        one.kids = other.kids = None
        return found
