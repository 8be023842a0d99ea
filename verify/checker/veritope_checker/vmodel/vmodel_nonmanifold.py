# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Boundaries that are no surfaces (docs/certificates/vmodel-invalid.md, section 4): more than two sides at one arc, more
than one vertex at one point."""
from fractions import Fraction
from itertools import combinations

from ..patches.patch_invalid_check import value_at
from ..patches.star_box_patches import curve_key
from ..patches.volume_folded_check import different
from .vmodel_equal import FACE_CORNERS, AllFaces, Candidates, corner_index
from .vmodel_glue import corner_of, edge_indices, ends_of, moved_index, side_of, test_edges
from .vmodel_pieces import OTHERS, coefficients, interval, is_one_point, pieces_of, window

class Boundary:
    """fail(condition, why) and spend(units) are the checker's, unless_skipped(test, *arguments), too."""

    def __init__(self, volumes, fail, spend, unless_skipped):
        self.volumes, self.fail, self.spend, self.unless_skipped = volumes, fail, spend, unless_skipped
        self.faces = AllFaces(volumes, spend)

    def test_cells_near(self, x):
        """V1 of the cells near a point. x: homogeneous."""
        x = [Fraction(c) / x[3] for c in x[:3]]
        for cell, volume in enumerate(self.volumes):
            if is_near(volume, x):
                breaks = [different(knots) for knots in volume.knots]
                counts = [len(b) - 1 for b in breaks]
                for piece in pieces_of(volume, breaks, self.spend):
                    self.unless_skipped(test_edges, piece, counts, self.faces.of(cell))

    # ------------------------------------------------------------ curves

    def test_arcs(self, arcs):
        for a, b in combinations(arcs, 2):
            if a[:3] == b[:3] and a.at.k == b.at.k and a.at.overlaps(b.at):
                self.fail("C1", "two arcs of side %d of face %d of cell %d overlap" % (a.side, a.face, a.cell))
        curve = self.curve(arcs[0])
        if is_one_point(curve):
            self.fail("C2", "the first arc is a point")
        key = curve_key(curve)
        for arc in arcs[1:]:
            other = self.curve(arc)
            if key not in (curve_key(other), curve_key(other[::-1])):
                self.fail("C2", "an arc is another curve than the first")
        self.test_faces_of(arcs)
        self.test_cells_near([value_at(list(c), 1, 2) for c in zip(*curve)])

    def curve(self, arc):
        """The homogeneous Bernstein coefficients."""
        volume = self.volumes[arc.cell]
        chosen = interval(volume, arc.edge // 4, arc.at.lo, arc.at.hi, self.spend)
        points = [volume.at(*index) for index in edge_indices(volume.sizes, arc.edge)]
        return list(zip(*coefficients([points[i] for i in window(chosen)], [chosen], self.spend)))

    def test_faces_of(self, arcs):
        """C3."""
        candidates = Candidates(self.faces, range(6 * len(self.volumes)))
        for arc in arcs:
            f = 6 * arc.cell + arc.face
            if self.faces.is_collapsed(f):
                self.fail("C3", "face %d is collapsed" % f)
            for g, _ in candidates.equal_to(f):
                self.fail("C3", "face %d is equal to face %d" % (f, g))

    # ------------------------------------------------------------ points

    def test_point(self, cell, corner):
        volume, q = self.volumes[cell], self.faces.points[cell][corner]
        self.test_cells_near(volume.at(*corner_index(volume.sizes, corner)))
        corners = [[number == q for number in points] for points in self.faces.points]
        faces = [f for f in range(6 * len(self.volumes)) if q in self.faces.corner_points(f)
                 and not self.faces.is_collapsed(f)]
        candidates, partners = Candidates(self.faces, faces), {}
        for f in faces:
            for g, s in candidates.equal_to(f):
                if f in partners:
                    self.fail("P1", "face %d is equal to faces %d and %d" % (f, partners[f][0], g))
                partners.setdefault(f, (g, s))
        self.test_vertices(Vertices(self, corners, partners, [f for f in faces if f not in partners]))

    def test_vertices(self, vertices):
        """P2."""
        if not vertices.have_ends:
            self.fail("P2", "a walk does not end at a border face")
        if vertices.number() < 2:
            self.fail("P2", "there are %d vertices at the point" % vertices.number())

class Vertices:
    """Classes of pairs (border face, corner of its cell)."""

    def __init__(self, boundary, corners, partners, border):
        """corners: for each cell, which ones are at the point."""
        self.faces, self.spend, self.partners = boundary.faces, boundary.spend, partners
        self.longest = 6 * sum(map(sum, corners))       # of a walk that passes no edge, end and face twice
        self.spend(self.longest // 6)
        self.parent, self.have_ends = {}, True
        for f in border:
            at = corners[f // 6]
            self.parent.update({(f, c): (f, c) for c in (corner_of(f % 6, ends) for ends in FACE_CORNERS) if at[c]})
        for f in border:
            at, is_collapsed = corners[f // 6], self.faces.of(f // 6).edges
            for edge in (side_of(f % 6, which, end) for which, end in FACE_CORNERS):
                a, b = ends_of(edge)
                for corner, far in ((a, b), (b, a)):
                    if at[corner]:
                        partner = (f, far) if is_collapsed[edge] else self.walk(f, corner, far)
                        self.unite((f, corner), partner or (f, corner))

    def walk(self, f, corner, far):
        """The partner of a side end: of the side from `corner` to `far`."""
        cell, face = divmod(f, 6)
        for _ in range(self.longest):
            self.spend(1)
            face = other_face(face, corner, far)
            h = 6 * cell + face
            if self.faces.is_collapsed(h):
                across, = [axis for axis in OTHERS[face // 2] if not (corner ^ far) >> axis & 1]
                corner, far = corner ^ 1 << across, far ^ 1 << across
            elif h in self.partners:
                g, s = self.partners[h]
                corner, far = [image(c, face, g % 6, s) for c in (corner, far)]
                cell, face = divmod(g, 6)
            else:
                return h, corner
        self.have_ends = False
        return None

    def find(self, pair):
        while self.parent[pair] != pair:
            self.parent[pair] = pair = self.parent[self.parent[pair]]
        return pair

    def unite(self, a, b):
        self.parent[self.find(a)] = self.find(b)

    def number(self):
        return sum(pair == parent for pair, parent in self.parent.items())

def is_near(volume, x):
    for c, value in enumerate(x):
        values = [p[c] / p[3] for p in volume.points]
        if not min(values) <= value <= max(values):
            return False
    return True

def other_face(face, corner, far):
    """The face that has the edge between two corners, too."""
    found = [2 * axis + (corner >> axis & 1) for axis in range(3) if not (corner ^ far) >> axis & 1]
    return found[found[0] == face]

def image(corner, face, other, s):
    """The corner of the other face's cell to which a symmetry takes a corner of the face."""
    ends = [corner >> axis & 1 for axis in OTHERS[face // 2]]
    return corner_of(other, moved_index(ends, (2, 2), s))
