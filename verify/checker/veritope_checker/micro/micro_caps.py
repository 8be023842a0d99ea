# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Caps of two walls that meet (docs/certificates/microstructure.md, section 6): T4."""
from fractions import Fraction

from ..common.errors import Reject
from ..patches.model_powers import scaled
from ..vmodel.vmodel_pieces import OTHERS
from .micro_polynomials import at_number, curve_key, in_bernstein, map_key, of_lists

MAX_KEPT = 1 << 17                                          # results that are kept, and shapes of caps
OWN, UNPLACED = "own number", (0, 0, 0)                     # the place of a wall in itself: places[0] is (1, 0)

class Shape:
    """A cap in the parameters of a wall.  low, high: its hull; key: a text that equal caps share; rim: {curve: patch
    outside the cap} for its border."""

    def __init__(self, tile, number, lists_of, extent):
        wall, patches = tile.caps[number]
        inside, keys, points, self.rim = set(patches), [], [], {}
        for n in patches:
            patch = tile.patches[n]
            lists, common = lists_of(patch)
            coefficients, factor = in_bernstein(lists, extent)
            points += [[Fraction(c, common * factor) for c in point] for of_t in coefficients for point in of_t]
            keys.append(map_key(OWN, lists, common, patch.degrees))
            for s, other in enumerate(patch.sides):
                if other and other[0] not in inside:
                    curve = [[p[m] for m in patch.along(s)] for p in lists]
                    back = [points[::-1] for points in curve]
                    self.rim[min(curve_key(OWN, curve, common), curve_key(OWN, back, common))] = other[0]
        self.number, self.keys, self.chi = number, sorted(keys), tile.chi(patches)
        self.low, self.high = [[f(column) for column in zip(*points)] for f in (min, max)]

    def misses(self, other):
        return any(a > d or b < c for a, b, c, d in zip(self.low, self.high, other.low, other.high))

class Match:
    """The equal caps of two walls.  pairs: (cap of the first tile, cap of the second, joins: pairs of patches that meet
    in the cap's border)."""

    def __init__(self, pairs):
        self.pairs = [(a.number, b.number, sorted({(a.rim[c], b.rim[c]) for c in a.rim if c in b.rim}))
                      for a, b in pairs]
        self.masks = [sum(1 << pair[k] for pair in self.pairs) for k in (0, 1)]
        self.chi = sum(a.chi for a, _ in pairs)
        self.key = "%s %d" % (self.pairs, self.chi)

class Caps:
    """Compares walls; whatever depends on the tiles alone is found once."""

    def __init__(self, tiles, skip):
        self.tiles, self.skip, self.places, self.numbers = tiles, skip, [(Fraction(1), Fraction(0))], {"1/1,0/1": 0}
        self.families, self.matches, self.shapes, self.known = {}, {}, {}, {}
        self.of_wall = [[[n for n, (w, _) in enumerate(tile.caps) if w == wall] for wall in range(6)] for tile in tiles]
        self.depends = [[sorted({depends_on(tile.patches[n]) for cap in of_wall for n in tile.caps[cap][1]} - {None})
                         for of_wall in walls] for tile, walls in zip(tiles, self.of_wall)]

    def place(self, factor, step):
        """The number of the map x -> factor x + step."""
        text = "%x/%x,%x/%x" % (factor.numerator, factor.denominator, step.numerator, step.denominator)
        if text not in self.numbers:
            self.numbers[text] = len(self.places)
            self.places.append((factor, step))
        return self.numbers[text]

    def family(self, tile, wall, other, other_wall, place):
        """The match of the walls if it is the same for whatever number both have; else None.  tile, other: numbers of
        tiles.  place: (whether parameters are exchanged, the places of both) of the second wall in the first."""
        key = tile, wall, other, other_wall, place
        if key not in self.families:
            self.families[key] = None
            if set(self.depends[tile][wall]) <= {wall} and set(self.depends[other][other_wall]) <= {other_wall}:
                try:
                    self.families[key] = self.compared(self.shapes_of(tile, wall, None, UNPLACED),
                                                       self.shapes_of(other, other_wall, None, place), ())
                except Reject:
                    pass
        return self.families[key]

    def match(self, tile, wall, cell, other, other_wall, other_cell, place=UNPLACED):
        """The match of the walls of two cells: (grid, cell)."""
        ours, theirs = self.depends[tile][wall], self.depends[other][other_wall]
        if not ours or not theirs or cell[0].number(cell[1], wall) == other_cell[0].number(other_cell[1], other_wall):
            found = self.family(tile, wall, other, other_wall, place)
            if found:
                return found
        ours = tuple([cell[0].number(cell[1], w) for w in ours])
        theirs = tuple([other_cell[0].number(other_cell[1], w) for w in theirs])
        key = tile, wall, ours, other, other_wall, theirs, place
        if key not in self.matches:
            if len(self.matches) >= MAX_KEPT:
                self.matches.clear()
            self.matches[key] = self.compared(self.shapes_of(tile, wall, ours, UNPLACED),
                                              self.shapes_of(other, other_wall, theirs, place), self.skip)
        return self.matches[key]

    def compared(self, ours, theirs, skip):
        pairs = []
        for a in ours:
            for b in theirs:
                if a.keys == b.keys:
                    pairs.append((a, b))
                elif not a.misses(b) and "T4" not in skip:
                    raise Reject("T4", "cap %d of a tile and cap %d of the next one are neither equal nor apart" % (
                        a.number, b.number))
        for which in (0, 1):
            numbers = [pair[which].number for pair in pairs]
            if len(set(numbers)) != len(numbers) and "T4" not in skip:
                raise Reject("T4", "a cap is equal to two others")
        match = Match(pairs)
        return self.known.setdefault(match.key, match)

    def shapes_of(self, tile, wall, numbers, place):
        """The caps of a wall; numbers: those of the walls on which they depend, or None for families."""
        key = tile, wall, numbers, place
        if key not in self.shapes:
            if len(self.shapes) >= MAX_KEPT:
                self.shapes.clear()
            of = self.tiles[tile]
            known = dict(zip(self.depends[tile][wall], numbers or ()))

            def lists_of(patch):
                depends, lists = of_lists(patch.wall, patch.lists)
                common = patch.unit
                if numbers is not None:
                    points, factor = at_number(lists, known.get(depends, 0))
                    lists, common = [points], common * factor
                return self.placed([[[p[axis] for axis in OTHERS[wall // 2]] for p in points] for points in lists],
                                   common, place)
            self.shapes[key] = [Shape(of, n, lists_of, of.extent) for n in self.of_wall[tile][wall]]
        return self.shapes[key]

    def placed(self, lists, common, place):
        """(points of a wall in the parameters of another one, common denominator)"""
        (f, a, g, b), factor = scaled([*self.places[place[1]], *self.places[place[2]]])
        first, second = (1, 0) if place[0] else (0, 1)
        found = [[[f * p[first], g * p[second]] for p in points] for points in lists]
        found[0] = [[x + a * common, y + b * common] for x, y in found[0]]
        return found, common * factor

def depends_on(patch):
    return of_lists(patch.wall, patch.lists)[0]
