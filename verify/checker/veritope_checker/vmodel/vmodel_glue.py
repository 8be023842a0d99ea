# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Faces, edges and corners of cells (docs/certificates/vmodel.md, sections 3, 4 and 7): which are collapsed, which are
glued, and the classes that are counted."""
from math import comb, gcd

from ..common.errors import Reject
from ..patches.star_box_patches import Groups, transposed
from .vmodel_pieces import OTHERS, edge_number, is_one_point

POINT, FIRST, SECOND = "to a point", "along its first parameter", "along its second parameter"

# ---------------------------------------------------------------- section 3: collapsed faces and edges

def face_rows(volume, axis, end):
    """The homogeneous control points of a face of a cell, a row for each along its first parameter."""
    p, q = OTHERS[axis]
    index = [0, 0, 0]
    index[axis] = end * (volume.sizes[axis] - 1)
    rows = []
    for index[p] in range(volume.sizes[p]):
        rows.append([])
        for index[q] in range(volume.sizes[q]):
            rows[-1].append(volume.at(*index))
    return rows

def collapse_of(rows):
    """POINT, FIRST, SECOND or None."""
    corner = rows[0][0]
    if all(is_multiple(q, corner, q[3], corner[3]) for row in rows for q in row):
        return POINT
    for name, lines in ((FIRST, rows), (SECOND, transposed(rows))):
        if all(is_multiple(q, first, row[0][3], corner[3]) for row in lines for q, first in zip(row, lines[0])):
            return name
    return None

def is_multiple(p, q, v, w):
    """p w = q v, in all four components."""
    return all(a * w == b * v for a, b in zip(p, q))

class Faces:
    """The collapsed faces and edges of a cell."""

    def __init__(self, volume):
        self.collapse = [collapse_of(face_rows(volume, f // 2, f % 2)) for f in range(6)]
        self.edges = [is_one_point([volume.at(*index) for index in edge_indices(volume.sizes, edge)])
                      for edge in range(12)]

    def allows(self, edge, axis, on_faces):
        """May an edge of a piece be collapsed?  edge: the cell's edge in which it lies, or None; on_faces: the faces of
        the cell in which it lies; axis: along which it runs."""
        if edge is not None and self.edges[edge]:
            return True
        return any(self.collapse[f] == POINT or self.collapse[f] and axis == along(f, self.collapse[f])
                   for f in on_faces)

def along(face, collapse):
    """The axis along which a face is collapsed, if it is so along one."""
    return OTHERS[face // 2][collapse == SECOND]

def edge_indices(sizes, edge):
    axis, e, f = edge // 4, edge % 2, edge // 2 % 2
    index = [0, 0, 0]
    for other, end in zip(OTHERS[axis], (e, f)):
        index[other] = end * (sizes[other] - 1)
    for index[axis] in range(sizes[axis]):
        yield tuple(index)

def test_edges(piece, counts, faces):
    """V1 for the edges of a piece. counts: the numbers of pieces along the axes."""
    at_ends = [(i == 0, i == n - 1) for i, n in zip(piece.index, counts)]
    for axis in range(3):
        for ends in ((0, 0), (1, 0), (0, 1), (1, 1)):
            if not is_one_point(piece.line(axis, ends)):
                continue
            on_faces = [2 * other + end for other, end in zip(OTHERS[axis], ends) if at_ends[other][end]]
            edge = edge_number(axis, ends) if len(on_faces) == 2 else None
            if not faces.allows(edge, axis, on_faces):
                raise Reject("V1", "an edge along axis %d of piece %s is collapsed" % (axis, piece.index))


# ---------------------------------------------------------------- section 4: symmetries

def is_odd(symmetry):
    return bin(symmetry).count("1") % 2 == 1

def moved(rows, symmetry):
    """The array of a map whose parameters the symmetry replaces."""
    if symmetry & 1:
        rows = transposed(rows)
    if symmetry & 2:
        rows = rows[::-1]
    if symmetry & 4:
        rows = [row[::-1] for row in rows]
    return rows

def moved_index(index, counts, symmetry):
    (i, j), (m, n) = index, counts
    if symmetry & 1:
        i, j, m, n = j, i, n, m
    return (m - 1 - i if symmetry & 2 else i, n - 1 - j if symmetry & 4 else j)

def hand(face, flag):
    axis, end = face // 2, face % 2
    return (1 if end else -1) * (-1 if axis == 1 else 1) * (-1 if flag else 1)

def parts(breaks):
    """The breaks, brought to [0, 1]."""
    lo, hi = breaks[0], breaks[-1]
    return [(b - lo) / (hi - lo) for b in breaks]

def have_equal_breaks(ours, theirs, symmetry):
    """ours, theirs: of the two parameters of the faces."""
    ours = ours[::-1] if symmetry & 1 else ours
    for k, (a, b) in enumerate(zip(ours, theirs)):
        a = parts(a)
        if symmetry & (4 if k else 2):
            a = [1 - t for t in a[::-1]]
        if a != parts(b):
            return False
    return True

def key_of(rows):
    """A text that is equal for maps that agree, in any degrees, up to a positive factor: the coefficients of powers."""
    arrays = [in_powers(transposed(in_powers(transposed([[p[c] for p in row] for row in rows])))) for c in range(4)]
    while len(arrays[0]) > 1 and not any(any(a[-1]) for a in arrays):
        arrays = [a[:-1] for a in arrays]
    while len(arrays[0][0]) > 1 and not any(row[-1] for a in arrays for row in a):
        arrays = [[row[:-1] for row in a] for a in arrays]
    common = gcd(*[c for a in arrays for row in a for c in row])
    return ";".join(",".join("%x" % (c // common) for a in arrays for c in a[i]) for i in range(len(arrays[0])))

def in_powers(rows):
    """The rows as polynomials: Bernstein coefficients become those of powers."""
    result = []
    for row in rows:
        n, powers = len(row) - 1, []
        for k in range(n + 1):
            powers.append(comb(n, k) * row[0])
            row = [b - a for a, b in zip(row, row[1:])]
        result.append(powers)
    return result

class Gluing:
    """V3, fed with the pieces of cells."""

    def __init__(self, codes, flags, breaks):
        self.partner, self.flags, self.breaks, self.keys, self.wrong = {}, flags, breaks, {}, None
        for f, code in enumerate(codes):
            if type(code) is tuple:
                g, symmetry = code
                if codes[g] != 2 or g in self.partner:
                    self.wrong = self.wrong or "face %d is named, and has no code 2 or another name" % g
                self.partner[g] = self.partner[f] = f, g, symmetry
        for f, code in enumerate(codes):
            if code == 2 and f not in self.partner:
                self.wrong = self.wrong or "no face names face %d" % f
        self.pairs = [(f, g, s) for f, (first, g, s) in sorted(self.partner.items()) if f == first]

    def test_pairs(self):
        if self.wrong:
            raise Reject("V3", self.wrong)
        for f, g, symmetry in self.pairs:
            product = hand(f % 6, self.flags[f // 6]) * hand(g % 6, self.flags[g // 6])
            if product != (1 if is_odd(symmetry) else -1):
                raise Reject("V3", "faces %d and %d are glued with the same orientation" % (f, g))
            if not have_equal_breaks(self.breaks_of(f), self.breaks_of(g), symmetry):
                raise Reject("V3", "the breaks of faces %d and %d differ" % (f, g))
            if self.keys[f] != self.keys[g]:
                raise Reject("V3", "faces %d and %d are not equal" % (f, g))

    def breaks_of(self, face):
        return [self.breaks[face // 6][axis] for axis in OTHERS[face % 6 // 2]]

    def see(self, cell, piece, counts):
        """Keeps the faces of a piece that lie in glued faces."""
        for k in range(6):
            axis, end, f = k // 2, k % 2, 6 * cell + k
            if f not in self.partner or piece.index[axis] != end * (counts[axis] - 1):
                continue
            first, _, symmetry = self.partner[f]
            p, q = OTHERS[axis]
            index, rows = (piece.index[p], piece.index[q]), piece.face(axis, end)
            if f == first:
                index, rows = moved_index(index, (counts[p], counts[q]), symmetry), moved(rows, symmetry)
            self.keys.setdefault(f, {})[index] = key_of(rows)


# ---------------------------------------------------------------- section 7: classes

def corner_of(face, ends):
    """The corner of a cell at these ends of the face's parameters."""
    corner = (face % 2) << (face // 2)
    for axis, end in zip(OTHERS[face // 2], ends):
        corner |= end << axis
    return corner

def side_of(face, which, end):
    """The edge of a cell that is the side of a face along its first (0) or second (1) parameter, at an end of the other
    one."""
    axis, fixed = OTHERS[face // 2][which], OTHERS[face // 2][1 - which]
    ends = {face // 2: face % 2, fixed: end}
    return edge_number(axis, [ends[other] for other in OTHERS[axis]])

def count_classes(faces, pairs):
    """(v_points, v_curves). faces: of each cell. pairs: (face, face, symmetry)."""
    corners, edges = Groups(8 * len(faces)), Groups(12 * len(faces))
    for f, g, symmetry in pairs:
        for ends in ((0, 0), (0, 1), (1, 0), (1, 1)):
            to = moved_index(ends, (2, 2), symmetry)
            corners.unite(8 * (f // 6) + corner_of(f % 6, ends), 8 * (g // 6) + corner_of(g % 6, to))
        for which in range(2):
            for end in range(2):
                to = which ^ symmetry & 1
                reverse = symmetry >> (2 if to == 0 else 1) & 1
                edges.unite(12 * (f // 6) + side_of(f % 6, which, end),
                            12 * (g // 6) + side_of(g % 6, to, end ^ reverse))
    for c, cell in enumerate(faces):
        for edge, is_collapsed in enumerate(cell.edges):
            if is_collapsed:
                a, b = ends_of(edge)
                corners.unite(8 * c + a, 8 * c + b)
        for f, collapse in enumerate(cell.collapse):
            if collapse in (FIRST, SECOND):
                which = 1 if collapse == FIRST else 0           # the parameter of the curve that is left
                edges.unite(12 * c + side_of(f, which, 0), 12 * c + side_of(f, which, 1))
    of_curves = edges.number()
    curves = {of_curves[12 * c + e] for c, cell in enumerate(faces) for e in range(12) if not cell.edges[e]}
    return len(set(corners.number())), len(curves)

def ends_of(edge):
    axis = edge // 4
    corner = sum(end << other for other, end in zip(OTHERS[axis], (edge % 2, edge // 2 % 2)))
    return corner, corner | 1 << axis
