# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The numbers of a microstructure (docs/certificates/microstructure.md, section 8)."""
from collections import Counter
from fractions import Fraction

from ..patches.star_box_patches import Groups

class Glued:
    """The tiles, glued along equal caps.  cells: a byte for each, of all grids together: 0 or 1 + its tile; masks: for
    each cell the caps that are equal to others, a bit each; base: the first cell of each grid."""

    def __init__(self, tiles, grids, meetings):
        self.tiles, self.meetings, self.base = tiles, meetings, meetings.base
        self.cells = b"".join(grid.cells for grid in grids)
        self.masks, self.classes = [0] * len(self.cells), Groups(len(self.cells))
        for a, b, kind in zip(meetings.first, meetings.second, meetings.kinds):
            one, other = meetings.matches[kind].masks
            self.masks[a] |= one
            self.masks[b] |= other
            self.classes.unite(a, b)

    def numbers(self):
        cells, used = self.cells, Counter(self.meetings.kinds)
        held = len(cells) - cells.count(0)
        chi = sum(Fraction(tile.chi(), 2) * cells.count(n + 1) for n, tile in enumerate(self.tiles))
        chi -= sum(self.meetings.matches[kind].chi * count for kind, count in used.items())
        components = held - joined(self.classes)
        # Each pair of equal caps joins one piece of its cells to one, if cells have no more than one.
        is_one = all(count == 1 for _, count in self.pieces().values())
        shells = components if is_one else sum(1 for _ in self.first_patches())
        return {"cells": len(cells), "tiles": held, "components": components, "shells": shells, "genus": shells - chi,
                "glued_caps": sum(len(self.meetings.matches[kind].pairs) * count for kind, count in used.items())}

    def pieces(self):
        """{(tile + 1, mask): Tile.pieces()} for all cells that hold a tile."""
        keys = set(zip(self.cells, map(hex, self.masks)))   # a text has a keyed hash
        return {key: self.tiles[key[0] - 1].pieces(int(key[1], 16)) for key in keys if key[0]}

    def first_patches(self):
        """(cell, patch) of the first patch of each shell: the classes of the pieces of all tiles, joined around equal
        caps."""
        first, count, joins, pieces, meetings = [], 0, {}, self.pieces(), self.meetings
        keys = list(zip(self.cells, map(hex, self.masks)))
        for key in keys:
            first.append(count)
            count += pieces[key][1] if key[0] else 0
        classes = Groups(count)
        for a, b, kind in zip(meetings.first, meetings.second, meetings.kinds):
            key = kind, *keys[a], *keys[b]
            if key not in joins:
                (ours, _), (theirs, _) = pieces[keys[a]], pieces[keys[b]]
                joins[key] = {(ours[p], theirs[q]) for _, _, pairs in meetings.matches[kind].pairs for p, q in pairs
                              if p in ours and q in theirs}
            for p, q in joins[key]:
                classes.unite(first[a] + p, first[b] + q)
        for cell, key in enumerate(keys):
            if key[0]:                                      # a class has the number of its least element
                of_patches, number = pieces[key]
                begins = [n for n in range(number) if classes.parent[first[cell] + n] == first[cell] + n]
                for n in begins:
                    yield cell, min(patch for patch, piece in of_patches.items() if piece == n)

def joined(classes):
    """The number of elements that are not the least of their class."""
    return sum(p != n for n, p in enumerate(classes.parent))
