# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Which faces of volumes are left out: docs/certificates/reading-rule-faces.md, section 4.

Control points and knots are compared by the SHA-256 of a text of each, as a certificate names its model. (A file could
be made of numbers of one hash in Python's own sense, and texts of them all would take much more memory than the file.)
"""
import hashlib
from array import array
from fractions import Fraction
from itertools import chain
from math import gcd

from .model_powers import degree_of, has_full_degree, lowered, scaled

class Names:
    """Numbers sequences of texts in the order in which they are first seen."""

    def __init__(self):
        self.numbers = {}

    def number(self, texts):
        digest = hashlib.sha256()
        for text in texts:
            digest.update(text.encode())
        return self.numbers.setdefault(digest.digest(), len(self.numbers))

def text_of(fraction):
    return "%x/%x;" % (fraction.numerator, fraction.denominator)

def split(point):
    """(integers without a common factor, the factor) of a homogeneous point: the integers are equal for equal points.
    All are 0 if the point has no number but 0, as one in the lowest degree may."""
    integers, common = scaled(point)
    factor = gcd(*integers)
    return tuple(c // (factor or 1) for c in integers), Fraction(factor, common)

def transposed(rows):
    return [list(column) for column in zip(*rows)]


# ---------------------------------------------------------------- without area

def has_area(rows):
    """rows: of homogeneous points."""
    points, weights = [[split(p)[0] for p in row] for row in rows], [[p[3] for p in row] for row in rows]
    return not (all(point == points[0][0] for row in points for point in row) or
                is_constant_along_rows(points, weights) or
                is_constant_along_rows(transposed(points), transposed(weights)))

def is_constant_along_rows(points, weights):
    """Whether Q(i, j) w(0, 0) = Q(i, 0) w(0, j) for all i and j."""
    return (all(point == row[0] for row in points for point in row) and
            all(w * weights[0][0] == row[0] * first for row in weights for w, first in zip(row, weights[0])))


# ---------------------------------------------------------------- walls

def in_lowest_degree(rows):
    """The net with the least degree along its rows, at least 1; there are no inner knots along them."""
    lines = [component for row in rows for component in zip(*row)]
    if len(rows[0]) == 2 or any(has_full_degree(line) for line in lines):
        return rows
    degree = max(1, *map(degree_of, lines))
    return [transposed([lowered(component, degree) for component in zip(*row)]) for row in rows]

class Walls:
    """Numbers the points and the knots of nets, so that equal ones have equal numbers."""

    def __init__(self):
        self.points, self.axes, self.seen = Names(), Names(), {}

    def grid(self, rows):
        """The numbers of the control points up to one positive factor of all: the greatest weight is made 1."""
        most = max(point[3] for row in rows for point in row)
        return [[self.points.number(("%x,%x,%x,%x:" % integers, text_of(factor / most)))
                 for integers, factor in map(split, row)] for row in rows]

    def axis(self, degree, knots):
        """The numbers of an axis with these knots, mapped to [0, 1], and of the same axis reversed."""
        key = degree, id(knots)                             # the volume's own list, which outlives this object
        if key not in self.seen:
            first, last = knots[0], knots[-1]
            ways = (t - first for t in knots), (last - t for t in reversed(knots))
            self.seen[key] = [self.axes.number(chain(("%d:" % degree,), (text_of(t / (last - first)) for t in way)))
                              for way in ways]
        return self.seen[key]

    def form(self, surface):
        """(grid, axes): the numbers of the control points and of both axes in the lowest degrees."""
        rows, axes = surface.rows, []
        for degree, knots in zip(surface.degrees[::-1], surface.knots[::-1]):      # along the rows first
            if len(knots) == 2 * degree + 2:
                rows = in_lowest_degree(rows)
                axes.insert(0, [self.axes.number(("%d" % (len(rows[0]) - 1),))] * 2)
            else:
                axes.insert(0, self.axis(degree, knots))
            rows = transposed(rows)
        return self.grid(rows), axes

    def changed(self, surface):
        """(parity, the face after the symmetry) for each of the eight symmetries."""
        grid, axes = self.form(surface)
        for exchanged in (0, 1):
            for first in (0, 1):
                for second in (0, 1):
                    rows = grid[::-1] if first else grid
                    rows = [row[::-1] for row in rows] if second else rows
                    key = array("q", (axes[0][first], axes[1][second], *(n for row in rows for n in row)))
                    yield (exchanged + first + second) % 2, key.tobytes()
            grid, axes = transposed(grid), axes[::-1]

def left_over(faces):
    """The faces, surfaces in space, that have an area and are no walls."""
    walls, classes = Walls(), {}
    for n, face in enumerate(faces):
        changed = list(walls.changed(face))
        least = min(key for _, key in changed)
        # The parities of the symmetries that lead to the least form: two faces of a class are equal under an odd
        # symmetry iff one leads there with one parity and one with the other.
        classes.setdefault(least, []).append((n, {parity for parity, key in changed if key == least}))
    left_out = set()
    for members in classes.values():
        if len(members) == 2 and len(members[0][1] | members[1][1]) == 2:
            left_out.update(n for n, _ in members)
    return [face for n, face in enumerate(faces) if n not in left_out and has_area(face.rows)]
