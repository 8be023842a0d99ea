# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim microstructure-1: check() is called when the statement and the hashes are right.

Written from docs/certificates/microstructure.md and docs/formats/micro-files.md alone, and the pages that they quote.
"""
from collections import Counter
from fractions import Fraction
from math import lcm
from operator import mul

from ..common.errors import Reject
from ..patches.star_box_patches import Groups
from ..patches.star_box_read import Body
from ..vmodel import vmodel_check
from .micro_caps import Caps
from .micro_read import Microstructure
from .micro_tile import Tile
from .micro_walls import Meetings, lies_in_face, test_cells

MAGIC, MAX_COEFFICIENTS, MAX_BITS = b"VTMS", 1 << 18, 64
MAX_PATCH_BITS, MAX_WORK = 4096, 1 << 27

def check(claim, statement, body, model, skip):
    """skip: conditions that are not tested, for tests only."""
    Checker(statement, Body(body), Microstructure(model), skip).run()

def bits_of(lists):
    """The bits of the longest of the numbers as integers with a common denominator, and of that."""
    numbers = [c for points in lists for point in points for c in point]
    common = lcm(*[c.denominator for c in numbers])
    return max([common, *[abs(c.numerator) * (common // c.denominator) for c in numbers]]).bit_length()

class Checker:
    """The conditions in the order of the page."""

    def __init__(self, statement, body, model, skip):
        self.statement, self.model, self.skip = statement, model, skip
        if body.bytes(4) != MAGIC or body.count(7) != len(model.tiles):
            raise Reject("B1", "magic, or another number of tiles")
        self.hints = [([body.rational() for _ in range(3)], body.varint()) for _ in model.tiles]
        if any(exit >= len(patches) for (_, patches), (_, exit) in zip(model.tiles, self.hints)):
            raise Reject("B1", "an exit is no patch of its tile")
        self.of_cage = body.bytes(body.left())

    def fail(self, condition, why):
        if condition not in self.skip:
            raise Reject(condition, why)

    def run(self):
        for key, value in self.numbers().items():
            if self.statement[key] != value:
                self.fail("W3", "%s are %s, the statement says %d" % (key, value, self.statement[key]))

    def numbers(self):
        """Tests all conditions but W3; returns the numbers of section 7."""
        self.test_b2()
        tiles = [Tile(*tile, *hint, self.skip) for tile, hint in zip(self.model.tiles, self.hints)]
        grids, codes = self.model.grids, self.codes_of_cage()
        for tile in tiles:
            tile.test()
        test_cells(grids, tiles, lambda grid, wall: codes[6 * grid.volume + wall] == 1
                   and lies_in_face(grid, wall, self.model.cage), self.skip)
        meetings = Meetings(grids, Caps(tiles, self.skip))
        meetings.find(self.model.cage, codes)
        return count(tiles, grids, meetings)

    def codes_of_cage(self):
        """The codes of the faces of the cage's volumes, if the conditions of vmodel-1 hold but for W3."""
        cage = vmodel_check.Checker(self.statement, self.of_cage, self.model.cage, self.skip)
        cage.numbers()
        return cage.cert.codes

    def test_b2(self):
        patches = [patch for _, of_tile in self.model.tiles for patch in of_tile]
        sizes = [9 * patch.degrees[0] * patch.degrees[1] * (3 * len(patch.lists) - 2) for patch in patches]
        if sum(sizes) > MAX_COEFFICIENTS:
            self.fail("B2", "the tiles have more than %d coefficients" % MAX_COEFFICIENTS)
        bits = [bits_of(patch.lists) for patch in patches]
        if max(bits) > MAX_PATCH_BITS or sum(map(mul, sizes, bits)) > MAX_WORK:
            self.fail("B2", "the numbers of the tiles are too long")
        for centre, _ in self.hints:
            if any(not 0 < c < 1 or c.denominator >> MAX_BITS for c in centre):
                self.fail("B2", "a centre is not inside the cube, or too long")


# ---------------------------------------------------------------- section 7

def count(tiles, grids, meetings):
    cells = b"".join(grid.cells for grid in grids)
    held, used = len(cells) - cells.count(0), Counter(meetings.kinds)
    chi = sum(Fraction(tile.chi(), 2) * cells.count(n + 1) for n, tile in enumerate(tiles))
    chi -= sum(meetings.matches[kind].chi * count for kind, count in used.items())
    masks, classes = [0] * len(cells), Groups(len(cells))
    for a, b, kind in zip(meetings.first, meetings.second, meetings.kinds):
        one, other = meetings.matches[kind].masks
        masks[a] |= one
        masks[b] |= other
        classes.unite(a, b)
    components = held - joined(classes)
    masks = list(map(hex, masks))                           # a text has a keyed hash
    pieces = {key: tiles[key[0] - 1].pieces(int(key[1], 16)) for key in set(zip(cells, masks)) if key[0]}
    # Each pair of equal caps joins one piece of its cells to one, if cells have no more than one.
    is_one = all(count == 1 for _, count in pieces.values())
    shells = components if is_one else num_shells(meetings, cells, masks, pieces)
    return {"cells": len(cells), "tiles": held, "components": components, "shells": shells, "genus": shells - chi,
            "glued_caps": sum(len(meetings.matches[kind].pairs) * count for kind, count in used.items())}

def joined(classes):
    """The number of elements that are not the least of their class."""
    return sum(p != n for n, p in enumerate(classes.parent))

def num_shells(meetings, cells, masks, pieces):
    """The classes of the pieces of all tiles, joined around equal caps."""
    first, count, joins = [], 0, {}
    for key in zip(cells, masks):
        first.append(count)
        count += pieces[key][1] if key[0] else 0
    classes = Groups(count)
    for a, b, kind in zip(meetings.first, meetings.second, meetings.kinds):
        key = kind, masks[a], masks[b], cells[a], cells[b]
        if key not in joins:
            (ours, _), (theirs, _) = pieces[cells[a], masks[a]], pieces[cells[b], masks[b]]
            joins[key] = {(ours[p], theirs[q]) for _, _, pairs in meetings.matches[kind].pairs for p, q in pairs
                          if p in ours and q in theirs}
        for p, q in joins[key]:
            classes.unite(first[a] + p, first[b] + q)
    return count - joined(classes)
