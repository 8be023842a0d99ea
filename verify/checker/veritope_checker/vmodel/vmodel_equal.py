# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Equal faces (docs/certificates/vmodel-invalid.md, section 4). Face 6 c + k is face k of cell c."""
from bisect import bisect_left
from itertools import groupby, product
from math import gcd

from ..patches.model_powers import scaled
from ..patches.volume_folded_check import different
from .vmodel_glue import Faces, corner_of, key_of, moved, moved_index, parts
from .vmodel_pieces import OTHERS, coefficients, interval, window

FACE_CORNERS = tuple(product((0, 1), repeat=2))         # the ends of a face's two parameters

def corner_index(sizes, corner):
    """The control point of a corner."""
    return [(corner >> axis & 1) * (n - 1) for axis, n in enumerate(sizes)]

def text_of(point):
    """A text that is equal for homogeneous points that are equal as points.  A text has a keyed hash."""
    values = scaled(point)[0]
    common = gcd(*values)
    return ",".join("%x" % (c // common) for c in values)

class AllFaces:
    """points: for each cell, numbers of its eight corners; corners that are equal as points have one number."""

    def __init__(self, volumes, spend):
        self.volumes, self.spend, self.made, numbers = volumes, spend, {}, {}
        self.points = [[numbers.setdefault(text_of(volume.at(*corner_index(volume.sizes, corner))), len(numbers))
                        for corner in range(8)] for volume in volumes]

    def of(self, cell):
        """The collapsed faces and edges of a cell."""
        if cell not in self.made:
            self.made[cell] = Faces(self.volumes[cell])
        return self.made[cell]

    def is_collapsed(self, f):
        return bool(self.of(f // 6).collapse[f % 6])

    def corner_points(self, f):
        return [self.points[f // 6][corner_of(f % 6, ends)] for ends in FACE_CORNERS]

    def symmetry(self, f, g):
        """The lowest symmetry under which face f equals face g, or None."""
        if self.is_collapsed(f) or self.is_collapsed(g):
            return None
        ours, theirs = [dict(zip(FACE_CORNERS, self.corner_points(face))) for face in (f, g)]
        for s in range(8):
            if all(ours[ends] == theirs[moved_index(ends, (2, 2), s)] for ends in ours) and self.have_one_map(f, g, s):
                return s
        return None

    def have_one_map(self, f, g, s):
        """Do the maps agree between common breaks?"""
        of_f, of_g = [self.intervals(face, units) for face, units in zip((f, g), self.common_breaks(f, g, s))]
        counts = [len(intervals) for intervals in of_g]
        for at in product(*map(range, counts)):
            i, j = moved_back(at, counts, s)
            ours = self.rows(f, (of_f[0][i], of_f[1][j]))
            theirs = self.rows(g, (of_g[0][at[0]], of_g[1][at[1]]))
            if key_of(moved(ours, s)) != key_of(theirs):
                return False
        return True

    def knots(self, f):
        """The different knots of the two parameters."""
        return [different(self.volumes[f // 6].knots[axis]) for axis in OTHERS[f % 6 // 2]]

    def common_breaks(self, f, g, s):
        """The common breaks from 0 to 1, of the parameters of f and of those of g."""
        ours, theirs = [[parts(knots) for knots in self.knots(face)] for face in (f, g)]
        ours = ours[::-1] if s & 1 else ours
        is_reversed, of_f, of_g = (s & 2, s & 4), [], []
        for a, b, back in zip(ours, theirs, is_reversed):
            of_g.append(different(sorted((complement(a) if back else a) + b)))
            of_f.append(complement(of_g[-1]) if back else of_g[-1])
        return of_f[::-1] if s & 1 else of_f, of_g

    def intervals(self, f, units):
        """For each parameter, what vmodel_pieces.interval() makes of the intervals between these breaks."""
        volume, found = self.volumes[f // 6], []
        for axis, knots, of_axis in zip(OTHERS[f % 6 // 2], self.knots(f), units):
            breaks = [knots[0] + (knots[-1] - knots[0]) * t for t in of_axis]
            found.append([interval(volume, axis, lo, hi, self.spend) for lo, hi in zip(breaks, breaks[1:])])
        return found

    def rows(self, f, chosen):
        """The homogeneous coefficients of the face on a product of two intervals."""
        volume, axis = self.volumes[f // 6], f % 6 // 2
        index, points = [f % 2 * (n - 1) for n in volume.sizes], []
        first, second = map(window, chosen)
        for index[OTHERS[axis][0]] in first:
            for index[OTHERS[axis][1]] in second:
                points.append(volume.at(*index))
        points = list(zip(*coefficients(points, chosen, self.spend)))
        return [points[i:i + len(second)] for i in range(0, len(points), len(second))]

class Candidates:
    """Faces in ascending order, with which others are compared, a unit each."""

    def __init__(self, faces, numbers):
        self.faces, self.numbers, self.places = faces, numbers, {}
        for place, f in enumerate(numbers):
            self.places.setdefault(self.key(f), []).append(place)

    def key(self, f):
        """Equal faces have one key."""
        return tuple(sorted(self.faces.corner_points(f)))

    def equal_to(self, f):
        """Pairs (g, symmetry), for all g that f equals."""
        own, done = bisect_left(self.numbers, f), 0
        for place in self.places[self.key(f)]:
            if place != own:
                upto = place + (place < own)
                self.faces.spend(upto - done)
                done, s = upto, self.faces.symmetry(f, self.numbers[place])
                if s is not None:
                    yield self.numbers[place], s
        self.faces.spend(len(self.numbers) - 1 - done)

def complement(units):
    return [1 - t for t in units[::-1]]

def moved_back(index, counts, s):
    """The inverse of moved_index; counts: of the face to which the symmetry leads."""
    i, j = [n - 1 - i if back else i for i, n, back in zip(index, counts, (s & 2, s & 4))]
    return (j, i) if s & 1 else (i, j)
